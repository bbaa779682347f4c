--- A world: its settings and the order of the steps.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local begin = require(root .. ".motion.begin")
local bounds = require(root .. ".world.bounds")
local carrier = require(root .. ".objects.carriers")
local check = require(root .. ".world.check")
local collect = require(root .. ".objects.read")
local columns = require(root .. ".memory.columns")
local crush = require(root .. ".solver.crush")
local detect = require(root .. ".broadphase.pairFinder")
local events = require(root .. ".contacts.events")
local explain = require(root .. ".world.explain")
local guard = require(root .. ".world.strictMode")
local hash = require(root .. ".state.hash")
local interpreted = require(root .. ".memory.jit")
local oneway = require(root .. ".solver.oneWay")
local part = require(root .. ".solver.separate")
local predict = require(root .. ".motion.predict")
local publish = require(root .. ".objects.write")
local query = require(root .. ".queries.query")
local rest = require(root .. ".sleep.islands")
local restore = require(root .. ".state.restore")
local roster = require(root .. ".objects.registry")
local settings = require(root .. ".world.settings")
local slide = require(root .. ".queries.move")
local solver = require(root .. ".solver.solver")
local state = require(root .. ".state.save")
local view = require(root .. ".queries.index")

--- An independent world: a table of groups of objects, settings as plain fields, and the steps.
--- Its settings are fields of it, too.
---@class physics.World: physics.WorldSettings
---@field objects table<string|number, any> the game's groups of objects
---@field stats physics.Stats counters of the last step
---@field alpha number share of a fixed step that is saved up, 0..1
---@field package _bodies table the columns of the simulation
---@field package _saved number s, time for which no fixed step was made yet
---@field package _walls table what `setBounds` has put there
local World = {}
World.__index = World

local ceil, floor, max, min = math.ceil, math.floor, math.max, math.min
local isFinite = check.isFinite

-- Longest time that one update makes up for, s.
local LONGEST = 0.25
-- A way that the game has written, divided by less time than that, would be no speed any more, s.
local SHORTEST = 1e-10
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

-- Notes how long a stage has taken, if there is a clock. Returns the time now.
local function time(self, name, since)
  local times = self.stats.times
  if not times then
    return 0
  end
  local now = self.profile()
  now = type(now) == "number" and now or since
  times[name] = now - since
  return now
end

-- Lets the game act before a step. It may do anything but step again.
local function tellStep(self, dt)
  local b = self._bodies
  settings.apply(self) -- a callback may have spoilt `onStep`
  b.isTold = true
  local ok, result = pcall(self.onStep, dt)
  b.isTold = false
  if not ok then
    error(result, 0)
  end
end

--- One step of dt seconds: the building of this library, room by room. Its events are told by the
--- caller, once the time of the step is booked.
local function step(self, dt)
  if self.onStep then
    tellStep(self, dt)
  end
  local b = self._bodies
  settings.apply(self)
  local now = time(self, "write", 0)
  collect.run(b, self.objects)
  if self.checked then
    guard.run(self)
  end
  carrier.dismount(b)
  if dt < rest.SHORTEST then
    rest.wakeAll(b)
  end
  now = time(self, "read", now)

  b.begun, b.predicted, b.rubs, b.dt = 0, 0, 0, dt
  begin.run(b)
  detect.runMoved(b)
  crush.wedgeGrown(b)
  part.run(b)
  now = time(self, "separate", now)
  predict.run(b, dt) -- forces, move
  now = time(self, "move", now)
  solver.run(b, dt) -- contacts, settle, friction, then sweep and hit
  now = time(self, "solve", now)
  publish.run(b)
  if b.rest then
    rest.settle(b, dt)
  end
  view.outdate(b)
  time(self, "write", now)

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
  publish.forgetHits(self._bodies)
  for remaining = steps, 1, -1 do
    self._bodies.remaining = remaining
    step(self, dt / steps)
    events.tell(self._bodies)
  end
end

