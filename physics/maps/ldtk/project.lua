--- The parts of an LDtk project: finds the level that is meant, and checks what is read of it.

local root = (...):match("^(.*)%.maps%.")
local check = require(root .. ".world.check")
local interpreted = require(root .. ".memory.jit")
local values = require(root .. ".maps.values")

local project = {}

--- How an error names the call.
project.WHERE = "world:loadLDtk(project, level, options)"

local WHERE = project.WHERE

local OPTIONS =
  { "groups", "ignore", "merge", "onlyLayers", "skipLayers", "solid", "strict", "x", "y" }

---@class physics.LDtkOptions
---@field x? number px, default 0: where the level's left edge goes, often `level.worldX`
---@field y? number px, default 0: where its upper edge goes
---@field solid? table<string|integer, boolean|table> which values of IntGrid layers are solid, by
---  identifier or number: true, or the fields of their objects; default: those with an identifier
---  that says so (walls, solid, ground, collision), else all
---@field groups? table<string, string|number> identifier of an entity -> its group
---@field onlyLayers? string[] identifiers of layers: nothing else is read
---@field skipLayers? string[] identifiers of layers that are left out
---@field ignore? string[] names of fields that mean something else in this game
---@field strict? boolean default false; true: a field that cannot be used is an error
---@field merge? boolean default true: equal solid cells become few; false: each one is an object

--- Returns a text, nil if it is none: decoders have several ways to say `null`.
function project.text(value)
  return type(value) == "string" and value or nil
end

-- Options -----------------------------------------------------------------------------------------

local function namesOf(options, name)
  local list = options[name]
  if list == nil then
    return nil
  elseif not check.isList(list) then
    check.fail(("%s: %s must be a list of names, got %s"):format(WHERE, name, check.show(list)))
  end
  for i = 1, #list do
    if type(list[i]) ~= "string" then
      local text = "%s: %s[%d] must be a name, got %s"
      check.fail(text:format(WHERE, name, i, check.show(list[i])))
    end
  end
  return list
end

