--- The public methods of a world, and the order of the stages of a step.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local begin = require(root .. ".motion.begin")
local carrier = require(root .. ".objects.carriers")
local check = require(root .. ".world.check")
local knots = require(root .. ".solver.knots")
local read = require(root .. ".objects.read")
local columns = require(root .. ".memory.columns")
local crowd = require(root .. ".solver.crowd")
local crowdLayout = require(root .. ".solver.crowdLayout")
local crush = require(root .. ".solver.crush")
local detect = require(root .. ".broadphase.pairFinder")
local drift = require(root .. ".motion.drift")
local events = require(root .. ".contacts.events")
local flight = require(root .. ".motion.flight")
local interpreted = require(root .. ".memory.jit")
local lazy = require(root .. ".memory.lazy")
local notice = require(root .. ".queries.notice")
local oneway = require(root .. ".solver.oneWay")
local separate = require(root .. ".solver.separate")
local slope = require(root .. ".solver.slope")
local predict = require(root .. ".motion.predict")
local write = require(root .. ".objects.write")
local rest = require(root .. ".sleep.islands")
local registry = require(root .. ".objects.registry")
local settings = require(root .. ".world.settings")
local solver = require(root .. ".solver.solver")
local zones = require(root .. ".motion.zones")

-- What is loaded when it is first used.
local bounds = lazy(root .. ".world.bounds")
local explain = lazy(root .. ".world.explain")
local explosion = lazy(root .. ".world.explosion")
local guard = lazy(root .. ".world.strictMode")
local hash = lazy(root .. ".state.hash")
local query = lazy(root .. ".queries.query")
local restore = lazy(root .. ".state.restore")
local slide = lazy(root .. ".queries.move")
local state = lazy(root .. ".state.save")
local draw = lazy(root .. ".world.draw")
local tiled = lazy(root .. ".maps.tiled")
local array = lazy(root .. ".maps.array")
local ldtk = lazy(root .. ".maps.ldtk")
local tileLayers = lazy(root .. ".maps.tiles")
local shift = lazy(root .. ".objects.shift")

--- An independent world: a table of groups of objects, settings as plain fields, and the steps.
--- Its settings are fields of it, too.
---@class physics.World: physics.WorldSettings
---@field objects table<string|number, any> the game's groups of objects
---@field stats physics.Stats counters of the last step
---@field alpha number share of a fixed step that is saved up, 0..1; your own loop may write it (see
---  `interpolate`)
---@field package _bodies table the columns of the simulation
---@field package _saved number s, time for which no fixed step was made yet
---@field package _restores integer how often it was put back to an earlier state
---@field package _walls table what `setBounds` has put there
local World = {}
World.__index = World

local ceil, floor, max, min = math.ceil, math.floor, math.max, math.min
local isFinite = check.isFinite

-- Longest time that one update simulates, s.
local LONGEST = 0.25
-- Shortest dt that makes a step, s: a way that the game has written, divided by less, would be no
-- usable speed.
local SHORTEST = 1e-10
-- An object must be larger than this, px; physics/world/check.lua has the exact limit.
local SMALLEST = 1e-90
-- Fraction of a fixed step that may be missing through rounding.
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

-- Calls `onStep`, which may do anything but make a step.
local function tellStep(self, dt)
  local b = self._bodies
  settings.apply(self) -- a callback may have put a value into `onStep` that cannot be called
  b.isTold = true
  local ok, result = pcall(self.onStep, dt)
  b.isTold = false
  if not ok then
    error(result, 0)
  end
end

--- Makes one step of dt seconds, stage by stage. The caller calls the callbacks afterwards, once
--- the step's time is subtracted.
local function step(self, dt)
  if self.onStep then
    tellStep(self, dt)
  end
  local b = self._bodies
  settings.apply(self)
  local now = time(self, "write", 0)
  read.run(b, self.objects)
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
  knots.run(b)
  zones.begin(b, b.awakeList, b.awakeCount)
  crowd.mark(b)
  detect.runMoved(b)
  crowdLayout.run(b)
  crush.wedgeGrown(b)
  separate.run(b)
  drift.run(b, dt)
  flight.begin(b, dt)
  now = time(self, "separate", now)
  predict.run(b, dt) -- forces, move
  now = time(self, "move", now)
  solver.run(b, dt) -- contacts, settle, friction, then sweep and hit
  drift.takeOff(b)
  now = time(self, "solve", now)
  write.run(b)
  flight.finish(b, dt)
  if b.rest then
    rest.settle(b, dt)
  end
  columns.shrink(b)
  notice.outdate(b)
  time(self, "write", now)

  local stats = self.stats
  stats.objects, stats.movers = b.count, b.moverCount
  stats.resting = b.moverCount - b.awakeCount - b.flyerCount
  stats.pairs, stats.contacts, stats.events = b.pairCount, b.contactCount, b.resolved
end

-- Makes steps of equal length, at most `maxStep` long.
local function split(self, dt)
  local steps = ceil(dt / self.maxStep - ROUNDING)
  if steps < 1 then
    steps = 1
  end
  write.forgetHits(self._bodies)
  for remaining = steps, 1, -1 do
    self._bodies.remaining = remaining
    step(self, dt / steps)
    events.tell(self._bodies)
  end
end

