--- Many boxes dropped into a container come to rest and do not sink into each other.

local newRandom = require("spec.support.random").new
local overlap = require "spec.support.overlap"
local scene = require "spec.support.scene"

local GRID = { shift = { 0 }, order = { "forward" }, broadphase = { "grid" }, push = { "both" } }
local SMALL = {
  shift = { 0, 0.1, 100000.3 },
  order = { "forward", "shuffled" },
  broadphase = { "grid", "pairs" },
  turn = { 0, 1, 2, 3 },
  push = { "both" },
}

--- `count` boxes of 10 to 20 px in rows over a container `width` px wide, whose floor is at y = 0.
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
    description[#description + 1] = {
      "boxes",
      {
        x = 25 * (i - row * columns) + random:between(0, 5),
        y = -25 * (row + 1),
        width = random:between(10, 20),
        height = random:between(10, 20),
        vx = random:between(-20, 20),
        friction = friction,
      },
    }
  end
  return description
end

--- Plays a pile and checks the overlap after every step.
local function playPile(run, seconds)
  local deepest = overlap.checker(run.all)
  for _ in run:steps(seconds) do
    local depth, a, b = deepest()
    if depth > 0.01 then
      run:check(false, "overlap of %.4g px, at (%.4g, %.4g)", depth, a.x, b.y)
    end
  end
end

--- The number of boxes that move.
local function countMovers(run)
  local movers, fastest = 0, 0
  for _, object in ipairs(run.all) do
    local speed = math.max(math.abs(object.vx or 0), math.abs(object.vy or 0))
    if speed ~= 0 then movers = movers + 1 end
    fastest = math.max(fastest, speed)
  end
  return movers, fastest
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

describe("a pile", function()
  it("(13) of 1000 boxes with friction is still within 20 s", function()
    scene.each(GRID, function(run)
      run:build(pile(1000, 800, 0.3))
      playPile(run, 20)
      local movers, fastest = countMovers(run)
      run:check(movers == 0, "%d boxes move, up to %.3g px/s", movers, fastest)
      checkInside(run, 800)
    end)
  end)

  it("(13) of 1000 boxes without friction does not overlap, nothing bobs up and down", function()
    scene.each(GRID, function(run)
      run:build(pile(1000, 800, nil))
      playPile(run, 20)
      checkInside(run, 800)
      run:near("mean height", meanHeight(run), 170, 30)
    end)
  end)

  it("(13) of 100 boxes is still within 20 s, turned and shifted", function()
    scene.each(SMALL, function(run)
      run:build(pile(100, 200, 0.3))
      playPile(run, 20)
      local movers, fastest = countMovers(run)
      run:check(movers == 0, "%d boxes move, up to %.3g px/s", movers, fastest)
      checkInside(run, 200)
    end)
  end)

  it("(13) of 100 boxes is still within 20 s, push first", function()
    scene.each({ push = { "first" }, shift = { 0, 0.3 }, order = { "forward" } }, function(run)
      run:build(pile(100, 200, 0.3))
      playPile(run, 20)
      local movers, fastest = countMovers(run)
      run:check(movers == 0, "%d boxes move, up to %.3g px/s", movers, fastest)
    end)
  end)
end)
