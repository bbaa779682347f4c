---@diagnostic disable
--- Finds the objects near a place or a line, as the game's tables are now, not as the last step
--- left them. It changes nothing: what the game writes and takes back before the next update has
--- never happened.
--
-- It asks the grid of the world. Objects that the game has moved out of their fat boxes since the
-- last step (*strays*) are found by comparing the tables with what was written to them, and those
-- that it has added (*guests*) by comparing the groups with the registry. A write leaves no trace,
-- so each query compares all that moves. Groups in which nothing moves are compared by the first
-- query after an update, `add`, `remove` or `refresh`. With more than `FEW` movers, only that query
-- compares anything. What has changed is noted in the *view* of the world. What is found becomes a
-- *catch*: columns by place in it. What a query keeps of that becomes its list.
--
-- Reads the grid, fat boxes, and position, size and filter of static objects; writes no column.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local allot = require(root .. ".memory.allot")
local check = require(root .. ".fields.check")
local constants = require(root .. ".memory.constants")
local filter = require(root .. ".broadphase.filter")
local gridLines = require(root .. ".memory.lazy")(root .. ".broadphase.gridLines")
local registry = require(root .. ".objects.registry")
local shapes = require(root .. ".space.shapes")
local sort = require(root .. ".memory.sort")

local near = {}

local max, min, remove = math.max, math.min, table.remove
local STATIC, DYNAMIC = constants.STATIC, constants.DYNAMIC
-- So many objects are compared in a few microseconds.
local FEW = 1000
-- Numbers with a sum up to this are all in range.
local MOST = 1e99
local MISSED = " was moved after this frame's first query. With more than "
  .. FEW
  .. " moving objects, call world:refresh(object) so that later queries see it"
local COLUMNS = {
  "slot", -- 0: a guest
  "object",
  "rank",
  "group", -- the record of it, in `objects/registry`
  "groupName",
  "key",
  "kind",
  "shape",
  "position", -- two values, as in `memory/layout`
  "size",
  "active", -- these: see `near.readFilter`
  "sensor",
  "oneWay",
  "mask",
  "hitsOnly",
  "entry", -- scratch of queries
}

local function newView()
  return {
    isFresh = false, -- all was compared since the last step or change
    registry = false, -- the groups as they were seen last: those of the world, or later ones
    rankOf = false, -- by object, if they are later ones; recordOf and keyOf as well
    guests = {}, -- objects
    strays = {}, -- slots
    strayAt = {}, -- by slot: `looks` when it was one
    looks = 0,
    pool = {}, -- of catches
  }
end

-- What the game has changed -----------------------------------------------------------------------

-- Reads the groups as the next update will. Errors: those of an update.
local function readGroups(v, world)
  local b = world._bodies
  check.setting("order", world.order)
  local seen = registry.look(b, world.objects, world.order or {})
  v.rankOf, v.recordOf, v.keyOf, v.guestCount = {}, {}, {}, 0
  for index, record in ipairs(seen.groups) do
    for n = 1, record.count do
      local object = record.list[n]
      v.rankOf[object], v.recordOf[object] = index * allot.GROUP_SPAN + n, record
      v.keyOf[object] = record.keys and record.keys[n] or n
      if not b.slotOf[object] then
        v.guestCount = v.guestCount + 1
        v.guests[v.guestCount] = object
      end
    end
  end
  v.registry, v.order = seen, world.order
end

-- Lists the guests, if the game has changed its groups.
local function lookAtGroups(v, world)
  if not v.registry then
    v.registry, v.order, v.rankOf, v.guestCount = world._bodies.registry, world.order, false, 0
  end
  if world.order ~= v.order or registry.hasChanged(v.registry, world.objects, v.isFresh) then
    readGroups(v, world)
  end
end

-- Errors: an object of which place, size or `active` cannot be used.
local function checkPlace(object, record, key)
  local x, y, width, height, active = object.x, object.y, object.width, object.height, object.active
  if
    type(x) ~= "number"
    or type(y) ~= "number"
    or type(width) ~= "number"
    or type(height) ~= "number"
    or not (max(x, -x) + max(y, -y) + width + height <= MOST and min(width, height) > 0)
    or (active ~= nil and type(active) ~= "boolean")
  then
    check.object(object, registry.place, record, key)
  end
end

-- Notes slot i as a stray, if the grid does not know where it is now.
local function noteStray(v, b, i)
  local object, k, fatLow, fatHigh = b.object[i], 2 * i, b.fatLow, b.fatHigh
  checkPlace(object, b.group[i], b.key[i])
  local isKnown = b.placed[i] ~= 0
    and object.x >= fatLow[k]
    and object.y >= fatLow[k + 1]
    and object.x + object.width <= fatHigh[k]
    and object.y + object.height <= fatHigh[k + 1]
  if not isKnown and object.active ~= false and v.strayAt[i] ~= v.looks then
    v.strayAt[i], v.strayCount = v.looks, v.strayCount + 1
    v.strays[v.strayCount] = i
  end