-- As many fixed steps as fit into what is saved up. A refused step has used up no time, and none of
-- a refused dt is saved. What an update that failed on its way has left counts as part of this one.
local function stepFixed(self, dt)
  local timestep = self.timestep
  if self._saved >= timestep * (1 - ROUNDING) then
    dt = max(0, min(dt, LONGEST - self._saved))
  end
  self._bodies.remaining = max(1, floor((self._saved + dt) / timestep + ROUNDING))
  if self._saved + dt >= timestep * (1 - ROUNDING) then
    publish.forgetHits(self._bodies)
  end
  while self._saved + dt >= timestep * (1 - ROUNDING) do
    begin.keepPlaces(self._bodies)
    step(self, timestep)
    self._saved, dt = self._saved + dt - timestep, 0
    self._bodies.remaining = max(1, self._bodies.remaining - 1)
    events.tell(self._bodies)
  end
  self._saved = self._saved + dt
  local alpha = self._saved / timestep
  self.alpha = alpha > 0 and alpha or 0
end

--- Moves the world on by dt seconds: collects the game's tables, moves and bumps what is in them,
--- writes the results back and tells the events. More than `maxStep` is split into equal steps,
--- more than 0.25 s is cut to that; 0, or less than 1e-10 s, reads the tables and moves nothing.
---
--- Errors: dt is no number >= 0; a group, key, field or setting that cannot be used (nothing has
--- changed then); called from inside `canCollide`; whatever a callback raises.
---@param dt number s, >= 0
function World:update(dt)
  checkSelf(self, "update(dt)")
  check.number(dt, "dt", "world:update(dt)", 0)
  local b = self._bodies
  checkIdle(b, "update(dt)")
  if b.isTold then
    check.fail("world:update(dt) cannot be called from inside onStep")
  end
  view.outdate(b) -- also if there is no step
  events.tell(b)
  if dt < SHORTEST then
    settings.apply(self)
    collect.run(b, self.objects)
    collect.giveTouching(b)
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

local function checkIsGroup(self, group, where)
  local members = self.objects[group]
  if members ~= nil and (type(members) ~= "table" or type(members.width) == "number") then
    check.fail(
      where
        .. ": "
        .. check.place(group)
        .. " is not a group, got "
        .. (type(members) == "table" and "an object" or check.show(members))
    )
  end
end

-- The table of a group that is one, or is not there yet.
local function groupFor(self, group)
  local members = self.objects[group]
  if members == nil then
    members = {}
    self.objects[group] = members
  end
  return members
end

-- What an object has at once that comes through `add`. One that was taken out since the last update
-- is in there still, and keeps what it touches: while it rests nobody would tell it anew.
local function welcome(b, object)
  if not object.static and not object.kinematic then
    local slot = b.slotOf[object]
    local touching = slot and b.touching[slot] or collect.touchingFor(b, object)
    object.vx, object.vy, object.touching = object.vx or 0, object.vy or 0, touching
    b.roster.given[object] = touching
  end
end

-- One that was taken out since the last update may have been changed meanwhile, also in what is
-- read only once.
local function readAgain(b, object)
  local slot = b.slotOf[object]
  if slot and (object.static or b.kind[slot] == columns.STATIC) then
    collect.refresh(b, slot)
  else
    view.refresh(b, object)
  end
end

