-- Finds keys with which the platformer's level is won, and prints them:
--
--   luajit scripts/find_keys.lua >examples/demos/platformer.keys
--
-- Needed when the level, the player or (**Behaviour**) the physics changed so that the recorded
-- keys no longer win. It plays without a window: always to the right, with jumps at random moments
-- that are kept as long as they lead further.

package.path = "./?.lua;./examples/?.lua;" .. package.path

local LONGEST = 2400 -- frames
local PATIENCE = 50 -- frames without getting further
local FIRST = 10 -- frame in which the player starts to run

-- The game asks LÖVE for the keyboard, and its art for nothing.
local function nothing() end
package.loaded.platformer_art = { load = nothing, update = nothing, burst = nothing }
love = {
  keyboard = {
    isDown = function()
      return false
    end,
  },
}
local input = require("input")
local platformer = require("platformer")

-- Plays with jumps `{ { first, last }, … }`; returns how far, until when, and whether it was won.
local function play(jumps)
  local furthest, since, next = 0, 0, 1
  platformer.load()
  for frame = 1, LONGEST do
    while jumps[next] and frame > jumps[next][2] do
      next = next + 1
    end
    local jump = jumps[next]
    input.held = { right = frame >= FIRST, space = jump and frame >= jump[1] }
    platformer.update(1 / 60)
    local x, deaths, won = platformer.report():match("x=(%-?%d+).* deaths=(%d+) won=(%a+)")
    if tonumber(x) > furthest then
      furthest, since = tonumber(x), frame
    end
    if won == "true" or deaths ~= "0" or frame - since > PATIENCE then
      return furthest, frame, won == "true"
    end
  end
  return furthest, LONGEST, false
end

-- Keeps what was done until shortly before `last` and goes on with other jumps.
local function vary(jumps, last)
  local cut = last - math.random(20, 200)
  local varied = {}
  for _, jump in ipairs(jumps) do
    if jump[2] < cut then
      varied[#varied + 1] = jump
    end
  end
  local frame = math.max(FIRST, cut)
  for _ = 1, math.random(1, 3) do
    local first = frame + math.random(2, 50)
    frame = first + math.random(4, 30)
    varied[#varied + 1] = { first, frame }
  end
  return varied
end

math.randomseed(1)
local jumps = {}
local furthest, last, won = play(jumps)
while not won do
  local varied = vary(jumps, last)
  local x, frame, isWon = play(varied)
  -- An equally good one is taken now and then, or the search would stay in a dead end.
  if isWon or x > furthest or (x == furthest and math.random() < 0.3) then
    jumps, furthest, last, won = varied, x, frame, isWon
    io.stderr:write("x = ", x, " in frame ", frame, "\n")
  end
end

local keys = { ("right:%d-%d"):format(FIRST, last) }
for _, jump in ipairs(jumps) do
  if jump[1] <= last then
    keys[#keys + 1] = ("space:%d-%d"):format(jump[1], jump[2])
  end
end
print(table.concat(keys, ","))
