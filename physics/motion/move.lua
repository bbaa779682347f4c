---@diagnostic disable
--- Move: computes the path of every body in this step from its free flight and its carrier, as if
-- nothing were in the way.
--
-- The acceleration of a body is `path.pullOf`: gravity (readFields.pull), the accelerations of
-- zones (zones.run), its own `ax, ay`. Air friction, drag and limits are in forces.lua. From here
-- until objects/write.lua all velocities are absolute. The velocity of a carrier is added here and
-- taken off there.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local carriers = require(root .. ".motion.carriers")
local constants = require(root .. ".memory.constants")
local drift = require(root .. ".memory.lazy")(root .. ".motion.drift")
local forces = require(root .. ".memory.lazy")(root .. ".motion.forces")
local path = require(root .. ".motion.path")
local zones = require(root .. ".memory.lazy")(root .. ".motion.zones")

local move = {}

local KINEMATIC, DYNAMIC, FAR = constants.KINEMATIC, constants.DYNAMIC, constants.FAR
local UNSWEPT = math.huge -- no path ends there

-- Computes the path of a kinematic object on an axis. It moves to where the game has written it,
-- and further by its own velocity. If the update has several steps, the written way is spread over
-- those that remain. Otherwise a platform would hurry ahead, hit things, and then wait.
local function moveKinematic(b, k, dt)
  local v, goal = b.velocity[k], b.written[k] + b.wayLeft[k]
  b.displacement[k] = (b.written[k] - b.from[k] + b.wayLeft[k]) / b.remaining
  b.to[k] = (b.remaining > 1 and b.from[k] + b.displacement[k] or goal) + v * dt
  b.writtenSpeed[k] = b.displacement[k] / dt
  v = v + b.writtenSpeed[k]
  b.start[k], b.speed[k], b.freeSpeed[k], b.accel[k] = v, v, v, 0
  b.held[2 * k + 1], b.held[2 * k + 2] = 1, 1
end

-- Computes the free flight of dynamic bodies, as if nothing carried them: how fast they are when
-- the step begins and when it ends, and where they end. Nothing holds them yet, and nothing was
-- swept. (One pass, with both axes written out: without a compiler that is half of the work for a
-- body that meets nothing.)
local function fly(b, dt)
  local list, kind, isFree, air, brake = b.awakeList, b.kind, b.isFree, b.flowAir, b.flowDrag
  local velocity, pull, push, from, origin = b.velocity, b.flowPull, b.push, b.from, b.origin
  local start, speed, freeSpeed = b.start, b.speed, b.freeSpeed
  local to, displacement, accel, give, inverseMass =
    b.to, b.displacement, b.accel, b.give, b.inverseMass
  local squeezed, held, swept = b.squeezed, b.held, b.swept
  for n = 1, b.awakeCount do
    local i = list[n]
    local k, m, inverse = 2 * i, 2 * i + 1, inverseMass[i]
    local x, y, side = from[k], from[m], 2 * k
    origin[k], origin[m], give[k], give[m], swept[k] = x, y, inverse, inverse, UNSWEPT
    if kind[i] == DYNAMIC then
      squeezed[k], squeezed[m], held[side + 1], held[side + 2] = 0, 0, 0, 0
      held[side + 3], held[side + 4] = 0, 0
      local startX, startY = velocity[k], velocity[m]
      if isFree[i] and air[i] == 0 and brake[i] == 0 then
        -- (The usual case, without a call: `path.pullOf` is written out here, pull + push.)
        local endX, endY = startX + (pull[k] + push[k]) * dt, startY + (pull[m] + push[m]) * dt
        speed[k], speed[m] = endX, endY
        displacement[k], displacement[m] = (startX + endX) * 0.5 * dt, (startY + endY) * 0.5 * dt
      else
        startX, startY = forces.flight(b, i, dt)
      end
      local endX, endY = speed[k], speed[m]
      start[k], start[m], freeSpeed[k], freeSpeed[m] = startX, startY, endX, endY
      to[k], to[m] = x + displacement[k], y + displacement[m]
      accel[k], accel[m] = (endX - startX) / dt, (endY - startY) / dt
    end
  end
end

-- Moves kinematic objects, and reads how fast they carry others.
local function carry(b, dt)
  local list, kind = b.awakeList, b.kind
  for n = 1, b.awakeCount do
    for k = 2 * list[n], kind[list[n]] == KINEMATIC and 2 * list[n] + 1 or 0 do
      moveKinematic(b, k, dt)
    end
  end
  carriers.board(b)
  for n = 1, b.awakeCount do
    local i = list[n]
    if kind[i] == DYNAMIC then
      b.carried[2 * i], b.carried[2 * i + 1] = carriers.velocity(b, b.carrier[i], i)
    end
  end
end

-- Adds to the flight of each body that of its carrier, and holds a buried body where it is, and a
-- crowd that would fall.
local function ride(b, dt)
  local list, kind, carried, accel, to = b.awakeList, b.kind, b.carried, b.accel, b.to
  local start, speed, freeSpeed = b.start, b.speed, b.freeSpeed
  local isNeeded = b.hasCarriers or b.driftedCount > 0 or b.hasOverlaps
  for n = 1, isNeeded and b.awakeCount or 0 do
    local i = list[n]
    local isBuried, isCrowd = b.buried[i], b.crowd[2 * i] > 0
    for k = 2 * i, kind[i] == DYNAMIC and 2 * i + 1 or 0 do
      local gift = carried[k]
      local v = start[k] + gift
      start[k], speed[k], to[k] = v, speed[k] + gift, to[k] + gift * dt
      if isBuried then
        b.give[k], b.held[2 * k + 1], b.held[2 * k + 2] = 0, FAR, FAR
        path.finish(b, k, b.from[k], 0.0, 0.0)
      elseif isCrowd and speed[k] * b.down[k] > 0 then
        b.displacement[k] = 0.0
        path.finish(b, k, b.from[k], gift, 0.0)
      end
      freeSpeed[k], accel[k] = speed[k], (speed[k] - v) / dt
    end
  end
end

--- Gives a path to each awake body. The solver may wake others: then all are computed anew.
function move.run(b, dt)
  path.begin(b)
  if b.zoneList[1] then
    zones.run(b, b.awakeList, b.awakeCount, dt * 0.5)
  end
  fly(b, dt)
  if b.hasCarriers then
    carry(b, dt)
  end
  if b.driftedCount > 0 then
    drift.add(b)
  end
  ride(b, dt)
end

return move
