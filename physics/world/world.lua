--- Worlds: `update`, states, drawing, and how a world is made. The other methods are in
--- objectMethods.lua, queryMethods.lua and mapMethods.lua.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".world.check")
local class = require(root .. ".world.class")
local columns = require(root .. ".memory.columns")
local events = require(root .. ".contacts.events")
local interpreted = require(root .. ".memory.jit")
local lazy = require(root .. ".memory.lazy")
local notice = require(root .. ".queries.notice")
local read = require(root .. ".objects.read")
local registry = require(root .. ".objects.registry")
local settings = require(root .. ".world.settings")
local solver = require(root .. ".solver.solver")
local steps = require(root .. ".world.step")
local write = require(root .. ".objects.write")

require(root .. ".world.objectMethods")
require(root .. ".world.queryMethods")
require(root .. ".world.mapMethods")

-- What is loaded when it is first used.
local draw = lazy(root .. ".world.draw")
local guard = lazy(root .. ".world.strictMode")
local hash = lazy(root .. ".state.hash")
local restore = lazy(root .. ".state.restore")
local state = lazy(root .. ".state.save")

---@class (partial) physics.World
local World = class.World

local checkCall, checkSelf = class.checkCall, class.checkSelf

-- Shortest dt that makes a step, s: a way that the game has written, divided by less, would be no
-- usable speed.
local SHORTEST = 1e-10

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
  local where = "world:update(dt)"
  checkSelf(self, where)
  check.number(dt, "dt", where, 0)
  local b = self._bodies
  checkCall(self, where)
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
  steps.run(self, dt)
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
  checkCall(self, "world:save()")
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
  checkCall(self, "world:restore(state)")
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
  checkCall(self, "world:hash()")
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
  checkSelf(self, "world:draw(options)")
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
  local where = "world:interpolate(object)"
  checkSelf(self, where)
  check.table(object, "object", where)
  local b = self._bodies
  local slot = b.slotOf[object]
  if not slot or not self.timestep or not b.active[slot] or b.kind[slot] == columns.STATIC then
    return object.x, object.y
  end
  local k = 2 * slot
  return between(b, slot, k, object.x, self.alpha), between(b, slot, k + 1, object.y, self.alpha)
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

interpreted.always(World.save)

return world
