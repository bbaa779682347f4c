--- Step 6, meet: what stands on somebody, and may go along with it, as a list.
--
-- A push of a box with others on it asks several times what those need, and a tower that slides
-- rubs as a whole (see `cargo`, `friction`). So the tree of who stands on whom is listed once,
-- those that stand on others before these, and each walk over it is a loop that is compiled, while
-- `cargo` is not. (One loop a function; what they have in common with `path` is written out, as in
-- `ring`.)
--
-- A list is the places `first` to `last` of b.tower, with what each stands on in b.towerOn; there
-- may be several, one behind the other. What is added up on the way to those below is in b.sum and
-- b.sumMass, which are 0 for everybody else.

local here = (...):match("^(.*)%.[^.]+$")
local columns = require(here .. ".columns")
local grip = require(here .. ".grip")

local tower = {}

local huge, max, min = math.huge, math.max, math.min
local ROUNDING, VAST = grip.ROUNDING, columns.VAST

-- Whether nothing but friction holds `up` on what it stands on (levels go up, see `grip`), and it
-- goes at v px/s, but for `most`.
local function isLoose(b, up, axis, v, most)
  local k = 2 * up + axis
  local slip = b.speed[k] - v
  return b.level[up] > b.level[b.goesWith[up]]
    and b.weld[k] == 0
    and b.heldLow[k] + b.heldHigh[k] == 0
    and not (b.backedLow[k] or b.backedHigh[k])
    and max(slip, -slip) <= most
end

-- Lists, behind place `last`, all that stand on slot i, on those, and so on, and are loose as
-- `isLoose` has it, but for slot `except`; for those right on i, b.towerOn says `root`. Notes the
-- mass of each with all on it. Returns the last place then, and the mass of all.
local function list(b, i, axis, v, most, root, except, last)
  local cargo, nextCargo, goesWith = b.cargo, b.nextCargo, b.goesWith
  local at, up = i, cargo[i]
  while at ~= i or up ~= 0 do
    if up == 0 then -- nothing else is on `at`
      last = last + 1
      local mass, low = b.mass[at] + b.sumMass[at], goesWith[at]
      b.tower[last], b.towerOn[last] = at, low == i and root or low
      b.towerMass[at], b.towerThrough[at], b.sumMass[at] = mass, 0, 0
      b.sumMass[low] = b.sumMass[low] + mass
      up, at = nextCargo[at], low
    elseif up ~= except and isLoose(b, up, axis, v, most) then
      b.towerBegin[up] = last + 1
      at, up = up, cargo[up]
    else
      up = nextCargo[up]
    end
  end
  local mass = b.sumMass[i]
  b.sumMass[i] = 0
  return last, mass
end

--- Lists all that goes along with slot i, if friction can take it, but for slot `except` with what
--- is on that. `root` stands for slot i in b.towerOn. Returns the last place then, and the mass of
--- all.
function tower.list(b, i, axis, root, except, last)
  return list(b, i, axis, 0, huge, root, except, last)
end

--- Lists slot i, as the last, and of all on it those that go as it does, at v px/s, along an axis.
--- Returns the last place then, and the mass of all.
function tower.listParts(b, i, axis, v, last)
  local top, mass = list(b, i, axis, v, 0, i, 0, last)
  -- (What friction gives the last one is for the caller to say, see `move`.)
  b.tower[top + 1], b.towerOn[top + 1], b.towerMass[i], b.towerThrough[i] = i, 0, 0, 0
  return top + 1, b.mass[i] + mass
end

--- Returns the impulse that brings all in the list to v px/s, as far as friction can, and the mass
--- of those that it brings there, both added to what is given for `root`, on which they stand.
--- Notes for each the impulse, and whether it is dragged only: one of those that it does not bring
--- there.
function tower.need(b, first, last, axis, v, root, impulse, mass)
  local sum, sumMass, dragged, impulses = b.sum, b.sumMass, b.dragged, b.dragImpulse
  sum[root], sumMass[root] = impulse, mass
  for n = first, last do
    local i, low, own = b.tower[n], b.towerOn[n], b.mass[b.tower[n]]
    local needed, its = own * (v - b.speed[2 * i + axis]) + sum[i], own + sumMass[i]
    -- No branches: most numbers of a push wait until its load is known.
    local sign = max(min(needed * VAST, 1), -1) ---@type number
    local most = max(b.grip[i] - sign * b.gripUsed[i], 0.0)
    local excess = needed * sign - most * (1 + ROUNDING)
    local isDragged = min(max(excess * VAST, 0), 1) ---@type number
    needed = needed * (1 - isDragged) + most * sign * isDragged
    its = its * (1 - isDragged)
    dragged[i], impulses[i] = isDragged, needed
    sum[i], sumMass[i] = 0, 0
    sum[low], sumMass[low] = sum[low] + needed, sumMass[low] + its
  end
  impulse, mass = sum[root], sumMass[root]
  sum[root], sumMass[root] = 0, 0
  return impulse, mass
