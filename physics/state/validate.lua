--- Checks a state before it is restored. Either all of it can be used, or the error says what
--- cannot, and nothing has changed.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".world.check")
local fieldColumns = require(root .. ".objects.fieldColumns")
local fields = require(root .. ".world.fields")
local interpreted = require(root .. ".memory.jit")
local own = require(root .. ".state.own")
local format = require(root .. ".state.format")

local verify = {}

local WHERE = "world:restore(state): "
-- As in step.lua, s: the longest time that can be saved up, and its tolerance for rounding.
local LONGEST, ROUNDING = 0.25, 1e-9
local floor = math.floor
local isFinite, show = check.isFinite, check.show

local function refuse(path, expected, value)
  check.fail(WHERE .. path .. " must be " .. expected .. ", got " .. show(value))
end

local function isCount(value, most)
  return isFinite(value) and value >= 0 and value <= most and floor(value) == value
end

local function isBoolean(value)
  return type(value) == "boolean"
end

-- Returns a value that must be a table; `path` names it in the error.
local function needTable(value, path)
  if type(value) ~= "table" then
    refuse(path, "a table", value)
  end
  return value
end

local function needCount(value, path, most)
  if not isCount(value, most) then
    refuse(path, "an integer in 0.." .. show(most), value)
  end
end

