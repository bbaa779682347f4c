--- A ball that cannot be pushed presses on a crate in a corner, and a fast heavy box flies with
--- balls against a wall.

local scenes = require("bench.contacts.scene")
local small = require("spec.support.small")

local put, tile, ball = small.put, small.tile, small.ball

local EDGE = 0.01 -- px

local function playCorner(scene)
  local random = scene.random
  local hz, gravity = random:pick(scenes.RATES), random:pick({ 0, 900 })
  scene:start(hz, gravity)
  scene:add("walls", tile(-20, 200, 400, 20))
  scene:add("walls", tile(-20, -200, 20, 400))
  local isLow = random:chance(0.3)
  if isLow then
    scene:add("walls", tile(0, 140, 200, 10))
  end
  local size = random:integer(8, 30)
  local crate = put(0, 200 - size, size, size, { friction = random:pick({ 0, 0.5 }) })
  crate.mass = random:pick({ 1, 0.2, 5 })
  scene:add("crates", crate)
  local radius = random:integer(5, 20)
  local angle = random:pick({ 0, 20, 45, 70, 90, random:between(0, 90) })
  local far = size + radius + 20
  angle = math.rad(isLow and random:pick({ 0, 10 }) or angle)
  local x = math.max(size / 2 + far * math.cos(angle), radius)
  local y = math.min(200 - size / 2 - far * math.sin(angle), 200 - radius)
  local pusher = ball(x, isLow and 200 - radius or y, radius, { pushable = false })
  pusher.restitution = random:pick({ 0, 0, 0.5 })
  scene:add("balls", pusher)
  local speed = random:pick({ 60, 150, 400, 1500 })
  for n = 1, 2 * hz do
    local dx = crate.x + size / 2 - pusher.x - radius
    local dy = crate.y + size / 2 - pusher.y - radius
    local share = speed / math.max(1, math.sqrt(dx * dx + dy * dy))
    if n < 1.5 * hz then
      pusher.vx = dx * share
      pusher.vy = (gravity == 0 or dy > 0) and dy * share or pusher.vy
    end
    scene:step()
    scene:measure("in each other, or in a wall", scene:deepest())
    scene:measure(
      "the crate leaves the corner",
      math.abs(crate.x) > 60 or math.abs(crate.y + size - 200) > 200
    )
  end
end

local function addBalls(scene, size, list)
  local random = scene.random
  for _ = 1, random:integer(1, 8) do
    local radius = random:integer(3, 9)
    local x = 300 - radius - random:pick({ 0, random:between(0, 60) })
    local y = 120 - radius - random:between(0, size - radius)
    local one = ball(x, y, radius, { restitution = random:pick({ 0, 0.5, 1 }) })
    if scene:isFree(one, list) then
      list[#list + 1] = scene:add("balls", one)
    end
  end
end

local function playFast(scene)
  local random = scene.random
  local hz, gravity = random:pick(scenes.RATES), random:pick({ 0, 0, 900 })
  scene:start(hz, gravity)
  scene:add("walls", tile(300, -1e6, random:pick({ 1, 8, 40 }), 2e6))
  if gravity > 0 then
    scene:add("walls", tile(-1e6, 120, 1000300, 20))
  end
  local size = random:integer(12, 50)
  local box = put(100, 120 - size, size, size)
  box.vx = random:pick({ 300, 1000, 3000, 8000, 20000 })
  box.mass = random:pick({ 10, 100, 1000, 1e5 })
  box.restitution = random:pick({ 0, 0, 0.8 })
  local list = { scene:add("boxes", box) }
  addBalls(scene, size, list)
  for _ = 1, hz do
    scene:step()
    for n, object in ipairs(list) do
      scene:measure(
        n == 1 and "the box in the wall" or "a ball in the wall",
        object.x + object.width - 300
      )
      local isOver = gravity > 0 and object.x < 290
      scene:measure("in the floor", isOver and object.y + object.height - 120)
    end
  end
end

return {
  {
    name = "corner",
    scenes = 600,
    salt = { 5, 2 },
    rows = { { "in each other, or in a wall", 0.1, "px" }, { "the crate leaves the corner", 0 } },
    play = playCorner,
  },
  {
    name = "fast",
    scenes = 1500,
    salt = { 29, 8 },
    rows = {
      { "the box in the wall", EDGE, "px" },
      { "a ball in the wall", EDGE, "px" },
      { "in the floor", EDGE, "px" },
    },
    play = playFast,
  },
}
