-- Football for two: the game that `rollback` winds back and forth. What happens in a step depends
-- on the state and on the keys of that step, and on nothing else.

local boxes = require("boxes")
local hero = require("hero")
local input = require("input")
local look = require("look")
local physics = require("physics")

local football = {}

local STEP = 1 / 60 -- s
local RUN_SPEED, JUMP_SPEED, LIFT_SPEED = 280, 700, 90 -- px/s
local FLOOR, LIFT_TOP, LIFT_BOTTOM = 510, 250, 440 -- px

local players, lift, score ---@type physics.Object[], table, table

local function kickOff(ball)
  ball.x, ball.y, ball.vx, ball.vy = 468, 40, (score[1] - score[2]) * 20 + 70, 0
end

local function goal(net, ball)
  score[net.number] = score[net.number] + 1
  kickOff(ball)
end

-- The left half for -1, the right half for 1.
local function addHalf(world, way)
  local function add(group, color, x, y, width, height, fields)
    x = 480 + way * x - (way < 0 and width or 0)
    return boxes.add(world, group, color, x, y, width, height, fields)
  end
  local net = { static = true, sensor = true, number = way < 0 and 2 or 1, onBegin = goal }
  net.mask = { players = false, crates = false }
  add("goals", "lime", 448, 398, 32, FLOOR - 398, net)
  add("walls", "slate", 414, 386, 66, 12, { static = true })
  add("shelves", "teal", 170, 400, 120, 10, { static = true, oneWay = "top" })
  add("crates", "yellow", 214, 368, 32, 32, { mass = 0.4, friction = 0.4 })
  local player = { vx = 0, restitution = 0.3, lookX = -way, lookY = 0 }
  return add("players", way < 0 and "orange" or "sky", 210, 470, 30, 40, player)
end

function football.load()
  local world = physics.newWorld({ gravity = 1600 })
  score = { 0, 0 }
  world:setBounds(0, -400, 960, FLOOR + 400)
  players = { addHalf(world, -1), addHalf(world, 1) }
  lift = { kinematic = true, vy = -LIFT_SPEED, oneWay = "top" }
  boxes.add(world, "lifts", "blue", 430, LIFT_BOTTOM, 100, 14, lift)
  local ball = { mass = 0.25, restitution = 0.8, friction = 0.02 }
  kickOff(boxes.add(world, "balls", "white", 0, 0, 24, 24, ball))
  football.world, football.ball, football.players = world, ball, players
end

--- Returns all that goes into a step beside the state: two directions, two jumps.
function football.readKeys()
  return {
    input.axis("a", "a", "d", "d"),
    input.axis("left", "left", "right", "right"),
    input.isDown("w"),
    input.isDown("up"),
  }
end

function football.step(keys)
  for i, player in ipairs(players) do
    hero.run(player, STEP, keys[i], RUN_SPEED)
    if keys[i + 2] then
      hero.jump(player, JUMP_SPEED)
    end
  end
  if lift.y < LIFT_TOP or lift.y > LIFT_BOTTOM then
    lift.vy = lift.y < LIFT_TOP and LIFT_SPEED or -LIFT_SPEED
  end
  football.world:update(STEP)
end

--- Returns what is the game's own, which the world does not save.
function football.save()
  return { score[1], score[2] }
end

function football.restore(saved)
  score = { saved[1], saved[2] }
end

function football.draw()
  look.sky("night", "navy", "teal")
  boxes.ground(FLOOR)
  boxes.draw(football.world, "goals walls shelves lifts crates balls players", 0)
  look.color("white")
  look.text(("%d : %d"):format(score[1], score[2]), 0, 90, 54, 960, "center")
end

return football
