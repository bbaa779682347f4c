--- Gives queries the objects as the game's tables are now, not as the last step left them.
--
-- A query must not touch the columns of the simulation. What the game writes and takes back before
-- the next update has never happened. So queries have columns of their own, with the same names, a
-- registry and a grid. Worlds without queries have none of this.
--
-- To find every change, the first query after a step looks at every object. Later queries compare
-- the number of objects in each group, and look at the objects that they find nearby. In a world of
-- up to `FEW` objects they look at all objects again. In a larger world a later query may miss two
-- changes until the next update. The first is an object that the game has moved or made larger by
-- more than `LEFT`. The second is an object that was put into a group of the same size by
-- assignment. `add`, `remove`, `move` and `refresh` report changes at once.
--
-- Of the simulation's columns it reads only which objects are static and where they are, which are
-- read once.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local aabb = require(root .. ".memory.aabb")
local columnStore = require(root .. ".memory.columnStore")
local check = require(root .. ".world.check")
local columns = require(root .. ".memory.columns")
local filter = require(root .. ".broadphase.filter")
local grid = require(root .. ".broadphase.grid")
local interpreted = require(root .. ".memory.jit")
local registry = require(root .. ".objects.registry")
local walkGrid = require(root .. ".broadphase.gridLines")

local view = {}

local max, min = math.max, math.min
local STATIC, DYNAMIC = columns.STATIC, columns.DYNAMIC
local BOX, CIRCLE, shapeOf = columns.SHAPE_BOX, columns.SHAPE_CIRCLE, columns.shapeOf

-- Kind of an object that the simulation has read anew.
local UNREAD = 0
-- Margins in px around an object that has not moved yet, and around one that has. It may move
-- inside them without being filed anew. LEFT is how much of the margin must remain. (A query looks
-- at all objects with boxes, margins included, that it meets.)
local STANDS, MOVES, LEFT = 3.25, 6, 3
-- px around a way within which objects may be met.
local SLACK = 1
-- px, size of the grid's cells: a box up to 28 px wide fits into one with its margin, wherever it
-- is.
local CELL = 40
-- Numbers with a sum up to this are all in range.
local MOST = 1e99
-- Up to so many objects can be looked at in a few microseconds.
local FEW = 128

-- Fields of a static object, copied from the simulation's columns.
local FIELD = { "active", "sensor", "oneWay", "mask", "shape", "only", "hitsGiven" }

local ANY = { "object", "group", "groupName", "key", "listed", "oneWay", "mask" }
local LAYOUT = {
  { kind = "any", width = 1, names = ANY },
  { kind = "any", width = 1, names = { "only", "hitsGiven" } },
  { kind = "boolean", width = 1, names = { "live", "active", "sensor" } },
  { kind = "integer", width = 1, names = { "kind", "shape" } },
  { kind = "number", width = 1, names = { "rank", "entry", "mark" } }, -- the last two are scratch
  { kind = "number", width = 2, names = { "position", "size", "fatLow", "fatHigh" } },
}

local function new()
  local v = {
    slots = 0,
    count = 0,
    hasCircles = false, -- ever
    free = {},
    slotOf = {},
    movers = {}, -- slots with fields that may change: all but static objects that were read
    moverCount = 0,
    lengths = {}, -- of the groups' tables, by place of the group
    isTold = false, -- an object was added or removed since the groups were looked at
    registry = registry.new(),
    order = false,
    masks = false,
    fresh = false, -- all objects were looked at since the last step
    stamp = 0,
    pool = {}, -- unused lists, and how many
    pooled = 0,
    single = {}, -- a list of one
    strays = {}, -- scratch of followAll
  }
  v.store = columnStore.new(v, LAYOUT)
  v.grid = grid.new(v, CELL)
  return v
end

-- Reading -----------------------------------------------------------------------------------------

local function kindOf(b, object)
  local slot = b.slotOf[object]
  return columns.kindOf(object, slot and b.kind[slot] == STATIC)
end

local function complain(v, i)
  check.object(v.object[i], registry.placeOf(v, i))
end

-- Reads the radius of an object that has one; returns its shape.
local function lookAtRadius(v, i, radius)
  local object = v.object[i]
  if
    type(radius) ~= "number"
    or object.width ~= 2 * radius
    or object.height ~= 2 * radius
    or object.slope ~= nil
  then
    complain(v, i)
  end
  v.hasCircles = true
  return CIRCLE
