--- Islands: computes from the last step which bodies may sleep. A sleeping body is not computed.
--
-- Objects with fat boxes that meet, directly or through others, form an island. If the last step
-- changed no bit in an island and nothing in it has any speed, the next step would be the same. So
-- its movers fall asleep together, and are obstacles that do not move. Whatever could make a
-- difference wakes the whole island before it could have an effect:
--
-- - a field that the game wrote;
-- - a new or lost neighbour;
-- - a moving kinematic object;
-- - a path that comes near.
--
-- So sleeping changes no result. A kinematic object sleeps alone: as long as it stands, it is only
-- a wall.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")

local rest = {}

local STATIC, DYNAMIC = columns.STATIC, columns.DYNAMIC
local max, min = math.max, math.min

--- The shortest step in which bodies fall asleep, s: what happens in a shorter one may be too
--- little to show. In a shorter step no sleeping body is skipped either: what a long step takes
--- back may be too little in a short one.
rest.SHORTEST = 1 / 2000

local function rouse(b, i)
  local n = b.awakeCount + 1
  b.awakeCount = n
  b.awakeList[n] = i
  b.awakeAt[i] = n
  b.awake[i] = true
  b.quiet[i] = false
  b.awakenings = b.awakenings + 1
  if b.flying[i] then
    b.flying[i] = false
    columns.stand(b, i)
  end
end

-- Wakes the sleeping dynamic neighbours of all bodies in awakeList from place `from` on. The list
-- itself is the queue of this flood fill.
local function flood(b, from)
  local list, kind, awake = b.awakeList, b.kind, b.awake
  local head, other, nextHalf = b.head, b.other, b.next
  local n = from
  while n <= b.awakeCount do
    local half = head[list[n]]
    while half ~= 0 do
      local j = other[half]
      if kind[j] == DYNAMIC and not awake[j] then
        rouse(b, j)
      end
      half = nextHalf[half]
    end
    n = n + 1
  end
end

--- Wakes an object and, if it slept, its island.
function rest.wake(b, i)
  if b.kind[i] == STATIC or not b.active[i] then
    return
  end
  b.quiet[i] = false
  if not b.awake[i] then
    local from = b.awakeCount + 1
    rouse(b, i)
    flood(b, from)
  end
end

--- Wakes all neighbours of an object, which may be static.
function rest.wakeNeighbours(b, i)
  local half = b.head[i]
  while half ~= 0 do
    rest.wake(b, b.other[half])
    half = b.next[half]
  end
end

--- Wakes all bodies, for example because a setting has changed.
function rest.wakeAll(b)
  for n = 1, b.moverCount do
    rest.wake(b, b.movers[n])
  end
end

--- Takes an object out of the list of awake bodies.
function rest.drop(b, i)
  b.flying[i] = false
  if b.awake[i] then
    local at, last = b.awakeAt[i], b.awakeList[b.awakeCount]
    b.awakeList[at] = last
    b.awakeAt[last] = at
    b.awakeCount = b.awakeCount - 1
    b.awake[i] = false
    b.awakenings = b.awakenings + 1
  end
end

-- Puts an object to sleep. It is an obstacle for others until it wakes.
local function sleep(b, i)
  columns.stand(b, i)
  rest.drop(b, i)
end

-- Returns whether a speed limit takes off some of the pull on k in a step of `longest` s.
local function isCapped(b, k, limit, longest)
  local pull = b.flowPull[k] + b.push[k]
  return max(pull, -pull) * longest > min(limit, b.fastest[k], -b.slowest[k])
end

-- Returns whether k is pulled, and only friction holds it there.
local function isRubbed(b, k)
  local pull = b.flowPull[k] + b.push[k]
  return pull > 0 and not b.pressedHigh[k] or pull < 0 and not b.pressedLow[k]
end

-- Returns whether k is pulled towards a body that only friction holds. (A body that is woken in the
-- middle of a step may be pushed before it has rubbed; this one must have rubbed first.)
local function leansOnRubbed(b, k)
  local pull = b.flowPull[k] + b.push[k]
  return pull > 0 and b.pressedHigh[k] and b.heldHigh[k] == 0
    or pull < 0 and b.pressedLow[k] and b.heldLow[k] == 0
end

-- Lists the island of an awake dynamic object in `b.island`. Returns its size, and whether all of
-- it may sleep: whether none of it would do anything in the next step, however long that is. A
-- speed limit may take off some of the pull, or of what presses. Then friction may bear the rest in
-- a long step and not in a short one, or the other way round.
local function gather(b, i, stamp)
  local island, kind, awake, quiet, visited = b.island, b.kind, b.awake, b.quiet, b.visited
  local head, other, nextHalf, maxSpeed = b.head, b.other, b.next, b.maxSpeed
  local longest = max(b.world.maxStep, b.world.timestep or 0)
  local count, n, calm, capped, rubbed = 1, 1, true, false, false
  island[1] = i
  visited[i] = stamp
  while n <= count do
    local member = island[n]
    calm = calm and quiet[member]
    if calm then
      local k, limit = 2 * member, maxSpeed[member]
      capped = capped or isCapped(b, k, limit, longest) or isCapped(b, k + 1, limit, longest)
      rubbed = rubbed or isRubbed(b, k) or isRubbed(b, k + 1)
      local leans = leansOnRubbed(b, k) or leansOnRubbed(b, k + 1)
      calm = not leans or b.stillAt[member] == b.solveStamp
    end
    local half = head[member]
    while half ~= 0 do
      local j = other[half]
      if kind[j] ~= STATIC and awake[j] then
        if kind[j] ~= DYNAMIC then
          calm = calm and quiet[j]
        elseif visited[j] ~= stamp then
          visited[j] = stamp
          count = count + 1
          island[count] = j
        end
      end
      half = nextHalf[half]
    end
    n = n + 1
  end
  return count, calm and not (capped and rubbed)
end

--- Puts every island to sleep that is calm after a step of dt s.
function rest.settle(b, dt)
  if dt < rest.SHORTEST then
    return
  end
  b.stamp = b.stamp + 1
  local stamp, list, kind, quiet, visited = b.stamp, b.awakeList, b.kind, b.quiet, b.visited
  for n = b.awakeCount, 1, -1 do
    local i = list[n]
    -- Sleeping bodies are dropped from the list, which may bring others to this place.
    if i and n <= b.awakeCount and quiet[i] and visited[i] ~= stamp then
      if kind[i] ~= DYNAMIC then
        sleep(b, i)
      else
        local count, calm = gather(b, i, stamp)
        if calm then
          for m = 1, count do
            sleep(b, b.island[m])
          end
        end
      end
    end
  end
end

return rest
