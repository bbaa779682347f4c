-- One of two processes that play the example Online with each other (scripts/online.sh):
--
--   love scripts/online host|join PORT SECONDS PING LOSS [break]
--
-- plays at the usual pace with keys at random, PING in ms and LOSS in % added by the sender, over
-- 127.0.0.1. Prints each hash that was compared, "hash STEP MINE THEIRS", and figures at the end.
-- With `break` it changes its own game after three seconds, as a game would that is not
-- deterministic.

local root = love.filesystem.getSource() .. "/../.."
package.path = ("%s/?.lua;%s/examples/?.lua;%s"):format(root, root, package.path)

local input = require("input")
local online = require("online")

local FRAME = 1 / 60 -- s
local KEYS = { "left", "right", "up" }

local seconds, random, session, isToBreak ---@type number, any, table, boolean
local left, frames, longestSleep = 0, 0, 0 -- s, frames, s
local mostBytes = 0 -- bytes in a second
-- Steps of the longest rollback, and s of processor time for each step of the fastest one: so much
-- it costs when nothing else disturbs.
local furthest, cost = 0, math.huge

local function printHash(step, mine, theirs)
  print(("hash %d %.17g %.17g"):format(step, mine, theirs))
end

function love.load(arguments)
  local role, port, time, ping, loss =
    arguments[1], arguments[2], arguments[3], arguments[4], arguments[5]
  local seed = tonumber(port) * 2 + (role == "host" and 0 or 1)
  random, seconds, isToBreak =
    love.math.newRandomGenerator(seed), tonumber(time), arguments[6] ~= nil
  math.randomseed(seed)
  io.stdout:setvbuf("line") -- also what is killed has said something
  input.isReal = false
  online.load(role, "127.0.0.1:" .. port)
  local side = online.sides[1]
  side.line.ping, side.line.loss = tonumber(ping) / 1000, tonumber(loss) / 100
  session = side.session
  session.onHash = printHash
end

-- Holds each key for some frames.
local function press()
  local key = KEYS[random:random(#KEYS)]
  if random:random() < 0.15 then
    input.held[key] = not input.held[key] or nil
  end
end

local function finish()
  local stats = session.stats
  print(("steps %d"):format(session.now))
  print(("longestRollback %.2f ms"):format(furthest > 0 and furthest * cost * 1000 or 0))
  print(("longestSleep %.0f ms"):format(longestSleep * 1000))
  print(("longestWait %.0f ms"):format(stats.longestWait * 1000))
  print(("mostBytes %.0f"):format(mostBytes))
  print(("desync %s"):format(stats.desync or "none"))
  print(("problem %s"):format(stats.problem or "none"))
  love.event.quit()
end

function love.update(dt)
  if frames > 0 then
    longestSleep = math.max(longestSleep, dt) -- a busy machine has left the process waiting
  end
  left = math.min(left + dt, 4 * FRAME)
  if left < FRAME then
    return -- LÖVE without a window has no pace of its own
  end
  left, frames, seconds = left - FRAME, frames + 1, seconds - FRAME
  press()
  if isToBreak and frames > 180 and not session.stats.desync then
    online.sides[1].game.ball.x = 300 -- again and again: a rollback would mend it
  end
  local before = os.clock()
  online.update(FRAME)
  local back, time = session.replayed, os.clock() - before
  if back > 0 then
    furthest, cost = math.max(furthest, back), math.min(cost, time / back)
  end
  if frames > 240 then -- the state, which comes first, is as much as a second of play
    mostBytes = math.max(mostBytes, session.stats.bytes)
  end
  if seconds <= 0 then
    finish()
  end
end

function love.quit()
  online.leave()
end

function love.errorhandler(message)
  io.stderr:write(debug.traceback(tostring(message), 2), "\n")
  os.exit(1)
end
