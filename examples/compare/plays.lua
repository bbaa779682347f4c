-- Plays scenes in the engines of bench/, step by step or as a whole.

local engines = require("bench.engines")

local plays = {}

--- The engines that can be found here, in the order of the columns: `name`, `title`, `engine`.
function plays.engines()
  local found = {}
  for _, name in ipairs({ "ours", "love", "bump", "tutorial" }) do
    local engine = engines.get(name, love ~= nil and love.physics ~= nil)
    if engine then
      found[#found + 1] = { name = name, title = engines.title(name), engine = engine }
    end
  end
  return found
end

-- Where an engine has no platforms a game moves a box by hand.
local PLACES = {
  bump = function(play, i, x, y)
    local object = play.world.objects[i]
    object.x, object.y = x, y
    play.world.world:update(object, x, y)
  end,
  tutorial = function(play, i, x, y)
    local object = play.world.objects[i]
    object.x, object.y = x, y
  end,
}

--- A scene at its start in one engine.
function plays.new(scene, found)
  local place, objects = PLACES[found.name], {}
  for i, description in ipairs(scene.objects) do
    objects[i] = description
    if place and description.kinematic then
      objects[i] = setmetatable({ static = true }, { __index = description })
    end
  end
  local world = found.engine.new({
    gravity = scene.gravity,
    rest = true,
    objects = objects,
  })
  return { scene = scene, world = world, place = place, notes = { x = 0 }, frame = 0 }
end

--- Plays one step of dt s.
function plays.step(play, dt)
  local scene = play.scene
  play.frame = play.frame + 1
  if scene.push then
    scene.push(play, play.frame)
  end
  play.world:step(dt)
  if scene.look then
    scene.look(play, play.frame)
  end
end

-- Plays a scene from its start. Returns its number.
local function number(scene, found, rate)
  local play = plays.new(scene, found)
  for _ = 1, math.floor(scene.seconds * rate + 0.5) do
    plays.step(play, 1 / rate)
  end
  local result = scene.number(play)
  play.world:free()
  return result
end

--- Returns the number of a scene in an engine.
function plays.number(scene, found)
  if scene.rates then
    local a, b = number(scene, found, scene.rates[1]), number(scene, found, scene.rates[2])
    return math.abs(a - b) < 0.05 and 0 or math.abs(a - b)
  end
  return number(scene, found, 60)
end

--- Writes a number as it is shown.
function plays.show(value)
  if type(value) ~= "number" then
    return value
  elseif value ~= value or math.abs(value) > 1e6 then
    return "lost"
  elseif value == math.floor(value) then
    return ("%d"):format(value)
  end
  return ("%.1f"):format(value)
end

local function line(row)
  return "| " .. table.concat(row, " | ") .. " |"
end

--- Returns the table of all scenes and engines as Markdown.
function plays.table(list)
  local found = plays.engines()
  local head, rule = { "scene", "counts" }, { "---", "---" }
  for _, each in ipairs(found) do
    head[#head + 1], rule[#rule + 1] = each.title, "---:"
  end
  local lines = { line(head), line(rule) }
  for _, scene in ipairs(list) do
    local row = { scene.title, scene.unit }
    for _, each in ipairs(found) do
      row[#row + 1] = plays.show(plays.number(scene, each))
    end
    lines[#lines + 1] = line(row)
  end
  return table.concat(lines, "\n") .. "\n"
end

return plays
