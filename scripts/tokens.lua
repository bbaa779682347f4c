--- Splits Lua source into tokens, for the scripts that change it (mutants.lua) or count in it
--- (coverage.lua). Knows what the core uses: no long strings with signs of equality, no goto.

local tokens = {}

-- Tried in this order at every place of the text. What has no kind is neither code nor counted.
local PATTERNS = {
  { "^%s+" },
  { "^%-%-%[%[.-%]%]" },
  { "^%-%-[^\n]*" },
  { '^"[^"\n]*"', "string" },
  { "^'[^'\n]*'", "string" },
  { "^%[%[.-%]%]", "string" },
  { "^[%a_][%w_]*", "word" },
  { "^%d[%w%.]*[eE]%-%d+", "number" },
  { "^%d[%w%.]*", "number" },
  { "^%.%.%.", "value" },
  { "^%.%.", "operator" },
  { "^[<>=~]=", "operator" },
  { "^[<>%+%-%*/%%^#=]", "operator" },
  { "^.", "sign" },
}

local function nextToken(text, at)
  for _, row in ipairs(PATTERNS) do
    local token = text:match(row[1], at)
    if token then
      return token, row[2]
    end
  end
end

--- The tokens of a text, without spaces and comments.
---@param text string Lua source
---@return table[] list of `{ text =, kind =, at =, line = }`; kind: "word", "number", "string",
--- "operator", "value" (three dots) or "sign"
function tokens.list(text)
  local list, at, line = {}, 1, 1
  while at <= #text do
    local token, kind = nextToken(text, at)
    if kind then
      list[#list + 1] = { text = token, kind = kind, at = at, line = line }
    end
    line = line + select(2, token:gsub("\n", "\n"))
    at = at + #token
  end
  return list
end

-- After these words an expression goes on.
local EXPECTING = { ["and"] = true, ["or"] = true, ["not"] = true, ["in"] = true, ["local"] = true }
for _, word in ipairs({ "return", "if", "elseif", "while", "until", "function", "for" }) do
  EXPECTING[word] = true
end
local EXPECTING_SIGNS = { [","] = true, ["("] = true, ["{"] = true, ["["] = true, ["."] = true }
EXPECTING_SIGNS[":"] = true

--- Whether an expression or a list goes on after a token: what follows it begins no statement, and
--- a minus there has one operand.
---@param token table? one of the list, nil: the beginning of the text
---@return boolean
function tokens.isOpen(token)
  if not token then
    return false
  end
  return token.kind == "operator"
    or token.kind == "word" and EXPECTING[token.text] == true
    or token.kind == "sign" and EXPECTING_SIGNS[token.text] == true
end

return tokens
