--- Two things that are right in Lua, but which gopher-lua gets wrong (spec/gopher/README.md), do
--- not stand in the library. `make test-gopher` may find them, too, but only where there is Go.

-- Splits at the commas that stand in no bracket.
local function split(text)
  local parts, depth, part = {}, 0, ""
  for character in text:gmatch(".") do
    if character:find("[%(%[{]") then
      depth = depth + 1
    elseif character:find("[%)%]}]") then
      depth = depth - 1
    end
    if character == "," and depth == 0 then
      parts[#parts + 1], part = part, ""
    else
      part = part .. character
    end
  end
  parts[#parts + 1] = part
  return parts
end

-- Whether a variable is read in an expression: its name, but not as a field.
local function reads(expression, name)
  return (" " .. expression):find("[^%w_.:]" .. name .. "%f[^%w_]") ~= nil
end

-- Whether `a, b = …` reads a variable after it has been written, when it writes from left to right.
local function readsWhatItWrote(line)
  local left, right = line:match("^%s*([%a_][^=]-) = (.*)$")
  if not left or left:find("^local ") or left:find("^for ") or left:find("^function ") then
    return false
  end
  local names, values = split(left), split((right:gsub('"[^"]*"', '""'):gsub(" %-%-.*$", "")))
  for i = 1, #names do
    local name = names[i]:match("^%s*([%a_][%w_]*)%s*$")
    for j = i + 1, #names do
      if name and (reads(values[j] or "", name) or reads(names[j], name)) then
        return true
      end
    end
  end
  return false
end

-- Whether a loop over `next` leaves out where to start.
local function startsAnywhere(line)
  local values = line:match("%f[%w_]in (next, .*) do%f[%W]")
  return values ~= nil and #split(values) < 3
end

local function eachLine(visit)
  local listing, count = assert(io.popen("find physics.lua physics -name '*.lua'")), 0
  for path in listing:lines() do
    local number = 0
    for line in io.lines(path) do
      number, count = number + 1, count + 1
      visit(line, path .. ":" .. number .. ": " .. line)
    end
  end
  listing:close()
  assert.is_true(count > 5000)
end

describe("the library", function()
  it("swaps no variables by one assignment", function()
    eachLine(function(line, place)
      assert.is_false(readsWhatItWrote(line), place)
    end)
  end)

  it("says where a loop over next starts", function()
    eachLine(function(line, place)
      assert.is_false(startsAnywhere(line), place)
    end)
  end)
end)
