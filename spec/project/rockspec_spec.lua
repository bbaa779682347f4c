-- The rockspec repeats what the files say; here they are compared. And the address of the project
-- stands in the rockspec alone (scripts/publish.lua).

local files = require("spec.support.files")
local publish = require("scripts.publish")

local read = files.read
local ROCKSPEC = "rockspec/physics-scm-1.rockspec"
local ADDRESS = "https://github.com/Owner/name"
local ADDRESSED = read(ROCKSPEC):gsub('url = "[^"]*"', 'url = "git+' .. ADDRESS .. '"', 1)

-- A rockspec is Lua that assigns globals. Reads its text into a table, whatever the version of Lua.
local function run(text)
  local found = {}
  if setfenv then -- luacheck: ignore
    setfenv(assert(loadstring(text)), found)() -- luacheck: ignore
  else
    assert(load(text, ROCKSPEC, "t", found))()
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
  it("installs every file of the library #files", function()
    assert.same(modulesOnDisk(), run(read(ROCKSPEC)).build.modules)
  end)

  it("allows the Lua that runs this", function()
    local least, below = run(read(ROCKSPEC)).dependencies[1]:match("^lua >= ([%d.]+), < ([%d.]+)$")
    local running = tonumber(_VERSION:match("%d+%.%d+"))
    assert.is_true(running >= tonumber(least) and running < tonumber(below))
  end)

  it("of a release says the same, but for version, tag and address", function()
    local main, release = run(ADDRESSED), run(publish.rockspec("1.2.3", ADDRESSED))
    assert.same({ url = "git+" .. ADDRESS, tag = "v1.2.3" }, release.source)
    assert.equal("1.2.3-1", release.version)
    assert.equal(ADDRESS, release.description.homepage)
    assert.equal(ADDRESS .. "/issues", release.description.issues_url)
    release.version, release.source = main.version, main.source
    release.description.homepage, release.description.issues_url = nil, nil
    assert.same(main, release)
  end)
end)

describe("publishing", function()
  it("finds the address in the rockspec alone #files", function()
    for _, path in
      ipairs(files.list("git ls-files -- '*.md' '*.yml' '*.py' '*.mjs' '*.lua' '*.html'"))
    do
      local text = read(path)
      local found = text:match("github%.com/[%w-]+/physics%.lua")
        or text:match("github%.io/physics%.lua")
      assert.is_true(path == "README.md" or not found, path)
    end
  end)
end)

it("the changelog tells what is unreleased first, or the version of the library", function()
  local first = read("CHANGELOG.md"):match("\n## ([^\n]+)")
  local version = require("physics")._VERSION
  assert.equal(first == "Unreleased", version:find("%-dev$") ~= nil)
  assert.is_true(first == "Unreleased" or first:match("^[%d%.]+") == version)
end)
