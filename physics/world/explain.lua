--- Explains in one sentence why two objects do or do not collide.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local aabb = require(root .. ".memory.aabb")
local check = require(root .. ".world.check")
local circle = require(root .. ".memory.circle")
local columns = require(root .. ".memory.columns")
local filter = require(root .. ".broadphase.filter")
local registry = require(root .. ".objects.registry")
local slope = require(root .. ".memory.lazy")(root .. ".solver.slope")
local triangle = require(root .. ".memory.triangle")
local view = require(root .. ".queries.index")

local explain = {}

local EPSILON = columns.EPSILON
local STATIC, CIRCLE = columns.STATIC, columns.SHAPE_CIRCLE
local format, max = string.format, math.max

local nameOf = registry.placeOf

-- Returns which mask lets two objects pass through each other, in words, or nil.
local function explainMask(v, i, j)
  local refusal = filter.refusal(v, i, j)
  if refusal == "mask" then
    return format("the mask of %s refuses the group %s", nameOf(v, i), check.show(v.groupName[j]))
  elseif refusal == "hits" then
    return format("%s does not hit the group %s", nameOf(v, i), check.show(v.groupName[j]))
  elseif refusal == "masks" then
    local one, other = check.show(v.groupName[i]), check.show(v.groupName[j])
    return format("the world's masks let %s pass through %s", one, other)
  end
end

local function explainSoft(v, i, j)
  if filter.isSoft(v, i, j) then
    local one, other = check.show(v.groupName[i]), check.show(v.groupName[j])
    return format("%s and %s are soft to each other, and drift apart", one, other)
  end
end

local function kindName(v, i)
  return v.kind[i] == STATIC and "static" or "kinematic"
end

-- Returns why two objects never collide, wherever they are, or nil.
local function explainFilter(v, i, j)
  for _, slot in ipairs({ i, j }) do
    if not v.active[slot] then
      return nameOf(v, slot) .. " is not active"
    end
  end
  if filter.reason(v, i, j) == "immovable" then
    local one, other = kindName(v, i), kindName(v, j)
    if one == other then
      return format("both are %s, which never bump each other", one)
    end
    return format("one is %s and the other %s, which never bump each other", one, other)
  end
  return explainMask(v, i, j) or explainMask(v, j, i) or explainSoft(v, i, j)
end

-- Returns the gaps on both axes, negative where they overlap.
local function gapsOf(v, i, j)
  local p, s, k, m = v.position, v.size, 2 * i, 2 * j
  local width, height = aabb.overlap(p[k], p[k + 1], s[k], s[k + 1], p[m], p[m + 1], s[m], s[m + 1])
  return -width, -height
end

local function show(px)
  return check.show(math.floor(px * 1000 + 0.5) / 1000)
end

-- Returns the side of slot i that is nearest to slot j, of which one is a slope, and px to that;
-- the side is nil if they meet at a corner only.
local function slopeSide(v, i, j)
  local box, its, core = i, j, v.bodies
  if v.shape[j] < triangle.FIRST then
    box, its = j, i
  end
  local slot = core.slotOf[v.object[box]]
  local axis = slot and slope.axisOf(core, slot) or core.downAxis
  local p, s, k, m = v.position, v.size, 2 * box, 2 * its
  local x, y = p[k] - p[m], p[k + 1] - p[m + 1]
  local face, gap = triangle.nearest(v.shape[its], axis, x, y, s[k], s[k + 1], s[m], s[m + 1])
  local gapX, gapY = gapsOf(v, i, j)
  local q = face == triangle.EDGE and axis or face % 2
  local isCorner = gap >= -EPSILON and (q == 0 and gapY or gapX) >= -EPSILON
  local isLow = triangle.isLow(face, v.shape[its], axis) == (box == i)
  return not isCorner and columns.SIDES[2 * q + (isLow and 2 or 1)] or nil, gap
end

local function isSlope(v, i, j)
  return (v.shape[i] >= triangle.FIRST) ~= (v.shape[j] >= triangle.FIRST)
end

-- Returns how far two are apart, < 0: by how much they overlap, and the normal from j to i, if one
-- of them is a circle.
local function roundGap(v, i, j)
  if max(v.shape[i], v.shape[j]) ~= CIRCLE then
    return nil
  end
  local p, s, k, m = v.position, v.size, 2 * i, 2 * j
  local isRound, isOtherRound = v.shape[i] == CIRCLE, v.shape[j] == CIRCLE
  local x, y, w, h = p[k], p[k + 1], s[k], s[k + 1]
  return circle.gap(x, y, w, h, isRound, p[m], p[m + 1], s[m], s[m + 1], isOtherRound)
end

-- Returns the side of slot i at which slot j is flush, or nil.
local function flushSide(v, i, j)
  if isSlope(v, i, j) then
    local side, gap = slopeSide(v, i, j)
    return gap >= -EPSILON and gap <= EPSILON and side or nil
  end
  local gap, nx, ny = roundGap(v, i, j)
  if gap then
    local isFlush = gap <= EPSILON and gap >= -EPSILON
    local side = nx * nx > ny * ny and (nx > 0 and "left" or "right")
      or ny > 0 and "top"
      or "bottom"
    return isFlush and side or nil
  end
  local gapX, gapY = gapsOf(v, i, j)
  local p, k, m = v.position, 2 * i, 2 * j
  if gapX > EPSILON or gapY > EPSILON then
    return nil
  elseif gapX >= -EPSILON then
    return gapY < -EPSILON and (p[k] < p[m] and "right" or "left") or nil
  elseif gapY >= -EPSILON then
    return p[k + 1] < p[m + 1] and "bottom" or "top"
  end
