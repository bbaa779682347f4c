--- Makes boxes of a shape of the editor: a rectangle, also a turned one, or a polygon with only
--- level and upright edges.

local root = (...):match("^(.*)%.maps%.")
local check = require(root .. ".world.check")

local shapes = {}

local abs, floor = math.abs, math.floor

-- px. Closer corners have the same coordinate: drawing by hand and sines are not more exact.
local SAME = 0.01
-- Degrees. A rotation this close to a quarter turn counts as one.
local SAME_ANGLE = 0.001

--- Returns the number of quarter turns, 0..3, clockwise; nil: it is turned by another angle.
---@param rotation number? degrees
---@return integer?
function shapes.quarters(rotation)
  local turns = (rotation or 0) / 90
  local whole = floor(turns + 0.5)
  if abs(turns - whole) * 90 > SAME_ANGLE then
    return nil
  end
  return whole - 4 * floor(whole / 4)
end

--- Turns a point around the origin by quarters, clockwise as the editor shows it.
---@param x number px
---@param y number px
---@param quarters integer
---@return number x px
---@return number y px
function shapes.turn(x, y, quarters)
  if quarters == 1 then
    return -y, x
  elseif quarters == 2 then
    return -x, -y
  elseif quarters == 3 then
    return y, -x
  end
  return x, y
end

--- Turns a box around a point.
---@param box table x, y, width, height
---@param x number px
---@param y number px
---@param quarters integer
---@return table box a new one
function shapes.turnBox(box, x, y, quarters)
  local x1, y1 = shapes.turn(box.x - x, box.y - y, quarters)
  local x2, y2 = shapes.turn(box.x + box.width - x, box.y + box.height - y, quarters)
  local isUpright = quarters % 2 == 1
  return {
    x = x + math.min(x1, x2),
    y = y + math.min(y1, y2),
    width = isUpright and box.height or box.width,
    height = isUpright and box.width or box.height,
  }
end

-- Polygons ----------------------------------------------------------------------------------------

