--- Random plays for the property specs. A script is data, made from a seed before anything moves: a
--- first set of objects, and for each step a dt and what the game writes before it. So the same
--- script can be played in worlds with different settings, and the bits compared.

local physics = require("physics")
local newRandom = require("spec.support.random").new
local set = require("spec.support.small").set

local script = {}

local GROUPS = { "boxes", "crates", "players" }
local ROOM = 400 -- px, inner width and height of the room

-- Making -----------------------------------------------------------------------------------------

--- A room: floor of tiles, walls, some blocks inside.
local function makeStatics(random, list)
  for i = 0, 24 do
    list[#list + 1] = { "tiles", { x = 16 * i, y = ROOM, width = 16, height = 16, static = true } }
  end
  local walls = {
    { -32, -ROOM, 32, 2 * ROOM + 32 },
    { ROOM, -ROOM, 32, 2 * ROOM + 32 },
    { -32, -ROOM - 32, ROOM + 64, 32 },
  }
  for _, wall in ipairs(walls) do
    local x, y, width, height = wall[1], wall[2], wall[3], wall[4]
    local object = { x = x, y = y, width = width, height = height, static = true }
    object.friction = random:chance(0.5) and random:between(0, 1) or nil
    list[#list + 1] = { "walls", object }
  end
  for i = 0, 3 do
    local x, y = 100 * i + random:between(0, 50), random:between(200, 340)
    local block = { x = x, y = y, width = random:between(8, 50), height = random:between(8, 30) }
    block.static = true
    list[#list + 1] = { "blocks", block }
  end
end

-- Fields that a box may have: with which chance, between which numbers, or which of a list.
local CHANCES = {
  { "friction", 0.5, 0, 1 },
  { "restitution", 0.4, { 0.25, 0.5, 0.9, 1 } },
  { "mass", 0.4, 0.25, 8 },
  { "gravity", 0.1, { 0, -300, 1200 } },
  { "airFriction", 0.1, 0, 2 },
  { "drag", 0.1, 0, 100 },
  { "maxSpeed", 0.1, 50, 400 },
}

--- A dynamic box with random fields, at a place of a raster so that nothing overlaps at first.
local function makeBox(random, x, y, options)
  local box = { x = x, y = y, width = random:between(4, 20), height = random:between(4, 20) }
  box.vx, box.vy = random:between(-150, 150), random:between(-100, 100)
  for _, row in ipairs(CHANCES) do
    if random:chance(row[2]) then
      box[row[1]] = row[4] and random:between(row[3], row[4]) or random:pick(row[3])
    end
  end
  if random:chance(0.1) and not options.pushable then
    box.pushable = false
  end
  if random:chance(0.1) and options.specials then
    box.mask = { crates = false }
  end
  return box
end

--- A platform, a one-way or a sensor.
local function makeSpecial(random, x, y)
  local special = { x = x, y = y, width = random:between(20, 70), height = random:between(4, 12) }
  local kind = random:integer(1, 4)
  if kind == 1 then
    special.kinematic, special.vx, special.vy = true, random:between(-80, 80), 0
  elseif kind == 2 then
    special.kinematic, special.vx, special.vy = true, 0, random:between(-40, 40)
  elseif kind == 3 then
    special.static, special.oneWay = true, random:pick({ "top", "bottom", "left", "right" })
  else
    special.static, special.sensor = true, true
  end
  return special
end

--- What the game writes to an object that is there.
local function makeWrite(random, index)
  local kind = random:integer(1, 9)
  local fields
  if kind <= 3 then
    fields = { vx = random:between(-400, 400), vy = random:between(-400, 400) }
  elseif kind == 4 then
    fields = { x = random:between(0, ROOM - 20), y = random:between(0, 180) }
  elseif kind == 5 then
    fields = { width = random:between(4, 20), height = random:between(4, 20) }
  elseif kind == 6 then
    fields = { friction = random:between(0, 1) }
  elseif kind == 7 then
    fields = { active = random:chance(0.5) }
  elseif kind == 8 then
    fields = { mask = random:chance(0.5) and { boxes = false } or {} }
  end
  return { fields and "write" or "remove", index, fields }
end

--- Makes a script.
---@param seed integer
---@param options table steps: integer; boxes: integer; writes: number, share of the steps in which
---  the game writes something; specials: boolean, with platforms, one-ways, sensors and masks;
---  pushable: boolean, nothing that cannot be pushed
function script.new(seed, options)
  local random = newRandom(seed)
  local list = {}
  makeStatics(random, list)
  local firstMover = #list + 1
  for i = 0, options.boxes - 1 do
    local x = 24 * (i % 16) + random:between(0, 3)
    local y = 160 - 24 * math.floor(i / 16) + random:between(0, 3)
    list[#list + 1] = { random:pick(GROUPS), makeBox(random, x, y, options) }
  end
  if options.specials then
    for i = 0, 4 do
      list[#list + 1] = { "specials", makeSpecial(random, 80 * i, random:between(190, 380)) }
    end
  end
  local result = { objects = list, steps = {}, gravity = random:pick({ 0, 400, 800, 800, 800 }) }
  local count = #list
  for i = 1, options.steps do
    local step = { dt = random:pick({ 1 / 60, 1 / 60, 1 / 60, 1 / 30, 1 / 144, 0.05 }) }
    if random:chance(options.writes) then
      step[1] = makeWrite(random, random:integer(firstMover, count))
      if random:chance(0.1) then
        count = count + 1
        local x, y = random:between(0, ROOM - 20), random:between(0, 150)
        local box = makeBox(random, x, y, options)
        step[2] = { "add", random:pick(GROUPS), box }
      end
    end
    result.steps[i] = step
  end
  return result
end

-- Playing ----------------------------------------------------------------------------------------

local Player = {}
Player.__index = Player

--- Ways of putting an object into a world: each fills the keys 1, 2, 3 … of its group.
script.inserts = {
  add = function(world, group, object)
    world:add(group, object)
  end,
  insert = function(world, group, object)
    world.objects[group] = world.objects[group] or {}
    table.insert(world.objects[group], object)
  end,
  assign = function(world, group, object)
    local list = {}
    for key, other in pairs(world.objects[group] or {}) do
      list[key] = other
    end
    list[#list + 1] = object
    world.objects[group] = list
  end,
}

function Player:add(group, description)
  local object = set({}, description)
  self.count = self.count + 1
  self.list[self.count] = object
  self.indexOf[object] = self.count
  self.insert(self.world, group, object)
end

--- Writes every event as a line, so that two runs can be compared.
local function listen(player)
  local told = player.told
  for _, name in ipairs({ "onBegin", "onStay", "onEnd", "onCrush" }) do
    player.world[name] = function(a, b, c)
      local first, second = tostring(player.indexOf[a]), tostring(player.indexOf[b])
      local third = tostring(player.indexOf[c] or c)
      told[#told + 1] = ("%s %s %s %s"):format(name, first, second, third)
    end
  end
end

--- Begins to play a script.
---@param settings table? of newWorld; gravity comes from the script
---@param insert function? one of script.inserts, add unless given
---@param prepare function? gets the world before anything is in it
function script.play(self, settings, insert, prepare)
  local all = set({ gravity = self.gravity }, settings)
  local player = setmetatable({ script = self, step = 0, count = 0 }, Player)
  player.world = physics.newWorld(all)
  player.list, player.indexOf, player.told = {}, {}, {}
  player.insert = insert or script.inserts.add
  if prepare then
    prepare(player.world)
  end
  listen(player)
  for _, entry in ipairs(self.objects) do
    player:add(entry[1], entry[2])
  end
  return player
end

local function act(player, action)
  if action[1] == "add" then
    return player:add(action[2], action[3])
  end
  local object = player.list[action[2]]
  if not object then
    return
  end -- removed before
  if action[1] == "remove" then
    player.world:remove(object)
    player.list[action[2]] = false
  else
    for field, value in pairs(action[3]) do
      object[field] = type(value) == "table" and set({}, value) or value
    end
  end
end

--- Plays the next step; false after the last.
function Player:next()
  self.step = self.step + 1
  local step = self.script.steps[self.step]
  if not step then
    return false
  end
  for i = 1, #step do
    act(self, step[i])
  end
  for i = #self.told, 1, -1 do
    self.told[i] = nil
  end
  self.world:update(step.dt)
  return true
end

local FIELDS = { "x", "y", "vx", "vy" }
local SIDES = { "top", "bottom", "left", "right" }

--- What can be seen of the world after a step: place, speed and neighbours of every object.
local function frameOf(player)
  local values, told = {}, {}
  for i = 1, player.count do
    local object = player.list[i]
    local touching = object and object.touching
    for _, field in ipairs(object and FIELDS or {}) do
      values[#values + 1] = object[field] or false
    end
    for _, side in ipairs(touching and SIDES or {}) do
      values[#values + 1] = player.indexOf[touching[side]] or false
    end
  end
  for i = 1, #player.told do
    told[i] = player.told[i]
  end
  return { values = values, told = told }
end

--- Plays a script to the end and notes everything.
---@return table[] track one frame for each step
function script.track(self, settings, insert)
  local player, track = script.play(self, settings, insert), {}
  while player:next() do
    track[player.step] = frameOf(player)
  end
  return track
end

local function write(value)
  return type(value) == "number" and ("%.17g"):format(value) or tostring(value)
end

--- The first difference between a player after a step and the track of another, in words, or nil.
function script.difference(track, player)
  local expected, found = track[player.step], frameOf(player)
  for _, what in ipairs({ "values", "told" }) do
    for at = 1, math.max(#expected[what], #found[what]) do
      local a, b = expected[what][at], found[what][at]
      if a ~= b then
        return ("step %d: %s %d is %s and %s"):format(player.step, what, at, write(a), write(b))
      end
    end
  end
end

return script