end

-- Returns the side of slot i that is nearest to the opposite side of slot j, or nil if they do not
-- overlap.
local function deepSide(v, i, j)
  if isSlope(v, i, j) then
    local side, gap = slopeSide(v, i, j)
    return gap < -EPSILON and side or nil
  end
  local gapX, gapY = gapsOf(v, i, j)
  if gapX >= -EPSILON or gapY >= -EPSILON then
    return nil
  end
  local gap = roundGap(v, i, j)
  if gap and gap >= -EPSILON then
    return nil
  end
  local p, s, k, m = v.position, v.size, 2 * i, 2 * j
  return aabb.side(p[k], p[k + 1], s[k], s[k + 1], p[m], p[m + 1], s[m], s[m + 1])
end

local function explainPlace(v, i, j)
  local gapX, gapY = gapsOf(v, i, j)
  local side, gap = flushSide(v, i, j), roundGap(v, i, j)
  if gap and gap > EPSILON then
    return format("they are %s px apart", show(gap))
  elseif gap and gap < -EPSILON then
    return format("they overlap by %s px", show(-gap))
  elseif side then
    return format("they are flush at the %s of %s", side, nameOf(v, i))
  elseif isSlope(v, i, j) and max(gapX, gapY) < -EPSILON then
    local _, off = slopeSide(v, i, j)
    if off > EPSILON then
      return format("they are %s px apart at the sloped edge", show(off))
    end
    return off < -EPSILON and format("they overlap by %s px", show(-off))
      or "they are flush at a corner only"
  elseif gapX > EPSILON and gapY > EPSILON then
    return format("they are %s px apart on x and %s px on y", show(gapX), show(gapY))
  elseif gapX > EPSILON then
    return format("they are %s px apart on x", show(gapX))
  elseif gapY > EPSILON then
    return format("they are %s px apart on y", show(gapY))
  elseif gapX >= -EPSILON or gapY >= -EPSILON then
    return "they are flush at a corner only"
  end
  return format("they overlap by %s x %s px", show(-gapX), show(-gapY))
end

-- Returns the conditions under which they collide, in words.
local function conditions(v, world, i, j)
  local list = {}
  for _, slot in ipairs({ i, j }) do
    local name = nameOf(v, slot)
    if v.sensor[slot] then
      list[#list + 1] = name .. " is a sensor: it reports contacts, but nothing bumps into it"
    end
    if v.shape[slot] >= triangle.FIRST then
      local side = columns.SLOPE_NAMES[v.shape[slot]]
      list[#list + 1] = format("%s is a slope, high at its %s", name, side)
    end
    if v.object[slot].area then
      list[#list + 1] = name .. " is a zone: its area acts on what is inside"
    end
    if v.oneWay[slot] then
      list[#list + 1] = format("%s is solid only at its %s", name, v.oneWay[slot])
    end
    if v.object[slot].canCollide then
      list[#list + 1] = format("canCollide of %s may refuse", name)
    end
  end
  if world.canCollide then
    list[#list + 1] = "canCollide of the world may refuse"
  end
  return list
end

local function explainSlots(v, world, i, j)
  view.lookAtFilter(v, i)
  view.lookAtFilter(v, j)
  local names = format("%s and %s ", nameOf(v, i), nameOf(v, j))
  local why = explainFilter(v, i, j)
  if why then
    return format("%snever collide: %s.", names, why)
  end
  local list = conditions(v, world, i, j)
  list[#list + 1] = "now " .. explainPlace(v, i, j)
  return format("%scan collide: %s.", names, table.concat(list, "; "))
end

--- Returns a sentence that says why two objects do or do not collide.
function explain.run(world, a, b)
  local v = view.of(world)
  local i, j = view.find(v, world, a), view.find(v, world, b)
  if rawequal(a, b) then
    return "a and b are the same object, which never collides with itself."
  elseif not i and not j then
    return "a and b never collide: neither is in the world."
  elseif not i or not j then
    return format("a and b never collide: %s is not in the world.", i and "b" or "a")
  end
  return explainSlots(v, world, i, j)
end

--- Returns the side of a at which it is in contact with b, or nil. The contacts are those that the
--- last step left, unless the game has moved the two apart since; with `sideBySide` flush objects
--- are in contact. If one of them is not in the world: nil, and "a" or "b".
function explain.touching(world, a, b)
  local v, core = view.of(world), world._bodies
  local i, j = view.find(v, world, a), view.find(v, world, b)
  if not i or not j then
    return nil, i and "b" or "a"
  end
  view.lookAtFilter(v, i)
  view.lookAtFilter(v, j)
  if rawequal(a, b) or filter.reason(v, i, j) then
    return nil
  end
  local flush = flushSide(v, i, j)
  if flush and world.sideBySide and not (v.sensor[i] or v.sensor[j]) then
    return flush
  end
  local deep = deepSide(v, i, j)
  local slotA, slotB = core.slotOf[a], core.slotOf[b]
  local p = (flush or deep) and slotA and slotB and columns.pairOf(core, slotA, slotB)
  local contact = p and core.contact[p] or 0
  if contact == 0 then
    return nil
  end
  local side = columns.SIDES[core.pairA[p] == slotA and contact or columns.OPPOSITE[contact]]
  return (deep or flush == side) and side or nil
end

return explain
