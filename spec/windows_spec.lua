--- What is different on Windows: paths with "\", in the names of chunks and in the calls of a game,
--- and files with CR LF. The specs run on other systems, where these are made by hand.

local effort = require("spec.support.effort")
local fresh = require("spec.support.fresh")

effort.interpretQuickly(setup, teardown)

local loadText = rawget(_G, "loadstring") or load
local searchers = rawget(package, "searchers") or rawget(package, "loaders")

local function read(path)
  local file = io.open(path, "rb")
  local text = file and file:read("*a")
  if file then
    file:close()
  end
  return text
end

-- Calls f with the library loaded from these texts under these names: change(text, path) returns
-- what is loaded instead of a file, and the name of its chunk.
local function during(change, f)
  local function search(name)
    local path = name:gsub("%.", "/") .. ".lua"
    local text = name:find("^physics") and read(path)
    if text then
      return assert(loadText(change(text, path)))
    end
  end
  table.insert(searchers, 2, search)
  local config = package.config
  rawset(package, "config", "\\" .. config:sub(2))
  local isDone, problem = pcall(fresh.during, f)
  rawset(package, "config", config)
  table.remove(searchers, 2)
  assert(isDone, problem)
end

describe("require and loadTiled: on Windows", function()
  it("files with CR LF do the same, to the bit #files", function()
    local expected = require("spec.support.everything").fold()
    local name, found = "spec.support.everything", nil
    local function convert(text, path)
      assert.is_nil(text:find("\r", 1, true), path)
      return text:gsub("\n", "\r\n"), "@" .. path
    end
    local everything = package.loaded[name]
    during(convert, function()
      package.loaded[name] = nil
      found = require(name).fold()
    end)
    package.loaded[name] = everything
    assert.equal(expected, found)
  end)

  it("a checkout has LF, whatever git is told there #files", function()
    assert.truthy(read(".gitattributes"):find("* text=auto eol=lf", 1, true))
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
