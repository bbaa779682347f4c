-- Plays scenes in the engines of bench/, step by step or as a whole.

local engines = require("bench.engines")

local plays = {}

local TITLES = { tutorial = "plain loop" } -- what docs/compare.md calls an engine

--- The engines that can be found here, in the order of the columns: `name`, `title`, `engine`.
function plays.engines()
  local found = {}
  for _, name in ipairs({ "ours", "love", "bump", "tutorial" }) do
    local engine = engines.get(name, love ~= nil and love.physics ~= nil)
    if engine then
      local title = TITLES[name] or engines.title(name)
      found[#found + 1] = { name = name, title = title, engine = engine }
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
    soft = scene.soft,
    rest = true,
    objects = objects,
  })
  local play = { scene = scene, world = world, place = place, notes = { x = 0 }, frame = 0 }
  play.objects = objects
  if scene.prepare then
    scene.prepare(play)
  end
  return play
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

-- The cell of a scene and an engine. `unit`: of a scene that is timed, the time of love.physics.
local function cell(scene, each, unit)
  local function show(value)
    return unit and ("%.1f"):format(value / unit) or plays.show(value)
  end
  local parts = { show(plays.number(scene, each)) }
  for _, cure in ipairs(scene.cures and scene.cures[each.name] or {}) do
    local cured = setmetatable(cure, { __index = scene })
    parts[#parts + 1] = ("%s with %s"):format(show(plays.number(cured, each)), cure.title)
  end
  return table.concat(parts, "; ")
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
    local row, unit = { scene.title, scene.unit }, nil ---@type string[], number?
    for _, each in ipairs(scene.isTimed and found or {}) do
      unit = each.name == "love" and plays.number(scene, each) or unit
    end
    for _, each in ipairs(found) do
      row[#row + 1] = cell(scene, each, unit)
    end
    lines[#lines + 1] = line(row)
  end
  return table.concat(lines, "\n") .. "\n"
end

return plays
