-- The rockspec and the changelog repeat what the files say; here they are compared.

local ROCKSPEC = "rockspec/physics-0.1.0-1.rockspec"

local function read(path)
  local file = assert(io.open(path, "rb"))
  local text = file:read("*a")
  file:close()
  return text
end

-- A rockspec is Lua that assigns globals. Read it into a table, whatever the version of Lua.
local function readRockspec()
  local found = {}
  if setfenv then -- luacheck: ignore
    setfenv(assert(loadstring(read(ROCKSPEC))), found)() -- luacheck: ignore
  else
    assert(load(read(ROCKSPEC), ROCKSPEC, "t", found))() -- luacheck: ignore
  end
  return found
end

-- Every Lua file of the library, as { [module name] = path }.
local function modulesOnDisk()
  local found = {}
  local listing = assert(io.popen("find physics.lua physics -name '*.lua'"))
  for path in listing:lines() do
    found[path:gsub("%.lua$", ""):gsub("/", ".")] = path
  end
  listing:close()
  return found
end

describe("the rockspec", function()
  it("installs every file of the library #files", function()
    assert.same(modulesOnDisk(), readRockspec().build.modules)
  end)

  it("has the version of the library", function()
    local rockspec = readRockspec()
    local version = require("physics")._VERSION
    assert.equal(version .. "-1", rockspec.version)
    assert.equal("v" .. version, rockspec.source.tag)
    assert.equal("rockspec/physics-" .. rockspec.version .. ".rockspec", ROCKSPEC)
  end)
end)

describe("the changelog", function()
  it("tells what is unreleased first, or the version of the library", function()
    local first = read("CHANGELOG.md"):match("\n## ([^\n]+)")
    local version = require("physics")._VERSION
    assert.is_true(first == "Unreleased" or first:match("^[%d%.]+") == version)
  end)
end)
