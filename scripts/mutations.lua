--- The small changes that scripts/mutants.lua tries on a source text, one at a time: another
--- operator, a comparison turned round or with its edge moved, another constant, min for max.

local tokens = require("scripts.tokens")

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

-- Another number, of the same kind: 1 more, or the double of what may be very small or large.
local function otherNumber(text)
  local value = tonumber(text)
  if value == 0 then
    return text:find("%.") and "1.0" or "1"
  end
  return text:find("[%.exEX]") and "(" .. text .. " * 2)" or tostring(value + 1)
end

-- What a token may become. `t.min` is a field of that name.
local function others(token, before)
  if token.kind == "number" then
    return { otherNumber(token.text) }
  elseif token.text == "-" and (not before or tokens.isOpen(before)) then
    return { "" }
  elseif token.kind == "operator" or token.kind == "word" then
    local isField = before and (before.text == "." or before.text == ":")
    return not isField and SWAPS[token.text] or {}
  end
  return {}
end

--- Everything that can be changed in a text.
---@param text string Lua source
---@return table[] list of `{ at =, line =, old =, new = }`
function mutations.list(text)
  local list, before = {}, nil
  for _, token in ipairs(tokens.list(text)) do
    for _, new in ipairs(others(token, before)) do
      list[#list + 1] = { at = token.at, line = token.line, old = token.text, new = new }
    end
    before = token
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

local function trimmed(line)
  return (line:gsub("^%s+", ""))
end

--- The line that a change is in, as it becomes, without its indentation.
---@param text string Lua source
---@param change table one of `mutations.list(text)`
---@return string line
function mutations.changedLine(text, change)
  local start = text:sub(1, change.at - 1):match("^.*\n()") or 1
  local after = text:sub(change.at + #change.old):match("^[^\n]*")
  return trimmed(text:sub(start, change.at - 1) .. change.new .. after)
end

--- Where a line is.
---@param text string
---@param wanted string the line without its indentation, after some that are before it if there are
---  several like it
---@return integer? number of the line, from 1; nil: there is none, or more than one
function mutations.findLine(text, wanted)
  local number, found, count = 0, nil, select(2, wanted:gsub("\n", ""))
  local lines = {}
  for line in (text .. "\n"):gmatch("(.-)\n") do
    number = number + 1
    lines[number] = trimmed(line)
    if number > count and table.concat(lines, "\n", number - count) == wanted then
      if found then
        return nil
      end
      found = number
    end
  end
  return found
end

return mutations
