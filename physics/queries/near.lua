---@diagnostic disable
--- Finds the objects near a place or a line, as the game's tables are now, not as the last step
--- left them. It changes no result: a value that the game writes and takes back before the next
--- update has never been there.
--
-- It asks the grid of the world, in which everything has a *fat box* around its place. A query
-- first takes over new and missing objects (see objects/registry), without reading them. Then it
-- enlarges the fat boxes that the game has moved objects out of: a larger one is looked up anew by
-- the next step, and changes no result. So the grid knows all objects.
--
-- The game's writes leave no trace, so each query compares all that moves. Groups of many objects
-- of which none moves are compared by the first query after an update, `add`, `remove` or
-- `refresh`; so are new keys of a group, other than the next number. With more than `FEW` movers,
-- only that query compares anything. The objects that are found become a *catch*: columns by place
-- in it. Those of them that a query keeps become its list.
--
-- A query has these steps (see `query.point`, and for lines `rays.raycast`):
--
--     local c, kept = near.begin(world, wanted), 0 -- `wanted`: the filter of the game
--     near.rectangle(c, left, top, right, bottom) -- its candidates: places 1 to c.count
--     for n = 1, c.count do
--       if near.isNamed(c, n) and isHit(c, n) then -- the exact test, of shapes or lines
--         kept = kept + 1
--         c.found[kept], c.entry[n] = n, distance -- it is put in order by that
--       end
--     end
--     return near.publish(c, kept, c.entry, out) -- a list; one object: near.first, near.finish
--
-- A candidate has `object`, `rank`, `kind`, `shape`, `position` and `size` (at 2 n and 2 n + 1) at
-- once; `active`, `sensor`, `oneWay` and masks only after `near.readFilter`. Down of the world, at
-- the last update, is the axis a = `c.bodies.downAxis`, its sign `c.bodies.orientation[a]`; down of
-- an object is `b.down`, if `kind` is DYNAMIC: 0 on both axes if nothing pulls it. The filter may
-- be a function of the game, which may ask queries itself: it is called by `publish`, `first` and
-- `accepts` only.
--
-- A query of a line begins with `rays.begin`, which sets where the line is (`c.x`, `c.y`, `c.dx`,
-- `c.dy`; on a vertical line `c.x` is shifted by EPSILON, so results come from the numbers of the
-- caller), and calls `near.line`. `lines.passage` says whether it meets a candidate, `lines.hit`
-- where.
--
-- Reads the grid, and position, size and filter of static objects; writes fat boxes and the grid.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".fields.check")
local constants = require(root .. ".memory.constants")
local filter = require(root .. ".broadphase.filter")
local gridLines = require(root .. ".memory.lazy")(root .. ".broadphase.gridLines")
local read = require(root .. ".objects.read")
local registry = require(root .. ".objects.registry")
local shapes = require(root .. ".space.shapes")
local sort = require(root .. ".memory.sort")

local near = {}

local isFinite, max, min, remove = check.isFinite, math.max, math.min, table.remove
local STATIC, DYNAMIC = constants.STATIC, constants.DYNAMIC
-- So many objects are compared in a few microseconds.
local FEW = 1000
local MARGIN = 1 -- of a fat box, px
local MISSED = " was moved after this frame's first query. With more than "
  .. FEW
  .. " moving objects, call world:refresh(object) so that later queries see it"
-- Of a catch. `position` and `size` have two values, as in `memory/layout`. `near.readFilter` fills
-- those from `active` to `hitsOnly`; `entry` is scratch of queries.
local COLUMNS = [[
  object rank groupName kind shape position size active sensor oneWay mask hitsOnly entry
]]

-- Changes by the game -----------------------------------------------------------------------------

-- Errors: an object of which place, size or `active` cannot be used.
local function checkPlace(b, i)
  local object, active = b.object[i], b.object[i].active
  local isAt = isFinite(object.x) and isFinite(object.y)
  local isBox = isAt and isFinite(object.width) and isFinite(object.height)
  local isUsable = isBox and min(object.width, object.height) > 0
  if not isUsable or active ~= nil and type(active) ~= "boolean" then
    check.object(object, registry.placeOf, b, i)
  end
