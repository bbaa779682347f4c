---@diagnostic disable
--- Soft crowds: computes how fast bodies of soft groups drift apart, and adds that to their paths.
--
-- Two bodies that overlap get a velocity apart along the line between their middles, in proportion
-- to the depth: `soft` px/s on the axis on which they are further apart, for two bodies at one
-- place. The stronger one does not give way; two of equal strength share it by their masses.
-- The velocities of all its pairs add up to the *drift* of a body, in each part of a step at most
-- the largest `soft` of its group. The drift is added to the path of this step and taken off again
-- after it, so that solid objects stop it as any other motion.
--
--      [ a [ ] b ]        Let d be the distance of the middles on an axis, h the sum of the half
--      <-       ->        sizes there, and f the larger d / h of both axes. Then the pair parts at
--       | d  |            soft (1 / f - 1) d / h:  `soft` at one place, 0 when the two touch.
--
-- The places x of a crowd follow x' = v(x), whose stiffness is the rate soft / size (the fastest
-- `soft`, the mean of widths and heights) times the number of pairs, near ones included, for each
-- body that is the first of one in the list. One step of v dt overshoots if that rate times dt is
-- above 2: a dense crowd would explode. So a step is made in as many equal parts, at most
-- MOST_PARTS (the method of Euler). Beyond that, only the limit of the drift bounds it. A drift
-- against the motion of its body slows that further, so that a crowd comes to stand (see
-- `listDrifted`).
--
-- The pairs that overlap, or are less than `near` apart, are found once. The bodies are sorted by
-- the rows of their upper edges, which are as high as the highest body and `near`, and in a row by
-- their left edges. So each is compared with those beside it in its row and in the next one. Sums
-- do not depend on that order: all velocities are rounded to multiples of 2^-20 px/s, which add up
-- exactly.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local constants = require(root .. ".memory.constants")
local filter = require(root .. ".broadphase.filter")
local islands = require(root .. ".sleep.islands")
local sort = require(root .. ".memory.sort")

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
    left = {}, -- its left edge
    line = {}, -- the row in which it begins
    sorted = {}, -- the bodies by row, then from left to right
    one = {}, -- pairs that may overlap
    other = {},
    partSpeed = {}, -- px/s, of each pair
    shareOne = {},
    shareOther = {},
    now = { [0] = {}, {} }, -- by axis: velocity apart in a part of the step
    drifted = {}, -- slots with a drift: b.driftedCount
    speed = {}, -- by index: velocity at the end of the step without it, and that of the carrier
    carried = {},
  }
end

-- Lists the bodies of the soft groups, in the order of the world.
local function list(b, work)
  local groups, n, from, size, fastest = b.registry.groups, 0, b.from, b.size, 0.0
  local sum, wide, high = 0.0, 0.0, constants.TINY
  local name, row, most, groupName = nil, nil, 0.0, b.groupName
  local x, y, halfX, halfY = work.at[0], work.at[1], work.half[0], work.half[1]
  for m = 1, b.moverCount do
    local i = b.movers[m]
    if groupName[i] ~= name then
      name, row, most = groupName[i], b.soft[groupName[i]], 0.0
      for other = 1, row and #groups or 0 do
        most = max(most, row[groups[other].name] or 0)
      end
    end
    if row and b.active[i] and not b.sensor[i] then
      local w, h = size[2 * i], size[2 * i + 1]
      n, fastest = n + 1, max(fastest, most)
      work.slot[n], work.row[n], work.name[n], work.most[n] = i, row, name, most
      sum, wide, high = sum + w + h, max(wide, w), max(high, h)
      local isPlain = b.power[i] == 0 and b.kind[i] == DYNAMIC and b.pushable[i]
      work.plain[n] = isPlain and not (b.mask[i] or b.hitsOnly[i] or b.masks) and b.mass[i]
      halfX[n], halfY[n] = w * 0.5, h * 0.5
      x[n], y[n] = from[2 * i] + halfX[n], from[2 * i + 1] + halfY[n]
    end
  end
  for at = 1, n ~= work.count and n or 0 do
    work.sorted[at], work.now[0][at], work.now[1][at] = at, 0.0, 0.0
  end
  work.widest, work.highest = wide, high
  work.count, work.fastest, work.meanSize = n, fastest, max(sum, constants.TINY) / max(2 * n, 1)
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
  local i, j, mass, speed = work.slot[m], work.slot[n], work.plain[m], work.row[m][work.name[n]]
  local areAlike = mass and mass == work.plain[n]
  if speed and (areAlike or not (filter.refusal(b, i, j) or filter.refusal(b, j, i))) then
    count = count + 1
    work.one[count], work.other[count], work.partSpeed[count] = m, n, speed
    work.shareOne[count], work.shareOther[count] = 0.5, 0.5
    if not areAlike then
      work.shareOne[count], work.shareOther[count] = weigh(b, i, j)
    end
  end
  return count
