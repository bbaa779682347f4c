--- The small changes that scripts/mutants.lua tries on a source text, one at a time: another
--- operator, a comparison turned round or with its edge moved, another constant, min for max.

local decoder = require("luacheck.decoder")
local lexer = require("luacheck.lexer")

local mutations = {}

-- token -> what it becomes, one after the other
local SWAPS = {
  ["<"] = { "<=", ">=" },
  ["<="] = { "<", ">" },
  [">"] = { ">=", "<=" },
  [">="] = { ">", "<" },
  ["=="] = { "~=" },
  ["~="] = { "==" },
  ["+"] = { "-" },
  ["-"] = { "+" },
  ["*"] = { "/" },
  ["/"] = { "*" },
  ["and"] = { "or" },
  ["or"] = { "and" },
  ["not"] = { "" },
  ["true"] = { "false" },
  ["false"] = { "true" },
  ["min"] = { "max" },
  ["max"] = { "min" },
}

-- A minus behind one of these has two operands.
local ENDS = { name = true, number = true, string = true, [")"] = true, ["]"] = true, ["}"] = true }

-- Another number, of the same kind: 1 more, or the double of what may be very small or large.
local function otherNumber(text)
  local value = tonumber(text)
  if value == 0 then
    return text:find("%.") and "1.0" or "1"
  end
  return text:find("[%.exEX]") and "(" .. text .. " * 2)" or tostring(value + 1)
end

-- What a token may become. `t.min` is a field of that name.
local function others(kind, text, before)
  if kind == "number" then
    return { otherNumber(text) }
  elseif kind == "-" and not ENDS[before] then
    return { "" }
  end
  return before ~= "." and before ~= ":" and kind ~= "string" and SWAPS[text] or {}
end

--- The tokens of a text, without comments.
---@param text string Lua source
---@return table[] list of `{ kind =, text =, at =, line = }`, with the kinds of luacheck's lexer
function mutations.tokens(text)
  local list = {}
  local state = lexer.new_state(decoder.decode((text:gsub("[\128-\255]", "?")))) -- offsets in bytes
  local kind, _, line, at = lexer.next_token(state)
  while kind and kind ~= "eof" do
    if not kind:find("comment") then
      list[#list + 1] = { kind = kind, text = text:sub(at, state.offset - 1), at = at, line = line }
    end
    kind, _, line, at = lexer.next_token(state)
  end
  return list
end

--- Everything that can be changed in a text.
---@param text string Lua source
---@return table[] list of `{ at =, line =, old =, new = }`
function mutations.list(text)
  local list, before = {}, nil
  for _, token in ipairs(mutations.tokens(text)) do
    for _, new in ipairs(others(token.kind, token.text, before)) do
      list[#list + 1] = { at = token.at, line = token.line, old = token.text, new = new }
    end
    before = token.kind
  end
  return list
end

--- The text with one of them.
---@param text string Lua source
---@param change table one of `mutations.list(text)`
---@return string? text nil: it is no Lua any more
function mutations.apply(text, change)
  local changed = text:sub(1, change.at - 1) .. change.new .. text:sub(change.at + #change.old)
  return (loadstring or load)(changed) and changed
end

return mutations
