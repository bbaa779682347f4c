---@meta _
--- The types of this library for editors (LuaLS, EmmyLua). Nothing requires this file.
--- scripts/types.lua writes it from physics/fields/fields.lua and the methods of worlds: change
--- those.

---@alias physics.Side "left"|"right"|"top"|"bottom"

--- A rectangle: left edge, top edge and size, in px. It may have fields of your own.
---@class physics.Box
---@field x number px, the left edge
---@field y number px, the top edge; y grows downwards
---@field width number px, > 0
---@field height number px, > 0
---@field [string|number] any

--- The neighbours of a dynamic object: on each side the one with the widest common edge, or false.
---@class physics.Touching
---@field top physics.Object|false
---@field bottom physics.Object|false
---@field left physics.Object|false
---@field right physics.Object|false

--- What an object may have beside its place and size.
---@class physics.ObjectFields
--- px/s, default 0. The velocity along x. For a rider it is relative to the carrier.
---@field vx? number
--- px/s, default 0. The velocity along y, downwards. For a rider it is relative to the carrier.
---@field vy? number
--- px/s², default 0. A constant acceleration along x: an engine, a magnet.
---@field ax? number
--- px/s², default 0. A constant acceleration along y, on top of gravity.
---@field ay? number
--- default false. It never moves. A static object is read once, when it is first seen; `refresh`
--- reads it again.
---@field static? boolean
--- default false. It moves by its own velocity, or by the game writing `x, y`. It pushes, is never
--- pushed and feels no gravity.
---@field kinematic? boolean
--- default true. `false` takes it out: no motion, no contacts, no queries.
---@field active? boolean
--- default false. It reports contacts, but nothing bumps into it.
---@field sensor? boolean
--- default none. Makes a sensor a zone, which acts on dynamic objects inside it: water, wind, a
--- magnet.
---@field area? physics.Area
--- default true. `false`: other objects cannot push it, but it pushes them. Walls still stop it.
---@field pushable? boolean
--- default 0. The stronger of two objects is not moved by the weaker one, whose mass counts only a
--- fifth.
---@field strength? number
--- > 0, default 1. The weight in pushes and in the exchange of momentum. Only ratios matter.
---@field mass? number
--- px/s², default the world's. Replaces the world's downward gravity for this object. An object
--- with 0 floats.
---@field gravity? number
--- px/s², default the world's. Replaces the world's sideways gravity for this object.
---@field gravityX? number
--- >= 0, default 0; static and kinematic: the other object's. The Coulomb coefficient. A pair uses
--- the square root of the product.
---@field friction? number
--- 0..1, default 0. The bounciness: 0 none, 1 all of it. A pair uses the larger one.
---@field restitution? number
--- 1/s, >= 0, default 0. Damping: the speed falls as e^(-k t), the same at any frame rate.
---@field airFriction? number
--- px/s², >= 0, default 0. A constant deceleration towards 0, as on a floor seen from above.
---@field drag? number
--- px/s, >= 0, default none. The limit of the speed, that is of the length of the velocity. At a
--- static wall it holds along each axis alone.
---@field maxSpeed? number
--- px/s, >= 0, default none. The limit of the speed along x, in both directions.
---@field maxSpeedX? number
--- px/s, >= 0, default none. The limit of the speed along y, in both directions: it also cuts a
--- jump that is faster.
---@field maxSpeedY? number
--- px/s, >= 0, default none. The limit of the speed at which it falls, along gravity only: a jump
--- may be faster.
---@field maxFallSpeed? number
--- default collides with every group. `mask[group] = false`: passes through the objects of that
--- group. `true` and nil collide. Either object of a pair may refuse.
---@field mask? table<string|number, boolean>
--- default every group that no mask refuses. Collides with the objects of these groups and of no
--- others: `hits = { "players" }`. The list is read when it is set; to change it, set another list.
---@field hits? (string|number)[]
--- default none: solid all around. The one side that is solid; `true` is the top. The others let
--- everything through. For round objects the side is up to 45° wide. For static and kinematic
--- objects: a dynamic one would fall through the floor.
---@field oneWay? boolean|"top"|"bottom"|"left"|"right"
--- default none: a box. A right triangle that fills its box, for static and kinematic objects.
--- `left` and `right` name the side that is high, solid below; `topleft` and `topright` hang from
--- above.
---@field slope? "left"|"right"|"topleft"|"topright"
--- default true. Whether a kinematic object takes its riders along. `false`: it slides away under
--- them, and launches them upwards.
---@field carry? boolean
--- px/s, default 0. A conveyor: objects on it move along x at this speed, also on a slope; along y
--- where gravity acts sideways.
---@field surfaceSpeed? number
--- px, >= 0, default 0. Corner correction: an object that hits a static or kinematic corner by at
--- most this much slides past it.
---@field nudge? number
--- px, >= 0, default 0. An object that does not jump stays on ground that drops by at most this
--- much: down stairs.
---@field snap? number
--- >= 0, default none. The steepest slope on which a box walks: px up for each px across. A steeper
--- one is a wall, along which it falls.
---@field maxSlope? number
--- default false. On slopes `vx` is the speed along the ground. `false`: it is the speed along x
--- everywhere.
---@field constantSpeed? boolean
--- default none. Called once when a contact starts, also with a sensor. `side` is the side of
--- `self` that was hit, `speed` the approach speed in px/s. The edge that the two have in common
--- goes from `x1, y1` to `x2, y2`. `nx, ny` is the normal, away from `other`.
---@field onBegin? fun(self: physics.Object, other: physics.Object, side: physics.Side, speed: number, x1: number, y1: number, x2: number, y2: number, nx: number, ny: number)
--- default none. Called at every further step of a contact; dt is the length of that step in s.
---@field onStay? fun(self: physics.Object, other: physics.Object, side: physics.Side, dt: number, nx: number, ny: number)
--- default none. Called once when a contact ends, also when one of the two is removed or
--- deactivated.
---@field onEnd? fun(self: physics.Object, other: physics.Object, side: physics.Side)
--- default none. Called once when `self` is held between `a` and `b`, neither of which can give
--- way. `axis` is "x" or "y".
---@field onCrush? fun(self: physics.Object, a: physics.Object, b: physics.Object, axis: "x"|"y")
--- default always. Called before a contact: `false` lets the pair pass through each other for this
--- step. It must not change the world.
---@field canCollide? fun(self: physics.Object, other: physics.Object, side: physics.Side): boolean?
---@field [string|number] any

