---@diagnostic disable
--- Clip: computes where a box ends in a room that slopes narrow. A room that stands still crushes
-- nothing.
--
-- Settling looks at one axis at a time, and for it a slope is only another distance. In a wedge
-- that is not enough: along y the box does not fit, although it only has to stop along x.
--
--          ______________ ceiling     Each face in the way is a half-plane, in which the box must
--      [ box ]-> .-'                  stay. It ends at the point of all of them that is nearest to
--             .-'                     where it was going: there, on one of the faces, or in the
--          .-' slope                  corner of two.
--
-- Where the box began the step, it was in the half-planes of all objects that stand still. So there
-- always is such a point: objects that stand still do not crush the box, and it ends in none of
-- them. If two faces close on each other, the attempt fails; if all do, the box is left to
-- `squeeze` in settle.lua: machines do crush.
--
-- A box that was clipped is pushed nowhere in this step. Others that are in its way are clipped,
-- too: it is a wall for them, but only on the sides on which faces stop it (not `loose`).
--
-- The list begins with the objects that the box touches, also through others (`addRoom`). Further
-- walls are found one by one: the nearest point (space/planes.lua), the wall in which the box would
-- be deepest there, its face, and again, at most MOST times; a wall that the box was not in front
-- of ends the attempt. If there is no such point, fewer walls count in further attempts
-- (`counting`): the others give way, or crush.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local boxes = require(root .. ".space.boxes")
local constants = require(root .. ".memory.constants")
local contacts = require(root .. ".solver.contacts")
local links = require(root .. ".memory.links")
local filter = require(root .. ".broadphase.filter")
local pairFinder = require(root .. ".broadphase.pairFinder")
local planes = require(root .. ".space.planes")
local path = require(root .. ".motion.path")
local rounds = require(root .. ".solver.rounds")
local settle = require(root .. ".solver.settle")
local shapes = require(root .. ".space.shapes")
local touch = require(root .. ".narrowphase.touch")
local walk = require(root .. ".solver.walk")

local clip = {}

local APART, SLANTED, ENTERED = contacts.APART, contacts.SLANTED, contacts.ENTERED
local DYNAMIC, KINEMATIC, STATIC = constants.DYNAMIC, constants.KINEMATIC, constants.STATIC
local EPSILON, neighbours = constants.EPSILON, links.neighbours
local floor, huge, max, sqrt = math.floor, math.huge, math.max, math.sqrt
-- Maximum number of walls in the way of one box, besides the objects that it touches.
local MOST = 8
local nx, ny, least, wall = planes.nx, planes.ny, planes.least, planes.wall
local side = planes.side ---@type integer[]
-- px by which a box may be in a wall where the step begins.
local NEAR = 0.001
-- px/s: slower things stand still.
local STILL = 1e-6

-- Which walls count: ALL; 2: not the static ones behind other bodies, since these bodies may give
-- way; FIXED: static ones only.
local ALL, FIXED = 1, 3
local counting = ALL

-- How fast slot `wall` of half-plane n goes along the normal of half-plane m, px/s.
local function speedAlong(b, n, m)
  local k = 2 * wall[n]
  return nx[m] * b.speed[k] + ny[m] * b.speed[k + 1]
end

-- Returns whether half-planes n and m (0: none) close on each other, or part: each moves along the
-- normal of the other one. (A train under a ceiling goes along its own face: it closes on nothing.)
-- If not all walls count, whether one of them moves: then it closes on those that do not.
local function areClosing(b, n, m)
  if counting > ALL then
    return n > 0 and speedAlong(b, n, n) > STILL or m > 0 and speedAlong(b, m, m) > STILL
  elseif m == 0 then
    return false
  end
  local one = speedAlong(b, n, n) - speedAlong(b, m, n)
  local other = speedAlong(b, n, m) - speedAlong(b, m, m)
  return max(one, -one) > STILL and max(other, -other) > STILL
end

-- Walls in the way --------------------------------------------------------------------------------

