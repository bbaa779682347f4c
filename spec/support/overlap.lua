--- How deep the objects of a scene stand in each other.

local overlap = {}

--- Depth of the overlap of two boxes, px; negative: they are apart.
function overlap.depth(a, b)
  local x = math.min(a.x + a.width, b.x + b.width) - math.max(a.x, b.x)
  local y = math.min(a.y + a.height, b.y + b.height) - math.max(a.y, b.y)
  return math.min(x, y)
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
