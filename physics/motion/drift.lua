---@diagnostic disable
--- Soft crowds: computes how fast bodies of soft groups drift apart, and adds that to their paths.
--
-- Two that overlap get a velocity apart along the line between their middles, in proportion to how
-- deep: `soft` px/s on the longer axis for two at one place, shared by their masses. The velocities
-- of all its pairs add up to the *drift* of a body, which is at most the largest `soft` of its
-- group. It is added to the path of this step and taken off again after it, so that what is solid
-- stops it as any other motion.
--
-- Those that overlap are found in strips across the axis along which they are more spread out,
-- sorted by counting: a body is compared with what begins in its own strip after it, and in the
-- strips up to its far edge. Sums do not depend on that order: all velocities are rounded to
-- multiples of 2^-20 px/s, which add up exactly.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local filter = require(root .. ".broadphase.filter")
local islands = require(root .. ".sleep.islands")

local drift = {}

local DYNAMIC = columns.DYNAMIC
local ceil, floor, huge, max, min, sqrt =
  math.ceil, math.floor, math.huge, math.max, math.min, math.sqrt

-- Adding it and taking it off again rounds what is below 2^31 to a multiple of 2^-20.
local ROUNDING = 6442450944.0
-- Less than that part of their size apart, two are at one place.
local NEAREST = 1e-6
-- A step is made in parts, in which the drift changes by little; at most so many.
local STIFFNESS, MOST_PARTS = 6, 16
-- Strips for a body of mean size.
local FINE = 4
-- Directions in which two at one place part, by the order of the world.
---@type table<number, number>
local WAYS_X = { 1.0, 0.25, 0.5, -1.0, 1.0, 0.75, -0.5, 0.5 }
---@type table<number, number>
local WAYS_Y = { 0.5, 1.0, 1.0, 0.75, 0.25, -1.0, 1.0, -1.0 }

-- Returns the scratch lists of a world.
local function newWork()
  return {
    count = 0, -- bodies of soft groups
    slot = {}, -- of each, and what follows, in the order of the world
    at = { [0] = {}, {} }, -- by axis: of its middle, px
    half = { [0] = {}, {} }, -- by axis: half of its size, px
    row = {}, -- the row of its group in the setting, and the name of that
    name = {},
    most = {}, -- px/s: the largest of that row
    plain = {}, -- its mass if it has no mask, `hits`, strength, and can be pushed; else false
    start = {}, -- of each strip: where it begins in `sorted`
    strip = {}, -- of each body
    sorted = {},
    place = { [0] = {}, {} }, -- middle and half size in that order
    reach = { [0] = {}, {} },
    one = {}, -- pairs that overlap
    other = {},
    partSpeed = {}, -- px/s, of each pair
    shareOne = {},
    shareOther = {},
    now = { [0] = {}, {} }, -- by axis: velocity apart in a part of the step
    drifted = {}, -- slots with a drift: b.driftedCount
    speed = {}, -- by index: velocity at the end of the step without it
  }
end

-- Lists the bodies of the soft groups, in the order of the world.
local function list(b, work)
  local groups, n, from, size = b.registry.groups, 0, b.from, b.size
  for g = 1, #groups do
    local name, movers = groups[g].name, groups[g].movers
    local row, most = b.soft[name], 0.0
    for other = 1, row and #groups or 0 do
      most = max(most, row[groups[other].name] or 0)
    end
    for m = 1, row and #movers or 0 do
      local i = movers[m]
      if b.active[i] and not b.sensor[i] then
        n = n + 1
        work.slot[n], work.row[n], work.name[n], work.most[n] = i, row, name, most
        local isPlain = b.power[i] == 0 and b.kind[i] == DYNAMIC and b.pushable[i]
        work.plain[n] = isPlain and not (b.mask[i] or b.only[i] or b.masks) and b.mass[i]
        for axis = 0, 1 do
          local half = size[2 * i + axis] * 0.5
          work.at[axis][n], work.half[axis][n] = from[2 * i + axis] + half, half
        end
      end
    end
  end
  work.count = n
end

-- Returns where the bodies begin and end on an axis, px, and the sum of their sizes there.
local function extent(work, axis)
  local at, half, low, high, sum = work.at[axis], work.half[axis], huge, -huge, 0.0
  for n = 1, work.count do
    low, high = min(low, at[n] - half[n]), max(high, at[n])
    sum = sum + (2 * half[n] + ROUNDING - ROUNDING)
  end
  return low, high, sum
end

