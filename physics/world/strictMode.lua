--- Finds common mistakes in the game's tables (the setting `checked`), by checks that would be too
--- slow or too strict for every game. It changes nothing.
--
--   a static object that was changed by hand: it is read once, so the change has no effect
--   a field or setting with a name that is one slip away from one that the library knows, and a
--     mask with the name of a group that is one slip away from a group of the world
--   a mask that refuses no group, and a filter of a query with such a name
--   a mover that is larger than very many cells of the grid
--   a dynamic object that is one-way: it is open to the floor below it
--   an object that is in two worlds (if both are checked)
--   a class that has `static`, `kinematic` or `sensor`, which its objects do not see; a method
--     `touching`, which the field of that name hides
--   a mask that refuses no group, of a new object or in new masks of the world
--   a side that `touching` does not have (from then on, the table tells by itself)
--   a dt in milliseconds
--   `canCollide` that returns nothing (see permission.lua)

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".world.check")
local columns = require(root .. ".memory.columns")
local fieldColumns = require(root .. ".objects.fieldColumns")
local fields = require(root .. ".world.fields")
local filter = require(root .. ".broadphase.filter")
local interpreted = require(root .. ".memory.jit")
local registry = require(root .. ".objects.registry")
local wording = require(root .. ".world.wording")

local guard = {}

local format, show = string.format, check.show
local STATIC, DYNAMIC = columns.STATIC, columns.DYNAMIC
local NONE = {}
-- Length that a mover may have, in cells.
local MOST_CELLS = 1024

-- Names of other libraries, and the names here.
local MEANT = {
  velocityX = "vx",
  velocityY = "vy",
  isStatic = "static",
  isKinematic = "kinematic",
  isSensor = "sensor",
  isActive = "active",
  isPushable = "pushable",
  bounciness = "restitution",
  elasticity = "restitution",
  damping = "airFriction",
  linearDamping = "airFriction",
  gravityScale = "gravity, in px/s²",
  isTrigger = "sensor",
  onCollide = "onBegin",
  onCollision = "onBegin",
}

-- Common names of a game's own that look like slips.
local OWN =
  { draw = true, update = true, weight = true, velocity = true, fraction = true, masks = true }

local placeOf = registry.placeOf

-- Names -------------------------------------------------------------------------------------------

