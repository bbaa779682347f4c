--- Step 7, publish: whether a pair is in contact at the end of a step, and on which side.
--
-- Reads to, position, hit, pressed...; writes contact, overlapping, wedged, dropping, inside,
-- passing, and notes the events. `publish` asks it only for pairs whose contact does not simply go
-- on. What begins or ends without more to it is found in a compiled loop, everything else is
-- interpreted.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local aabb = require(root .. ".memory.aabb")
local ask = require(root .. ".solver.permission")
local ball = require(root .. ".solver.ball")
local columns = require(root .. ".memory.columns")
local events = require(root .. ".contacts.events")
local interpreted = require(root .. ".memory.jit")
local live = require(root .. ".broadphase.activePairs")
local oneway = require(root .. ".solver.oneWay")
local sort = require(root .. ".memory.sort")

local contact = {}

local DYNAMIC = columns.DYNAMIC
local EPSILON, OPPOSITE = columns.EPSILON, columns.OPPOSITE
local floor, max, min = math.floor, math.max, math.min

-- What `flushSide` says of two that are inside each other.
local INSIDE = -1

-- 1 for a number >= 0, else 0.
local function step(v)
  return max(min(floor(v) + 1, 1), 0)
end

-- The side of the pair's first at which the two are flush at the end of the step, else 0; INSIDE.
-- No branches, so that whatever follows is compiled once.
local function flushSide(b, i, j)
  local to, size, k, m = b.to, b.size, 2 * i, 2 * j
  local x, y = to[m] - to[k], to[m + 1] - to[k + 1]
  local afterX, beforeX = x - size[k], -x - size[m]
  local afterY, beforeY = y - size[k + 1], -y - size[m + 1]
  local gapX, gapY = max(afterX, beforeX), max(afterY, beforeY)
  local apartX, apartY = step(gapX + EPSILON), step(gapY + EPSILON)
  local flushX, flushY = apartX * step(EPSILON - gapX), apartY * step(EPSILON - gapY)
  return flushX * (1 - apartY) * (1 + step(afterX - beforeX))
    + flushY * (1 - apartX) * (3 + step(afterY - beforeY))
    - (1 - apartX) * (1 - apartY)
end

-- The same of any two.
local function endSide(b, i, j)
  if b.hasCircles and ball.isRound(b, i, j) then
    return ball.side(b, i, j)
  end
  return flushSide(b, i, j)
end

-- Whether a side was leant on in this step, by either of the two.
local function isPressed(b, i, j, side)
  local axis = side > 2 and 1 or 0
  local ki, kj = 2 * i + axis, 2 * j + axis
  local iDynamic, jDynamic = b.kind[i] == DYNAMIC, b.kind[j] == DYNAMIC
  if side % 2 == 0 then
    return iDynamic and b.pressedHigh[ki] or jDynamic and b.pressedLow[kj]
  end
  return iDynamic and b.pressedLow[ki] or jDynamic and b.pressedHigh[kj]
end

-- Whether two that are flush on a side and may meet there are in contact.
local function isHeld(b, p, i, j, side)
  return b.contact[p] == side or b.hit[p] == side or b.sideBySide or isPressed(b, i, j, side)
end

-- Remembers how two that are left inside each other came there: they may only part that way.
local function wedge(b, p, i, j)
  if b.deepIn[p] == b.solveStamp then
    b.wedged[p] = b.deepWay[p]
    return
  elseif b.wedged[p] ~= 0 then
    return
  end
  local position, size = b.position, b.size
  for axis = 0, 1 do
    local ki, kj = 2 * i + axis, 2 * j + axis
    local r = position[kj] - position[ki]
    if r - size[ki] >= -EPSILON or -r - size[kj] >= -EPSILON then
      b.wedged[p] = 2 * axis + (r < 0 and 1 or 2)
      return
    end
  end
end

