--- Path: computes where a body is inside a step. A path leads in a straight line from the place
-- `from` at `time` (0..1 of the step) to `to` at its end.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local interpreted = require(root .. ".memory.jit")

local path = {}

local DYNAMIC = columns.DYNAMIC
local min = math.min
-- The last moment at which a path may begin anew.
local LAST = 1 - 1e-12

-- Puts what walks (see walk) onto its way along the ground.
local function stay(b, i)
  local axis = b.down[2 * i] ~= 0 and 0 or 1
  local k, place, height = 2 * i + axis, b.piecePlace, b.pieceHeight
  local x, first, last = b.from[2 * i + 1 - axis], b.pieceFirst[i], b.pieceLast[i]
  local n = first + 1
  while n < last and (place[n] - x) * (place[last] - place[first]) < 0 do
    n = n + 1
  end
  local way = place[n] - place[n - 1]
  local share = way ~= 0 and (x - place[n - 1]) / way or 1
  b.from[k] = b.down[k] * (height[n - 1] + (height[n] - height[n - 1]) * share)
end

--- Returns where body k is at moment t. Its path begins at moment `start`.
function path.at(b, k, start, t)
  local from = b.from[k]
  if t <= start then
    return from
  end
  return from + (b.to[k] - from) * ((t - start) / (1 - start))
end

--- Lets the path of a dynamic body begin anew where it is at moment t.
function path.advance(b, i, t)
  local start = b.time[i]
  if b.kind[i] ~= DYNAMIC or t <= start then
    return
  end
  t = min(t, 1)
  local share = (t - start) / (1 - start)
  local from, to, k = b.from, b.to, 2 * i
  from[k] = from[k] + (to[k] - from[k]) * share
  from[k + 1] = from[k + 1] + (to[k + 1] - from[k + 1]) * share
  b.time[i] = min(t, LAST)
  if b.hasSlopes and b.pieceLast[i] > 0 then
    stay(b, i)
  end
end

--- Notes that the path of a dynamic body has changed inside the step: it is swept again.
function path.change(b, i)
  if b.kind[i] == DYNAMIC and b.dirty[i] == 0 then
    b.dirty[i], b.changedCount = 1, b.changedCount + 1
    b.changed[b.changedCount] = i
  end
end

interpreted.functions(path.at) -- of single pairs

return path
