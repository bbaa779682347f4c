---@diagnostic disable
--- Zones: sensors with an `area` act on the dynamic objects inside them: water, wind, low gravity,
--- attractors.
--
-- A zone acts by the share of the object that is inside, where the object is halfway through the
-- step: so nothing depends on the step in which an edge is crossed.
-- Source: the midpoint method, as in E. Hairer et al., Solving Ordinary Differential Equations I.
--
-- Gravity is that of the last zone in the order of the world, as far as an object is in that (on
-- each axis alone, by shares); all else adds up.
--
-- Reads area, from, velocity, carrier, size, shape, pull, airFriction, drag; writes flowPull,
-- flowAir, flowDrag and down. Without zones objects/readFields.lua writes them.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local carriers = require(root .. ".motion.carriers")
local check = require(root .. ".fields.check")
local constants = require(root .. ".memory.constants")
local filter = require(root .. ".broadphase.filter")
local path = require(root .. ".motion.path")
local shapes = require(root .. ".space.shapes")
local sort = require(root .. ".memory.sort")

local zones = {}

local DYNAMIC, TINY = constants.DYNAMIC, constants.TINY
local max, min, sqrt = math.max, math.min, math.sqrt
-- Share of the radius within which an attractor gets weaker towards its centre.
local CORE = 0.125

-- Areas -------------------------------------------------------------------------------------------

--- Notes that slot i has an area.
function zones.note(b, i)
  local area, list = b.area[i], b.zoneList
  if not check.isAmong(i, list) then
    list[#list + 1] = i
  end
  b.hasLimits = b.hasLimits or (area.drag or 0) > 0
end

-- Puts the list in the order of the world, without those that are zones no more. (Slots at the end
-- may have been given back.)
local function arrange(b)
  local list, count = b.zoneList, 0
  for n = 1, #list do
    local i = list[n]
    list[n] = nil
    if i <= b.slots and b.kind[i] ~= 0 and b.area[i] then
      count = count + 1
      list[count] = i
    end
  end
  sort.by(list, count, b.rank, b.rank, b.rank)
end

-- Shares ------------------------------------------------------------------------------------------

-- Returns where slot i is `time` s after the beginning of the step, x and y, if nothing acts on it.
-- A rider goes with its carrier.
local function placeOf(b, i, time)
  local k, x, y = 2 * i, 0, 0
  if b.hasCarriers and b.kind[i] == DYNAMIC then
    x, y = carriers.velocity(b, b.carrier[i], i)
  end
  return b.from[k] + (b.velocity[k] + x) * time, b.from[k + 1] + (b.velocity[k + 1] + y) * time
end

-- Returns the share of slot i, 0..1, that is in zone j, if zone j acts on it at all.
local function shareIn(b, i, j, time)
  local size, k, m = b.size, 2 * i, 2 * j
  local x, y = placeOf(b, i, time)
  local left, top = placeOf(b, j, time)
  local w, h = size[m], size[m + 1]
  local share = shapes.share(b.shape[j], left, top, w, h, x, y, size[k], size[k + 1])
  local acts = share > 0 and i ~= j and not (filter.refusal(b, i, j) or filter.refusal(b, j, i))
  return acts and share or 0.0
end

-- Forces ------------------------------------------------------------------------------------------

-- Returns how an attractor of 1 px/s² at its rim pulls at d radii from its centre.
local function strength(law, d)
  local far = max(d, CORE)
  local pull = law == "linear" and far
    or law == "inverse" and 1 / far
    or law == "square" and 1 / (far * far)
    or 1.0
  return pull * min(d / CORE, 1.0)
end

-- Adds the attraction of zone j to the accelerations of slot i.
local function attract(b, i, j, share, time)
  local size, k, m, area = b.size, 2 * i, 2 * j, b.area[j]
  local x, y = placeOf(b, i, time)
  local dx, dy = placeOf(b, j, time)
  dx, dy = dx + size[m] * 0.5 - x - size[k] * 0.5, dy + size[m + 1] * 0.5 - y - size[k + 1] * 0.5
  local distance, radius = max(sqrt(dx * dx + dy * dy), TINY), min(size[m], size[m + 1]) * 0.5
  local pull = share * area.attract * strength(area.law, distance / radius) / distance
  b.flowPull[k], b.flowPull[k + 1] = b.flowPull[k] + dx * pull, b.flowPull[k + 1] + dy * pull
end

-- Replaces the gravity of body k by that of a zone, g, for `share` of the body, as far as no zone
-- on top acts on it already.
local function replace(b, k, g, share)
  local taken = min(share, b.zoneLeft[k])
  b.flowPull[k], b.zoneLeft[k] = b.flowPull[k] + (g - b.pull[k]) * taken, b.zoneLeft[k] - taken
end

-- Replaces the gravity of slot i by that of zone j.
local function turn(b, i, j, share)
  local area, k = b.area[j], 2 * i
  replace(b, k, area.gravityX or b.pull[k], area.gravityX and share or 0.0)
  replace(b, k + 1, area.gravity or b.pull[k + 1], area.gravity and share or 0.0)
end

-- Adds the effects of zone j on slot i beyond gravity: `ax, ay` (wind), airFriction, drag and
-- attraction.
local function push(b, i, j, share, time)
  local pull, air, drag, k, area = b.flowPull, b.flowAir, b.flowDrag, 2 * i, b.area[j]
  pull[k] = pull[k] + (area.ax or 0) * share
  pull[k + 1] = pull[k + 1] + (area.ay or 0) * share
  air[i] = air[i] + (area.airFriction or 0) * share
  drag[i] = drag[i] + (area.drag or 0) * share
  if area.attract then
    attract(b, i, j, share, time)
  end
end

-- Applies `turn` or `push` of zone j to the bodies of list[1..count] that are in it.
-- (Kinematic bodies do not read the result.)
local function act(b, list, count, j, time, what)
  for n = 1, b.active[j] and count or 0 do
    local i = list[n]
    local share = shareIn(b, i, j, time)
    if share > 0 then
      what(b, i, j, share, time)
    end
  end
end

-- Gives the bodies in list[1..count] the air friction and drag of their own fields, and finds their
-- gravity, `time` s after the beginning of the step; the last zone is on top.
local function turnAll(b, list, count, time)
  local slots, pull, flowPull, left = b.zoneList, b.pull, b.flowPull, b.zoneLeft
  for n = 1, count do
    local i, k, m = list[n], 2 * list[n], 2 * list[n] + 1
    left[k], left[m], flowPull[k], flowPull[m] = 1, 1, pull[k], pull[m]
    b.flowAir[i], b.flowDrag[i] = b.airFriction[i], b.drag[i]
  end
  for n = #slots, 1, -1 do
    local area = b.area[slots[n]]
    act(b, list, (area.gravity or area.gravityX) and count or 0, slots[n], time, turn)
  end
  for n = 1, count do
    local i = list[n]
    if b.kind[i] == DYNAMIC then
      path.setDown(b, i, b.flowPull[2 * i], b.flowPull[2 * i + 1])
    end
  end
end

--- Finds the forces of zones on the bodies in list[1..count], `time` s after the beginning of the
--- step.
function zones.run(b, list, count, time)
  local slots = b.zoneList
  turnAll(b, list, count, time)
  for n = 1, #slots do
    act(b, list, count, slots[n], time, push)
  end
end

--- Finds the zones, and where "down" is for the bodies in list[1..count], at the beginning of a
--- step.
function zones.begin(b, list, count)
  arrange(b)
  turnAll(b, list, count, 0)
end

return zones