end

-- Lists the pairs of bodies that are no further apart than `near` px: a body with those in its row
-- that begin after it, up to its right edge, and with those of the next row beside it. Returns how
-- many there are, and how many for each body that begins one.
local function findNear(b, work, near)
  local x, y, halfX, halfY = work.at[0], work.at[1], work.half[0], work.half[1]
  local sorted, left, row, high = work.sorted, work.left, work.line, work.highest + near
  for n = 1, work.count do
    left[n], row[n] = x[n] - halfX[n], floor((y[n] - halfY[n]) / high)
  end
  sort.by(sorted, work.count, row, left, left)
  sorted[work.count + 1], row[0] = 0, huge
  local count, bodies, below = 0, 0, 1
  for p = 1, work.count do
    local m, before = sorted[p], count
    local right, most = x[m] + halfX[m] + near, left[m] - work.widest - near
    local n = sorted[below]
    while row[n] <= row[m] or row[n] == row[m] + 1 and left[n] < most do
      below = below + 1
      n = sorted[below]
    end
    for r = 0, 1 do
      local q, line = r == 0 and p + 1 or below, row[m] + r
      n = sorted[q]
      while row[n] == line and left[n] < right do
        local dx, dy = x[n] - x[m], y[n] - y[m]
        local w, h = halfX[m] + halfX[n] + near, halfY[m] + halfY[n] + near
        if dy < h and -dy < h and dx < w and -dx < w then
          count = addPair(b, work, count, m, n)
        end
        q = q + 1
        n = sorted[q]
      end
    end
    bodies = count > before and bodies + 1 or bodies
  end
  return count, count / max(bodies, 1)
end

-- Returns the vector along which slots i and j part if they are at one place.
local function wayOf(b, i, j)
  local at = (b.seat[i] + b.seat[j]) % #WAYS_X + 1
  local sign = b.rank[i] < b.rank[j] and 1 or -1
  return WAYS_X[at] * sign * NEAREST, WAYS_Y[at] * sign * NEAREST
end

-- Adds the velocity of each pair that overlaps to both of its bodies.
local function push(b, work, count)
  local x, y, halfX, halfY = work.at[0], work.at[1], work.half[0], work.half[1]
  local nowX, nowY, one, other, rounding = work.now[0], work.now[1], work.one, work.other, ROUNDING
  local speed, shareOne, shareOther = work.partSpeed, work.shareOne, work.shareOther
  for c = 1, count do
    local m, n = one[c], other[c]
    local dx, dy = (x[n] - x[m]) / (halfX[m] + halfX[n]), (y[n] - y[m]) / (halfY[m] + halfY[n])
    local far = max(dx, -dx, dy, -dy)
    if far < 1 then
      if far < NEAREST then
        dx, dy = wayOf(b, work.slot[m], work.slot[n])
        far = NEAREST
      end
      local v, share, rest = speed[c] * (1 / far - 1), shareOne[c], shareOther[c]
      local vx, vy = v * dx, v * dy
      nowX[m] = nowX[m] - (vx * share + rounding - rounding)
      nowY[m] = nowY[m] - (vy * share + rounding - rounding)
      nowX[n] = nowX[n] + (vx * rest + rounding - rounding)
      nowY[n] = nowY[n] + (vy * rest + rounding - rounding)
    end
  end
end

