--- Step 6, meet: two of whom one stands on the other when the step begins, in the way that most do.
--
-- What is not simple is refused and goes to `press`. This is compiled; what it has in common with
-- the interpreted files (`path.change`, `impact.at`, ...) is written out here, because the trace
-- compiler gives up functions that interpreted ones call, and with them the loop.
--
-- Writes what `resolve` would write.

local here = (...):match("^(.*)%.[^.]+$")
local columns = require(here .. ".columns")
local friction = require(here .. ".friction")
local impact = require(here .. ".impact")
local press = require(here .. ".press")
local resolve = require(here .. ".resolve")
local rounds = require(here .. ".rounds")

local footing = {}

local DYNAMIC, WELDS = columns.DYNAMIC, resolve.WELDS
local STILL, TINY = columns.STILL, columns.TINY
local EVEN, ROUNDING = impact.EVEN, impact.ROUNDING
local max, min = math.max, math.min

-- Columns of the side towards the floor: held, holder, pressed, and pressed away from it.
local function sidesOf(b, isUp)
  if isUp then
    return b.heldLow, b.holderLow, b.pressedLow, b.pressedHigh
  end
  return b.heldHigh, b.holderHigh, b.pressedHigh, b.pressedLow
end

-- A weight on slot i presses on all that it stands on, as in `grip`: notes it in that column, or
-- what of it is an impact in `gripHit`.
local function weighOn(b, column, i, impulse)
  local stickiness, ground, level = b.stickiness, b.ground, b.level
  local at = level[i]
  repeat
    column[i] = column[i] + stickiness[i] * impulse
    local before = at
    i = ground[i]
    at = level[i]
  until at == 0 or at >= before
end

-- Notes that `up` goes along with `low`, as `cargo.put` does.
local function goWith(b, up, low)
  local cargo, nextCargo, goesWith = b.cargo, b.nextCargo, b.goesWith
  if goesWith[up] == 0 then
    goesWith[up], nextCargo[up], cargo[low] = low, cargo[low], up
    b.hasCargo = true
  end
end

-- How far apart two numbers are.
local function apart(v, other)
  return max(v - other, other - v)
end

-- How much friction between two, along the axis of ka and kb, is another case than that of two that
-- are pulled alike, on no belt, and of whom the upper one is not welded, nor at its limit. 0: not
-- at all. (One question: each more would be a way of its own through all that follows.)
local function strangeness(b, low, ku, ka, kb, sign)
  local weld, belt, kept = b.weld[ka], b.surfaceSpeed[low], b.reserve[ka]
  local odd = apart(b.accel[ka], b.accel[kb]) + apart(b.down[ku], sign) + weld
  return odd + max(belt, -belt) + max(kept, -kept)
end

-- Friction between two that do not move against each other, nor would: `up` sticks to `low` where
-- that stands fast. Returns false for all others, whom `friction` must look at.
local function stick(b, up, low, ku, kl, mu, impulse, sign)
  local across = 1 - 2 * b.downAxis -- from an index along gravity to the one across
  local ka, kb = ku + across, kl + across
  local isFast = b.inverseMass[low] == 0
  if apart(b.speed[ka], b.speed[kb]) + strangeness(b, low, ku, ka, kb, sign) > 0 then
    return false
  elseif not isFast and b.down[kl] ~= sign then
    return false
  elseif not isFast and b.stuck[low] == 0 then
    if b.grip[low] > 0 then
      return false
    end
    b.changes[kb] = b.changes[kb] + 1
    return true -- both slide, together
  end
  if not isFast then
    weighOn(b, b.grip, low, impulse)
    goWith(b, up, low)
  end
  b.stuck[up], b.stickiness[up], b.grip[up] = 1, mu, b.grip[up] + mu * impulse
  b.ground[up], b.groundSpeed[up], b.level[up] = low, b.speed[kb], b.level[low] + 1
  b.to[ka], b.changes[ka] = b.from[ka] + (b.to[kb] - b.from[kb]), b.changes[ka] + 1
  return true
end

-- What is left of u when its amount is less by `loss`, which does not turn it round. No branches.
local function lessen(u, loss)
  return max(u - loss, 0.0) + min(u + loss, 0.0)
end

-- Whether k, or m, is pushed by one that cannot be pushed back.
local function isBacked(b, k, m)
  local low, high = b.backedLow, b.backedHigh
  return b.hasBacked and (low[k] or high[k] or low[m] or high[m])
