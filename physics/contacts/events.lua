---@diagnostic disable
--- Events: collects the events of a step, and calls the callbacks of the game after it.
--- The kind of an event is the name of its callback: a row of `fields` with `event`.
--
-- Events wait in a list of their own, as objects and not as slots, because callbacks may do
-- anything, also remove objects. An error in a callback leaves the rest in the list for the next
-- update.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local ball = require(root .. ".memory.lazy")(root .. ".narrowphase.ball")
local check = require(root .. ".fields.check")
local constants = require(root .. ".memory.constants")
local fields = require(root .. ".fields.fields")
local links = require(root .. ".memory.links")
local patience = require(root .. ".memory.lazy")(root .. ".overlaps.patience")
local registry = require(root .. ".objects.registry")
local sort = require(root .. ".memory.sort")
local touch = require(root .. ".narrowphase.touch")

local events = {}

local SIDES, OPPOSITE = constants.SIDES, constants.OPPOSITE
local AT_LEFT, AT_TOP = constants.SIDE.left, constants.SIDE.top
local max = math.max
local IN = 0.02 -- see isWedged

--- The values of an event, of which the first OBJECTS are objects: each has a list, by event. (So
--- do `leant` and the ranks, which put them in order.)
events.OBJECTS = 3
events.VALUES = {
  "a",
  "b",
  "c", -- false: there are two only
  "kind", -- the name of its callback
  "side", -- of `a`; or the name of an axis, or false (see `event` in fields/fields)
  "speed", -- px/s; of `onStay`: s, the length of its step
  "x1", -- of `onBegin` (`onStay` is not told): the ends of the common edge
  "y1",
  "x2",
  "y2",
  "nx", -- of `onBegin` and `onStay`: the unit normal, from `b` to `a`
  "ny",
}

-- By kind of event: the values that its callback gets.
local TELLS = {}
for _, row in ipairs(fields.events) do
  TELLS[row.name] = row.event
end

--- Returns an empty list of events.
function events.new()
  local e = {
    count = 0, -- number of events
    told = 0, -- how many of them were told
    sorted = 0, -- how many are in order; later ones follow behind them
    heardBy = 3, -- of the last one told, recipients called: its first object, its second, the world
    order = {},
    late = {},
    leant = {}, -- 1: the contact begins because one object leans on the other, without a hit
    rankA = {},
    rankB = {},
  }
  for _, name in ipairs(events.VALUES) do
    e[name] = {}
  end
  return e
end

-- Returns whether there is a callback for an event of slots i and j. Most games listen to few
-- contacts, and an event without a callback need not be sorted.
local function hasListener(b, name, i, j)
  return b.world[name] or b.object[i][name] or b.object[j][name]
end

-- Adds an event of the objects in slots i and j, and of a third object if there is one.
local function note(b, kind, i, j, third, side, speed)
  local e = b.events
  local n = e.count + 1
  e.count = n
  e.order[n] = n
  e.kind[n], e.leant[n] = kind, 0
  e.rankA[n], e.rankB[n] = b.rank[i], b.rank[j]
  e.a[n], e.b[n], e.c[n] = b.object[i], b.object[j], third
  e.side[n], e.speed[n] = side, speed + 0.0 -- a float, and not -0, on each Lua
  e.x1[n], e.y1[n], e.x2[n], e.y2[n], e.nx[n], e.ny[n] = 0, 0, 0, 0, 0, 0
end

-- Adds its place and normal to the last event, of pair p: where the two hit (`isHit`), or where
-- they touch at the end of the step. (If two boxes overlap, the first in the order of the world
-- counts.)
local function locate(b, p, isHit)
  local e, n, i, j = b.events, b.events.count, links.slotsOf(b, p)
  local at, low, high, nx, ny
  if isHit then
    local sign = i == b.pairA[p] and 1 or -1
    at, low, high = b.hitAt[p], b.hitEnd[2 * p], b.hitEnd[2 * p + 1]
    nx, ny = sign * b.hitNormal[2 * p], sign * b.hitNormal[2 * p + 1]
  else
    at, low, high, nx, ny = touch.line(b, i, j, e.side[n], 1)
  end
  e.nx[n], e.ny[n] = nx + 0.0, ny + 0.0
  if constants.AXIS[e.side[n]] == 0 then
    e.x1[n], e.y1[n], e.x2[n], e.y2[n] = at, low, at, high
  else
    e.x1[n], e.y1[n], e.x2[n], e.y2[n] = low, at, high, at
  end
