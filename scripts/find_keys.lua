-- Finds keys with which an example is won that tells of `x`, `deaths` and `won`, and prints them:
--
--   luajit scripts/find_keys.lua platformer >examples/demos/platformer.keys
--
-- Needed when the level, the player or (**Behaviour**) the physics changed so that the recorded
-- keys no longer win. It plays without a window: to the right, with jumps and rests at random
-- moments that are kept as long as they lead further.

package.path = "./?.lua;./examples/?.lua;" .. package.path

local LONGEST = 3600 -- frames
local PATIENCE = 300 -- frames without getting further
local FIRST = 10 -- frame in which the player starts to run

-- The game asks LÖVE for the keyboard, and its art for nothing.
local function nothing() end
local name = assert(arg[1], "which example?")
package.loaded[name .. "_art"] = { load = nothing, update = nothing, burst = nothing }
love = { keyboard = { isDown = nothing } }
local input = require("input")
local game = require(name)

-- Whether one of the spans `{ key, first, last }` has a frame.
local function isIn(spans, key, frame)
  for _, span in ipairs(spans) do
    if span[1] == key and frame >= span[2] and frame <= span[3] then
      return true
    end
  end
end

-- Plays with jumps ("space") and rests; returns how far, until when, and whether it was won.
local function play(spans)
  local furthest, since = 0, 0
  game.load()
  for frame = 1, LONGEST do
    input.held = {
      right = frame >= FIRST and not isIn(spans, "rest", frame),
      space = isIn(spans, "space", frame),
    }
    game.update(1 / 60)
    local x, deaths, won = game.report():match("x=(%-?%d+).* deaths=(%d+).* won=(%a+)")
    if tonumber(x) > furthest then
      furthest, since = tonumber(x), frame
    end
    if won == "true" or deaths ~= "0" or frame - since > PATIENCE then
      return furthest, frame, won == "true", since
    end
  end
  return furthest, LONGEST, false, since
end

-- Keeps what was done until shortly before `last` and goes on with other jumps and rests.
local function vary(spans, last)
  local frame, varied = math.max(FIRST, last - math.random(10, 250)), {}
  for _, span in ipairs(spans) do
    if span[3] < frame then
      varied[#varied + 1] = span
    end
  end
  for _ = 1, math.random(1, 4) do
    local isRest = math.random() < 0.3
    local first = frame + math.random(1, 60)
    frame = first + math.random(4, isRest and 150 or 30)
    varied[#varied + 1] = { isRest and "rest" or "space", first, frame }
  end
  return varied
end

math.randomseed(1)
local best, last, won, spans = 0, FIRST, false, {}
while not won do
  local varied = vary(spans, last)
  local x, _, isWon, since = play(varied)
  -- An equally good one is taken now and then, or the search would stay in a dead end.
  if isWon or x > best or (x == best and math.random() < 0.3) then
    spans, best, last, won = varied, x, since, isWon
    io.stderr:write("x = ", x, " in frame ", last, "\n")
  end
end

local keys, from = {}, FIRST
for _, span in ipairs(spans) do
  if span[2] <= last then
    if span[1] == "rest" then
      keys[#keys + 1] = ("right:%d-%d"):format(from, span[2] - 1)
      from = span[3] + 1
    else
      keys[#keys + 1] = ("space:%d-%d"):format(span[2], span[3])
    end
  end
end
keys[#keys + 1] = ("right:%d-%d"):format(from, last)
print(table.concat(keys, ","))
