--- LÖVE 12 is not out, so nothing can be run on it here. But its list of changes says what it takes
--- away, and that must not be used: neither by the files of the library that name LÖVE, nor by the
--- examples. Source: "Removed functions deprecated in LOVE 11" in the changes.txt of LÖVE 12.0.

local REMOVED = {
  "love%.audio%.getSourceCount",
  "love%.filesystem%.exists",
  "love%.filesystem%.isDirectory",
  "love%.filesystem%.isFile",
  "love%.filesystem%.isSymlink",
  "love%.filesystem%.getLastModified",
  "love%.filesystem%.getSize",
  "love%.math%.compress",
  "love%.math%.decompress",
  "[.:]getChannels",
  "[.:][gs]etAreaSpread",
  "[.:]getBodyList",
  "[.:]getFixtureList",
  "[.:]getJointList",
  "[.:]getContactList",
  "[.:]hasLimitsEnabled",
  "setColorMask%(%)",
  "[bB]atch:setColor%(%)",
}

local function filesThatNameLove()
  local listing = assert(io.popen("find physics examples -name '*.lua' | LC_ALL=C sort"))
  local texts = {}
  for path in listing:lines() do
    local file = assert(io.open(path, "rb"))
    local text = file:read("*a")
    file:close()
    if text:find("love%.%a") then
      texts[path] = text
    end
  end
  listing:close()
  return texts
end

-- What of the list a text uses, or nil.
local function findRemoved(text)
  for _, pattern in ipairs(REMOVED) do
    -- A name ends where it ends: `getSize` is not in `getSizes`.
    local found = text:match(pattern .. (pattern:find("%a$") and "%f[^%w_]" or ""))
    if found then
      return found
    end
  end
end

describe("LÖVE 12", function()
  it("has everything that draw, tiled and the examples use #posix", function()
    local count = 0
    for path, text in pairs(filesThatNameLove()) do
      count = count + 1
      assert.is_nil(findRemoved(text), path)
    end
    assert.is_true(count > 10)
  end)
end)
