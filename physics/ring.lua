--- The rings of welded objects (see `weld`): what is done to all members, one after the other.
--
-- A ring may have a hundred members, who are passed at every hit; so these loops are compiled,
-- while `weld` is not. What they have in common with `path` is written out (see `footing`).

local ring = {}

local floor, max = math.floor, math.max

--- Tells all of the ring of k who leads it.
function ring.name(b, k, leader)
  local weld, weldNext, member = b.weld, b.weldNext, k
  repeat
    weld[member] = leader
    member = weldNext[member]
  until member == k
end

--- Whether the ring of `one` has more members than that of `other`; looks at no more of them than
--- the shorter one has. Who joins two rings names the shorter one anew: a long row that is joined
--- one by one would be named from end to end each time.
function ring.isLonger(b, one, other)
  local weldNext, member, its = b.weldNext, b.weldNext[one], b.weldNext[other]
  while member ~= one and its ~= other do
    member, its = weldNext[member], weldNext[its]
  end
  return member ~= one
end

--- Marks all of the ring of k, which may be nobody else, as held on the low or high side
--- (1; 0: not on this one).
function ring.hold(b, k, low, high)
  if low + high == 0 then
    return -- mostly
  end
  local heldLow, heldHigh, weldNext, member = b.heldLow, b.heldHigh, b.weldNext, k
  repeat
    heldLow[member], heldHigh[member] = max(heldLow[member], low), max(heldHigh[member], high)
    member = weldNext[member]
  until member == k or member == 0
end

-- Begins the paths of the others anew where they are at time t > 0.
local function advance(b, k, t)
  local from, to, time, weldNext = b.from, b.to, b.time, b.weldNext
  local member = weldNext[k]
  while member ~= k and member ~= 0 do
    local i = floor(member * 0.5)
    local start = time[i]
    if t > start then
      local share, m = (t - start) / (1 - start), 2 * i
      from[m] = from[m] + (to[m] - from[m]) * share
      from[m + 1] = from[m + 1] + (to[m + 1] - from[m + 1]) * share
      time[i] = t
    end
    member = weldNext[member]
  end
end

-- Counts that the paths of the others have changed.
local function countChanges(b, k)
  local weldNext, changes = b.weldNext, b.changes
  local member = weldNext[k]
  while member ~= k and member ~= 0 do
    changes[member] = changes[member] + 1
    member = weldNext[member]
  end
end

-- Notes that the paths of the others have changed, by that of `leader` alone. (Whoever is welded is
-- dynamic.)
local function change(b, k, leader)
  local changed, mark, stamp, count = b.changed, b.changedMark, b.changeStamp, b.changedCount
  local weldNext, changes, follows = b.weldNext, b.changes, b.follows
  local member = weldNext[k]
  while member ~= k and member ~= 0 do
    local i = floor(member * 0.5)
    if mark[i] ~= stamp then
      count = count + 1
      mark[i], changed[count], follows[i] = stamp, i, leader
      changes[2 * i], changes[2 * i + 1] = changes[2 * i] + 1, changes[2 * i + 1] + 1
    elseif follows[i] ~= leader then
      follows[i] = 0 -- it has followed another one, too, on the other axis
    end
    member = weldNext[member]
  end
  b.changedCount = count
end

--- Lets the others of the ring of k follow it at time t: its speed, and `way` px further.
function ring.follow(b, k, way, t)
  if b.weldNext[k] == 0 then
    return
  elseif t > 0 then
    advance(b, k, t)
  end
  local to, speed, accel, drive, weldNext = b.to, b.speed, b.accel, b.drive, b.weldNext
  local v, a, d = speed[k], accel[k], drive[k]
  local member = weldNext[k]
  while member ~= k and member ~= 0 do
    to[member], speed[member] = to[member] + way, v
    accel[member], drive[member] = a, d
    member = weldNext[member]
  end
  b.isTurnStale[0], b.isTurnStale[1] = true, true
  if b.isQuiet then
    countChanges(b, k)
  else
    -- At the very beginning all of them are looked at once more, for the sake of the last digit:
    -- there turns, which ask nobody about this, must lead to the same as the queue.
    change(b, k, t > 0 and b.weld[k] or 0)
  end
end

return ring
