-- Football for two, and a slider that turns back time. From there you can watch the game again,
-- the same to the last bit, or play on differently. Network games do this when a key arrives late.

local football = require("football")
local input = require("input")
local look = require("look")

local rollback = {
  keys = {
    { "a", "d", "w", "orange" },
    { "left", "right", "up", "blue" },
    { "q", "e", "mouse", "turn back time" },
    { "space", "see it again" },
  },
}

local STEP, MOST = 1 / 60, 900 -- s; steps that are kept, which is 15 s
local SLIDER_X, SLIDER_Y, SLIDER_WIDTH = 40, 46, 620 -- px
local MODES = {
  play = "playing: turn back time with q, or by the slider",
  rewound = "back in time: space plays it again, any other key plays on",
  again = "played again, from the same state with the same keys",
}

-- records[i] is what was before step i, and the keys that were held in it. Mode "play" adds to
-- them, "again" follows them from step `now` on, "rewound" waits.
local game, world, records, state ---@type any, physics.World, table, table

function rollback.load()
  game = football.new()
  world, records = game.world, {}
  rollback.world, state = world, { now = 1, mode = "play", untilStep = 0, same = 0, different = 0 }
end

local function record()
  local old = #records == MOST and table.remove(records, 1) or {}
  records[#records + 1] = {
    keys1 = football.readKeys("a", "d", "w"),
    keys2 = football.readKeys("left", "right", "up"),
    hash = world:hash(), -- a number that stands for the whole state
    world = world:save(old.world), -- fills the oldest one anew, to make no garbage
    x = game.ball.x + 12, -- for the picture
    y = game.ball.y + 12,
  }
  state.now = #records
end

local function goTo(step)
  state.now = math.max(1, math.min(#records, step))
  world:restore(records[state.now].world) -- the same tables as then
  state.mode = "rewound"
end

local function step()
  if state.mode == "play" then
    record()
  else
    local result = world:hash() == records[state.now].hash and "same" or "different"
    state[result] = state[result] + 1
  end
  game:step(records[state.now].keys1, records[state.now].keys2)
  state.now = state.now + 1
  state.mode = state.now > #records and "play" or state.mode
end

function rollback.update(dt)
  local mouseX, mouseY, isHeld = input.mouse()
  local turn = input.axis("q", "q", "e", "e")
  if isHeld and math.abs(mouseY - SLIDER_Y) < 25 and mouseX < 700 then
    goTo(math.floor((mouseX - SLIDER_X) / SLIDER_WIDTH * #records + 0.5))
  elseif turn ~= 0 then
    goTo(state.now + turn * 2)
  elseif state.mode == "rewound" and input.isDown("a", "d", "w", "left", "right", "up") then
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
  end
end

-- The way of the ball: 3 s of the past, and as much of the future that is to be changed.
local function drawWay()
  for i = math.max(1, state.now - 180), math.min(#records, state.now + 180), 4 do
    look.color(i < state.now and "white" or "yellow", 0.9 - math.abs(i - state.now) / 240)
    love.graphics.circle("fill", records[i].x, records[i].y, i < state.now and 3 or 5)
  end
  look.color("white")
  look.text("its way so far", 40, 84, 15)
  love.graphics.circle("fill", 28, 93, 3)
  if state.now <= #records then
    look.color("yellow")
    look.text("its way the first time", 190, 84, 15)
    love.graphics.circle("fill", 176, 93, 5)
  end
end

-- What the numbers of the steps that were played again say.
local function comparison()
  local count = state.same + state.different
  if count == 0 then
    return "nothing was played again"
  end
  return ("%d steps again: %d differ"):format(count, state.different)
end

function rollback.draw()
  game:draw()
  drawWay()
  look.panel(16, SLIDER_Y - 38, 928, 66)
  local share = math.min(1, state.now / math.max(1, #records))
  look.slider(SLIDER_X, SLIDER_Y, SLIDER_WIDTH, share, state.mode == "play" and "lime" or "yellow")
  local seconds = math.min(0, state.now - #records) * STEP
  look.color("white")
  look.text(MODES[state.mode], SLIDER_X, SLIDER_Y - 30, 15)
  look.text(("%.1f s"):format(seconds), SLIDER_X, SLIDER_Y - 30, 15, SLIDER_WIDTH, "right")
  look.color("silver")
  look.text(("hash %.0f"):format(world:hash()), 700, SLIDER_Y - 28, 15)
  look.text(comparison(), 700, SLIDER_Y - 4, 15)
end

function rollback.report()
  local result, blue = "rollback: x=%d y=%d records=%d same=%d different=%d", game.players[2]
  return result:format(blue.x, blue.y, #records, state.same, state.different)
end

return rollback
