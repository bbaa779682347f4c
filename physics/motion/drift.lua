---@diagnostic disable
--- Soft crowds: computes how fast bodies of soft groups drift apart, and adds that to their paths.
--
-- Two bodies that overlap get a velocity apart along the line between their middles, in proportion
-- to the depth: `soft` px/s on the axis on which they are further apart, for two bodies at one
-- place. The stronger one does not give way; two of equal strength share it by their masses.
-- The velocities of all its pairs add up to the *drift* of a body, which is at most the largest
-- `soft` of its group. The drift is added to the path of this step and taken off again after it, so
-- that solid objects stop it as any other motion.
--
--      [ a [ ] b ]        Let d be the distance of the middles on an axis, h the sum of the half
--      <-       ->        sizes there, and f the larger d / h of both axes. Then the pair parts at
--       | d  |            soft (1 / f - 1) d / h:  `soft` at one place, 0 when the two touch.
--
-- The places x of a crowd follow x' = v(x), whose stiffness is the rate soft / size (the fastest
-- `soft`, the mean size) times the number of pairs, near ones included, for each body that begins
-- one. One step of v dt overshoots if that rate times dt is above 2: a
-- dense crowd would explode. So a step is made in s parts, the stages of a Runge-Kutta-Legendre
-- scheme, with z = rate * dt:
--
--      Y_n = Y_(n-1) + (n - 1) / n (Y_(n-1) - Y_(n-2)) + (4 n - 2) / (n (s² + s)) v(Y_(n-1)) dt
--
-- It is stable up to z = s² + s, so s grows only with the root of the density:
-- s = ceil(sqrt(z + 1/4) - 1/2), at most MOST_PARTS. (In `advance`, `keep` and `part` are the two
-- factors.) Beyond that, only the limit of the drift bounds it. A drift against the motion of its
-- body slows that further, so that a crowd comes to stand (see `listDrifted`).
--
-- The pairs that overlap, or may in this step, are found once, in cells, sorted by counting: a body
-- is compared with the bodies that begin after it in its row, and in the rows down to its lower
-- edge. Sums do not depend on that order: all velocities are rounded to multiples of 2^-20 px/s,
-- which add up exactly.
--
-- Source: C. D. Meyer, D. S. Balsara, T. D. Aslam, A second-order accurate Super TimeStepping
-- formulation for anisotropic thermal conduction, 2012 (RKL1, the scheme of first order).

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local constants = require(root .. ".memory.constants")
local filter = require(root .. ".broadphase.filter")
local islands = require(root .. ".sleep.islands")

local drift = {}

local DYNAMIC = constants.DYNAMIC
local ceil, floor, huge, max, min, sqrt =
  math.ceil, math.floor, math.huge, math.max, math.min, math.sqrt

-- Adding this number and taking it off again rounds a number below 2^31 to a multiple of 2^-20.
local ROUNDING = 6442450944.0
-- Two bodies are at one place if they are less apart than this share of their size.
local NEAREST = 1e-6
-- Maximum number of parts of a step. There are more parts, the faster near bodies part, and the
-- more pairs a body has.
local MOST_PARTS = 12
-- Share of the way of the fastest drift in a step: bodies that are no further apart may overlap in
-- this step.
local NEAR = 0.5
-- Cells across a body of mean size; height of a row of cells, in such bodies; cells for each body.
local FINE, HIGH, CELLS = 4, 1.5, 4
-- Directions in which two bodies at one place part, by the order of the world.
---@type table<number, number>
local WAYS_X = { 1.0, 0.25, 0.5, -1.0, 1.0, 0.75, -0.5, 0.5 }
---@type table<number, number>
local WAYS_Y = { 0.5, 1.0, 1.0, 0.75, 0.25, -1.0, 1.0, -1.0 }

