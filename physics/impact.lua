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

-- A speed > -STILL, or 0 if it is hardly one. No branches.
local function calm(v)
  return max(v, 0.0) * min(max((v - STILL) * VAST, 0), 1)
end

--- Approach speed at the moment of contact and the time left after it, from what the paths will
-- have become at the end of the step: overlap o, closing speed v, closing acceleration a; `touches`
-- if the paths begin at the contact.
function impact.at(o, v, a, left, touches)
  local start = v - a * left
  if touches and start > -STILL and o >= (v + start) * 0.5 * left * (1 - ROUNDING) then
    -- They touch from the beginning of their paths on; the speed there is exact, no difference of
    -- squares.
    return calm(start), left
  end
  local square = v * v - 2 * a * o
  local u = 0
  if square > 0 and not (v <= 0 and a >= 0) then
    u = sqrt(square)
  end
  local tau = left
  if v + u > 0 then
    tau = max(min(2 * o / (v + u), left), 0) -- who does not overlap yet has no time left
  end
  return u, tau
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
