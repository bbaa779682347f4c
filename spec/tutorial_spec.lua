--- The tutorial, followed line by line: global names, grouped tables, a loop. What its functions
--- find is in world_tutorial_spec.lua.
-- luacheck: globals objects physics_load physics_update

local fresh = require("spec.support.fresh")
local physics = require("physics")

local GLOBALS = { "objects", "physics_load", "physics_update", "checkCollision", "inside", "bump" }
local DT = 1 / 60

-- A global that a spec assigns would be busted's own, one that it reads is real.
local globals = _G

local function forgetGlobals()
  for _, name in ipairs(GLOBALS) do
    rawset(_G, name, nil)
  end
end

describe("the library", function()
  it("sets no global, until it is asked to", function()
    local before = {}
    for name in pairs(_G) do
      before[name] = true
    end
    fresh.during(function(again)
      again.load({ gravity = 0 })
      again.add("boxes", { x = 0, y = 0, width = 1, height = 1 })
      again.update(DT)
    end)
    for name in pairs(_G) do
      assert.is_true(before[name], tostring(name))
    end
    for _, name in ipairs(GLOBALS) do
      assert.is_nil(rawget(_G, name))
    end
  end)
end)

describe("the tutorial", function()
  before_each(function()
    physics.load()
    physics.globals()
  end)

  after_each(function()
    forgetGlobals()
    physics.load()
  end)

  it("loads, and updates a table of groups that the game assigns", function()
    globals.objects = {
      players = { { x = 40, y = 40, width = 24, height = 32 } },
      tiles = { { x = 0, y = 560, width = 800, height = 40, static = true } },
    }
    physics_load({ gravity = 800 })
    for _ = 1, 120 do
      physics_update(DT)
    end
    assert.equal(528, objects.players[1].y)
    assert.equal(objects.tiles[1], objects.players[1].touching.bottom)
    assert.equal(objects, physics.objects)
  end)

  it("reads the global anew at every update", function()
    physics_load({ gravity = 0 })
    globals.objects = { boxes = { { x = 0, y = 0, width = 8, height = 8, vx = 60 } } }
    physics_update(DT)
    local first = objects.boxes[1]
    assert.near(1, first.x, 1e-12)
    globals.objects = { boxes = { { x = 100, y = 0, width = 8, height = 8, vx = 60 } } }
    physics_update(DT)
    assert.near(1, first.x, 1e-12)
    assert.near(101, objects.boxes[1].x, 1e-12)
  end)

  it("may put all objects into one table, without groups", function()
    physics_load({ gravity = 800 })
    globals.objects = {
      { x = 0, y = 0, width = 16, height = 16 },
      { x = -50, y = 100, width = 200, height = 16, static = true },
      player = { x = 40, y = 0, width = 16, height = 16 },
    }
    for _ = 1, 60 do
      physics_update(DT)
    end
    assert.equal(84, objects[1].y)
    assert.equal(84, objects.player.y)
  end)

  it("may start with no table at all", function()
    rawset(_G, "objects", nil)
    physics_load()
    objects.boxes = { { x = 0, y = 0, width = 16, height = 16 } }
    physics_update(DT)
    assert.is_true(objects.boxes[1].y > 0)
  end)
end)