-- Returns the scratch lists of a world.
local function newWork()
  return {
    count = 0, -- bodies of soft groups
    slot = {}, -- of each; all lists are in the order of the world
    at = { [0] = {}, {} }, -- by axis: of its middle, px
    half = { [0] = {}, {} }, -- by axis: half of its size, px
    row = {}, -- the row of its group in the setting, and the name of that
    name = {},
    most = {}, -- px/s: the largest of that row
    plain = {}, -- its mass if it has no mask, `hits`, strength, and can be pushed; else false
    start = {}, -- of each cell: where it begins in `sorted`
    cell = {}, -- of each body
    sorted = {},
    place = { [0] = {}, {} }, -- middle and half size in that order
    reach = { [0] = {}, {} },
    one = {}, -- pairs that may overlap
    other = {},
    partSpeed = {}, -- px/s, of each pair
    shareOne = {},
    shareOther = {},
    now = { [0] = {}, {} }, -- by axis: velocity apart in a part of the step
    last = { [0] = {}, {} }, -- by axis: velocity that the last part has added to the drift, px/s
    drifted = {}, -- slots with a drift: b.driftedCount
    speed = {}, -- by index: velocity at the end of the step without it
  }
end

-- Lists the bodies of the soft groups, in the order of the world.
local function list(b, work)
  local groups, n, from, size, fastest = b.registry.groups, 0, b.from, b.size, 0.0
  local name, row, most
  for m = 1, b.moverCount do
    local i = b.movers[m]
    if b.groupName[i] ~= name then
      name, row, most = b.groupName[i], b.soft[b.groupName[i]], 0.0
      for other = 1, row and #groups or 0 do
        most = max(most, row[groups[other].name] or 0)
      end
    end
    if row and b.active[i] and not b.sensor[i] then
      n, fastest = n + 1, max(fastest, most)
      work.slot[n], work.row[n], work.name[n], work.most[n] = i, row, name, most
      local isPlain = b.power[i] == 0 and b.kind[i] == DYNAMIC and b.pushable[i]
      work.plain[n] = isPlain and not (b.mask[i] or b.hitsOnly[i] or b.masks) and b.mass[i]
      for axis = 0, 1 do
        local half = size[2 * i + axis] * 0.5
        work.at[axis][n], work.half[axis][n] = from[2 * i + axis] + half, half
        work.now[axis][n], work.last[axis][n] = 0.0, 0.0
      end
    end
  end
  work.count, work.fastest = n, fastest
end

-- Returns where on an axis the first and the last body begin, px, the sum of their sizes there, and
-- the largest one.
local function extent(work, axis)
  local at, half, low, high, sum, largest = work.at[axis], work.half[axis], huge, -huge, 0.0, 0.0
  for n = 1, work.count do
    low, high = min(low, at[n] - half[n]), max(high, at[n] - half[n])
    sum, largest = sum + (2 * half[n] + ROUNDING - ROUNDING), max(largest, 2 * half[n])
  end
  return low, high, sum, largest
end

-- Sorts the bodies by the cells in which they begin, row by row.
local function sortCells(work)
  local x, y, halfX, halfY = work.at[0], work.at[1], work.half[0], work.half[1]
  local cell, start, sorted, across = work.cell, work.start, work.sorted, work.across
  local cells = across * work.rows
  for c = 0, cells do
    start[c] = 0
  end
  for n = 1, work.count do
    local row = floor((y[n] - halfY[n] - work.lowY) * work.partY)
    local c = row * across + floor((x[n] - halfX[n] - work.lowX) * work.partX)
    cell[n], start[c] = c, start[c] + 1
  end
  local sum = 1
  for c = 0, cells do
    sum = sum + start[c]
    start[c] = sum -- where the next one begins
  end
  for n = work.count, 1, -1 do
    local c = cell[n]
    start[c] = start[c] - 1
    sorted[start[c]] = n
  end
  for k = 0, 1 do
    local at, half, place, reach = work.at[k], work.half[k], work.place[k], work.reach[k]
    for p = 1, work.count do
      place[p], reach[p] = at[sorted[p]], half[sorted[p]]
    end
  end
end

-- Returns the shares of the velocity apart that slot i and slot j take; 0: it is not moved.
local function weigh(b, i, j)
  local wi, wj = b.inverseMass[i], b.inverseMass[j]
  if b.kind[i] == DYNAMIC and b.kind[j] == DYNAMIC and b.power[i] ~= b.power[j] then
    wi, wj = b.power[i] < b.power[j] and wi or 0, b.power[j] < b.power[i] and wj or 0
  elseif not (b.pushable[i] or b.pushable[j]) then
    wi, wj = 0, 0
  end
  local total = max(wi + wj, constants.TINY)
  return wi / total, wj / total
