---@meta _
--- The types of this library for editors (LuaLS, EmmyLua). Nothing requires this file.
--- Written by scripts/types.lua from physics/world/fields.lua and physics/world/world.lua: change those.

---@alias physics.Side "left"|"right"|"top"|"bottom"

--- A rectangle: left edge, top edge and size, in px. Fields of the game's own may stand beside.
---@class physics.Box
---@field x number px, the left edge
---@field y number px, the top edge; y grows downwards
---@field width number px, > 0
---@field height number px, > 0
---@field [string|number] any

--- What a dynamic object touches on each side: the neighbour with the widest common edge, or false.
---@class physics.Touching
---@field top physics.Object|false
---@field bottom physics.Object|false
---@field left physics.Object|false
---@field right physics.Object|false

--- What a game gives to `add`, or puts into a group: a table of its own.
---@class physics.NewObject: physics.Box
--- px/s, default 0. The velocity along x; relative to what carries it, for a rider.
---@field vx? number
--- px/s, default 0. The velocity along y, downwards; relative to what carries it, for a rider.
---@field vy? number
--- px/s², default 0. A constant acceleration along x: an engine, wind, a magnet.
---@field ax? number
--- px/s², default 0. A constant acceleration along y, on top of gravity.
---@field ay? number
--- default false. It never moves; read once when it is first seen, `refresh` reads it again.
---@field static? boolean
--- default false. It moves by its own velocity or by the game writing x and y, pushes, is never
--- pushed and feels no gravity.
---@field kinematic? boolean
--- default true. `false` takes it out: no motion, no contacts, no queries.
---@field active? boolean
--- default false. It reports contacts, is never bumped and bumps nobody.
---@field sensor? boolean
--- default true. `false`: other objects cannot push it, walls still stop it.
---@field pushable? boolean
--- > 0, default 1. Its weight in the sharing of pushes and momentum; only ratios matter.
---@field mass? number
--- px/s², default the world's. Replaces the world's downward gravity for this object; 0 floats.
---@field gravity? number
--- px/s², default the world's. Replaces the world's sideways gravity for this object.
---@field gravityX? number
--- >= 0, default 0; static and kinematic: the other object's. The Coulomb coefficient of rubbing; a
--- pair uses the square root of the product.
---@field friction? number
--- 0..1, default 0. The bounciness, 0 none, 1 all of it; a pair uses the larger one.
---@field restitution? number
--- 1/s, >= 0, default 0. Damping: the speed falls as e^(-k t), the same at any frame rate.
---@field airFriction? number
--- px/s², >= 0, default 0. A constant deceleration towards 0, as on a floor seen from above.
---@field drag? number
--- px/s, >= 0, default none. The limit of the speed, that is of the length of the velocity.
---@field maxSpeed? number
--- px/s, >= 0, default none. The limit of the speed along x, in both directions.
---@field maxSpeedX? number
--- px/s, >= 0, default none. The limit of the speed along y, in both directions.
---@field maxSpeedY? number
--- default collides with every group. `mask[group] = false` passes through that group; either side
--- of a pair may refuse.
---@field mask? table<string|number, boolean>
--- default none: solid all around. The one side that is solid; the others let everything through,
--- floors included: it is for static and kinematic objects.
---@field oneWay? "top"|"bottom"|"left"|"right"
--- default true. A kinematic object takes its riders along; `false`: it slides away under them.
---@field carry? boolean
--- px/s, default 0. A conveyor: what stands on it is moved along x at this speed; along y where
--- gravity acts sideways.
---@field surfaceSpeed? number
--- px, >= 0, default 0. Corner correction: a hit that misses by at most this much slides around the
--- corner; who lands on an edge is never moved off it.
---@field nudge? number
--- default none. Called once when a contact starts; side is the side of self that was hit, speed
--- the approach speed in px/s.
---@field onBegin? fun(self: physics.Object, other: physics.Object, side: physics.Side, speed: number)
--- default none. Called at every further step of a contact; dt is the length of that step in s.
---@field onStay? fun(self: physics.Object, other: physics.Object, side: physics.Side, dt: number)
--- default none. Called once when a contact ends, also when one of the two is removed or
--- deactivated.
---@field onEnd? fun(self: physics.Object, other: physics.Object, side: physics.Side)
--- default none. Called once when self is held between a and b, which cannot give way; axis is "x"
--- or "y".
---@field onCrush? fun(self: physics.Object, a: physics.Object, b: physics.Object, axis: "x"|"y")
--- default always. Asked before a contact: `false` lets the pair pass through for this step; it
--- must not change the world.
---@field canCollide? fun(self: physics.Object, other: physics.Object, side: physics.Side): boolean?

