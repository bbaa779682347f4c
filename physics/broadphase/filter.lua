---@diagnostic disable
--- Filter: decides from kinds, `active`, sensors, masks and `hits` which objects can meet at all.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local constants = require(root .. ".memory.constants")
local forms = require(root .. ".fields.forms")

local filter = {}

local DYNAMIC, STATIC, max = constants.DYNAMIC, constants.STATIC, math.max
local OPPOSITE, SIDE = constants.OPPOSITE, constants.SIDE

--- Returns the record that the library keeps of a list of `hits`: `names`, a copy, and `has`, by
--- name. That is `known`, if it is the record of an equal list: objects in a row share it.
function filter.readHits(list, known)
  if known and forms.isSame(list, known.names) then
    return known
  end
  local read = { names = forms.copy(list), has = {} }
  for n = 1, #list do
    read.has[list[n]] = true
  end
  return read
end

--- Returns "mask", "hits" or "masks" if an object refuses another by its own mask or list, or by
--- the world's masks.
function filter.refusal(b, i, j)
  local hitsOnly = b.hitsOnly[i]
  if hitsOnly and not hitsOnly.has[b.groupName[j]] then
    return "hits"
  end
  local mask = b.mask[i]
  if mask and mask[b.groupName[j]] == false then
    return "mask"
  end
  local group = b.masks and b.masks[b.groupName[i]]
  if group and group[b.groupName[j]] == false then
    return "masks"
  end
end

--- Returns whether slot i or slot j is a sensor: the two press nothing.
function filter.isSensed(b, i, j)
  return b.sensor[i] or b.sensor[j]
end

local isSensed = filter.isSensed

--- Returns whether slots i and j, which meet on `side` of i, may pass through each other because
--- one of them is a one-way object.
function filter.isOpen(b, i, j, side)
  local one, other = b.oneWay[i], b.oneWay[j]
  return one and SIDE[one] ~= side or other and SIDE[other] ~= OPPOSITE[side]
end

--- Returns whether two objects are soft to each other: then they drift apart instead of colliding
--- (see drift). Static objects and sensors are soft to nothing.
function filter.isSoft(b, i, j)
  local row = b.soft and b.soft[b.groupName[i]]
  local isNamed = row and row[b.groupName[j]] ~= nil
  local canDrift = isNamed and b.kind[i] ~= STATIC and b.kind[j] ~= STATIC
  return canDrift and not isSensed(b, i, j)
end

--- Returns why two objects cannot meet (a word for `explain`), or nil if they can.
function filter.reason(b, i, j)
  local mostFree = max(b.kind[i], b.kind[j])
  if not (b.active[i] and b.active[j]) then
    return "inactive"
  end
  if mostFree == STATIC or mostFree < DYNAMIC and not isSensed(b, i, j) then
    return "immovable"
  elseif filter.isSoft(b, i, j) then -- most pairs in a crowd
    return "soft"
  elseif filter.refusal(b, i, j) or filter.refusal(b, j, i) then
    return "mask"
  end
end

--- Returns whether both slots are solid on all their sides.
function filter.areSolid(b, i, j)
  return not (isSensed(b, i, j) or b.oneWay[i] or b.oneWay[j])
end

--- Returns whether an object that is not dynamic, or any object (`isAny`), can be in the way of
--- another object: it is solid for that on every side.
function filter.blocks(b, i, j, isAny)
  local isSolid = not (isSensed(b, i, j) or b.oneWay[j])
  return isSolid and (isAny or b.kind[j] ~= DYNAMIC) and not filter.reason(b, i, j)
end

return filter