-- Puts an object that was checked at the end of a group: last of all, so that one that fails when
-- it is written to, or read, has not come in.
local function put(self, group, object)
  local b = self._bodies
  welcome(b, object)
  readAgain(b, object)
  local members = groupFor(self, group)
  members[#members + 1] = object
  b.roster.groupGiven[object] = group
  view.tell(b)
  return object
end

-- Where an object stands now: the table that holds it, its key in there, and the name of its group
-- (and the key again if it does not stand directly in `objects`). Looks where it was last and where
-- it was added; nil: not there.
local function whereIs(self, object)
  local b = self._bodies
  local slot = b.slotOf[object]
  if slot then
    local members, key = roster.whereSeen(b, self.objects, slot)
    if members then
      local record = b.group[slot]
      return members, key, record.name, not record.direct and key or nil
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

-- The same, but looks everywhere: the game may have put it elsewhere since the last step.
local function search(self, object)
  local members, key, name = whereIs(self, object)
  if members then
    return members, key, name
  end
  for group, value in next, self.objects, nil do
    if rawequal(value, object) then
      return self.objects, group, group
    elseif type(value) == "table" and type(value.width) ~= "number" then
      key = roster.find(value, object)
      if key ~= nil then
        return value, key, group
      end
    end
  end
end

local function failMissing(call, object, name)
  name = name or "the object"
  check.fail("world:" .. call .. ": " .. name .. " is not in the world, got " .. check.show(object))
end

local function checkObjects(self)
  if type(self.objects) ~= "table" then
    check.fail("objects must be a table of groups, got " .. check.show(self.objects))
  end
end

--- Puts an object at the end of a group, which is made if it is not there. The same as
--- `table.insert(world.objects[group], object)`, but it checks the fields at once, gives the object
--- its `touching`, and reads one anew that was taken out since the last update, also a static one.
---
--- Errors: a group that is no name; no table; a field that cannot be used; an object that already
--- stands in the world. Nothing has changed then. (One that was put in by hand since the last
--- update is only found by the next one: an object in two places.)
---@param group string|number name of the group
---@param object physics.NewObject the game's own table: x, y, width, height and whatever else
---@return physics.Object object the same table
function World:add(group, object)
  checkSelf(self, "add(group, object)")
  checkIdle(self._bodies, "add(group, object)")
  check.group(group, "world:add(group, object)")
  check.table(object, "object", "world:add(group, object)")
  checkObjects(self)
  local known = self.objects[group]
  local n = type(known) == "table" and #known or 0
  check.object(object, check.place(group, n + 1))
  local found, _, name, key = whereIs(self, object)
  if found then
    check.fail("world:add(group, object): the object already stands at " .. check.place(name, key))
  end
  checkIsGroup(self, group, "world:add(group, object)")
  return put(self, group, object)
end

--- Takes an object out of the world, out of its group's table. Its contacts end with `onEnd` at the
--- next update.
---
--- Errors: no table.
---@param object physics.NewObject who is to go
---@return boolean removed false: it was not in the world
function World:remove(object)
  checkSelf(self, "remove(object)")
  checkIdle(self._bodies, "remove(object)")
  check.table(object, "object", "world:remove(object)")
  checkObjects(self)
  local members, key = search(self, object)
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
  view.tell(self._bodies)
  return true
end

--- Reads an object anew, also the fields that are read only once: `static`, and everything of a
--- static object. Also tells later questions that it has gone far away.
---
--- Errors: no table; an object that is not in the world; a field that cannot be used.
---@param object physics.NewObject who was changed
function World:refresh(object)
  checkSelf(self, "refresh(object)")
  local b = self._bodies
  checkIdle(b, "refresh(object)")
  check.table(object, "object", "world:refresh(object)")
  checkObjects(self)
  local members, key, name = search(self, object)
  if not members then
    failMissing("refresh(object)", object)
  end
  local slot = b.slotOf[object]
  if slot then
    collect.refresh(b, slot)
  else
    check.object(object, check.place(name, members ~= self.objects and key or nil))
    view.refresh(b, object)
  end
end

--- Lets an object fall through the one-way objects it stands on. It passes them until it is clear
--- of them, also if something else holds it up until then.
---
--- Errors: no table; an object that is not in the world.
---@param object physics.NewObject who stands there
---@return boolean dropped false: it stands on none
function World:dropThrough(object)
  checkSelf(self, "dropThrough(object)")
  local b = self._bodies
  checkIdle(b, "dropThrough(object)")
  check.table(object, "object", "world:dropThrough(object)")
  checkObjects(self)
  if not search(self, object) then
    failMissing("dropThrough(object)", object)
  end
  local slot = b.slotOf[object]
  if not slot or not oneway.drop(b, slot) then
    return false
  end
  rest.wake(b, slot)
  return true
end

-- State -------------------------------------------------------------------------------------------

--- What `save` returns: numbers, strings, booleans and tables of them. Its inside may change from
--- version to version.
---@class physics.State
---@field [string] any

--- Returns all that a future step depends on, as a plain table of numbers, strings, booleans and
--- tables that any serializer can write: no functions, no cycles, no infinities. Restored, the run
--- goes on to the bit, also in another process and on another Lua. Saving changes nothing.
---
--- It holds the objects with the fields that the library knows, the settings that change results,
--- contacts, riders, saved-up time, and events that a failed callback has left behind. It does not
--- hold functions (callbacks, `canCollide`), fields of the game's own, `broadphase`, `cellSize`,
--- `rest` and `checked`.
---
--- The best place is right before `update`, when the input of the step has been written. Inside a
--- callback it holds what is still to be told; the event that is being told counts as told.
---
--- Errors: something that `update` would refuse; called from inside `canCollide`; no table.
---@param out physics.State? a state of this world that is not needed any more, to be filled anew:
---  in a steady scene nothing is left to the garbage collector then
---@return physics.State state
function World:save(out)
  checkSelf(self, "save()")
  checkIdle(self._bodies, "save()")
  if out ~= nil then
    check.table(out, "out", "world:save(out)")
    if next(out) ~= nil and rawget(out, "version") == nil then
      check.fail("world:save(out): out must be an earlier state or empty, got another table")
    end
  end
  local saved = state.save(self, out)
  return saved
end

--- Makes this world what it was when the state was saved. No event is told for the jump itself.
---
--- Objects that have been added since leave their groups, those that have left come back, all get
--- their fields again. If this world has saved the state itself, and it is still the same table,
--- they are the very tables that they were, so the game's references, callbacks and own fields stay
--- with them. A state from elsewhere (a file, the network, another world) goes to whoever stands
--- under the same group and key, and to new plain tables where nobody does. The tables of groups
--- stay the same; groups that are not in the state are emptied. Fields of the game's own are not
--- touched.
---
--- Whoever had left the world, and of whom events were still to be told, is told of as before: in
--- this world as the table that it was, elsewhere as a new one with the fields that the library
--- knows, and without callbacks of its own.
---
--- Errors: no state, one of another version, or one that is damaged; called from inside
--- `canCollide`. Nothing has changed then.
---@param saved physics.State what `save` returned, or a copy
function World:restore(saved)
  checkSelf(self, "restore(state)")
  checkIdle(self._bodies, "restore(state)")
  restore.world(self, saved)
end

--- Returns a number over all that `save` holds, a whole one in 0..10^14, the same on every Lua: two
--- worlds with the same number go on the same (to one in 10^13). For replays and for finding out
--- when two players' worlds have parted.
---
--- Errors: something that `update` would refuse; called from inside `canCollide`.
---@return number
function World:hash()
  checkSelf(self, "hash()")
  checkIdle(self._bodies, "hash()")
  local number = hash.world(self)
  return number
end

-- One coordinate between two fixed steps; `now` is what the game's table says.
local function between(b, slot, k, now, alpha)
  -- Where the game has put a dynamic object, there it is; a kinematic one goes there.
  if b.kind[slot] == columns.DYNAMIC and now ~= b.written[k] then
    return now
  end
  return b.position[k] - (b.position[k] - b.last[k]) * (1 - alpha)
end

--- Draws the world as the physics sees it (LÖVE only): static grey, kinematic blue, dynamic orange
--- (brown at rest), sensors as a green outline, inactive ones faintly, the solid side of one-way
--- objects violet, sides that touch light. It can be seen on dark and on light ground. Uses the
--- caller's transform; leaves colour, font and transform as they were.
---
--- Errors: an unknown option, or a wrong value for one.
---@param options physics.DrawOptions? what to show
function World:draw(options)
  checkSelf(self, "draw(options)")
  require(root .. ".world.draw").draw(self, options)
end

--- Returns where to draw an object between two fixed steps (`timestep`): on the way from where it
--- was before the last step to where it is now, by `alpha`. Who is new, static, not active, or was
--- put somewhere by the game is drawn where it is; without `timestep` everybody is.
---
--- Errors: no table.
---@param object physics.NewObject who is to be drawn
---@return number x px
---@return number y px
function World:interpolate(object)
  checkSelf(self, "interpolate(object)")
  check.table(object, "object", "world:interpolate(object)")
  local b = self._bodies
  local slot = b.slotOf[object]
  if not slot or not self.timestep or not b.active[slot] or b.kind[slot] == columns.STATIC then
    return object.x, object.y
  end
  local k = 2 * slot
  return between(b, slot, k, object.x, self.alpha), between(b, slot, k + 1, object.y, self.alpha)
end

-- Questions ---------------------------------------------------------------------------------------
--
-- They see the tables as they are now, objects added since the last update included, removed ones
-- not; they change nothing, and may be asked anywhere, also inside callbacks and filters. In worlds
-- of more than 128 objects the first question after an update looks at everybody, later ones only
-- nearby: see physics/view.lua for what they may miss.
--
-- Who is not active is not found; sensors are. `filter` is a group name, a list of them, or a
-- function(object) whose result is taken as yes or no; it must not change the world. `out` is a
-- list to fill instead of a new one; then nothing is left to the garbage collector.

local function checkQuestion(self, call, filter, out)
  checkSelf(self, call)
  if filter ~= nil then
    check.filter(filter, "world:" .. call)
  end
  if out ~= nil and type(out) ~= "table" then
    check.table(out, "out", "world:" .. call)
  end
  if type(self.sideBySide) ~= "boolean" then
    check.setting("sideBySide", self.sideBySide)
  end
  if self.masks then
    check.setting("masks", self.masks)
  end
end

local function checkPoint(x, y, where)
  check.number(x, "x", where)
  check.number(y, "y", where)
end

local function checkLine(x1, y1, x2, y2, where)
  -- A game may ask for a thousand lines a frame: one test for all that is as it should be.
  if isFinite(x1) and isFinite(y1) and isFinite(x2) and isFinite(y2) then
    return
  end
  check.number(x1, "x1", where)
  check.number(y1, "y1", where)
  check.number(x2, "x2", where)
  check.number(y2, "y2", where)
end

--- Finds everybody at a point. The left and top edges of an object belong to it, the right and
--- bottom ones do not, so a point on a seam belongs to one tile.
---
--- Errors: no finite number; no filter; `out` is no table.
---@param x number px
---@param y number px
---@param filter physics.Filter? default everybody
---@param out physics.Object[]? list to fill, default a new one
---@return physics.Object[] objects in the order of the world
---@return integer count
function World:queryPoint(x, y, filter, out)
  local call = "queryPoint(x, y)"
  checkQuestion(self, call, filter, out)
  checkPoint(x, y, "world:queryPoint(x, y)")
  local found, count = query.point(self, x + 0.0, y + 0.0, filter, out)
  return found, count
end

--- Finds everybody who overlaps a rectangle by more than 1e-6 px; with the setting `sideBySide`
--- also who is flush with it.
---
--- Errors: no finite number; a size <= 0; no filter; `out` is no table.
---@param x number px, left edge
---@param y number px, top edge
---@param w number px, > 0
---@param h number px, > 0
---@param filter physics.Filter? default everybody
---@param out physics.Object[]? list to fill, default a new one
---@return physics.Object[] objects in the order of the world
---@return integer count
function World:queryRect(x, y, w, h, filter, out)
  checkQuestion(self, "queryRect(x, y, w, h)", filter, out)
  local where = "world:queryRect(x, y, w, h)"
  checkPoint(x, y, where)
  check.positive(w, "w", where)
  check.positive(h, "h", where)
  local found, count = query.rectangle(self, x + 0.0, y + 0.0, w + 0.0, h + 0.0, filter, out)
  return found, count
end

--- Finds everybody on the line from (x1, y1) to (x2, y2), as `raycast` would hit them.
---
--- Errors: no finite number; no filter; `out` is no table.
---@param x1 number px
---@param y1 number px
---@param x2 number px
---@param y2 number px
---@param filter physics.Filter? default everybody
---@param out physics.Object[]? list to fill, default a new one
---@return physics.Object[] objects nearest first, ties in the order of the world
---@return integer count
function World:querySegment(x1, y1, x2, y2, filter, out)
  checkQuestion(self, "querySegment(x1, y1, x2, y2)", filter, out)
  checkLine(x1, y1, x2, y2, "world:querySegment(x1, y1, x2, y2)")
  local found, count = query.segment(self, x1 + 0.0, y1 + 0.0, x2 + 0.0, y2 + 0.0, filter, out)
  return found, count
end

--- Finds the first object on the line from (x1, y1) to (x2, y2).
---
---     starts inside an object     hits it at fraction 0, normal 0, 0
---     starts on an edge           hits at fraction 0 with its normal if it goes in, else not
---     ends on an edge             hits at fraction 1
---     runs along an edge          hits whom the edge belongs to: the one below it or to its right,
---                                 so no ray slips between two tiles (to a millionth of a pixel)
---     meets a corner              of one object: no hit if it only grazes it; the normal is along
---                                 gravity, or that of the wall if a neighbour covers the other one
---     has no length               hits who is there, as queryPoint, fraction 0, normal 0, 0
---
--- Source: slab method; the grid is walked in strips (see physics/broadphase/grid.lua).
---
--- Errors: no finite number; no filter.
---@param x1 number px
---@param y1 number px
---@param x2 number px
---@param y2 number px
---@param filter physics.Filter? default everybody
---@return physics.Object? object nil: the line is free, and nothing else is returned
---@return number x px, where it is hit
---@return number y px
---@return number nx normal of the side that is hit: -1, 0, 1
---@return number ny likewise
---@return number fraction of the line, 0..1
function World:raycast(x1, y1, x2, y2, filter)
  checkQuestion(self, "raycast(x1, y1, x2, y2)", filter)
  checkLine(x1, y1, x2, y2, "world:raycast(x1, y1, x2, y2)")
  -- (A tail call: what is done with the answer is compiled anew for each way to get there.)
  ---@diagnostic disable-next-line: missing-return-value
  return query.raycast(self, x1 + 0.0, y1 + 0.0, x2 + 0.0, y2 + 0.0, filter)
end

--- Finds what would stop an object on its way by (dx, dy): solids that its mask, theirs and the
--- world's do not let pass, one-ways on their solid side; not sensors. `canCollide` is not asked.
--- Who overlaps it already is hit at fraction 0 with the normal 0, 0; who is flush beside its way
--- is not. Nothing moves.
---
--- Errors: no table; an object that is not in the world; no finite number; no filter.
---@param object physics.NewObject who would move
---@param dx number px
---@param dy number px
---@param filter physics.Filter? default everybody
---@return physics.Object? other nil: the way is free, and nothing else is returned
---@return number x px, where `object` would be then, flush
---@return number y px
---@return number nx normal of the side that is hit: -1, 0, 1
---@return number ny likewise
---@return number fraction of the way, 0..1
function World:sweep(object, dx, dy, filter)
  local where = "world:sweep(object, dx, dy)"
  checkQuestion(self, "sweep(object, dx, dy)", filter)
  check.table(object, "object", where)
  check.number(dx, "dx", where)
  check.number(dy, "dy", where)
  local other, x, y, nx, ny, fraction = query.sweep(self, object, dx + 0.0, dy + 0.0, filter)
  if other then
    return other, x, y, nx, ny, fraction
  elseif x == false then
    failMissing("sweep(object, dx, dy)", object)
  end
end ---@diagnostic disable-line: missing-return

--- Finds the object nearest to a point; ties in the order of the world.
---
--- Errors: no finite number; a radius < 0; no filter.
---@param x number px
---@param y number px
---@param radius number px, >= 0: how far it looks
---@param filter physics.Filter? default everybody
---@return physics.Object? object nil: there is none
---@return number distance px, from the point to the edge, 0: inside
function World:nearest(x, y, radius, filter)
  local where = "world:nearest(x, y, radius)"
  checkQuestion(self, "nearest(x, y, radius)", filter)
  checkPoint(x, y, where)
  check.number(radius, "radius", where, 0)
  local object, distance = query.nearest(self, x + 0.0, y + 0.0, radius + 0.0, filter)
  if object then
    return object, distance
  end
end ---@diagnostic disable-line: missing-return

--- Finds everybody who overlaps an object by more than 1e-6 px, whatever the masks say; with the
--- setting `sideBySide` also who is flush with it. An object that is not active overlaps nobody.
---
--- Errors: no table; an object that is not in the world; no filter; `out` is no table.
---@param object physics.NewObject one of the world
---@param filter physics.Filter? default everybody
---@param out physics.Object[]? list to fill, default a new one
---@return physics.Object[] objects in the order of the world, without `object`
---@return integer count
function World:overlapping(object, filter, out)
  checkQuestion(self, "overlapping(object)", filter, out)
  check.table(object, "object", "world:overlapping(object)")
  local found, count = query.overlapping(self, object, filter, out)
  if not found then
    failMissing("overlapping(object)", object)
  end
  return found, count
end

--- Returns the side of `a` at which it is in contact with `b`: the contact of which `onBegin` told
--- and `onEnd` has not, unless the game has taken the two apart since. With the setting
--- `sideBySide` who is flush is in contact.
---
--- Errors: no table; an object that is not in the world.
---@param a physics.NewObject one of the two
---@param b physics.NewObject the other one
---@return physics.Side? side of `a`, nil: no contact
function World:touching(a, b)
  checkQuestion(self, "touching(a, b)")
  check.table(a, "a", "world:touching(a, b)")
  check.table(b, "b", "world:touching(a, b)")
  local side, missing = explain.touching(self, a, b)
  if missing then
    failMissing("touching(a, b)", missing == "a" and a or b, missing)
  end
  return side
end

--- Says in one sentence why two objects do or do not collide: for debugging, its words may change.
---
--- Errors: no table.
---@param a physics.NewObject one of the two
---@param b physics.NewObject the other one
---@return string sentence
function World:explain(a, b)
  checkQuestion(self, "explain(a, b)")
  check.table(a, "a", "world:explain(a, b)")
  check.table(b, "b", "world:explain(a, b)")
  local sentence = explain.run(self, a, b)
  return sentence
end

-- Moving by hand ----------------------------------------------------------------------------------

---@alias physics.Filter string|number|(string|number)[]|fun(object: physics.Object): any
---@alias physics.Response "slide"|"touch"|"cross"|"bounce"
---@alias physics.Responses physics.Response|false|nil
---@alias physics.Respond fun(object: physics.Object, other: physics.Object): physics.Responses
---@class physics.Hit
---@field other physics.Object who was met
---@field side physics.Side side of the object that moved
---@field x number px, where the object was then
---@field y number px
---@field nx number normal of the side of `other`: -1, 0, 1
---@field ny number likewise
---@field fraction number of the way asked for, 0..1
---@field response physics.Response what came of it

--- Moves one object to (x, y) now, with collisions and without physics: it writes `object.x` and
--- `object.y`, pushes nobody and changes no velocity. Any kind of object is in its way; masks,
--- `active` and `oneWay` hold as in a step, `canCollide` is not asked. It never ends inside a
--- solid, unless it was inside that one before: who overlaps it from the beginning is reported and
--- crossed.
---
---     "slide"    goes on along the side that it hit (default)
---     "touch"    stays where it hit
---     "cross"    goes through
---     "bounce"   goes on mirrored
---
--- Sensors are crossed whatever the response. A function(object, other) says for each hit one of
--- these names (nil: "slide"), or false: `other` is not there; it must not change the world.
--- An object that is not active moves without any collision. After 64 hits the way ends.
--- Source: the responses are those of bump.lua (E. García Cota).
---
--- Errors: no table; an object that is not in the world; a static one; no finite number; an unknown
--- response; called from inside `canCollide`. Nothing has moved then.
---@param object physics.NewObject dynamic or kinematic
---@param x number px, left edge where it should go
---@param y number px, top edge
---@param response physics.Response|physics.Respond|nil default "slide"
---@param out physics.Hit[]? list of an earlier call, to be filled anew
---@return number x px, where it is now
---@return number y px
---@return physics.Hit[] hits in the order in which they happened
---@return integer count
function World:move(object, x, y, response, out)
  local call, where = "move(object, x, y)", "world:move(object, x, y)"
  checkQuestion(self, call, nil, out)
  checkIdle(self._bodies, call)
  check.table(object, "object", where)
  checkPoint(x, y, where)
  slide.check(response, where)
  local atX, atY, hits, count = slide.run(self, object, x, y, response, out, where)
  if atX == nil then
    failMissing(call, object)
  elseif atX == false then
    check.fail(where .. ": object must not be static (write x, y and call world:refresh(object))")
  end
  return atX, atY, hits, count
end

local PUSHED = { "vx", "vy", "mass" }

--- Pushes a dynamic object: its velocity changes by the impulse divided by its mass.
---
--- Errors: no table; an object that is not in the world, or not dynamic; no finite number; a field
--- that cannot be used; called from inside `canCollide`.
---@param object physics.NewObject a dynamic one
---@param ix number px/s times mass
---@param iy number likewise
function World:impulse(object, ix, iy)
  local call, where = "impulse(object, ix, iy)", "world:impulse(object, ix, iy)"
  checkSelf(self, call)
  checkIdle(self._bodies, call)
  check.table(object, "object", where)
  check.number(ix, "ix", where)
  check.number(iy, "iy", where)
  checkObjects(self)
  if not search(self, object) then
    failMissing(call, object)
  elseif object.static or object.kinematic then
    local kind = object.static and "static" or "kinematic"
    check.fail(where .. ": object must be dynamic, got a " .. kind .. " one")
  end
  check.fields(object, where .. ": object", PUSHED)
  local mass = object.mass or 1
  local vx, vy = (object.vx or 0) + ix / mass, (object.vy or 0) + iy / mass
  check.number(vx, "vx after it", where)
  check.number(vy, "vy after it", where)
  object.vx, object.vy = vx, vy
end

--- Puts four static walls around a rectangle, the group `bounds` (`objects.bounds.top`, `.bottom`,
--- `.left`, `.right`; they may be given `friction` and so on before the next update). Called again,
--- it replaces them; without arguments it takes them away.
---
--- Errors: no finite number; a size <= 0; the game has put something else under one of these names;
--- called from inside `canCollide`.
---@param x number? px, inner left edge; nil: no bounds
---@param y number? px, inner top edge
---@param w number? px, > 0
---@param h number? px, > 0
function World:setBounds(x, y, w, h)
  local call, where = "setBounds(x, y, w, h)", "world:setBounds(x, y, w, h)"
  checkSelf(self, call)
  checkIdle(self._bodies, call)
  if x ~= nil or y ~= nil or w ~= nil or h ~= nil then
    checkPoint(x, y, where)
    check.positive(w, "w", where)
    check.positive(h, "h", where)
  end
  self._walls = bounds.set(self.objects, self._walls, x, y, w, h)
  view.tell(self._bodies)
end

--- Adds what stands in a map of the editor Tiled: its rectangles and tile objects, and its solid
--- tiles, merged into few large rectangles. The map is its Lua export (the table, or the path of
--- the file) or the table that STI makes of it; it is not changed, and nothing is drawn.
---
--- The name of a layer is the group of its objects. Properties of an object are its fields; those
--- that the library knows are also taken from its tile, its layer and the layers around it, the
--- nearest first. Three properties are for the loader: `solid`, `merge`, and `group`, which is used
--- instead of the layer's name. A tile is solid if it or its layer says so, or if it has collision
--- rectangles, and neither says `solid = false`, which takes objects out, too. A layer that says
--- nothing says what the nearest one around it does. An option counts as a yes instead of the own
--- word: `solidTiles` of a tile (not for tile objects), `solidLayers` of a layer. Solid tiles are
--- static unless they say otherwise. Static ones that are equal and no sensors become one; merging
--- changes no motion.
---
--- Not supported, and named in `unsupported` of what is returned: maps that are not orthogonal,
--- rotated objects, polygons, ellipses, points and texts, encoded layer data, parallax, tilesets
--- that are not embedded in the export.
---
--- Errors: no map, no such file; an unknown option; a layer or gid in an option that is not in the
--- map; a gid of no tileset; a property that is a field and cannot be used; a group that is an
--- object; called from inside `canCollide`. Nothing has been added then.
---@param map table|string what the export returns, what STI returns, or the path of the export
---@param options physics.TiledOptions? where the map goes, and which of its tiles are solid
---@return physics.Level level the objects that were added, counts, and what is not supported
function World:loadTiled(map, options)
  local call = "loadTiled(map, options)"
  checkSelf(self, call)
  checkIdle(self._bodies, call)
  checkObjects(self)
  local level, groupOf, groups = require(root .. ".tiled").read(map, options)
  for i = 1, #groups do
    checkIsGroup(self, groups[i], "world:loadTiled(map)")
  end
  for i = 1, #groups do
    groupFor(self, groups[i])
  end
  for i = 1, #level.objects do
    put(self, groupOf[i], level.objects[i])
  end
  return level
end

--- How long the stages of the last step have taken, in s: see the setting `profile`.
---@class physics.Times
---@field read number reading the game's tables
---@field separate number finding neighbours and parting what overlaps
---@field move number gravity, engines, drag, limits
---@field solve number contacts, friction and impacts
---@field write number writing the tables, noting events, putting to sleep

---@class physics.Stats
---@field objects integer objects in the world
---@field movers integer of these, not static
---@field resting integer movers that rest when the step is over
---@field pairs integer neighbours that may meet
---@field contacts integer contacts at the end of the step
---@field events integer contacts resolved in the step
---@field times physics.Times? how long the stages have taken, if `profile` is a clock
local function newStats()
  return { objects = 0, movers = 0, resting = 0, pairs = 0, contacts = 0, events = 0 }
end

local world = {}

world.methods = World

--- Returns a new world.
function world.new(given, where)
  check.settings(given, where)
  local b = columns.new()
  solver.adopt(b)
  b.events, b.roster, b.hits = events.new(), roster.new(), publish.newHits()
  local self = setmetatable({
    objects = {},
    stats = newStats(),
    alpha = 0,
    _bodies = b,
    _saved = 0,
    _walls = {},
  }, World)
  b.world = self
  settings.fill(self, given)
  return self
end

interpreted.always(search, World.save)

return world
