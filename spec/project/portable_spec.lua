--- What does not stand in the library, though it is right in the Lua and the LÖVE that are here:
--- three things that gopher-lua takes otherwise (spec/gopher/README.md), and what LÖVE 12 takes
--- away, also in the examples. Source: "Removed functions deprecated in LOVE 11", changes.txt. And
--- the paths of Windows.

local files = require("spec.support.files")

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

-- Whether a variable becomes a chain of `and` in which it stands itself, `a = a and b and c`, or
-- what stands last in one: `a = f() and a`.
local function chainsItself(line)
  local name, right = line:match("^%s*([%a_][%w_]*) = (.*)$")
  if not name or right:find(" or ") or not reads(right, name) then
    return false
  end
  return right:find(" and .* and ") ~= nil or right:find(" and " .. name .. "$") ~= nil
end

it("the library has nothing in it that gopher-lua takes in another way", function()
  local count = 0
  for _, path in ipairs(files.list("find physics.lua physics -name '*.lua'")) do
    for line in io.lines(path) do
      count = count + 1
      local place = path .. ": " .. line
      assert.is_false(readsWhatItWrote(line), place)
      assert.is_false(startsAnywhere(line), place)
      assert.is_false(chainsItself((line:gsub("%-%-.*", ""):gsub("%b()", "()"))), place)
    end
  end
  assert.is_true(count > 5000)
end)

-- Names that LÖVE 12 takes away. A name ends where it ends: `getSize` is not in `getSizes`.
local REMOVED = "audio.getSourceCount filesystem.exists filesystem.isDirectory filesystem.isFile"
  .. " filesystem.isSymlink filesystem.getLastModified filesystem.getSize math.compress"
  .. " math.decompress .getChannels .getAreaSpread .setAreaSpread .getBodyList .getFixtureList"
  .. " .getJointList .getContactList .hasLimitsEnabled"

it("LÖVE 12 has everything that draw, tiled and the examples use #posix", function()
  local count = 0
  for _, path in ipairs(files.list("find physics examples -name '*.lua'")) do
    local text = files.read(path)
    if text:find("love%.%a") then
      count = count + 1
      for name in REMOVED:gmatch("%S+") do
        local pattern = name:gsub("^%a+%.", "love.%0"):gsub("%.", "[.:]")
        assert.is_nil(text:match(pattern .. "%f[^%w_]"), path)
      end
      assert.is_nil(text:match("setColorMask%(%)") or text:match("[bB]atch:setColor%(%)"), path)
    end
  end
  assert.is_true(count > 10)
end)

describe("loadTiled: on Windows", function()
  it("a checkout has LF, whatever git is told there #files", function()
    assert.truthy(files.read(".gitattributes"):find("* text=auto eol=lf", 1, true))
  end)

  it("a path with a backslash is told why love.filesystem does not find it", function()
    local before = rawget(_G, "love")
    rawset(_G, "love", {
      filesystem = {
        getInfo = function(path)
          return path == "levels/one.lua" and {} or nil
        end,
      },
    })
    local world = require("physics").newWorld()
    local isFine, message = pcall(world.loadTiled, world, "levels\\one.lua")
    local isFineToo, other = pcall(world.loadTiled, world, "levels/two.lua")
    rawset(_G, "love", before)
    assert.is_false(isFine or isFineToo)
    local hint = 'cannot read "levels\\\\one.lua": there is no such file; '
      .. "love.filesystem divides folders by / on every system"
    assert.truthy(message:find(hint, 1, true), message)
    assert.truthy(other:find('"levels/two.lua": there is no such file$'), other)
  end)
end)