end

-- Lists bodies m and n as the pair after `count`, with their shares and the speed at which they
-- part, if they are soft to each other and no mask refuses it. Returns how many pairs there are
-- now. (Most bodies are alike: asking the masks of all would make a step a twentieth longer.)
local function addPair(b, work, count, m, n)
  local i, j, plain = work.slot[m], work.slot[n], work.plain
  local areAlike, speed = plain[m] and plain[m] == plain[n], work.row[m][work.name[n]]
  if speed and (areAlike or not (filter.refusal(b, i, j) or filter.refusal(b, j, i))) then
    count = count + 1
    work.one[count], work.other[count], work.partSpeed[count] = m, n, speed
    work.shareOne[count], work.shareOther[count] = weigh(b, i, j)
  end
  return count
end

-- Lists the pairs of bodies that are no further apart than `near` px: a body with the bodies that
-- begin after it in its row, and in the rows down to its lower edge; `most`: the largest width, px.
-- Returns how many pairs there are, and how many for each body that begins one.
local function listNear(b, work, near, most)
  local x, y, halfX, halfY = work.place[0], work.place[1], work.reach[0], work.reach[1]
  local start, across, partX, partY = work.start, work.across, work.partX, work.partY
  local sorted, count, bodies = work.sorted, 0, 0
  for p = 1, work.count do
    local fromX, fromY, w, h = x[p] - work.lowX, y[p] - work.lowY, halfX[p] + near, halfY[p] + near
    local first = max(floor((fromX - w - most) * partX), 0)
    local final = min(floor((fromX + w) * partX), across - 1) + 1 ---@type number
    local row, before = floor((y[p] - halfY[p] - work.lowY) * partY), count
    for r = row, min(floor((fromY + h) * partY), work.rows - 1) do
      for q = r == row and p + 1 or start[r * across + first], start[r * across + final] - 1 do
        local dx, dy, reachX, reachY = x[q] - x[p], y[q] - y[p], w + halfX[q], h + halfY[q]
        if dy < reachY and -dy < reachY and dx < reachX and -dx < reachX then
          count = addPair(b, work, count, sorted[p], sorted[q])
        end
      end
    end
    bodies = count > before and bodies + 1 or bodies
  end
  return count, count / max(bodies, 1)
end

-- Lists the pairs of bodies that are no further apart than `near` px. Returns the mean size, px,
-- and the two numbers of `listNear`.
local function findNear(b, work, near)
  local lowX, highX, width, most = extent(work, 0)
  local lowY, highY, height = extent(work, 1)
  local wide, high, count = highX - lowX, highY - lowY, work.count
  local mean = max((width + height) / (2 * count), constants.TINY)
  work.lowX, work.lowY, work.partY = lowX, lowY, 1 / max(mean * HIGH, high / count)
  work.rows = floor(high * work.partY) + 1
  work.partX = 1 / max(mean / FINE, wide * work.rows / (CELLS * count))
  work.across = floor(wide * work.partX) + 1
  sortCells(work)
  return mean, listNear(b, work, near, most)
end

-- Returns the vector along which slots i and j part if they are at one place.
local function wayOf(b, i, j)
  local at = (b.seat[i] + b.seat[j]) % #WAYS_X + 1
  local sign = b.rank[i] < b.rank[j] and 1 or -1
  return WAYS_X[at] * sign * NEAREST, WAYS_Y[at] * sign * NEAREST
end

-- Adds the velocity of each pair to both of its bodies.
local function push(b, work, count)
  local x, y, halfX, halfY = work.at[0], work.at[1], work.half[0], work.half[1]
  local nowX, nowY, shareOne, shareOther = work.now[0], work.now[1], work.shareOne, work.shareOther
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

