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

local KINEMATIC, DYNAMIC = constants.KINEMATIC, constants.DYNAMIC

-- Computes the path of a kinematic object on an axis. It moves to where the game has written it,
-- and further by its own velocity. If the update has several steps, the written way is spread over
-- those that remain. Otherwise a platform would hurry ahead, hit things, and then wait.
local function moveKinematic(b, k, dt)
  local v, goal = b.velocity[k], b.written[k] + b.wayLeft[k]
  b.displacement[k] = (b.written[k] - b.from[k] + b.wayLeft[k]) / b.remaining
  b.to[k] = (b.remaining > 1 and b.from[k] + b.displacement[k] or goal) + v * dt
  b.writtenSpeed[k] = b.displacement[k] / dt
  b.speed[k], b.accel[k] = v + b.writtenSpeed[k], 0
end

-- Computes the free flight of dynamic bodies: speed at the end, and way.
local function findFlights(b, dt)
  local list, kind, isFree, air = b.awakeList, b.kind, b.isFree, b.flowAir
  local velocity, pull, push, speed, displacement =
    b.velocity, b.flowPull, b.push, b.speed, b.displacement
  for n = 1, b.awakeCount do
    local i = list[n]
    local k, m = 2 * i, 2 * i + 1
    if kind[i] == DYNAMIC and isFree[i] and air[i] == 0 then
      -- (The usual case: without a compiler a call would cost more than the work. So `path.pullOf`
      -- is written out here: pull + push.)
      local x, y = velocity[k], velocity[m]
      local endX, endY = x + (pull[k] + push[k]) * dt, y + (pull[m] + push[m]) * dt
      speed[k], speed[m] = endX, endY
      displacement[k], displacement[m] = (x + endX) * 0.5 * dt, (y + endY) * 0.5 * dt
    elseif kind[i] == DYNAMIC then
      forces.flight(b, i, dt)
    end
  end
end

-- Holds a buried body where it is, and a crowd that would fall.
local function holdBack(b, i)
  for k = 2 * i, 2 * i + 1 do
    if b.buried[i] then
      path.finish(b, k, b.from[k], 0.0, 0.0)
    elseif b.speed[k] * b.down[k] > 0 then
      b.displacement[k] = 0.0
      path.finish(b, k, b.from[k], b.carried[k], 0.0)
    end
  end
end

-- Computes where bodies would end, and how fast they would be then: free flight, before any contact
-- acts. (One pass, with both axes written out: without a compiler that is half of the work for a
-- body that meets nothing.)
local function findEnds(b, dt)
  local list, kind, from, to, displacement = b.awakeList, b.kind, b.from, b.to, b.displacement
  local speed, carried, accel, start, freeSpeed = b.speed, b.carried, b.accel, b.start, b.freeSpeed
  local buried, crowd, give, inverseMass = b.buried, b.crowd, b.give, b.inverseMass
  local origin, isFree, velocity = b.origin, b.isFree, b.velocity
  for n = 1, b.awakeCount do
    local i = list[n]
    local k, m, inverse = 2 * i, 2 * i + 1, inverseMass[i]
    local x, y = from[k], from[m]
    origin[k], origin[m] = x, y
    if kind[i] == DYNAMIC then
      to[k], speed[k] = x + displacement[k] + carried[k] * dt, speed[k] + carried[k]
      to[m], speed[m] = y + displacement[m] + carried[m] * dt, speed[m] + carried[m]
    end
    if buried[i] or crowd[k] > 0 then
      holdBack(b, i)
      inverse = buried[i] and 0 or inverse
    end
    local endX, endY = speed[k], speed[m]
    give[k], give[m], freeSpeed[k], freeSpeed[m] = inverse, inverse, endX, endY
    if kind[i] == DYNAMIC then
      local startX, startY = velocity[k], velocity[m]
      if not isFree[i] then
        startX, startY = forces.limit(b, i, startX, startY)
      end
      startX, startY = startX + carried[k], startY + carried[m]
      start[k], start[m] = startX, startY
      accel[k], accel[m] = (endX - startX) / dt, (endY - startY) / dt
    else
      start[k], start[m] = endX, endY
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

--- Gives a path to each awake body. The solver may wake others: then all are computed anew.
function move.run(b, dt)
  path.begin(b)
  if b.hasZones then
    zones.run(b, b.awakeList, b.awakeCount, dt * 0.5)
  end
  findFlights(b, dt)
  if b.hasLimits then
    forces.hinder(b, dt)
  end
  if b.hasCarriers or b.drifts then
    carry(b, dt)
  end
  if b.driftedCount > 0 then
    drift.add(b)
  end
  findEnds(b, dt)
end

return move