end

-- Returns whether slot i is in the grid, with a fat box around the place where it is now, or need
-- not be. Errors: its place cannot be used.
local function isFiled(b, i)
  local object, k, fatLow, fatHigh = b.object[i], 2 * i, b.fatLow, b.fatHigh
  if not b.group[i] then
    return true -- it has gone
  end
  checkPlace(b, i)
  local isInX = object.x >= fatLow[k] and object.x + object.width <= fatHigh[k]
  local isInY = object.y >= fatLow[k + 1] and object.y + object.height <= fatHigh[k + 1]
  return object.active == false or b.placed[i] ~= 0 and isInX and isInY
end

--- Puts slot i into the grid where it is now, if it is not there.
function near.file(b, i)
  if isFiled(b, i) then
    return
  end
  local object, k, m, fatLow, fatHigh = b.object[i], 2 * i, 2 * i + 1, b.fatLow, b.fatHigh
  local left, top = object.x - MARGIN, object.y - MARGIN
  local right, bottom = object.x + object.width + MARGIN, object.y + object.height + MARGIN
  if b.placed[i] == 0 then
    fatLow[k], fatLow[m], fatHigh[k], fatHigh[m] = left, top, right, bottom
  else
    fatLow[k], fatLow[m] = min(fatLow[k], left), min(fatLow[m], top)
    fatHigh[k], fatHigh[m] = max(fatHigh[k], right), max(fatHigh[m], bottom)
  end
  b.broadphase:put(i)
  b.placed[i] = 1
end

-- Takes over new groups, and the objects in them.
local function lookAtGroups(b, world)
  if b.isSeen and not registry.hasChanged(b.registry, world.objects) then
    return
  end
  read.look(b, world.objects)
  b.isSeen = true
  for n = 1, b.enteredCount do
    near.file(b, b.entered[n])
  end
  for n = 1, b.movedCount do -- static ones that were read again, too
    near.file(b, b.movedList[n])
  end
end

-- Calls `visit(b, i)` for movable objects that do not stand where they were read or written.
local function lookAtPlaces(b, visit)
  local movers, objects, written, size, placed = b.movers, b.object, b.written, b.size, b.placed
  for n = 1, b.moverCount do
    local i = movers[n]
    local object, k = objects[i], 2 * i
    if object then
      local isThere = object.x == written[k] and object.y == written[k + 1]
      local isSame = isThere and object.width == size[k] and object.height == size[k + 1]
      if not isSame or placed[i] == 0 then
        visit(b, i)
      end
    end
  end
end

-- Errors: something has been moved to where queries of a large world do not see it.
local function checkMissed(b, i)
  if not isFiled(b, i) then
    check.fail(registry.placeOf(b, i) .. MISSED)
  end
end

--- Begins a query: takes over the changes, and returns an empty catch, with its filter.
--- Errors: those of an update, a group, key or place that cannot be used.
function near.begin(world, wanted)
  local b = world._bodies
  local isInside = b.asking -- of a step, which has read all
  if not isInside and (not b.isSeen or b.moverCount <= FEW) then
    lookAtGroups(b, world)
    lookAtPlaces(b, near.file)
  elseif world.checked and not isInside then
    lookAtPlaces(b, checkMissed)
  end
  local c = remove(b.catches)
  if not c then
    c = { found = {}, slots = {}, bodies = b }
    for name in COLUMNS:gmatch("%a+") do
      c[name] = {}
    end
    c.size[0], c.size[1] = 0, 0 -- place 0: a point
  end
  c.count, c.filter = 0, wanted
  c.masks, c.soft = world.masks or false, b.soft
  return c
end