-- Goes on with the room of each side along the contacts of an axis, from low bodies to high ones
-- (`sign` 1) or back (-1).
local function spread(b, list, sign)
  local room, walls, at = b.clipWork.room, b.clipWork.wall, sign > 0 and 1 or 2
  local near, far, first, last = contacts.along(list, sign)
  for c = first, last, sign do
    local from, to = 2 * near[c] + at, 2 * far[c] + at
    local place = room[from] + sign * list.separation[c]
    if b.kind[floor(far[c] * 0.5)] == DYNAMIC and place * sign > room[to] * sign then
      room[to], walls[to] = place, walls[from]
    end
  end
end

-- Notes the furthest place (`room`, px) to which each body can go along an axis until it meets a
-- wall, directly or through other bodies, and which wall that is. (Bodies that are squeezed are in
-- each other. One that was clipped is a wall where faces stop it, and gives way to its other side.)
local function findRoom(b, axis)
  local list, work = b.contacts[axis], b.clipWork
  for c = 1, list.count do
    for n = 0, 3 do
      local k = n < 2 and list.low[c] or list.high[c]
      local at, furthest = 2 * k + 1 + n % 2, n % 2 == 0 and -huge or huge
      local isLoose = b.give[k] > 0 or work.loose[at] == b.solveStamp
      work.room[at], work.wall[at] = isLoose and furthest or b.to[k], floor(k * 0.5)
    end
  end
  spread(b, list, 1)
  spread(b, list, -1)
end

-- Adds a half-plane that slot j, directly or through others, keeps box i in, if that wall counts.
local function addWall(b, x, y, place, j, itsSide)
  if counting == ALL or b.kind[j] ~= STATIC then
    planes.add(b.rank, x, y, place, j, itsSide)
  end
end

-- px from box i at (x, y) to the nearest face of slot j, at moment t; its normal, and whether it is
-- an edge.
local function face(b, i, j, x, y, t)
  local m, start = 2 * j, b.time[j]
  local ox, oy = path.at(b, m, start, t), path.at(b, m + 1, start, t)
  return touch.face(b, i, j, x, y, ox, oy, b.size)
end

-- Whether slot j, of pair p, stops box i, and does not give way (round and one-way objects: never).
local function isWall(b, p, i, j)
  local isFirm = b.kind[j] == STATIC or b.kind[j] == KINEMATIC and counting < FIXED
  return isFirm and not shapes.isRound[b.shape[j]] and not b.passing[p] and filter.blocks(b, i, j)
end

-- Returns the wall that box i would be deepest in at (x, y), at moment t; nil: it would be in none.
local function wallAt(b, i, x, y, t)
  local deepest, first = -2 * EPSILON, nil
  for _, j, p in neighbours(b, i) do
    local gap = isWall(b, p, i, j) and face(b, i, j, x, y, t) or 0.0
    if gap < deepest or first and gap == deepest and b.rank[j] < b.rank[first] then
      deepest, first = gap, j
    end
  end
  return first
end

-- Returns the wall that box i would end in at (x, y), and looks up the neighbours of that place.
local function lookUp(b, i, x, y)
  path.lead(b, i, x, y)
  b.stack[1] = i
  pairFinder.run(b, b.stack, 1)
  return wallAt(b, i, x, y, 1)
end

-- px that slot i goes in the step.
local function wayOf(b, i, from)
  local x, y = b.to[2 * i] - from[2 * i], b.to[2 * i + 1] - from[2 * i + 1]
  return sqrt(x * x + y * y)
end