--- An object in a world. `vx`, `vy` and `touching` are there when it is dynamic.
---@class physics.Object: physics.NewObject
--- px/s, default 0. The velocity along x; relative to what carries it, for a rider.
---@field vx number
--- px/s, default 0. The velocity along y, downwards; relative to what carries it, for a rider.
---@field vy number
--- What a dynamic object touches: top, bottom, left and right, each the other object or false; also
--- one that was hit in the last update and left again in it.
---@field touching physics.Touching

--- What `newWorld` and `load` take.
---@class physics.Settings
--- px/s², default 9.81 * 64. The downward acceleration of everything that moves, for 64 px to the
--- metre.
---@field gravity? number
--- px/s², default 0. The sideways acceleration of everything that moves.
---@field gravityX? number
--- default "both". Who gives way: both of a pair by inverse mass, or only the object that ran into
--- the other.
---@field push? "both"|"first"
--- default every group collides with every group. Groups that pass through each other: `masks = {
--- bullets = { players = false } }`.
---@field masks? table<string|number, table<string|number, boolean>>
--- default false. Whether flush neighbours that never pressed each other count as colliding: in
--- events, `touching`, `queryRect`, `overlapping` and `checkCollision`.
---@field sideBySide? boolean
--- default "auto". How pairs that may meet are found, all with the same result to the bit; `auto`
--- is the grid.
---@field broadphase? "auto"|"pairs"|"grid"
--- px, > 0, default 48. The width and height of the smallest cells of the grid: most objects should
--- fit into one, with some 10 px to spare. Larger ones stand in larger cells.
---@field cellSize? number
--- s, 1e-05..0.25, default none: a step is as long as dt. A fixed step: `update` saves up dt and
--- makes as many of them as fit.
---@field timestep? number
--- s, 1e-05..0.25, default 1 / 30. The longest single step; a longer dt is split, but a `timestep`
--- is one step.
---@field maxStep? number
--- default numbers ascending, then strings. Group names from first to last; those that are not
--- listed follow in usual order.
---@field order? (string|number)[]
--- default true. Whether objects whose step would change nothing are skipped; the result is the
--- same to the bit.
---@field rest? boolean
--- default false. Whether every step also looks for what is easily done wrong: a static object
--- changed without `refresh`, a misspelled field, an object in two worlds; for a game that is being
--- written.
---@field checked? boolean
--- default nothing is timed. A clock that returns seconds, as `os.clock` or `love.timer.getTime`:
--- with one, `stats` tells how long the stages of the last step have taken.
---@field profile? fun(): number
--- default none. Called before every step, of dt s: the place for controllers where an update makes
--- several steps (`timestep`, a long dt) or none. What it writes counts in that step.
---@field onStep? fun(dt: number)
--- default none. Called once when a contact starts, a before b in order; side is the side of a.
---@field onBegin? fun(a: physics.Object, b: physics.Object, side: physics.Side, speed: number)
--- default none. Called at every further step of a contact; dt is the length of that step in s.
---@field onStay? fun(a: physics.Object, b: physics.Object, side: physics.Side, dt: number)
--- default none. Called once when a contact ends.
---@field onEnd? fun(a: physics.Object, b: physics.Object, side: physics.Side)
--- default none. Called once when an object is held between a and b, which cannot give way.
---@field onCrush? fun(object: physics.Object, a: physics.Object, b: physics.Object, axis: "x"|"y")
--- default always. Asked before every contact: `false` lets the pair pass through for this step; it
--- must not change the world.
---@field canCollide? fun(a: physics.Object, b: physics.Object, side: physics.Side): boolean?

