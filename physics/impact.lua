--- How fast two meet, and how they part: one axis, two numbers moving with constant acceleration.

local here = (...):match("^(.*)%.[^.]+$")
local columns = require(here .. ".columns")

local impact = {}

local max, min, sqrt = math.max, math.min, math.sqrt
local STILL, VAST = columns.STILL, columns.VAST
--- Share by which an overlap may be short through rounding.
impact.ROUNDING = 1e-6
local ROUNDING = impact.ROUNDING
--- px/s² below which two accelerate alike.
impact.EVEN = 1e-6
local EVEN = impact.EVEN

--- px/s: what is slower does not close; with no more px than a number may have, in range.
impact.SLOWEST = 1e-200
local SLOWEST = impact.SLOWEST

--- Approach speed at the moment of contact and the time left after it, from what the paths will
--- have become at the end of the step: overlap o, closing speed v, closing acceleration a.
--- `touches` is 1 if the paths begin at the contact, else 0. No branches: most numbers of a hit are
--- needed later on, and LuaJIT would have to keep them at each.
function impact.at(o, v, a, left, touches)
  local start = v - a * left
  local way = (v + start) * 0.5 * left * (1 - ROUNDING)
  local reaches = min(max((o - way) * VAST + 1, 0), 1) ---@type number
  -- They touch from the beginning of their paths on; the speed there is exact, no difference of
  -- squares.
  local isThere = min(max((start + STILL) * VAST, 0), 1) * reaches * touches
  -- A speed that is hardly one is none.
  local speed = max(start, 0.0) * min(max((start - STILL) * VAST, 0), 1)
  local u = sqrt(max(v * v - (a + a) * o, 0.0)) * min(max(v * VAST, -a * VAST, 0), 1)
  -- Who does not overlap yet has no time left.
  local closes = min(max((v + u) * VAST, 0), 1) ---@type number
  local tau = max(min((o + o) / max(v + u, SLOWEST), left), 0.0) * closes + left * (1 - closes)
  return speed * isThere + u * (1 - isThere), left * isThere + tau * (1 - isThere)
end

--- Gap and closing speed at the end of the step after the impact.
function impact.rebound(restitution, u, a, tau)
  if restitution > 0 then
    local gap = restitution * u * tau - a * tau * tau * 0.5
    local v = a * tau - restitution * u
    if gap >= 0 and v < 0 then
      return gap, v
    end
  elseif a < -EVEN then
    return -a * tau * tau * 0.5, a * tau
  end
  return 0, 0
end

return impact
