--- Proves that a world can be played for as long as one likes, and far away: memory stays, no
--- object is lost, and a pile comes to rest ten million px from the origin. A short part:
--- `make soak` plays ten million steps.

local busy = require("spec.support.busy")
local effort = require("spec.support.effort")
local overlap = require("spec.support.overlap")
local physics = require("physics")
local small = require("spec.support.small")

local long = effort.isFirst and it or pending

long("world:update: a busy scene loses no object and keeps its memory", function()
  local world, length = busy.new(), effort.isWhole and 4000 or 500
  local n = 0
  local function play()
    for _ = 1, length do
      n = n + 1
      busy.step(world, n)
    end
    assert.is_nil(busy.complaint(world))
    return busy.memory()
  end
  play()
  local before = play()
  local after = play()
  assert.is_true(after < before * 1.05, ("%.0f kB became %.0f kB"):format(before, after))
end)

small.rows("y and vy: falling leaves nothing, {1} #slow", { "grid", "pairs" }, function(broadphase)
  local world = physics.newWorld({ gravity = 1000, broadphase = broadphase })
  for i = 1, 40 do
    local box = { x = 30 * i, y = 0, width = 16, height = 16, vx = 40 * (i % 7 - 3) }
    box.maxSpeedY = 300 * i
    world:add("boxes", box)
  end
  local function fall(steps)
    small.run(world, steps)
    return busy.memory()
  end
  fall(effort.share(2000, 1500))
  local before = fall(600)
  local after = fall(effort.share(2000, 1500))
  assert.is_true(after < before * 1.05, ("%.0f kB became %.0f kB"):format(before, after))
  assert.is_true(world.objects.boxes[40].y > 90000)
  assert.equal(40, world.stats.objects)
end)

-- Sizes that no binary fraction hits.
local function pile(shiftX, shiftY)
  local world = physics.newWorld({ gravity = 800 })
  local floor = world:add("floor", small.tile(shiftX - 200, shiftY + 200, 600, 20))
  local boxes = {}
  for i = 0, 19 do
    local x, y = shiftX + 10.1 * (i % 5) * 2 + i / 7, shiftY + 150 - 23.3 * math.floor(i / 5)
    local fields = { friction = 0.5, restitution = i % 3 == 0 and 0.4 or 0 }
    boxes[i + 1] = world:add("boxes", small.put(x, y, 20 / 3 + i / 3, 10.1 + i / 9, fields))
  end
  boxes[21] = floor
  return world, boxes
end

describe("x and y: ten million pixels from the origin", function()
  -- Neighbouring numbers are 1.9e-9 px apart there. Nothing overlaps by more than the 1e-6 px that
  -- are promised everywhere; paths differ from those at the origin by rounding alone.
  local PLACES = { { 1e7, 1e7 }, { -1e7, 1e7 }, { 1e7, -1e7 }, { -1e7, -1e7 } }
  small.rows("a pile comes to rest as anywhere, at {1}, {2}", PLACES, function(x, y)
    local world, boxes = pile(x, y)
    local deepest = overlap.checker(boxes)
    for _ = 1, 300 do
      world:update(1 / 60)
      assert.is_true(deepest() <= 1e-6, ("overlap %.3g px"):format(deepest()))
    end
    for i = 1, 20 do
      assert.same({ 0, 0 }, { boxes[i].vx, boxes[i].vy }, "box " .. i)
      assert.truthy(boxes[i].touching.bottom, "box " .. i)
      local below = boxes[i].touching.bottom
      assert.is_true(math.abs(boxes[i].y + boxes[i].height - below.y) <= 1e-6)
    end
  end)
end)