--- The settings as fields of a world: they may change between two updates.
---@class physics.WorldSettings
--- px/s², default 9.81 * 64. The downward acceleration of everything that moves, for 64 px to the
--- metre.
---@field gravity number
--- px/s², default 0. The sideways acceleration of everything that moves.
---@field gravityX number
--- default "both". Who gives way: both of a pair by inverse mass, or only the object that ran into
--- the other.
---@field push "both"|"first"
--- default every group collides with every group. Groups that pass through each other: `masks = {
--- bullets = { players = false } }`.
---@field masks? table<string|number, table<string|number, boolean>>
--- default false. Whether flush neighbours that never pressed each other count as colliding: in
--- events, `touching`, `queryRect`, `overlapping` and `checkCollision`.
---@field sideBySide boolean
--- default "auto". How pairs that may meet are found, all with the same result to the bit; `auto`
--- is the grid.
---@field broadphase "auto"|"pairs"|"grid"
--- px, > 0, default 48. The width and height of the smallest cells of the grid: most objects should
--- fit into one, with some 10 px to spare. Larger ones stand in larger cells.
---@field cellSize? number
--- s, 1e-05..0.25, default none: a step is as long as dt. A fixed step: `update` saves up dt and
--- makes as many of them as fit.
---@field timestep? number
--- s, 1e-05..0.25, default 1 / 30. The longest single step; a longer dt is split, but a `timestep`
--- is one step.
---@field maxStep number
--- default numbers ascending, then strings. Group names from first to last; those that are not
--- listed follow in usual order.
---@field order? (string|number)[]
--- default true. Whether objects whose step would change nothing are skipped; the result is the
--- same to the bit.
---@field rest boolean
--- default false. Whether every step also looks for what is easily done wrong: a static object
--- changed without `refresh`, a misspelled field, an object in two worlds; for a game that is being
--- written.
---@field checked boolean
--- default nothing is timed. A clock that returns seconds, as `os.clock` or `love.timer.getTime`:
--- with one, `stats` tells how long the stages of the last step have taken.
---@field profile? fun(): number
--- default none. Called before every step, of dt s: the place for controllers where an update makes
--- several steps (`timestep`, a long dt) or none. What it writes counts in that step.
---@field onStep? fun(dt: number)
--- default none. Called once when a contact starts, a before b in order; side is the side of a.
---@field onBegin? fun(a: physics.Object, b: physics.Object, side: physics.Side, speed: number)
--- default none. Called at every further step of a contact; dt is the length of that step in s.
---@field onStay? fun(a: physics.Object, b: physics.Object, side: physics.Side, dt: number)
--- default none. Called once when a contact ends.
---@field onEnd? fun(a: physics.Object, b: physics.Object, side: physics.Side)
--- default none. Called once when an object is held between a and b, which cannot give way.
---@field onCrush? fun(object: physics.Object, a: physics.Object, b: physics.Object, axis: "x"|"y")
--- default always. Asked before every contact: `false` lets the pair pass through for this step; it
--- must not change the world.
---@field canCollide? fun(a: physics.Object, b: physics.Object, side: physics.Side): boolean?

--- The default world, which the functions of the module mean.
---@class physics.DefaultWorld: physics.WorldSettings
---@field objects table<string|number, any> the game's groups of objects
---@field stats physics.Stats counters of the last step
---@field alpha number share of a fixed step that is saved up, 0..1
local default = {}

--- Moves the world on by dt seconds: collects the game's tables, moves and bumps what is in them,
--- writes the results back and tells the events. More than `maxStep` is split into equal steps,
--- more than 0.25 s is cut to that; 0, or less than 1e-10 s, reads the tables and moves nothing.
---
--- Errors: dt is no number >= 0; a group, key, field or setting that cannot be used (nothing has
--- changed then); called from inside `canCollide`; whatever a callback raises.
---@param dt number s, >= 0
function default.update(dt) end

--- Puts an object at the end of a group, which is made if it is not there. The same as
--- `table.insert(world.objects[group], object)`, but it checks the fields at once, gives the object
--- its `touching`, and reads one anew that was taken out since the last update, also a static one.
---
--- Errors: a group that is no name; no table; a field that cannot be used; an object that already
--- stands in the world. Nothing has changed then. (One that was put in by hand since the last
--- update is only found by the next one: an object in two places.)
---@param group string|number name of the group
---@param object physics.NewObject the game's own table: x, y, width, height and whatever else
---@return physics.Object object the same table
function default.add(group, object) end