--- Your own table that you give to `add` or put into a group: a box, or a circle in its square.
---@alias physics.NewObject physics.NewBox|physics.NewCircle

---@class physics.NewBox: physics.ObjectFields
---@field x number px, the left edge
---@field y number px, the top edge
---@field width number px, > 0
---@field height number px, > 0
--- px, > 0. It is a circle: `width` and `height` are 2 * radius.
---@field radius? number

---@class physics.NewCircle: physics.ObjectFields
---@field x number px, the left edge of its square
---@field y number px, the top edge of its square
---@field radius number px, > 0
---@field width? number px, 2 * radius; `add` writes it
---@field height? number px, 2 * radius; `add` writes it

--- An object in a world. A dynamic one always has `vx`, `vy` and `touching`.
---@class physics.Object: physics.NewBox, physics.Box
--- px/s, default 0. The velocity along x. For a rider it is relative to the carrier.
---@field vx number
--- px/s, default 0. The velocity along y, downwards. For a rider it is relative to the carrier.
---@field vy number
--- The neighbours of a dynamic object: `top`, `bottom`, `left` and `right`, each an object or
--- `false`. An object that was hit in the last update, and left again, counts.
---@field touching physics.Touching

--- The entries of the field `area` of a zone.
---@class physics.Area
--- px/s², default that of the object. Replaces the downward gravity of objects inside. A negative
--- one lifts, as in water.
---@field gravity? number
--- px/s², default that of the object. Replaces the sideways gravity of objects inside.
---@field gravityX? number
--- px/s², default 0. An acceleration along x on top: wind.
---@field ax? number
--- px/s², default 0. An acceleration along y on top.
---@field ay? number
--- 1/s, >= 0, default 0. Damping on top of that of the object: water, mud.
---@field airFriction? number
--- px/s², >= 0, default 0. A constant deceleration on top of that of the object.
---@field drag? number
--- px/s², default 0. An acceleration towards the centre of the zone; a negative one repels.
---@field attract? number
--- default "constant". `attract` is the pull at the rim. `law` says how it changes towards the
--- centre: constant, in proportion to the distance, as 1 / distance, or as 1 / distance². The rim
--- is at half of the smaller size. Within an eighth of that the pull falls to 0 at the centre.
---@field law? "constant"|"linear"|"inverse"|"square"