end

-- Friction between two that both slide, and are pulled alike: the simple half of `friction`.
-- Returns false for all others.
local function slideTogether(b, up, low, ku, kl, limit, share, sign, dt)
  local across = 1 - 2 * b.downAxis
  local ka, kb = ku + across, kl + across
  local heldLow, heldHigh, weld = b.heldLow, b.heldHigh, b.weld
  local wu, wl = b.inverseMass[up], b.inverseMass[low]
  local held = heldLow[ka] + heldHigh[ka] + heldLow[kb] + heldHigh[kb]
  local strange = strangeness(b, low, ku, ka, kb, sign) + b.grip[low] + weld[kb] + held
  if strange + b.stuck[low] > 0 or wl == 0 or isBacked(b, ka, kb) then
    return false
  end
  local to, speed, changes = b.to, b.speed, b.changes
  local w, u = wu + wl, speed[ka] - speed[kb]
  local stop, way = 0.0, 0.0
  if max(u, -u) >= STILL then
    local v, brake = lessen(u, limit * w * share), limit * w * (1 - share) / dt
    stop = lessen(v, brake * dt)
    way = (v + stop) * 0.5 * min(dt, max(v, -v) / max(brake, TINY))
  end
  local dSpeed, dWay = stop - u, way - (u + u) * 0.5 * dt
  local shareU, shareL = wu / w, wl / w
  speed[ka], to[ka] = speed[ka] + dSpeed * shareU, to[ka] + dWay * shareU
  speed[kb], to[kb] = speed[kb] - dSpeed * shareL, to[kb] - dWay * shareL
  changes[ka], changes[kb] = changes[ka] + 1, changes[kb] + 1
  return true
end

-- Whether one that cannot give way has something on it that can, nothing is welded or backed, and
-- they have not met again and again.
local function isSimple(b, p, up, low, ku, kl, isUp)
  local weld, time, held, upHeld = b.weld, b.time, b.heldHigh, b.heldLow
  if isUp then
    held, upHeld = b.heldLow, b.heldHigh
  end
  return held[kl] + (DYNAMIC - b.kind[low]) > 0
    and b.met[p] < WELDS
    and weld[ku] + weld[kl] == 0
    and held[ku] + upHeld[ku] + upHeld[kl] == 0
    and time[up] + time[low] == 0
    and not isBacked(b, ku, kl)
end

--- Puts `up` on `low`, who meet on `side` of the pair's first, as `resolve` would: flush, without a
--- bounce, held from below. If that presses, notes for friction by how much, at place x, and that
--- it was the n-th turn. Returns false if the case is another one; nothing has changed then.
function footing.putOn(b, n, x, p, side, up, low, ku, kl, isUp, dt)
  if not isSimple(b, p, up, low, ku, kl, isUp) then
    return false
  elseif b.hasCargo and b.down[ku] == 0 and b.cargo[up] > 0 then
    return false -- this is across its own gravity, and somebody may go along with it
  end
  local v ---@type number
  -- (A block, so that LuaJIT need not keep what is in it at the last question. For the same reason
  -- the sides are asked for so late: where somebody does not press nobody needs them.)
  do
    local to, size, speed, accel, drive = b.to, b.size, b.speed, b.accel, b.drive
    local sign = isUp and -1 or 1
    v = (speed[ku] - speed[kl]) * sign
    local pull = (drive[ku] - drive[kl]) * sign
    local goal = isUp and to[kl] + size[kl] or to[kl] - size[ku]
    local o = isUp and goal - to[ku] or to[ku] + size[ku] - to[kl]
    -- They touch already: the simple half of `impact.at`.
    local start = v - (accel[ku] - accel[kl]) * sign * dt
    if pull < -EVEN or start <= -STILL or o < (v + start) * 0.5 * dt * (1 - ROUNDING) then
      return false
    end
    local u = start > STILL and start or 0
    if press.bounces(b, up, low, u, pull, dt) then
      return false
    end
    press.noteHit(b, p, side, u)
    local held, holder, pressed, pressedUp = sidesOf(b, isUp)
    local changes = b.changes
    to[ku], changes[ku] = goal, changes[ku] + 1
    if v > 0 then
      speed[ku] = speed[kl]
      b.turnImpulse[x], b.turnShare[x], b.turnLeft[x] = v / b.inverseMass[up], min(u / v, 1.0), dt
      b.isTurnStale[1] = true -- as after any change of a path, here or by friction
    end
    if v > -STILL then
      -- It leans on `low` from now on.
      accel[ku], drive[ku] = accel[kl], drive[kl]
      pressed[ku], held[ku], holder[ku] = true, 1, low
      pressedUp[kl] = true -- means nothing for one that is not dynamic
    end
    b.turnSeen[x] = changes[ku] + changes[kl]
  end
  -- Last, as many floors have no friction: what follows a branch is compiled for either way.
  if v > 0 and b.friction[up] ~= 0 and b.friction[low] ~= 0 then
    b.landedCount = b.landedCount + 1
    b.landed[b.landedCount] = n
  end
  return true
