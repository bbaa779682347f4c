--- Computes a number from a state, the same on every Lua.
--
-- The bits of the doubles are folded by arithmetic that is exact in doubles. So neither the width
-- of integers nor the way in which numbers are written matters. Two remainders of 23 bits make one
-- number below 10^14, which every Lua writes with all its digits. Source: polynomial rolling hash,
-- R. M. Karp and M. O. Rabin (1987).

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local fieldColumns = require(root .. ".objects.fieldColumns")
local fields = require(root .. ".world.fields")
local keyOrder = require(root .. ".memory.keyOrder")
local format = require(root .. ".state.format")
local state = require(root .. ".state.save")

local hash = {}

local floor, max = math.floor, math.max

local PRIME_A, PRIME_B = 8388593.0, 8388587.0 -- the two largest below 2^23
local FACTOR_A, FACTOR_B = 131071.0, 99991.0 -- products with them stay below 2^41
local FRACTION = 4503599627370496.0 -- 2^52: makes the fraction of a number >= 1 whole
local BIG = 281474976710656.0 -- 2^48
local TRUE, FALSE, TEXT = 5000011, 5000027, 5000039

-- Folds a whole number below 2^52 into both remainders of `sum`.
local function mix(sum, piece)
  local a, b = sum.a * FACTOR_A + piece, sum.b * FACTOR_B + piece
  sum.a = a - floor(a / PRIME_A) * PRIME_A
  sum.b = b - floor(b / PRIME_B) * PRIME_B
end

-- Folds a finite number in pieces below 2^52: whole part, sign and what follows; fraction; scale.
local function mixNumber(sum, value)
  value = value + 0.0
  local sign = 0
  if value < 0 then
    value, sign = -value, 1
  end
  local scale = 0
  while value ~= 0 and value < 1 do
    value, scale = value * BIG, scale - 1
  end
  while value >= BIG do
    value, scale = value / BIG, scale + 1
  end
  local whole = floor(value)
  local fraction = (value - whole) * FRACTION
  mix(sum, whole * 8 + sign * 4 + (fraction ~= 0 and 2 or 0) + (scale ~= 0 and 1 or 0))
  if fraction ~= 0 then
    mix(sum, fraction)
  end
  if scale ~= 0 then
    mix(sum, scale + 64)
  end
end

local function mixText(sum, text)
  mix(sum, TEXT + #text)
  for at = 1, #text do
    mix(sum, text:byte(at))
  end
end

local mixAny

local function mixList(sum, list)
  mix(sum, #list)
  for at = 1, #list do
    mixAny(sum, list[at])
  end
end

function mixAny(sum, value)
  local kind = type(value)
  if kind == "number" then
    mixNumber(sum, value)
  elseif kind == "string" then
    mixText(sum, value)
  elseif kind == "table" then
    mixList(sum, value)
  else
    mix(sum, value and TRUE or FALSE)
  end
end

-- Folds a list with one number for each object, or false; nearly all of a state is in such lists.
local function mixDense(sum, list, count)
  for n = 1, count do
    mixNumber(sum, list[n] or 0)
  end
end

-- Folds a sparse list of a field. `default` is a value that means the same as none.
local function mixSparse(sum, name, list, default)
  local isNamed = false
  for at = 1, #list, 2 do
    if default == nil or list[at + 1] ~= default then
      if not isNamed then
        mixText(sum, name)
        isNamed = true
      end
      mix(sum, list[at])
      mixAny(sum, list[at + 1])
    end
  end
end

-- Returns the default of a field. Without friction of its own a static object takes the other
-- object's, which is not the same as 0.
local function defaultOf(name)
  if name ~= "friction" then
    return fields.objectByName[name].default
  end
end

local function mixGroups(sum, out)
  for _, group in ipairs(out.groups) do
    if group.count > 0 then
      mixAny(sum, group.name)
      mix(sum, group.count)
      mixAny(sum, group.direct)
      mixAny(sum, group.keys or false)
    end
  end
  for _, group in ipairs(out.tables or {}) do
    if #group.objects > 0 then
      mixAny(sum, group.name)
      mixAny(sum, group.direct)
      mixList(sum, group.keys)
      mixList(sum, group.objects)
    end
  end
end

-- Values of the game: tables by their keys, in order.
local function mixPlain(sum, value)
  if type(value) ~= "table" then
    return mixAny(sum, value)
  end
  local keys = keyOrder.sorted(value)
  mix(sum, #keys)
  for n = 1, #keys do
    mixAny(sum, keys[n])
    mixPlain(sum, value[keys[n]])
  end
end

-- The fields of the game that are saved.
local function mixOwn(sum, out)
  for _, entry in ipairs(out.own or {}) do
    mixText(sum, entry.name)
    for at = 1, #entry.values, 2 do
      mix(sum, entry.values[at])
      mixPlain(sum, entry.values[at + 1])
    end
  end
end

-- Folds the objects that have left the world and are remembered.
local function mixGone(sum, out)
  for _, saved in ipairs(out.gone or {}) do
    for _, name in ipairs(fieldColumns.NAMES) do
      local value = saved[name]
      mixAny(sum, value == nil and FALSE or value)
    end
  end
end

local function mixMemory(sum, out)
  for _, name in ipairs(format.FLAGS) do
    mixList(sum, out.memory[name])
  end
  for _, name in ipairs(format.LINKS) do
    mixList(sum, out.memory[name])
  end
  for _, entry in ipairs(format.POINTS) do
    if entry[1] ~= "last" and entry[1] ~= "drift" then -- they change no motion
      mixList(sum, out.memory[entry[1]])
    end
  end
  mixList(sum, out.memory.lost)
  -- (Not `touching`, which follows from the contacts; what it shows of hits depends on how many
  -- steps an update has made.)
  mixList(sum, out.contacts)
  mixList(sum, out.events)
  if out.heardBy then
    mix(sum, out.heardBy)
  end
  if out.sorted then
    mix(sum, out.sorted)
  end
  mixGone(sum, out)
end

local function mixSettings(sum, out)
  local settings = out.settings
  for _, name in ipairs(format.SETTINGS) do
    local value = settings[name]
    mixAny(sum, value == nil and FALSE or value)
  end
  mixAny(sum, settings.masks or false)
  mixAny(sum, settings.order or false)
  if settings.soft then
    mixList(sum, settings.soft)
  end
end

--- Returns the hash of a state, a whole number in 0..10^14.
function hash.of(out)
  local sum = { a = 1.0, b = 1.0 }
  mixSettings(sum, out)
  mixNumber(sum, out.saved)
  mixGroups(sum, out)
  for _, entry in ipairs(fieldColumns.EVERY) do
    mixDense(sum, out[entry[1]], out.count)
  end
  for _, entry in ipairs(fieldColumns.SOME) do
    mixSparse(sum, entry[1], out.fields[entry[1]], defaultOf(entry[1]))
  end
  for _, name in ipairs(fieldColumns.NAMES) do
    local list = out.read[name]
    if list and #list > 0 then
      mix(sum, TEXT) -- marks values that were read
      mixSparse(sum, name, list)
    end
  end
  mixMemory(sum, out)
  mixOwn(sum, out)
  mix(sum, 0)
  return floor(max(sum.a, 0) * PRIME_B + max(sum.b, 0))
end

--- Returns the hash of the present state of a world. Errors: something that `update` would refuse.
function hash.world(world)
  local b = world._bodies
  b.hashed = b.hashed or {}
  state.fill(world, b.hashed)
  return hash.of(b.hashed)
end

return hash
