-- Football for two: the game that `rollback` winds back and forth, and that `online` plays over a
-- network. What happens in a step depends on the state and on the keys of that step, and on nothing
-- else: so the score is a field that the world saves (`ownFields`), not a variable.

local boxes = require("boxes")
local hero = require("hero")
local input = require("input")
local look = require("look")
local physics = require("physics")

---@class examples.Football
---@field [string] any
local football = {}
football.__index = football

local STEP = 1 / 60 -- s
local RUN_SPEED, JUMP_SPEED, LIFT_SPEED = 280, 700, 90 -- px/s
local FLOOR, LIFT_TOP, LIFT_BOTTOM = 510, 250, 440 -- px
local LEFT, RIGHT, JUMP = 1, 2, 4 -- the keys of a player are a sum of these

local function kickOff(game)
  local ball = game.ball
  ball.x, ball.y, ball.vy = 468, 40, 0
  ball.vx = (game.players[1].goals - game.players[2].goals) * 20 + 70
end

-- The left half for -1, the right half for 1. Returns the player of that half.
local function addHalf(game, way)
  local function add(group, color, x, y, width, height, fields)
    x = 480 + way * x - (way < 0 and width or 0)
    return boxes.add(game.world, group, color, x, y, width, height, fields)
  end
  local net = { static = true, sensor = true, mask = { players = false, crates = false } }
  function net.onBegin()
    local other = game.players[way < 0 and 2 or 1]
    other.goals = other.goals + 1
    kickOff(game)
  end
  add("goals", "lime", 448, 398, 32, FLOOR - 398, net)
  add("walls", "slate", 414, 386, 66, 12, { static = true })
  add("shelves", "teal", 170, 400, 120, 10, { static = true, oneWay = "top" })
  add("crates", "yellow", 214, 368, 32, 32, { mass = 0.4, friction = 0.4 })
  local player = { vx = 0, restitution = 0.3, lookX = -way, lookY = 0, goals = 0 }
  return add("players", way < 0 and "orange" or "sky", 210, 470, 30, 40, player)
end

--- Returns a new game: `world`, `ball`, `players`, and the functions below.
function football.new()
  local game = setmetatable({}, football)
  local world = physics.newWorld({ gravity = 1600, ownFields = { "goals" } })
  world:setBounds(0, -400, 960, FLOOR + 400)
  game.world, game.players = world, {}
  game.players[1], game.players[2] = addHalf(game, -1), addHalf(game, 1)
  game.lift = { kinematic = true, vy = -LIFT_SPEED, oneWay = "top" }
  boxes.add(world, "lifts", "blue", 430, LIFT_BOTTOM, 100, 14, game.lift)
  game.ball = { mass = 0.25, restitution = 0.8, friction = 0.02 }
  boxes.add(world, "balls", "white", 0, 0, 24, 24, game.ball)
  kickOff(game)
  return game
end

--- Returns the keys that are held, as a number that fits into a byte.
function football.readKeys(left, right, jump)
  return (input.isDown(left) and LEFT or 0)
    + (input.isDown(right) and RIGHT or 0)
    + (input.isDown(jump) and JUMP or 0)
end

local function steer(player, keys)
  local isLeft, isRight = keys % 2 >= LEFT, keys % 4 >= RIGHT
  hero.run(player, STEP, (isRight and 1 or 0) - (isLeft and 1 or 0), RUN_SPEED)
  if keys % 8 >= JUMP then
    hero.jump(player, JUMP_SPEED)
  end
end

--- Plays a step with the keys of both players.
function football:step(keys1, keys2)
  steer(self.players[1], keys1)
  steer(self.players[2], keys2)
  local lift = self.lift
  if lift.y < LIFT_TOP or lift.y > LIFT_BOTTOM then
    lift.vy = lift.y < LIFT_TOP and LIFT_SPEED or -LIFT_SPEED
  end
  self.world:update(STEP)
end

function football:draw()
  look.sky("night", "navy", "teal")
  boxes.ground(FLOOR)
  boxes.draw(self.world, "goals walls shelves lifts crates balls players", 0)
  look.color("white")
  local score = ("%d : %d"):format(self.players[1].goals, self.players[2].goals)
  look.text(score, 0, 90, 54, 960, "center")
end

return football