-- Who is dynamic will try to get out (see `part`).
local function leaveInside(b, i, j)
  b.inside[i], b.inside[j] = b.kind[i] == DYNAMIC, b.kind[j] == DYNAMIC
  b.hasInside = true
end

-- The side of slot i by which two that are inside each other would part on the shortest way.
local function shortestSide(b, i, j)
  -- A tie is decided by the order of the world.
  local isSwapped = b.rank[j] < b.rank[i]
  if isSwapped then
    local first = j
    j = i
    i = first
  end
  local to, size, ki, kj = b.to, b.size, 2 * i, 2 * j
  local side = columns.SIDE[aabb.side(
    to[ki],
    to[ki + 1],
    size[ki],
    size[ki + 1],
    to[kj],
    to[kj + 1],
    size[kj],
    size[kj + 1]
  )]
  return isSwapped and OPPOSITE[side] or side
end

-- The side on which a solid pair is in contact now, else 0.
local function solidContact(b, p, i, j)
  local side = endSide(b, i, j)
  b.overlapping[p] = side == INSIDE
  if side == INSIDE then
    if b.passing[p] or b.oneWay[i] or b.oneWay[j] then
      b.wedged[p] = 0
      leaveInside(b, i, j)
      return 0
    end
    wedge(b, p, i, j)
    if b.wedged[p] ~= 0 then
      if b.kind[i] == DYNAMIC and b.kind[j] == DYNAMIC then
        leaveInside(b, i, j)
      end
      return b.wedged[p]
    end
    leaveInside(b, i, j)
    side = b.contact[p] ~= 0 and b.contact[p] or b.hit[p]
    -- What finds no way out touches what it is in.
    return side == 0 and (b.buried[i] or b.buried[j]) and shortestSide(b, i, j) or side
  end
  b.wedged[p] = 0
  if side == 0 then
    b.dropping[p] = false
    return 0
  end
  if b.passing[p] or b.dropping[p] or oneway.lets(b, i, j, side, false) then
    return 0
  end
  return isHeld(b, p, i, j, side) and side or 0
end

-- The side on which a sensor was entered, while the two overlap, else 0.
local function sensorContact(b, p, i, j)
  if endSide(b, i, j) ~= INSIDE or b.passing[p] then
    return 0
  end
  if b.contact[p] ~= 0 then
    return b.contact[p]
  elseif b.hit[p] ~= 0 then
    return b.hit[p]
  end
  return shortestSide(b, i, j)
end

-- The side on which solid pair p, which was not met in this step, will be in contact: one of the
-- two leans on that side on somebody else. Else 0.
local function unmetSide(b, p, i, j)
  local side = endSide(b, i, j)
  if side <= 0 or b.dropping[p] or oneway.lets(b, i, j, side, false) then
    return 0
  end
  return isHeld(b, p, i, j, side) and side or 0
end

-- Lists the pairs about which the game is still to be asked, in the order of the world; returns how
-- many.
local function listUnasked(b, work)
  local pairs, sides, first, second, order =
    work.pairs, work.sides, work.first, work.second, work.order
  local count = 0
  for n = 1, b.liveCount do
    local p = b.live[n]
    local i, j = b.pairA[p], b.pairB[p]
    local isOpen = b.hit[p] == 0 and not b.passing[p] and b.asked[p] ~= b.solveStamp
    if isOpen and ask.isAsked(b, i, j) then
      local side = (b.sensor[i] or b.sensor[j]) and 0 or unmetSide(b, p, i, j)
      if side ~= 0 then
        local one, other = b.rank[i], b.rank[j]
        count = count + 1
        pairs[count], sides[count], order[count] = p, side, count
        first[count], second[count] = min(one, other), max(one, other)
      end
    end
  end
  sort.by(order, count, first, second, second)
  return count
end

