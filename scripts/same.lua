--- Plays the scenes of bench/ at a small size, and random games, with the library in FOLDER. After
--- each ten frames it prints a sum of where everything is, to the last bit, and of what the games
--- were told. (`make same BASE=COMMIT` compares these lines with those of a commit.)
---
---   luajit scripts/same.lua FOLDER [FILTER]     FILTER: only what has this in its name

package.path = arg[1] .. "/?.lua;./?.lua"

local scenes = require("bench.scenes")

local SIZE, FRAMES, EACH, GAMES = 60, 60, 10, 45
local FIELDS = { "x", "y", "vx", "vy" }
local filter = arg[2] or ""

-- Prints the name of a scene, a frame, and a sum of all numbers and words.
local function tell(name, frame, objects, count, told)
  local words, sum = { table.concat(told, " ") }, 0
  for n = 1, count * #FIELDS do
    local object = objects[math.ceil(n / #FIELDS)]
    words[n + 1] = ("%.17g"):format(object and object[FIELDS[n % #FIELDS + 1]] or 0)
  end
  local text = table.concat(words, " ")
  for at = 1, #text do
    sum = (sum * 131 + text:byte(at)) % 4294967291
  end
  print(("%s, frame %d: %d"):format(name, frame, sum))
end

local function playScene(scene)
  local world = require("bench.engines.ours").new(scene)
  local prepare = scene.between or tostring
  for frame = 1, FRAMES do
    prepare(world, frame)
    scene.frame(world, frame)
    if frame % EACH == 0 then
      tell(scene.name, frame, world.objects, #world.objects, {})
    end
  end
end

local function playGame(name, game)
  local player, frame = require("spec.fuzz.player").new(game), 0
  for _, act in ipairs(game.acts) do
    player:act(act)
    frame = frame + (act[1] == "update" and 1 or 0)
    if act[1] == "update" and frame % EACH == 0 then
      tell(name, frame, player.list, player.highest, player.told)
    end
  end
end

for _, row in ipairs(scenes.list) do
  if row.name:find(filter, 1, true) and row.name ~= "rooms" then -- (those are many worlds)
    playScene(scenes.build(row.name, math.max(SIZE, row.quick)))
  end
end
for n = 1, GAMES do
  local kind = n % 3 == 0 and "sloped" or n % 3 == 1 and "crowded" or "case"
  local name = kind .. " " .. n
  if name:find(filter, 1, true) then
    playGame(name, require("spec.fuzz." .. kind).new(n, FRAMES))
  end
end
