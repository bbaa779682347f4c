--- The pure functions of the tutorial, with checked arguments: no world, no state, no time.
--- They know rectangles only; masks, sensors and one-way sides belong to a step.
--- Source: "Making a Simple 2D Physics Engine", part 1.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local aabb = require(root .. ".memory.aabb")
local check = require(root .. ".world.check")
local fields = require(root .. ".world.fields")

-- px. Rectangles that were put flush may overlap or miss each other by a rounding error, so two
-- that are at most this far from flush count as flush.
local FLUSH = 1e-6

local BOX = { "x", "y", "width", "height" }
local BUMPED = { "static", "kinematic", "pushable", "mass" }
local MODES = fields.settingByName.push.values

local isFinite = check.isFinite

local pure = {}

-- Checking ---------------------------------------------------------------------------------------

-- A fast test for a usable box; the slow check then writes the message.
local function checkBox(box, place)
  if type(box) == "table" then
    local x, y, width, height = box.x, box.y, box.width, box.height
    if isFinite(x) and isFinite(y) and isFinite(width) and isFinite(height) then
      if width > 0 and height > 0 then
        return
      end
    end
  end
  check.fields(box, place, BOX)
end

local function checkSideBySide(sideBySide, where)
  if sideBySide ~= nil then
    check.boolean(sideBySide, "sideBySide", where)
  end
end

-- Colliding --------------------------------------------------------------------------------------

-- The side of the first that is hit, or false.
local function collide(x1, y1, w1, h1, x2, y2, w2, h2, sideBySide)
  local width, height = aabb.overlap(x1, y1, w1, h1, x2, y2, w2, h2)
  local isHit ---@type boolean
  if sideBySide then
    isHit = width >= -FLUSH and height >= -FLUSH
  else
    isHit = width > FLUSH and height > FLUSH
  end
  return isHit and aabb.side(x1, y1, w1, h1, x2, y2, w2, h2)
end

local function collideBoxes(a, b, sideBySide)
  return collide(a.x, a.y, a.width, a.height, b.x, b.y, b.width, b.height, sideBySide)
end

local function checkCollisionOfNumbers(x1, y1, w1, h1, x2, y2, w2, h2, sideBySide)
  local where = "checkCollision(x1, y1, w1, h1, x2, y2, w2, h2)"
  check.number(x1, "x1", where)
  check.number(y1, "y1", where)
  check.positive(w1, "w1", where)
  check.positive(h1, "h1", where)
  check.number(x2, "x2", where)
  check.number(y2, "y2", where)
  check.positive(w2, "w2", where)
  check.positive(h2, "h2", where)
  checkSideBySide(sideBySide, where)
  return collide(x1, y1, w1, h1, x2, y2, w2, h2, sideBySide)
end

--- Tells whether the first rectangle lies inside the second. The left and top edges of the second
--- belong to it, its right and bottom edges do not.
---
--- Errors: a number is missing, NaN or infinite; a size of the first is < 0; a size of the second
--- is <= 0.
---@param x1 number px, left edge of the first
---@param y1 number px, its top edge
---@param w1 number px, >= 0, its width; with w1 and h1 0 it is a point
---@param h1 number px, >= 0, its height
---@param x2 number px, left edge of the second
---@param y2 number px, its top edge
---@param w2 number px, > 0, its width
---@param h2 number px, > 0, its height
---@return boolean isInside
function pure.inside(x1, y1, w1, h1, x2, y2, w2, h2)
  local where = "inside(x1, y1, w1, h1, x2, y2, w2, h2)"
  check.number(x1, "x1", where)
  check.number(y1, "y1", where)
  check.number(w1, "w1", where, 0)
  check.number(h1, "h1", where, 0)
  check.number(x2, "x2", where)
  check.number(y2, "y2", where)
  check.positive(w2, "w2", where)
  check.positive(h2, "h2", where)
  return aabb.inside(x1, y1, w1, h1, x2, y2, w2, h2)
end

--- Returns the side of `a` that is nearest to the opposite side of `b`, whether or not the two
--- overlap: `"right"` when the right side of `a` has the shortest way out of `b`, and so on. Equal
--- ways go to the bottom, then the top, then the left, then the right.
---
---     a +-------+           right, bottom: how far the right and the bottom side of a
---       |   +---|---+ b     have come into b; the smaller one names the side
---       |   |   |   | |
---       +---|---+   | | bottom
---           +-------+
---           --->|
---            right
---
--- Source: opposite sides difference, the third method of the tutorial.
---
--- Errors: `a` or `b` has no usable x, y, width, height.
---@param a physics.Box a rectangle: x, y, width, height in px
---@param b physics.Box the other one
---@return physics.Side side of `a`; that of `b` is the opposite one
function pure.side(a, b)
  checkBox(a, "side(a, b): a")
  checkBox(b, "side(a, b): b")
  return aabb.side(a.x, a.y, a.width, a.height, b.x, b.y, b.width, b.height)