-- Sorts the bodies by strips across an axis; `part`: strips for each px.
local function sortStrips(work, axis, low, part, strips)
  local at, half, strip, start = work.at[axis], work.half[axis], work.strip, work.start
  for s = 0, strips + 1 do
    start[s] = 0
  end
  for n = 1, work.count do
    local s = floor((at[n] - half[n] - low) * part)
    strip[n], start[s] = s, start[s] + 1
  end
  local sum = 1
  for s = 0, strips + 1 do
    sum = sum + start[s]
    start[s] = sum -- where the next one begins
  end
  for n = work.count, 1, -1 do
    local s = strip[n]
    start[s] = start[s] - 1
    work.sorted[start[s]] = n
  end
  for k = 0, 1 do
    local its, itsHalf, place, reach = work.at[k], work.half[k], work.place[k], work.reach[k]
    for p = 1, work.count do
      place[p], reach[p] = its[work.sorted[p]], itsHalf[work.sorted[p]]
    end
  end
end

-- Lists those that overlap. Returns how many pairs there are, and the mean size, px.
local function findOverlaps(work)
  local lowX, highX, width = extent(work, 0)
  local lowY, highY, height = extent(work, 1)
  local axis = highX - lowX >= highY - lowY and 0 or 1
  local low, long, count = axis == 0 and lowX or lowY, max(highX - lowX, highY - lowY), 0
  local mean = max((width + height) / (2 * work.count), columns.TINY)
  local part = FINE / max(mean, long / work.count)
  local strips = floor(long * part)
  sortStrips(work, axis, low, part, strips)
  local along, across, wide, high =
    work.place[axis], work.place[1 - axis], work.reach[axis], work.reach[1 - axis]
  local sorted, start, one, other = work.sorted, work.start, work.one, work.other
  for p = 1, work.count do
    local x, y, w, h = along[p], across[p], wide[p], high[p]
    for q = p + 1, start[min(floor((x + w - low) * part), strips) + 1] - 1 do
      local dx, dy, reachX, reachY = along[q] - x, across[q] - y, w + wide[q], h + high[q]
      if dy < reachY and -dy < reachY and dx < reachX and -dx < reachX then
        count = count + 1
        one[count], other[count] = sorted[p], sorted[q]
      end
    end
  end
  return count, mean
end

-- Returns the shares of what takes two apart: 0 for what is not moved by the other.
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
-- how many. Notes how fast they part, and the share of each. (Most are alike: asking all would make
-- a step a twentieth longer.)
local function keepSoft(b, work, count)
  local slot, plain, kept = work.slot, work.plain, 0
  for c = 1, count do
    local m, n = work.one[c], work.other[c]
    local i, j, speed = slot[m], slot[n], work.row[m][work.name[n]]
    local areAlike = plain[m] and plain[m] == plain[n]
    if speed and (areAlike or not (filter.refusal(b, i, j) or filter.refusal(b, j, i))) then
      local shareOne, shareOther = 0.5, 0.5
      if not areAlike then
        shareOne, shareOther = weigh(b, i, j)
      end
      kept = kept + 1
      work.one[kept], work.other[kept], work.partSpeed[kept] = m, n, speed
      work.shareOne[kept], work.shareOther[kept] = shareOne, shareOther
    end
  end
  return kept
end

