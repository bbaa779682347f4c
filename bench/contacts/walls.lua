--- A ball that cannot be pushed presses on a crate in a corner, and a fast heavy box flies with
--- balls against a wall.

local scenes = require("bench.contacts.scene")
local small = require("spec.support.small")

local put, tile, ball = small.put, small.tile, small.ball

local EDGE = 0.01 -- px

local function playCorner(scene)
  local random = scene.random
  scene:start({ 0, 900 })
  scene:add("walls", tile(-20, 200, 400, 20))
  scene:add("walls", tile(-20, -200, 20, 400))
  local isLow = random:chance(0.3)
  if isLow then
    scene:add("walls", tile(0, 140, 200, 10))
  end
  local size, radius = random:integer(8, 30), random:integer(5, 20)
  local crate = put(0, 200 - size, size, size)
  scene:add("crates", scene:vary(crate, "friction", { 0, 0.5 }, "mass", { 1, 0.2, 5 }))
  local angle, far = random:pick({ 0, 20, 45, 70, 90, random:between(0, 90) }), size + radius + 20
  angle = math.rad(isLow and random:pick({ 0, 10 }) or angle)
  local x = math.max(size / 2 + far * math.cos(angle), radius)
  local y = math.min(200 - size / 2 - far * math.sin(angle), 200 - radius)
  local pusher = ball(x, isLow and 200 - radius or y, radius, { pushable = false })
  scene:add("balls", scene:vary(pusher, "restitution", { 0, 0, 0.5 }))
  local speed = random:pick({ 60, 150, 400, 1500 })
  scene:play(2, function(n)
    local dx = crate.x + size / 2 - pusher.x - radius
    local dy = crate.y + size / 2 - pusher.y - radius
    local share = speed / math.max(1, math.sqrt(dx * dx + dy * dy))
    if n < 1.5 * scene.hz then
      pusher.vx = dx * share
      pusher.vy = (scene.gravity == 0 or dy > 0) and dy * share or pusher.vy
    end
  end, function()
    scene:measure("in each other, or in a wall, px", scene:deepest())
    local isAway = math.abs(crate.x) > 60 or math.abs(crate.y + size - 200) > 200
    scene:measure("the crate leaves the corner", isAway)
  end)
end

local function playFast(scene)
  local random = scene.random
  scene:start({ 0, 0, 900 })
  scene:add("walls", tile(300, -1e6, random:pick({ 1, 8, 40 }), 2e6))
  if scene.gravity > 0 then
    scene:add("walls", tile(-1e6, 120, 1000300, 20))
  end
  local size = random:integer(12, 50)
  local box = scene:vary(put(100, 120 - size, size, size), "vx", { 300, 1000, 3000, 8000, 20000 })
  scene:vary(box, "mass", { 10, 100, 1000, 1e5 }, "restitution", { 0, 0, 0.8 })
  local list = { scene:add("boxes", box) }
  for _ = 1, random:integer(1, 8) do
    local radius = random:integer(3, 9)
    local x = 300 - radius - random:pick({ 0, random:between(0, 60) })
    local one = ball(x, 120 - radius - random:between(0, size - radius), radius)
    scene:addFree("balls", scene:vary(one, "restitution", { 0, 0.5, 1 }), list)
  end
  scene:play(1, nil, function()
    for n, object in ipairs(list) do
      local row = n == 1 and "the box in the wall, px" or "a ball in the wall, px"
      scene:measure(row, object.x + object.width - 300)
      local isOver = scene.gravity > 0 and object.x < 290
      scene:measure("in the floor, px", isOver and object.y + object.height - 120)
    end
  end)
end

return {
  scenes.subject("corner", 600, playCorner, {
    { "in each other, or in a wall, px", 0.1 },
    { "the crate leaves the corner", 0 },
  }),
  scenes.subject("fast", 1500, playFast, {
    { "the box in the wall, px", EDGE },
    { "a ball in the wall, px", EDGE },
    { "in the floor, px", EDGE },
  }),
}
