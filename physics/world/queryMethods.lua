--- The methods of a world that only look.
--
-- They see the tables as they are now: objects that were added since the last update, but not
-- removed ones. They change nothing and may be called anywhere, also inside callbacks and filters.
-- In worlds of more than 128 objects the first query after an update looks at all objects, later
-- ones only nearby: see physics/queries/index.lua for what they may miss.
--
-- Inactive objects are not found; sensors are. `filter` is a group name, a list of them, or a
-- function(object) that returns yes or no; it must not change the world. `out` is a
-- list to fill instead of a new one, so that no garbage is made.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local carrier = require(root .. ".objects.carriers")
local check = require(root .. ".world.check")
local class = require(root .. ".world.class")
local lazy = require(root .. ".memory.lazy")

-- What is loaded when it is first used.
local explain = lazy(root .. ".world.explain")
local query = lazy(root .. ".queries.query")
local rays = lazy(root .. ".queries.rays")

---@class (partial) physics.World
local World = class.World

local isFinite = check.isFinite
local checkPoint, checkQuestion, failMissing =
  class.checkPoint, class.checkQuestion, class.failMissing

local function checkLine(x1, y1, x2, y2, where)
  -- A game may cast a thousand rays a frame: one test covers the usual case.
  if isFinite(x1) and isFinite(y1) and isFinite(x2) and isFinite(y2) then
    return
  end
  check.number(x1, "x1", where)
  check.number(y1, "y1", where)
  check.number(x2, "x2", where)
  check.number(y2, "y2", where)
end

--- Returns all objects at a point, and how many. The left and top edges of an object belong to it,
--- the right and bottom ones do not. So a point on a seam belongs to one tile.
---
--- Errors: a coordinate is not a finite number; the filter cannot be used; `out` is not a table.
---@param x number px
---@param y number px
---@param filter physics.Filter? which objects count, default all
---@param out physics.Object[]? list to fill, default a new one
---@return physics.Object[] objects in the order of the world
---@return integer count
function World:queryPoint(x, y, filter, out)
  local where = "world:queryPoint(x, y)"
  checkQuestion(self, where, filter, out)
  checkPoint(x, y, where)
  local found, count = query.point(self, x + 0.0, y + 0.0, filter, out)
  return found, count
end

--- Returns all objects that overlap a rectangle by more than 1e-6 px, and how many. With the
--- setting `sideBySide` objects that are flush with it count, too.
---
--- Errors: a number is not finite; a size is <= 0; the filter cannot be used; `out` is not a table.
---@param x number px, left edge
---@param y number px, top edge
---@param w number px, > 0
---@param h number px, > 0
---@param filter physics.Filter? which objects count, default all
---@param out physics.Object[]? list to fill, default a new one
---@return physics.Object[] objects in the order of the world
---@return integer count
function World:queryRect(x, y, w, h, filter, out)
  local where = "world:queryRect(x, y, w, h)"
  checkQuestion(self, where, filter, out)
  checkPoint(x, y, where)
  check.positive(w, "w", where)
  check.positive(h, "h", where)
  local found, count = query.rectangle(self, x + 0.0, y + 0.0, w + 0.0, h + 0.0, filter, out)
  return found, count
end

--- Returns all objects that overlap a circle by more than 1e-6 px, and how many: those of which a
--- point is nearer to the centre than the radius. With the setting `sideBySide` objects that are
--- flush with it count, too.
--- Source: the point of a box that is nearest to the centre.
---
--- Errors: a number is not finite; the radius is <= 0; the filter cannot be used; `out` is not a
--- table.
---@param x number px, the centre
---@param y number px
---@param radius number px, > 0
---@param filter physics.Filter? which objects count, default all
---@param out physics.Object[]? list to fill, default a new one
---@return physics.Object[] objects in the order of the world
---@return integer count
function World:queryCircle(x, y, radius, filter, out)
  local where = "world:queryCircle(x, y, radius)"
  checkQuestion(self, where, filter, out)
  checkPoint(x, y, where)
  check.positive(radius, "radius", where)
  local found, count = query.circle(self, x + 0.0, y + 0.0, radius + 0.0, filter, out)
  return found, count
end