--- Takes an object out of the world, out of its group's table. Its contacts end with `onEnd` at the
--- next update.
---
--- Errors: no table.
---@param object physics.NewObject who is to go
---@return boolean removed false: it was not in the world
function default.remove(object) end

--- Reads an object anew, also the fields that are read only once: `static`, and everything of a
--- static object. Also tells later questions that it has gone far away.
---
--- Errors: no table; an object that is not in the world; a field that cannot be used.
---@param object physics.NewObject who was changed
function default.refresh(object) end

--- Lets an object fall through the one-way objects it stands on. It passes them until it is clear
--- of them, also if something else holds it up until then.
---
--- Errors: no table; an object that is not in the world.
---@param object physics.NewObject who stands there
---@return boolean dropped false: it stands on none
function default.dropThrough(object) end

--- Returns all that a future step depends on, as a plain table of numbers, strings, booleans and
--- tables that any serializer can write: no functions, no cycles, no infinities. Restored, the run
--- goes on to the bit, also in another process and on another Lua. Saving changes nothing.
---
--- It holds the objects with the fields that the library knows, the settings that change results,
--- contacts, riders, saved-up time, and events that a failed callback has left behind. It does not
--- hold functions (callbacks, `canCollide`), fields of the game's own, `broadphase`, `cellSize`,
--- `rest` and `checked`.
---
--- The best place is right before `update`, when the input of the step has been written. Inside a
--- callback it holds what is still to be told; the event that is being told counts as told.
---
--- Errors: something that `update` would refuse; called from inside `canCollide`; no table.
---@param out physics.State? a state of this world that is not needed any more, to be filled anew: in a steady scene nothing is left to the garbage collector then
---@return physics.State state
function default.save(out) end

--- Makes this world what it was when the state was saved. No event is told for the jump itself.
---
--- Objects that have been added since leave their groups, those that have left come back, all get
--- their fields again. If this world has saved the state itself, and it is still the same table,
--- they are the very tables that they were, so the game's references, callbacks and own fields stay
--- with them. A state from elsewhere (a file, the network, another world) goes to whoever stands
--- under the same group and key, and to new plain tables where nobody does. The tables of groups
--- stay the same; groups that are not in the state are emptied. Fields of the game's own are not
--- touched.
---
--- Whoever had left the world, and of whom events were still to be told, is told of as before: in
--- this world as the table that it was, elsewhere as a new one with the fields that the library
--- knows, and without callbacks of its own.
---
--- Errors: no state, one of another version, or one that is damaged; called from inside
--- `canCollide`. Nothing has changed then.
---@param saved physics.State what `save` returned, or a copy
function default.restore(saved) end

--- Returns a number over all that `save` holds, a whole one in 0..10^14, the same on every Lua: two
--- worlds with the same number go on the same (to one in 10^13). For replays and for finding out
--- when two players' worlds have parted.
---
--- Errors: something that `update` would refuse; called from inside `canCollide`.
---@return number
function default.hash() end

--- Draws the world as the physics sees it (LÖVE only): static grey, kinematic blue, dynamic orange
--- (brown at rest), sensors as a green outline, inactive ones faintly, the solid side of one-way
--- objects violet, sides that touch light. It can be seen on dark and on light ground. Uses the
--- caller's transform; leaves colour, font and transform as they were.
---
--- Errors: an unknown option, or a wrong value for one.
---@param options physics.DrawOptions? what to show
function default.draw(options) end

--- Returns where to draw an object between two fixed steps (`timestep`): on the way from where it
--- was before the last step to where it is now, by `alpha`. Who is new, static, not active, or was
--- put somewhere by the game is drawn where it is; without `timestep` everybody is.
---
--- Errors: no table.
---@param object physics.NewObject who is to be drawn
---@return number x px
---@return number y px
function default.interpolate(object) end

--- Finds everybody at a point. The left and top edges of an object belong to it, the right and
--- bottom ones do not, so a point on a seam belongs to one tile.
---
--- Errors: no finite number; no filter; `out` is no table.
---@param x number px
---@param y number px
---@param filter physics.Filter? default everybody
---@param out physics.Object[]? list to fill, default a new one
---@return physics.Object[] objects in the order of the world
---@return integer count
function default.queryPoint(x, y, filter, out) end