-- Makes as many fixed steps as fit into the saved time. A refused step uses up no time, and none of
-- a refused dt is saved. Time that an update with an error has left counts in this one.
local function stepFixed(self, dt)
  local timestep = self.timestep
  if self._saved >= timestep * (1 - ROUNDING) then
    dt = max(0, min(dt, LONGEST - self._saved))
  end
  self._bodies.remaining = max(1, floor((self._saved + dt) / timestep + ROUNDING))
  if self._saved + dt >= timestep * (1 - ROUNDING) then
    write.forgetHits(self._bodies)
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

--- Moves the world on by dt seconds: reads the game's tables, moves the objects, writes the results
--- back and calls the callbacks.
---
--- A dt above `maxStep` is split into equal steps. A dt above 0.25 s is cut to 0.25 s, so a game
--- that is too slow runs in slow motion. A dt of 0 (or below 1e-10 s) reads the tables and moves
--- nothing.
---
--- With `timestep` an update makes one step, several, or none. Code that must run once per step,
--- such as a jump buffer, belongs into `onStep`.
---
--- Errors: dt is not a number >= 0; a group, key, field or setting has a value that cannot be used
--- (nothing has changed then); it is called from inside `canCollide`; a callback raises an error.
---@param dt number s, >= 0
function World:update(dt)
  checkSelf(self, "update(dt)")
  check.number(dt, "dt", "world:update(dt)", 0)
  local b = self._bodies
  checkIdle(b, "update(dt)")
  if b.isTold then
    check.fail("world:update(dt) cannot be called from inside onStep")
  end
  if self.checked then
    guard.checkTime(self, dt)
  end
  notice.outdate(b) -- also if there is no step
  events.tell(b)
  if dt < SHORTEST then
    settings.apply(self)
    read.run(b, self.objects)
    read.giveTouching(b)
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

-- Returns the table of a group, which is made if it is missing.
local function groupFor(self, group)
  local members = self.objects[group]
  if members == nil then
    members = {}
    self.objects[group] = members
  end
  return members
end

-- Gives an object the fields that `add` promises. An object that was removed since the last update
-- still has a slot and keeps its `touching`: while it sleeps no step would write it again.
local function welcome(b, object)
  if not object.static and not object.kinematic then
    local slot = b.slotOf[object]
    local touching = slot and b.touching[slot] or read.touchingFor(b, object)
    object.vx, object.vy, object.touching = object.vx or 0, object.vy or 0, touching
    b.registry.given[object] = touching
  end
end

-- Reads an object again that was removed since the last update: the game may have changed it, also
-- in the fields that are read only once.
local function readAgain(b, object)
  local slot = b.slotOf[object]
  if slot and (object.static or b.kind[slot] == columns.STATIC) then
    read.refresh(b, slot)
  else
    notice.refresh(b, object)
  end
end