end

--- Returns the side of `a` that `b` overlaps, or `false` if the two do not overlap. Flush
--- neighbours (at most 1e-6 px apart) overlap only with `sideBySide`. It also takes eight numbers,
--- as in the first version of the tutorial: `checkCollision(x1, y1, w1, h1, x2, y2, w2, h2[,
--- sideBySide])`.
--- Source: intersection rectangle, then opposite sides difference.
---
--- Errors: `a` or `b` has no usable x, y, width, height; `sideBySide` is not a boolean.
---@param a physics.Box a rectangle: x, y, width, height in px
---@param b physics.Box the other one
---@param sideBySide boolean? true: flush neighbours count; default: the setting of the default
---   world
---@return physics.Side|false side of `a`; that of `b` is the opposite one
---@overload fun(x1: number, y1: number, ...: number|boolean): physics.Side|false
function pure.checkCollision(a, b, sideBySide, ...)
  if type(a) == "number" then
    return checkCollisionOfNumbers(a, b, sideBySide, ...)
  end
  checkBox(a, "checkCollision(a, b): a")
  checkBox(b, "checkCollision(a, b): b")
  checkSideBySide(sideBySide, "checkCollision(a, b, sideBySide)")
  return collideBoxes(a, b, sideBySide)
end

-- Bumping ----------------------------------------------------------------------------------------

local function isImmovable(box)
  return box.static or box.kinematic
end

-- Whether a box gives way to another one. A box that is not pushable gives way only to a box of the
-- same kind and to one that never moves, such as a wall.
local function givesWay(box, other)
  if isImmovable(box) then
    return false
  end
  return box.pushable ~= false or other.pushable == false or isImmovable(other)
end

-- Returns the shares of the overlap by which `a` and `b` move: 0 and 0, or together 1.
local function shares(a, b, mode)
  local aGives, bGives = givesWay(a, b), givesWay(b, a)
  if aGives and bGives and mode == "both" then
    local massA, massB = a.mass or 1, b.mass or 1
    return 1 / (1 + massA / massB), 1 / (1 + massB / massA)
  elseif aGives then
    return 1, 0
  elseif bGives then
    return 0, 1
  end
  return 0, 0
end

-- Opens the overlap of two boxes along one axis.
--
--     low  +-------+            high moves its share to the right first; then the low one is
--          |   +---|---+ high   assigned the flush place, so that no rounding is left between
--          |   |<->|   |        them: low.x == high.x - low.width
--          +---|---+   |
--              +-------+
local function separate(low, high, lowShare, highShare, position, size)
  local overlap = low[position] + low[size] - high[position]
  if lowShare == 0 then
    high[position] = low[position] + low[size]
  else
    if highShare > 0 then
      high[position] = high[position] + overlap * highShare
    end
    low[position] = high[position] - low[size]
  end
end

local function part(a, b, side, mode)
  local shareA, shareB = shares(a, b, mode)
  if shareA == 0 and shareB == 0 then
    return
  elseif side == "right" then
    separate(a, b, shareA, shareB, "x", "width")
  elseif side == "left" then
    separate(b, a, shareB, shareA, "x", "width")
  elseif side == "bottom" then
    separate(a, b, shareA, shareB, "y", "height")
  else
    separate(b, a, shareB, shareA, "y", "height")
  end
end

--- Moves two overlapping objects apart, the shortest way, until they are flush. Returns the side of
--- `a` that was hit, or `false` if they do not overlap (then nothing moves). Velocities do not
--- change.
---
---     mode "both"    each gives way by half; with `mass`, the heavier one by less
---     mode "first"   only `a` gives way
---
--- Static and kinematic objects do not move, nor does an object with `pushable = false` that
--- overlaps a pushable one: the other object then moves the whole way. If neither can move, nothing
--- moves.
---
--- Errors: an object has no usable x, y, width, height; both are the same object; the mode is
--- unknown; they overlap, and static, kinematic, pushable or mass cannot be used.
---@param a physics.NewObject x, y, width, height in px, optional static, kinematic, pushable, mass
---@param b physics.NewObject the other one
---@param mode "both"|"first"|nil which of them moves, default "both"
---@return physics.Side|false side of `a`; that of `b` is the opposite one
function pure.bump(a, b, mode)
  checkBox(a, "bump(a, b): a")
  checkBox(b, "bump(a, b): b")
  if rawequal(a, b) then
    check.fail("bump(a, b): a and b must be two objects, got the same one twice")
  end
  if mode ~= nil then
    check.choice(mode, "mode", "bump(a, b, mode)", MODES)
  end
  local side = collideBoxes(a, b, false)
  if side then
    check.fields(a, "bump(a, b): a", BUMPED)
    check.fields(b, "bump(a, b): b", BUMPED)
    part(a, b, side, mode or "both")
  end
  return side
end

return pure
