--- A number over many numbers, equal on every Lua: two runs with the same fold went the same way.
--- Whole parts and two 32-bit pieces of the fraction are folded one by one modulo 2^31 - 1, in
--- doubles that stay below 2^53, so nothing is rounded.

local floor = math.floor

local MODULUS = 2147483647.0
local FACTOR = 16807.0
local PIECE = 4294967296.0

local function rest(value)
  return value - floor(value / MODULUS) * MODULUS
end

local function mix(fold, piece)
  return rest(fold * FACTOR + rest(piece))
end

local fold = {}

fold.START = 1.0

--- Adds one finite number, |value| < 2^52, to a fold.
function fold.number(sum, value)
  local whole = floor(value)
  local high = (value - whole) * PIECE
  local low = (high - floor(high)) * PIECE
  return mix(mix(mix(sum, whole), floor(high)), floor(low))
end

--- Adds positions and velocities of a list of objects to a fold.
function fold.objects(sum, objects)
  for i = 1, #objects do
    local object = objects[i]
    sum = fold.number(fold.number(sum, object.x), object.y)
    sum = fold.number(fold.number(sum, object.vx or 0), object.vy or 0)
  end
  return sum
end

return fold
