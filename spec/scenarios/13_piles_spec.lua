--- Many boxes dropped into a container come to rest and do not sink into each other.

local effort = require("spec.support.effort")
local motion = require("spec.support.motion")
local newRandom = require("spec.support.random").new
local overlap = require("spec.support.overlap")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local GRID = { shift = { 0 }, order = { "forward" }, broadphase = { "grid" }, push = { "both" } }
local SMALL = {
  shift = { 0, 100000.3 },
  order = { "shuffled" },
  broadphase = { "grid", "pairs" },
  turn = { 0, 1, 2, 3 },
  push = { "both" },
}

--- `count` boxes of 10 to 20 px in rows over a container `width` px wide, with its floor at y = 0.
---
---   |  +-+  +-+  +--+ |
---   |  +-+  +-+  +--+ |
---   +-----------------+
local function pile(count, width, friction)
  local random = newRandom(17)
  local tall = count * 30
  local description = {
    gravity = 800,
    { "walls", { x = -100, y = 0, width = width + 200, height = 100, static = true } },
    { "walls", { x = -100, y = -tall, width = 100, height = tall, static = true } },
    { "walls", { x = width, y = -tall, width = 100, height = tall, static = true } },
  }
  local columns = math.floor(width / 25)
  for i = 0, count - 1 do
    local row = math.floor(i / columns)
    local x, y = 25 * (i - row * columns) + random:between(0, 5), -25 * (row + 1)
    local box = { x = x, y = y, width = random:between(10, 20), height = random:between(10, 20) }
    box.vx, box.friction = random:between(-20, 20), friction
    description[#description + 1] = { "boxes", box }
  end
  return description
end

--- The number of boxes that move, and the largest speed.
local function countMovers(run)
  local movers, fastest = 0, 0
  for _, object in ipairs(run.all) do
    local speed = math.max(math.abs(object.vx or 0), math.abs(object.vy or 0))
    movers, fastest = movers + (speed ~= 0 and 1 or 0), math.max(fastest, speed)
  end
  return movers, fastest
end

--- Plays a pile and checks the overlap after every step; ends early once nothing has moved for 1 s.
local function playPile(run, seconds)
  local deepest, stillSince = overlap.checker(run.all), nil
  for time in run:steps(seconds) do
    local depth, a, b = deepest()
    if depth > 0.01 then
      run:check(false, "overlap of %.4g px, at (%.4g, %.4g)", depth, a.x, b.y)
    end
    stillSince = countMovers(run) == 0 and (stillSince or time) or nil
    if stillSince and time - stillSince >= 1 then
      break
    end
  end
end

local function checkInside(run, width)
  for _, object in ipairs(run.all) do
    local view = run.views[object]
    if not object.static then
      run:check(view.x >= -1e-6 and view.x + view.width <= width + 1e-6, "left the container")
      run:check(view.y + view.height <= 1e-6, "left the container below")
    end
  end
end

--- An object that does not fall stands on something.
local function checkSupported(run)
  for _, object in ipairs(run.all) do
    if not object.static and object.vy == 0 then
      run:check(object.touching.bottom, "hangs in the air at (%.6g, %.6g)", object.x, object.y)
    end
  end
end

--- How high the pile is: the mean distance of its boxes from the floor.
local function meanHeight(run)
  local sum, count = 0, 0
  for _, object in ipairs(run.all) do
    if not object.static then
      sum, count = sum - run.views[object].y, count + 1
    end
  end
  return sum / count
end

describe("friction: a pile", function()
  -- An interpreter plays a fifth of the 1000, in a container a fifth as wide.
  local COUNT, WIDTH = effort.share(1000), effort.isWhole and 800 or 160
  -- px, measured: with friction, and 20 s after the drop without any
  local HEIGHT, SLID_HEIGHT = effort.isWhole and 249 or 261, effort.isWhole and 184 or 198

  scene.it("(13) of 1000 boxes with friction is still within 20 s", GRID, function(run)
    run:build(pile(COUNT, WIDTH, 0.3))
    playPile(run, 20)
    local movers, fastest = countMovers(run)
    run:check(movers == 0, "%d boxes move, up to %.3g px/s", movers, fastest)
    checkInside(run, WIDTH)
    run:near("mean height", meanHeight(run), HEIGHT, 5)
  end)

  -- Sliding boxes go on sliding until they drop into a gap: the pile is lower than one with
  -- friction, and sinks for a long time.
  scene.it("(13) of 1000 boxes without friction slides together, apart #slow", GRID, function(run)
    run:build(pile(COUNT, WIDTH, nil))
    playPile(run, 20)
    checkInside(run, WIDTH)
    checkSupported(run)
    run:near("mean height", meanHeight(run), SLID_HEIGHT, 5)
  end)

  local FIRST = { push = { "first" }, shift = { 0, 0.3 }, order = { "forward" } }
  FIRST.broadphase = { "grid" }
  for name, levels in pairs({ ["turned and shifted"] = SMALL, ["push first"] = FIRST }) do
    scene.it("(13) of 100 boxes is still within 20 s, " .. name, levels, function(run)
      run:build(pile(100, 200, 0.3))
      playPile(run, 20)
      local movers, fastest = countMovers(run)
      run:check(movers == 0, "%d boxes move, up to %.3g px/s", movers, fastest)
      checkInside(run, 200)
    end)
  end
end)

-- Piles that are pressed ------------------------------------------------------------------------

local solid = scene.maker("tiles", { static = true })
local body = scene.maker("bodies")
local UPRIGHT = { shift = { 0, 1 / 3, -1000.1 }, rate = { 60, 30, 144 }, order = variants.ORDERS }

-- Fails unless nothing moves by a bit for half a second.
-- Nothing goes further than half a pixel in half a second: crates that are squeezed sideways part
-- by 0.03 px in a step, less than a player sees, until the sum of their overlaps has stayed.
local function expectRest(run)
  local before = {}
  for i, object in ipairs(run.all) do
    before[i] = { object.x, object.y }
  end
  for _ in run:steps(0.5) do
    for i, object in ipairs(run.all) do
      local x, y = before[i][1], before[i][2]
      local text = "an object at rest went from %.17g, %.17g to %.17g, %.17g"
      local far = math.max(math.abs(object.x - x), math.abs(object.y - y))
      run:check(far <= 0.5, text, x, y, object.x, object.y)
    end
  end
end

--   |->|####|
--   |->|####|
--   +-------+
-- Hundreds of impacts in each step, for ever.
describe("kinematic: a heap that it squeezes", function()
  for _, row in ipairs({
    -- crates, their sizes, what is left of 200 px, restitution, friction
    { 20, "equal", 40, 0, 0.3 },
    { 20, "different", 40, 0, 0.3 },
    { 20, "different", 30, 0, 0 },
    { 20, "different", 40, 0.5, 0.3 },
    { 40, "different", 80, 0, 0.3 },
    { 5, "different", 12, 0, 0.3 },
  }) do
    local count, sizes, left, restitution, friction = row[1], row[2], row[3], row[4], row[5]
    local title = "of %d crates of %s sizes in %d px, restitution %g, friction %g, rests"
    scene.it(title:format(count, sizes, left, restitution, friction), UPRIGHT, function(run)
      local random, rows = newRandom(12), 5
      local description = {
        solid("floor", -300, 300, 600, 16),
        solid("ceiling", -300, 204, 600, 16),
        solid("wall", 200, 220, 16, 80),
        scene.maker("pistons", { kinematic = true })("piston", -100, 220, 100, 80),
      }
      for i = 0, count - 1 do
        local size = sizes == "equal" and 16 or random:between(10, 16)
        local column = math.floor(i / rows)
        local x, y = 4 + 17 * column, 300 - 16 * (i - rows * column) - size
        local fields = { restitution = restitution, friction = friction }
        description[5 + i] = body("crate" .. i, x, y, size, size, fields)
      end
      local named = run:build(description)
      local watch = motion.new(run.world, run.all)
      named.piston.vx = 200 - left
      scene.watch(run, watch, 1)
      named.piston.vx = 0
      scene.watch(run, watch, count < 40 and restitution == 0 and 2.5 or 3)
      expectRest(run)
    end)
  end
end)
