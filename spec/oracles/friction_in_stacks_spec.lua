--- Proves that stacks and rows go where very small steps lead them, as far as a step is long (by
--- hand that cannot be worked out any more).

local newRandom = require("spec.support.random").new
local physics = require("physics")
local small = require("spec.support.small")

-- A box of 16 px with its upper left corner at x, y; the floor is at y = 0.
local function put(x, y, friction, vx, mass, fields)
  local object = small.box(x, y, fields)
  object.friction, object.vx, object.mass = friction, vx or 0, mass or 1
  return object
end

local function addFloor(world, friction)
  local floor = { x = -9000, y = 0, width = 18000, height = 16, static = true, friction = friction }
  return world:add("floors", floor)
end

local function update(world, steps, dt, keep, boxes)
  for _ = 1, steps do
    for n, vx in pairs(keep or {}) do
      boxes[n].vx = vx
    end
    world:update(dt)
  end
end

-- Plays a row: boxes on a floor with friction `floor`, for `seconds`. Returns their ways.
local function run(row, rate)
  local world = physics.newWorld({ gravity = 900 })
  addFloor(world, row.floor)
  local boxes, from, ways = {}, {}, {}
  for n, box in ipairs(row) do
    boxes[n], from[n] =
      world:add("boxes", put(box.x, box.y, box.friction, box.vx, box.mass, box)), box.x
  end
  update(world, math.floor(row.seconds * rate + 0.5), 1 / rate)
  for n, box in ipairs(boxes) do
    ways[n] = box.x - from[n]
  end
  return ways
end

-- What comes of these cannot be worked out by hand any more: it is what very small steps lead to,
-- as far as a step is long.
-- How far the boxes of `build(random, seed)` are from there, at most, for each of the seeds.
local function distances(build, seconds, count, rate)
  local apart = {}
  for seed = 1, count do
    local row = build(newRandom(seed), seed)
    row.seconds = seconds
    local exact, ways = run(row, 1500), run(row, rate)
    apart[seed] = 0
    for n = 1, #row do
      apart[seed] = math.max(apart[seed], math.abs(ways[n] - exact[n]))
    end
  end
  table.sort(apart)
  return apart
end

-- Two to four of different mass, some of which bounce, pull or touch from the beginning.
local function runningInto(random)
  local row, x = { floor = 1 }, 0
  for n = 1, math.floor(random:between(2, 5)) do
    x = x + math.max(random:between(-40, 40), 0)
    local box = put(x, -16, random:between(0, 1) < 0.2 and 0 or random:between(0.05, 0.5))
    box.mass = random:between(0, 1) < 0.5 and 1 or random:between(0.3, 4)
    box.vx = random:between(0, 1) < 0.5 and random:between(-300, 300) or 0
    box.restitution = random:between(0, 1) < 0.3 and random:between(0, 1) or nil
    box.ax = random:between(0, 1) < 0.3 and random:between(-400, 400) or nil
    row[n], x = box, x + 16
  end
  return row
end

-- One stack that runs into another, or comes down on it.
local function stacks(random, seed)
  local row = { floor = random:between(0.1, 0.6) }
  local x, vx, high = random:between(-60, -16), random:between(60, 300), random:between(0, 30)
  for _, stack in ipairs({
    { 0, math.floor(random:between(1, 5)), 0, 0 },
    { x, math.floor(random:between(1, 3)), vx, seed % 4 == 0 and high or 0 },
  }) do
    for n = 1, stack[2] do
      local friction, mass = random:between(0.1, 0.7), random:between(0.5, 2.5)
      row[#row + 1] = put(stack[1], -16 * n - stack[4], friction, stack[3], mass)
    end
  end
  return row
end

-- A stack of which each has another speed; half of them get another one on top.
local function sliding(random, seed)
  local row = { floor = random:between(0.1, 0.6) }
  for n = 1, math.floor(random:between(2, 6)) do
    local friction, mass = random:between(0.1, 0.7), random:between(0.5, 2.5)
    row[n] = put(0, -16 * n, friction, random:between(-60, 240), mass, { width = 200 })
  end
  if seed % 2 == 0 then
    local y = -16 * #row - 16 - random:between(1, 30)
    row[#row + 1] = put(90, y, random:between(0.1, 0.7))
  end
  return row
end

small.rows("friction: goes where small steps lead it #slow {1}, at {5} Hz #slow", {
  -- what, build, seconds, seeds, rate, px for the half of them and for so many
  { "boxes that run into each other", runningInto, 0.5, 40, 30, 1e-9, 36, 0.9 },
  { "boxes that run into each other", runningInto, 0.5, 40, 60, 1e-9, 36, 0.25 },
  { "a stack that is run into", stacks, 0.5, 24, 60, 0.1, 22, 1.5 },
  { "a stack of different speeds", sliding, 0.4, 20, 60, 0.1, 20, 1.5 },
}, function(_, build, seconds, seeds, rate, usual, which, worst)
  local apart = distances(build, seconds, seeds, rate)
  local half, most = apart[seeds / 2], apart[which]
  assert.is_true(half < usual, ("half differ by up to %g px"):format(half))
  assert.is_true(most < worst, ("%d differ by up to %g px"):format(which, most))
end)