-- Makes coordinates that are nearly equal equal; returns the different ones, ascending.
local function snap(points, axis)
  local sorted = {}
  for i = 1, #points do
    sorted[i] = points[i][axis]
  end
  table.sort(sorted)
  local list = {}
  for i = 1, #sorted do
    if i == 1 or sorted[i] - list[#list] > SAME then
      list[#list + 1] = sorted[i]
    end
  end
  for i = 1, #points do
    local n = #list
    while list[n] > points[i][axis] do
      n = n - 1
    end
    points[i][axis] = list[n]
  end
  return list
end

local function isSame(a, b)
  return a.x == b.x and a.y == b.y
end

-- Returns the corners, each once.
local function distinct(points)
  local kept = {}
  for i = 1, #points do
    local isLast = i == #points and #kept > 0 and isSame(points[i], kept[1])
    if not isLast and (#kept == 0 or not isSame(points[i], kept[#kept])) then
      kept[#kept + 1] = points[i]
    end
  end
  return kept
end

-- Returns the corners without those in the middle of a level or upright edge.
local function corners(points)
  local kept = {}
  for i = 1, #points do
    local before, point = points[(i - 2) % #points + 1], points[i]
    local after = points[i % #points + 1]
    local isOn = (before.x == point.x and point.x == after.x)
      or (before.y == point.y and point.y == after.y)
    if not isOn then
      kept[#kept + 1] = point
    end
  end
  return kept
end

local function isLevel(points)
  for i = 1, #points do
    local point, after = points[i], points[i % #points + 1]
    if point.x ~= after.x and point.y ~= after.y then
      return false
    end
  end
  return true
end

-- Returns where upright edges cross the height y, ascending.
local function crossings(points, y)
  local xs = {}
  for i = 1, #points do
    local point, after = points[i], points[i % #points + 1]
    if point.x == after.x and (point.y < y) ~= (after.y < y) then
      xs[#xs + 1] = point.x
    end
  end
  table.sort(xs)
  return xs
end

-- Adds a box. It is joined to a box of the same width that ends where it begins.
local function addBox(boxes, x, y, width, height)
  for i = 1, #boxes do
    local box = boxes[i]
    if box.x == x and box.width == width and box.y + box.height == y then
      box.height = box.height + height
      return
    end
  end
  boxes[#boxes + 1] = { x = x, y = y, width = width, height = height }
end

-- Cuts a polygon along every height at which there is a corner.
local function decompose(points, ys)
  local boxes = {}
  for i = 1, #ys - 1 do
    local xs = crossings(points, (ys[i] + ys[i + 1]) / 2)
    for n = 1, #xs - 1, 2 do
      if xs[n + 1] > xs[n] then
        addBox(boxes, xs[n], ys[i], xs[n + 1] - xs[n], ys[i + 1] - ys[i])
      end
    end
  end
  return boxes
end

local function isRightTriangle(points)
  if #points ~= 3 then
    return false
  end
  for i = 1, 3 do
    local a, b, c = points[i], points[i % 3 + 1], points[(i + 1) % 3 + 1]
    if (a.x == b.x and b.y == c.y) or (a.y == b.y and b.x == c.x) then
      return true
    end
  end
  return false
end

--- Returns the boxes of a polygon, from top to bottom.
---@param points table[] { x =, y = }, px; they are changed
---@return table[]? boxes nil: it consists of none
---@return string? reason why not
function shapes.polygon(points)
  snap(points, "x")
  local ys = snap(points, "y")
  points = corners(distinct(points))
  if #points < 3 then
    return nil, "polygon: it has no area"
  elseif isRightTriangle(points) then
    return nil, "polygon: a right triangle would be a slope, and slopes are not supported"
  elseif not isLevel(points) then
    return nil, "polygon: only those with level and upright edges are boxes"
  end
  local boxes = decompose(points, ys)
  if #boxes == 0 then
    return nil, "polygon: it has no area"
  end
  return boxes
end

-- Objects -----------------------------------------------------------------------------------------

local function rotated(object)
  return ("rotated by %.14g degrees: boxes do not turn"):format(object.rotation)
end

--- Returns the corners of a polygon or a polyline, as new tables. Errors: there is no list of
--- points.
---@param object table
---@param name "polygon"|"polyline"
---@param place string how an error names the object
---@param sti table? { x =, y = }: STI has turned and moved the corners by that, and by the object
---@return table[]? points px, in the layer; nil: it is turned by no quarter
---@return string? reason
function shapes.points(object, name, place, sti)
  local quarters = sti and 0 or shapes.quarters(object.rotation)
  if not quarters then
    return nil, rotated(object)
  end
  local given, points = object[name], {}
  check.table(given, name, place)
  for i, point in ipairs(given) do
    local what = ("%s[%d]"):format(name, i)
    check.table(point, what, place)
    check.number(point.x, what .. ".x", place)
    check.number(point.y, what .. ".y", place)
    if sti then
      points[i] = { x = point.x - sti.x, y = point.y - sti.y }
    else
      local x, y = shapes.turn(point.x, point.y, quarters)
      points[i] = { x = object.x + x, y = object.y + y }
    end
  end
  return points
end

--- Returns the boxes of a rectangle or polygon. Errors: a polygon without a list of points.
---@param object table as Tiled exports it, in a layer or in a tile
---@param place string how an error names it
---@param sti table? see `points`
---@return table[]? boxes in the layer; nil: it consists of none
---@return string? reason why not
function shapes.boxes(object, place, sti)
  local kind = object.shape or "rectangle"
  if kind == "polygon" then
    local points, reason = shapes.points(object, kind, place, sti)
    if not points then
      return nil, reason
    end
    return shapes.polygon(points)
  elseif kind ~= "rectangle" then
    return nil, kind .. ": only rectangles are boxes"
  end
  local quarters = shapes.quarters(object.rotation)
  if not quarters then
    return nil, rotated(object)
  elseif object.width == 0 or object.height == 0 then
    return nil, "it has no size"
  end
  return { shapes.turnBox(object, object.x, object.y, quarters) }
end

return shapes