--- What `newWorld` and `load` take.
---@class physics.Settings
--- px/s², default 9.81 * 64. The downward acceleration of everything that moves. The default is
--- that of the earth at 64 px to the metre.
---@field gravity? number
--- px/s², default 0. The sideways acceleration of everything that moves.
---@field gravityX? number
--- default "both". Where two objects meet: half-way, by their masses, or at the edge of the one
--- that was run into. It concerns places only: both settings share the velocities by mass.
---@field push? "both"|"first"
--- default every group collides with every group. Groups that pass through each other: `masks = {
--- bullets = { players = false } }`.
---@field masks? table<string|number, table<string|number, boolean>>
--- px/s, default no group is soft to another. Groups that overlap and drift apart instead of
--- colliding: `soft = { enemies = { enemies = 400 } }`. Two at one place part at this speed along x
--- or y, two that overlap by half at half of it.
---@field soft? table<string|number, table<string|number, number>>
--- default false. Whether flush neighbours that never pressed each other count as colliding: in
--- events, `touching`, `queryRect`, `overlapping` and `checkCollision`.
---@field sideBySide? boolean
--- default "auto". How pairs that may meet are found, all with the same result to the bit. `auto`
--- is the grid.
---@field broadphase? "auto"|"pairs"|"grid"
--- px, > 0, default 48. The width and height of the smallest cells of the grid. Most objects should
--- fit into one, with some 10 px to spare; larger objects use larger cells.
---@field cellSize? number
--- s, 1e-05..0.25, default none: a step is as long as dt. A fixed step: `update` saves up dt and
--- makes as many of these steps as fit.
---@field timestep? number
--- s, 1e-05..0.25, default 1 / 30. The longest single step. A longer dt is split into equal steps.
--- A `timestep` is never split.
---@field maxStep? number
--- default numbers ascending, then strings. Group names from first to last. Groups that are not
--- listed follow in the usual order.
---@field order? (string|number)[]
--- default none. Names of fields of your own objects that `save`, `restore` and `hash` count in:
--- numbers, strings, booleans and tables of these.
---@field ownFields? string[]
--- default true. Whether objects are skipped when a step would not change them. The result is the
--- same to the bit.
---@field rest? boolean
--- default false. Whether every step also looks for common mistakes, such as a misspelt field. Use
--- it while you write the game.
---@field checked? boolean
--- default nothing is timed. A clock that returns seconds, as `os.clock` or `love.timer.getTime`:
--- with one, `stats` tells how long the stages of the last step have taken.
---@field profile? fun(): number
--- default none. Called before every step, of dt s: the place for controllers. Its changes count in
--- that step.
---@field onStep? fun(dt: number)
--- default none. As `onBegin` of an object; `a` comes before `b` in the order of the world.
---@field onBegin? fun(a: physics.Object, b: physics.Object, side: physics.Side, speed: number, x1: number, y1: number, x2: number, y2: number, nx: number, ny: number)
--- default none. As `onStay` of an object; `a` comes before `b` in the order of the world.
---@field onStay? fun(a: physics.Object, b: physics.Object, side: physics.Side, dt: number, nx: number, ny: number)
--- default none. As `onEnd` of an object; `a` comes before `b` in the order of the world.
---@field onEnd? fun(a: physics.Object, b: physics.Object, side: physics.Side)
--- default none. As `onCrush` of an object; `a` comes before `b` in the order of the world.
---@field onCrush? fun(object: physics.Object, a: physics.Object, b: physics.Object, axis: "x"|"y")
--- default always. As `canCollide` of an object; `a` comes before `b` in the order of the world.
---@field canCollide? fun(a: physics.Object, b: physics.Object, side: physics.Side): boolean?

