--- A world: its settings and the order of the steps.

local here = (...):match("^(.*)%.[^.]+$")
local begin = require(here .. ".begin")
local carrier = require(here .. ".carrier")
local check = require(here .. ".check")
local collect = require(here .. ".collect")
local columns = require(here .. ".columns")
local detect = require(here .. ".detect")
local events = require(here .. ".events")
local meet = require(here .. ".meet")
local oneway = require(here .. ".oneway")
local part = require(here .. ".part")
local predict = require(here .. ".predict")
local publish = require(here .. ".publish")
local queue = require(here .. ".queue")
local rest = require(here .. ".rest")
local roster = require(here .. ".roster")
local settings = require(here .. ".settings")

--- An independent world: a table of groups of objects, settings as plain fields, and the steps.
---@class physics.World
---@field objects table<string|number, table> the game's groups of objects
---@field stats physics.Stats counters of the last step
---@field alpha number share of a fixed step that is saved up, 0..1
local World = {}
World.__index = World

local ceil = math.ceil

-- Longest time that one update makes up for, s.
local LONGEST = 0.25
-- Share of a fixed step that may be missing through rounding.
local ROUNDING = 1e-9

local function checkSelf(self, call)
  if getmetatable(self) ~= World then
    check.fail(
      "world:" .. call .. " must be called with a colon on a world, got " .. check.show(self)
    )
  end
end

local function checkIdle(b, call)
  if b.asking then
    check.fail("world:" .. call .. " cannot be called from inside canCollide")
  end
end

--- One step of dt seconds: the building of this library, room by room. Its events are told by the
--- caller, once the time of the step is booked.
local function step(self, dt)
  local b = self._bodies
  settings.apply(self)
  collect.run(b, self.objects)
  carrier.dismount(b)

  b.begun, b.predicted = 0, 0
  begin.run(b)
  detect.runMoved(b)
  part.run(b)
  predict.run(b, dt) -- forces, move, detect
  meet.run(b, dt) -- side, push, restitution, friction
  publish.run(b)
  if b.rest then
    rest.settle(b)
  end

  local stats = self.stats
  stats.objects, stats.movers, stats.resting = b.count, b.moverCount, b.moverCount - b.awakeCount
  stats.pairs, stats.contacts, stats.events = b.pairCount, b.contactCount, b.resolved
end

-- Steps of equal length that are at most `maxStep` long.
local function split(self, dt)
  local steps = ceil(dt / self.maxStep - ROUNDING)
  if steps < 1 then
    steps = 1
  end
  for _ = 1, steps do
    step(self, dt / steps)
    events.tell(self._bodies)
  end
end

-- As many fixed steps as fit into what is saved up. A refused step has used up no time, and none of
-- a refused dt is saved.
local function stepFixed(self, dt)
  local timestep = self.timestep
  while self._saved + dt >= timestep * (1 - ROUNDING) do
    step(self, timestep)
    self._saved, dt = self._saved + dt - timestep, 0
    events.tell(self._bodies)
  end
  self._saved = self._saved + dt
  local alpha = self._saved / timestep
  self.alpha = alpha > 0 and alpha or 0
end

--- Moves the world on by dt seconds: collects the game's tables, moves and bumps what is in them,
--- writes the results back and tells the events. More than `maxStep` is split into equal steps,
--- more than 0.25 s is cut to that; 0 reads the tables and moves nothing.
---
--- Errors: dt is no number >= 0; a group, key, field or setting that cannot be used (nothing has
--- changed then); called from inside `canCollide`; whatever a callback raises.
---@param dt number s, >= 0
function World:update(dt)
  checkSelf(self, "update(dt)")
  check.number(dt, "dt", "world:update(dt)", 0)
  local b = self._bodies
  checkIdle(b, "update(dt)")
  events.tell(b)
  if dt == 0 then
    settings.apply(self)
    collect.run(b, self.objects)
    events.tell(b)
    return
  end
  dt = dt < LONGEST and dt or LONGEST
  settings.apply(self)
  if self.timestep then
    stepFixed(self, dt)
  else
    split(self, dt)
  end
end

local function groupFor(self, group)
  if type(self.objects) ~= "table" then
    check.fail("objects must be a table of groups, got " .. check.show(self.objects))
  end
  local members = self.objects[group]
  if members == nil then
    members = {}
    self.objects[group] = members
  elseif type(members) ~= "table" or type(members.width) == "number" then
    check.fail(
      "world:add(group, object): "
        .. check.place(group)
        .. " is not a group, got "
        .. (type(members) == "table" and "an object" or check.show(members))
    )
  end
  return members
end

-- Where an object stands now: the table that holds it and its key in there; nil: nowhere.
local function whereIs(self, object)
  local b = self._bodies
  local slot = b.slotOf[object]
  if slot then
    local record = b.group[slot]
    if record.direct then
      if self.objects[record.name] == object then
        return self.objects, record.name, record.name
      end
    elseif self.objects[record.name] == record.source then
      local key = roster.find(record.source, object, b.key[slot])
      if key ~= nil then
        return record.source, key, record.name, key
      end
    end
  end
  local group = b.roster.groupGiven[object]
  local members = group ~= nil and self.objects[group]
  if type(members) == "table" then
    local key = roster.find(members, object)
    if key ~= nil then
      return members, key, group, key
    end
  end