-- Makes a part of a step, `share` of it, of dt s: adds that share of the velocity now to the drift.
local function advance(b, work, share, dt)
  local slot, most, softSpeed, velocity = work.slot, work.most, b.softSpeed, b.velocity
  local x, y, nowX, nowY = work.at[0], work.at[1], work.now[0], work.now[1]
  for n = 1, work.count do
    local k, dx, dy = 2 * slot[n], nowX[n], nowY[n]
    local limited = share * min(most[n] / max(sqrt(dx * dx + dy * dy), constants.TINY), 1.0)
    dx, dy, nowX[n], nowY[n] = dx * limited, dy * limited, 0.0, 0.0
    softSpeed[k], softSpeed[k + 1] = softSpeed[k] + dx, softSpeed[k + 1] + dy
    x[n] = x[n] + (velocity[k] * share + dx) * dt
    y[n] = y[n] + (velocity[k + 1] * share + dy) * dt
  end
end

-- Lists the bodies that drift, and wakes them. Where a drift against the velocity of its body
-- leaves less than `own`, the larger part of that velocity, the speed that is left shrinks by left
-- / own: so the body does not go to and fro around the place where it comes to stand. A body that
-- stands on something drifts across gravity only: it is not lifted off the ground.
local function listDrifted(b, work)
  local softSpeed, velocity, down, support = b.softSpeed, b.velocity, b.down, b.support
  for n = 1, work.count do
    local i = work.slot[n]
    local k, m = 2 * i, 2 * i + 1
    if softSpeed[k] ~= 0 or softSpeed[m] ~= 0 then
      b.driftedCount = b.driftedCount + 1
      work.drifted[b.driftedCount] = i
      islands.wake(b, i)
      local own = max(velocity[k], -velocity[k], velocity[m], -velocity[m])
      for at = k, m do
        local left = velocity[at] + softSpeed[at]
        if softSpeed[at] * velocity[at] < 0 and max(left, -left) < own then
          softSpeed[at] = left * max(left, -left) / own - velocity[at]
        end
        if down[at] ~= 0 and support[i] ~= 0 then
          softSpeed[at] = 0
        end
      end
    end
  end
end

--- Finds the drift of all bodies that overlap bodies to which they are soft, in a step of dt s.
function drift.run(b, dt)
  b.drifts = b.drifts or newWork()
  local work, softSpeed = b.drifts, b.softSpeed
  for n = 1, b.driftedCount do
    local k = 2 * work.drifted[n]
    softSpeed[k], softSpeed[k + 1] = 0, 0
  end
  b.driftedCount = 0
  if not b.soft then
    return
  end
  list(b, work)
  local displacement = work.fastest * dt
  local count, each = findNear(b, work, NEAR * displacement)
  local parts = min(ceil(displacement / work.meanSize * each * 0.5), MOST_PARTS)
  for _ = 1, parts do
    push(b, work, count)
    advance(b, work, 1 / parts, dt)
  end
  listDrifted(b, work)
end

--- Lets the drift carry its bodies in this step, as a carrier does.
function drift.add(b)
  local before, gift, softSpeed, carried = b.drifts.speed, b.drifts.carried, b.softSpeed, b.carried
  local speed, hasCarriers = b.speed, b.hasCarriers
  for n = 1, b.driftedCount do
    local k = 2 * b.drifts.drifted[n]
    for at = k, k + 1 do
      local v = hasCarriers and carried[at] or 0
      before[at], gift[at], carried[at] = speed[at] + v, v, v + softSpeed[at]
    end
  end
end

--- Takes the drift off the velocities again, after a step. The body's own velocity becomes the
--- middle one of three: its speed at the end of the step, its own velocity, and that with the
--- change of speed in the step. (So a wall that stopped the drift does not throw it back.)
function drift.takeOff(b)
  local before, gift, speed, freeSpeed = b.drifts.speed, b.drifts.carried, b.speed, b.freeSpeed
  for n = 1, b.driftedCount do
    local k = 2 * b.drifts.drifted[n]
    for at = k, k + 1 do
      local own, change = before[at], speed[at] - freeSpeed[at]
      speed[at] = max(min(own, own + change), min(speed[at], max(own, own + change)))
      b.carried[at] = gift[at]
    end
  end
end

return drift
