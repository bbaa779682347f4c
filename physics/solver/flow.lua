--- Motion of one body or block along an axis under constant forces, with kinks.
--
-- A kink is a velocity at which the force jumps down: Coulomb friction of limit L against a ground
-- that moves at v is a kink of 2 L at v; an engine that stops pulling at its speed limit is a kink
-- of its force there. The force is the least in the fastest motion, so the body comes to rest at a
-- kink when the force points to it from both sides, and stays there. Friction that stops a body,
-- turns it or holds it, and engines at their limit, are all found at their moment this way.
--
-- Kinks are in lists, by rising velocity: `kinkAt`, `kinkJump`, `kinkNext`; 0 ends a list.

local flow = {}

-- Stretches of time between two kinks, at most.
local STRETCHES = 8

--- Forgets all kinks.
function flow.reset(b)
  b.kinkCount = 0
end

--- Adds a kink to a list and returns the list.
function flow.add(b, list, at, jump)
  local kinkAt, kinkNext, n = b.kinkAt, b.kinkNext, b.kinkCount + 1
  b.kinkCount = n
  kinkAt[n], b.kinkJump[n], kinkNext[n] = at, jump, 0
  if list == 0 or at < kinkAt[list] then
    kinkNext[n] = list
    return n
  end
  local before = list
  while kinkNext[before] ~= 0 and kinkAt[kinkNext[before]] <= at do
    before = kinkNext[before]
  end
  kinkNext[n], kinkNext[before] = kinkNext[before], n
  return list
end

--- Merges two lists of kinks and returns the list. Kinks at one velocity become one.
function flow.merge(b, one, other)
  local kinkAt, kinkJump, kinkNext = b.kinkAt, b.kinkJump, b.kinkNext
  local first, last = 0, 0
  while one ~= 0 or other ~= 0 do
    local n
    if other == 0 or (one ~= 0 and kinkAt[one] <= kinkAt[other]) then
      n, one = one, kinkNext[one]
    else
      n, other = other, kinkNext[other]
    end
    if last ~= 0 and kinkAt[last] == kinkAt[n] then
      kinkJump[last] = kinkJump[last] + kinkJump[n]
    elseif last == 0 then
      first, last = n, n
    else
      kinkNext[last], last = n, n
    end
  end
  if last ~= 0 then
    kinkNext[last] = 0
  end
  return first
end

-- The force just below and just above velocity v, and the kinks next to it on both sides.
local function around(b, list, force, v)
  local kinkAt, kinkJump, kinkNext = b.kinkAt, b.kinkJump, b.kinkNext
  local below, above, slower = force, force, 0
  while list ~= 0 and kinkAt[list] <= v do
    above = above - kinkJump[list]
    if kinkAt[list] < v then
      below, slower = above, list
    end
    list = kinkNext[list]
  end
  return below, above, slower, list
end

--- Returns the velocity after `tau` s and the way until then, px, of a body of this mass that is
--- pulled by `force` below all kinks and starts at velocity v.
function flow.run(b, list, mass, force, v, tau)
  local way = 0.0
  for _ = 1, STRETCHES do
    local below, above, slower, faster = around(b, list, force, v)
    local a, kink = 0, 0
    if above > 0 then
      a, kink = above / mass, faster
    elseif below < 0 then
      a, kink = below / mass, slower
    end
    if a == 0 then
      return v, way + v * tau
    end
    local last = v + a * tau
    if kink == 0 or (b.kinkAt[kink] - last) * a >= 0 then
      return last, way + (v + last) * 0.5 * tau
    end
    local at = b.kinkAt[kink]
    local time = (at - v) / a
    v, way, tau = at, way + (v + at) * 0.5 * time, tau - time
  end
  return v, way + v * tau
end

--- The same of one body with nothing but Coulomb friction: its own acceleration a, ground that
--- moves at `base`, and a deceleration by friction of `brake` px/s².
function flow.slide(v, a, base, brake, tau)
  local slip, way = v - base, base * tau
  if slip ~= 0 then
    local d = slip > 0 and a - brake or a + brake
    local last = slip + d * tau
    if last * slip >= 0 then
      return base + last, way + (slip + last) * 0.5 * tau
    end
    local time = -slip / d
    way, tau = way + slip * 0.5 * time, tau - time
  end
  local d = a > brake and a - brake or a < -brake and a + brake or 0.0
  return base + d * tau, way + d * tau * 0.5 * tau
end

return flow
