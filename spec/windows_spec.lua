--- What is different on Windows: paths with "\", and files with CR LF.

local read = require("spec.support.files").read

describe("require and loadTiled: on Windows", function()
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
