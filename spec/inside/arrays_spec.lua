--- Columns in typed arrays (physics/memory/arrays.lua): LuaJIT checks no index of them. Here tables
--- stand for them that check all, and that know when they are no column any more.

local effort = require("spec.support.effort")
local fresh = require("spec.support.fresh")
local small = require("spec.support.small")

effort.interpret(setup, teardown)

-- The first value of each kind, and whether it may hold another one.
local FIRST = { double = 0, int32_t = 0, bool = false }

local function fits(kind, value)
  local isWhole = kind ~= "int32_t" or value % 1 == 0 and math.abs(value) < 2 ^ 31
  return type(value) == type(FIRST[kind]) and isWhole
end

-- Returns a column with places from 0 to `last`, which takes over the values of `old`. A call of it
-- ends it, and returns its values.
local function guarded(kind, last, old)
  local values, isGone = old and old() or {}, false
  for k = #values + 1, last do
    values[k] = FIRST[kind]
  end
  values[0] = values[0] or FIRST[kind]
  local function at(k)
    if isGone or k < 0 or k > last or k % 1 ~= 0 then
      local text = "place %s of 0 to %d, of an array that is%s a column"
      error(text:format(k, last, isGone and " no more" or ""))
    end
    return k
  end
  return setmetatable({}, {
    __index = function(_, k)
      return values[at(k)]
    end,
    __newindex = function(_, k, value)
      assert(fits(kind, value), value)
      values[at(k)] = value
    end,
    __call = function()
      isGone = true
      return values
    end,
  })
end

local function guard(arrays)
  function arrays.grow(kind, column, width, old, count)
    return kind and guarded(kind, width * count, old > 0 and column) or column
  end
end

-- Frames of a scene of the benchmark.
local function play(name, n, frames)
  package.loaded["bench.engines.ours"] = nil
  local scenes, ours = require("bench.scenes"), require("bench.engines.ours")
  local scene = scenes.build(name, n)
  local world = ours.new(scene)
  for step = 1, frames do
    if scene.between then
      scene.between(world, step)
    end
    scene.frame(world, step)
  end
  package.loaded["bench.engines.ours"] = nil
end

describe("typed arrays: no place beyond its end and no old array is used", function()
  local SCENES = {
    { "pile", 60 },
    { "level", 150 },
    { "hills", 60 },
    { "gas", 60 },
    { "balls", 60 },
    { "zones", 30 },
    { "swarm-ax", 30 },
    { "swarm-soft-kite", 30 },
    { "bullets", 100 },
    { "lifts", 10 },
    { "asking", 40 },
    { "spawn", 60 },
    { "rest", 60 },
    { "restore", 60 },
    { "spot-corner", 20 },
    { "turning", 30 },
  }
  small.rows("in {1} of {2}", SCENES, function(name, count)
    fresh.during(function()
      guard(require("physics.memory.arrays"))
      play(name, count, 12)
    end)
  end)

  -- A ball that falls onto others gets a plane in the middle of a step, beside its contact.
  it("in a heap of elastic balls that others fall on", function()
    fresh.during(function(physics)
      guard(require("physics.memory.arrays"))
      local world = physics.newWorld({ gravity = 800 })
      world:setBounds(0, 0, 160, 300)
      for step = 1, 150 do
        if step % 3 == 0 then
          local x, radius = 20 + step * 37 % 60, 6 + step % 4
          world:add("balls", { x = x, y = 20, radius = radius, restitution = 0.4 })
        end
        world:update(1 / 60)
      end
    end)
  end)

  it("where a method is called for tiles, a state has them ride, or movers come later", function()
    fresh.during(function(physics)
      guard(require("physics.memory.arrays"))
      local world = physics.newWorld()
      for n = 1, 200 do
        world:add("tiles", { x = 50 * n, y = 0, width = 8, height = 8, static = true })
      end
      local box = world:add("boxes", { x = 0, y = 900, width = 8, height = 8 })
      local last = world.objects.tiles[200]
      world:update(1 / 60)
      assert.is_nil((world:ground(last)))
      assert.is_false(world:dropThrough(last))
      assert.matches("apart", world:explain(last, box))
      local state = world:save()
      state.memory.support = { 99, 100 }
      world:restore(state)
      world:remove(last)
      for n = 1, 2 do
        world:add("boxes", { x = 0, y = 900 - 20 * n, width = 8, height = 8 })
        world:update(1 / 60)
      end
      local b, layout = world._bodies, require("physics.memory.layout")
      assert.equal(3, b.moverCount)
      assert.is_true(b.reserved[layout.MOVER] < 50) -- the tiles have none of these columns
    end)
  end)
end)