--- Returns all objects on the line from (x1, y1) to (x2, y2), as `raycast` would hit them, and how
--- many.
---
--- Errors: a coordinate is not a finite number; the filter cannot be used; `out` is not a table.
---@param x1 number px
---@param y1 number px
---@param x2 number px
---@param y2 number px
---@param filter physics.Filter? which objects count, default all
---@param out physics.Object[]? list to fill, default a new one
---@return physics.Object[] objects nearest first, ties in the order of the world
---@return integer count
function World:querySegment(x1, y1, x2, y2, filter, out)
  local where = "world:querySegment(x1, y1, x2, y2)"
  checkQuestion(self, where, filter, out)
  checkLine(x1, y1, x2, y2, where)
  local found, count = rays.segment(self, x1 + 0.0, y1 + 0.0, x2 + 0.0, y2 + 0.0, filter, out)
  return found, count
end

--- Returns the first object on the line from (x1, y1) to (x2, y2), and where the line hits it.
---
---     starts inside an object     hits it at fraction 0, normal 0, 0
---     starts on an edge           hits at fraction 0 with its normal if it goes in, else not
---     ends on an edge             hits at fraction 1
---     runs along an edge          hits the object that owns the edge: the one below it or to its
---                                 right, so no ray slips between two tiles (to 1e-6 px)
---     meets a corner              of one object: no hit if it only grazes it; the normal is along
---                                 gravity, or that of the wall if a neighbour covers the other one
---     has no length               hits the object that queryPoint finds, fraction 0, normal 0, 0
---
--- Source: slab method; the grid is walked in strips (see physics/broadphase/grid.lua).
---
--- Errors: a coordinate is not a finite number; the filter cannot be used.
---@param x1 number px
---@param y1 number px
---@param x2 number px
---@param y2 number px
---@param filter physics.Filter? which objects count, default all
---@return physics.Object? object nil: the line is free, and nothing else is returned
---@return number x px, where it is hit
---@return number y px
---@return number nx normal where it is hit, of length 1: -1, 0, 1 at a box
---@return number ny likewise
---@return number fraction of the line, 0..1
function World:raycast(x1, y1, x2, y2, filter)
  local where = "world:raycast(x1, y1, x2, y2)"
  checkQuestion(self, where, filter)
  checkLine(x1, y1, x2, y2, where)
  -- (A tail call: the trace compiler would compile the code after it anew for each path.)
  ---@diagnostic disable-next-line: missing-return-value
  return rays.raycast(self, x1 + 0.0, y1 + 0.0, x2 + 0.0, y2 + 0.0, filter)
end

--- Returns what would stop an object on its way by (dx, dy), and where the object would be then.
--- Nothing moves. `sweep(object, 0, -10)` answers "may it grow by 10 px upwards?".
---
--- Solid objects stop it, unless its mask, theirs or the world's says otherwise; one-way objects
--- stop it on their solid side; sensors do not. `canCollide` is not called. An object that overlaps
--- it already is hit at fraction 0 with the normal 0, 0. An object that is flush beside its way is
--- not hit.
---
--- Errors: the object is not a table, or not in the world; a distance is not a finite number; the
--- filter cannot be used.
---@param object physics.NewObject the object that would move
---@param dx number px
---@param dy number px
---@param filter physics.Filter? which objects count, default all
---@return physics.Object? other nil: the way is free, and nothing else is returned
---@return number x px, where `object` would be then, flush
---@return number y px
---@return number nx normal where it is hit, of length 1: -1, 0, 1 on a side of a box
---@return number ny likewise
---@return number fraction of the way, 0..1
function World:sweep(object, dx, dy, filter)
  local where = "world:sweep(object, dx, dy)"
  checkQuestion(self, where, filter)
  check.table(object, "object", where)
  check.number(dx, "dx", where)
  check.number(dy, "dy", where)
  local other, x, y, nx, ny, fraction = query.sweep(self, object, dx + 0.0, dy + 0.0, filter)
  if other then
    return other, x, y, nx, ny, fraction
  elseif x == false then
    failMissing(where, object)
  end
end ---@diagnostic disable-line: missing-return