--- Asks the game about those who will be in contact without having been met: who stands on two
--- floors is held by one of them. Writes nothing but that they pass, since the game's function may
--- fail.
function contact.ask(b)
  if not b.hasAskers then
    return
  end
  local work = b.unasked
  for n = 1, listUnasked(b, work) do
    local at = work.order[n]
    local p, side = work.pairs[at], work.sides[at]
    local i, j, axis = b.pairA[p], b.pairB[p], side > 2 and 1 or 0
    local isFirstLow = side % 2 == 0
    b.passing[p] = not ask.permits(b, isFirstLow and i or j, isFirstLow and j or i, axis)
    live.stain(b, p)
  end
end

-- Finds out whether pair p is in contact now, and notes what there is to tell of that.
local function update(b, p)
  local i, j = b.pairA[p], b.pairB[p]
  local now
  if b.sensor[i] or b.sensor[j] then
    now = sensorContact(b, p, i, j)
  else
    now = solidContact(b, p, i, j)
  end
  local before = b.contact[p]
  if now == before then
    if now ~= 0 then
      events.stay(b, p, now)
    elseif b.hit[p] ~= 0 then
      events.bounce(b, p, b.hit[p], b.hitSpeed[p])
      b.news[i], b.news[j] = true, true -- it is told as often as it happens
    end
    return
  end
  if before ~= 0 then
    events.finish(b, p, before)
    b.contactCount = b.contactCount - 1
  end
  if now ~= 0 then
    events.begin(b, p, now, b.hit[p] ~= 0 and b.hitSpeed[p] or 0)
    b.contactCount = b.contactCount + 1
  end
  b.contact[p] = now
  b.news[i], b.news[j] = true, true
end

-- Whether somebody wants to be told when a contact begins or ends.
local function hears(listener)
  return listener.onBegin or listener.onEnd or listener.onStay
end

-- Whether where two stand says all about their contact: both are solid on all sides, were not
-- inside each other, and neither wants to hear of it.
local function isPlain(b, p, i, j)
  return b.plain[i]
    and b.plain[j]
    and b.wedged[p] == 0
    and not (b.oneWay[i] or b.oneWay[j] or b.passing[p] or b.dropping[p] or b.overlapping[p])
    and not (hears(b.object[i]) or hears(b.object[j]))
end

-- Updates those of `list[1..listCount]` of which no more than that must be known. Returns how many
-- are left in `list`, and how many are in `touching`.
local function updatePlain(b, list, listCount, touching, count)
  local pairA, pairB, contacts, news, left = b.pairA, b.pairB, b.contact, b.news, 0
  local hit = b.hit
  for n = 1, listCount do
    local p = list[n]
    local i, j, before = pairA[p], pairB[p], contacts[p]
    local side = flushSide(b, i, j)
    if side == INSIDE or not isPlain(b, p, i, j) then
      left = left + 1
      list[left] = p
    else
      local now = side ~= 0 and isHeld(b, p, i, j, side) and side or 0
      if now ~= 0 then
        count = count + 1
        touching[count] = p
      end
      if now ~= before then
        contacts[p], news[i], news[j] = now, true, true
        b.contactCount = b.contactCount + min(now, 1) - min(before, 1)
      elseif now == 0 and hit[p] ~= 0 then
        news[i], news[j] = true, true -- as in `update`: somebody may want to hear of the next one
      end
    end
  end
  return left, count
end

--- Updates the pairs in `list[1..listCount]`, and lists those in contact behind place `count` of
--- `touching`; returns how many these are then.
function contact.updateAll(b, list, listCount, touching, count)
  if not hears(b.world) then
    listCount, count = updatePlain(b, list, listCount, touching, count)
  end
  for n = 1, listCount do
    local p = list[n]
    update(b, p)
    if b.contact[p] ~= 0 then
      count = count + 1
      touching[count] = p
    end
  end
  return count
end

interpreted.functions(
  unmetSide,
  listUnasked,
  contact.ask,
  wedge,
  leaveInside,
  solidContact,
  shortestSide,
  sensorContact,
  update,
  contact.updateAll
)

return contact