-- A game with all that keeps the slots of static objects: what is added, moved, a zone, a state,
-- and a box that is put into the middle of a block. Returns it as text. `visit` is called with the
-- columns between two stages.
local function tell(library, visit)
  local world, log = library.newWorld({ gravity = 800 }), {}
  world.profile = visit and function()
    visit(world._bodies)
    return 0
  end
  local function wall(name, x, y, w, h, fields)
    return world:add(name, small.tile(x, y, w, h, fields))
  end
  wall("block", 0, 0, 200, 200)
  wall("above", 0, -100, 200, 100)
  wall("below", 0, 200, 200, 100)
  wall("left", -100, 0, 100, 200)
  wall("right", 200, 0, 100, 200)
  wall("winds", 300, -500, 100, 900, { sensor = true, area = { ax = 50 } })
  local shelf = wall("shelf", 600, 300, 50, 10)
  world:add("crates", { x = 90, y = -400, width = 20, height = 20 }) -- at "above" in step 50
  world:add("crates", { x = 310, y = -400, width = 20, height = 20 })
  local hero = world:add("hero", { x = 1000, y = 0, width = 20, height = 20, gravity = 0 })
  function hero.onCrush(_, a, b, axis)
    local one, other = a and world:groupOf(a), b and world:groupOf(b)
    log[#log + 1] = ("crushed by %s and %s, %s"):format(tostring(one), tostring(other), axis)
  end
  for n = 1, 70 do
    if n == 20 then
      wall("late", 300, 100, 60, 10)
    elseif n == 40 or n == 50 then
      shelf.x, hero.x, hero.y = 650 - n, 90, 85
      world:refresh(shelf)
    elseif n == 45 then
      hero.x, hero.y = 1000, 0
    elseif n == 60 then
      log[#log + 1] = world:restore(world:save())
    end
    world:update(1 / 60)
    log[#log + 1] = world:hash()
  end
  return table.concat(log, "\n")
end

-- The lists that any stage may use: see "Data" in ARCHITECTURE.
local SCRATCH = { "stack", "found", "pairList", "sortKey" }

it("scratch lists hold nothing from one stage to the next", function()
  local cleared = {}
  local function clear(b)
    for _, name in ipairs(SCRATCH) do
      for n = 1, #(b[name] or {}) do
        b[name][n], cleared[name] = 0, (cleared[name] or 0) + 1
      end
    end
  end
  assert.equal(tell(require("physics")), tell(require("physics"), clear))
  for _, name in ipairs(SCRATCH) do
    assert.is_true(cleared[name] > 100, name)
  end
end)

it("stamps go on beyond 2^31, which bullets reach in a day", function()
  local world = require("physics").newWorld()
  for n = 0, 1 do
    world:add("boxes", { x = 12 * n, y = 0, width = 8, height = 8, vx = 600 })
  end
  world:update(1 / 60)
  local b = world._bodies
  b.stamp, b.solveStamp, b.roundStamp, b.dirtyStamp = 2 ^ 31, 2 ^ 31, 2 ^ 31, 2 ^ 31
  small.run(world, 30)
  assert.equal(1, world.stats.pairs)
end)
