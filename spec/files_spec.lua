--- A game in files: scenes and rooms are worlds that know nothing of each other, and the library
--- may lie in any folder.

local files = require("spec.support.files")
local physics = require("physics")
local small = require("spec.support.small")

local newBox, newFloor, run = small.box, small.floor, small.run

local DT = 1 / 60

describe("newWorld: two worlds", function()
  it("know nothing of each other", function()
    local one, other = physics.newWorld({ gravity = 800 }), physics.newWorld({ gravity = 0 })
    one:add("tiles", newFloor())
    local first, second = one:add("boxes", newBox(0, 0)), other:add("boxes", newBox(0, 0))
    run(one)
    run(other)
    assert.same({ 84, 0, 2, 1 }, { first.y, second.y, one.stats.objects, other.stats.objects })
  end)

  it("may be stepped from each other's callbacks", function()
    local function make()
      local world = physics.newWorld({ gravity = 800, rest = false }) -- it is asked at every step
      world:add("tiles", newFloor())
      return world, world:add("boxes", newBox(0, 0, { restitution = 0.5 }))
    end
    local outer, outerBox = make()
    local inner, innerBox = make()
    local function step()
      inner:update(DT)
    end
    local calls = 0
    function inner.canCollide()
      calls = calls + 1
      return true
    end
    outerBox.onBegin = step
    run(outer, 120)
    assert.is_true(innerBox.y > 0)
    outer.canCollide = step
    run(outer, 200)
    assert.equal(84, innerBox.y)
    assert.is_true(calls > 0)
  end)
end)

-- The interpreter that runs this spec, with its arguments.
local function interpreter()
  local args, first = rawget(_G, "arg"), 0
  while args[first - 1] do
    first = first - 1
  end
  return args[first]
end

it("require: lib.physics works, blames the game, needs nothing else #posix", function()
  local folder = os.tmpname()
  os.remove(folder)
  files.output(("mkdir -p '%s/lib' && cp -r physics.lua physics '%s/lib'"):format(folder, folder))
  files.write(
    folder .. "/main.lua",
    [[
      local before = {}
      for name in pairs(_G) do before[name] = true end
      local physics = require "lib.physics"
      physics.load { gravity = 800 }
      physics.add("tiles", { x = 0, y = 100, width = 100, height = 10, static = true })
      local box = physics.add("boxes", { x = 0, y = 0, width = 16, height = 16 })
      for _ = 1, 60 do physics.update(1 / 60) end
      assert(box.y == 84 and box.touching.bottom)
      physics.globals()
      objects, physics_load, physics_update, checkCollision, inside, bump = nil
      for name in pairs(_G) do assert(before[name], name) end
      for name in pairs(package.loaded) do
        assert(name ~= "physics" and not name:find("^physics%."), name)
      end
      local ok, message = pcall(function() physics.update(-1) end)
      assert(message:find("^%.?/?main.lua:%d+: physics: world:update"), message)
      print("it works")
    ]]
  )
  local printed = files.output(("cd '%s' && '%s' main.lua 2>&1"):format(folder, interpreter()))
  files.output(("rm -r '%s'"):format(folder))
  assert.equal("it works\n", printed)
end)
