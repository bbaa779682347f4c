--- What is loaded with the library, what only when it is first used, and that a game sees no
--- difference.

local fresh = require("spec.support.fresh")

-- A world that has made some steps, in which a box has landed.
local function play(physics)
  local world = physics.newWorld({ gravity = 800 })
  local floor = world:add("floors", { x = 0, y = 100, width = 200, height = 16, static = true })
  local box = world:add("boxes", { x = 20, y = 0, width = 16, height = 16 })
  for _ = 1, 60 do
    world:update(1 / 60)
  end
  assert.equal(84, box.y)
  world:remove(world:add("boxes", { x = 60, y = 0, width = 16, height = 16 }))
  return world, box, floor
end

describe("a part of the library that the first step does not need", function()
  -- of most folders one file, and what needs it: a method with its arguments, or a setting, "=",
  -- with its value;
  -- "box" and "floor" are what is in the world
  for _, row in ipairs({
    { "maps.tiled", "loadTiled", {} },
    { "motion.drift", "=", "soft", { boxes = { boxes = 100 } } },
    { "queries.move", "move", "box", 8, 8 },
    { "solver.bounds", "add", "balls", { x = 0, y = 0, radius = 9 } },
    { "state.save", "save" },
    { "world.draw", "draw" },
    { "world.checked", "=", "checked", true },
    { "fields.wording", "add" },
  }) do
    -- (In one file nothing is in package.loaded.)
    it(row[1] .. " #files is loaded when it is first used", function()
      fresh.during(function(physics)
        local world, box, floor = play(physics)
        local named = { box = box, floor = floor }
        assert.is_nil(package.loaded["physics." .. row[1]])
        if row[2] == "=" then
          world[row[3]] = row[4]
        else
          local call, first = world[row[2]] or physics[row[2]], named[row[3]] or row[3]
          if world[row[2]] then
            pcall(call, world, first, named[row[4]] or row[4], row[5], row[6])
          else
            call(first, named[row[4]])
          end
        end
        world:update(1 / 60)
        assert.is_not_nil(package.loaded["physics." .. row[1]])
      end)
    end)
  end
end)