--- Finds everybody who overlaps a rectangle by more than 1e-6 px; with the setting `sideBySide`
--- also who is flush with it.
---
--- Errors: no finite number; a size <= 0; no filter; `out` is no table.
---@param x number px, left edge
---@param y number px, top edge
---@param w number px, > 0
---@param h number px, > 0
---@param filter physics.Filter? default everybody
---@param out physics.Object[]? list to fill, default a new one
---@return physics.Object[] objects in the order of the world
---@return integer count
function default.queryRect(x, y, w, h, filter, out) end

--- Finds everybody on the line from (x1, y1) to (x2, y2), as `raycast` would hit them.
---
--- Errors: no finite number; no filter; `out` is no table.
---@param x1 number px
---@param y1 number px
---@param x2 number px
---@param y2 number px
---@param filter physics.Filter? default everybody
---@param out physics.Object[]? list to fill, default a new one
---@return physics.Object[] objects nearest first, ties in the order of the world
---@return integer count
function default.querySegment(x1, y1, x2, y2, filter, out) end

--- Finds the first object on the line from (x1, y1) to (x2, y2).
---
---     starts inside an object     hits it at fraction 0, normal 0, 0
---     starts on an edge           hits at fraction 0 with its normal if it goes in, else not
---     ends on an edge             hits at fraction 1
---     runs along an edge          hits whom the edge belongs to: the one below it or to its right,
---                                 so no ray slips between two tiles (to a millionth of a pixel)
---     meets a corner              of one object: no hit if it only grazes it; the normal is along
---                                 gravity, or that of the wall if a neighbour covers the other one
---     has no length               hits who is there, as queryPoint, fraction 0, normal 0, 0
---
--- Source: slab method; the grid is walked in strips (see physics/broadphase/grid.lua).
---
--- Errors: no finite number; no filter.
---@param x1 number px
---@param y1 number px
---@param x2 number px
---@param y2 number px
---@param filter physics.Filter? default everybody
---@return physics.Object? object nil: the line is free, and nothing else is returned
---@return number x px, where it is hit
---@return number y px
---@return number nx normal of the side that is hit: -1, 0, 1
---@return number ny likewise
---@return number fraction of the line, 0..1
function default.raycast(x1, y1, x2, y2, filter) end

--- Finds what would stop an object on its way by (dx, dy): solids that its mask, theirs and the
--- world's do not let pass, one-ways on their solid side; not sensors. `canCollide` is not asked.
--- Who overlaps it already is hit at fraction 0 with the normal 0, 0; who is flush beside its way
--- is not. Nothing moves.
---
--- Errors: no table; an object that is not in the world; no finite number; no filter.
---@param object physics.NewObject who would move
---@param dx number px
---@param dy number px
---@param filter physics.Filter? default everybody
---@return physics.Object? other nil: the way is free, and nothing else is returned
---@return number x px, where `object` would be then, flush
---@return number y px
---@return number nx normal of the side that is hit: -1, 0, 1
---@return number ny likewise
---@return number fraction of the way, 0..1
function default.sweep(object, dx, dy, filter) end

--- Finds the object nearest to a point; ties in the order of the world.
---
--- Errors: no finite number; a radius < 0; no filter.
---@param x number px
---@param y number px
---@param radius number px, >= 0: how far it looks
---@param filter physics.Filter? default everybody
---@return physics.Object? object nil: there is none
---@return number distance px, from the point to the edge, 0: inside
function default.nearest(x, y, radius, filter) end

--- Finds everybody who overlaps an object by more than 1e-6 px, whatever the masks say; with the
--- setting `sideBySide` also who is flush with it. An object that is not active overlaps nobody.
---
--- Errors: no table; an object that is not in the world; no filter; `out` is no table.
---@param object physics.NewObject one of the world
---@param filter physics.Filter? default everybody
---@param out physics.Object[]? list to fill, default a new one
---@return physics.Object[] objects in the order of the world, without `object`
---@return integer count
function default.overlapping(object, filter, out) end

--- Returns the side of `a` at which it is in contact with `b`: the contact of which `onBegin` told
--- and `onEnd` has not, unless the game has taken the two apart since. With the setting
--- `sideBySide` who is flush is in contact.
---
--- Errors: no table; an object that is not in the world.
---@param a physics.NewObject one of the two
---@param b physics.NewObject the other one
---@return physics.Side? side of `a`, nil: no contact
function default.touching(a, b) end

