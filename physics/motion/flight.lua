--- Free flight: what is near nothing moves like a point.
--
-- A dynamic body without neighbours, on which nothing acts but gravity and drift, flies on as long
-- as its path stays in its fat box: nothing can be met there. It takes no part in the step. What
-- comes near wakes it, as it wakes what rests, and it is computed then as if it had been awake from
-- the beginning of the step. So this changes no result.
--
-- Reads position, velocity, pull, drift and the fat boxes of the bodies in b.flyers; writes
-- position, velocity and the fields x, y, vx, vy and touching of the game's objects.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local pairFinder = require(root .. ".broadphase.pairFinder")
local islands = require(root .. ".sleep.islands")

local flight = {}

local DYNAMIC = columns.DYNAMIC

-- Gives what still flies the path of this step; returns how many. What acts on them is as in
-- `forces` and `move`, to the bit.
local function predict(b, dt)
  local list, flying, n = b.flyers, b.flying, 0
  local position, velocity, pull, drift, to = b.position, b.velocity, b.pull, b.softSpeed, b.to
  for m = 1, b.flyerCount do
    local i = list[m]
    if flying[i] then
      local k, l = 2 * i, 2 * i + 1
      local x, y, vx, vy = position[k], position[l], velocity[k], velocity[l]
      n = n + 1
      list[n] = i
      to[k] = x + ((vx + (vx + pull[k] * dt)) * 0.5 * dt + drift[k] * dt)
      to[l] = y + ((vy + (vy + pull[l] * dt)) * 0.5 * dt + drift[l] * dt)
    end
  end
  return n
end

-- Wakes what has neighbours now, and so takes part in this step, and what stands.
local function wakeMet(b)
  local list, head, from, to = b.flyers, b.head, b.from, b.to
  for n = 1, b.flyerCount do
    local i = list[n]
    local k = 2 * i
    if head[i] ~= 0 or (from[k] == to[k] and from[k + 1] == to[k + 1]) then
      islands.wake(b, i)
    end
  end
end

--- Finds the paths of what flies in a step of dt s. Until then it stands where it is.
function flight.begin(b, dt)
  b.flyerCount = predict(b, dt)
  if b.flyerCount > 0 then
    pairFinder.follow(b, b.flyers, b.flyerCount)
    wakeMet(b)
  end
end

-- Whether the past of slot i, which has no neighbours, says anything of its next step.
local function hasPast(b, i)
  local k = 2 * i
  return b.news[i]
    or b.buried[i]
    or b.inside[i]
    or b.carrier[i] ~= 0
    or b.crowd[k] ~= 0
    or b.carried[k] ~= 0
    or b.carried[k + 1] ~= 0
    or b.kept[k] ~= 0
    or b.kept[k + 1] ~= 0
    or b.packed[k] ~= 0
    or b.wasCrushed[k]
    or b.wasCrushed[k + 1]
end

-- Whether slot i goes on to move. What does not will rest.
local function isMoving(b, i)
  local velocity, pull, drift, k = b.velocity, b.pull, b.softSpeed, 2 * i
  return velocity[k] ~= 0
    or velocity[k + 1] ~= 0
    or pull[k] ~= 0
    or pull[k + 1] ~= 0
    or drift[k] ~= 0
    or drift[k + 1] ~= 0
end

-- Lets fly from here on what is awake and near nothing.
local function admit(b)
  local list, kind, bare, head = b.awakeList, b.kind, b.bare, b.head
  local flyers, flying = b.flyers, b.flying
  for n = b.awakeCount, 1, -1 do
    local i = list[n]
    if head[i] == 0 and bare[i] and kind[i] == DYNAMIC and isMoving(b, i) and not hasPast(b, i) then
      islands.drop(b, i)
      b.flyerCount = b.flyerCount + 1
      flyers[b.flyerCount], flying[i] = i, true
      columns.stand(b, i)
    end
  end
end

-- Moves what has flown through the whole step; returns how many.
local function move(b, dt)
  local list, flying, objects, tables = b.flyers, b.flying, b.object, b.touching
  local position, velocity, written, to, pull = b.position, b.velocity, b.written, b.to, b.pull
  local from, n = b.from, 0
  for m = 1, b.flyerCount do
    local i = list[m]
    if flying[i] then
      local object, k, l = objects[i], 2 * i, 2 * i + 1
      local x, y = to[k], to[l]
      local vx, vy = velocity[k] + pull[k] * dt, velocity[l] + pull[l] * dt
      n = n + 1
      list[n] = i
      object.x, object.y, object.vx, object.vy, object.touching = x, y, vx, vy, tables[i]
      position[k], position[l], velocity[k], velocity[l] = x, y, vx, vy
      written[k], written[l], from[k], from[l] = x, y, x, y
    end
  end
  return n
end

--- Ends the step: moves what has flown through it, and lets others fly from here on.
function flight.finish(b, dt)
  b.flyerCount = move(b, dt)
  if b.rest and dt >= islands.SHORTEST then
    admit(b)
  end
end

return flight