-- Checks every entry of a list. `kinds` are { test, expectation }, in the order in which entries
-- follow each other.
local function needList(list, path, kinds)
  needTable(list, path)
  local step = #kinds
  if #list % step ~= 0 then
    refuse("#" .. path, "a multiple of " .. step, #list)
  end
  for at = 1, #list do
    local kind = kinds[(at - 1) % step + 1]
    if not kind[1](list[at]) then
      refuse(path .. "[" .. at .. "]", kind[2], list[at])
    end
  end
end

local NUMBER = { isFinite, "a number in -1e+100..1e+100" }
local BOOLEAN = { isBoolean, "true or false" }
local function isSoftSpeed(value)
  return isFinite(value) and value >= 0 and value <= check.FASTEST
end

local SPEED = { isSoftSpeed, "a number in 0.." .. show(check.FASTEST) }
local NAME = { check.isName, "a string or a number" }

-- Returns the kind of an entry that is the number of an object.
local function objectKind(first, last)
  return {
    function(value)
      return isCount(value, last) and value >= first
    end,
    "an integer in " .. first .. ".." .. last,
  }
end

-- Checks that the first values of a sparse list's entries ascend.
local function needAscent(list, path, step)
  for at = 1 + step, #list, step do
    if list[at] <= list[at - step] then
      refuse(path .. "[" .. at .. "]", "> " .. show(list[at - step]), list[at])
    end
  end
end

local function needSparse(list, path, kinds)
  needList(list, path, kinds)
  needAscent(list, path, #kinds)
end

-- Settings ---------------------------------------------------------------------------------------

local function needSettings(settings)
  needTable(settings, "state.settings")
  for _, name in ipairs(format.SETTINGS) do
    local field, value = fields.settingByName[name], settings[name]
    if value ~= nil or field.default ~= nil then
      check.value(field, value, WHERE .. "state.settings." .. name)
    end
  end
  if settings.masks ~= nil then
    needList(settings.masks, "state.settings.masks", { NAME, NAME, BOOLEAN })
  end
  if settings.soft ~= nil then
    needList(settings.soft, "state.settings.soft", { NAME, NAME, SPEED })
  end
  if settings.order ~= nil then
    check.value(fields.settingByName.order, settings.order, WHERE .. "state.settings.order")
  end
end

-- Objects ----------------------------------------------------------------------------------------

-- Checks that a list of names or keys has none twice.
local function needUnique(list, path)
  local seen = {}
  for at = 1, #list do
    if seen[list[at]] then
      refuse(path .. "[" .. at .. "]", "a key that is there once", list[at])
    end
    seen[list[at]] = true
  end
end

-- Checks name, `direct` and keys of a group with `count` objects.
local function needGroup(group, path, count, seen)
  if not check.isName(group.name) or seen[group.name] then
    refuse(path .. ".name", "a name that is there once", group.name)
  end
  seen[group.name] = true
  if not isBoolean(group.direct) then
    refuse(path .. ".direct", "true or false", group.direct)
  end
  if group.direct and count ~= 1 then
    refuse(path .. ".count", "1", count)
  end
  if group.keys ~= nil then
    needList(group.keys, path .. ".keys", { NAME })
    if #group.keys ~= count then
      refuse("#" .. path .. ".keys", show(count), #group.keys)
    end
    needUnique(group.keys, path .. ".keys")
  end
end

local function needGroups(st)
  local total, seen = 0, {}
  for g, group in ipairs(needTable(st.groups, "state.groups")) do
    local path = "state.groups[" .. g .. "]"
    needTable(group, path)
    needCount(group.count, path .. ".count", st.known)
    needGroup(group, path, group.count, seen)
    total = total + group.count
  end
  if total ~= st.known then
    refuse("state.known", show(total) .. ", as many as the groups have", st.known)
  end
end

local function needTables(st)
  if st.tables == nil then
    if st.count ~= st.known then
      refuse("state.count", show(st.known), st.count)
    end
    return
  end
  local seen, owners = {}, {}
  for g, group in ipairs(needTable(st.tables, "state.tables")) do
    local path = "state.tables[" .. g .. "]"
    needTable(group, path)
    needList(group.objects, path .. ".objects", { objectKind(1, st.count) })
    needTable(group.keys, path .. ".keys")
    needGroup(group, path, #group.objects, seen)
    for m, n in ipairs(group.objects) do
      if owners[n] then
        refuse(path .. ".objects[" .. m .. "]", "an object that is there once", n)
      end
      owners[n] = true
    end
  end
  for n = st.known + 1, st.count do
    if not owners[n] then
      refuse("state.tables", "a place for object " .. n, nil)
    end
  end
end

-- Fields -----------------------------------------------------------------------------------------

-- Returns how the game would write the place of object n.
local function placeOf(st, n)
  local before = 0
  for _, group in ipairs(st.groups) do
    if n <= before + group.count then
      local m = n - before
      return check.place(
        group.name,
        not group.direct and (group.keys and group.keys[m] or m) or nil
      )
    end
    before = before + group.count
  end
  return "new object " .. n
end

local MASK = { NAME, BOOLEAN }

-- An area as { name, value, ... }.
local function needArea(list, path)
  needTable(list, path)
  for at = 1, #list, 2 do
    local field = fields.areaByName[list[at]]
    if not field then
      refuse(path .. "[" .. at .. "]", "the name of an entry of an area", list[at])
    end
    check.value(field, list[at + 1], WHERE .. path .. "." .. field.name)
  end
end

-- Checks a value of a field; `path` is its place in the state, n the number of its object.
local function needField(field, value, path, st, n)
  if field.type == "mask" then
    needList(value, path, MASK)
  elseif field.type == "area" then
    needArea(value, path)
  elseif not check.accepts(field, value) then
    check.value(field, value, WHERE .. (n and placeOf(st, n) .. "." .. field.name or path))
  end
end

local function needDense(st, name)
  local path, field = "state." .. name, fields.objectByName[name]
  local list = needTable(st[name], path)
  if #list ~= st.count then
    refuse("#" .. path, show(st.count), #list)
  end
  for n = 1, st.count do
    local value = list[n]
    if value ~= false or field.required then
      needField(field, value, path, st, n)
    end
  end
end

local function needSparseField(st, list, name, path, last, isRead)
  local field = fields.objectByName[name]
  path = path .. "." .. name
  needTable(list, path)
  if #list % 2 ~= 0 then
    refuse("#" .. path, "even", #list)
  end
  for at = 1, #list, 2 do
    local n, value = list[at], list[at + 1]
    if not isCount(n, last) or n < 1 then
      refuse(path .. "[" .. at .. "]", "an integer in 1.." .. last, n)
    end
    if not (isRead and value == false) then
      needField(field, value, path .. "[" .. (at + 1) .. "]", st, n)
    end
  end
  needAscent(list, path, 2)
end

local function needFields(st)
  needTable(st.fields, "state.fields")
  needTable(st.read, "state.read")
  for _, entry in ipairs(fieldColumns.EVERY) do
    needDense(st, entry[1])
  end
  for _, entry in ipairs(fieldColumns.SOME) do
    local name = entry[1]
    needSparseField(st, st.fields[name], name, "state.fields", st.count, false)
  end
  for _, name in ipairs(fieldColumns.NAMES) do
    if st.read[name] ~= nil then
      needSparseField(st, st.read[name], name, "state.read", st.known, true)
    end
  end
end

-- Checks the objects that have left the world and are remembered.
local function needGone(st)
  for n, saved in ipairs(st.gone == nil and {} or needTable(st.gone, "state.gone")) do
    local path = "state.gone[" .. n .. "]"
    needTable(saved, path)
    for _, name in ipairs(fieldColumns.NAMES) do
      local field, value = fields.objectByName[name], saved[name]
      if value ~= nil then
        needField(field, value, path .. "." .. name)
      end
    end
  end
end

-- Memory -----------------------------------------------------------------------------------------

-- Returns how many objects have a number.
local function countNamed(st)
  return st.count + (st.gone and #st.gone or 0)
end

local function needMemory(st)
  local memory, object = needTable(st.memory, "state.memory"), objectKind(1, st.known)
  for _, name in ipairs(format.FLAGS) do
    needSparse(memory[name], "state.memory." .. name, { object })
  end
  needSparse(memory.lost, "state.memory.lost", { object })
  for _, name in ipairs(format.LINKS) do
    needSparse(memory[name], "state.memory." .. name, { object, object })
  end
  for _, entry in ipairs(format.POINTS) do
    local kind = type(entry[2]) == "boolean" and BOOLEAN or NUMBER
    needSparse(memory[entry[1]], "state.memory." .. entry[1], { object, kind, kind })
  end
  local none = objectKind(0, countNamed(st))
  needSparse(st.touching, "state.touching", { object, none, none, none, none })
  for side, n in next, needTable(st.walls, "state.walls"), nil do
    if type(side) ~= "string" or not isCount(n, st.count) or n < 1 then
      refuse("state.walls." .. show(side), "an integer in 1.." .. st.count, n)
    end
  end
end

-- Returns the kind of a pair's value: its default, or a value that can be swapped.
local function pairKind(entry)
  return {
    function(value)
      return value == entry[2] or type(value) == type(entry[2]) and entry[3][value] ~= nil
    end,
    "a " .. entry[1] .. " of a pair",
  }
end

local function needContacts(st)
  local object = objectKind(1, st.known)
  local kinds = { object, object }
  for _, entry in ipairs(format.PAIRS) do
    kinds[#kinds + 1] = pairKind(entry)
  end
  local list = st.contacts
  needList(list, "state.contacts", kinds)
  local step = #kinds
  for at = 1, #list, step do
    local path = "state.contacts[" .. (at + 1) .. "]"
    if list[at + 1] <= list[at] then
      refuse(path, "> " .. show(list[at]), list[at + 1])
    end
    local isLater = at == 1
      or list[at] > list[at - step]
      or (list[at] == list[at - step] and list[at + 1] > list[at + 1 - step])
    if not isLater then
      refuse(path, "behind the pair before it", list[at + 1])
    end
  end
end

local function needEvents(st)
  local object, none = objectKind(1, countNamed(st)), objectKind(0, countNamed(st))
  local kind = {
    function(value)
      return isCount(value, 5) and value > 0
    end,
    "an integer in 1..5",
  }
  local side = {
    function(value)
      return value == "x" or value == "y" or isCount(value, 4) and value > 0
    end,
    "a side",
  }
  local kinds = { object, object, none, kind, side }
  for n = #kinds + 1, 3 + #format.EVENT do
    kinds[n] = NUMBER
  end
  needList(st.events, "state.events", kinds)
  local list, length = st.events, #kinds
  for at = 4, #list, length do
    if (list[at] == 5) ~= (type(list[at + 1]) == "string") then
      refuse("state.events[" .. (at + 1) .. "]", "a side of this kind of event", list[at + 1])
    end
  end
  local heardBy = st.heardBy
  if heardBy ~= nil and not (#list > 0 and isCount(heardBy, 2) and heardBy > 0) then
    refuse("state.heardBy", "nil, or 1 or 2 where events wait", heardBy)
  end
  if st.sorted ~= nil and not isCount(st.sorted, #list / length) then
    refuse("state.sorted", "nil, or an integer in 0.." .. show(#list / length), st.sorted)
  end
end

--- Checks a whole state. Errors: it is not a table; another version; something in it that cannot be
--- used.
function verify.state(st)
  needTable(st, "state")
  if st.version == nil then
    check.fail(WHERE .. "state must be what world:save() returns, got " .. show(st))
  elseif st.version ~= format.VERSION then
    local expected = show(format.VERSION) .. " (it was saved by another version of the library)"
    refuse("state.version", expected, st.version)
  end
  needSettings(st.settings)
  -- Rounding may leave slightly less than 0. More than LONGEST cannot come from an update.
  if not isFinite(st.saved) or st.saved < -ROUNDING or st.saved > LONGEST then
    refuse("state.saved", "a number in 0..0.25", st.saved)
  end
  needCount(st.count, "state.count", 2 ^ 31)
  needCount(st.known, "state.known", st.count)
  needGroups(st)
  needTables(st)
  needFields(st)
  needGone(st)
  needMemory(st)
  needContacts(st)
  needEvents(st)
  own.verify(st, WHERE)
end

interpreted.always(needMemory)

return verify
