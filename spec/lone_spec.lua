--- Hits with which nobody else has to do are resolved at once (physics/lone.lua), to the same bits
--- as one by one.

local effort = require("spec.support.effort")
local lone = require("physics.lone")
local newRandom = require("spec.support.random").new
local physics = require("physics")

--- Counts what is resolved so and what is taken back of it: because a neighbour meets somebody, as
--- is known at once, and because a neighbour was hit first, as turns out later. Single hits count.
local function spy()
  local seen = { hits = 0, disturbed = 0, near = 0 }
  local resolve, undoDisturbed, undoNear = lone.resolve, lone.undoDisturbed, lone.undoNear
  local function counted(name, f)
    return function(b, ...)
      local before = b.resolved
      local result = f(b, ...)
      local change = b.resolved - before
      seen[name] = seen[name] + (change < 0 and -change or change)
      return result
    end
  end
  lone.resolve = counted("hits", resolve)
  lone.undoDisturbed = counted("disturbed", undoDisturbed)
  lone.undoNear = counted("near", undoNear)
  return seen,
    function()
      lone.resolve, lone.undoDisturbed, lone.undoNear = resolve, undoDisturbed, undoNear
    end
end

--- Fields of an object that differ from what most have, for one in two worlds of boxes.
local SPECIALS = {
  { friction = 0.5 },
  { sensor = true },
  { pushable = false },
  { kinematic = true },
  { drag = 3 },
  { oneWay = "top" },
  { maxSpeed = 100 },
  { ax = 300 },
  { gravity = -200 },
}

local function addWalls(random, world, size)
  for i = 0, 3 do
    local isUpright = i < 2
    world:add("walls", {
      x = i == 1 and size or -100,
      y = i == 3 and size or -100,
      width = isUpright and 100 or size + 200,
      height = isUpright and size + 200 or 100,
      restitution = random:chance(0.3) and 1 or nil,
      friction = random:chance(0.2) and 0.5 or nil,
      static = true,
    })
  end
end

--- A room of boxes that fly about, mostly too many and too fast to be alone.
local function room(seed, queueOnly)
  local random = newRandom(seed)
  local gravity = random:chance(0.5) and 0 or random:between(-300, 600)
  local world = physics.newWorld({ gravity = gravity, broadphase = queueOnly and "pairs" or nil })
  world._bodies.queueOnly = queueOnly
  local size, most = random:between(100, 400), random:between(50, 3000)
  local hasSpecials = random:chance(0.5)
  addWalls(random, world, size)
  local boxes = {}
  for i = 1, random:integer(5, 80) do
    local box = {
      x = random:between(0, size - 20),
      y = random:between(0, size - 20),
      width = random:between(4, 20),
      height = random:between(4, 20),
      vx = random:between(-most, most),
      vy = random:between(-most, most),
      restitution = random:chance(0.8) and random:between(0.3, 1) or nil,
      mass = random:chance(0.3) and random:between(0.5, 4) or nil,
    }
    for field, value in pairs(hasSpecials and random:chance(0.5) and random:pick(SPECIALS) or {}) do
      box[field] = value
    end
    boxes[i] = world:add("boxes", box)
  end
  return world, boxes
end

describe("hits with which nobody else has to do", function()
  local seen, restore

  before_each(function()
    seen, restore = spy()
  end)

  after_each(function()
    restore()
  end)

  it("lead to the same bits as one by one, also when they are taken back", function()
    for seed = 1, effort.share(40) do
      local one, boxes = room(seed)
      local other, others = room(seed, true)
      local random = newRandom(seed + 1)
      for step = 1, 60 do
        local dt = random:chance(0.8) and 1 / 60 or random:between(0.001, 0.05)
        one:update(dt)
        other:update(dt)
        for i, box in ipairs(boxes) do
          local its = others[i]
          if box.x ~= its.x or box.y ~= its.y or box.vx ~= its.vx or box.vy ~= its.vy then
            error(("seed %d, step %d: box %d is elsewhere"):format(seed, step, i))
          end
        end
      end
    end
    -- All ways through it were gone.
    assert.is_true(seen.hits > 100 and seen.disturbed > 20 and seen.near > 0)
  end)

  -- Equal masses that bounce off each other in a row exchange their velocities: up to the widths
  -- they go on as if they passed through each other.
  --
  --     [e] ->  [d]  [c]  [a]     <- [b]
  --
  -- e meets d and b meets a; nobody else is met yet. But d meets c then, and c meets a before b
  -- does.
  it("are taken back when a neighbour comes first", function()
    local world = physics.newWorld({ gravity = 0 })
    local row = {
      { x = 0, width = 10, vx = 780 },
      { x = 10.5, width = 10 },
      { x = 24, width = 14 },
      { x = 43.2, width = 10 },
      { x = 62.4, width = 10, vx = -600 },
    }
    for _, box in ipairs(row) do
      box.y, box.height, box.restitution = 0, 10, 1
      world:add("row", box)
    end
    world:update(1 / 60)
    assert.same({ hits = 2, disturbed = 0, near = 1 }, seen)
    -- Without widths they are at 0 + 13, 0.5, 4, 9.2 and 18.4 - 10 then.
    local expected =
      { { 0.5, 0 }, { 10 + 4, 0 }, { 20 + 8.4, -600 }, { 34 + 9.2, 0 }, { 44 + 13, 780 } }
    for i, box in ipairs(row) do
      assert.near(expected[i][1], box.x, 1e-9)
      assert.near(expected[i][2], box.vx, 1e-9)
    end
  end)
end)
