--- What a speed limit keeps from somebody's engine.
--
-- Who is as fast as its maxSpeedX or maxSpeed lets it be does not get faster, however hard `ax`
-- pulls. As soon as friction, drag or a crate in the way make it slower, it pulls again; so within
-- a step it first makes up for what they take. Without this, who is rubbed would be slower than its
-- limit, by what friction takes off in a step: the more, the longer the steps are.
--
-- `reserve` is what is left of that in this step, px/s, and `pace` the speed to which it may bring
-- somebody, without what carries it.

local here = (...):match("^(.*)%.[^.]+$")
local columns = require(here .. ".columns")

require(here .. ".interpreted").file()

local reserve = {}

local huge, max, min = math.huge, math.max, math.min
local STILL = columns.STILL

-- How fast k gets by itself in a second, in px/s, either way.
local function pullOn(b, k)
  local pull = b.pull[k] + b.push[k]
  return max(pull, -pull)
end

--- Returns how much faster k may still get in the last `tau` s of the step, px/s; < 0: towards
--- smaller coordinates. 0 if it leans on something immovable there, which bears it.
function reserve.left(b, k, tau)
  local left = b.reserve[k]
  if left == 0 or (left > 0 and b.heldHigh[k] > 0) or (left < 0 and b.heldLow[k] > 0) then
    return 0
  end
  local most = pullOn(b, k) * tau
  return max(min(left, most), -most)
end

--- Returns the speed, absolute, beyond which the reserve of k does not bring it.
function reserve.top(b, k)
  return b.pace[k] + b.carried[k]
end

--- Of a way that begins at a speed of `start` px/s and ends `tau` s later, evenly, at one that is
--- `over` px/s beyond `top` (of the same sign), returns how far it is if it stays at that.
function reserve.wayTo(way, start, top, over, tau)
  if (top - start) * over <= 0 then
    return top * tau -- all the time
  end
  return way - over * 0.5 * (tau * over / (top + over - start))
end

--- Lets the reserve of slot i bear an impulse on k, which would slow it in the `tau` s that are
--- left, as far as it goes. Returns what it has borne.
function reserve.bear(b, i, k, impulse, tau)
  local left = reserve.left(b, k, tau) * b.mass[i]
  if left * impulse >= 0 then
    return 0
  end
  local borne = impulse > 0 and min(impulse, -left) or max(impulse, -left)
  b.reserve[k] = (left + borne) / b.mass[i]
  return borne
end

-- Adds up the reserves of k and of those that are welded to it, towards `sign`: how much faster
-- they may get together, of an inverse mass of w, the least of their tops, and whose that is. It is
-- all used up then.
local function takeAll(b, k, w, sign, tau)
  local impulse, top = 0.0, huge
  local lender, member = 0, k
  repeat
    local left = reserve.left(b, member, tau) * sign
    if left > 0 then
      local its = reserve.top(b, member) * sign
      impulse = impulse + left * b.mass[(member - member % 2) / 2]
      if its < top then
        top, lender = its, member
      end
      b.reserve[member] = 0
    end
    member = b.weldNext[member]
  until member == k or member == 0
  return impulse * w, top, lender
end

--- Whether any of two who lean on each other may push the other with what its limit keeps from it.
--- (Along gravity what is kept is the fall of who falls as fast as it may.)
function reserve.pushes(b, kl, kh)
  return b.reserves > 0
    and b.down[kl] == 0
    and b.down[kh] == 0
    and (b.weld[kl] + b.weld[kh] > 0 or b.reserve[kl] > 0 or b.reserve[kh] < 0)
end

--- Of the pull that drives two apart, returns what does not, as it is that of one who is pushed on
--- at its limit.
function reserve.idle(b, kl, kh)
  local high = b.reserve[kh] > 0 and max(b.drive[kh], 0) or 0
  local low = b.reserve[kl] < 0 and min(b.drive[kl], 0) or 0
  return high - low
end

-- Makes k faster by `gain` px/s towards `sign`, and lets it go as far as it gets by that from the
-- moment on at which it came to its limit.
local function hasten(b, k, gain, sign, tau)
  local rise = max(b.accel[k] * sign * tau, 0.0)
  local way = 0.0
  if gain > 0 then
    way = gain * 0.5 * (tau * gain / (gain + rise))
  end
  b.speed[k], b.to[k] = b.speed[k] + gain * sign, b.to[k] + way * sign
  return way
