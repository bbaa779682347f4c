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

-- Returns a sparse list for objects in another order. `isOurs`: of a field of the library, in which
-- a table that is no list of names is flat.
local function sparse(old, order, isOurs)
  local values, list = {}, {}
  for at = 1, #old, 2 do
    local value = old[at + 1]
    local isFlat = isOurs and type(value) == "table" and value[2] ~= nil
    isFlat = isFlat and type(value[2]) ~= "string"
    values[old[at]] = isFlat and nested(value, 1) or value
  end
  for n = 1, #order do
    if values[order[n]] ~= nil then
      list[#list + 1], list[#list + 2] = n, values[order[n]]
    end
  end
  return list
end

--- Returns a state of version 2 as one of today. (Objects that were added since the last step are
--- the last ones there, in no group.)
function older.read(old)
  local st, order = {}, {}
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
      order[#order + 1] = group.objects and group.objects[m] or #order + 1
    end
  end
  for _, name in ipairs(DENSE) do
    st.fields[name] = {}
    for n = 1, #order do
      st.fields[name][n] = old[name][order[n]]
    end
  end
  for name, list in pairs(old.fields) do
    st.fields[name] = sparse(list, order, true)
  end
  for n, entry in ipairs(old.own or {}) do
    st.own[n], st.fields[entry.name] = entry.name, sparse(entry.values, order)
  end
  st.version, st.count, st.gone = layout.VERSION, #order, 0
  for _, entry in ipairs(layout.KEPT) do
    st.memory[entry[1]] = {}
  end
  return st
end

return older