--- The settings as fields of a world. They may change between two updates.
---@class physics.WorldSettings
--- px/s², default 9.81 * 64. The downward acceleration of everything that moves. The default is
--- that of the earth at 64 px to the metre.
---@field gravity number
--- px/s², default 0. The sideways acceleration of everything that moves.
---@field gravityX number
--- default "both". Where two objects meet: half-way, by their masses, or at the edge of the one
--- that was run into. It concerns places only: both settings share the velocities by mass.
---@field push "both"|"first"
--- default every group collides with every group. Groups that pass through each other: `masks = {
--- bullets = { players = false } }`.
---@field masks? table<string|number, table<string|number, boolean>>
--- px/s, default no group is soft to another. Groups that overlap and drift apart instead of
--- colliding: `soft = { enemies = { enemies = 400 } }`. Two at one place part at this speed along x
--- or y, two that overlap by half at half of it.
---@field soft? table<string|number, table<string|number, number>>
--- default false. Whether flush neighbours that never pressed each other count as colliding: in
--- events, `touching`, `queryRect`, `overlapping` and `checkCollision`.
---@field sideBySide boolean
--- default "auto". How pairs that may meet are found, all with the same result to the bit. `auto`
--- is the grid.
---@field broadphase "auto"|"pairs"|"grid"
--- px, > 0, default 48. The width and height of the smallest cells of the grid. Most objects should
--- fit into one, with some 10 px to spare; larger objects use larger cells.
---@field cellSize? number
--- s, 1e-05..0.25, default none: a step is as long as dt. A fixed step: `update` saves up dt and
--- makes as many of these steps as fit.
---@field timestep? number
--- s, 1e-05..0.25, default 1 / 30. The longest single step. A longer dt is split into equal steps.
--- A `timestep` is never split.
---@field maxStep number
--- default numbers ascending, then strings. Group names from first to last. Groups that are not
--- listed follow in the usual order.
---@field order? (string|number)[]
--- default none. Names of fields of your own objects that `save`, `restore` and `hash` count in:
--- numbers, strings, booleans and tables of these.
---@field ownFields? string[]
--- default true. Whether objects are skipped when a step would not change them. The result is the
--- same to the bit.
---@field rest boolean
--- default false. Whether every step also looks for common mistakes, such as a misspelt field. Use
--- it while you write the game.
---@field checked boolean
--- default nothing is timed. A clock that returns seconds, as `os.clock` or `love.timer.getTime`:
--- with one, `stats` tells how long the stages of the last step have taken.
---@field profile? fun(): number
--- default none. Called before every step, of dt s: the place for controllers. Its changes count in
--- that step.
---@field onStep? fun(dt: number)
--- default none. As `onBegin` of an object; `a` comes before `b` in the order of the world.
---@field onBegin? fun(a: physics.Object, b: physics.Object, side: physics.Side, speed: number, x1: number, y1: number, x2: number, y2: number, nx: number, ny: number)
--- default none. As `onStay` of an object; `a` comes before `b` in the order of the world.
---@field onStay? fun(a: physics.Object, b: physics.Object, side: physics.Side, dt: number, nx: number, ny: number)
--- default none. As `onEnd` of an object; `a` comes before `b` in the order of the world.
---@field onEnd? fun(a: physics.Object, b: physics.Object, side: physics.Side)
--- default none. As `onCrush` of an object; `a` comes before `b` in the order of the world.
---@field onCrush? fun(object: physics.Object, a: physics.Object, b: physics.Object, axis: "x"|"y")
--- default always. As `canCollide` of an object; `a` comes before `b` in the order of the world.
---@field canCollide? fun(a: physics.Object, b: physics.Object, side: physics.Side): boolean?

--- The default world, on which the functions of the module work.
---@class physics.DefaultWorld: physics.WorldSettings
---@field objects table<string|number, any> the game's groups of objects
---@field stats physics.Stats counters of the last step
---@field alpha number share of a fixed step that is saved up, 0..1; your own loop may write it (see `interpolate`)
local default = {}

--- Moves the world on by dt seconds: reads the game's tables, moves the objects, writes the results
--- back and calls the callbacks.
---
--- A dt above `maxStep` is split into equal steps; one above 0.25 s is cut to 0.25 s. A dt of 0
--- reads the tables and moves nothing. With `timestep` an update makes one step, several, or none.
---
--- Errors: dt is not a number >= 0; a group, key, field or setting has a value that cannot be used
--- (nothing has changed then); it is called from inside `canCollide`; a callback raises an error.
---@param dt number s, >= 0
function default.update(dt) end

