--- The methods of a world that add, remove, move and push objects.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".world.check")
local class = require(root .. ".world.class")
local lazy = require(root .. ".memory.lazy")
local notice = require(root .. ".queries.notice")
local oneway = require(root .. ".solver.oneWay")
local read = require(root .. ".objects.read")
local rest = require(root .. ".sleep.islands")
local slope = require(root .. ".memory.lazy")(root .. ".solver.slope")

-- What is loaded when it is first used.
local bounds = lazy(root .. ".world.bounds")
local explosion = lazy(root .. ".world.explosion")
local shift = lazy(root .. ".objects.shift")
local slide = lazy(root .. ".queries.move")

---@class (partial) physics.World
local World = class.World

local checkCall, checkObjects = class.checkCall, class.checkObjects
local checkPoint, checkQuestion = class.checkPoint, class.checkQuestion
local failMissing, search, whereIs = class.failMissing, class.search, class.whereIs

-- Checks an object. Only if it cannot be used, the text of its place is made.
local function checkNew(self, group, object)
  local size = check.sizeToFill(object)
  if check.badField(object, size) then
    local known = self.objects[group]
    local n = type(known) == "table" and #known or 0
    check.object(object, check.place(group, n + 1), size)
  end
end

--- Puts an object at the end of a group and returns it. A group that does not exist is made.
---
--- It does the same as `table.insert(world.objects[group], object)`, and more. It checks the fields
--- at once and gives a dynamic object its `vx`, `vy` and `touching`. An object that was removed
--- since the last update is read again.
---
--- Errors: the group is not a string or a number; the object is not a table; a field has a value
--- that cannot be used; the object is already in the world. Nothing has changed then. (An object
--- that you put in by hand since the last update is found by the next update: "the same object
--- as".)
---@param group string|number name of the group
---@param object physics.NewObject your own table: x, y, width, height and any other fields
---@return physics.Object object the same table
function World:add(group, object)
  local where = "world:add(group, object)"
  checkCall(self, where)
  if type(group) == "table" and type(object) == "number" then
    check.fail(
      "world:add(group, object): the place is a part of the object, as in"
        .. ' world:add("boxes", { x = 0, y = 0, width = 16, height = 16 })'
    )
  end
  check.group(group, where)
  check.table(object, "object", where)
  checkObjects(self)
  checkNew(self, group, object)
  local found, _, name, key = whereIs(self, object)
  if found then
    check.fail("world:add(group, object): the object already stands at " .. check.place(name, key))
  end
  class.checkIsGroup(self, group, where)
  return class.put(self, group, object)
end

--- Takes an object out of the world, that is out of its group's table. Its contacts end with
--- `onEnd` at the next update. An object that is added again before that update has never been
--- away.
---
--- Later objects of the group move up one place, as with `table.remove`. Inside a loop go
--- backwards, `for i = #group, 1, -1 do`, or loop over the list that a query returns. A forward
--- `ipairs` over the group would skip the object after each removed one.
---
--- Errors: the object is not a table.
---@param object physics.NewObject the object to remove
---@return boolean removed false: it was not in the world
function World:remove(object)
  local where = "world:remove(object)"
  checkCall(self, where)
  check.table(object, "object", where)
  checkObjects(self)
  local members, key = search(self, object)
  if not members then
    return false
  end
  local isNumbered = members ~= self.objects and type(key) == "number"
  if isNumbered and key >= 1 and key <= #members and key % 1 == 0 then
    table.remove(members, key)
  else
    members[key] = nil
  end
  self._bodies.registry.groupGiven[object] = nil
  notice.tell(self._bodies)
  return true
end

--- Reads an object again, also the fields that are read only once: `static`, and all fields of a
--- static object. Call it after changing one of these by hand. Queries see the change at once.
---
--- On a kinematic object it also means "it is there now": without `refresh` an object gets to
--- the `x, y` that you write during the next step, and pushes what is in its way.
---
--- Errors: the object is not a table, or not in the world; a field has a value that cannot be used.
---@param object physics.NewObject the object that you changed
function World:refresh(object)
  local where = "world:refresh(object)"
  checkCall(self, where)
  local b = self._bodies
  local members, key, name = class.find(self, object, where)
  local slot = b.slotOf[object]
  if slot then
    read.refresh(b, slot)
  else
    check.object(object, check.place(name, members ~= self.objects and key or nil))
    notice.refresh(b, object)
  end
end

--- Lets an object fall through the one-way objects that it stands on. It passes through them until
--- it is clear of them. Until then no other one-way object holds it, so it falls through a whole
--- bridge of planks or slopes. If it also stands on something solid, it stays there, although the
--- result is true; it passes through the one-way objects when it leaves the solid one.
---
--- Errors: the object is not a table, or not in the world.
---@param object physics.NewObject the object that stands on them
---@return boolean dropped false: it stands on no one-way object
function World:dropThrough(object)
  local where = "world:dropThrough(object)"
  checkCall(self, where)
  local b = self._bodies
  class.find(self, object, where)
  local slot = b.slotOf[object]
  if not slot or not oneway.drop(b, slot) then
    return false
  end
  rest.wake(b, slot)
  return true
end

--- Returns what an object stands on, as the last step has left it, and how steep that is under it:
--- for a sprite that turns with the ground, `math.atan(gradient)`.
---
--- The gradient is in px along y for each px along x: -0.5 on a slope that rises to the right by 1
--- px in 2, 0 on everything that is level. Where gravity acts sideways it is px along x for each px
--- along y.
---
--- Errors: the object is not a table, or not in the world.
---@param object physics.NewObject a dynamic object
---@return physics.NewObject? ground nil: it stands on nothing
---@return number gradient
function World:ground(object)
  local where = "world:ground(object)"
  class.checkSelf(self, where)
  local b = self._bodies
  class.find(self, object, where)
  local slot = b.slotOf[object]
  local below = slot and b.support[slot] or 0
  if below == 0 then
    return nil, 0
  end
  return b.object[below], slope.gradient(b, slot, below)
end

-- Moving by hand ----------------------------------------------------------------------------------

---@alias physics.Filter string|number|(string|number)[]|fun(object: physics.Object): any
---@alias physics.Response "slide"|"touch"|"cross"|"bounce"
---@alias physics.Responses physics.Response|false|nil
---@alias physics.Respond fun(object: physics.Object, other: physics.Object): physics.Responses
---@class physics.Hit
---@field other physics.Object the object that was hit
---@field side physics.Side side of the object that moved
---@field x number px, where the object was then
---@field y number px
---@field nx number normal of `other`, of length 1: -1, 0, 1 where a box is hit on a side
---@field ny number likewise
---@field fraction number of the way asked for, 0..1
---@field response physics.Response how the move went on

--- Moves one object to (x, y) now, with collisions and without physics. It writes `object.x` and
--- `object.y`, pushes nothing and changes no velocity.
---
--- Static, kinematic and dynamic objects are in its way. Masks, `active` and `oneWay` hold as in a
--- step; `canCollide` is not called. The object never ends inside a solid one, unless it was inside
--- that one before: an object that it overlaps at the start is reported and crossed.
---
---     "slide"    goes on along the side that it hit (default)
---     "touch"    stays where it hit
---     "cross"    goes through
---     "bounce"   goes on mirrored
---
--- The response may be a function(object, other) that returns one of these names for each hit (nil:
--- "slide"), or false, as if `other` were not there. It must not change the world. Sensors are
--- crossed whatever the response. An inactive object moves without collisions. The move ends after
--- 64 hits.
--- Source: the responses are those of bump.lua (E. García Cota).
---
--- Errors: the object is not a table, not in the world, or static; a number is not finite; the
--- response is unknown; it is called from inside `canCollide`. Nothing has moved then.
---@param object physics.NewObject dynamic or kinematic
---@param x number px, left edge where it should go
---@param y number px, top edge
---@param response physics.Response|physics.Respond|nil default "slide"
---@param out physics.Hit[]? list of an earlier call, which is filled again
---@return number x px, where it is now
---@return number y px
---@return physics.Hit[] hits in the order in which they happened
---@return integer count
function World:move(object, x, y, response, out)
  local where = "world:move(object, x, y)"
  checkQuestion(self, where, nil, out)
  checkCall(self, where)
  check.table(object, "object", where)
  checkPoint(x, y, where)
  slide.check(response, where)
  local atX, atY, hits, count = slide.run(self, object, x, y, response, out, where)
  if atX == nil then
    failMissing(where, object)
  elseif atX == false then
    check.fail(where .. ": object must not be static (write x, y and call world:refresh(object))")
  end
  return atX, atY, hits, count
end

local PUSHED = { "vx", "vy", "mass" }

--- Changes the velocity of a dynamic object by the impulse divided by its mass. A speed limit of
--- the object (`maxSpeed`, `maxSpeedX`, `maxSpeedY`) cuts the new velocity in the next step.
---
--- Errors: the object is not a table, not in the world, or not dynamic; a number is not finite; its
--- `vx`, `vy` or `mass` cannot be used; it is called from inside `canCollide`.
---@param object physics.NewObject a dynamic object
---@param ix number px/s times mass, along x
---@param iy number px/s times mass, along y
function World:impulse(object, ix, iy)
  local where = "world:impulse(object, ix, iy)"
  checkCall(self, where)
  check.table(object, "object", where)
  check.number(ix, "ix", where)
  check.number(iy, "iy", where)
  checkObjects(self)
  if not search(self, object) then
    failMissing(where, object)
  elseif object.static or object.kinematic then
    local kind = object.static and "static" or "kinematic"
    check.fail(where .. ": object must be dynamic, got a " .. kind .. " one")
  end
  check.fields(object, where .. ": object", PUSHED)
  local mass = object.mass or 1
  local vx, vy = (object.vx or 0) + ix / mass, (object.vy or 0) + iy / mass
  check.number(vx, "vx after it", where)
  check.number(vy, "vy after it", where)
  object.vx, object.vy = vx, vy
end

--- Moves the whole world by (dx, dy): every object, active or not, and the tiles of its maps. No
--- callback is called, and riders, contacts and velocities stay as they are. So a level may wrap
--- around, or the player stay near the origin. Move your camera by the same way.
---
--- The coordinates are sums, so they round: choose a whole number of px. A state that was saved
--- before belongs to the old place.
---
--- Errors: a number is not finite; an object would be too far away, or has a field that cannot be
--- used (nothing has moved then); it is called from inside `canCollide`.
---@param dx number px
---@param dy number px
function World:shift(dx, dy)
  local where = "world:shift(dx, dy)"
  checkCall(self, where)
  check.number(dx, "dx", where)
  check.number(dy, "dy", where)
  checkObjects(self)
  shift.run(self, dx, dy)
end

--- Pushes all dynamic objects in a circle away from its centre, also sensors. At the centre an
--- object gets the whole impulse, at the rim nothing; in between it is less with the distance of
--- the nearest point of the object. The push is towards the middle of the object, or straight up
--- if that is the centre.
---
--- With `walls` only objects in sight are pushed: those that nothing of `walls` hides from the
--- centre. It is a filter as for `raycast`, for instance the name of a group. Inside a wall an
--- explosion pushes only that wall, if it is dynamic.
---
--- Errors: a number is not finite; the radius is <= 0; a filter cannot be used; `vx`, `vy` or
--- `mass` of an object cannot be used; it is called from inside `canCollide`. Nothing has changed
--- then.
---@param x number px, the centre
---@param y number px
---@param radius number px, > 0
---@param impulse number px/s times mass, at the centre; < 0: towards the centre
---@param filter physics.Filter? which objects are pushed, default all
---@param walls physics.Filter? what is in the way, default nothing
---@return physics.Object[] objects those that were pushed, in the order of the world
---@return integer count
function World:explode(x, y, radius, impulse, filter, walls)
  local where = "world:explode(x, y, radius, impulse)"
  checkQuestion(self, where, filter)
  checkCall(self, where)
  checkPoint(x, y, where)
  check.positive(radius, "radius", where)
  check.number(impulse, "impulse", where)
  class.checkFilter(self, walls, where .. ": walls")
  x, y, radius, impulse = x + 0.0, y + 0.0, radius + 0.0, impulse + 0.0
  local pushed, count = explosion.run(self, x, y, radius, impulse, filter, walls, where)
  return pushed, count
end

--- Puts four static walls around a rectangle: `top`, `bottom`, `left` and `right` of the group
--- `bounds`. You may give them `friction` and other fields before the next update. A second call
--- replaces the walls; a call without arguments removes them.
---
--- The lower wall is a floor. A level with pits needs a rectangle that is higher than the level, so
--- that the player falls out of sight. Filters and masks that name only your own walls leave
--- `bounds` out.
---
--- Errors: a number is not finite; a size is <= 0; the game uses one of these names for something
--- else; it is called from inside `canCollide`.
---@param x number? px, inner left edge; nil: no bounds
---@param y number? px, inner top edge
---@param w number? px, > 0
---@param h number? px, > 0
function World:setBounds(x, y, w, h)
  local where = "world:setBounds(x, y, w, h)"
  checkCall(self, where)
  if x ~= nil or y ~= nil or w ~= nil or h ~= nil then
    checkPoint(x, y, where)
    check.positive(w, "w", where)
    check.positive(h, "h", where)
  end
  self._walls = bounds.set(self.objects, self._walls, x, y, w, h)
  notice.tell(self._bodies)
end

return World
