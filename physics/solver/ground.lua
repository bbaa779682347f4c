--- The ground of a box on its way across gravity: what it may walk on, where that begins and ends,
--- and how high it is. `walk.lua` follows it.
---
--- Heights and `turn` are those of walk.lua. `b.ground` is what is near the way of one body:
--- `slot`, `count` of them; `turn`, places at which something begins or ends to be ground, `turns`
--- of them.
---
--- Reads to, size, roof, passing, dropping; writes b.ground.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local filter = require(root .. ".broadphase.filter")
local oneway = require(root .. ".solver.oneWay")
local rules = require(root .. ".solver.rules")
local slope = require(root .. ".solver.slope")
local triangle = require(root .. ".memory.triangle")

local ground = {}

local EPSILON, DYNAMIC, SIDE = columns.EPSILON, columns.DYNAMIC, columns.SIDE
local SOLID, HUGE = triangle.SOLID, math.huge
local isFalling, isRamp = oneway.isFalling, slope.bears
local max, min = math.max, math.min

-- Whether slot j can be ground for slot i, along an axis.
local function isGround(b, i, j, axis, turn)
  local isAir = j == i or b.kind[j] == DYNAMIC or b.sensor[j] or b.sensor[i]
  if isAir or not filter.allows(b, i, j) then
    return false
  end
  local oneWay = b.oneWay[j]
  if oneWay and SIDE[oneWay] ~= 2 * axis + (turn > 0 and 1 or 2) then
    return false
  elseif oneWay and isFalling(b, i, oneWay) then
    return false
  elseif not (b.hasOneWays or b.hasAskers) then
    return true
  end
  local p, k, m = columns.pairOf(b, i, j), 2 * i + axis, 2 * j + axis
  if not p then
    return not b.hasAskers -- what is not near was not asked about
  elseif b.passing[p] or b.dropping[p] or not b.hasAskers then
    return not (b.passing[p] or b.dropping[p])
  end
  return not rules.passes(b, p, turn > 0 and k or m, turn > 0 and m or k, axis, false)
end

-- The height of slot i on slot j, where it is at x across gravity.
local function heightOn(b, i, j, axis, turn, x)
  local k, m = 2 * i + axis, 2 * j + axis
  if isRamp(b, j, axis, turn) then
    local apart = slope.separation(b, i, j, axis, x, b.to[m + 1 - 2 * axis])
    return turn * (b.to[m] - turn * apart)
  end
  return turn > 0 and b.to[m] - b.size[k] or -(b.to[m] + b.size[m])
end

-- Notes where slot j begins and ends to be ground (or with the other `turn` a roof) for a box of w
-- px, and where that comes over its crest.
local function noteTurns(b, list, j, axis, turn, w)
  local m, n = 2 * j + 1 - axis, list.turns
  local low, high = b.to[m], b.to[m] + b.size[m]
  list.turn[n + 1], list.turn[n + 2] = low - w, high
  list.turns = n + 2
  if isRamp(b, j, axis, turn) then
    list.turn[n + 3] = SOLID[1 - axis][b.shape[j]] > 0 and high - w or low
    list.turns = n + 3
  end
end

--- Lists what may be ground on the way of slot i from x0 to x1, `height` high.
function ground.list(b, i, axis, turn, x0, x1, height)
  local list, found, k = b.ground, b.found, 2 * i
  local w = b.size[k + 1 - axis]
  local base = turn > 0 and height + b.size[k + axis] or -height
  local reach = max(x1 - x0, x0 - x1) * b.steep[axis] + 1
  local left, right = min(x0, x1) - 1, max(x0, x1) + w + 1
  local n
  if axis == 1 then
    n = b.broadphase:query(left, base - reach, right, base + reach, found)
  else
    n = b.broadphase:query(base - reach, left, base + reach, right, found)
  end
  list.count, list.turns = 0, 0
  for at = 1, n do
    if isGround(b, i, found[at], axis, turn) then
      list.count = list.count + 1
      list.slot[list.count] = found[at]
      noteTurns(b, list, found[at], axis, turn, w)
    end
  end
  if b.roof[k + axis] > 0 then
    noteTurns(b, list, b.roof[k + axis], axis, -turn, w)
  end
end

--- Returns the next place from x on towards x1 at which something begins or ends to be ground.
function ground.nextTurn(b, x, x1)
  local list, way, nearest = b.ground, x1 >= x and 1 or -1, x1
  for n = 1, list.turns do
    local at = list.turn[n]
    if (at - x) * way > EPSILON and (nearest - at) * way > 0 then
      nearest = at
    end
  end
  return nearest
end

--- Returns whether a box of w px, which is at x across gravity, is above or below slot j.
function ground.isOver(b, j, axis, x, w)
  local m = 2 * j + 1 - axis
  return x + w > b.to[m] and x < b.to[m] + b.size[m]
end

-- Whether slot j, at a height, counts before the best one so far: by height, then in order.
local function isFirst(b, j, best, height, top)
  return height < top or (height == top and b.rank[j] < b.rank[best])
end

--- Returns where a piece of the way from x, `height` high, ends, if that is at xEnd at last: where
--- another ground rises over the one that it is on, at the latest. Returns place, height, and what
--- it is on there: 0, nothing is level with it.
function ground.endOf(b, i, axis, turn, x, xEnd, height)
  local list, w = b.ground, b.size[2 * i + 1 - axis]
  local middle = (x + xEnd) * 0.5
  local best, top, start, its, level = 0, HUGE, 0.0, 0, HUGE
  for n = 1, list.count do
    local j = list.slot[n]
    if ground.isOver(b, j, axis, middle, w) then
      local first = heightOn(b, i, j, axis, turn, x)
      if first >= height - EPSILON then
        local last = heightOn(b, i, j, axis, turn, xEnd)
        if first <= height + EPSILON and isFirst(b, j, its, last, level) then
          its, level = j, last
        end
        if isFirst(b, j, best, last, top) then
          best, top, start = j, last, first
        end
      end
    end
  end
  if level == HUGE then
    return xEnd, height, 0
  elseif start > height + EPSILON and level > top then
    local share = (start - height) / (start - height + level - top)
    return x + (xEnd - x) * share, height + (level - height) * share, its
  end
  return xEnd, top, best
end

return ground
