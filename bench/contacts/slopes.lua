--- A ball that lands or lies on a slope that moves, beside the same on one that stands.

local overlap = require("spec.support.overlap")
local scenes = require("bench.contacts.scene")
local small = require("spec.support.small")

local LENGTH = 1200 -- px
local WAIT = 0.3 -- s, until a slope on which a ball lies drives

-- Returns the places of the ball on the slope, in each frame, and whether it touches it.
local function run(scene, choice, isMoving)
  scene:again()
  local vx, vy = isMoving and choice.vx or 0, isMoving and choice.vy or 0
  local slope = small.put(0, 0, LENGTH, choice.height, { slope = choice.slope })
  slope.kinematic, slope.static = isMoving or nil, not isMoving or nil
  scene:add("ramps", slope)
  local length = math.sqrt(LENGTH * LENGTH + choice.height * choice.height)
  local ax, ay = LENGTH / length, choice.height / length
  local isLeft, lies, radius = choice.slope == "left", choice.drop == 0, choice.radius
  local x = choice.at + ay * radius
  local y = choice.at * ay / ax - ax * radius - choice.drop
  local ball = small.ball(isLeft and x or LENGTH - x, y, radius, choice.fields)
  ball.vx = (isLeft and choice.along or -choice.along) + (lies and 0 or vx)
  ball.vy = lies and choice.along * ay / ax or vy
  scene:add("balls", ball)
  local places = {}
  scene:play(1.2, function(n)
    if isMoving and (not lies or n > WAIT * scene.hz) then
      slope.vx, slope.vy = vx, vy
    end
  end, function(n)
    scene:measure("in the slope, px", isMoving and overlap.depth(ball, slope))
    local place = { x = ball.x - slope.x, y = ball.y - slope.y, isOn = ball.touching.bottom }
    places[n] = place
  end)
  return places
end

local function play(scene)
  local random = scene.random
  scene:start(800)
  local choice = { radius = random:between(5, 14), at = random:between(300, 600) }
  scene:vary(choice, "height", { 120, 300, 600, 900 }, "slope", { "left", "right" })
  choice.fields = scene:vary(
    {},
    "restitution",
    { false, false, 0.3, 0.6 },
    "friction",
    { false, 0, 0.5 }
  )
  choice.drop = random:pick({ 0, random:between(2, 60) })
  local isLying = choice.drop == 0
  choice.along = isLying and random:pick({ 0, 50, -50 }) or random:between(-80, 80)
  choice.vx = random:pick({ 0, 0, random:integer(-120, 120) })
  choice.vy = random:pick({ 0, random:integer(-120, 120) })
  local still, moving = run(scene, choice, false), run(scene, choice, true)
  local row = isLying and "lying" or "landing"
  row = row .. (choice.fields.restitution and ", bouncing" or "") .. ", elsewhere, px"
  scene:measure(row, scene:moved(still, moving))
  for n = #still - 10, #still do
    scene:measure("in the air", still[n].isOn and not moving[n].isOn)
  end
end

return {
  scenes.subject("slopes", 1500, play, {
    { "lying, elsewhere, px", 0.1 },
    { "lying, bouncing, elsewhere, px", 0.1 },
    { "landing, elsewhere, px", 0.1 },
    { "landing, bouncing, elsewhere, px", 0.1 },
    { "in the air", 0 },
    { "in the slope, px", 1e-4 },
  }),
}
