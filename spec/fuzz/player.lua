--- Plays the acts of a case (spec/fuzz/case.lua) in one world and writes down what is told.
--
-- An object that is acted upon inside a callback is noted in `touched`: what the last step has left
-- of it need not be true any more when the step is judged.

local physics = require("physics")
local copyOf = require("spec.support.small").copy

-- Runs no slower without the trace compiler, which has too many loops to see here.
local jit = rawget(_G, "jit")
if jit then
  jit.off(true, true)
end

local Player = {}
Player.__index = Player

local EVENTS = { "onBegin", "onEnd", "onCrush" } -- onStay would keep all awake
-- Settings that change no result; a player of a fixed kind keeps its own.
local OWN = { broadphase = true, cellSize = true, rest = true }
local MESSAGE = "fuzz: a callback fails"

-- The log ----------------------------------------------------------------------------------------

local function nameOf(player, value)
  if type(value) == "table" then
    return tostring(player.idOf[value]) -- "nil": a wall of the world
  end
  return type(value) == "number" and ("%.17g"):format(value) or tostring(value)
end

function Player:tell(name, ...)
  local words = { name }
  for n = 1, select("#", ...) do
    words[n + 1] = nameOf(self, (select(n, ...)))
  end
  self.told[#self.told + 1] = table.concat(words, " ")
end

-- Events of the whole world: written down, followed by the acts that wait for them.
local function listen(player)
  local world = player.world
  for _, name in ipairs(EVENTS) do
    world[name] = function(a, b, side, more)
      player:tell(name, a, b, side, more)
      if player.onEvent then
        player.onEvent(player, name, a, b, side, more)
      end
      player:react(0, name)
    end
  end
end

--- Does the next act that waits for an event of an object (id 0: of the world).
function Player:react(id, event)
  local list = self.reactions[id .. event]
  if not list then
    return
  end
  list.done = list.done + 1
  local act = list.acts[list.done]
  if act and act[1] == "fail" then
    error(MESSAGE, 0)
  elseif act then
    self.inside = true
    self:act(act)
    self.inside = false
  end
end

-- Of a static object even `onStay` and `canCollide` are read only once.
local function reread(player, id)
  local object = player.list[id]
  if object and object.static and player.present[id] then
    player.world:refresh(object)
  end
end

-- Returns whether the object exists that gets a callback; 0 is the world. An object that comes
-- later must not have it in a restored copy only.
local function isThere(player, id)
  return id == 0 or player.list[id] ~= nil
end

-- Callbacks of one object, also of one that a restored copy has made anew.
local function hear(player, id, event)
  local target = id == 0 and player.world or player.list[id]
  if id == 0 and event ~= "onStay" then
    return -- the others are there already
  end
  target[event] = function(...)
    if id == 0 then
      player:tell("onStay", ...)
    end
    player:react(id, event)
  end
  if event == "onStay" then
    reread(player, id)
  end
end

local function refuse(player, id, modulus)
  local target = id == 0 and player.world or player.list[id]
  target.canCollide = function(a, b, side)
    local sum = (player.idOf[a] or 0) + 3 * (player.idOf[b] or 0) + #side
    return sum % modulus ~= 0
  end
  reread(player, id)
end

-- Acts -------------------------------------------------------------------------------------------

local acts = {}

local function note(player, id)
  player.dirty[id] = true
  if player.inside then
    player.touched[id] = true
  end
end

local function enter(player, id, group, fields)
  local object = copyOf(fields)
  player.list[id], player.idOf[object], player.present[id] = object, id, true
  note(player, id)
  return object, group
end

function acts.add(player, id, group, fields)
  if not player.list[id] then
    local object = enter(player, id, group, fields)
    player.world:add(group, object)
  end
end

function acts.insert(player, id, group, fields)
  if not player.list[id] then
    local objects = player.world.objects
    objects[group] = objects[group] or {}
    objects[group][#objects[group] + 1] = enter(player, id, group, fields)
  end
end

-- Whether a circle or a zone cannot have a field with that value.
local function isUnfit(object, name, value)
  return object.radius and name == "oneWay" or object.area and name == "sensor" and not value
end

function acts.write(player, id, fields)
  local object = player.list[id]
  if object then
    note(player, id)
    local wasStatic = object.static
    for name, value in pairs(fields) do
      if not isUnfit(object, name, value) then
        object[name] = copyOf(value)
      end
    end
    local size = object.radius and object.radius * 2
    if size and (object.width ~= size or object.height ~= size) then
      object.radius = nil -- it has become a box
    end
    if wasStatic and player.present[id] then
      player.world:refresh(object)
    else
      reread(player, id)
    end
  end
end

function acts.erase(player, id, name)
  local object = player.list[id]
  if object then
    note(player, id)
    if not isUnfit(object, name, nil) then
      object[name] = nil
    end
    reread(player, id)
  end
end

function acts.remove(player, id)
  local object = player.list[id]
  if object then
    note(player, id)
    player.world:remove(object)
    player.present[id] = false
  end
end

-- The place of an object in the game's tables.
local function find(world, object)
  for _, members in pairs(world.objects) do
    for key, member in pairs(members) do
      if member == object then
        return members, key
      end
    end
  end
end

function acts.take(player, id)
  local members, key = find(player.world, player.list[id])
  if members then
    note(player, id)
    if type(key) == "number" then
      table.remove(members, key)
    else
      members[key] = nil
    end
    player.present[id] = false
  end
end

function acts.regroup(player, id, group)
  local members, key = find(player.world, player.list[id])
  if members and type(key) == "number" then
    note(player, id)
    table.remove(members, key)
    local objects = player.world.objects
    objects[group] = objects[group] or {}
    objects[group][#objects[group] + 1] = player.list[id]
  end
end

function acts.refresh(player, id)
  if player.present[id] then
    note(player, id)
    player.world:refresh(player.list[id])
  end
end

function acts.drop(player, id)
  if player.present[id] then
    note(player, id)
    player.world:dropThrough(player.list[id])
  end
end

function acts.impulse(player, id, ix, iy)
  local object = player.list[id]
  if player.present[id] and not object.static and not object.kinematic then
    note(player, id)
    player.world:impulse(object, ix, iy)
  end
end

function acts.move(player, id, x, y, response)
  local object = player.list[id]
  if player.present[id] and not object.static then
    note(player, id)
    local _, _, hits, count = player.world:move(object, x, y, response)
    for n = 1, count do
      player:tell("hit", hits[n].other, object, hits[n].side)
    end
  end
end

-- What can meet what has changed, for all objects.
local function noteAll(player)
  for id = 1, player.highest do
    note(player, id)
  end
end

function acts.set(player, name, value)
  if not (player.own and OWN[name]) then
    player.world[name] = copyOf(value)
  end
  noteAll(player)
end

function acts.unset(player, name)
  acts.set(player, name, nil)
end

function acts.bounds(player, x, y, w, h)
  player.world:setBounds(x, y, w, h)
  noteAll(player)
end

function acts.listen(player, id, event, list)
  if isThere(player, id) then
    player.reactions[id .. event] = { done = 0, acts = list }
    player.isStayHeard = player.isStayHeard or event == "onStay"
    hear(player, id, event)
  end
end

function acts.refuse(player, id, modulus)
  if isThere(player, id) then
    player.refusals[id] = modulus
    refuse(player, id, modulus)
    noteAll(player)
  end
end

local function tellList(player, name, list, count)
  for n = 1, count do
    player:tell(name, list[n])
  end
end

function acts.ask(player, x, y, w, h)
  local world = player.world
  tellList(player, "point", world:queryPoint(x, y))
  tellList(player, "rect", world:queryRect(x, y, w, h))
  if world._bodies.hasRound then
    tellList(player, "circle", world:queryCircle(x, y, w))
  end
  tellList(player, "segment", world:querySegment(x, y, x + w, y - h))
  player:tell("ray", world:raycast(x + w, y, x - w, y + h))
  player:tell("nearest", world:nearest(x, y, w))
  local object = player.list[1]
  if player.present[1] then
    player:tell("sweep", world:sweep(object, w, h))
    player:tell("fits", world:fits(x, y, w, h, object))
    player:tell("velocity", world:velocity(object))
    tellList(player, "overlapping", world:overlapping(object))
  end
end

function acts.fail() end

function acts.reload(player)
  if not (player.own or player.inside) then
    player.world:restore(player.world:save())
  end
end

-- What plays several worlds makes the copy.
function acts.twin() end

function acts.update(player, dt)
  if player.inside then
    return
  end
  player.touched = {}
  local ok, message = pcall(player.world.update, player.world, dt)
  player.inside = false
  if not ok and message ~= MESSAGE then
    error(message, 0)
  end
  player.failed = not ok
end

--- Does one act.
function Player:act(act)
  acts[act[1]](self, act[2], act[3], act[4], act[5])
end

-- Players ----------------------------------------------------------------------------------------

local function blank(highest)
  return setmetatable({
    list = {}, -- objects by id, removed ones too
    idOf = {},
    present = {}, -- ids of those that are in the world's tables
    told = {},
    reactions = {},
    refusals = {},
    touched = {}, -- ids of those that a callback of the last update acted upon
    dirty = {}, -- ids of those that were acted upon since this was emptied
    highest = highest,
    inside = false, -- in a callback
    failed = false, -- the last update
  }, Player)
end

local function highestId(list)
  local highest = 0
  for _, act in ipairs(list) do
    if act[1] == "add" or act[1] == "insert" then
      highest = math.max(highest, act[2])
    elseif act[1] == "listen" then
      highest = math.max(highest, highestId(act[4]))
    end
  end
  return highest
end

local player = {}

-- Lets some objects come and go, so that the world's memory is used in another order than in a new
-- one. What is left of them is the name of a group, which no case uses.
local function receive(world)
  local guests = {}
  for n = 1, 30 do
    local guest = { x = 12 * n, y = 7 * n, width = 30, height = 40, static = n % 4 == 0 }
    guests[n] = world:add("guests", guest)
  end
  world:update(1 / 60)
  for n = 1, 30 do
    world:remove(guests[n * 7 % 31])
    if n % 9 == 0 then
      world:update(1 / 60)
    end
  end
  world.objects.guests = nil
  world:update(0)
end

--- Begins to play a case.
---@param case table
---@param own table? settings that this player keeps whatever the case says: broadphase, cellSize,
---  rest; `guests`: others have been in its world before
function player.new(case, own)
  local self = blank(highestId(case.acts))
  local settings = copyOf(case.settings)
  for name in pairs(own and OWN or {}) do
    settings[name] = own[name]
  end
  self.own = own
  self.world = physics.newWorld(settings)
  if own and own.guests and not settings.timestep then
    receive(self.world)
  end
  listen(self)
  return self
end

-- Notes which object of a copy is which: `mine` is there for `its`.
local function pair(self, other, mine, its)
  local id = its and other.idOf[its]
  if id and not self.list[id] then
    self.list[id], self.idOf[mine], self.present[id] = mine, id, other.present[id]
  end
end

-- Pairs the objects that the worlds know; some of them may not be in the tables any more.
local function pairKnown(self, other)
  -- By name: the order of the groups is one that the next update will read.
  local mine, its = self.world._bodies.registry.byName, other.world._bodies.registry.groups
  for _, record in ipairs(its) do
    for n = 1, record.count do
      pair(self, other, mine[record.name].list[n], record.list[n])
    end
  end
end

-- Pairs the objects in the tables of two worlds, and those that they touch, which may have left
-- them.
local function pairPresent(self, other)
  for group, members in pairs(other.world.objects) do
    for key, its in pairs(members) do
      local mine = self.world.objects[group][key]
      pair(self, other, mine, its)
      -- An object that is not dynamic any more keeps the table that it had; its copy never gets
      -- one.
      for side, neighbour in pairs(mine.touching and its.touching or {}) do
        pair(self, other, mine.touching[side], neighbour)
      end
    end
  end
end

-- Pairs the objects of events that wait. They may have left, and no table leads to them.
local function pairTold(self, other)
  local mine, its = self.world._bodies.events, other.world._bodies.events
  for n = 1, mine.count do
    local m = its.order[its.count - mine.count + n]
    for _, role in ipairs({ "a", "b", "c" }) do
      pair(self, other, mine[role][n], its[role][m])
    end
  end
end

--- Makes a player that goes on from the state of another, in a world of its own.
---@param other table
---@param own table settings of the new one: broadphase, cellSize, rest
function player.copy(other, own)
  local self = blank(other.highest)
  self.own, self.world = own, physics.newWorld(own)
  self.world:restore(copyOf(other.world:save()))
  pairKnown(self, other)
  pairPresent(self, other)
  pairTold(self, other)
  for id, object in pairs(other.list) do
    if not self.list[id] then -- not in the world: nothing else will look at it again
      local touching = object.touching
      object.touching = nil
      local copy = copyOf(object)
      object.touching = touching
      self.list[id], self.idOf[copy], self.present[id] = copy, id, false
    end
  end
  listen(self)
  for name, list in pairs(other.reactions) do
    self.reactions[name] = { done = list.done, acts = list.acts }
    local id, event = name:match("^(%d+)(.*)$")
    hear(self, tonumber(id), event)
  end
  for id, modulus in pairs(other.refusals) do
    self.refusals[id] = modulus
    refuse(self, id, modulus)
  end
  return self
end

return player
