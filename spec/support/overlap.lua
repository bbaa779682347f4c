--- How deep the objects of a scene stand in each other.

local overlap = {}

local max, min, sqrt = math.max, math.min, math.sqrt

-- Px by which a circle overlaps a box.
local function roundDepth(circle, box)
  local r = circle.radius
  local x, y = circle.x + r, circle.y + r
  local nearX, nearY = max(box.x, min(x, box.x + box.width)), max(box.y, min(y, box.y + box.height))
  local dx, dy = x - nearX, y - nearY
  if dx == 0 and dy == 0 then
    return r + min(x - box.x, box.x + box.width - x, y - box.y, box.y + box.height - y)
  end
  return r - sqrt(dx * dx + dy * dy)
end

-- Px by which two circles overlap.
local function ballsDepth(a, b)
  local dx, dy = a.x + a.radius - b.x - b.radius, a.y + a.radius - b.y - b.radius
  return a.radius + b.radius - sqrt(dx * dx + dy * dy)
end

-- Px between a point and a line from (ax, ay) to (bx, by).
local function lineDistance(x, y, ax, ay, bx, by)
  local dx, dy = bx - ax, by - ay
  local share = max(0, min(1, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)))
  local nearX, nearY = x - ax - share * dx, y - ay - share * dy
  return sqrt(nearX * nearX + nearY * nearY)
end

-- Px by which something overlaps a slope; a box by its way out along an axis.
local function slopeDepth(object, slope)
  local left, right = slope.x, slope.x + slope.width
  local isRight = slope.slope == "right" or slope.slope == "topright"
  local leftY, rightY = slope.y, slope.y + slope.height
  local top = object.y
  if slope.slope == "topleft" or slope.slope == "topright" then -- seen in a mirror
    top = leftY + rightY - object.y - object.height
  end
  if isRight then
    leftY, rightY = rightY, leftY
  end
  local function lineAt(x)
    return leftY + (rightY - leftY) * (x - left) / slope.width
  end
  if object.radius then
    local x, y = object.x + object.radius, top + object.radius
    local isBelow = x > left and x < right and y > lineAt(x)
    local far = lineDistance(x, y, left, leftY, right, rightY)
    return object.radius + (isBelow and far or -far)
  end
  local corner = isRight and min(object.x + object.width, right) or max(object.x, left)
  return (top + object.height - lineAt(corner)) * min(1, slope.width / slope.height)
end

--- Depth of the overlap of two boxes or circles, or one of them and a slope, px; negative: they
--- are apart.
function overlap.depth(a, b)
  local x = min(a.x + a.width, b.x + b.width) - max(a.x, b.x)
  local y = min(a.y + a.height, b.y + b.height) - max(a.y, b.y)
  local depth = min(x, y)
  if depth <= 0 then
    return depth
  elseif a.slope or b.slope then
    return min(depth, a.slope and slopeDepth(b, a) or slopeDepth(a, b))
  elseif a.radius and b.radius then
    return ballsDepth(a, b)
  elseif a.radius then
    return min(depth, roundDepth(a, b))
  elseif b.radius then
    return min(depth, roundDepth(b, a))
  end
  return depth
end

local function isSolid(object)
  return object.active ~= false and not object.sensor and not object.oneWay
end

local function isFixed(object)
  return object.static or object.kinematic
end

--- The solid objects among `objects`, from left to right.
--- An insertion sort of a list kept from the last call: hardly anything moved since.
local function fromLeft(objects, list)
  if #list ~= #objects then
    for i = 1, #objects do
      list[i] = objects[i]
    end
    for i = #list, #objects + 1, -1 do
      list[i] = nil
    end
    table.sort(list, function(a, b)
      return a.x < b.x
    end)
  end
  for i = 2, #list do
    local object, x, j = list[i], list[i].x, i - 1
    while j >= 1 and list[j].x > x do
      list[j + 1] = list[j]
      j = j - 1
    end
    list[j + 1] = object
  end
  return list
end

--- Makes a function that finds the largest overlap of any two of a list of objects, at least one of
--- them dynamic. Sensors, one-ways and inactive objects do not count; masks are not looked at.
---@param objects table[]
---@param least number? px, default 0: pairs that overlap by more than this are counted
---@return fun(): number, table?, table?, integer largest overlap in px (0: none), the two objects,
---and how many pairs overlap
function overlap.checker(objects, least)
  local list = {}
  least = least or 0
  return function()
    fromLeft(objects, list)
    local deepest, first, second, count = 0, nil, nil, 0
    for i = 1, #list do
      local a = list[i]
      local right = a.x + a.width
      local j = i + 1
      while isSolid(a) and list[j] and list[j].x < right do
        local b = list[j]
        if isSolid(b) and not (isFixed(a) and isFixed(b)) then
          local depth = overlap.depth(a, b)
          if depth > deepest then
            deepest, first, second = depth, a, b
          end
          if depth > least then
            count = count + 1
          end
        end
        j = j + 1
      end
    end
    return deepest, first, second, count
  end
end

--- Fails unless all objects of a run (spec/support/scene.lua) are apart, flush or with a gap; two
--- that overlap by less than `most` px, default 0.01, are.
function overlap.expectApart(run, most)
  local deepest, a, b = overlap.checker(run.all)()
  if deepest > (most or 0.01) then
    local text = "two overlap by %.9g px, at %.9g, %.9g and %.9g, %.9g"
    run:check(false, text, deepest, a.x, a.y, b.x, b.y)
  end
end

return overlap
