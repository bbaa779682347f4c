--- What is loaded with the library, what only when it is first used, and that a game sees no
--- difference.

local fresh = require("spec.support.fresh")

-- What calls load, by the file that they need.
local USES = {
  ["physics.maps.array"] = function(_, world)
    world:addTiles("tiles", { "#" }, nil, 16)
  end,
  ["physics.maps.ldtk"] = function(_, world)
    pcall(world.loadLDtk, world, {})
  end,
  ["physics.maps.tiled"] = function(_, world)
    pcall(world.loadTiled, world, {})
  end,
  ["physics.motion.softDrift"] = function(_, world)
    world.soft = { boxes = { boxes = 100 } }
    world:update(1 / 60)
  end,
  ["physics.queries.move"] = function(_, world, box)
    world:move(box, 8, 8)
  end,
  ["physics.queries.query"] = function(_, world)
    world:nearest(0, 0, 10)
  end,
  ["physics.queries.rays"] = function(_, world)
    world:raycast(0, 0, 10, 10)
  end,
  ["physics.state.hash"] = function(_, world)
    world:hash()
  end,
  ["physics.state.restore"] = function(_, world)
    world:restore(world:save())
  end,
  ["physics.state.save"] = function(_, world)
    world:save()
  end,
  ["physics.world.bounds"] = function(_, world)
    world:setBounds(0, 0, 10, 10)
  end,
  ["physics.world.draw"] = function(_, world)
    pcall(world.draw, world)
  end,
  ["physics.world.explain"] = function(_, world, box, floor)
    world:explain(box, floor)
  end,
  ["physics.world.checked"] = function(_, world)
    world.checked = true
    world:update(1 / 60)
  end,
  ["physics.fields.wording"] = function(_, world)
    pcall(world.add, world)
  end,
  ["physics.world.tutorial"] = function(physics, _, box, floor)
    physics.bump(box, floor)
  end,
}

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
  local names = {}
  for name in pairs(USES) do
    names[#names + 1] = name
  end
  table.sort(names)

  for _, name in ipairs(names) do
    -- (In one file nothing is in package.loaded.)
    it(name .. " #files is loaded when it is first used", function()
      fresh.during(function(physics)
        local world, box, floor = play(physics)
        assert.is_nil(package.loaded[name])
        USES[name](physics, world, box, floor)
        assert.is_not_nil(package.loaded[name])
      end)
    end)
  end

  it("#files is found under the name of the folder that the game gave it", function()
    local function rename(name)
      if name == "engine" or name:find("^engine%.") then
        local path = name:gsub("^engine", "physics"):gsub("%.", "/") .. ".lua"
        return loadfile(path)
      end
    end
    local searchers = rawget(package, "searchers") or rawget(package, "loaders")
    table.insert(searchers, 2, rename)
    local isDone, problem = pcall(function()
      local world, box = play(require("engine"))
      assert.equal(box, (world:raycast(28, 50, 28, 99)))
      assert.is_number(world:hash())
    end)
    table.remove(searchers, 2)
    for name in pairs(package.loaded) do
      if name:find("^engine") then
        package.loaded[name] = nil
      end
    end
    assert(isDone, problem)
  end)

  it("#files is a plain table of functions from then on", function()
    local lazy, module = require("physics.memory.lazy"), { first = print, second = type }
    package.preload["spec.a_part"] = function()
      return module
    end
    local stand = lazy("spec.a_part")
    assert.equal(stand, lazy("spec.a_part"))
    assert.is_not_nil(getmetatable(stand))
    assert.equal(module.first, stand.first)
    assert.is_nil(getmetatable(stand))
    assert.is_nil(stand.missing)
    assert.same(module, stand)
    package.preload["spec.a_part"], package.loaded["spec.a_part"] = nil, nil
  end)

  it("that is missing is #files named when it is used, each time", function()
    local stand = require("physics.memory.lazy")("physics.world.no_such_file")
    for _ = 1, 2 do
      local isDone, problem = pcall(function()
        return stand.run
      end)
      assert.is_false(isDone)
      assert.is_truthy(tostring(problem):find("no_such_file", 1, true))
    end
  end)
end)