local function groupsOf(options)
  local groups = options.groups
  if groups == nil then
    return {}
  end
  check.table(groups, "groups", WHERE)
  local names = {}
  for name in pairs(groups) do
    if type(name) ~= "string" then
      local text = "%s: groups must have identifiers of entities as keys, got %s"
      check.fail(text:format(WHERE, check.show(name)))
    end
    names[#names + 1] = name
  end
  table.sort(names)
  for _, name in ipairs(names) do
    check.group(groups[name], WHERE, "groups." .. name)
  end
  return groups
end

local function toSet(list)
  local set = {}
  for _, name in ipairs(list or {}) do
    set[name] = true
  end
  return set
end

--- Returns what a level is read by.
--- Errors: an unknown option, or a wrong value for one.
---@param options physics.LDtkOptions?
---@return table reading
function project.checkOptions(options)
  options = values.readOptions(options, OPTIONS, { "merge", "strict" }, WHERE)
  local isIgnored = toSet(namesOf(options, "ignore"))
  return {
    x = options.x or 0,
    y = options.y or 0,
    merge = options.merge ~= false,
    groups = groupsOf(options),
    onlyLayers = namesOf(options, "onlyLayers"),
    skipLayers = namesOf(options, "skipLayers"),
    solid = values.readSolid(options.solid, { fields = {}, problems = {} }, WHERE),
    rules = {
      solidNames = { "solid", "collidable" },
      isIgnored = isIgnored,
      isStrict = options.strict or false,
    },
  }
end

-- Levels ------------------------------------------------------------------------------------------

local function fail(text, ...)
  check.fail(WHERE .. ": " .. text:format(...))
end

local function levelsOf(given)
  local levels, parts = {}, { given }
  for _, world in ipairs(type(given.worlds) == "table" and given.worlds or {}) do
    parts[#parts + 1] = world
  end
  for _, part in ipairs(parts) do
    local list = type(part) == "table" and part.levels
    for _, level in ipairs(type(list) == "table" and list or {}) do
      levels[#levels + 1] = level
    end
  end
  return levels
end

local function pick(levels, wanted)
  if type(wanted) == "number" then
    return levels[wanted]
  end
  for _, level in ipairs(levels) do
    if level.identifier == wanted or level.iid == wanted then
      return level
    end
  end
end

local function failLevel(levels, wanted)
  local names = {}
  for i, level in ipairs(levels) do
    names[i] = check.show(level.identifier)
  end
  local text = "level must be the identifier, iid or number of a level, got %s; they are %s"
  fail(text, check.show(wanted), table.concat(names, ", "))
end

--- Returns a level of a project.
--- Errors: no project; no such level; its layers are in a file of their own.
---@param given any the decoded project
---@param wanted any identifier, iid, number, the level itself, nil: the first
---@return table level
function project.findLevel(given, wanted)
  if type(given) ~= "table" then
    fail("project must be a decoded LDtk project, got %s", check.show(given))
  elseif type(given.levels) ~= "table" then
    fail("project.levels must be a table, got %s", check.show(given.levels))
  end
  local level = wanted
  if type(wanted) ~= "table" then
    local levels = levelsOf(given)
    for i = 1, #levels do
      check.table(levels[i], ("project.levels[%d]"):format(i), WHERE)
    end
    level = pick(levels, wanted == nil and 1 or wanted)
    if not level then
      failLevel(levels, wanted)
    end
  end
  if type(level.layerInstances) ~= "table" then
    local path = project.text(level.externalRelPath)
    if path then
      fail("level %s is in %s: decode it and give that", check.show(level.identifier), path)
    end
    fail("level.layerInstances must be a table, got %s", check.show(level.layerInstances))
  end
  check.positive(level.pxWid, "level.pxWid", WHERE)
  check.positive(level.pxHei, "level.pxHei", WHERE)
  return level
end

-- Parts -------------------------------------------------------------------------------------------

--- Returns the definitions of the values of an IntGrid layer.
---@param given table the project
---@param uid integer? of the layer's definition
---@return table[]
function project.valuesOf(given, uid)
  local list = {}
  local layers = type(given.defs) == "table" and given.defs.layers
  for _, layer in ipairs(type(layers) == "table" and layers or {}) do
    local found = type(layer) == "table" and layer.uid == uid and layer.intGridValues
    for _, definition in ipairs(type(found) == "table" and found or {}) do
      if type(definition) == "table" and check.isFinite(definition.value) then
        list[#list + 1] = definition
      end
    end
  end
  return list
end

local function checkListed(level, option, list)
  for i, wanted in ipairs(list or {}) do
    local names, isThere = {}, false
    for n, layer in ipairs(level.layerInstances) do
      names[n] = type(layer) == "table" and check.show(layer.__identifier) or "?"
      isThere = isThere or type(layer) == "table" and layer.__identifier == wanted
    end
    if not isThere then
      local text = "%s[%d] must be a layer of the level, got %s; they are %s"
      fail(text, option, i, check.show(wanted), table.concat(names, ", "))
    end
  end
end

local function allValues(given, level)
  local isKnown, shown = {}, {}
  for _, layer in ipairs(level.layerInstances) do
    local list = type(layer) == "table" and project.valuesOf(given, layer.layerDefUid) or {}
    for _, definition in ipairs(list) do
      local identifier = project.text(definition.identifier)
      isKnown[definition.value], shown[#shown + 1] = true, tostring(definition.value)
      if identifier then
        isKnown[identifier], shown[#shown] = true, check.show(identifier)
      end
    end
  end
  return isKnown, shown
end

--- Checks that what options name is in the project: a slip would only show in the game.
--- Errors: a layer, or a value of `solid`, that is not.
---@param given table the project
---@param level table
---@param reading table
function project.checkNames(given, level, reading)
  checkListed(level, "onlyLayers", reading.onlyLayers)
  checkListed(level, "skipLayers", reading.skipLayers)
  local isKnown, shown = allValues(given, level)
  local unknown
  for key in pairs(reading.solid or {}) do
    if not isKnown[key] and (unknown == nil or check.show(key) < check.show(unknown)) then
      unknown = key
    end
  end
  if unknown ~= nil then
    local text = "solid[%s] must be a value of an IntGrid layer; they are %s"
    fail(text, check.show(unknown), table.concat(shown, ", "))
  end
end

--- Errors: a layer without a name, or with offsets that are no numbers.
---@param layer any
---@param i integer which of the level
---@return string place how an error names it
function project.checkLayer(layer, i)
  check.table(layer, ("level.layerInstances[%d]"):format(i), WHERE)
  if type(layer.__identifier) ~= "string" then
    fail("a layer's __identifier must be a string, got %s", check.show(layer.__identifier))
  end
  local place = ("%s: layer %s"):format(WHERE, check.show(layer.__identifier))
  for _, name in ipairs({ "__pxTotalOffsetX", "__pxTotalOffsetY" }) do
    if layer[name] ~= nil then
      check.number(layer[name], name, place)
    end
  end
  return place
end

--- Errors: no size, or no list of that many cells.
---@param layer table an IntGrid layer
---@param place string
function project.checkGrid(layer, place)
  check.positive(layer.__gridSize, "__gridSize", place)
  check.integer(layer.__cWid, "__cWid", place, 1, 1e6)
  check.integer(layer.__cHei, "__cHei", place, 1, 1e6)
  check.table(layer.intGridCsv, "intGridCsv", place)
  local expected = layer.__cWid * layer.__cHei
  if #layer.intGridCsv ~= expected then
    local text = "%s: intGridCsv must hold %d cells (%d x %d), got %d"
    check.fail(text:format(place, expected, layer.__cWid, layer.__cHei, #layer.intGridCsv))
  end
end

--- Errors: no name, no place, no size.
---@param entity any
---@param place string
function project.checkEntity(entity, place)
  if type(entity) ~= "table" then
    check.fail(("%s must be a table, got %s"):format(place, check.show(entity)))
  elseif type(entity.__identifier) ~= "string" then
    local text = "%s: __identifier must be a string, got %s"
    check.fail(text:format(place, check.show(entity.__identifier)))
  end
  place = place .. " " .. check.show(entity.__identifier)
  check.positive(entity.width, "width", place)
  check.positive(entity.height, "height", place)
  for _, name in ipairs({ "px", "__pivot" }) do
    check.table(entity[name], name, place)
    check.number(entity[name][1], name .. "[1]", place)
    check.number(entity[name][2], name .. "[2]", place)
  end
end

local IS_DATA = { number = true, string = true, boolean = true, table = true }

--- Returns the fields of an entity or a level; those that are `null` are not there.
--- Errors: fields without a name.
---@param owner table
---@param place string
---@return table<string, any>
function project.fieldsOf(owner, place)
  local fields = {}
  if owner.fieldInstances == nil then
    return fields
  end
  check.table(owner.fieldInstances, "fieldInstances", place)
  for i, field in ipairs(owner.fieldInstances) do
    check.table(field, ("fieldInstances[%d]"):format(i), place)
    local name = field.__identifier
    if type(name) ~= "string" then
      local text = "%s: fieldInstances[%d].__identifier must be a string, got %s"
      check.fail(text:format(place, i, check.show(name)))
    end
    if IS_DATA[type(field.__value)] then
      fields[name] = field.__value
    end
  end
  return fields
end

interpreted.always(groupsOf, project.checkNames)

return project