--- Puts an object at the end of a group and returns it. A group that does not exist is made. Unlike
--- `table.insert(world.objects[group], object)` it checks the fields at once, and gives a dynamic
--- object its `vx`, `vy` and `touching`.
---
--- Errors: the group is not a string or a number; the object is not a table; a field has a value
--- that cannot be used; the object is already in the world. Nothing has changed then.
---@overload fun(group: string|number, ball: physics.NewCircle): physics.Object
---@param group string|number name of the group
---@param object physics.NewBox your table: x, y, width and height or radius, and other fields
---@return physics.Object object the same table
function default.add(group, object) end

--- Takes an object out of its group and the world. Its contacts end at the next update. Later
--- objects of the group move up one place: in a loop go backwards, or use the list of a query.
---
--- Errors: the object is not a table.
---@param object physics.NewObject the object to remove
---@return boolean removed false: it was not in the world
function default.remove(object) end

--- Reads an object again, also the fields that are read only once: `static`, and all fields of a
--- static object. Queries see the change at once.
---
--- On a kinematic object it also means "it is there now". Without `refresh` it gets to the `x, y`
--- that you write during the next step, and pushes objects on its way.
---
--- Errors: the object is not a table, or not in the world; a field has a value that cannot be used.
---@param object physics.NewObject the object that you changed
function default.refresh(object) end

--- Lets an object fall through the one-way objects that it stands on, and through others on its
--- way, until it is clear of them. If it also stands on something solid, it stays there.
---
--- Errors: the object is not a table, or not in the world.
---@param object physics.NewObject the object that stands on them
---@return boolean dropped false: it stands on no one-way object
function default.dropThrough(object) end

--- Moves one object to (x, y) now, with collisions and without physics. It pushes nothing and
--- changes no velocity. Masks, `active` and `oneWay` hold as in a step; `canCollide` is not called.
--- Sensors, and objects that it overlaps at the start, are reported and crossed.
---
---     "slide"    goes on along the side that it hit (default)
---     "touch"    stays where it hit
---     "cross"    goes through
---     "bounce"   goes on mirrored
---
--- The response may be a function(object, other) that returns one of these names for each hit, or
--- false to ignore `other`. Nothing means "slide"; a `checked` world refuses it. Of several that
--- stop the object at once, the one with the longest common edge comes first, and decides. The move
--- ends after 64 hits.
---
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
function default.move(object, x, y, response, out) end

--- Changes the velocity of a dynamic object by the impulse divided by its mass. A speed limit, such
--- as `maxSpeed`, cuts the new velocity in the next step.
---
--- Errors: the object is not a table, or not in the world; the object is not dynamic; a number is
--- not finite; its `vx`, `vy` or `mass` cannot be used; it is called from inside `canCollide`.
---@param object physics.NewObject a dynamic object
---@param ix number px/s times mass, along x
---@param iy number px/s times mass, along y
function default.impulse(object, ix, iy) end

--- Moves the whole world by (dx, dy), so that the player stays near the origin. No callback is
--- called. Choose whole px, since coordinates round. States that were saved before belong to the
--- old place.
---
--- Errors: a number is not finite; an object would be too far away, or has a field that cannot be
--- used (nothing has moved then); it is called from inside `canCollide`.
---@param dx number px
---@param dy number px
function default.shift(dx, dy) end

--- Pushes all dynamic objects in a circle away from its centre, also sensors. The nearest point of
--- an object counts: at the centre it gets the whole impulse, at the rim nothing. With `walls` only
--- objects in sight of the centre are pushed.
---
--- Errors: a number is not finite; the radius is <= 0; a filter cannot be used; `vx`, `vy` or
--- `mass` of an object cannot be used; it is called from inside `canCollide`. Nothing has changed
--- then.
---@param x number px, the centre
---@param y number px
---@param radius number px, > 0
---@param impulse number px/s times mass, at the centre; < 0: towards the centre
---@param filter physics.Filter? which objects are pushed, default all
---@param walls physics.Filter? objects that shield others, default none
---@return physics.Object[] objects those that were pushed, in the order of the world
---@return integer count
function default.explode(x, y, radius, impulse, filter, walls) end

