---@diagnostic disable
--- Makes the arrays of columns: where LuaJIT's compiler runs, typed arrays of its FFI, else tables.
--
-- Compiled code reads a typed array without checks of type and length, and has whole numbers at
-- once as indexes. Piles, levels and bullets take 0.7 of the time, crowds 0.9. Interpreted code
-- takes longer. So this is chosen when the first object comes: a game that turns the compiler off
-- must do so before that.
--
-- A typed array has a length: to grow, a column becomes another array. So nothing may hold a column
-- in a local variable while objects come or pairs are linked. Beyond its length there is no check.

local arrays = {}

local floor, max = math.floor, math.max
local jit = rawget(_G, "jit")
local types = {} -- of the FFI
-- The FFI, if there is one, and the compiler runs. Where there is no `jit`, it is not tried: on
-- gopher-lua an error takes local variables away from the game, though it is caught.
---@type boolean, any
local isKnown, ffi = not jit, nil
-- LuaJIT's function that makes a table with room.
---@type boolean, any
local hasRoom, newTable = false, nil
if jit then
  hasRoom, newTable = pcall(require, "table.new")
end

-- Columns are written side by side. With lengths of 2^n they would compete for the same few lines
-- of the cache (piles 9 % slower): each is longer by one place in so many.
local SPREAD = 16
-- Places in the first array of a column, or that a table has to spare; by how much an array grows.
local FIRST, GROWTH, SPARE = 4, 1.25, 1.125

-- Returns the FFI if columns are typed arrays.
local function typed()
  if not isKnown then
    local hasFfi, module = pcall(require, "ffi")
    isKnown, ffi = true, hasFfi and jit.status() and module
  end
  return ffi
end

--- Returns how many places a column gets that needs `count`: an array has more places than are
--- needed now, else each frame in which a level gets a few slots more would copy all columns. A
--- table grows by itself, but each growth goes through all columns: it gets a few more, too.
function arrays.places(old, count)
  return typed() and floor(max(count * SPARE + 1, FIRST, GROWTH * old)) or count + FIRST
end

--- Returns whether new places of a column hold this value: those of a typed array hold 0, `false`.
function arrays.begins(kind, value)
  return typed() and kind and (value == 0 or value == false)
end

--- Returns a column with places for the slots 0 to `count` - 1 that begins as `column` does.
---@param kind string|false a type of C, false: it may hold anything
---@param column any has places for `old` slots; for none, it is an empty table
---@param width integer places of each slot; the last one of sides is behind them (they are 1 to 4)
function arrays.grow(kind, column, width, old, count)
  if not (typed() and kind) then
    -- A table that doubles goes through all that it has: 20 000 tiles take a tenth more time.
    local isLarge = hasRoom and count > 2 * old
    local array = isLarge and newTable(width * count + 1, 0) or column
    for k = 0, isLarge and width * old or -1 do
      array[k] = column[k]
    end
    return array
  end
  types[kind] = types[kind] or ffi.typeof(kind .. "[?]")
  local array = types[kind](width * count + 1 + floor(width * count / SPREAD))
  if old > 0 then
    ffi.copy(array, column, ffi.sizeof(kind) * (width * old + 1))
  end
  return array
end

return arrays
