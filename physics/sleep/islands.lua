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

-- Lists the island of an awake dynamic object in `b.island`. Returns its size, and whether none of
-- it would do anything in the next step.
local function gather(b, i, stamp)
  local island, kind, awake, quiet, visited = b.island, b.kind, b.awake, b.quiet, b.visited
  local head, other, nextHalf = b.head, b.other, b.next
  local count, n, calm = 1, 1, true
  island[1] = i
  visited[i] = stamp
  while n <= count do
    local member = island[n]
    calm = calm and quiet[member]
    local half = head[member]
    while half ~= 0 do
      local j = other[half]
      if kind[j] == DYNAMIC and awake[j] and visited[j] ~= stamp then
        visited[j] = stamp
        count = count + 1
        island[count] = j
      elseif kind[j] ~= DYNAMIC and awake[j] then
        calm = calm and quiet[j]
      end
      half = nextHalf[half]
    end
    n = n + 1
  end
  return count, calm
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