--- Puts four static walls around a rectangle: `top`, `bottom`, `left` and `right` of the group
--- `bounds`. A second call replaces them; a call without arguments removes them. The lower wall is
--- a floor, so give a level with pits a higher rectangle.
---
--- Errors: a number is not finite; a size is <= 0; the game uses one of these names for something
--- that is not static; it is called from inside `canCollide`.
---@param x number? px, inner left edge; nil: no bounds
---@param y number? px, inner top edge
---@param w number? px, > 0
---@param h number? px, > 0
function default.setBounds(x, y, w, h) end

--- Adds the objects of a map of the editor Tiled, and its solid tiles, merged into few large
--- rectangles. Parts that are not supported are listed in `unsupported` of the result. A `.world`
--- file is several maps. JSON needs the option `decode`. See docs/maps.md.
---
--- Errors: the map does not exist, or a part is damaged; an option is unknown, or names a layer
--- that is not in the map; with `strict` a property cannot be used; a group is an object; it is
--- called from inside `canCollide`. Nothing has been added then.
---@param map table|string the path of a map or a world, the table that an export or STI returns, or decoded JSON
---@param options physics.TiledOptions? where the map goes, and which parts are solid
---@return physics.Level|physics.Atlas level the objects that were added, and the parts that were left out
function default.loadTiled(map, options) end

--- Adds the tiles of a plain array as static objects. Equal cells are merged into few large
--- objects, which changes no motion. The cells are copied. See docs/maps.md.
---
--- The cells are one list, row by row, or a list of rows, for which `columns` is nil. A row may be
--- a string (`"##..#"`): each character is a cell. Columns and rows are counted from 1.
---
--- Errors: the group is not a name, or is an object; the cells, the size or an option cannot be
--- used; it is called from inside `canCollide`. Nothing has been added then.
---@param group string|number name of their group; the field `group` of a value has precedence
---@param cells table list of values, or list of rows
---@param columns integer? of a list of values: how many are a row; nil for a list of rows
---@param size number|number[] px, of a cell: one number, or width and height
---@param options physics.TileOptions? which values are solid, and where the tiles go
---@return physics.Tiles tiles
---@diagnostic disable-next-line: redefined-local
function default.addTiles(group, cells, columns, size, options) end

--- Adds a level of the editor LDtk: the solid cells of its IntGrid layers as few large static
--- objects, and its entities with their fields. With the option `all` it adds all levels of the
--- project, as a level of several maps. See docs/maps.md.
---
--- Errors: the level does not exist, is in another file, or a part is damaged; an option is
--- unknown, or names a layer that is not in the level; with `strict` a field cannot be used; a
--- group is an object; it is called from inside `canCollide`. Nothing has been added then.
---@param project table the .ldtk file, decoded by a JSON library
---@param level string|integer|table|nil its identifier, iid or number, or its decoded .ldtkl file; default: the first level
---@param options physics.LDtkOptions? where the level goes, and which parts are solid
---@return physics.LDtkLevel|physics.Atlas level the objects that were added, and the parts that were left out
---@diagnostic disable-next-line: redefined-local
function default.loadLDtk(project, level, options) end

--- Returns everything that a future step depends on, as a plain table of numbers, strings, booleans
--- and tables. After `restore` the run continues with the same bits, also in another process and on
--- another Lua. See docs/state.md.
---
--- Of your own fields only those that `ownFields` names are saved, and no functions. A state that
--- is saved inside a callback holds the events of this step that are still to come.
---
--- Errors: a field or setting that `update` would refuse; a value in `ownFields` that cannot be
--- saved; `out` is not a table; it is called from inside `canCollide`.
---@param out physics.State? a state of this world that you no longer need: it is filled again
---@return physics.State state
function default.save(out) end

--- Puts this world back to the moment at which the state was saved. That itself calls no callback.
---
--- Objects that were added since then leave, removed ones come back, and all get their saved
--- fields. In this same world each object is the very table that it was. A state from elsewhere is
--- applied to objects of maps by their id in the editor, to others by group and key; a missing one
--- becomes a new plain table, without callbacks. Maps come and go, and tiles are dug, as they were.
---
--- Errors: the value is not a state, or one of another version, or damaged; a map cannot be read;
--- it is called from inside `canCollide`. Nothing has changed then.
---@param saved physics.State the result of `save`, or a copy
---@return string? misfit nil: the state fits; else a sentence about numbered keys that may be wrong
---@return physics.Object[] new the objects that had to be made
function default.restore(saved) end

