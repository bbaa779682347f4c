--- Computes how fast bodies of soft groups drift apart (see drift.lua). It is loaded when a world
--- has such groups.
--
-- Two that overlap get a velocity apart along the line between their middles, in proportion to how
-- deep: `soft` px/s on the longer axis for two at one place, shared by their masses. The velocities
-- of all its pairs add up to the drift of a body, which is at most the largest `soft` of its group.
--
-- Sums do not depend on the order: all velocities are rounded to multiples of 2^-20 px/s, which
-- add up exactly.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local filter = require(root .. ".broadphase.filter")
local islands = require(root .. ".sleep.islands")
local softCells = require(root .. ".motion.softCells")

local soft = {}

local DYNAMIC = columns.DYNAMIC
local ceil, floor, max, min, sqrt = math.ceil, math.floor, math.max, math.min, math.sqrt

-- Adding it and taking it off again rounds what is below 2^31 to a multiple of 2^-20.
local ROUNDING = 6442450944.0
-- Less than that part of their size apart, two are at one place.
local NEAREST = 1e-6
-- A step is made in parts, in which the drift changes by little; at most so many.
local STIFFNESS, MOST_PARTS = 3, 8
-- Directions in which two at one place part, by the order of the world.
---@type table<number, number>
local WAYS_X = { 1.0, 0.25, 0.5, -1.0, 1.0, 0.75, -0.5, 0.5 }
---@type table<number, number>
local WAYS_Y = { 0.5, 1.0, 1.0, 0.75, 0.25, -1.0, 1.0, -1.0 }

--- Returns the scratch lists of a world, for softCells, too.
function soft.new()
  return {
    count = 0, -- bodies of soft groups
    slot = {}, -- of each, and what follows, in the order of the world
    x = {}, -- of its middle, px
    y = {},
    halfX = {}, -- half of its size, px
    halfY = {},
    kind = {}, -- number of its group among the soft ones
    plainMass = {}, -- its mass, if it has no mask, no `hits` and no strength; else false
    cell = {},
    start = {}, -- of each cell: where it begins in `sorted`
    sorted = {},
    sx = {}, -- place and half size in the order of the cells
    sy = {},
    shx = {},
    shy = {},
    large = {},
    from = {}, -- ranges of `sorted` with what may be near one body
    last = {},
    asker = {},
    one = {}, -- those that overlap
    other = {},
    partSpeed = {}, -- px/s, of each pair
    nearX = {}, -- 1/px: how far apart it is when it touches
    nearY = {},
    shareOne = {},
    shareOther = {},
    nowX = {}, -- velocity apart in a part of the step
    nowY = {},
    meanSize = 1, -- px
    drifted = {}, -- slots with a drift
    driftedCount = 0,
    speeds = {}, -- px/s, by kind + kinds * other kind; false: not soft to each other
    most = {}, -- px/s, by kind: the largest of these
    names = {}, -- of the soft groups, by kind
    kinds = 0,
  }
end

-- Lists the bodies of the soft groups, in the order of the world.
local function listGroup(b, work, group, kind, n)
  local movers, from, size = group.movers, b.from, b.size
  local active, sensor, mask, only = b.active, b.sensor, b.mask, b.only
  local power, kindOf, mass, plainMass = b.power, b.kind, b.mass, work.plainMass
  local slot, x, y, halfX, halfY, kinds =
    work.slot, work.x, work.y, work.halfX, work.halfY, work.kind
  for m = 1, #movers do
    local i = movers[m]
    if active[i] and not sensor[i] then
      local k = 2 * i
      local w, h = size[k] * 0.5, size[k + 1] * 0.5
      n = n + 1
      slot[n], x[n], y[n], halfX[n], halfY[n] = i, from[k] + w, from[k + 1] + h, w, h
      kinds[n] = kind
      local isPlain = power[i] == 0 and kindOf[i] == DYNAMIC and not (mask[i] or only[i])
      plainMass[n] = isPlain and mass[i]
    end
  end
  return n
end

local function list(b, work)
  local groups, rows, n, kinds = b.registry.groups, b.soft, 0, 0
  for g = 1, #groups do
    if rows[groups[g].name] then
      kinds = kinds + 1
      n = listGroup(b, work, groups[g], kinds, n)
      work.names[kinds] = groups[g].name
    end
  end
  work.count, work.kinds = n, kinds
end

-- Notes how fast bodies of two soft groups part, by the numbers of these.
local function readSpeeds(b, work)
  local names, kinds = work.names, work.kinds
  for m = 1, kinds do
    work.most[m] = 0.0
    for n = 1, kinds do
      local speed = b.soft[names[m]][names[n]] or false
      work.speeds[m + kinds * n] = speed
      work.most[m] = max(work.most[m], speed or 0)
    end
  end
end

-- Shares of what takes two apart: 0 for what is not moved by the other.
local function weigh(b, i, j)
  local wi, wj = b.inverseMass[i], b.inverseMass[j]
  if b.kind[i] == DYNAMIC and b.kind[j] == DYNAMIC and b.power[i] ~= b.power[j] then
    wi, wj = b.power[i] < b.power[j] and wi or 0, b.power[j] < b.power[i] and wj or 0
  elseif not (b.pushable[i] or b.pushable[j]) then
    wi, wj = 0, 0
  end
  local total = max(wi + wj, columns.TINY)
  return wi / total, wj / total
end