-- Puts a checked object at the end of a group. This comes last: an object that raises an error when
-- it is read or written has not been added.
local function put(self, group, object)
  local b, size = self._bodies, check.sizeToFill(object)
  if size then
    object.width, object.height = size, size
  end
  welcome(b, object)
  readAgain(b, object)
  local members = groupFor(self, group)
  members[#members + 1] = object
  b.registry.groupGiven[object] = group
  notice.tell(b)
  return object
end

-- Returns where an object is now: the table that holds it, its key there, and the name of its
-- group. (And the key again, unless it is directly in `objects`.) Looks where the object was in the
-- last step, and where it was added; nil: it is in neither place.
local function whereIs(self, object)
  local b = self._bodies
  local slot = b.slotOf[object]
  if slot then
    local members, key = registry.whereSeen(b, self.objects, slot)
    if members then
      local record = b.group[slot]
      return members, key, record.name, not record.direct and key or nil
    end
  end
  local group = b.registry.groupGiven[object]
  local members = group ~= nil and self.objects[group]
  if type(members) == "table" then
    local key = registry.find(members, object)
    if key ~= nil then
      return members, key, group, key
    end
  end
end

-- The same, but searches all groups: the game may have moved it since the last step.
local function search(self, object)
  local members, key, name = whereIs(self, object)
  if members then
    return members, key, name
  end
  for group, value in next, self.objects, nil do
    if rawequal(value, object) then
      return self.objects, group, group
    elseif type(value) == "table" and type(value.width) ~= "number" then
      key = registry.find(value, object)
      if key ~= nil then
        return value, key, group
      end
    end
  end
end

local function failMissing(call, object, name)
  local why = type(object) == "table" and " (removed, or never added)" or ""
  check.fail("world:" .. call .. ": " .. (name or "the object") .. " is not in the world" .. why)
end

local function checkObjects(self)
  if type(self.objects) ~= "table" then
    check.fail("objects must be a table of groups, got " .. check.show(self.objects))
  end
end

--- Puts an object at the end of a group and returns it. A group that does not exist is made.
---
--- It does the same as `table.insert(world.objects[group], object)`, and more. It checks the fields
--- at once and gives a dynamic object its `vx`, `vy` and `touching`. An object that was removed
--- since the last update is read again.
---
--- Errors: the group is not a string or a number; the object is not a table; a field has a value
--- that cannot be used; the object is already in the world. Nothing has changed then. (An object
--- that you put in by hand since the last update is found by the next update: "the same object
--- as".)
---@param group string|number name of the group
---@param object physics.NewObject your own table: x, y, width, height and any other fields
---@return physics.Object object the same table
function World:add(group, object)
  checkSelf(self, "add(group, object)")
  checkIdle(self._bodies, "add(group, object)")
  if type(group) == "table" and type(object) == "number" then
    check.fail(
      "world:add(group, object): the place is a part of the object, as in"
        .. ' world:add("boxes", { x = 0, y = 0, width = 16, height = 16 })'
    )
  end
  check.group(group, "world:add(group, object)")
  check.table(object, "object", "world:add(group, object)")
  checkObjects(self)
  local objects = self.objects ---@type table<any, any>
  local known = objects[group]
  local n = type(known) == "table" and #known or 0
  check.object(object, check.place(group, n + 1), check.sizeToFill(object))
  local found, _, name, key = whereIs(self, object)
  if found then
    check.fail("world:add(group, object): the object already stands at " .. check.place(name, key))
  end
  checkIsGroup(self, group, "world:add(group, object)")
  return put(self, group, object)
end

--- Takes an object out of the world, that is out of its group's table. Its contacts end with
--- `onEnd` at the next update. An object that is added again before that update has never been
--- away.
---
--- Later objects of the group move up one place, as with `table.remove`. Inside a loop go
--- backwards, `for i = #group, 1, -1 do`, or loop over the list that a query returns. A forward
--- `ipairs` over the group would skip the object after each removed one.
---
--- Errors: the object is not a table.
---@param object physics.NewObject the object to remove
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
  self._bodies.registry.groupGiven[object] = nil
  notice.tell(self._bodies)
  return true
end

--- Reads an object again, also the fields that are read only once: `static`, and all fields of a
--- static object. Call it after changing one of these by hand. Queries see the change at once.
---
--- On a kinematic object it also means "it is there now": without `refresh` an object gets to
--- the `x, y` that you write during the next step, and pushes what is in its way.
---
--- Errors: the object is not a table, or not in the world; a field has a value that cannot be used.
---@param object physics.NewObject the object that you changed
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
    read.refresh(b, slot)
  else
    check.object(object, check.place(name, members ~= self.objects and key or nil))
    notice.refresh(b, object)
  end
end

--- Lets an object fall through the one-way objects that it stands on. It passes through them until
--- it is clear of them. Until then no other one-way object holds it, so it falls through a whole
--- bridge of planks or slopes. If it also stands on something solid, it stays there, although the
--- result is true; it passes through the one-way objects when it leaves the solid one.
---
--- Errors: the object is not a table, or not in the world.
---@param object physics.NewObject the object that stands on them
---@return boolean dropped false: it stands on no one-way object
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

--- Returns what an object stands on, as the last step has left it, and how steep that is under it:
--- for a sprite that turns with the ground, `math.atan(gradient)`.
---
--- The gradient is in px along y for each px along x: -0.5 on a slope that rises to the right by 1
--- px in 2, 0 on everything that is level. Where gravity acts sideways it is px along x for each px
--- along y.
---
--- Errors: the object is not a table, or not in the world.
---@param object physics.NewObject a dynamic object
---@return physics.NewObject? ground nil: it stands on nothing
---@return number gradient
function World:ground(object)
  checkSelf(self, "ground(object)")
  local b = self._bodies
  check.table(object, "object", "world:ground(object)")
  checkObjects(self)
  if not search(self, object) then
    failMissing("ground(object)", object)
  end
  local slot = b.slotOf[object]
  local below = slot and b.support[slot] or 0
  if below == 0 then
    return nil, 0
  end
  return b.object[below], slope.gradient(b, slot, below)
end

-- State -------------------------------------------------------------------------------------------

--- What `save` returns: numbers, strings, booleans and tables of them. The format may change from
--- version to version.
---@class physics.State
---@field [string] any

--- Returns everything that a future step depends on, as a plain table that any serializer can
--- write: numbers, strings, booleans and tables, without functions, cycles and infinities. After
--- `restore` the run continues with the same bits, also in another process and on another Lua.
---
--- - Saved: the objects with the fields that the library knows, the settings that change results,
---   contacts, riders, saved-up time, and events that an error in a callback has delayed.
--- - Not saved: functions (callbacks, `canCollide`), your own fields but for those that the setting
---   `ownFields` names, and the settings `broadphase`, `cellSize`, `rest`, `checked` and
---   `ownFields`.
--- - Of a static object it is what `update` has read: call `refresh` after changing one.
---
--- A state also holds what you have written since the last step. For rollback save before you write
--- the input of a step: a late input must not find the guessed one in the state. A state that is
--- saved inside a callback holds the events that are still to come, without the current one.
---
--- Errors: a field or setting that `update` would refuse; a field of your own in `ownFields` that
--- is a function, infinite, or the like; `out` is not a table; it is called from inside
--- `canCollide`.
---@param out physics.State? a state of this world that you no longer need. It is filled again, so
---   that a steady scene makes no garbage
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

--- Makes this world what it was when the state was saved. The jump itself calls no callback.
---
--- Objects that were added since then leave their groups, removed ones come back, and all get their
--- saved fields. The tables of groups stay the same. Groups that are not in the state are emptied.
--- Your own fields are not touched, but for those that the setting `ownFields` named.
---
--- - A state of this same world, in the same table: each object is the very table that it was. Your
---   references, callbacks and own fields stay with it.
--- - A state from elsewhere (a file, the network, another world): it is applied by group and key. A
---   new plain table, without callbacks, is made for each object that is missing.
---
--- Numbered keys shift when an object is removed. So, for states from elsewhere, give an object
--- with fields or callbacks of its own a string key: `world.objects.enemies.boss = boss`. A group
--- under numbers with another count of objects than in the state is named in the result.
---
--- Events that were still to come when the state was saved are told after `restore`, also about
--- objects that have left the world. In another world such an object is a new plain table.
---
--- Errors: the value is not a state, or one of another version, or damaged; it is called from
--- inside `canCollide`. Nothing has changed then.
---@param saved physics.State what `save` returned, or a copy
---@return string? misfit nil: the state fits; else a sentence about numbered keys that may be wrong
function World:restore(saved)
  checkSelf(self, "restore(state)")
  checkIdle(self._bodies, "restore(state)")
  local misfit = restore.world(self, saved)
  self._restores = self._restores + 1
  return misfit
end

--- Returns a whole number in 0..10^14 over everything that `save` holds. It is the same on every
--- Lua. Two worlds with the same number continue in the same way (wrong once in 10^13). Use it for
--- replays, and to find the step in which two players' worlds began to differ. Your own fields
--- (`health`) are not in it: compare them beside it.
---
--- Errors: a field or setting that `update` would refuse; it is called from inside `canCollide`.
---@return number
function World:hash()
  checkSelf(self, "hash()")
  checkIdle(self._bodies, "hash()")
  local number = hash.world(self)
  return number
end

-- Returns one coordinate between two fixed steps; `now` is its value in the game's table.
local function between(b, slot, k, now, alpha)
  -- A dynamic object that the game has moved is there already; a kinematic one is on its way.
  if b.kind[slot] == columns.DYNAMIC and now ~= b.written[k] then
    return now
  end
  return b.position[k] - (b.position[k] - b.last[k]) * (1 - alpha)
end

--- Draws the world as the physics sees it (LÖVE only). Static objects are grey, kinematic ones
--- blue, dynamic ones orange (brown at rest), sensors have a green outline, inactive objects are
--- faint. The solid side of a one-way object is violet, sides that touch are light.
---
--- The colours can be seen on dark and on light ground. It draws with your transform, and leaves
--- colour, font and transform as they were. It draws at `x, y`, also with a `timestep`: what you
--- draw at `interpolate` is up to one step behind it.
---
--- Errors: an unknown option, or a wrong value for one; there is no `love.graphics`.
---@param options physics.DrawOptions? what to show
function World:draw(options)
  checkSelf(self, "draw(options)")
  draw.draw(self, options)
end

--- Returns where to draw an object between two fixed steps (`timestep`): on the way from its place
--- before the last step to its place now, by the share `world.alpha`. Returns `object.x, object.y`
--- if there is no `timestep`, and for an object that is new, static, not active, or was put
--- somewhere by the game.
---
--- A loop of your own, as for rollback, sets `timestep`, too. `world:update(world.timestep)` is
--- then exactly one step, and sets `world.alpha` to 0. After its last step the loop writes
--- `world.alpha`.
---
--- Errors: the object is not a table.
---@param object physics.NewObject the object to draw
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

-- Queries -----------------------------------------------------------------------------------------
--
-- They see the tables as they are now: objects that were added since the last update, but not
-- removed ones. They change nothing and may be called anywhere, also inside callbacks and filters.
-- In worlds of more than 128 objects the first query after an update looks at all objects, later
-- ones only nearby: see physics/queries/index.lua for what they may miss.
--
-- Inactive objects are not found; sensors are. `filter` is a group name, a list of them, or a
-- function(object) that returns yes or no; it must not change the world. `out` is a
-- list to fill instead of a new one, so that no garbage is made.

local function checkQuestion(self, call, filter, out)
  checkSelf(self, call)
  if filter ~= nil then
    check.filter(filter, "world:" .. call)
    if self.checked then
      guard.filter(self, filter, "world:" .. call)
    end
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
  -- A game may cast a thousand rays a frame: one test covers the usual case.
  if isFinite(x1) and isFinite(y1) and isFinite(x2) and isFinite(y2) then
    return
  end
  check.number(x1, "x1", where)
  check.number(y1, "y1", where)
  check.number(x2, "x2", where)
  check.number(y2, "y2", where)
end

--- Returns all objects at a point, and how many. The left and top edges of an object belong to it,
--- the right and bottom ones do not. So a point on a seam belongs to one tile.
---
--- Errors: a coordinate is not a finite number; the filter cannot be used; `out` is not a table.
---@param x number px
---@param y number px
---@param filter physics.Filter? which objects count, default all
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

--- Returns all objects that overlap a rectangle by more than 1e-6 px, and how many. With the
--- setting `sideBySide` objects that are flush with it count, too.
---
--- Errors: a number is not finite; a size is <= 0; the filter cannot be used; `out` is not a table.
---@param x number px, left edge
---@param y number px, top edge
---@param w number px, > 0
---@param h number px, > 0
---@param filter physics.Filter? which objects count, default all
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

--- Returns all objects that overlap a circle by more than 1e-6 px, and how many: those of which a
--- point is nearer to the centre than the radius. With the setting `sideBySide` objects that are
--- flush with it count, too.
--- Source: the point of a box that is nearest to the centre.
---
--- Errors: a number is not finite; the radius is <= 0; the filter cannot be used; `out` is not a
--- table.
---@param x number px, the centre
---@param y number px
---@param radius number px, > 0
---@param filter physics.Filter? which objects count, default all
---@param out physics.Object[]? list to fill, default a new one
---@return physics.Object[] objects in the order of the world
---@return integer count
function World:queryCircle(x, y, radius, filter, out)
  checkQuestion(self, "queryCircle(x, y, radius)", filter, out)
  local where = "world:queryCircle(x, y, radius)"
  checkPoint(x, y, where)
  check.positive(radius, "radius", where)
  local found, count = query.circle(self, x + 0.0, y + 0.0, radius + 0.0, filter, out)
  return found, count
end

--- Returns all objects on the line from (x1, y1) to (x2, y2), as `raycast` would hit them, and how
--- many.
---
--- Errors: a coordinate is not a finite number; the filter cannot be used; `out` is not a table.
---@param x1 number px
---@param y1 number px
---@param x2 number px
---@param y2 number px
---@param filter physics.Filter? which objects count, default all
---@param out physics.Object[]? list to fill, default a new one
---@return physics.Object[] objects nearest first, ties in the order of the world
---@return integer count
function World:querySegment(x1, y1, x2, y2, filter, out)
  checkQuestion(self, "querySegment(x1, y1, x2, y2)", filter, out)
  checkLine(x1, y1, x2, y2, "world:querySegment(x1, y1, x2, y2)")
  local found, count = query.segment(self, x1 + 0.0, y1 + 0.0, x2 + 0.0, y2 + 0.0, filter, out)
  return found, count
end

--- Returns the first object on the line from (x1, y1) to (x2, y2), and where the line hits it.
---
---     starts inside an object     hits it at fraction 0, normal 0, 0
---     starts on an edge           hits at fraction 0 with its normal if it goes in, else not
---     ends on an edge             hits at fraction 1
---     runs along an edge          hits the object that owns the edge: the one below it or to its
---                                 right, so no ray slips between two tiles (to 1e-6 px)
---     meets a corner              of one object: no hit if it only grazes it; the normal is along
---                                 gravity, or that of the wall if a neighbour covers the other one
---     has no length               hits the object that queryPoint finds, fraction 0, normal 0, 0
---
--- Source: slab method; the grid is walked in strips (see physics/broadphase/grid.lua).
---
--- Errors: a coordinate is not a finite number; the filter cannot be used.
---@param x1 number px
---@param y1 number px
---@param x2 number px
---@param y2 number px
---@param filter physics.Filter? which objects count, default all
---@return physics.Object? object nil: the line is free, and nothing else is returned
---@return number x px, where it is hit
---@return number y px
---@return number nx normal where it is hit, of length 1: -1, 0, 1 at a box
---@return number ny likewise
---@return number fraction of the line, 0..1
function World:raycast(x1, y1, x2, y2, filter)
  checkQuestion(self, "raycast(x1, y1, x2, y2)", filter)
  checkLine(x1, y1, x2, y2, "world:raycast(x1, y1, x2, y2)")
  -- (A tail call: the trace compiler would compile the code after it anew for each path.)
  ---@diagnostic disable-next-line: missing-return-value
  return query.raycast(self, x1 + 0.0, y1 + 0.0, x2 + 0.0, y2 + 0.0, filter)
end

--- Returns what would stop an object on its way by (dx, dy), and where the object would be then.
--- Nothing moves. `sweep(object, 0, -10)` answers "may it grow by 10 px upwards?".
---
--- Solid objects stop it, unless its mask, theirs or the world's says otherwise; one-way objects
--- stop it on their solid side; sensors do not. `canCollide` is not called. An object that overlaps
--- it already is hit at fraction 0 with the normal 0, 0. An object that is flush beside its way is
--- not hit.
---
--- Errors: the object is not a table, or not in the world; a distance is not a finite number; the
--- filter cannot be used.
---@param object physics.NewObject the object that would move
---@param dx number px
---@param dy number px
---@param filter physics.Filter? which objects count, default all
---@return physics.Object? other nil: the way is free, and nothing else is returned
---@return number x px, where `object` would be then, flush
---@return number y px
---@return number nx normal where it is hit, of length 1: -1, 0, 1 on a side of a box
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

--- Returns whether a box of that place and size would be free: may it stand up here, is there room
--- to appear? Solid objects are in the way, if they overlap the box by more than 1e-6 px. Sensors,
--- one-way objects and inactive objects are not.
---
--- In place of the filter you may give the object that would be there. Then it is not in its own
--- way, nor is what its mask, theirs or the world's lets it pass.
---
--- Errors: a number is not finite; a size is <= 0; the filter cannot be used, or is an object that
--- is not in the world.
---@param x number px, left edge
---@param y number px, top edge
---@param width number px, > 0
---@param height number px, > 0
---@param filter physics.Filter|physics.NewObject|nil which objects count, default all; or the
---  object that would be there
---@return boolean fits
---@return physics.Object? other what is in the way, the first in the order of the world
function World:fits(x, y, width, height, filter)
  local call, where = "fits(x, y, width, height)", "world:fits(x, y, width, height)"
  local isObject = type(filter) == "table" and type(filter.width) == "number"
  checkQuestion(self, call, not isObject and filter or nil)
  checkPoint(x, y, where)
  check.positive(width, "width", where)
  check.positive(height, "height", where)
  local w, h = width + 0.0, height + 0.0
  local other, isThere = query.blocker(self, x + 0.0, y + 0.0, w, h, filter)
  if not isThere then
    failMissing(call, filter, "the object in place of the filter")
  end
  return not other, other or nil
end

--- Returns the velocity of an object over ground. For a rider it is its own velocity and that of
--- its carrier; for a kinematic object that you move by writing `x, y` it is how fast it went in
--- the last step. Of a static object it is 0, 0.
---
--- Errors: the object is not a table, or not in the world.
---@param object physics.NewObject the object
---@return number vx px/s
---@return number vy px/s
function World:velocity(object)
  local call = "velocity(object)"
  checkQuestion(self, call)
  check.table(object, "object", "world:velocity(object)")
  checkObjects(self)
  if not search(self, object) then
    failMissing(call, object)
  end
  local slot = self._bodies.slotOf[object]
  if not slot then
    return object.static and 0 or object.vx or 0, object.static and 0 or object.vy or 0
  end
  local vx, vy = carrier.overGround(self._bodies, slot)
  return vx, vy
end

--- Returns the object nearest to a point, and its distance. Of two at the same distance it is the
--- first in the order of the world.
---
--- Errors: a number is not finite; the radius is < 0; the filter cannot be used.
---@param x number px
---@param y number px
---@param radius number px, >= 0: how far it looks
---@param filter physics.Filter? which objects count, default all
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

--- Returns all objects that overlap an object by more than 1e-6 px, and how many; masks play no
--- part. An object with a `radius` is the circle, not its square. With the setting `sideBySide`
--- objects that are flush with it count, too. An inactive object overlaps nothing.
---
--- Test the number, `count > 0`: an empty list is true in Lua. Removing objects while you loop over
--- the list is safe.
---
--- Errors: the object is not a table, or not in the world; the filter cannot be used; `out` is not
--- a table.
---@param object physics.NewObject an object of the world
---@param filter physics.Filter? which objects count, default all
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

--- Returns the side of `a` at which it is in contact with `b`. A contact lasts from `onBegin` to
--- `onEnd`, unless the game has moved the two apart since. With the setting `sideBySide` flush
--- objects are in contact.
---
--- Errors: `a` or `b` is not a table, or not in the world.
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

--- Returns a sentence that says why two objects do or do not collide. It is for debugging: the
--- words may change.
---
--- Errors: `a` or `b` is not a table.
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
---@field other physics.Object the object that was hit
---@field side physics.Side side of the object that moved
---@field x number px, where the object was then
---@field y number px
---@field nx number normal of `other`, of length 1: -1, 0, 1 where a box is hit on a side
---@field ny number likewise
---@field fraction number of the way asked for, 0..1
---@field response physics.Response how the move went on

--- Moves one object to (x, y) now, with collisions and without physics. It writes `object.x` and
--- `object.y`, pushes nothing and changes no velocity.
---
--- Static, kinematic and dynamic objects are in its way. Masks, `active` and `oneWay` hold as in a
--- step; `canCollide` is not called. The object never ends inside a solid one, unless it was inside
--- that one before: an object that it overlaps at the start is reported and crossed.
---
---     "slide"    goes on along the side that it hit (default)
---     "touch"    stays where it hit
---     "cross"    goes through
---     "bounce"   goes on mirrored
---
--- The response may be a function(object, other) that returns one of these names for each hit (nil:
--- "slide"), or false, as if `other` were not there. It must not change the world. Sensors are
--- crossed whatever the response. An inactive object moves without collisions. The move ends after
--- 64 hits.
--- Source: the responses are those of bump.lua (E. García Cota).
---
--- Errors: the object is not a table, not in the world, or static; a number is not finite; the
--- response is unknown; it is called from inside `canCollide`. Nothing has moved then.
---@param object physics.NewObject dynamic or kinematic
---@param x number px, left edge where it should go
---@param y number px, top edge
---@param response physics.Response|physics.Respond|nil default "slide"
---@param out physics.Hit[]? list of an earlier call, which is filled again
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

--- Changes the velocity of a dynamic object by the impulse divided by its mass. A speed limit of
--- the object (`maxSpeed`, `maxSpeedX`, `maxSpeedY`) cuts the new velocity in the next step.
---
--- Errors: the object is not a table, not in the world, or not dynamic; a number is not finite; its
--- `vx`, `vy` or `mass` cannot be used; it is called from inside `canCollide`.
---@param object physics.NewObject a dynamic object
---@param ix number px/s times mass, along x
---@param iy number px/s times mass, along y
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

--- Moves the whole world by (dx, dy): every object, active or not, and the tiles of its maps. No
--- callback is called, and riders, contacts and velocities stay as they are. So a level may wrap
--- around, or the player stay near the origin. Move your camera by the same way.
---
--- The coordinates are sums, so they round: choose a whole number of px. A state that was saved
--- before belongs to the old place.
---
--- Errors: a number is not finite; an object would be too far away, or has a field that cannot be
--- used (nothing has moved then); it is called from inside `canCollide`.
---@param dx number px
---@param dy number px
function World:shift(dx, dy)
  local call, where = "shift(dx, dy)", "world:shift(dx, dy)"
  checkSelf(self, call)
  checkIdle(self._bodies, call)
  check.number(dx, "dx", where)
  check.number(dy, "dy", where)
  checkObjects(self)
  shift.run(self, dx, dy)
end

--- Pushes all dynamic objects in a circle away from its centre, also sensors. At the centre an
--- object gets the whole impulse, at the rim nothing; in between it is less with the distance of
--- the nearest point of the object. The push is towards the middle of the object, or straight up
--- if that is the centre.
---
--- With `walls` only objects in sight are pushed: those that nothing of `walls` hides from the
--- centre. It is a filter as for `raycast`, for instance the name of a group. Inside a wall an
--- explosion pushes only that wall, if it is dynamic.
---
--- Errors: a number is not finite; the radius is <= 0; a filter cannot be used; `vx`, `vy` or
--- `mass` of an object cannot be used; it is called from inside `canCollide`. Nothing has changed
--- then.
---@param x number px, the centre
---@param y number px
---@param radius number px, > 0
---@param impulse number px/s times mass, at the centre; < 0: towards the centre
---@param filter physics.Filter? which objects are pushed, default all
---@param walls physics.Filter? what is in the way, default nothing
---@return physics.Object[] objects those that were pushed, in the order of the world
---@return integer count
function World:explode(x, y, radius, impulse, filter, walls)
  local call = "explode(x, y, radius, impulse)"
  local where = "world:" .. call
  checkQuestion(self, call, filter)
  checkIdle(self._bodies, call)
  checkPoint(x, y, where)
  check.positive(radius, "radius", where)
  check.number(impulse, "impulse", where)
  if walls ~= nil then
    check.filter(walls, where .. ": walls")
  end
  x, y, radius, impulse = x + 0.0, y + 0.0, radius + 0.0, impulse + 0.0
  local pushed, count = explosion.run(self, x, y, radius, impulse, filter, walls, where)
  return pushed, count
end

--- Puts four static walls around a rectangle: `top`, `bottom`, `left` and `right` of the group
--- `bounds`. You may give them `friction` and other fields before the next update. A second call
--- replaces the walls; a call without arguments removes them.
---
--- The lower wall is a floor. A level with pits needs a rectangle that is higher than the level, so
--- that the player falls out of sight. Filters and masks that name only your own walls leave
--- `bounds` out.
---
--- Errors: a number is not finite; a size is <= 0; the game uses one of these names for something
--- else; it is called from inside `canCollide`.
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
  notice.tell(self._bodies)
end

-- Maps --------------------------------------------------------------------------------------------

-- Functions of a world that layers of tiles use (physics/maps/tiles.lua).
local MAPS = { put = put, remove = World.remove }

function MAPS.check(self, where, groups)
  if self._bodies.asking then
    check.fail(where .. " cannot be called from inside canCollide")
  end
  checkObjects(self)
  for i = 1, #groups do
    checkIsGroup(self, groups[i], where)
  end
end

-- Checks a place and size. They are sums and products of a map's numbers, so they may be out of
-- range although those are not.
local function checkPlace(object, group, where)
  local isGood = isFinite(object.x) and isFinite(object.y)
  isGood = isGood and isFinite(object.width) and isFinite(object.height)
  isGood = isGood and object.radius == nil and object.area == nil -- these must fit to others
  if not (isGood and object.width > SMALLEST and object.height > SMALLEST) then
    check.object(object, where .. ": " .. check.place(group) .. "[n]")
  end
end

-- Checks whether objects can be put into these groups; their fields were checked before.
local function checkAll(self, objects, groupOf, groups, where)
  for i = 1, #groups do
    checkIsGroup(self, groups[i], where)
  end
  for i = 1, #objects do
    checkPlace(objects[i], groupOf[i], where)
  end
end

local function putAll(self, objects, groupOf)
  for i = 1, #objects do
    put(self, groupOf[i], objects[i])
  end
end

--- Adds the objects of a map of the editor Tiled, and its solid tiles, merged into few large
--- rectangles. The map is its Lua export (the table, or the path of the file), or the table that
--- STI makes of it. The map is not changed, and nothing is drawn. See docs/maps.md for all of it.
---
--- - The name of a layer is the group of its objects. Properties of an object are its fields.
---   Fields that the library knows are also taken from its tile, its layer and the layers around
---   it; the nearest one counts.
--- - `solid = true` (or `collidable`) on an object, a tile, a layer or a group of layers makes it
---   static, and `solid = false` leaves it out. The name of a layer (walls, collision, colliders,
---   solid, ground, platforms) does the same as `solid = true`, unless an option or a property says
---   otherwise. A tile is also solid if it has collision rectangles.
--- - Points are in `level.points`, lines in `level.lines`. Tile objects about which the map says
---   nothing are decoration, and not in the world.
---
--- Not supported, and listed in `unsupported` of the result: maps that are not orthogonal, objects
--- that are turned by other than quarters, polygons with other than level and upright edges,
--- ellipses that are no circles, capsules, texts, parallax, layers and tilesets that cannot be
--- read, and properties with values that cannot be used.
---
--- Errors: the map or the file does not exist; an unknown option; an option names a layer or a gid
--- that is not in the map; a layer in `solidLayers` cannot be read; a gid belongs to no tileset; a
--- part is malformed; with `strict` a property cannot be used; a group is an object; it is called
--- from inside `canCollide`. Nothing has been added then.
---@param map table|string the table that the export or STI returns, or the path of the export
---@param options physics.TiledOptions? where the map goes, and what of it is solid
---@return physics.Level level the objects that were added, counts, and what is not supported
function World:loadTiled(map, options)
  local call = "loadTiled(map, options)"
  checkSelf(self, call)
  checkIdle(self._bodies, call)
  checkObjects(self)
  local level, groupOf, groups, tiles = tiled.read(map, options)
  checkAll(self, level.objects, groupOf, groups, "world:loadTiled(map)")
  for i = 1, #groups do
    groupFor(self, groups[i])
  end
  putAll(self, level.objects, groupOf)
  for i = 1, #tiles do
    tileLayers.attach(tiles[i], self, MAPS)
  end
  return level
end

--- Adds the tiles of a plain array. Each solid cell is static. Equal cells are merged into few
--- large objects, which changes no motion. One-way cells merge only along their solid side; sensors
--- and cells that move do not merge, unless their field `merge` says so. The result can change the
--- tiles: `tiles:setTile(column, row, value)`, `tiles:load()`, `tiles:unload()`.
---
--- The cells are one list, row by row, or a list of rows (`cells[row][column]`). A row may be a
--- string (`"##..#"`): each character is a cell. For a list of rows `columns` is nil, and a short
--- row ends with empty cells. Columns and rows are counted from 1. The cells are copied, so change
--- them with `setTile`, too. Each object has the field `tile` with its `tiles`, `column`, `row`,
--- `columns`, `rows` and `value`.
---
--- Errors: the group is not a name, or is an object; the cells are not a list; a list of values
--- ends within a row; a row is longer than `columns`; a cell is not a number, string or boolean;
--- the size is missing; an unknown option, or a wrong value for one; it is called from
--- inside `canCollide`. Nothing has been added then.
---@param group string|number name of their group; the field `group` of a value has precedence
---@param cells table list of values, or list of rows
---@param columns integer? of a list of values: how many are a row; nil for a list of rows
---@param size number|number[] px, of a cell: one number, or width and height
---@param options physics.TileOptions? which values are solid, and where the tiles go
---@return physics.Tiles tiles
---@diagnostic disable-next-line: redefined-local
function World:addTiles(group, cells, columns, size, options) -- luacheck: ignore 431
  local call = "addTiles(group, cells, columns, size, options)"
  checkSelf(self, call)
  checkIdle(self._bodies, call)
  checkObjects(self)
  local tiles, objects, groupOf, later = array.read(group, cells, columns, size, options)
  checkIsGroup(self, group, "world:" .. call)
  checkAll(self, objects, groupOf, groupOf, "world:" .. call)
  groupFor(self, group)
  if not later then
    putAll(self, objects, groupOf)
  end
  tileLayers.attach(tiles, self, MAPS, later and objects)
  return tiles
end

--- Adds a level of the editor LDtk: the solid cells of its IntGrid layers, merged into few large
--- static objects, and its entities with their fields. Any JSON library decodes the project. The
--- project is not changed, and nothing is drawn. See docs/maps.md.
---
--- Cells are in the group of the identifier of their layer, entities in the group of their own
--- identifier. The fields `solid`, `group` and all fields of objects mean what they mean in a map
--- from Tiled.
---
--- Errors: the project or the level does not exist; the layers of the level are in another file; an
--- unknown option; an option names a layer or value that the level does not have; a part is
--- malformed; with `strict` a field cannot be used; a group is an object; it is called from inside
--- `canCollide`. Nothing has been added then.
---@param project table the .ldtk file, decoded by a JSON library
---@param level string|integer|table|nil its identifier, iid or number, or its decoded .ldtkl file;
---  default: the first level
---@param options physics.LDtkOptions? where the level goes, and what of it is solid
---@return physics.LDtkLevel level the objects that were added, counts, and what is not supported
function World:loadLDtk(project, level, options)
  local call = "loadLDtk(project, level, options)"
  checkSelf(self, call)
  checkIdle(self._bodies, call)
  checkObjects(self)
  local found, groupOf, tiles = ldtk.read(project, level, options)
  checkAll(self, found.objects, groupOf, groupOf, "world:" .. call)
  putAll(self, found.objects, groupOf)
  for i = 1, #tiles do
    tileLayers.attach(tiles[i], self, MAPS)
  end
  return found
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
---@field events integer contacts that were resolved in the step
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
  b.events, b.registry, b.hits = events.new(), registry.new(), write.newHits()
  b.drifts = drift.new()
  local self = setmetatable({
    objects = {},
    stats = newStats(),
    alpha = 0,
    _bodies = b,
    _saved = 0,
    _restores = 0,
    _walls = {},
  }, World)
  b.world = self
  settings.fill(self, given)
  return self
end

interpreted.always(search, World.save)

return world
