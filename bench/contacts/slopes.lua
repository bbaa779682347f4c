--- A ball that lands or lies on a slope that moves, beside the same on one that stands.

local overlap = require("spec.support.overlap")
local small = require("spec.support.small")

local GRAVITY, LENGTH = 800, 1200
local WAIT = 0.3 -- s, until a slope on which a ball lies drives

-- Returns the places of the ball on the slope, in each frame, and whether it touches it.
local function run(scene, choice, vx, vy)
  scene:start(choice.hz, GRAVITY)
  local isMoving = vx ~= nil
  local slope = small.put(0, 0, LENGTH, choice.height, { slope = choice.slope })
  slope.kinematic, slope.static = isMoving or nil, not isMoving or nil
  scene:add("ramps", slope)
  local length = math.sqrt(LENGTH * LENGTH + choice.height * choice.height)
  local ax, ay = LENGTH / length, choice.height / length
  local isLeft, radius, at = choice.slope == "left", choice.radius, choice.at
  local x, y = at + ay * radius, at * choice.height / LENGTH - ax * radius - choice.drop
  local fields = { restitution = choice.restitution, friction = choice.friction }
  local ball = small.ball(isLeft and x or LENGTH - x, y, radius, fields)
  ball.vx = isLeft and choice.vx or -choice.vx
  ball.vy = choice.lies and choice.vx * choice.height / LENGTH or 0
  if not choice.lies then
    ball.vx, ball.vy = ball.vx + (vx or 0), ball.vy + (vy or 0)
  end
  scene:add("balls", ball)
  local places = {}
  for n = 1, 1.2 * choice.hz do
    if isMoving and (not choice.lies or n > WAIT * choice.hz) then
      slope.vx, slope.vy = vx, vy
    end
    scene:step()
    scene:measure("in the slope", isMoving and overlap.depth(ball, slope))
    places[n] = { ball.x - slope.x, ball.y - slope.y, ball.touching.bottom }
  end
  return places
end

local function play(scene)
  local random = scene.random
  local choice = { hz = random:pick({ 30, 60, 144 }), height = random:pick({ 120, 300, 600, 900 }) }
  choice.slope = random:pick({ "left", "right" })
  choice.radius = random:between(5, 14)
  local restitution = random:pick({ 0, 0, 0.3, 0.6 })
  choice.restitution = restitution > 0 and restitution or nil
  choice.lies = random:chance(0.5)
  local vx = random:pick({ 0, 0, random:integer(-120, 120) })
  local vy = random:pick({ 0, random:integer(-120, 120) })
  choice.at = random:between(300, 600)
  choice.drop = choice.lies and 0 or random:between(2, 60)
  choice.vx = choice.lies and random:pick({ 0, 50, -50 }) or random:between(-80, 80)
  random:unit()
  choice.friction = random:pick({ false, 0, 0.5 }) or nil
  local still, moving = run(scene, choice), run(scene, choice, vx, vy)
  local row = (choice.lies and "lying" or "landing") .. (restitution > 0 and ", bouncing" or "")
  for n, place in ipairs(still) do
    local other = moving[n]
    scene:measure(
      row .. ", elsewhere",
      math.max(math.abs(place[1] - other[1]), math.abs(place[2] - other[2]))
    )
    scene:measure("in the air", n >= #still - 10 and place[3] and not other[3])
  end
end

return {
  {
    name = "slopes",
    scenes = 1500,
    salt = { 7, 3 },
    rows = {
      { "lying, elsewhere", 0.1, "px" },
      { "lying, bouncing, elsewhere", 0.1, "px" },
      { "landing, elsewhere", 0.1, "px" },
      { "landing, bouncing, elsewhere", 0.1, "px" },
      { "in the air", 0 },
      { "in the slope", 1e-4, "px" },
    },
    play = play,
  },
}