-- Of those that overlap, keeps those that are soft to each other and not refused by a mask; returns
-- how many. Notes how fast they part, and the share of each.
local function keepSoft(b, work, count)
  local one, other, slot, kind, speeds, kinds =
    work.one, work.other, work.slot, work.kind, work.speeds, work.kinds
  local partSpeed, shareOne, shareOther = work.partSpeed, work.shareOne, work.shareOther
  local halfX, halfY, nearX, nearY = work.halfX, work.halfY, work.nearX, work.nearY
  local plainMass, masks, kept = work.plainMass, b.masks, 0
  for c = 1, count do
    local m, n = one[c], other[c]
    local speed, mass = speeds[kind[m] + kinds * kind[n]], plainMass[m]
    local isEven = mass and mass == plainMass[n] and not masks
    if speed and not isEven then
      local i, j = slot[m], slot[n]
      if filter.refusal(b, i, j) or filter.refusal(b, j, i) then
        speed = false
      end
      shareOne[kept + 1], shareOther[kept + 1] = weigh(b, i, j)
    elseif speed then
      shareOne[kept + 1], shareOther[kept + 1] = 0.5, 0.5
    end
    if speed then
      kept = kept + 1
      one[kept], other[kept], partSpeed[kept] = m, n, speed
      nearX[kept], nearY[kept] = 1 / (halfX[m] + halfX[n]), 1 / (halfY[m] + halfY[n])
    end
  end
  return kept
end

-- A way in which two at one place part.
local function wayOf(b, i, j)
  local at = b.rank[i] + b.rank[j]
  at = at - floor(at / #WAYS_X) * #WAYS_X + 1
  local sign = b.rank[i] < b.rank[j] and 1 or -1
  return WAYS_X[at] * sign * NEAREST, WAYS_Y[at] * sign * NEAREST
end

-- Adds up what each pair does to both.
local function push(b, work, count)
  local one, other, partSpeed, shareOne, shareOther =
    work.one, work.other, work.partSpeed, work.shareOne, work.shareOther
  local x, y, nearX, nearY, nowX, nowY =
    work.x, work.y, work.nearX, work.nearY, work.nowX, work.nowY
  for n = 1, work.count do
    nowX[n], nowY[n] = 0.0, 0.0
  end
  for c = 1, count do
    local m, n = one[c], other[c]
    local dx, dy = (x[n] - x[m]) * nearX[c], (y[n] - y[m]) * nearY[c]
    local far = max(dx, -dx, dy, -dy)
    if far < 1 then
      if far < NEAREST then
        dx, dy = wayOf(b, work.slot[m], work.slot[n])
        far = NEAREST
      end
      local v, share = partSpeed[c] * (1 / far - 1), shareOne[c]
      local vx, vy = v * share * dx + ROUNDING - ROUNDING, v * share * dy + ROUNDING - ROUNDING
      nowX[m], nowY[m] = nowX[m] - vx, nowY[m] - vy
      if share ~= shareOther[c] then
        share = shareOther[c]
        vx, vy = v * share * dx + ROUNDING - ROUNDING, v * share * dy + ROUNDING - ROUNDING
      end
      nowX[n], nowY[n] = nowX[n] + vx, nowY[n] + vy
    end
  end
end

-- Moves the bodies for a part of the step, and adds this part of the drift to the whole.
local function advance(b, work, part, dt)
  local slot, kind, most, drifts, velocity =
    work.slot, work.kind, work.most, b.softSpeed, b.velocity
  local x, y, nowX, nowY = work.x, work.y, work.nowX, work.nowY
  for n = 1, work.count do
    local k, limit, dx, dy = 2 * slot[n], most[kind[n]], nowX[n], nowY[n]
    local square = dx * dx + dy * dy
    if square > limit * limit then
      local share = limit / sqrt(square)
      dx, dy = dx * share, dy * share
    end
    drifts[k], drifts[k + 1] = drifts[k] + dx * part, drifts[k + 1] + dy * part
    x[n] = x[n] + (velocity[k] + dx) * part * dt
    y[n] = y[n] + (velocity[k + 1] + dy) * part * dt
  end
end

-- Lists those that drift, and wakes them.
local function listDrifted(b, work)
  local slot, drifts, drifted, count = work.slot, b.softSpeed, work.drifted, 0
  for n = 1, work.count do
    local i = slot[n]
    if drifts[2 * i] ~= 0 or drifts[2 * i + 1] ~= 0 then
      count = count + 1
      drifted[count] = i
      islands.wake(b, i)
    end
  end
  work.driftedCount = count
end

-- In how many parts a step of dt s is made, so that what is pressed does not tremble.
local function countParts(work, dt)
  local fastest = 0.0
  for kind = 1, work.kinds do
    fastest = max(fastest, work.most[kind])
  end
  return max(1, min(ceil(fastest / work.meanSize * dt * STIFFNESS), MOST_PARTS))
end

-- Finds the drift in a step of dt s.
local function find(b, work, dt)
  readSpeeds(b, work)
  local count = keepSoft(b, work, softCells.findOverlaps(work))
  if count == 0 then
    return
  end
  local parts = countParts(work, dt)
  for _ = 1, parts do
    push(b, work, count)
    advance(b, work, 1 / parts, dt)
  end
  listDrifted(b, work)
end

--- Writes the drift of all that are soft to what they overlap, in a step of dt s.
function soft.run(b, work, dt)
  list(b, work)
  if work.count > 1 then
    find(b, work, dt)
  end
end

return soft
