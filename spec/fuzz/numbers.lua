--- Numbers for random games: the ones that are nice, the ones that are nasty, and all between.
--
-- A world has a unit (px): its sizes, places and speeds are multiples of it, most of them small. A
-- `raster` world takes whole multiples of an eighth, so that edges fall on edges again and again.

local newRandom = require("spec.support.random").new

local floor, max, min = math.floor, math.max, math.min

local Numbers = {}
Numbers.__index = Numbers

local SMALLEST, LARGEST = 0.01, 10000 -- px, of a size
local UNITS = { 0.25, 1, 8, 16, 16, 16, 16, 100, 1000 }
local RATES = { 1 / 60, 1 / 60, 1 / 60, 1 / 60, 1 / 30, 1 / 144, 1 / 240, 0.01, 0.05 }

--- Makes the numbers of one case.
---@param seed integer
local function new(seed)
  local self = setmetatable({ random = newRandom(seed) }, Numbers)
  self.unit = self.random:pick(UNITS)
  self.raster = self.random:chance(0.3) and self.unit / 8 or false
  self.rate = self.random:pick(RATES)
  self.steady = self.random:chance(0.6) -- nearly always the same dt
  return self
end

-- Whole multiples of the raster, where there is one.
function Numbers:snap(value)
  local raster = self.raster
  return raster and floor(value / raster + 0.5) * raster or value
end

-- 2^x for x between two numbers, without `exp`, which differs between machines.
local function power(random, low, high)
  local x = random:between(low, high)
  local whole = floor(x)
  local result = 1 + (x - whole)
  for _ = 1, whole do
    result = result * 2
  end
  for _ = whole, -1 do
    result = result / 2
  end
  return result
end

--- A number from `low` to `high`, > 0, all powers of ten alike.
function Numbers:spread(low, high)
  local value = low * power(self.random, 0, 20)
  while value > high do
    value = low * power(self.random, 0, 20)
  end
  return value
end

--- A width or height, px.
function Numbers:size()
  local random, unit = self.random, self.unit
  if random:chance(0.4) then
    return unit
  elseif random:chance(0.06) then
    return self:spread(SMALLEST, LARGEST)
  end
  local size = self:snap(random:between(0.3, 2.5) * unit)
  return min(LARGEST, max(SMALLEST, size > 0 and size or unit))
end

--- A coordinate between two multiples of the unit, px.
function Numbers:place(from, to)
  return self:snap(self.random:between(from, to) * self.unit)
end

--- A velocity along an axis, px/s.
function Numbers:speed()
  local random = self.random
  local kind = random:integer(1, 10)
  if kind == 1 then
    return 0
  elseif kind == 2 then
    return random:pick({ -1, 1 }) * self:spread(0.001, 20) * self.unit
  elseif kind == 3 then
    return random:between(-1000, 1000) * self.unit
  end
  return self:snap(random:between(-25, 25) * self.unit)
end

function Numbers:acceleration()
  return self:snap(self.random:between(-60, 60) * self.unit)
end

function Numbers:mass()
  return self.random:chance(0.2) and self:spread(0.01, 1000) or self.random:between(0.25, 8)
end

--- The length of an update, s.
function Numbers:dt()
  local random = self.random
  if self.steady and random:chance(0.95) then
    return self.rate
  end
  local kind = random:integer(1, 12)
  if kind == 1 then
    return 0
  elseif kind == 2 then
    return self:spread(1e-7, 1e-3)
  elseif kind == 3 then
    return random:between(0.02, 0.4)
  end
  return random:pick(RATES)
end

return { new = new }