end

-- Notes that the path of slot i has changed, in b.changed, where there are `count`; returns how
-- many there are then.
local function change(b, i, count)
  local mark, stamp, changes = b.changedMark, b.changeStamp, b.changes
  b.follows[i] = 0
  if mark[i] ~= stamp then
    count = count + 1
    mark[i], b.changed[count] = stamp, i
    changes[2 * i], changes[2 * i + 1] = changes[2 * i] + 1, changes[2 * i + 1] + 1
  end
  return count
end

--- Takes those in the list along with what they stand on, the last ones first, in a step of dt s,
--- up to one that is dragged; returns the place of that. What they need has been noted (see
--- `need`). Who began the step as fast as what it stands on goes that way to the bit.
function tower.take(b, first, last, axis, dt)
  local speed, accel, from, to = b.speed, b.accel, b.from, b.to
  local velocity, carried, count, n = b.velocity, b.carried, b.changedCount, last
  while n >= first and b.dragged[b.tower[n]] == 0 do
    local up, on = b.tower[n], b.towerOn[n]
    local k, m = 2 * up + axis, 2 * b.goesWith[up] + axis
    local before, was, new = speed[k], to[k], speed[m]
    speed[k], accel[k] = new, accel[m]
    local began = velocity[k] + carried[k] - (velocity[m] + carried[m])
    if began == 0 then
      to[k] = from[k] + (to[m] - from[m])
    else
      local isOther = min(max(before - b.dragFrom[on], b.dragFrom[on] - before) * VAST, 1)
      to[k] = was + (b.dragWay[on] * (1 - isOther) + (new - before) * dt * 0.5 * isOther)
    end
    b.gripUsed[up] = b.gripUsed[up] + b.dragImpulse[up]
    b.groundSpeed[up], b.taken[up] = new, b.step
    b.dragFrom[up], b.dragWay[up] = before, to[k] - was
    count, n = change(b, up, count), n - 1
  end
  b.changedCount = count
  b.isTurnStale[0], b.isTurnStale[1] = true, true
  return n
end

--- Marks those in the list through whom slot `low`, which is in it, stands on the last of it,
--- `base`: friction there takes what `low` gets (see `holds`, `move`).
function tower.markThrough(b, low, base)
  local goesWith, through = b.goesWith, b.towerThrough
  while low ~= base do
    through[low] = 1
    low = goesWith[low]
  end
end

--- Whether friction can hold the parts in the list together if they become faster by `gain`, as the
--- one that is marked gets an impulse, under a weight.
function tower.holds(b, first, last, gain, impulse, weight)
  local excess = 0.0
  for n = first, last - 1 do
    local i = b.tower[n]
    local isIt = b.towerThrough[i]
    local needed = b.gripUsed[i] + b.towerMass[i] * gain - isIt * impulse
    local most = b.grip[i] + isIt * b.stickiness[i] * weight
    excess = max(excess, max(needed, -needed) - most * (1 + ROUNDING))
  end
  return excess <= 0
end

--- Lets all in the list go on at `new` px/s, faster by `gain`, and `way` px further, with an
--- acceleration, as the one that is marked gets an impulse.
function tower.move(b, first, last, axis, new, gain, way, accel, impulse)
  local used, speed, to, accels, count = b.gripUsed, b.speed, b.to, b.accel, b.changedCount
  for n = first, last do
    local i = b.tower[n]
    local k = 2 * i + axis
    used[i] = used[i] + b.towerMass[i] * gain - b.towerThrough[i] * impulse
    speed[k], to[k], accels[k] = new, to[k] + way, accel
    count = change(b, i, count)
  end
  b.changedCount = count
  b.isTurnStale[0], b.isTurnStale[1] = true, true
end

--- Tells all that stand on somebody in the list that it goes at v px/s now: they slide, unless they
--- go on, too.
function tower.tell(b, first, last, v)
  local places, cargo, nextCargo, groundSpeed = b.tower, b.cargo, b.nextCargo, b.groundSpeed
  local n, up = first, cargo[places[first]]
  while n <= last do
    if up ~= 0 then
      groundSpeed[up] = v
      up = nextCargo[up]
    else
      n = n + 1
      up = n <= last and cargo[places[n]] or 0
    end
  end
end

--- Notes that all in the list have stopped, and go `way` px in this step, as their ground does. Who
--- has not moved otherwise goes that way to the bit.
function tower.stop(b, first, last, axis, way)
  local stuck, from, to = b.stuck, b.from, b.to
  for n = first, last do
    local i = b.tower[n]
    local k = 2 * i + axis
    local goal = from[k] + way
    if max(goal - to[k], to[k] - goal) < ROUNDING then -- as in `grip.settle`
      to[k] = goal
    end
    stuck[i] = 1
  end
end

return tower
