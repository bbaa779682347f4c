-- Football for two, and a slider that turns back time. From there the game can be seen again, which
-- gives the same to the last bit, or be played on differently.

local boxes = require("boxes")
local input = require("input")
local look = require("look")
local physics = require("physics")

local rollback = {}

local STEP, MOST = 1 / 60, 900 -- s; steps that are kept, which is 15 s
local RUN_SPEED, RUN_UP, JUMP_SPEED = 280, 30, 700 -- px/s, px/s a step, px/s
local FLOOR, SLIDER_X, SLIDER_Y, SLIDER_WIDTH = 510, 40, 566, 620 -- px
local MODES = {
  play = "playing",
  rewound = "rewound: see it again, or just play on",
  again = "seen again",
}

-- records[i] is what was before step i, and the keys that were held in it. Mode "play" adds to
-- them, "again" follows them from step `now` on, "rewound" waits.
local world, players, ball, lift, records, state

local function kickOff()
  ball.x, ball.y, ball.vx, ball.vy = 468, 40, (state.score[1] - state.score[2]) * 20 + 70, 0
end

local function goal(sensor)
  state.score[sensor.number] = state.score[sensor.number] + 1
  kickOff()
end

function rollback.load()
  world = physics.newWorld({ gravity = 1600 })
  state = { now = 1, mode = "play", untilStep = 0, score = { 0, 0 }, same = 0, different = 0 }
  records = {}
  world:setBounds(0, -400, 960, FLOOR + 400)
  for i = 0, 1 do
    local net = { static = true, sensor = true, number = 2 - i, onBegin = goal }
    net.mask = { players = false, crates = false }
    boxes.add(world, "goals", "lime", i * 928, 398, 32, FLOOR - 398, net)
    boxes.add(world, "walls", "slate", i * 894, 386, 66, 12, { static = true })
    local shelf = { static = true, oneWay = "top" }
    boxes.add(world, "shelves", "teal", 190 + i * 460, 400, 120, 10, shelf)
    local crate = { mass = 0.4, friction = 0.4 }
    boxes.add(world, "crates", "yellow", 234 + i * 460, 368, 32, 32, crate)
  end
  lift = { kinematic = true, vy = -90, oneWay = "top" }
  boxes.add(world, "lifts", "blue", 430, 440, 100, 14, lift)
  ball = { mass = 0.25, restitution = 0.8, friction = 0.02 }
  boxes.add(world, "balls", "white", 0, 0, 24, 24, ball)
  kickOff()
  players = { { vx = 0, restitution = 0.3 }, { vx = 0, restitution = 0.3 } }
  boxes.add(world, "players", "orange", 240, 470, 30, 40, players[1])
  boxes.add(world, "players", "sky", 690, 470, 30, 40, players[2])
end

-- All that goes into a step beside the state: two directions, two jumps.
local function readKeys()
  return {
    input.isDown("d") and 1 or input.isDown("a") and -1 or 0,
    input.isDown("right") and 1 or input.isDown("left") and -1 or 0,
    input.isDown("w"),
    input.isDown("up"),
  }
end

local function record(keys)
  local old = #records == MOST and table.remove(records, 1) or {}
  records[#records + 1] = {
    keys = keys,
    hash = world:hash(), -- a number that stands for the whole state
    world = world:save(old.world), -- fills the oldest one anew, to make no garbage
    score = { state.score[1], state.score[2] }, -- what is the game's own, the game has to save
    x = ball.x + 12, -- for the picture
    y = ball.y + 12,
  }
  state.now = #records
end

