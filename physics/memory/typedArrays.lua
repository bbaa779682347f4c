--- Makes columns as typed arrays of LuaJIT's FFI, for columnStore.

local typed = {}

local max = math.max

local TYPES = { { "number", "double" }, { "integer", "int32_t" }, { "boolean", "bool" } }
-- Bytes between two columns. Without them the columns of a large world would all begin at the same
-- offset of a memory page, and compete for the same few lines of the cache.
local GAP = 320

-- The garbage collector frees blocks that are not used any more.
local function drop() end

-- Room of a new store, in indexes: a server may have hundreds of worlds of a few objects.
local FIRST = 16

local function room(old, last)
  return max(FIRST, 2 * old, last)
end

--- Returns a source of columns for `columnStore.use`, or nil where there is no FFI.
function typed.source()
  local hasFfi, ffi = pcall(require, "ffi")
  if not hasFfi then
    return nil
  end
  local makers, sizes = {}, {}
  for n = 1, #TYPES do
    local kind, name = TYPES[n][1], TYPES[n][2]
    makers[kind], sizes[kind] = ffi.typeof(name .. "[?]"), ffi.sizeof(name)
  end
  local function give(kind, lengths)
    local gap = GAP / sizes[kind]
    local total = 0 ---@type number
    for n = 1, #lengths do
      total = total + lengths[n] + gap
    end
    local block, columns = makers[kind](total), {}
    local at = 0 ---@type number
    for n = 1, #lengths do
      columns[n], at = block + at, at + lengths[n] + gap
    end
    return columns, block
  end
  return { give = give, drop = drop, room = room }
end

return typed
