--- Step 6, meet: what friction can give whoever it rubs across gravity, and has given in this step.
--
-- A box that stands is rubbed before it is pushed (see `turns`). What friction has not given then
-- stands against the push: it is a force that acts during the step, whatever comes first in it.
-- What stands on others is held through them, down to the floor, and presses them on it.

local here = (...):match("^(.*)%.[^.]+$")
local columns = require(here .. ".columns")

require(here .. ".interpreted").file()

local grip = {}

local DYNAMIC = columns.DYNAMIC

local huge, max, min = math.huge, math.max, math.min
--- Share by which impulses may be rounded: what is borne at one dt is borne at every other. Also px
--- by which a sum of ways may be.
grip.ROUNDING = 1e-9
local ROUNDING = grip.ROUNDING
--- Share of what friction can give from which on that is all of it.
grip.ALL = 1 - ROUNDING
local ALL = grip.ALL

-- Returns what slot i is rubbed by, if that is rubbed, too; else 0. (Levels go down: of two that
-- are inside each other either may have stood on the other for a moment.) No branches: LuaJIT would
-- have to keep most numbers of a push at each.
local function below(b, i)
  local low = b.ground[i]
  local level = b.level[low]
  return low * min(max(b.level[i] - level, 0), level, 1)
end

--- Notes what rubs `up`, across gravity: `low`, at a speed of its surface. It can give it an
--- impulse of `limit`, of which it has given some; and of `lasting` in a whole step, by what goes
--- on pressing.
function grip.note(b, up, low, floorSpeed, mu, limit, impulse, lasting)
  b.grip[up], b.gripUsed[up] = b.grip[up] + limit, b.gripUsed[up] + impulse
  b.gripHit[up] = b.gripHit[up] + (limit - lasting)
  b.ground[up], b.groundSpeed[up], b.stickiness[up] = low, floorSpeed, mu
  b.level[up] = b.level[low] + 1
end

-- What friction between slot i and what that stands on can still give (see `left`).
local function graspOf(b, i, sign, t)
  local used = sign * b.gripUsed[i]
  local grasp = b.grip[i] - used
  if t > 0 then
    -- What was given was given before; but what pushes the other way might end now.
    local lasting = b.grip[i] - b.gripHit[i]
    grasp = min(grasp, (lasting + min(max(-used, 0), lasting)) * (1 - t))
  end
  return grasp
end

--- Returns how large an impulse friction can still give slot i across gravity, in the direction of
--- `sign`: from what it stands on, through that from what it stands on, too; from moment t (0..1)
--- of the step on, when impacts at its beginning are over. 0: none worth it.
function grip.left(b, i, sign, t)
  local least, last = huge, i
  while i ~= 0 do
    local grasp = graspOf(b, i, sign, t)
    if grasp <= b.grip[i] * ROUNDING then
      return 0
    end
    least, last, i = min(least, grasp), i, below(b, i)
  end
  return b.level[b.ground[last]] == 0 and least or 0
end

--- Returns where the hold of slot i (see `left`) ends first: at itself, or at one of those that it
--- stands on. Among equals it is the lowest.
function grip.weakest(b, i, sign, t)
  local weakest, least = i, huge
  while i ~= 0 do
    local grasp = graspOf(b, i, sign, t)
    if grasp <= least * (1 + ROUNDING) then
      weakest, least = i, grasp
    end
    i = below(b, i)
  end
  return weakest
end

--- A weight on slot i, which stands fast, presses on all that it stands on: by the impulse `jn`,
--- and by `lasting` in a whole step.
function grip.weighOn(b, i, jn, lasting)
  while i ~= 0 do
    b.grip[i] = b.grip[i] + b.stickiness[i] * jn
    b.gripHit[i] = b.gripHit[i] + b.stickiness[i] * (jn - lasting)
    i = below(b, i)
  end
end

--- Gives slot i an impulse, from the ground through all that it stands on.
function grip.give(b, i, impulse)
  while i ~= 0 do
    b.gripUsed[i] = b.gripUsed[i] + impulse
    i = below(b, i)
  end
end

--- Where ku, which begins its path anew, ends it if it goes as the surface of `low` does, kw: for
--- `tau` s, at a speed of `floorSpeed`.
function grip.goal(b, up, low, ku, kw, floorSpeed, tau)
  -- A kinematic object's path began with the step, that of a dynamic one at this moment.
  local left = b.kind[low] == DYNAMIC and 1 or 1 - b.time[up]
  return b.from[ku] + (b.to[kw] - b.from[kw]) * left + (floorSpeed - b.speed[kw]) * tau