end

-- Lists in `strays` what the grid does not know. What stands where it was read or written is known.
local function lookAtPlaces(v, b)
  local movers, objects, written, size, placed = b.movers, b.object, b.written, b.size, b.placed
  for n = 1, b.moverCount do
    local i = movers[n]
    local object, k = objects[i], 2 * i
    if
      object
      and (
        object.x ~= written[k]
        or object.y ~= written[k + 1]
        or object.width ~= size[k]
        or object.height ~= size[k + 1]
        or placed[i] == 0
      )
    then
      noteStray(v, b, i)
    end
  end
  for n = 1, b.movedCount do -- static ones that were read again, too
    if b.object[b.movedList[n]] then
      noteStray(v, b, b.movedList[n])
    end
  end
end

-- Errors: something has become a stray that queries of a large world do not see.
local function checkMissed(v, b)
  local known = v.strayCount
  lookAtPlaces(v, b)
  if v.strayCount > known then
    local where = registry.placeOf(b, v.strays[v.strayCount])
    check.fail(where .. MISSED)
  end
end

--- Begins a query: looks at what has changed, and returns an empty catch, with its filter.
--- Errors: those of an update, a group, key or place that cannot be used.
function near.begin(world, wanted)
  local b = world._bodies
  local v = b.view or newView()
  b.view = v
  if not v.isFresh or b.moverCount <= FEW then
    lookAtGroups(v, world)
    v.isFresh, v.looks, v.strayCount = true, v.looks + 1, 0
    lookAtPlaces(v, b)
  elseif world.checked then
    checkMissed(v, b)
  end
  local c = remove(v.pool)
  if not c then
    c = { found = {}, slots = {}, view = v, bodies = b }
    for _, name in ipairs(COLUMNS) do
      c[name] = {}
    end
  end
  c.count, c.filter = 0, wanted
  c.masks, c.soft = world.masks or false, b.soft
  return c
end