--- Returns a whole number in 0..10^14 over everything that `save` holds, the same on every Lua. Two
--- worlds with the same number continue in the same way (wrong once in 10^13). Use it for replays,
--- and to find the step in which two players' worlds began to differ.
---
--- Errors: a field or setting that `update` would refuse; it is called from inside `canCollide`.
---@return number
function default.hash() end

--- Returns all objects at a point, and how many. The left and top edges of an object belong to it,
--- the right and bottom ones do not.
---
--- Errors: a coordinate is not a finite number; the filter cannot be used; `out` is not a table.
---@param x number px
---@param y number px
---@param filter physics.Filter? which objects count, default all
---@param out physics.Object[]? list to fill, default a new one
---@return physics.Object[] objects in the order of the world
---@return integer count
function default.queryPoint(x, y, filter, out) end

--- Returns all objects that overlap a rectangle, and how many.
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
function default.queryRect(x, y, w, h, filter, out) end

--- Returns all objects that overlap a circle, and how many.
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
function default.queryCircle(x, y, radius, filter, out) end

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
function default.nearest(x, y, radius, filter) end

--- Returns whether a box of that place and size would be free. Solid objects are in the way, but
--- not sensors, one-way objects and inactive objects.
---
--- In place of the filter you may give the object that would be there. Then its mask counts, and it
--- is not in its own way.
---
--- Errors: a number is not finite; a size is <= 0; the filter cannot be used, or is an object that
--- is not in the world.
---@param x number px, left edge
---@param y number px, top edge
---@param width number px, > 0
---@param height number px, > 0
---@param filter physics.Filter|physics.NewObject|nil which objects count, default all; or the object that would be there
---@return boolean fits
---@return physics.Object? other the obstacle, the first in the order of the world
function default.fits(x, y, width, height, filter) end

--- Returns the nearest place, at most `reach` px away, where a box would be free, as `fits` says:
--- to spawn, to stand up. Of two as near, one straight above or below comes first. Beside slopes
--- and round objects there may be a nearer one.
---
--- Errors: a number is not finite; a size is <= 0; the reach is < 0; the filter cannot be used, or
--- is an object that is not in the world.
---@param x number px, left edge where it should be
---@param y number px, top edge
---@param width number px, > 0
---@param height number px, > 0
---@param reach number px, >= 0
---@param filter physics.Filter|physics.NewObject|nil as that of `fits`
---@return number? x px, left edge; nil: there is none
---@return number? y px, top edge
function default.freePlace(x, y, width, height, reach, filter) end

--- Returns all objects on the line from (x1, y1) to (x2, y2), as `raycast` would hit them, and how
--- many. With `fractions` it says where: `objects[n]` is hit at `x1 + (x2 - x1) * fractions[n]`.
---
--- Errors: a coordinate is not a finite number; the filter cannot be used; `out` or `fractions` is
--- not a table.
---@param x1 number px
---@param y1 number px
---@param x2 number px
---@param y2 number px
---@param filter physics.Filter? which objects count, default all
---@param out physics.Object[]? list to fill, default a new one
---@param fractions number[]? list to fill with the places, as fractions of the line, 0..1
---@return physics.Object[] objects nearest first, ties in the order of the world
---@return integer count
function default.querySegment(x1, y1, x2, y2, filter, out, fractions) end

--- Returns the first object on the line from (x1, y1) to (x2, y2), and where the line hits it.
---
---     starts inside an object     hits it at fraction 0, normal 0, 0
---     starts on an edge           hits at fraction 0 with its normal if it goes in, else not
---     ends on an edge             hits at fraction 1
---     runs along an edge          hits the object below it or to its right
---     grazes a corner             no hit, but of two that touch there: hits the first of them
---     meets a one-way object      hits it only from its solid side, as bodies do
---     has no length               hits the object that queryPoint finds, fraction 0, normal 0, 0
---
--- Source: slab method; the grid is walked in strips (see physics/broadphase/gridLines.lua).
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
function default.raycast(x1, y1, x2, y2, filter) end

--- Returns the obstacle that would stop an object on its way by (dx, dy), and where the object
--- would be then.
--- Nothing moves.
---
--- Solid objects stop it, if no mask says otherwise; one-way objects stop it on their solid side;
--- sensors do not. `canCollide` is not called. An object that overlaps it already is hit at
--- fraction 0 with the normal 0, 0.
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
function default.sweep(object, dx, dy, filter) end