-- Adds the half-plane of slot j: that of the face which box i was in front of at moment t, when it
-- was at (x, y). Returns whether it was. (The face goes where slot j goes.) If the two touch
-- (`isTouched`), only such a face counts, and no edge on which the box walks: it may pass its
-- crest.
local function addFace(b, i, j, x, y, t, isTouched)
  local gap, faceX, faceY, isEdge = face(b, i, j, x, y, t)
  local m, start, to, isBefore = 2 * j, b.time[j], b.to, gap >= -2 * EPSILON
  x, y = x + to[m] - path.at(b, m, start, t), y + to[m + 1] - path.at(b, m + 1, start, t)
  local _, _, itsSide = shapes.sideOf(faceX, faceY, isEdge, touch.axisOf(b, i, j))
  if not isTouched or isBefore and not (isEdge and touch.gradient(b, i, j) ~= 0) then
    planes.add(b.rank, faceX, faceY, faceX * x + faceY * y - gap, j, itsSide)
  end
  return isBefore
end

-- Adds the half-planes of the objects that box i, which was at (x, y) at moment t, touches. (Those
-- of slopes, too: nothing sweeps a contact, so a fast box would end behind a slope.)
local function addRoom(b, i, x, y, t)
  local room, walls = b.clipWork.room, b.clipWork.wall
  for _, j, p in neighbours(b, i) do
    local isTouched = b.touches[p] > APART and b.touches[p] < SLANTED
    if isTouched and touch.haveFaces(b, i, j) then
      if isWall(b, p, i, j) then
        addFace(b, i, j, x, y, t, true)
      end
    elseif isTouched and counting < FIXED then
      local kl, separation = b.bodyOf[2 * p], b.separation[p]
      local axis, isLow = kl % 2, floor(kl * 0.5) == i
      local at = isLow and 2 * b.bodyOf[2 * p + 1] + 2 or 2 * kl + 1
      if isLow and room[at] < huge then
        addWall(b, axis - 1, -axis, separation - room[at], walls[at], 2 * axis + 2)
      elseif not isLow and room[at] > -huge then
        addWall(b, 1 - axis, axis, room[at] + separation, walls[at], 2 * axis + 1)
      end
    end
  end
end

-- Returns where box i ends, if it is to come to no wall, and leaves the half-planes on which it is
-- there; nil: there is no such place. Box i ends at most as far from its goal as the step, or its
-- path, began, plus the ways of the listed walls: a stack under a press would jump. Faces are those
-- in front of which it was when its path began, or if that was in a wall, when the step began.
local function findPlace(b, i)
  local k, most, t = 2 * i, max(wayOf(b, i, b.origin), wayOf(b, i, b.from)) + NEAR, b.time[i]
  local startX, startY = b.from[k], b.from[k + 1] -- (no column: `lookUp` may replace that)
  if wallAt(b, i, startX, startY, t) then
    startX, startY, t = b.origin[k], b.origin[k + 1], 0
    b.from[k], b.from[k + 1], b.time[i] = startX, startY, t -- (else it would walk from in there)
  end
  planes.count = 0
  addRoom(b, i, startX, startY, t)
  for n = 1, planes.count do
    most = most + wayOf(b, wall[n], b.from)
  end
  local wantX, wantY = b.to[k], b.to[k + 1]
  local x, y, one, other, j
  for _ = 1, MOST do
    x, y, one, other = planes.nearest(wantX, wantY, most)
    j = x and lookUp(b, i, x, y)
    if not j or not addFace(b, i, j, startX, startY, t) then
      break
    end
    most = most + wayOf(b, j, b.from)
  end
  path.lead(b, i, wantX, wantY)
  if x and not (j or areClosing(b, one, other)) then
    planes.keepOnly(one, other)
    return x, y
  end
end

-- Clipping ----------------------------------------------------------------------------------------

-- Notes that half-plane n stops box i on the sides to which its face looks. In a corner of two an
-- edge also stops the box across gravity: notes that side as pressed.
local function stop(b, i, n)
  local work, count = b.clipWork, b.blockedCount + 1
  for axis = 0, 1 do
    local normal = axis == 0 and nx[n] or ny[n]
    local at = 4 * i + 2 * axis + (normal < 0 and 2 or 1)
    if normal ~= 0 then
      work.loose[at] = 0
    end
    if normal ~= 0 and planes.count == 2 and axis ~= (side[n] > 2 and 1 or 0) then
      b.pressedAt[at], b.blockedCount = b.solveStamp, count
      work.blocked[count], work.blockedBy[count] = at, wall[n]
    end
  end