-- Makes a part of a step of dt s: adds to the drift the share `keep` of the velocity that the last
-- part added, and the share `part` of the velocity now. `own` is the same sum for a constant
-- velocity of 1, by which the bodies' own velocities count.
local function advance(b, work, keep, part, own, dt)
  local slot, most, softSpeed, velocity = work.slot, work.most, b.softSpeed, b.velocity
  local x, y, nowX, nowY = work.at[0], work.at[1], work.now[0], work.now[1]
  local lastX, lastY = work.last[0], work.last[1]
  for n = 1, work.count do
    local k, limit, dx, dy = 2 * slot[n], most[n], nowX[n], nowY[n]
    local share = part * min(limit / max(sqrt(dx * dx + dy * dy), constants.TINY), 1.0)
    dx, dy = lastX[n] * keep + dx * share, lastY[n] * keep + dy * share
    lastX[n], lastY[n], nowX[n], nowY[n] = dx, dy, 0.0, 0.0
    softSpeed[k], softSpeed[k + 1] = softSpeed[k] + dx, softSpeed[k + 1] + dy
    x[n] = x[n] + (velocity[k] * own + dx) * dt
    y[n] = y[n] + (velocity[k + 1] * own + dy) * dt
  end
end

-- Lists the bodies that drift, and wakes them. A body that its drift nearly stops on an axis is
-- slowed further, in proportion to the speed that is left: so it does not go to and fro around the
-- place where it comes to stand. A body that stands on something drifts across gravity only: it is
-- not lifted off the ground.
local function listDrifted(b, work)
  local softSpeed, velocity = b.softSpeed, b.velocity
  for n = 1, work.count do
    local i = work.slot[n]
    if softSpeed[2 * i] ~= 0 or softSpeed[2 * i + 1] ~= 0 then
      b.driftedCount = b.driftedCount + 1
      work.drifted[b.driftedCount] = i
      islands.wake(b, i)
    end
    local vx, vy = velocity[2 * i], velocity[2 * i + 1]
    local own = max(vx, -vx, vy, -vy)
    for k = 2 * i, 2 * i + 1 do
      local left = velocity[k] + softSpeed[k]
      local speed = max(left, -left)
      if softSpeed[k] * velocity[k] < 0 and speed < own then
        softSpeed[k] = left * speed / own - velocity[k]
      end
      if b.support[i] ~= 0 and b.down[k] ~= 0 then
        softSpeed[k] = 0
      end
    end
  end
end

-- Finds the drift of the listed bodies in a step of dt s.
local function find(b, work, dt)
  local displacement, own = work.fastest * dt, 0.0
  local size, count, each = findNear(b, work, NEAR * displacement)
  local parts = min(ceil(sqrt(displacement / size * each + 0.25) - 0.5), MOST_PARTS)
  for n = 1, parts do
    local keep, part = (n - 1) / n, (4 * n - 2) / (n * (parts * parts + parts))
    own = own * keep + part
    push(b, work, count)
    advance(b, work, keep, part, own, dt)
  end
  listDrifted(b, work)
end

--- Finds the drift of all bodies that overlap bodies to which they are soft, in a step of dt s.
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

--- Adds the drift to the free flight of all awake bodies.
function drift.add(b, dt)
  local awakeList, kind, softSpeed, displacement, speed =
    b.awakeList, b.kind, b.softSpeed, b.displacement, b.speed
  local without, carried = b.drifts.speed, b.carried
  for n = 1, b.awakeCount do
    local k = 2 * awakeList[n]
    if kind[awakeList[n]] == DYNAMIC then
      without[k], without[k + 1] = speed[k] + carried[k], speed[k + 1] + carried[k + 1]
      displacement[k], displacement[k + 1] =
        displacement[k] + softSpeed[k] * dt, displacement[k + 1] + softSpeed[k + 1] * dt
      speed[k], speed[k + 1] = speed[k] + softSpeed[k], speed[k + 1] + softSpeed[k + 1]
    end
  end
end

--- Gives the bodies that drift the velocity at which they start, drift included, and the
--- acceleration without it.
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

--- Takes the drift off the velocities again, after a step. The body's own velocity becomes the
--- middle one of three: its speed at the end of the step, its own velocity, and that with the
--- change of speed in the step.
function drift.takeOff(b)
  local work = b.drifts
  for n = 1, b.driftedCount do
    local i = work.drifted[n]
    for k = 2 * i, 2 * i + 1 do
      local own, change = work.speed[k], b.speed[k] - b.freeSpeed[k]
      b.speed[k] = max(min(own, own + change), min(b.speed[k], max(own, own + change)))
    end
  end
end

return drift
