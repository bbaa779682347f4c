--- Checks the settings of a world and puts changes into effect at the beginning of a step. Settings
--- are plain fields that the game may change between two updates.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".world.check")
local read = require(root .. ".objects.read")
local detect = require(root .. ".broadphase.pairFinder")
local events = require(root .. ".contacts.events")
local fields = require(root .. ".world.fields")
local grid = require(root .. ".broadphase.grid")
local lazy = require(root .. ".memory.lazy")
local rest = require(root .. ".sleep.islands")

local allPairs = lazy(root .. ".broadphase.allPairs") -- loaded when it is first used

local interpreted = require(root .. ".memory.jit")
interpreted.file()

local settings = {}

local NONE = {} -- the mask of a group that has none
local BROADPHASES = { auto = grid, grid = grid, pairs = allPairs }

-- By name of a setting: what a change of it does.
local effects = {}

local function newGravity(self, b)
  -- Adding 0.0 turns the integers of Lua 5.3 and later into floats: squares of integers would wrap.
  b.gravityX, b.gravity = self.gravityX + 0.0, self.gravity + 0.0
  -- The axis that counts as "down" for the order of simultaneous contacts.
  local vertical = b.gravityX * b.gravityX <= b.gravity * b.gravity
  b.downAxis = vertical and 1 or 0
  local down = (vertical and b.gravity or b.gravityX) < 0 and -1 or 1
  b.orientation[b.downAxis] = down
  b.orientation[1 - b.downAxis] = vertical and down or -down
  read.newGravity(b)
end

local function newBroadphase(self, b)
  local old = b.broadphase
  local new = BROADPHASES[self.broadphase].new(b, self.cellSize)
  b.broadphase = new
  for n = 1, old and old.count or 0 do
    new:insert(old.list[n])
  end
end

effects.gravity, effects.gravityX = newGravity, newGravity
effects.broadphase, effects.cellSize = newBroadphase, newBroadphase

function effects.push(self, b)
  b.pushFirst = self.push == "first"
  rest.wakeAll(b)
end

function effects.sideBySide(self, b)
  b.sideBySide = self.sideBySide
  rest.wakeAll(b)
end

function effects.rest(self, b)
  b.rest = self.rest
  rest.wakeAll(b)
end

function effects.profile(self)
  local isTimed = self.profile ~= nil
  self.stats.times = isTimed and { read = 0, separate = 0, move = 0, solve = 0, write = 0 } or nil
end

function effects.onStay(_, b)
  rest.wakeAll(b)
end

function effects.canCollide(self, b)
  b.worldCanCollide = self.canCollide or false
  b.hasAskers = b.hasAskers or b.worldCanCollide ~= false
  rest.wakeAll(b)
end

function effects.order(self, b)
  b.registry.order = self.order or {}
  b.registry.reorder = true
end

-- What can meet what has changed.
local function refilter(b)
  rest.wakeAll(b)
  for i = 1, b.slots do
    if b.kind[i] ~= 0 then
      events.endForbidden(b, i)
    end
  end
  detect.refilterAll(b)
  rest.wakeAll(b)
  b.isRemasked = true
end

function effects.masks(self, b)
  b.masks = self.masks or false
  refilter(b)
end

local function copyRows(given)
  local copy = {}
  for group, row in next, given, nil do
    copy[group] = {}
    for other, speed in next, row, nil do
      copy[group][other] = speed
    end
  end
  return copy
end

-- A copy of `soft` in which each of two groups names the other one.
local function mirror(given)
  local copy = {}
  for group, row in next, given, nil do
    for other, speed in next, row, nil do
      copy[group], copy[other] = copy[group] or {}, copy[other] or {}
      local most = copy[group][other] or 0
      if speed + 0.0 >= most then
        copy[group][other], copy[other][group] = speed + 0.0, speed + 0.0
      end
    end
  end
  return next(copy) ~= nil and copy or false
end

-- Whether one table of rows says something that the other one does not.
local function differs(rows, others)
  for group, row in next, rows, nil do
    local other = others[group] or NONE
    for name, speed in next, row, nil do
      if other[name] ~= speed then
        return true
      end
    end
  end
  return false
end

-- Takes over what is soft to what, which may have changed inside the same tables.
local function applySoft(self, b)
  local soft = self.soft or NONE
  if differs(soft, b.softSeen) or differs(b.softSeen, soft) then
    b.softSeen, b.soft = copyRows(soft), mirror(soft)
    refilter(b)
  end
end

-- Writes into a row what a mask says of each group, by the number of the group. Returns whether
-- that has changed.
local function hasRowChanged(groups, mask, row)
  local changed = false
  for n = 1, #groups do
    local refuses, number = mask[groups[n].name] == false, groups[n].number
    if refuses ~= (row[number] or false) then
      row[number], changed = refuses, true
    end
  end
  return changed
end

-- Returns what was seen of groups that are still in the world.
local function withoutGone(groups, seen)
  local kept = {}
  for m = 1, #groups do
    local number = groups[m].number
    local row = seen[number]
    kept[number] = row and {}
    for n = 1, row and #groups or 0 do
      kept[number][groups[n].number] = row[groups[n].number]
    end
  end
  return kept
end

-- Returns whether the masks say something else than when they were last read: the game may change
-- them inside the same table. Masks of groups that are not in the world count for nothing yet.
local function haveMasksChanged(b, masks)
  local groups, seen, changed = b.registry.groups, b.masksSeen, false
  if not seen then -- never read, or forgotten by `restore`
    seen, changed = {}, true
  elseif seen[0] ~= b.registry.numbers then
    seen = withoutGone(groups, seen)
  end
  seen[0], b.masksSeen = b.registry.numbers, seen
  for n = 1, #groups do
    local mask, row = masks[groups[n].name], seen[groups[n].number]
    if mask or row then -- most have none
      row = row or {}
      seen[groups[n].number] = row
      changed = hasRowChanged(groups, mask or NONE, row) or changed
    end
  end
  return changed
end

--- Gives a new world its settings: those given, defaults for the rest.
function settings.fill(self, given)
  local b = self._bodies
  for _, field in ipairs(fields.settings) do
    local value = given and given[field.name]
    if value == nil then
      value = field.default
    end
    self[field.name] = value
  end
  b.applied = {}
  b.masksSeen, b.soft, b.softSeen = false, false, NONE
  b.orientation = {}
  settings.apply(self)
end

--- Checks the settings that changed since the last step and puts them into effect.
--- Errors: a value that cannot be used; nothing has changed then.
function settings.apply(self)
  local b, list = self._bodies, fields.settings
  local applied = b.applied
  local changed = false
  for n = 1, #list do
    local name = list[n].name
    local value = self[name]
    if value ~= applied[name] then
      check.setting(name, value)
      changed = true
    end
  end
  if self.masks then
    check.setting("masks", self.masks)
    if haveMasksChanged(b, self.masks) then
      effects.masks(self, b)
    end
  end
  if self.soft or b.soft then
    check.setting("soft", self.soft)
    applySoft(self, b)
  end
  if not changed then
    return
  end
  for n = 1, #list do
    local name = list[n].name
    local value = self[name]
    if value ~= applied[name] then
      applied[name] = value
      if effects[name] then
        effects[name](self, b)
      end
    end
  end
end

interpreted.always(copyRows, mirror, differs)

return settings
