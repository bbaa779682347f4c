---@diagnostic disable
--- Planes: half-planes in which a point must be, and the point in all of them that is nearest to
-- where it wants to be.
--
--      nx * x + ny * y >= least        (nx, ny) is the unit normal, into the free side
--
-- The nearest point is either the point itself, or on one half-plane (straight along its normal),
-- or in the corner of two. In two dimensions no more than two matter, so trying all pairs is exact.
-- With velocities in place of places (`least` is then the speed of the wall along the normal) this
-- clips a velocity against walls.
--
-- Source: clipping a move against planes, and then against the crease of two (`SV_FlyMove` in the
-- game Quake); here for the nearest point.

local planes = {}

local max = math.max
-- px by which a place may be outside of a half-plane, as it is rounded.
local ROUNDING = 1e-7
-- Two half-planes are parallel if the sine between their normals is less.
local PARALLEL = 1e-6

--- The half-planes of the body that is looked at: 1 to `planes.count`. `wall` is the slot behind
--- the face, `side` the side with which the body leans on it.
planes.count = 0
local nx, ny, least, wall, side = {}, {}, {}, {}, {}
planes.nx, planes.ny, planes.least, planes.wall, planes.side = nx, ny, least, wall, side

local function set(n, x, y, place, j, itsSide)
  nx[n], ny[n], least[n], wall[n], side[n] = x, y, place, j, itsSide
end

--- Adds a half-plane. If one with this normal is listed, the narrower one counts; if both are
--- equal, the one with the wall that comes first in the order of the world (`rank`).
function planes.add(rank, x, y, place, j, itsSide)
  local n = 1
  while n <= planes.count and not (nx[n] == x and ny[n] == y) do
    n = n + 1
  end
  local isNew = n > planes.count
  planes.count = max(planes.count, n)
  if isNew or place > least[n] or place == least[n] and rank[j] < rank[wall[n]] then
    set(n, x, y, place, j, itsSide)
  end
end

--- Forgets all half-planes but n and m, which comes first. Either may be 0: none.
function planes.keepOnly(n, m)
  planes.count = n > 0 and (m > 0 and 2 or 1) or 0
  for at = 1, planes.count do
    local from = at < planes.count and m or n
    set(at, nx[from], ny[from], least[from], wall[from], side[from])
  end
end

local function isIn(x, y)
  for n = 1, planes.count do
    if nx[n] * x + ny[n] * y < least[n] - ROUNDING then
      return false
    end
  end
  return true
end

-- Returns the point of half-plane n that is nearest to (x, y), or its corner with half-plane m, if
-- that is not 0; nil: the two are parallel.
local function pointOf(n, m, x, y)
  if m == 0 then
    local distance = max(least[n] - nx[n] * x - ny[n] * y, 0.0)
    return x + nx[n] * distance, y + ny[n] * distance
  end
  local sine = nx[n] * ny[m] - ny[n] * nx[m]
  if sine > PARALLEL or sine < -PARALLEL then
    local atX, atY = least[n] * ny[m] - least[m] * ny[n], least[m] * nx[n] - least[n] * nx[m]
    return atX / sine, atY / sine
  end
end

--- Returns the point in all half-planes that is nearest to (x, y), at most `most` away, and the one
--- or two on which it is (0: none); nil: there is no such point.
function planes.nearest(x, y, most)
  if isIn(x, y) then
    return x, y, 0, 0
  end
  local bestX, bestY, one, other, best = nil, nil, 0, 0, most * most
  for n = 1, planes.count do
    for m = 0, n - 1 do
      local atX, atY = pointOf(n, m, x, y)
      local far = atX and (atX - x) * (atX - x) + (atY - y) * (atY - y)
      if far and far < best and isIn(atX, atY) then
        bestX, bestY, one, other, best = atX, atY, n, m, far
      end
    end
  end
  return bestX, bestY, one, other
end

return planes
