--- Boxes side by side on rows, each at its own speed: do they go on at the speeds that are nearest
--- to these, whatever the order in which they were added?

local scenes = require("bench.contacts.scene")
local small = require("spec.support.small")

local CELL, TALL = 5, 20 -- px, of widths and gaps; height of a row
local SWEEPS, STILL = 20000, 1e-10 -- of the reference; px/s

-- Boxes on one or two of some rows, from left to right; the pairs of those that touch.
local function newBoxes(random)
  local rows, boxes, pairs = random:integer(2, 4), {}, {}
  local ends, last = { 0, 0, 0, 0 }, {}
  for n = 1, random:integer(4, 40) do
    local top = random:integer(1, rows)
    local bottom = math.min(rows, top + random:integer(0, 1))
    local x, width = math.max(ends[top], ends[bottom]), CELL * random:integer(1, 5)
    x = random:chance(0.2) and x + CELL or x
    local box = small.put(x, TALL * top, width, TALL * (bottom - top + 1) - 1)
    box.vx, box.mass = random:between(-100, 100), random:between(0.2, 5)
    for row = top, bottom do
      if last[row] and ends[row] == x and (row == top or last[row] ~= last[top]) then
        pairs[#pairs + 1] = { last[row], n }
      end
    end
    for row = top, bottom do
      ends[row], last[row] = x + width, n
    end
    boxes[n] = box
  end
  return boxes, pairs
end

-- The speeds with the least sum of mass times squared change, of all with which no two that touch
-- close. C. Hildreth, A quadratic programming procedure, 1957: one multiplier after the other.
local function nearestSpeeds(boxes, pairs)
  local speeds, pushes = {}, {}
  for n, box in ipairs(boxes) do
    speeds[n] = box.vx
  end
  for _ = 1, SWEEPS do
    local most = 0
    for n, pair in ipairs(pairs) do
      local low, high = pair[1], pair[2]
      local a, b, push = boxes[low].mass, boxes[high].mass, pushes[n] or 0
      local change = math.max(-push, (speeds[low] - speeds[high]) / (1 / a + 1 / b))
      speeds[low], speeds[high] = speeds[low] - change / a, speeds[high] + change / b
      pushes[n], most = push + change, math.max(most, math.abs(change))
    end
    if most < STILL then
      break
    end
  end
  return speeds
end

-- The speeds after a step, if the boxes are added to groups of these names in this order.
local function play(scene, boxes, order, groups)
  local added, speeds = {}, {}
  scene:again()
  for _, n in ipairs(order) do
    added[n] = scene:add(groups[n % #groups + 1], small.copy(boxes[n]))
  end
  scene:step()
  for n, box in ipairs(added) do
    speeds[n] = box.vx
  end
  return speeds
end

local function difference(list, other)
  local most = 0
  for n, value in ipairs(list) do
    most = math.max(most, math.abs(value - other[n]))
  end
  return most
end

local function playOrder(scene)
  local random, order = scene.random, {}
  scene:start(0)
  local boxes, pairs = newBoxes(random)
  for n in ipairs(boxes) do
    order[n] = n
  end
  local first = play(scene, boxes, order, { "a", "b", "c" })
  local second = play(scene, boxes, random:shuffled(order), { "c", "b", "a" })
  scene:measure("another order, another speed, px/s", difference(first, second))
  scene:measure("from the optimum, px/s", difference(first, nearestSpeeds(boxes, pairs)))
end

return {
  scenes.subject("orders", 1000, playOrder, {
    { "another order, another speed, px/s", 1e-3 },
    { "from the optimum, px/s", 1e-3 },
  }),
}
