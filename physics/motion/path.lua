--- Path: computes where a body is inside a step. A path leads in a straight line from the place
-- `from` at `time` (0..1 of the step) to `to` at its end.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")

local path = {}

local DYNAMIC = columns.DYNAMIC
local min = math.min
-- The last moment at which a path may begin anew.
local LAST = 1 - 1e-12

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
end

return path