end

--- Notes an event of the objects in slots i and j, if it has a callback. The first one in the order
--- of the world becomes `a`. `side` is that of slot i. For an event of one object alone, j is i,
--- and there is no side.
function events.add(b, kind, i, j, side, speed)
  if not hasListener(b, kind, i, j) then
    return
  elseif b.rank[j] < b.rank[i] then
    return note(b, kind, j, i, false, OPPOSITE[side], speed)
  end
  return note(b, kind, i, j, false, side, speed)
end

local add = events.add

-- Returns whether a contact has an `onStay`, which is called in every step. Such objects cannot
-- sleep.
local function isHeard(b, i, j)
  if b.world.onStay or b.object[i].onStay or b.object[j].onStay then
    b.isPolled[i], b.isPolled[j] = true, true
    return true
  end
  return false
end

-- Adds an event of a contact of pair p on `side` of its first object, with its place. `leant`: see
-- events.new.
local function addPlaced(b, kind, p, side, speed, leant)
  local e, count = b.events, b.events.count
  add(b, kind, b.pairA[p], b.pairB[p], side, speed)
  if e.count > count then
    e.leant[e.count] = leant
    locate(b, p, kind == "onBegin" and b.hit[p] ~= 0)
  end
end

--- Notes that a contact of pair p has begun on `side` of its first object. Contacts that begin
--- because one object leans on the other, without a hit, are told after all hits. (Of two bricks
--- that are hit at once, the one with the wider common edge is hit.)
function events.begin(b, p, side, speed)
  isHeard(b, b.pairA[p], b.pairB[p])
  addPlaced(b, "onBegin", p, side, speed, b.hit[p] == 0 and 1 or 0)
end

--- Notes that a contact of pair p has ended.
function events.finish(b, p, side)
  add(b, "onEnd", b.pairA[p], b.pairB[p], side, 0)
end

--- Notes that the objects of pair p touched and separated within the step.
function events.bounce(b, p, side, speed)
  addPlaced(b, "onBegin", p, side, speed, 0)
  events.finish(b, p, side)
end

--- Notes that a contact goes on, if there is an `onStay`.
function events.stay(b, p, side)
  local i, j = b.pairA[p], b.pairB[p]
  if isHeard(b, i, j) then
    addPlaced(b, "onStay", p, side, b.dt, 0)
  end
end

-- Returns whether slot i still lies in another body. (Bodies of a heap rest in each other by less
-- than IN of the smaller size.)
local function isWedged(b, i)
  for _, j, p in links.neighbours(b, i) do
    local isIn = b.wedged[p] ~= 0 and ball.gapIn(b, b.to, i, j) < -IN * ball.smallest(b, i, j)
    if isIn or ball.isCaught(b, p) then
      return true
    end
  end
  return false
end

--- Notes the events of objects that begin to be crushed in this step, on each axis. (A machine that
--- stands still for a while crushes nothing, but does not let them out either.)
function events.tellCrush(b)
  local list, crusher, wasCrushed = b.awakeList, b.crusher, b.wasCrushed
  for n = 1, b.awakeCount do
    local i = list[n]
    for k = 2 * i, 2 * i + 1 do
      local low, high = crusher[2 * k + 1], crusher[2 * k + 2] -- 0: it is not crushed
      if low > 0 and not wasCrushed[k] and hasListener(b, "onCrush", i, i) then
        note(b, "onCrush", i, low, b.object[high], k % 2 == 0 and "x" or "y", 0)
      end
      wasCrushed[k] = low > 0 or wasCrushed[k] and isWedged(b, i)
    end
  end
end

--- Ends the contacts of a slot with all others, or with the slots for which `isOver(b, i, j)`,
--- because the game has changed it or them. It is no longer wedged into them, and there may be room
--- now. (It may touch them again in the same step.)
function events.endContacts(b, i, isOver)
  for _, j, p in links.neighbours(b, i) do
    if (b.contact[p] ~= 0 or b.wedged[p] ~= 0) and (not isOver or isOver(b, i, j)) then
      b.wedged[p] = 0
      if b.contact[p] ~= 0 then
        if b.hasOverlaps then
          patience.loosen(b, i)
          if b.kind[j] == constants.DYNAMIC then -- (else all that lies on a floor may have room)
            patience.loosen(b, j)
          end
        end
        events.finish(b, p, b.contact[p])
        b.contact[p], b.contactCount = 0, b.contactCount - 1
      end
    end
  end