end

--- Lends two who lean on each other, and both give way, what their limits keep from them, for the
--- push. Returns by how much faster they close then, in px/s, and how much further they overlap.
function reserve.lend(b, kl, kh, wl, wh, tau)
  local gainL, topL, lenderL = takeAll(b, kl, wl, 1, tau)
  local gainH, topH, lenderH = takeAll(b, kh, wh, -1, tau)
  local way = hasten(b, kl, gainL, 1, tau) + hasten(b, kh, gainH, -1, tau)
  b.lentTopLow, b.lentTopHigh, b.lenderLow, b.lenderHigh = topL, topH, lenderL, lenderH
  return gainL + gainH, way
end

-- The push has brought both to the same speed, which is beyond the top of the lender, on the side
-- of k: they stay at that. k, which would have gone to `goal` alone, began at `start` px/s, `tau` s
-- before the end. Returns the impulse that the other, m, does not get then.
local function cut(b, k, m, wk, wm, lender, top, start, goal, tau)
  local over, to = b.speed[k] - top, b.to
  if (top - start) * over > STILL * max(over, -over) then
    goal = to[k] - over * 0.5 * (tau * over / (b.speed[k] - start))
  end -- else there is nobody in its way
  b.speed[k], b.speed[m], to[k] = top, top, goal
  to[m] = over > 0 and goal + b.size[k] or goal - b.size[m]
  b.reserve[lender] = over * (1 / wk + 1 / wm) / b.mass[(lender - lender % 2) / 2]
  return max(over, -over) / wm
end

-- Up to which speed k may be pushed towards `sign`; it is as fast as `v` px/s already.
local function mostOf(b, k, sign, v)
  local i = (k - k % 2) / 2
  return max(b.carried[k] * sign + min(b.limit[k], b.maxSpeed[i]), v * sign)
end

-- The push would bring both to a speed that is beyond the limit of m, which is pushed: that does
-- not get faster, whatever pushes it, and the other, k, neither. m would have come to v px/s and
-- to `goal` alone.
local function stop(b, k, m, top, v, goal, tau)
  local over, to, size = b.speed[k] - top, b.to, b.size
  local start = v - b.accel[m] * tau
  if (top - start) * over > STILL * max(over, -over) then
    goal = to[m] - over * 0.5 * (tau * over / (b.speed[k] - start))
  else
    goal = goal + (top - (start + v) * 0.5) * tau -- it is as fast as that all the time
  end
  b.speed[k], b.speed[m], to[m] = top, top, goal
  to[k] = over > 0 and goal - size[k] or goal + size[m]
end

-- After a push of k against m, towards `sign`, that has brought both to v px/s: sees to it that
-- neither is beyond what it may be. Returns the impulse that was too much.
local function hold(b, k, m, wk, wm, sign, v, lender, top, speed, goal, tau, speedM, goalM)
  local most = mostOf(b, m, sign, speedM)
  if v * sign > most and most < top then
    stop(b, k, m, most * sign, speedM, goalM, tau)
  elseif v * sign > top then
    return cut(b, k, m, wk, wm, lender, top * sign, speed - b.accel[k] * tau, goal, tau)
  end
  return 0
end

--- After a push, also one with what was lent last (b.pushLends): who would be beyond its top stays
--- at that, and nobody is pushed beyond its limit. How the two would have gone on alone is noted
--- (b.pushLowTo, ...). Returns the impulse that was too much.
function reserve.settle(b, kl, kh, wl, wh, tau)
  local v = b.speed[kl]
  if v ~= b.speed[kh] or min(wl, wh) <= 0 then
    return 0
  end
  local topL, topH = huge, huge
  if b.pushLends then
    topL, topH = b.lentTopLow, b.lentTopHigh
  end
  local toL, toH, speedL, speedH = b.pushLowTo, b.pushHighTo, b.pushLowSpeed, b.pushHighSpeed
  local low, high = b.lenderLow, b.lenderHigh
  return hold(b, kl, kh, wl, wh, 1, v, low, topL, speedL, toL, tau, speedH, toH)
    + hold(b, kh, kl, wh, wl, -1, v, high, topH, speedH, toH, tau, speedL, toL)
end

return reserve