--- Takes a catch back. (A filter may make queries of its own, so each has one. One that fails
--- leaves it to the garbage collector.)
function near.finish(c)
  local catches = c.bodies.catches
  catches[#catches + 1] = c
end

-- Catches -----------------------------------------------------------------------------------------

-- Adds slot i to a catch; returns its place there.
local function add(c, i)
  local b, n = c.bodies, c.count + 1
  local object, k, m, kind = b.object[i], 2 * n, 2 * i, STATIC
  c.count, c.object[n], c.groupName[n], c.rank[n] = n, object, b.group[i].name, b.newRank[i]
  if b.kind[i] == STATIC then
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

-- Adds slot i, if it is active and still in the world.
local function addSlot(c, i)
  local b = c.bodies
  local isActive = b.kind[i] == STATIC and b.active[i] or b.object[i].active ~= false
  return isActive and b.group[i] and add(c, i)
end

--- Adds all objects to a catch that may be in a rectangle.
function near.rectangle(c, left, top, right, bottom)
  local slots = c.slots
  for m = 1, c.bodies.broadphase:query(left, top, right, bottom, slots) do
    addSlot(c, slots[m])
  end
end

-- Adds an object that is on the way of a line, and asks how far it goes on.
local function visitSlot(c, i, bound)
  local n = addSlot(c, i)
  return n and c.visit and c.visit(c, n, bound) or bound
end

--- Adds all objects to a catch that its line from (c.x, c.y) by (c.dx, c.dy) may meet.
--- `visit(c, n, bound)` is called for each of them and returns the share of the line after which
--- nothing matters (see broadphase/gridLines).
function near.line(c, visit)
  local isLater, bound = type(c.filter) == "function", 1 -- (that may do anything, also to the grid)
  c.visit = not isLater and visit
  gridLines.walk(c.bodies.broadphase, c, visitSlot, bound)
  for n = 1, isLater and c.count or 0 do
    bound = visit(c, n, bound)
  end
end

--- Adds an object to a catch, wherever it is; returns its place, nil: it is not in the world. With
--- `where`, the call, that is an error; `name` is that of the argument.
function near.get(c, object, where, name)
  local i = c.bodies.slotOf[object]
  if i and c.bodies.group[i] then
    return add(c, i)
  elseif where then
    registry.failMissing(where, name)
  end
end

--- Reads the fields that decide which objects one of a catch can meet. Errors: one of them cannot
--- be used.
function near.readFilter(c, n)
  local b, object = c.bodies, c.object[n]
  local i = b.slotOf[object]
  if b.kind[i] == STATIC then
    c.active[n], c.sensor[n], c.oneWay[n] = b.active[i], b.sensor[i], b.oneWay[i]
    c.mask[n], c.hitsOnly[n] = b.mask[i], b.hitsOnly[i]
    return
  end
  check.object(object, registry.placeOf, b, i)
  c.active[n], c.sensor[n] = object.active ~= false, object.sensor or false
  c.oneWay[n], c.mask[n] = constants.sideOf(object.oneWay), object.mask or false
  c.hitsOnly[n] = object.hits and filter.readHits(object.hits, b.hitsOnly[i]) or false
end

-- Results -----------------------------------------------------------------------------------------
-- `found[1..count]` of a catch are the places in it that a query keeps.

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

--- Ends a query: writes the kept objects that the filter accepts into `out`, in the order of column
--- `first`, then of the world; and the values of that column into `values`, if it is a list.
---@return physics.Object[] objects
---@return integer count
function near.publish(c, count, first, out, values)
  local found, n = c.found, 0
  out = out or {}
  values = values or out
  sort.by(found, count, first, c.rank, c.rank)
  for m = 1, count do
    if near.accepts(c, found[m]) then
      n = n + 1
      values[n] = first[found[m]]
      out[n] = c.object[found[m]]
    end
  end
  for m = max(#out, #values), n + 1, -1 do
    out[m], values[m] = nil, nil
  end
  near.finish(c)
  return out, n
end

--- Returns the first kept object that the filter accepts, by `entry`, then in the order of the
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