-- Returns the name that a name is probably a misspelling of; false: it looks like one of the game's
-- own.
local function meaningOf(name, names, byName)
  if type(name) ~= "string" or byName[name] or OWN[name] or name:sub(1, 1) == "_" then
    return false
  elseif MEANT[name] and (byName == fields.objectByName or byName[MEANT[name]]) then
    return MEANT[name]
  end
  local guess = wording.guess(name, names)
  -- Short names are alike by chance: `w` and `z` may be the game's own.
  local isSure = guess and (#guess > 3 and #name > 3 or guess == name:lower())
  return isSure and guess or false
end

local function refuseName(place, name, meant)
  check.fail(
    format("%s.%s is not a field of the library: did you mean %s?", place, tostring(name), meant)
  )
end

-- Returns whether a value fits the field that is meant: a function for a callback, and for nothing
-- else.
local function mayBe(value, meant, byName)
  local field = byName[meant]
  local isCallback = field ~= nil and field.type == "function"
  return isCallback == (type(value) == "function")
end

-- Looks at the keys of a table itself, not at those of its class.
local function checkNames(seen, object, names, byName, b, i)
  for name, value in next, object, nil do
    local meant = seen[name]
    if meant == nil then
      meant = meaningOf(name, names, byName)
      seen[name] = meant
    end
    if meant and mayBe(value, meant, byName) then
      refuseName(i and placeOf(b, i) or "world", name, meant)
    end
  end
end

-- Returns the group that a name is probably a misspelling of; nil: there is none, or a group
-- of this name exists or existed. (A group may also come later, so short names are not checked.)
local function groupMeant(b, name)
  if type(name) ~= "string" or #name < 4 then
    return nil
  elseif b.guarded and b.guarded.groups[name] or b.world.objects[name] ~= nil then
    return nil
  end
  for n = 1, #b.registry.groups do
    local known = b.registry.groups[n].name
    if type(known) == "string" and #known > 3 and wording.isSlip(name, known) then
      return known
    end
  end
end

local function failGroup(place, name, meant)
  check.fail(format("%s: there is no group %s, did you mean %s?", place, name, meant))
end

-- Checks the groups that a mask names; `place` is how the game would write it.
local function checkMask(b, mask, place)
  for name in next, mask, nil do
    local meant = groupMeant(b, name)
    if meant then
      failGroup(place, name, meant)
    end
  end
end

local function checkHits(b, i, hits)
  if not filter.isSameHits(hits, b.only[i]) then
    check.fail(
      placeOf(b, i)
        .. ".hits was changed inside its table: the list is read when it is set, so set another"
        .. " list"
    )
  end
  for n = 1, #hits do
    local meant = groupMeant(b, hits[n])
    if meant then
      failGroup(placeOf(b, i) .. ".hits", hits[n], meant)
    end
  end
end

local function checkMasks(b, masks, place)
  checkMask(b, masks, place)
  for name, mask in next, masks, nil do
    checkMask(b, mask, place .. "." .. tostring(name))
  end
end

-- Returns the words that a mask refuses nothing, in which all groups collide: it is meant for the
-- only groups to collide with. Returns also one of them. nil: it refuses some, or is empty.
local function refusesNothing(mask)
  local group = nil
  for name, collides in next, mask, nil do
    if collides == false then
      return nil
    end
    group = name
  end
  local text = " = { [%s] = true } refuses nothing: true collides, as nil does, and false passes"
    .. " through"
  return group ~= nil and format(text, show(group)) or nil, group
end

local function checkRefuses(b, i, mask)
  local text, group = refusesNothing(mask)
  if text then
    check.fail(format("%s.mask%s (did you mean hits = { %s }?)", placeOf(b, i), text, show(group)))
  end
end

-- Checks new masks of the world. (In them, the game may turn groups on and off.)
local function checkRows(b, masks)
  if b.guarded.masks ~= masks then
    for name, mask in next, masks, nil do
      local text = refusesNothing(mask)
      if text then
        check.fail("world.masks." .. tostring(name) .. text)
      end
    end
    b.guarded.masks = masks
  end
end

-- Classes -----------------------------------------------------------------------------------------

-- Fields of a class that its objects must see.
local KINDS = { "static", "kinematic", "sensor" }

-- Looks for a field that a class has in its own table, of which its objects see nothing.
local function checkClass(b, i, object, class)
  for n = 1, type(class) == "table" and #KINDS or 0 do
    local name = KINDS[n]
    if rawget(class, name) == true and object[name] == nil then
      local text = "%s.%s is nil, but its class has %s = true: set it in the object, as in"
        .. " self.%s = true"
      check.fail(format(text, placeOf(b, i), name, name, name))
    end
  end
end

-- Looks for a method that the field of that name hides.
local function checkMethod(b, i, class)
  local index = type(class) == "table" and rawget(class, "__index")
  if type(index) == "table" and type(index.touching) == "function" then
    check.fail(
      placeOf(b, i)
        .. ".touching is written by the library, and hides the method touching of its"
        .. " class: give that another name"
    )
  end
end

-- What a `touching` says that is asked for a side that there is not.
local SIDES = {
  __index = function(_, side)
    local text = "touching.%s is no side: there are top, bottom, left and right"
    check.fail(format(text, tostring(side)))
  end,
}

local function watchSides(b, i)
  local touching = b.touching[i]
  if touching and not getmetatable(touching) then
    setmetatable(touching, SIDES)
  end
end

local function checkClasses(b, i, object)
  local class = getmetatable(object)
  checkClass(b, i, object, class)
  checkClass(b, i, object, object.class)
  if b.kind[i] == columns.DYNAMIC then
    checkMethod(b, i, class)
    watchSides(b, i)
  end
end

-- Static objects ----------------------------------------------------------------------------------

local function refuseStatic(b, i, name, value)
  check.fail(
    format(
      "%s.%s was changed to %s: a static object is read only once, so call world:refresh(object)",
      placeOf(b, i),
      name,
      show(value)
    )
  )
end

local function checkStatic(b, i, object)
  if not object.static then
    refuseStatic(b, i, "static", object.static)
  end
  local name = fieldColumns.firstChanged(b, i, object)
    or (object.canCollide or false) ~= b.canCollide[i] and "canCollide"
    or (object.onStay or false) ~= b.hears[i] and "onStay"
  if name then
    refuseStatic(b, i, name, object[name])
  end
end

-- Movers ------------------------------------------------------------------------------------------

local function checkMover(b, i, object)
  if object.static then
    refuseStatic(b, i, "static", true)
  elseif object.oneWay and b.kind[i] == DYNAMIC then
    check.fail(
      format(
        "%s.oneWay must be nil, got %s: one-way objects are static or kinematic; a dynamic one"
          .. " falls through the floor",
        placeOf(b, i),
        show(object.oneWay)
      )
    )
  end
  local cell = b.broadphase.cell
  if cell then
    local name = object.width > object.height and "width" or "height"
    if object[name] > MOST_CELLS * cell then
      check.fail(
        format(
          "%s.%s must be at most %d cells of %s px, got %s: set world.cellSize to the size of most"
            .. " objects",
          placeOf(b, i),
          name,
          MOST_CELLS,
          show(cell),
          show(object[name])
        )
      )
    end
  end
end

-- Worlds ------------------------------------------------------------------------------------------

-- The columns in which an object was last seen. All worlds share only this memory: one world cannot
-- know the objects of another. The table is weak, so it keeps no object alive.
local owners = setmetatable({}, { __mode = "kv" })

-- Returns the slot of an object there; it may have been removed since the last step.
local function slotIn(owner, object)
  local slot, objects = owner.slotOf[object], owner.world.objects
  return slot and type(objects) == "table" and registry.whereSeen(owner, objects, slot) and slot
end

local function checkOwner(b, i, object)
  local owner = owners[object]
  if owner ~= b then
    local slot = owner and slotIn(owner, object)
    if slot then
      check.fail(format("%s is also in another world, as %s", placeOf(b, i), placeOf(owner, slot)))
    end
    owners[object] = b
  end
end

--- Checks the groups that the filter of a query names: a list of them, or one.
--- Errors: a name that is one slip away from a group of the world.
function guard.filter(world, wanted, where)
  local b, names = world._bodies, wanted
  if type(wanted) ~= "table" then
    names = { wanted }
  end
  for n = 1, #names do
    local meant = groupMeant(b, names[n])
    if meant then
      failGroup(where .. ": filter", names[n], meant)
    end
  end
end

--- Notes the dt of an update. One of more than a second may be a game that was stopped; two after
--- each other are milliseconds.
--- Errors: that.
function guard.checkTime(world, dt)
  local b = world._bodies
  local wasLong = b.wasLong
  b.wasLong = dt > 1
  if b.wasLong and wasLong then
    check.fail(
      "world:update(dt): dt is in seconds, got " .. show(dt) .. " (milliseconds? divide by 1000)"
    )
  end
end

--- Checks all objects and settings, right after the game's tables were read.
--- Errors: see the top of this file; nothing has changed then.
function guard.run(world)
  local b = world._bodies
  b.guarded = b.guarded or { fields = {}, settings = {}, groups = {} }
  local seen = b.guarded
  for n = 1, #b.registry.groups do
    seen.groups[b.registry.groups[n].name] = true
  end
  checkNames(seen.settings, world, fields.settingNames, fields.settingByName, b)
  checkMasks(b, world.masks or NONE, "world.masks")
  checkMasks(b, world.soft or NONE, "world.soft")
  checkRows(b, world.masks or NONE)
  for i = 1, b.slots do
    local object = b.object[i]
    if object then
      checkNames(seen.fields, object, fields.objectNames, fields.objectByName, b, i)
      if b.kind[i] == STATIC then
        checkStatic(b, i, object)
      else
        checkMover(b, i, object)
      end
      if object.hits then
        checkHits(b, i, object.hits)
      end
      if object.mask then
        checkMask(b, object.mask, placeOf(b, i) .. ".mask")
        if b.fresh[i] then
          checkRefuses(b, i, object.mask)
        end
      end
      checkClasses(b, i, object)
      checkOwner(b, i, object)
    end
  end
end

interpreted.always(checkNames, checkMask, checkMasks, refusesNothing, checkRows)

return guard
