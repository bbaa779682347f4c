-- Football over a network. Both play at once, whatever the ping: a key that comes late turns back
-- time, unseen. Here are both screens, with a bad line between them.
--
-- For a game on two machines: `love examples online host`, and on the other one
-- `love examples online join ADDRESS`. kit/netplay.lua is the rollback, kit/line.lua the network,
-- football.lua the game.

local football = require("football")
local line = require("kit.line")
local look = require("look")
local netplay = require("kit.netplay")
local physics = require("physics")
local view = require("view")

local online = {
  keys = {
    { "a", "d", "w", "orange" },
    { "left", "right", "up", "blue" },
    { "b", "another line" },
    { "c", "cut the line" },
  },
}

local PORT = 22122
local VERSION = "football 1, physics " .. physics._VERSION
local LINES = { { 0.15, 0.1 }, { 0, 0 }, { 0.06, 0.02 } } -- s of ping, share of loss
local NAMES, COLORS = { "orange", "blue" }, { "orange", "sky" }
local BOTH_KEYS = online.keys
---@type any
local OWN_KEYS = { { "left", "right", "up", "play" }, { "b", "make the line worse" } }

-- sides: of this machine: one or two of { player =, game =, session =, line = }
local sides, state ---@type table, table

local function addSide(player, open, ...)
  local side = { player = player, game = football.new() }
  side.line = open(...)
  side.session = netplay.new({
    game = side.game,
    player = player,
    version = VERSION,
    send = function(text, isReliable)
      side.line:send(text, isReliable)
    end,
  })
  side.on = {
    connect = function()
      if player == 2 then
        side.session:join()
      end
    end,
    disconnect = function()
      side.session:leave()
    end,
    receive = function(text)
      side.session:receive(text)
    end,
  }
  sides[#sides + 1] = side
end

local function setLine(number)
  state.line = number
  for _, side in ipairs(sides) do
    side.line.ping, side.line.loss = LINES[number][1], LINES[number][2]
  end
end

local function receiveBy(player)
  return function(text)
    if not state.isCut then
      sides[player].session:receive(text)
    end
  end
end

local function withPort(address)
  return address:find(":") and address or address .. ":" .. PORT
end

--- `role`: "host", "join", or none for both sides in one picture. `address`, with a port or
--- without: for "join" that of the other machine (127.0.0.1: this one), for "host" that of this one
--- (*: all).
function online.load(role, address)
  sides, state = {}, { isCut = false }
  online.sides = sides
  online.keys, online.world = OWN_KEYS, nil
  if role == "host" then
    addSide(1, line.host, withPort(address or "*"))
  elseif role == "join" then
    addSide(2, line.join, withPort(address or "127.0.0.1"))
  else
    online.keys = BOTH_KEYS
    addSide(1, line.to, receiveBy(2))
    addSide(2, line.to, receiveBy(1))
    sides[2].session:join()
  end
  setLine(role and 2 or 1)
  if role then
    online.world = sides[1].game.world
  end
end

--- "Start again" makes no sense for one player alone.
function online.restart()
  if #sides == 2 then
    online.load()
  end
end

local function readKeys(player)
  local isBoth = #sides == 2
  if isBoth and player == 1 then
    return football.readKeys("a", "d", "w")
  end
  local keys = football.readKeys("left", "right", "up")
  return isBoth and keys or math.max(keys, football.readKeys("a", "d", "w"))
end

function online.update(dt)
  for _, side in ipairs(sides) do
    side.line:update(dt, side.on)
    side.session:update(dt, readKeys(side.player))
  end
end

function online.keypressed(key, isRepeat)
  if isRepeat then
    return
  elseif key == "b" then
    setLine(state.line % #LINES + 1)
  elseif key == "c" and #sides == 2 then
    state.isCut = not state.isCut
    for _, side in ipairs(sides) do
      if state.isCut then
        side.session:leave()
      elseif side.player == 2 then
        side.session:join()
      end
    end
  end
end

--- The other side is told, and joins again when this one is back.
function online.leave()
  if #sides == 1 then
    sides[1].line:close()
  end
end

local function stateOf(side)
  local session, stats = side.session, side.session.stats
  if stats.desync or stats.problem then
    return stats.desync or stats.problem
  elseif session.player == 2 and not session.isPlaying then
    return "waits for an answer"
  elseif session.isAlone then
    return "plays alone: the other side is not there"
  end
  return ("%d times compared, and equal to the bit"):format(stats.equal)
end

-- Rows of numbers, one below the other, so many to a column.
local function drawNumbers(side, x, y, height, most)
  local stats = side.session.stats
  local rows = {
    { "ping", stats.ping and ("%.0f ms"):format(stats.ping * 1000) or "-" },
    { "rolled back", ("%.0f frames a second, at most %d"):format(stats.back, stats.mostBack) },
    { "sent", ("%.1f kB a second"):format(stats.bytes / 1000) },
    { "longest wait", ("%.0f ms"):format(stats.longestWait * 1000) },
    { "the games", stateOf(side) },
  }
  for i, row in ipairs(rows) do
    local left, top = x + math.floor((i - 1) / most) * 440, y + (i - 1) % most * height
    look.color("silver")
    look.text(row[1], left, top, 15)
    look.color("white")
    look.text(row[2], left + 100, top, 15)
  end
end

local function describeLine()
  local ping, loss = LINES[state.line][1] * 1000, LINES[state.line][2] * 100
  return ("%.0f ms of ping and %.0f %% of loss"):format(ping, loss)
end

local function drawGame(game)
  game:draw()
end

local function drawBoth()
  look.sky("night", "dusk")
  look.color("white")
  look.text("one game, two screens", 0, 22, 26, 960, "center")
  look.color(state.isCut and "red" or "silver")
  local words = state.isCut and "the line is cut" or "between them: " .. describeLine()
  look.text(words, 0, 58, 17, 960, "center")
  for i, side in ipairs(sides) do
    local x = (i - 1) * 482
    look.color(COLORS[side.player])
    look.text("the screen of " .. NAMES[side.player], x + 16, 92, 17)
    love.graphics.push()
    love.graphics.translate(x, 118)
    love.graphics.scale(478 / 960)
    view.clip(0, 0, 960, 590, drawGame, side.game)
    love.graphics.pop()
    drawNumbers(side, x + 16, 432, 27, 5)
  end
end

local function drawOwn(side)
  side.game:draw()
  look.color(COLORS[side.player])
  local words = "you are %s; added to the line: %s"
  look.text(words:format(NAMES[side.player], describeLine()), 24, 14, 15)
  drawNumbers(side, 24, 524, 25, 3)
end

function online.draw()
  if #sides == 2 then
    drawBoth()
  else
    drawOwn(sides[1])
  end
end

function online.report()
  local side = sides[#sides] ---@type table
  local stats, player = side.session.stats, side.game.players[side.player]
  local result = "online: x=%d y=%d equal=%d back=%d desync=%s"
  local desync = (stats.desync or "none"):gsub(" ", "_")
  return result:format(player.x, player.y, stats.equal, stats.mostBack, desync)
end

return online
