--- Paths inside a step: from the place `from` at `time` (0..1) in a straight line to `to` at its
--- end.

local here = (...):match("^(.*)%.[^.]+$")
local columns = require(here .. ".columns")

local path = {}

local DYNAMIC = columns.DYNAMIC

--- Begins the path of a dynamic object anew where it is at time t.
function path.advance(b, i, t)
  local start = b.time[i]
  if b.kind[i] ~= DYNAMIC or t <= start then
    return
  end
  local share = (t - start) / (1 - start)
  local from, to, k = b.from, b.to, 2 * i
  from[k] = from[k] + (to[k] - from[k]) * share
  from[k + 1] = from[k + 1] + (to[k + 1] - from[k + 1]) * share
  b.time[i] = t
end

--- Lets k, which nothing holds any more, be pulled again by what is its own for `tau` s.
function path.fall(b, k, tau)
  local a = b.pull[k] + b.push[k]
  local more = (a - b.accel[k]) * tau
  b.speed[k], b.to[k] = b.speed[k] + more, b.to[k] + more * tau * 0.5
  b.accel[k], b.drive[k] = a, a
end

--- Begins a new list of whose path has changed.
function path.startChanges(b)
  b.changedCount = 0
  b.changeStamp = b.changeStamp + 1
end

--- Notes that the path of an object has changed.
function path.change(b, i)
  b.follows[i] = 0
  if b.kind[i] == DYNAMIC and b.changedMark[i] ~= b.changeStamp then
    local k, changes, isStale = 2 * i, b.changes, b.isTurnStale
    changes[k], changes[k + 1] = changes[k] + 1, changes[k + 1] + 1
    isStale[0], isStale[1] = true, true
    b.changedMark[i] = b.changeStamp
    b.changedCount = b.changedCount + 1
    b.changed[b.changedCount] = i
  end
end

return path