end

-- Puts box i, which leans on the half-planes that are left, at (x, y). Its velocity is the nearest
-- one at which it goes into none of them.
local function put(b, i, x, y)
  local k = 2 * i
  for at = 4 * i + 1, 4 * i + 4 do
    b.clipWork.loose[at] = b.solveStamp
  end
  for n = 1, planes.count do
    stop(b, i, n)
    b.pressedAt[4 * i + side[n]] = b.solveStamp
    least[n] = speedAlong(b, n, n)
  end
  local vx, vy = planes.nearest(b.speed[k], b.speed[k + 1], huge)
  path.finish(b, k, x, vx + 0.0, 0.0) -- (-0 + 0 is 0)
  path.finish(b, k + 1, y, vy + 0.0, 0.0)
  b.squeezed[k], b.squeezed[k + 1], b.give[k], b.give[k + 1] = 0, 0, 0, 0
end

-- Whether box i and slot j, of pair p, are in each other, and one of them was clipped.
local function areCaught(b, p, i, j)
  local isClipped = b.kind[j] == DYNAMIC and (b.give[2 * i] == 0 or b.give[2 * j] == 0)
  local mayMeet = b.touches[p] > APART and b.touches[p] < ENTERED
  return isClipped and mayMeet and boxes.gap(b, b.to, i, j) < -EPSILON
end

-- Returns whether box i is in a slope, or squeezed and touches one, or in a body that was clipped;
-- if it has followed the ground, also whether it is in a wall (as behind a slope, under a ceiling).
local function isSqueezed(b, i)
  local k, to = 2 * i, b.to
  local isCaught, hasWalked = b.squeezed[k] ~= 0 or b.squeezed[k + 1] ~= 0, b.pieceLast[i] > 0
  for _, j, p in neighbours(b, i) do
    local isClose = (hasWalked or touch.haveFaces(b, i, j))
      and (isCaught and b.touches[p] > APART or boxes.gap(b, to, i, j) < -EPSILON)
    local isIn = isClose and (isCaught or face(b, i, j, to[k], to[k + 1], 1) < -EPSILON)
    if areCaught(b, p, i, j) or isIn and isWall(b, p, i, j) then
      return true
    end
  end
  return false
end

-- Clips the way of box i. Returns whether it could: a box that machines press is only put in
-- front of static objects, and keeps its speed.
local function clipOne(b, i)
  for n = ALL, FIXED do
    counting = n
    local x, y = findPlace(b, i)
    counting = ALL
    if x and n < FIXED then
      put(b, i, x, y)
      return true
    elseif x then
      path.lead(b, i, x, y)
    end
  end
  return false
end

-- Clips the ways of all boxes, none of them buried, that are squeezed. Returns whether there were
-- any. (All are found before the first is clipped: the order of the awake bodies has no say.)
local function clipAll(b)
  local list, count, hasClipped = b.clipWork.list, 0, false
  for n = 1, b.awakeCount do
    local i = b.awakeList[n]
    local isMovable = b.kind[i] == DYNAMIC and shapes.isBox[b.shape[i]] and not b.buried[i]
    if isMovable and isSqueezed(b, i) then
      count = count + 1
      list[count] = i
    end
  end
  for axis = 0, count > 0 and 1 or -1 do
    findRoom(b, axis)
  end
  for n = 1, count do
    hasClipped = clipOne(b, list[n]) or hasClipped
  end
  return hasClipped
end

--- Clips the ways of all boxes that end in a slope, or that a slope squeezes, and settles the
--- bodies that lean on them. Returns whether there were any.
function clip.run(b, dt)
  if not clipAll(b) then
    return false
  end
  settle.axis(b, b.contacts[0], dt, true)
  settle.axis(b, b.contacts[1], dt, true)
  walk.run(b, dt, false)
  rounds.findChanged(b)
  return true
end

return clip
