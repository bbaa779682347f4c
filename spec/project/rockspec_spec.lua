-- The rockspecs and the changelog repeat what the files say; here they are compared.

local files = require("spec.support.files")

local read = files.read
local ROCKSPEC = "rockspec/physics-1.0.0-1.rockspec"
local UNRELEASED = "rockspec/physics-scm-1.rockspec"

-- A rockspec is Lua that assigns globals. Read it into a table, whatever the version of Lua.
local function readRockspec(path)
  local found = {}
  if setfenv then -- luacheck: ignore
    setfenv(assert(loadstring(read(path))), found)() -- luacheck: ignore
  else
    assert(load(read(path), path, "t", found))() -- luacheck: ignore
  end
  return found
end

-- Every Lua file of the library, as { [module name] = path }.
local function modulesOnDisk()
  local found = {}
  for _, path in ipairs(files.list("find physics.lua physics -name '*.lua'")) do
    found[path:gsub("%.lua$", ""):gsub("/", ".")] = path
  end
  return found
end

describe("the rockspec", function()
  for _, path in ipairs({ ROCKSPEC, UNRELEASED }) do
    it("installs every file of the library: " .. path .. " #files", function()
      assert.same(modulesOnDisk(), readRockspec(path).build.modules)
    end)
  end

  it("has the version of the library", function()
    local rockspec = readRockspec(ROCKSPEC)
    local version = require("physics")._VERSION
    assert.equal(version .. "-1", rockspec.version)
    assert.equal("v" .. version, rockspec.source.tag)
    assert.equal("rockspec/physics-" .. rockspec.version .. ".rockspec", ROCKSPEC)
  end)

  it("of what is unreleased says the same, but for the version and its place", function()
    local released, unreleased = readRockspec(ROCKSPEC), readRockspec(UNRELEASED)
    assert.equal("scm-1", unreleased.version)
    assert.equal(released.source.url, unreleased.source.url)
    assert.is_nil(unreleased.source.tag)
    for _, rockspec in ipairs({ released, unreleased }) do
      rockspec.version, rockspec.source = nil, nil
    end
    assert.same(released, unreleased)
  end)

  it("allows the Lua that runs this", function()
    local least, below =
      readRockspec(ROCKSPEC).dependencies[1]:match("^lua >= ([%d.]+), < ([%d.]+)$")
    local running = tonumber(_VERSION:match("%d+%.%d+"))
    assert.is_true(running >= tonumber(least) and running < tonumber(below))
  end)
end)

describe("the changelog", function()
  it("tells what is unreleased first, or the version of the library", function()
    local first = read("CHANGELOG.md"):match("\n## ([^\n]+)")
    local version = require("physics")._VERSION
    assert.is_true(first == "Unreleased" or first:match("^[%d%.]+") == version)
  end)
end)
