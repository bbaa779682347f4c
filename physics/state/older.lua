---@diagnostic disable
--- Reads states of earlier versions. Objects with their fields, groups and settings are as they
--- were; the library remembers nothing of them: contacts are told again, and riders board.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local layout = require(root .. ".memory.layout")

local older = {}

local DENSE = { "x", "y", "width", "height", "vx", "vy" }

-- Returns flat lists of names and values as tables in tables: { a, b, 1 } is { a = { b = 1 } }.
local function nested(list, depth)
  local map = {}
  for at = 1, #(list or {}), depth + 1 do
    local inner = map
    for n = 0, depth - 2 do
      inner[list[at + n]] = inner[list[at + n]] or {}
      inner = inner[list[at + n]]
    end
    inner[list[at + depth - 1]] = list[at + depth]
  end
  return list and map
end

-- Writes a sparse list into the objects. `isOurs`: of a field of the library, in which a table that
-- is no list of names is flat.
local function write(all, name, list, isOurs)
  for at = 1, #list, 2 do
    local value = list[at + 1]
    local isFlat = isOurs and type(value) == "table" and value[2] ~= nil
    isFlat = isFlat and type(value[2]) ~= "string"
    all[list[at]][name] = isFlat and nested(value, 1) or value
  end
end

-- Returns the objects of a state of version 2, by their number in it. Lists the names in `own`.
local function objectsOf(old, own)
  local all = {}
  for n = 1, #old.x do
    all[n] = {}
    for _, name in ipairs(DENSE) do
      all[n][name] = old[name][n] or nil
    end
  end
  for name, list in pairs(old.fields) do
    write(all, name, list, true)
  end
  for n, entry in ipairs(old.own or {}) do
    write(all, entry.name, entry.values)
    own[n] = entry.name
  end
  return all
end

--- Returns a state of version 2 as one of today. (Objects that were added since the last step are
--- the last ones there, in no group.)
function older.read(old)
  local st, objects, others, own = {}, {}, {}, {}
  local all = objectsOf(old, own)
  for name, value in pairs(old) do
    st[name] = type(value) ~= "table" and value or {}
  end
  for name, value in pairs(old.settings) do
    st.settings[name] = (name == "masks" or name == "soft") and nested(value, 2) or value
  end
  for g, group in ipairs(old.tables or old.groups) do
    local count = group.objects and #group.objects or group.count
    st.groups[g] = { name = group.name, direct = group.direct, count = count, keys = group.keys }
    for m = 1, count do
      local n = #objects + 1
      objects[n], others[n] = all[group.objects and group.objects[m] or n], n
    end
  end
  st.version, st.count, st.boxes, st.gone = layout.VERSION, #objects, {}, {}
  st.others, st.fields, st.own = others, objects, own[1] and own
  for _, entry in ipairs(layout.KEPT) do
    st.memory[entry[1]] = {}
  end
  return st
end

require(root .. ".memory.compiler").leave(objectsOf, older.read)

return older