end

-- Checks a callback. Callbacks are read when they are called, so a field may have changed since the
-- object was read.
local function checkCallback(b, owner, name)
  local callback = owner[name]
  if callback and type(callback) ~= "function" then
    local slot = b.slotOf[owner]
    local place = owner == b.world and "world"
      or slot and b.group[slot] and registry.placeOf(b, slot)
      or "removed object"
    check.fail(place .. "." .. name .. " must be a function, got " .. check.show(callback))
  end
end

-- Returns a number just below a coordinate. The right and bottom edges of a cell belong to the next
-- one; so a place there is told as one inside the other object.
local function before(at)
  return at - max(at, -at, 1) * 2e-15
end

-- Calls the callback of one recipient of an event: 1 and 2 are the two objects, 3 is the world.
-- Each object gets its own side, and the world that of the first object.
local function tell(e, n, recipient, name, owner)
  local callback, tells = owner[name], TELLS[name]
  local a, b, side, nx, ny = e.a[n], e.b[n], e.side[n], e.nx[n], e.ny[n]
  if not callback then
    return
  elseif recipient == 2 then
    a, b, side, nx, ny = e.b[n], e.a[n], OPPOSITE[side], 0.0 - nx, 0.0 - ny -- (never -0)
  end
  if tells == "alone" then
    callback(a)
  elseif tells == "axis" then
    callback(a, b, e.c[n], side)
  elseif tells == "place" then
    local x1, y1, x2, y2 = e.x1[n], e.y1[n], e.x2[n], e.y2[n]
    if side == AT_LEFT then
      x1, x2 = before(x1), before(x2)
    elseif side == AT_TOP then
      y1, y2 = before(y1), before(y2)
    end
    callback(a, b, SIDES[side], e.speed[n], x1, y1, x2, y2, nx, ny)
  elseif tells == "speed" then
    callback(a, b, SIDES[side], e.speed[n], nx, ny)
  else
    callback(a, b, SIDES[side])
  end
end

-- Tells one event to the recipients that have not been called yet: its objects and the world.
-- Callbacks may change the later ones, and forget all events.
local function tellAll(b, e, n)
  local name, tells = e.kind[n], TELLS[e.kind[n]]
  while e.heardBy < 3 do
    local recipient = e.heardBy + 1
    local owner = recipient == 3 and b.world or recipient == 1 and e.a[n] or e.b[n]
    local isMeant = recipient ~= 2 or tells ~= "axis" and tells ~= "alone"
    if isMeant then
      checkCallback(b, owner, name)
    end
    e.heardBy = recipient
    if isMeant then
      tell(e, n, recipient, name, owner)
    end
  end
end

--- Forgets all events, told or not.
function events.forget(e)
  for n = 1, e.count do
    e.a[n], e.b[n], e.c[n] = false, false, false
  end
  e.count, e.told, e.heardBy, e.sorted = 0, 0, 3, 0
end

--- Puts the events that are not in order yet in order, behind the others.
function events.arrange(e)
  local order, late, sorted, count = e.order, e.late, e.sorted, e.count - e.sorted
  for n = 1, count do
    late[n] = order[sorted + n]
  end
  sort.by(late, count, e.leant, e.rankA, e.rankB)
  for n = 1, count do
    order[sorted + n] = late[n]
  end
  e.sorted = e.count
end

--- Tells the game all events, in batches (see `arrange`). In a batch, pairs are in the order of the
--- world, and contacts that begin without a hit come last. An error in a callback passes through;
--- the next call tells the rest. `isOld`: only the events that an error has left: events that
--- `save` has noticed wait for the end of the step, as they do without `save`.
function events.tell(b, isOld)
  local e = b.events
  if e.count == 0 or (isOld and e.told == 0) then
    return
  end
  -- The list is put in order first, since events that an error delays are part of the state.
  events.arrange(e)
  tellAll(b, e, e.order[e.told]) -- the rest of an event that an error has interrupted
  while e.told < e.count do
    if e.told == e.sorted then
      events.arrange(e) -- callbacks may have ended contacts
    end
    local n = e.order[e.told + 1]
    e.told, e.heardBy = e.told + 1, 0
    tellAll(b, e, n)
  end
  events.forget(e)
end

return events