local function goTo(step)
  state.now = math.max(1, math.min(#records, step))
  local there = records[state.now]
  world:restore(there.world) -- the same tables as then, and all in them that is the library's
  state.score = { there.score[1], there.score[2] }
  state.mode = "rewound"
end

local function step()
  if state.mode == "play" then
    record(readKeys())
  else
    local result = world:hash() == records[state.now].hash and "same" or "different"
    state[result] = state[result] + 1
  end
  local keys = records[state.now].keys
  for i, player in ipairs(players) do
    local missing = keys[i] * RUN_SPEED - player.vx
    player.vx = player.vx + math.max(-RUN_UP, math.min(RUN_UP, missing))
    if keys[i + 2] and player.touching.bottom then
      player.vy = -JUMP_SPEED
    end
  end
  if lift.y < 250 or lift.y > 440 then
    lift.vy = lift.y < 250 and 90 or -90
  end
  world:update(STEP)
  state.now = state.now + 1
  state.mode = state.now > #records and "play" or state.mode
end

function rollback.update(dt)
  local mouseX, mouseY = love.mouse.getPosition()
  local keys, turn = readKeys(), input.axis("q", "pageup", "e", "pagedown")
  if love.mouse.isDown(1) and math.abs(mouseY - SLIDER_Y) < 25 then
    goTo(math.floor((mouseX - SLIDER_X) / SLIDER_WIDTH * #records + 0.5))
  elseif turn ~= 0 then
    goTo(state.now + turn * 2)
  elseif state.mode == "rewound" and (keys[1] ~= 0 or keys[2] ~= 0 or keys[3] or keys[4]) then
    for i = #records, state.now, -1 do
      records[i] = nil -- from here on it goes another way
    end
    state.mode = "play"
  end
  state.untilStep = state.untilStep - dt
  while state.untilStep < -STEP / 2 do
    state.untilStep = state.untilStep + STEP
    if state.mode ~= "rewound" then
      step()
    end
  end
end

function rollback.keypressed(key)
  if key == "space" and state.mode == "rewound" then
    state.mode = "again"
  elseif key == "r" then
    rollback.load()
  end
end

local function drawTime()
  for i = math.max(1, state.now - 180), math.min(#records, state.now + 180), 4 do
    look.color(i < state.now and "white" or "yellow", 0.5 - math.abs(i - state.now) / 400)
    love.graphics.circle("fill", records[i].x, records[i].y, 3) -- the way of the ball
  end
  look.panel(16, SLIDER_Y - 38, 928, 66)
  look.color("slate")
  love.graphics.rectangle("fill", SLIDER_X, SLIDER_Y, SLIDER_WIDTH, 8, 4)
  look.color(state.mode == "play" and "lime" or "yellow")
  local length = SLIDER_WIDTH * math.min(1, state.now / math.max(1, #records))
  love.graphics.rectangle("fill", SLIDER_X, SLIDER_Y, length, 8, 4)
  love.graphics.circle("fill", SLIDER_X + length, SLIDER_Y + 4, 11)
  look.color("white")
  look.text(MODES[state.mode], SLIDER_X, SLIDER_Y - 30, 15)
  local seconds = math.min(0, state.now - #records) * STEP
  look.text(("%.1f s"):format(seconds), SLIDER_X, SLIDER_Y - 30, 15, SLIDER_WIDTH, "right")
  look.color("silver")
  look.text(("hash %.0f"):format(world:hash()), 700, SLIDER_Y - 28, 15)
  local text = "again: %d the same, %d not"
  look.text(text:format(state.same, state.different), 700, SLIDER_Y - 4, 15)
end

function rollback.draw()
  look.sky("night", "navy", "teal")
  look.color("dusk")
  love.graphics.rectangle("fill", 0, FLOOR, 960, 130)
  boxes.draw(world, { "goals", "walls", "shelves", "lifts", "crates", "balls", "players" })
  for _, player in ipairs(players) do
    look.eyes(player.x, player.y, 30, 40, player.x < ball.x and 1 or -1, 0)
  end
  look.color("white")
  look.text(("%d : %d"):format(state.score[1], state.score[2]), 0, 20, 44, 960, "center")
  drawTime()
  boxes.keys({
    { "a", "d", "w", "orange" },
    { "left", "right", "up", "blue" },
    { "q", "e", "mouse", "turn back time" },
    { "space", "see it again" },
  })
end

function rollback.report()
  local result = "rollback: x=%d y=%d records=%d same=%d different=%d left=%d right=%d mode=%s"
  local score, player = state.score, players[2]
  return result:format(
    player.x,
    player.y,
    #records,
    state.same,
    state.different,
    score[1],
    score[2],
    state.mode
  )
end

return rollback