-- Returns a way in which two at one place part.
local function wayOf(b, i, j)
  local at = b.rank[i] + b.rank[j]
  at = at - floor(at / #WAYS_X) * #WAYS_X + 1
  local sign = b.rank[i] < b.rank[j] and 1 or -1
  return WAYS_X[at] * sign * NEAREST, WAYS_Y[at] * sign * NEAREST
end

-- Adds up what each pair does to both.
local function push(b, work, count)
  local x, y, halfX, halfY = work.at[0], work.at[1], work.half[0], work.half[1]
  local nowX, nowY, shareOne, shareOther = work.now[0], work.now[1], work.shareOne, work.shareOther
  for n = 1, work.count do
    nowX[n], nowY[n] = 0.0, 0.0
  end
  for c = 1, count do
    local m, n = work.one[c], work.other[c]
    local dx, dy = (x[n] - x[m]) / (halfX[m] + halfX[n]), (y[n] - y[m]) / (halfY[m] + halfY[n])
    local far = max(dx, -dx, dy, -dy)
    if far < NEAREST then
      dx, dy = wayOf(b, work.slot[m], work.slot[n])
      far = NEAREST
    end
    local v = work.partSpeed[c] * max(1 / far - 1, 0.0)
    local vx, vy = v * dx, v * dy
    nowX[m] = nowX[m] - (vx * shareOne[c] + ROUNDING - ROUNDING)
    nowY[m] = nowY[m] - (vy * shareOne[c] + ROUNDING - ROUNDING)
    nowX[n] = nowX[n] + (vx * shareOther[c] + ROUNDING - ROUNDING)
    nowY[n] = nowY[n] + (vy * shareOther[c] + ROUNDING - ROUNDING)
  end
end

-- Moves the bodies for a part of the step, and adds this part of the drift to the whole.
local function advance(b, work, part, dt)
  local slot, most, softSpeed, velocity = work.slot, work.most, b.softSpeed, b.velocity
  local x, y, nowX, nowY = work.at[0], work.at[1], work.now[0], work.now[1]
  for n = 1, work.count do
    local k, limit, dx, dy = 2 * slot[n], most[n], nowX[n], nowY[n]
    local square = dx * dx + dy * dy
    if square > limit * limit then
      local share = limit / sqrt(square)
      dx, dy = dx * share, dy * share
    end
    softSpeed[k], softSpeed[k + 1] = softSpeed[k] + dx * part, softSpeed[k + 1] + dy * part
    x[n] = x[n] + (velocity[k] + dx) * part * dt
    y[n] = y[n] + (velocity[k + 1] + dy) * part * dt
  end
end

-- Lists those that drift, and wakes them. What stands on something drifts across gravity only: it
-- is not lifted off the ground.
local function listDrifted(b, work)
  local softSpeed, down = b.softSpeed, b.down
  for n = 1, work.count do
    local i = work.slot[n]
    local k, m = 2 * i, 2 * i + 1
    if softSpeed[k] ~= 0 or softSpeed[m] ~= 0 then
      b.driftedCount = b.driftedCount + 1
      work.drifted[b.driftedCount] = i
      islands.wake(b, i)
      if b.support[i] ~= 0 then
        softSpeed[k] = down[k] == 0 and softSpeed[k] or 0
        softSpeed[m] = down[m] == 0 and softSpeed[m] or 0
      end
    end
  end
end

-- Finds the drift of all in a step of dt s.
local function find(b, work, dt)
  local count, size = findOverlaps(work)
  count = keepSoft(b, work, count)
  if count == 0 then
    return
  end
  local fastest = 0.0
  for n = 1, work.count do
    fastest = max(fastest, work.most[n])
  end
  local parts = max(1, min(ceil(fastest / size * dt * STIFFNESS), MOST_PARTS))
  for _ = 1, parts do
    push(b, work, count)
    advance(b, work, 1 / parts, dt)
  end
  listDrifted(b, work)
end

--- Finds the drift of all that are soft to what they overlap, in a step of dt s.
function drift.run(b, dt)
  b.drifts = b.drifts or newWork()
  local work = b.drifts
  for n = 1, b.driftedCount do
    local k = 2 * work.drifted[n]
    b.softSpeed[k], b.softSpeed[k + 1] = 0, 0
  end
  b.driftedCount, work.count = 0, 0
  if b.soft then
    list(b, work)
  end
  if work.count > 1 then
    find(b, work, dt)
  end
end

--- Adds the drift to the free flight of those in awakeList from `first` to `last`.
function drift.add(b, dt, first, last)
  local awakeList, kind, softSpeed, way, speed = b.awakeList, b.kind, b.softSpeed, b.way, b.speed
  local without, carried = b.drifts.speed, b.carried
  for n = first, last do
    local k = 2 * awakeList[n]
    if kind[awakeList[n]] == DYNAMIC then
      without[k], without[k + 1] = speed[k] + carried[k], speed[k + 1] + carried[k + 1]
      way[k], way[k + 1] = way[k] + softSpeed[k] * dt, way[k + 1] + softSpeed[k + 1] * dt
      speed[k], speed[k + 1] = speed[k] + softSpeed[k], speed[k + 1] + softSpeed[k + 1]
    end
  end
end

--- Gives those with a drift the velocity at which they start, drift included, and the acceleration
--- without it.
function drift.start(b, dt)
  local work = b.drifts
  for n = 1, b.driftedCount do
    local i = work.drifted[n]
    for k = 2 * i, 2 * i + 1 do
      b.start[k] = b.freeSpeed[k] - (work.speed[k] - b.start[k])
      b.accel[k] = (b.freeSpeed[k] - b.start[k]) / dt -- to the bit as friction computes it
    end
  end
end

-- Returns the velocity of its own that k has left, of `own`, after it has met something: what has
-- changed its speed has not turned it about.
local function ownAfter(own, speed, change)
  if change < 0 then
    return min(own, max(own + change, speed))
  end
  return max(own, min(own + change, speed))
end

--- Takes the drift off the velocities again, after a step.
function drift.takeOff(b)
  local work = b.drifts
  for n = 1, b.driftedCount do
    local i = work.drifted[n]
    for k = 2 * i, 2 * i + 1 do
      local own, change = work.speed[k], b.speed[k] - b.freeSpeed[k]
      b.speed[k] = change == 0 and own or ownAfter(own, b.speed[k], change)
    end
  end
end

return drift
