-- Hilly ground from a list of pieces, each with a shape, a width, and how much higher its end is,
-- in px: { "hill", 320, 120 }. A curve is a row of short slopes: that cannot be felt.

local terrain = {}

local PIECE, STAIR = 20, 14 -- px: the length of the slopes of a curve, the height of a stair

-- How a curve rises, from 0 to 1.
local CURVES = {
  hill = function(way)
    return way * way * (3 - 2 * way)
  end,
  dip = function(way) -- level at its end
    return way * (2 - way)
  end,
  climb = function(way) -- level at its beginning
    return way * way
  end,
}

-- The points at the ends of all slopes of a piece that begins at x, y.
local function pointsOf(piece, x, y)
  local kind, width, rise = piece[1], piece[2], piece[3] or 0
  local curve, points = CURVES[kind], {}
  if kind == "stairs" then
    local count = math.abs(rise) / STAIR
    for i = 1, count do
      points[2 * i - 1] = { x + width * (i - 1) / count, y - rise * i / count }
      points[2 * i] = { x + width * i / count, y - rise * i / count }
    end
    return points
  end
  local count = curve and width / PIECE or 1 -- "flat", "slope" and "cliff" are straight
  for i = 1, count do
    local way = i / count
    points[i] = { x + width * way, y - rise * (curve and curve(way) or way) }
  end
  return points
end

--- Follows pieces from x, y on, and calls `add(x1, y1, x2, y2)` for each straight part that is
--- wider than 0. After a piece it calls `put[name](value, x1, y1, x2, y2)` with its ends for each
--- of its fields `name = value`, in the order of the list `names`. Returns the line of all points,
--- { x, y, piece }.
function terrain.follow(pieces, x, y, add, names, put)
  local line = { { x, y, pieces[1] } }
  for _, piece in ipairs(pieces) do
    local fromX, fromY = x, y
    for _, point in ipairs(pointsOf(piece, x, y)) do
      if point[1] > x then
        add(x, y, point[1], point[2])
      end
      x, y, point[3] = point[1], point[2], piece
      line[#line + 1] = point
    end
    for _, name in ipairs(names or {}) do
      if piece[name] then
        put[name](piece[name], fromX, fromY, x, y)
      end
    end
  end
  return line
end

--- Adds what is between two points of the surface and `deep`, px: a slope as high as it rises, on a
--- box.
function terrain.addGround(world, x1, y1, x2, y2, deep)
  local top, bottom = math.min(y1, y2), math.max(y1, y2)
  local box = { x = x1, y = bottom, width = x2 - x1, height = deep - bottom, static = true }
  world:add("ground", box)
  if y1 ~= y2 then
    local slope = { x = x1, y = top, width = x2 - x1, height = bottom - top, static = true }
    slope.slope = y1 > y2 and "right" or "left" -- the side that is high
    world:add("ground", slope)
  end
end

--- Likewise for a ceiling, up to `high`.
function terrain.addCeiling(world, x1, y1, x2, y2, high)
  local top, bottom = math.min(y1, y2), math.max(y1, y2)
  local box = { x = x1, y = high, width = x2 - x1, height = top - high, static = true }
  world:add("ground", box)
  if y1 ~= y2 then
    local slope = { x = x1, y = top, width = x2 - x1, height = bottom - top, static = true }
    slope.slope = y1 > y2 and "topleft" or "topright"
    world:add("ground", slope)
  end
end

--- Returns the y of a line at x, and the piece that is there.
function terrain.heightAt(line, x)
  for i = 2, #line do
    local before, after = line[i - 1], line[i]
    if after[1] >= x and after[1] > before[1] then
      local way = (x - before[1]) / (after[1] - before[1])
      return before[2] + (after[2] - before[2]) * way, after[3]
    end
  end
  return line[#line][2], line[#line][3]
end

return terrain