end

-- Reads where an object is now.
local function look(v, i)
  local object, position, size, k = v.object[i], v.position, v.size, 2 * i
  local x, y, width, height = object.x, object.y, object.width, object.height
  local active, radius = object.active, object.radius
  if
    type(x) ~= "number"
    or type(y) ~= "number"
    or type(width) ~= "number"
    or type(height) ~= "number"
    or not (max(x, -x) + max(y, -y) + width + height <= MOST and min(width, height) > 0)
    or (active ~= nil and type(active) ~= "boolean")
  then
    complain(v, i)
  end
  local shape = v.kind[i] ~= DYNAMIC and shapeOf(object.slope) or BOX
  if radius ~= nil then
    shape = lookAtRadius(v, i, radius)
  elseif shape ~= v.shape[i] then
    complain(v, i)
  end
  v.active[i], v.shape[i] = active ~= false, shape
  -- Adding 0.0 makes floats of the integers of Lua 5.3 and later, which would wrap.
  position[k], position[k + 1] = x + 0.0, y + 0.0
  size[k], size[k + 1] = width + 0.0, height + 0.0
end

-- Reads where the objects in list[1..count] are now, if they are live. Errors: a place, size or
-- `active` that cannot be used.
local function lookAtAll(v, list, count)
  local live = v.live
  for n = 1, count do
    if live[list[n]] then
      look(v, list[n])
    end
  end
end

--- Reads what decides which objects an object can meet. Errors: a field that cannot be used.
function view.lookAtFilter(v, i)
  if not v.live[i] then
    return
  end
  local object = v.object[i]
  local sensor, mask, hits = object.sensor or false, object.mask or false, object.hits or false
  local oneWay = columns.sideOf(object.oneWay)
  if sensor ~= v.sensor[i] or oneWay ~= v.oneWay[i] or mask ~= v.mask[i] then
    complain(v, i)
    v.sensor[i], v.oneWay[i], v.mask[i] = sensor, oneWay, mask
  end
  if hits ~= v.hitsGiven[i] then
    complain(v, i)
    v.only[i], v.hitsGiven[i] = hits and filter.readHits(v.bodies, hits), hits
  end
  v.kind[i] = kindOf(v.bodies, object)
end

-- A static object is where the simulation read it.
local function readStatic(v, b, i)
  local slot = b.slotOf[v.object[i]]
  local k, m = 2 * i, 2 * slot
  v.position[k], v.position[k + 1] = b.position[m], b.position[m + 1]
  v.size[k], v.size[k + 1] = b.size[m], b.size[m + 1]
  for _, name in ipairs(FIELD) do
    v[name][i] = b[name][slot]
  end
  v.kind[i], v.live[i] = STATIC, false
  v.hasCircles = v.hasCircles or v.shape[i] == CIRCLE
end

local function readAny(v, b, i)
  local object = v.object[i]
  local slot = b.slotOf[object]
  if slot and b.kind[slot] == STATIC then
    readStatic(v, b, i)
  else
    v.live[i], v.single[1] = true, i
    v.kind[i] = kindOf(b, object)
    lookAtAll(v, v.single, 1)
  end
end

-- The grid ----------------------------------------------------------------------------------------

local function mustMove(v, i)
  local position, size, fatLow, fatHigh, k = v.position, v.size, v.fatLow, v.fatHigh, 2 * i
  return max(
    fatLow[k] - position[k],
    position[k] + size[k] - fatHigh[k],
    fatLow[k + 1] - position[k + 1],
    position[k + 1] + size[k + 1] - fatHigh[k + 1]
  ) > -LEFT
end

-- Gives an object a box with this margin, if it may move.
local function fatten(v, i, margin)
  local position, size, room = v.position, v.size, v.live[i] and margin or 0
  for k = 2 * i, 2 * i + 1 do
    v.fatLow[k], v.fatHigh[k] = position[k] - room, position[k] + size[k] + room
  end
end

-- Looks at the objects in list[1..count], and files those anew that have nearly left their boxes.
local function followAll(v, list, count)
  lookAtAll(v, list, count)
  local strays, m = v.strays, 0
  for n = 1, count do
    local i = list[n]
    if mustMove(v, i) then
      fatten(v, i, MOVES)
      m = m + 1
      strays[m] = i
    end
  end
  v.grid:update(strays, m)