end

--- Lets k end its path at a place, if it does so but for rounding: who does not move against what
--- it stands on stays where it is there, to the bit.
function grip.settle(b, k, goal)
  if max(goal - b.to[k], b.to[k] - goal) < ROUNDING then
    b.to[k] = goal
  end
end

--- Lets slot i, which others push, stand still on what it stands on, from now on: for `tau` s.
function grip.hold(b, i, axis, tau)
  local k, low = 2 * i + axis, b.ground[i]
  local floorSpeed = b.groundSpeed[i]
  local goal = grip.goal(b, i, low, k, 2 * low + axis, floorSpeed, tau)
  b.speed[k], b.stuck[i], b.gripAccel[i] = floorSpeed, 1, 0
  -- Who stood when the step began has not moved.
  if b.velocity[k] + b.carried[k] == floorSpeed then
    b.to[k] = goal
    return
  end
  return grip.settle(b, k, goal)
end

-- Whether friction may give slot i anything against going at v px/s. One question.
local function mayResist(b, i, v)
  local u, level = v - b.groundSpeed[i], b.level[i] - 1
  local isOnFirm = max(1 - max(level, -level), b.stuck[b.ground[i]])
  return min(b.grip[i] * max(u, -u) * ALL + b.gripUsed[i] * u, isOnFirm) > 0
end

--- Whether friction may bear some of a push across gravity, as `bear` does: one of the two, which
--- close at v px/s, would not go on as it is rubbed already. (`press` asks the same.)
function grip.mayBear(b, lo, hi, kl, wl, wh, v)
  if min(wl, wh) <= 0 then
    return false
  end
  local common = b.speed[kl] - v * (wl / (wl + wh))
  return mayResist(b, lo, common) or mayResist(b, hi, common)
end

-- Friction of slot i against going on with others, `mass` in all, at v px/s: gives it what stops
-- them all, or what it can. Returns the impulse, and whether that stops them.
local function resist(b, i, v, mass, t)
  if not mayResist(b, i, v) then
    return 0, false
  end
  local u = v - b.groundSpeed[i]
  local amount = max(u, -u)
  local sign, needed = u > 0 and -1 or 1, amount * mass
  local grasp = grip.left(b, i, sign, t)
  local stops = needed <= grasp * (1 + ROUNDING)
  local impulse = (stops and needed or grasp) * sign
  if grasp > 0 then
    grip.give(b, i, impulse)
  end
  return impulse, stops
end

--- Lets friction bear a push across gravity, as far as it can: `lo` and `hi`, who meet at moment t
--- (0..1), close at v px/s at the end of the step, `tau` s later, and both give way (inverse masses
--- `wl`, `wh`). It acts on both, who go on together, all that time.
--- Returns the inverse masses for the push (0 for one who stands, and whom friction does not let
--- go), the impulse of the contact, and who stands where it is rubbed (0: neither): so will both.
function grip.bear(b, lo, hi, kl, kh, wl, wh, v, t, tau)
  local mass, common = 1 / wl + 1 / wh, b.speed[kl] - v * (wl / (wl + wh))
  -- Who bears less does not stop who bears more.
  local weak, strong, isLowWeak = hi, lo, b.grip[lo] <= b.grip[hi]
  if isLowWeak then
    weak, strong = lo, hi
  end
  local less, isWeakStill = resist(b, weak, common, mass, t)
  local more, isStrongStill = resist(b, strong, common + less / mass, mass, t)
  local still = isStrongStill and strong or (isWeakStill and more == 0 and weak) or 0
  -- Who stands stays there; who has been braked within the step was elsewhere before.
  if isStrongStill and less == 0 and b.stuck[strong] > 0 then
    if strong == lo and b.speed[kl] == b.groundSpeed[lo] then
      return 0, wh, v / wh, lo
    elseif strong == hi and b.speed[kh] == b.groundSpeed[hi] then
      return wl, 0, v / wl, hi
    end
  end
  local dSpeed = (less + more) / mass
  local dWay = b.pushFirst and 0 or dSpeed * tau * 0.5
  b.speed[kl], b.speed[kh] = b.speed[kl] + dSpeed, b.speed[kh] + dSpeed
  b.to[kl], b.to[kh] = b.to[kl] + dWay, b.to[kh] + dWay
  local forLow, forHigh = more, less
  if isLowWeak then
    forLow, forHigh = less, more
  end
  return wl, wh, (v + forLow * wl - forHigh * wh) / (wl + wh), still
end

return grip
