--- The class of worlds, and what its methods share: checks of their arguments, and where an object
--- is.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".world.check")
local columns = require(root .. ".memory.columns")
local interpreted = require(root .. ".memory.jit")
local lazy = require(root .. ".memory.lazy")
local notice = require(root .. ".queries.notice")
local read = require(root .. ".objects.read")
local registry = require(root .. ".objects.registry")

local guard = lazy(root .. ".world.strictMode") -- loaded when it is first used

--- An independent world: a table of groups of objects, settings as plain fields, and the steps.
--- Its settings are fields of it, too.
---@class (partial) physics.World: physics.WorldSettings
---@field objects table<string|number, any> the game's groups of objects
---@field stats physics.Stats counters of the last step
---@field alpha number share of a fixed step that is saved up, 0..1; your own loop may write it (see
---  `interpolate`)
---@field protected _bodies table the columns of the simulation
---@field protected _saved number s, time for which no fixed step was made yet
---@field protected _restores integer how often it was put back to an earlier state
---@field protected _walls table what `setBounds` has put there
local World = {}
World.__index = World

local class = { World = World }

--- Refuses a call without a world, as by a dot. `where` is how the game writes the call.
function class.checkSelf(self, where)
  if getmetatable(self) ~= World then
    check.fail(where .. " must be called with a colon on a world, got " .. check.show(self))
  end
end

--- Does the same, and refuses a call from inside `canCollide`.
function class.checkCall(self, where)
  class.checkSelf(self, where)
  if self._bodies.asking then
    check.fail(where .. " cannot be called from inside canCollide")
  end
end

--- Refuses tables of objects that are none.
function class.checkObjects(self)
  if type(self.objects) ~= "table" then
    check.fail("objects must be a table of groups, got " .. check.show(self.objects))
  end
end

--- Refuses a group that is an object, or no table.
function class.checkIsGroup(self, group, where)
  local members = self.objects[group]
  if members ~= nil and (type(members) ~= "table" or type(members.width) == "number") then
    check.fail(
      where
        .. ": "
        .. check.place(group)
        .. " is not a group, got "
        .. (type(members) == "table" and "an object" or check.show(members))
    )
  end
end

--- Returns the table of a group, which is made if it is missing.
function class.groupFor(self, group)
  local members = self.objects[group]
  if members == nil then
    members = {}
    self.objects[group] = members
  end
  return members
end

-- Gives an object the fields that `add` promises. An object that was removed since the last update
-- still has a slot and keeps its `touching`: while it sleeps no step would write it again.
local function welcome(b, object)
  if not object.static and not object.kinematic then
    local slot = b.slotOf[object]
    local touching = slot and b.touching[slot] or read.touchingFor(b, object)
    object.vx, object.vy, object.touching = object.vx or 0, object.vy or 0, touching
    b.registry.given[object] = touching
  end
end

-- Reads an object again that was removed since the last update: the game may have changed it, also
-- in the fields that are read only once.
local function readAgain(b, object)
  local slot = b.slotOf[object]
  if slot and (object.static or b.kind[slot] == columns.STATIC) then
    read.refresh(b, slot)
  else
    notice.refresh(b, object)
  end
end

--- Puts a checked object at the end of a group. This comes last: an object that raises an error
--- when it is read or written has not been added.
function class.put(self, group, object)
  local b, size = self._bodies, check.sizeToFill(object)
  if size then
    object.width, object.height = size, size
  end
  welcome(b, object)
  readAgain(b, object)
  local members = class.groupFor(self, group)
  members[#members + 1] = object
  b.registry.groupGiven[object] = group
  notice.tell(b)
  return object
end

--- Returns where an object is now: the table that holds it, its key there, and the name of its
--- group. (And the key again, unless it is directly in `objects`.) Looks where the object was in
--- the last step, and where it was added; nil: it is in neither place.
function class.whereIs(self, object)
  local b = self._bodies
  local slot = b.slotOf[object]
  if slot then
    local members, key = registry.whereSeen(b, self.objects, slot)
    if members then
      local record = b.group[slot]
      return members, key, record.name, not record.direct and key or nil
    end
  end
  local group = b.registry.groupGiven[object]
  local members = group ~= nil and self.objects[group]
  if type(members) == "table" then
    local key = registry.find(members, object)
    if key ~= nil then
      return members, key, group, key
    end
  end
end

--- The same, but searches all groups: the game may have moved it since the last step.
function class.search(self, object)
  local members, key, name = class.whereIs(self, object)
  if members then
    return members, key, name
  end
  for group, value in next, self.objects, nil do
    if rawequal(value, object) then
      return self.objects, group, group
    elseif type(value) == "table" and type(value.width) ~= "number" then
      key = registry.find(value, object)
      if key ~= nil then
        return value, key, group
      end
    end
  end
end

--- Refuses an object that is not in the world. `name` is that of the argument, if it is another.
function class.failMissing(where, object, name)
  local why = type(object) == "table" and " (removed, or never added)" or ""
  check.fail(where .. ": " .. (name or "the object") .. " is not in the world" .. why)
end

--- Does the same as `search`. Errors: the object is no table, or not in the world.
function class.find(self, object, where)
  check.table(object, "object", where)
  class.checkObjects(self)
  local members, key, name = class.search(self, object)
  if not members then
    class.failMissing(where, object)
  end
  return members, key, name
end

--- Checks a filter, unless it is nil.
function class.checkFilter(self, filter, where)
  if filter ~= nil then
    check.filter(filter, where)
    if self.checked then
      guard.filter(self, filter, where)
    end
  end
end

--- Checks what queries have in common.
function class.checkQuestion(self, where, filter, out)
  class.checkSelf(self, where)
  class.checkFilter(self, filter, where)
  if out ~= nil and type(out) ~= "table" then
    check.table(out, "out", where)
  end
  if type(self.sideBySide) ~= "boolean" then
    check.setting("sideBySide", self.sideBySide)
  end
  if self.masks then
    check.setting("masks", self.masks)
  end
end

--- Checks two coordinates.
function class.checkPoint(x, y, where)
  check.number(x, "x", where)
  check.number(y, "y", where)
end

interpreted.always(class.search)

return class
