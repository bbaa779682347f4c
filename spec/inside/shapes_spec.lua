--- The geometry of boxes, circles and slopes, against sampling: what `space/shapes` and
--- `space/lines` say of all pairs.

local files = require("spec.support.files")
local newRandom = require("spec.support.random").new
local small = require("spec.support.small")
local shapes = require("physics.space.shapes")

local NAMES = { [0] = "box", "circle", "left", "right", "topleft", "topright" }

-- Points of the outline of a shape; those of a circle are its corners moved inward.
local function outline(shape, x, y, w, h)
  local points, solidX, solidY = {}, shapes.SOLID[0][shape], shapes.SOLID[1][shape]
  for _, corner in ipairs({ { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } }) do
    local isOpen = solidX ~= 0 and corner[1] == -solidX and corner[2] == -solidY
    if not isOpen then
      points[#points + 1] = { x + (corner[1] + 1) * w / 2, y + (corner[2] + 1) * h / 2 }
    end
  end
  return points
end

-- How far p is from the line between a and b, and whether it is on the right hand of that.
local function fromLine(p, a, b)
  local dx, dy, x, y = b[1] - a[1], b[2] - a[2], p[1] - a[1], p[2] - a[2]
  local share = math.max(0, math.min(1, (x * dx + y * dy) / (dx * dx + dy * dy)))
  local offX, offY = x - dx * share, y - dy * share
  return math.sqrt(offX * offX + offY * offY), dx * y - dy * x >= 0
end

-- How far p is from a polygon, below 0: inside.
local function fromPolygon(p, points)
  local nearest, isInside = math.huge, true
  for n = 1, #points do
    local far, isRight = fromLine(p, points[n], points[n % #points + 1])
    nearest, isInside = math.min(nearest, far), isInside and isRight
  end
  return isInside and -nearest or nearest
end

-- Whether the line from a to b crosses that from c to d.
local function cross(a, b, c, d)
  local function turn(p, q, r)
    return (q[1] - p[1]) * (r[2] - p[2]) - (q[2] - p[2]) * (r[1] - p[1])
  end
  return turn(a, b, c) * turn(a, b, d) < 0 and turn(c, d, a) * turn(c, d, b) < 0
end

-- How far two shapes are apart, by their outlines; of polygons that overlap: at most 0.
local function trueGap(a, x, y, w, h, b, ox, oy, ow, oh)
  if a == shapes.CIRCLE and b == shapes.CIRCLE then
    local dx, dy = x + w / 2 - ox - ow / 2, y + h / 2 - oy - oh / 2
    return math.sqrt(dx * dx + dy * dy) - w / 2 - ow / 2
  elseif a == shapes.CIRCLE then
    return fromPolygon({ x + w / 2, y + h / 2 }, outline(b, ox, oy, ow, oh)) - w / 2
  elseif b == shapes.CIRCLE then
    return trueGap(b, ox, oy, ow, oh, a, x, y, w, h)
  end
  local one, other, least = outline(a, x, y, w, h), outline(b, ox, oy, ow, oh), math.huge
  for n = 1, math.max(#one, #other) do
    least = math.min(least, one[n] and fromPolygon(one[n], other) or least)
    least = math.min(least, other[n] and fromPolygon(other[n], one) or least)
    for m = 1, one[n] and #other or 0 do
      local isCross = cross(one[n], one[n % #one + 1], other[m], other[m % #other + 1])
      least = isCross and 0 or least
    end
  end
  return least
end

-- Whether the two overlap by more than 1e-3 px before `share` of the way (sampled).
local function overlapsBefore(share, a, x, y, w, h, b, ox, oy, ow, oh, dx, dy)
  for n = 0, 200 do
    local at = n / 200
    if at < share - 1e-6 then
      if shapes.gap(a, x + dx * at, y + dy * at, w, h, b, ox, oy, ow, oh) < -1e-3 then
        return true
      end
    end
  end
  return false
end

describe("shapes.gap and shapes.meet", function()
  for a = 0, 5 do
    it("are those of the outlines: a " .. NAMES[a] .. " and each shape", function()
      local random = newRandom(a + 1)
      for n = 1, 1200 do
        local b = n % 6
        local x, y, w, h = random:between(0, 40), random:between(0, 40), 3, 3
        w, h = w + random:between(0, 40), h + random:between(0, 40)
        local ox, oy, ow, oh = random:between(0, 40), random:between(0, 40), 3, 3
        ow, oh = ow + random:between(0, 40), oh + random:between(0, 40)
        h, oh = a == 1 and w or h, b == 1 and ow or oh
        local gap, nx, ny = shapes.gap(a, x, y, w, h, b, ox, oy, ow, oh)
        local back = shapes.gap(b, ox, oy, ow, oh, a, x, y, w, h)
        local true_ = trueGap(a, x, y, w, h, b, ox, oy, ow, oh)
        local isExact = a == 1 or b == 1 or (true_ > 0 and (a < 2 or b < 2))
        assert.near(gap, back, 1e-9)
        assert.near(1, nx * nx + ny * ny, 1e-12)
        if isExact then
          assert.near(true_, gap, 1e-9, NAMES[b])
        else -- (two slopes that are apart: along a face, so at corners less than the distance)
          assert.is_true(gap <= math.max(true_, 0) + 1e-9, NAMES[b])
          assert.is_true(true_ > 1e-9 or gap <= 1e-9, NAMES[b])
        end
        local dx, dy = random:between(-20, 20), random:between(-20, 20)
        shapes.setPair(a, x, y, w, h, b, ox, oy, ow, oh)
        local share = shapes.meet(dx, dy, n % 2, 0, 0)
        if gap > 1e-6 then
          local past = share or 2
          assert.is_false(overlapsBefore(past, a, x, y, w, h, b, ox, oy, ow, oh, dx, dy), NAMES[b])
          if share then
            local left = shapes.gap(a, x + dx * share, y + dy * share, w, h, b, ox, oy, ow, oh)
            assert.near(0, left, 1e-6, NAMES[b])
          end
        end
      end
    end)
  end
end)

describe("shapes.meet", function()
  -- Of 8 px; the first is 10 px further right than where the second begins, which is at 8.
  local WAYS = { { 0, 1 }, { 10, -1 } }
  small.rows("leaves by the nearest side, or where it came in {1} px ago", WAYS, function(way, side)
    shapes.setPair(0, 10, 0, 8, 8, 0, 8, 0, 8, 8)
    local share, nx, ny, _, isDeep = shapes.meet(1, 0, 1, way, 0)
    assert.same({ 0, side, 0, true }, { share, nx, ny, isDeep })
  end)
end)

-- A shape is a row of `space/shapes`, not a branch in each file. (How many files name slopes and
-- circles: scripts/field_files.lua.)
it("shapes.ROWS: no file outside of space compares the number of a shape #files", function()
  for _, path in ipairs(files.list("find physics -name '*.lua' ! -path '*/space/*'")) do
    local code = files.read(path):gsub("%-%-[^\n]*", "")
    for _, word in ipairs({ "shape%[[^%]]*%] *[=~<>]=", "[=~<>]= *shapes%.", "[=~<>]= *BOX" }) do
      assert.is_nil(code:match(word), path)
    end
  end
end)