end

--- Looks at an object and files it anew if it has nearly left its box. Errors: a place, size or
--- `active` that cannot be used.
function view.follow(v, i)
  v.single[1] = i
  followAll(v, v.single, 1)
end

local function list(v, i)
  if v.live[i] and not v.listed[i] then
    v.moverCount = v.moverCount + 1
    v.movers[v.moverCount] = i
    v.listed[i] = v.moverCount
  end
end

local function unlist(v, i)
  local at = v.listed[i]
  if at then
    local last = v.movers[v.moverCount]
    v.movers[at], v.listed[last] = last, at
    v.movers[v.moverCount] = nil
    v.moverCount = v.moverCount - 1
    v.listed[i] = false
  end
end

-- Objects -----------------------------------------------------------------------------------------

local function enter(v, object, record, key)
  local i = v.free[#v.free]
  if i then
    v.free[#v.free] = nil
  else
    i = v.slots + 1
    v.slots = i
    if i > v.store.room then
      columnStore.grow(v.store, i)
    end
  end
  v.count = v.count + 1
  v.slotOf[object] = i
  v.object[i], v.group[i], v.groupName[i], v.key[i] = object, record, record.name, key
  v.listed[i], v.entry[i], v.mark[i], v.rank[i] = false, 0, 0, 0
  v.active[i], v.sensor[i], v.oneWay[i], v.mask[i] = true, false, false, false
  v.shape[i] = columns.SHAPE_BOX
  v.only[i], v.hitsGiven[i] = false, false
  readAny(v, v.bodies, i)
  fatten(v, i, STANDS)
  v.grid:insert(i)
  list(v, i)
  return i
end

local function leave(v, i)
  v.grid:remove(i)
  unlist(v, i)
  v.slotOf[v.object[i]] = nil
  v.object[i], v.group[i], v.mask[i] = false, false, false
  v.only[i], v.hitsGiven[i] = false, false
  v.free[#v.free + 1] = i
  v.count = v.count - 1
end

local function rename(v, i, record)
  v.group[i], v.groupName[i] = record, record.name
end

local function lookAtGroups(v, world)
  local r = v.registry
  if world.order ~= v.order then
    check.setting("order", world.order)
    v.order = world.order
    r.order, r.reorder = world.order or {}, true
  end
  registry.update(v, r, world.objects, enter, leave, rename)
  for n = 1, r.groupCount do
    v.lengths[n] = #r.groups[n].source
  end
  v.isTold = false
end

-- Returns whether a list still ends where it did. (`#` would search for its end anew.)
local function endsAt(source, length)
  return rawget(source, length + 1) == nil and (length == 0 or rawget(source, length) ~= nil)
end

-- Returns whether no group seems to have changed, in a world too large for looking at all objects.
local function seemsUnchanged(v, world)
  local r, objects = v.registry, world.objects
  if v.isTold or v.count <= FEW or not rawequal(r.source, objects) or world.order ~= v.order then
    return false
  end
  for n = 1, r.groupCount do
    local record = r.groups[n]
    local source = record.source
    if not rawequal(objects[record.name], source) or not endsAt(source, v.lengths[n]) then
      return false
    end
  end
  return true
end

-- Takes static objects off the list of movers once the simulation has read them.
local function settle(v)
  local movers, kind = v.movers, v.kind
  for n = v.moverCount, 1, -1 do
    local i = movers[n]
    if kind[i] <= STATIC then
      readAny(v, v.bodies, i)
      if not v.live[i] then
        unlist(v, i)
        fatten(v, i, STANDS)
        v.single[1] = i
        v.grid:update(v.single, 1)
      end
    end
  end
end

local function lookAtEverybody(v, world)
  lookAtGroups(v, world)
  settle(v)
  followAll(v, v.movers, v.moverCount)
  v.fresh = true
end

--- Returns the columns for queries of a world, up to date. Errors: those of an update, a group, key
--- or field that cannot be used.
function view.of(world)
  local b = world._bodies
  local v = b.view
  if not v or v.isBroken then
    v = new()
    v.bodies = b
    b.view = v
  end
  v.masks, v.soft = world.masks or false, b.soft
  v.isBroken = true -- if reading an object fails, everything is made anew
  if not v.fresh then
    lookAtEverybody(v, world)
  else
    if not seemsUnchanged(v, world) then
      lookAtGroups(v, world)
    end
    if v.moverCount <= FEW then
      followAll(v, v.movers, v.moverCount)
    end
  end
  v.isBroken = false
  return v
end

--- Notes that the simulation has read an object anew (see queries/notice).
function view.refresh(v, object)
  local i = v.slotOf[object]
  if i then
    v.live[i], v.kind[i] = true, UNREAD
    registry.reread(v.group[i])
    list(v, i)
    v.fresh = false
  end
end

--- Returns whether an object still stands where it was seen.
function view.isThere(v, i)
  local record = v.group[i]
  return record.direct or rawequal(record.source[v.key[i]], v.object[i])
end

--- Returns the slot of an object, nil: it is not in the world. It may have been put in without
--- `add` since all objects were looked at.
function view.find(v, world, object)
  local i = v.slotOf[object]
  if not i or not view.isThere(v, i) then
    lookAtGroups(v, world)
    i = v.slotOf[object]
  end
  if i then
    view.follow(v, i)
  end
  return i
end

--- Looks at an object that may have left since all objects were looked at; false: it has left.
function view.see(v, i)
  if not view.isThere(v, i) then
    return false
  elseif v.live[i] then
    look(v, i)
  end
  return true
end

local see = view.see

-- Looks at the objects that a query has found, one after the other; false: one has left.
local function lookAtFound(v, found, count)
  local n = 1
  while n <= count and see(v, found[n]) do
    n = n + 1
  end
  return n > count
end

--- Writes the slots of all objects that may be in a rectangle into `found`; returns how many. Their
--- positions are up to date.
function view.near(v, world, left, top, right, bottom, found)
  local count = v.grid:query(left, top, right, bottom, found)
  if not lookAtFound(v, found, count) then
    lookAtGroups(v, world)
    count = v.grid:query(left, top, right, bottom, found)
    lookAtFound(v, found, count)
  end
  return count
end

local function walkOnce(v, x1, y1, x2, y2, line, visit)
  line.isStale, line.count, line.best = false, 0, 0
  walkGrid(v.grid, x1, y1, x2, y2, line, visit)
end

--- Calls `visit` for all objects that may be on a line (see gridLines). `count` and `best`
--- of the line are 0 at first; `visit` may note its results there. It must call `see` for each
--- object. If one has left, `visit` sets `line.isStale` and returns -1, and all starts again.
function view.walk(v, world, x1, y1, x2, y2, line, visit)
  walkOnce(v, x1, y1, x2, y2, line, visit)
  if line.isStale then
    lookAtGroups(v, world)
    walkOnce(v, x1, y1, x2, y2, line, visit)
  end
end

-- Keeps in `found` the slots that slot i may meet on its way from (x, y) to (toX, toY); returns how
-- many.
local function keepOnWay(v, found, count, i, x, y, toX, toY)
  local position, size, n = v.position, v.size, 0
  local w, h = size[2 * i] + SLACK, size[2 * i + 1] + SLACK
  local backX, backY = x - SLACK, y - SLACK
  local shareX, shareY = aabb.share(toX - x), aabb.share(toY - y)
  for m = 1, count do
    local j = found[m]
    local k = 2 * j
    local left, top = position[k] - w - x, position[k + 1] - h - y
    local right, bottom = position[k] + size[k] - backX, position[k + 1] + size[k + 1] - backY
    if aabb.crossing(left, top, right, bottom, shareX, shareY) >= 0 then
      n = n + 1
      found[n] = j
    end
  end
  return n
end

--- The same as `near`, for the objects that slot i may meet on its way from (x, y) to (toX, toY).
function view.onWay(v, world, i, x, y, toX, toY, found)
  local w, h = v.size[2 * i], v.size[2 * i + 1]
  local left, top, right, bottom = min(x, toX), min(y, toY), max(x, toX) + w, max(y, toY) + h
  local count = view.near(v, world, left, top, right, bottom, found)
  return (keepOnWay(v, found, count, i, x, y, toX, toY))
end

interpreted.functions(view.lookAtFilter)

return view
