--- A seeded generator of numbers that are the same on every Lua.
--- Source: Park & Miller, "minimal standard" (1988): state * 16807 mod (2^31 - 1). The product
--- stays below 2^46, so every step is exact in a double.

local floor = math.floor

local MODULUS = 2147483647.0
local FACTOR = 16807.0

local Random = {}
Random.__index = Random

--- Makes a generator.
---@param seed number integer in 1..2^31 - 2
local function new(seed)
  local self = setmetatable({ state = seed + 0.0 }, Random)
  for _ = 1, 4 do
    self:unit()
  end -- small seeds start with small numbers
  return self
end

--- Number in [0, 1).
function Random:unit()
  local product = self.state * FACTOR
  self.state = product - floor(product / MODULUS) * MODULUS
  return (self.state - 1) / (MODULUS - 1)
end

--- Number in [from, to).
function Random:between(from, to)
  return from + (to - from) * self:unit()
end

--- Integer in from..to, both included.
function Random:integer(from, to)
  return from + floor((to - from + 1) * self:unit())
end

--- true in `share` (0..1) of the calls.
function Random:chance(share)
  return self:unit() < share
end

--- One of the entries of a list.
function Random:pick(list)
  return list[self:integer(1, #list)]
end

--- A new list with the same entries in another order.
function Random:shuffled(list)
  local result = {}
  for i = 1, #list do
    result[i] = list[i]
  end
  for i = #result, 2, -1 do
    local j = self:integer(1, i)
    result[i], result[j] = result[j], result[i]
  end
  return result
end

return { new = new }