end

--- Puts an object at the end of a group, which is made if it is not there. The same as
--- `table.insert(world.objects[group], object)`, but it checks the fields at once and gives the
--- object its `touching`.
---
--- Errors: a group that is no name; no table; a field that cannot be used; an object that already
--- stands in the world. Nothing has changed then.
---@generic T: table
---@param group string|number name of the group
---@param object T
---@return T object
function World:add(group, object)
  checkSelf(self, "add(group, object)")
  checkIdle(self._bodies, "add(group, object)")
  check.group(group, "world:add(group, object)")
  check.table(object, "object", "world:add(group, object)")
  local known = type(self.objects) == "table" and self.objects[group]
  local n = type(known) == "table" and #known or 0
  check.object(object, check.place(group, n + 1))
  local given = self._bodies.roster
  if type(self.objects) == "table" then
    local table_, _, name, key = whereIs(self, object)
    if table_ then
      check.fail(
        "world:add(group, object): the object already stands at " .. check.place(name, key)
      )
    end
  end
  local members = groupFor(self, group)
  members[#members + 1] = object
  given.groupGiven[object] = group
  if not object.static and not object.kinematic then
    object.touching = collect.newTouching()
    given.given[object] = object.touching
  end
  return object
end

--- Takes an object out of the world, out of its group's table. Its contacts end with `onEnd` at the
--- next update.
---
--- Errors: no table.
---@param object table
---@return boolean removed false: it was not in the world
function World:remove(object)
  checkSelf(self, "remove(object)")
  checkIdle(self._bodies, "remove(object)")
  check.table(object, "object", "world:remove(object)")
  local members, key = whereIs(self, object)
  if not members then
    return false
  end
  local isNumbered = members ~= self.objects and type(key) == "number"
  if isNumbered and key >= 1 and key <= #members and key % 1 == 0 then
    table.remove(members, key)
  else
    members[key] = nil
  end
  self._bodies.roster.groupGiven[object] = nil
  return true
end

--- Reads an object anew, also the fields that are read only once: `static`, and everything of a
--- static object.
---
--- Errors: no table; an object that is not in the world; a field that cannot be used.
---@param object table
function World:refresh(object)
  checkSelf(self, "refresh(object)")
  local b = self._bodies
  checkIdle(b, "refresh(object)")
  check.table(object, "object", "world:refresh(object)")
  local slot = b.slotOf[object]
  if slot then
    collect.refresh(b, slot)
  elseif not whereIs(self, object) then
    check.fail("world:refresh(object): the object is not in the world, got " .. check.show(object))
  end
end

--- Lets an object fall through the one-way objects it stands on. It passes them until it is clear
--- of them.
---
--- Errors: no table; an object that is not in the world.
---@param object table
---@return boolean dropped false: it stands on none
function World:dropThrough(object)
  checkSelf(self, "dropThrough(object)")
  local b = self._bodies
  checkIdle(b, "dropThrough(object)")
  check.table(object, "object", "world:dropThrough(object)")
  local slot = b.slotOf[object]
  if not slot and not whereIs(self, object) then
    check.fail("world:dropThrough(object): the object is not in the world, got a stranger")
  end
  if not slot or not oneway.drop(b, slot) then
    return false
  end
  rest.wake(b, slot)
  return true
end

--- Returns where to draw an object between two fixed steps (`timestep`): on the way from its last
--- position to the present one, by `alpha`.
---
--- Errors: no table.
---@param object table
---@return number x px
---@return number y px
function World:interpolate(object)
  checkSelf(self, "interpolate(object)")
  check.table(object, "object", "world:interpolate(object)")
  local b = self._bodies
  local slot = b.slotOf[object]
  if not slot or not self.timestep then
    return object.x, object.y
  end
  local k, behind = 2 * slot, 1 - self.alpha
  return object.x - (b.position[k] - b.last[k]) * behind,
    object.y - (b.position[k + 1] - b.last[k + 1]) * behind
end

---@class physics.Stats
---@field objects integer objects in the world
---@field movers integer of these, not static
---@field resting integer movers that were not computed
---@field pairs integer neighbours that may meet
---@field contacts integer contacts at the end of the step
---@field events integer contacts resolved in the step
local function newStats()
  return { objects = 0, movers = 0, resting = 0, pairs = 0, contacts = 0, events = 0 }
end

local world = {}

world.methods = World

--- Returns a new world.
function world.new(given, where)
  check.settings(given, where)
  local b = columns.new()
  b.queue, b.events, b.roster = queue.new(), events.new(), roster.new()
  local self = setmetatable({
    objects = {},
    stats = newStats(),
    alpha = 0,
    _bodies = b,
    _saved = 0,
  }, World)
  b.world = self
  settings.fill(self, given)
  return self
end

return world