--- Returns whether a box of that place and size would be free: may it stand up here, is there room
--- to appear? Solid objects are in the way, if they overlap the box by more than 1e-6 px. Sensors,
--- one-way objects and inactive objects are not.
---
--- In place of the filter you may give the object that would be there. Then it is not in its own
--- way, nor is what its mask, theirs or the world's lets it pass.
---
--- Errors: a number is not finite; a size is <= 0; the filter cannot be used, or is an object that
--- is not in the world.
---@param x number px, left edge
---@param y number px, top edge
---@param width number px, > 0
---@param height number px, > 0
---@param filter physics.Filter|physics.NewObject|nil which objects count, default all; or the
---  object that would be there
---@return boolean fits
---@return physics.Object? other what is in the way, the first in the order of the world
function World:fits(x, y, width, height, filter)
  local where = "world:fits(x, y, width, height)"
  local isObject = type(filter) == "table" and type(filter.width) == "number"
  checkQuestion(self, where, not isObject and filter or nil)
  checkPoint(x, y, where)
  check.positive(width, "width", where)
  check.positive(height, "height", where)
  local w, h = width + 0.0, height + 0.0
  local other, isThere = query.blocker(self, x + 0.0, y + 0.0, w, h, filter)
  if not isThere then
    failMissing(where, filter, "the object in place of the filter")
  end
  return not other, other or nil
end

--- Returns the velocity of an object over ground. For a rider it is its own velocity and that of
--- its carrier; for a kinematic object that you move by writing `x, y` it is how fast it went in
--- the last step. Of a static object it is 0, 0.
---
--- Errors: the object is not a table, or not in the world.
---@param object physics.NewObject the object
---@return number vx px/s
---@return number vy px/s
function World:velocity(object)
  local where = "world:velocity(object)"
  checkQuestion(self, where)
  class.find(self, object, where)
  local slot = self._bodies.slotOf[object]
  if not slot then
    return object.static and 0 or object.vx or 0, object.static and 0 or object.vy or 0
  end
  local vx, vy = carrier.overGround(self._bodies, slot)
  return vx, vy
end

--- Returns the object nearest to a point, and its distance. Of two at the same distance it is the
--- first in the order of the world.
---
--- Errors: a number is not finite; the radius is < 0; the filter cannot be used.
---@param x number px
---@param y number px
---@param radius number px, >= 0: how far it looks
---@param filter physics.Filter? which objects count, default all
---@return physics.Object? object nil: there is none
---@return number distance px, from the point to the edge, 0: inside
function World:nearest(x, y, radius, filter)
  local where = "world:nearest(x, y, radius)"
  checkQuestion(self, where, filter)
  checkPoint(x, y, where)
  check.number(radius, "radius", where, 0)
  local object, distance = query.nearest(self, x + 0.0, y + 0.0, radius + 0.0, filter)
  if object then
    return object, distance
  end
end ---@diagnostic disable-line: missing-return

--- Returns all objects that overlap an object by more than 1e-6 px, and how many; masks play no
--- part. An object with a `radius` is the circle, not its square. With the setting `sideBySide`
--- objects that are flush with it count, too. An inactive object overlaps nothing.
---
--- Test the number, `count > 0`: an empty list is true in Lua. Removing objects while you loop over
--- the list is safe.
---
--- Errors: the object is not a table, or not in the world; the filter cannot be used; `out` is not
--- a table.
---@param object physics.NewObject an object of the world
---@param filter physics.Filter? which objects count, default all
---@param out physics.Object[]? list to fill, default a new one
---@return physics.Object[] objects in the order of the world, without `object`
---@return integer count
function World:overlapping(object, filter, out)
  local where = "world:overlapping(object)"
  checkQuestion(self, where, filter, out)
  check.table(object, "object", where)
  local found, count = query.overlapping(self, object, filter, out)
  if not found then
    failMissing(where, object)
  end
  return found, count
end

--- Returns the side of `a` at which it is in contact with `b`. A contact lasts from `onBegin` to
--- `onEnd`, unless the game has moved the two apart since. With the setting `sideBySide` flush
--- objects are in contact.
---
--- Errors: `a` or `b` is not a table, or not in the world.
---@param a physics.NewObject one of the two
---@param b physics.NewObject the other one
---@return physics.Side? side of `a`, nil: no contact
function World:touching(a, b)
  local where = "world:touching(a, b)"
  checkQuestion(self, where)
  check.table(a, "a", where)
  check.table(b, "b", where)
  local side, missing = explain.touching(self, a, b)
  if missing then
    failMissing(where, missing == "a" and a or b, missing)
  end
  return side
end

--- Returns a sentence that says why two objects do or do not collide. It is for debugging: the
--- words may change.
---
--- Errors: `a` or `b` is not a table.
---@param a physics.NewObject one of the two
---@param b physics.NewObject the other one
---@return string sentence
function World:explain(a, b)
  local where = "world:explain(a, b)"
  checkQuestion(self, where)
  check.table(a, "a", where)
  check.table(b, "b", where)
  local sentence = explain.run(self, a, b)
  return sentence
end

return World