end

--- Lets those rub that have landed, in the same order. That changes paths across gravity only, on
--- which no footing depends, nor anything else that goes before the flanks; so it may follow the
--- landings (one loop for both would be too long for the trace compiler). Returns false at one that
--- needs more than this loop does, and must `rub`: the last of b.landed[1..b.slidCount].
function footing.slide(b, dt)
  local order, ups, lows, landed = b.turnOrder, b.turnUp, b.turnLow, b.landed
  local axis, shares, impulses = b.downAxis, b.turnShare, b.turnImpulse
  local sign = b.orientation[axis] < 0 and -1 or 1
  local base, way = rounds.direction(b.turnRound, 1, b.footingCount)
  local at, goesOn = b.slidCount, true
  while goesOn and at < b.landedCount do
    at = at + 1
    local x = order[base + way * landed[at]]
    local up, low, impulse = ups[x], lows[x], impulses[x]
    local mu = press.coefficient(b, up, low)
    local ku, kl, limit = 2 * up + axis, 2 * low + axis, mu * impulse
    goesOn = mu <= 0
      or stick(b, up, low, ku, kl, mu, impulse, sign)
      or slideTogether(b, up, low, ku, kl, limit, shares[x], sign, dt)
  end
  b.slidCount = at
  return goesOn
end

--- Notes how much of what friction can give b.landed[first..last], who have rubbed, and all below
--- them, comes from their impact. (One more number in the loop of `slide` would be one too many: a
--- third more time.)
function footing.noteImpacts(b, first, last)
  local order, ups, lows, landed = b.turnOrder, b.turnUp, b.turnLow, b.landed
  local shares, impulses, stuck, hit = b.turnShare, b.turnImpulse, b.stuck, b.gripHit
  local inverseMass = b.inverseMass
  local base, way = rounds.direction(b.turnRound, 1, b.footingCount)
  for at = first, last do
    local x = order[base + way * landed[at]]
    local up, low, share = ups[x], lows[x], shares[x]
    local isHeavy = share > 0 and stuck[up] > 0 -- whoever it stands on
    if isHeavy and (inverseMass[low] == 0 or stuck[low] > 0) then
      local mu, impulse = max(press.coefficient(b, up, low), 0), impulses[x]
      local lasting = impulse * (1 - share)
      hit[up] = hit[up] + (mu * impulse - mu * lasting)
      if mu > 0 and inverseMass[low] > 0 then
        weighOn(b, hit, low, impulse - lasting)
      end
    end
  end
end

--- Lists in `out` who has landed in this round, or been landed on, and touches somebody with whom
--- it has no turn, or may, since somebody was nudged; returns how many.
function footing.listLanded(b, out)
  local ups, lows, landed = b.turnUp, b.turnLow, b.landed
  local watched, step, isWary, count = b.watched, b.step, b.isEager, 0
  for at = 1, b.landedCount do
    local x = rounds.turnAt(b, landed[at])
    if isWary or watched[ups[x]] == step or watched[lows[x]] == step then
      out[count + 1], out[count + 2] = ups[x], lows[x]
      count = count + 2
    end
  end
  return count
end

--- Lets the two of the n-th turn of this round rub, along or across gravity, in the general way.
function footing.rub(b, n)
  local x, across = rounds.turnAt(b, n)
  local axis = across == 1 and 1 - b.downAxis or b.downAxis
  local up, low = b.turnUp[x], b.turnLow[x]
  local isDown = b.orientation[axis] > 0
  local lo, hi = isDown and up or low, isDown and low or up
  return friction.rub(b, lo, hi, axis, b.turnImpulse[x], b.turnShare[x], b.turnLeft[x], 0)
end

return footing