--- Takes a catch back. (A filter may make queries of its own, so each has one. One that fails
--- leaves it to the garbage collector.)
function near.finish(c)
  local pool = c.view.pool
  pool[#pool + 1] = c
end

--- Notes that the library has moved an object of a catch: in a large world no query would see it.
function near.noteMoved(c, n)
  if c.slot[n] ~= 0 then
    noteStray(c.view, c.bodies, c.slot[n])
  end
end

-- Catches -----------------------------------------------------------------------------------------

-- Adds an object to a catch; returns its place there. Of a guest, the slot is 0.
local function add(c, object, i)
  local b, v, n = c.bodies, c.view, c.count + 1
  c.count, c.slot[n], c.object[n] = n, i, object
  if v.rankOf then
    c.group[n], c.key[n], c.rank[n] = v.recordOf[object], v.keyOf[object], v.rankOf[object]
  else
    c.group[n], c.key[n], c.rank[n] = b.group[i], b.key[i], b.rank[i]
  end
  c.groupName[n] = c.group[n].name
  local k, m, kind = 2 * n, 2 * i, STATIC
  if i ~= 0 and b.kind[i] == STATIC then
    c.position[k], c.position[k + 1] = b.position[m], b.position[m + 1]
    c.size[k], c.size[k + 1], c.shape[n] = b.size[m], b.size[m + 1], b.shape[i]
  else
    -- Adding 0.0 makes floats of the integers of Lua 5.3 and later, which would wrap.
    c.position[k], c.position[k + 1] = object.x + 0.0, object.y + 0.0
    c.size[k], c.size[k + 1] = object.width + 0.0, object.height + 0.0
    kind = constants.kindOf(object)
    c.shape[n] = shapes.of(object, kind == DYNAMIC)
  end
  c.kind[n] = kind
  return n
end

-- Adds slot i, if it is active and still in the world, and no stray.
local function addSlot(c, i)
  local b, v = c.bodies, c.view
  local object, rankOf = b.object[i], v.rankOf
  local isActive = b.kind[i] == STATIC and b.active[i] or object.active ~= false
  if isActive and v.strayAt[i] ~= v.looks and (not rankOf or rankOf[object]) then
    return add(c, object, i)
  end
end

-- Adds a stray or guest that is in a rectangle, or at its edge.
local function addUnfiled(c, object, i, left, top, right, bottom)
  local rankOf = c.view.rankOf
  if
    object.active ~= false
    and (not rankOf or rankOf[object])
    and object.x <= right
    and object.y <= bottom
    and object.x + object.width >= left
    and object.y + object.height >= top
  then
    add(c, object, i)
  end
end

-- Adds all strays and guests in a rectangle.
local function addAllUnfiled(c, left, top, right, bottom)
  local v, objects = c.view, c.bodies.object
  for m = 1, v.strayCount do
    addUnfiled(c, objects[v.strays[m]], v.strays[m], left, top, right, bottom)
  end
  for m = 1, v.guestCount do
    local object = v.guests[m]
    checkPlace(object, v.recordOf[object], v.keyOf[object])
    addUnfiled(c, object, 0, left, top, right, bottom)
  end
end

--- Adds all objects to a catch that may be in a rectangle.
function near.rectangle(c, left, top, right, bottom)
  local slots = c.slots
  for m = 1, c.bodies.broadphase:query(left, top, right, bottom, slots) do
    addSlot(c, slots[m])
  end
  addAllUnfiled(c, left, top, right, bottom)
end

-- Adds an object that is on the way of a line, and asks how far it goes on.
local function visitSlot(c, i, bound)
  local n = addSlot(c, i)
  return n and c.visit(c, n, bound) or bound
end

--- Adds all objects to a catch that a line may meet. `visit(c, n, bound)` is called for each of
--- them and returns the share of the line after which nothing matters (see broadphase/gridLines).
function near.line(c, x1, y1, x2, y2, visit)
  local bound = 1
  addAllUnfiled(c, min(x1, x2), min(y1, y2), max(x1, x2), max(y1, y2))
  for n = 1, c.count do
    bound = visit(c, n, bound)
  end
  c.visit = visit
  gridLines.walk(c.bodies.broadphase, x1, y1, x2, y2, c, visitSlot, bound)
end

--- Adds an object to a catch, wherever it is; returns its place, nil: it is not in the world.
function near.find(c, object)
  local i, rankOf = c.bodies.slotOf[object], c.view.rankOf
  if rankOf and rankOf[object] == nil or not (rankOf or i) then
    return nil
  end
  return add(c, object, i or 0)
end

--- Does the same. Errors: the object is not in the world; `name` is that of the argument.
function near.get(c, object, where, name)
  local n = near.find(c, object)
  if not n then
    registry.failMissing(where, name)
  end
  return n
end

--- Reads what decides what an object of a catch can meet. Errors: a field that cannot be used.
function near.readFilter(c, n)
  local b, object, i = c.bodies, c.object[n], c.slot[n]
  if c.kind[n] == STATIC and i ~= 0 then
    c.active[n], c.sensor[n], c.oneWay[n] = b.active[i], b.sensor[i], b.oneWay[i]
    c.mask[n], c.hitsOnly[n] = b.mask[i], b.hitsOnly[i]
    return
  end
  check.object(object, registry.place, c.group[n], c.key[n])
  c.active[n], c.sensor[n] = object.active ~= false, object.sensor or false
  c.oneWay[n], c.mask[n] = constants.sideOf(object.oneWay), object.mask or false
  c.hitsOnly[n] = object.hits and filter.readHits(b, object.hits) or false
end

-- Results -----------------------------------------------------------------------------------------
-- `found[1..count]` of a catch are places in it: what a query keeps.

--- Returns whether the filter of a catch accepts the group of an object in it. One that is a
--- function is asked later.
function near.isNamed(c, n)
  local wanted, name = c.filter, c.groupName[n]
  if type(wanted) == "table" then
    return check.isAmong(name, wanted)
  end
  return wanted == nil or wanted == name or type(wanted) == "function"
end

--- Returns whether the filter, if it is a function, accepts an object.
function near.accepts(c, n)
  return type(c.filter) ~= "function" or c.filter(c.object[n])
end

--- Ends a query: writes what it has kept and the filter accepts into `out`, in the order of column
--- `first`, then of the world.
---@return physics.Object[] objects
---@return integer count
function near.publish(c, count, first, out)
  local found, n = c.found, 0
  out = out or {}
  sort.by(found, count, first, c.rank, c.rank)
  for m = 1, count do
    if near.accepts(c, found[m]) then
      n = n + 1
      out[n] = c.object[found[m]]
    end
  end
  for m = #out, n + 1, -1 do
    out[m] = nil
  end
  near.finish(c)
  return out, n
end

--- Returns the first of what is kept that the filter accepts, by `entry`, then in the order of the
--- world; nil: none.
function near.first(c, count)
  sort.by(c.found, count, c.entry, c.rank, c.rank)
  for m = 1, count do
    if near.accepts(c, c.found[m]) then
      return c.found[m]
    end
  end
end

return near