--- Says in one sentence why two objects do or do not collide: for debugging, its words may change.
---
--- Errors: no table.
---@param a physics.NewObject one of the two
---@param b physics.NewObject the other one
---@return string sentence
function default.explain(a, b) end

--- Moves one object to (x, y) now, with collisions and without physics: it writes `object.x` and
--- `object.y`, pushes nobody and changes no velocity. Any kind of object is in its way; masks,
--- `active` and `oneWay` hold as in a step, `canCollide` is not asked. It never ends inside a
--- solid, unless it was inside that one before: who overlaps it from the beginning is reported and
--- crossed.
---
---     "slide"    goes on along the side that it hit (default)
---     "touch"    stays where it hit
---     "cross"    goes through
---     "bounce"   goes on mirrored
---
--- Sensors are crossed whatever the response. A function(object, other) says for each hit one of
--- these names (nil: "slide"), or false: `other` is not there; it must not change the world.
--- An object that is not active moves without any collision. After 64 hits the way ends.
--- Source: the responses are those of bump.lua (E. García Cota).
---
--- Errors: no table; an object that is not in the world; a static one; no finite number; an unknown
--- response; called from inside `canCollide`. Nothing has moved then.
---@param object physics.NewObject dynamic or kinematic
---@param x number px, left edge where it should go
---@param y number px, top edge
---@param response physics.Response|physics.Respond|nil default "slide"
---@param out physics.Hit[]? list of an earlier call, to be filled anew
---@return number x px, where it is now
---@return number y px
---@return physics.Hit[] hits in the order in which they happened
---@return integer count
function default.move(object, x, y, response, out) end

--- Pushes a dynamic object: its velocity changes by the impulse divided by its mass.
---
--- Errors: no table; an object that is not in the world, or not dynamic; no finite number; a field
--- that cannot be used; called from inside `canCollide`.
---@param object physics.NewObject a dynamic one
---@param ix number px/s times mass
---@param iy number likewise
function default.impulse(object, ix, iy) end

--- Puts four static walls around a rectangle, the group `bounds` (`objects.bounds.top`, `.bottom`,
--- `.left`, `.right`; they may be given `friction` and so on before the next update). Called again,
--- it replaces them; without arguments it takes them away.
---
--- Errors: no finite number; a size <= 0; the game has put something else under one of these names;
--- called from inside `canCollide`.
---@param x number? px, inner left edge; nil: no bounds
---@param y number? px, inner top edge
---@param w number? px, > 0
---@param h number? px, > 0
function default.setBounds(x, y, w, h) end

--- Adds what stands in a map of the editor Tiled: its rectangles and tile objects, and its solid
--- tiles, merged into few large rectangles. The map is its Lua export (the table, or the path of
--- the file) or the table that STI makes of it; it is not changed, and nothing is drawn.
---
--- The name of a layer is the group of its objects. Properties of an object are its fields; those
--- that the library knows are also taken from its tile, its layer and the layers around it, the
--- nearest first. Three properties are for the loader: `solid`, `merge`, and `group`, which is used
--- instead of the layer's name. A tile is solid if it or its layer says so, or if it has collision
--- rectangles, and neither says `solid = false`, which takes objects out, too. A layer that says
--- nothing says what the nearest one around it does. An option counts as a yes instead of the own
--- word: `solidTiles` of a tile (not for tile objects), `solidLayers` of a layer. Solid tiles are
--- static unless they say otherwise. Static ones that are equal and no sensors become one; merging
--- changes no motion.
---
--- Not supported, and named in `unsupported` of what is returned: maps that are not orthogonal,
--- rotated objects, polygons, ellipses, points and texts, encoded layer data, parallax, tilesets
--- that are not embedded in the export.
---
--- Errors: no map, no such file; an unknown option; a layer or gid in an option that is not in the
--- map; a gid of no tileset; a property that is a field and cannot be used; a group that is an
--- object; called from inside `canCollide`. Nothing has been added then.
---@param map table|string what the export returns, what STI returns, or the path of the export
---@param options physics.TiledOptions? where the map goes, and which of its tiles are solid
---@return physics.Level level the objects that were added, counts, and what is not supported
function default.loadTiled(map, options) end