--- Returns the obstacle of a free box on its way by (dx, dy), as `sweep` does for an object.
---
--- Errors: a number is not finite; a size is <= 0; the filter cannot be used.
---@param x number px, left edge
---@param y number px, top edge
---@param width number px, > 0
---@param height number px, > 0
---@param dx number px
---@param dy number px
---@param filter physics.Filter? which objects count, default all
---@return physics.Object? other nil: the way is free
---@return number x px, left edge of the box then
---@return number y px, top edge
---@return number nx normal, of length 1
---@return number ny likewise
---@return number fraction of the way, 0..1
function default.cast(x, y, width, height, dx, dy, filter) end

--- Returns the obstacle of a free circle on its way by (dx, dy).
---
--- Errors: a number is not finite; the radius is <= 0; the filter cannot be used.
---@param x number px, the centre
---@param y number px
---@param radius number px, > 0
---@param dx number px
---@param dy number px
---@param filter physics.Filter? which objects count, default all
---@return physics.Object? other nil: the way is free
---@return number x px, the centre then
---@return number y px
---@return number nx normal, of length 1
---@return number ny likewise
---@return number fraction of the way, 0..1
function default.castCircle(x, y, radius, dx, dy, filter) end

--- Returns all objects that overlap an object, and how many. Removing objects
--- while you loop over the list is safe.
---
--- Errors: the object is not a table, or not in the world; the filter cannot be used; `out` is not
--- a table.
---@param object physics.NewObject an object of the world
---@param filter physics.Filter? which objects count, default all
---@param out physics.Object[]? list to fill, default a new one
---@return physics.Object[] objects in the order of the world, without `object`
---@return integer count
function default.overlapping(object, filter, out) end

--- Returns the ground of an object, and how steep that is: px along y for each px along x. It is
--- -0.5 on a slope that rises to the right by 1 px in 2. A sprite that leans with the ground turns
--- by `math.atan(gradient)`. Where gravity acts sideways both axes change places.
---
--- Errors: the object is not a table, or not in the world.
---@param object physics.NewObject a dynamic object
---@return physics.NewObject? ground nil: it stands on nothing
---@return number gradient
function default.ground(object) end

--- Returns the name of the group that an object is in: its key in `world.objects`.
---
--- Errors: the object is not a table.
---@param object physics.NewObject the object
---@return string|number|nil group nil: it is not in the world
function default.groupOf(object) end

--- Returns the velocity of an object over ground. For a rider it is its own velocity and that of
--- its carrier; for a kinematic object that you move by writing `x, y` it is that of the last step.
---
--- Errors: the object is not a table, or not in the world.
---@param object physics.NewObject the object
---@return number vx px/s
---@return number vy px/s
function default.velocity(object) end

--- Returns the side of `a` at which it is in contact with `b`. A contact lasts from `onBegin` to
--- `onEnd`, unless the game has moved the two apart since.
---
--- Errors: `a` or `b` is not a table, or not in the world.
---@param a physics.NewObject one of the two
---@param b physics.NewObject the other one
---@return physics.Side? side of `a`, nil: no contact
function default.touching(a, b) end

--- Returns a sentence that says why two objects do or do not collide. It is for debugging: the
--- words may change.
---
--- Errors: `a` or `b` is not a table.
---@param a physics.NewObject one of the two
---@param b physics.NewObject the other one
---@return string sentence
function default.explain(a, b) end

--- Draws the world as the physics sees it (LÖVE only), with your transform. Static objects are
--- slate grey, kinematic ones blue, dynamic ones red (lilac at rest). Sensors have a green outline,
--- inactive objects are faint, the solid side of a one-way object is yellow.
---
--- Errors: an unknown option, or a wrong value for one; there is no `love.graphics`.
---@param options physics.DrawOptions? the parts that are shown
function default.draw(options) end

--- Returns where to draw an object between two fixed steps (`timestep`). That is on the way from
--- its place before the last step to its place now, by the share `world.alpha`. Without a
--- `timestep` it is `object.x, object.y`, as for an object that is new, static, or was put
--- somewhere by the game.
---
--- Errors: the object is not a table.
---@param object physics.NewObject the object to draw
---@return number x px
---@return number y px
function default.interpolate(object) end
