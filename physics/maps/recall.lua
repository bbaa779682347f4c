---@diagnostic disable
--- The memory of maps, in a world and in its states: which maps of a level of several are there, by
--- which name each object was loaded, and which cells were dug. So a state finds its objects in a
--- world that has loaded the same maps anew, too.
---
--- Objects are named by their map, its place (as before any `world:shift`) and their id in the
--- editor; those of tiles by their cells. Layers that are out of the world, as `unload` leaves
--- them, are in no state.

local root = (...):match("^(.*)%.maps%.")
local cells = require(root .. ".maps.cells")
local keyOrder = require(root .. ".memory.keyOrder")
local properties = require(root .. ".maps.properties")

local NONE = {}

local recall = {}

--- Returns the memory of the maps of a world, by name: layers of tiles that are in it, and those
--- that are not, as long as the game has them; levels of several maps.
function recall.mapsOf(world)
  local b = world._bodies
  if not b.maps then
    local away = setmetatable({}, { __mode = "v" })
    b.maps = { here = {}, away = away, atlases = {}, objects = {}, names = {} }
  end
  return b.maps
end

--- Returns by which name and as which record (its field `tile`, `tiled` or `ldtk`) an object was
--- loaded; nil: it was not.
function recall.nameOf(object)
  if type(object) ~= "table" then
    return nil
  end
  local record = rawget(object, "tiled") or rawget(object, "tile") or rawget(object, "ldtk")
  if type(record) == "table" and rawequal(record._object, object) then
    if not record._name then
      local size = (" %.0f %dx%d"):format(record._order, record.columns, record.rows)
      record._name = record.tiles._name .. size
    end
    return record._name, record
  end
end

--- Notes that a layer of tiles is in the world, or is not.
function recall.setHere(layer, isHere)
  local maps, name = recall.mapsOf(layer.world), layer._name
  maps.here[name], maps.away[name] = isHere and layer or nil, not isHere and layer or nil
  layer._isAway = not isHere
end

--- Notes the layers that a map has made.
---@param layers table[] physics.Tiles
function recall.enter(world, layers)
  local here = recall.mapsOf(world).here
  for _, layer in ipairs(layers) do
    while here[layer._name] and cells.inWorld(here[layer._name])[1] do -- (not emptied by the game)
      layer._name = layer._name .. "+"
    end
    recall.setHere(layer, true)
  end
end

--- Brings maps, and tiles with the objects that wait, to where the world is now.
function recall.place(world)
  local maps, x, y = recall.mapsOf(world), world._shiftedX, world._shiftedY
  local lists = { maps.here, maps.away }
  for _, atlas in next, maps.atlases, nil do
    lists[#lists + 1] = atlas.maps
  end
  for _, list in ipairs(lists) do
    for _, part in next, list, nil do
      local dx, dy = part._baseX + x - part.x, part._baseY + y - part.y
      for _, object in ipairs(part._isAway and cells.objects(part) or NONE) do
        object.x, object.y = object.x + dx, object.y + dy
      end
      part.x, part.y = part._baseX + x, part._baseY + y
    end
  end
end

-- Saving ------------------------------------------------------------------------------------------

-- Returns the part of a state about a layer: the same table until the layer changes.
local function snapshotOf(layer)
  if not layer._snapshot then
    local changes = {}
    for n, index in ipairs(keyOrder.sorted(layer._source)) do
      changes[2 * n - 1], changes[2 * n] = index, cells.valueAt(layer, index)
    end
    layer._snapshot = changes
  end
  return layer._snapshot
end

-- Lists which objects have a name. (Which one has which is looked up only where there is another
-- object than at the last time.)
local function saveNames(maps, loaded, objects, count)
  local known, names, at = maps.objects, maps.names, 0
  for n = 1, count do
    if not rawequal(known[n], objects[n]) then
      known[n], names[n] = objects[n], recall.nameOf(objects[n]) or false
    end
    if names[n] then
      loaded[at + 1], loaded[at + 2], at = n, names[n], at + 2
    end
  end
  for k = math.max(#known, #loaded), math.min(count, at) + 1, -1 do
    known[k], loaded[k] = k <= count and known[k] or nil, k <= at and loaded[k] or nil
  end
end

--- Adds to the state `out` its part about maps (see state/format). `tables`, the objects by number,
--- gets the layers and levels to which the same world goes back.
function recall.save(world, out, tables)
  local maps = recall.mapsOf(world)
  saveNames(maps, out.loaded, tables, out.count)
  out.tiles, out.maps, tables.layers, tables.made = {}, {}, {}, {}
  for name, layer in next, maps.here, nil do
    out.tiles[name], tables.layers[name] = snapshotOf(layer), layer
  end
  for name, atlas in next, maps.atlases, nil do
    out.maps[name], tables.made[name] = atlas._there, atlas._made
  end
end

-- Restoring ---------------------------------------------------------------------------------------

-- Digs and builds until a layer has the cells of a state. (A value may be gone from the source.)
local function digTo(layer, changes)
  local goal = properties.put({}, layer._source)
  for at = 1, #changes, 2 do
    goal[changes[at]] = changes[at + 1]
  end
  for _, index in ipairs(keyOrder.sorted(goal)) do
    if pcall(cells.listOf, layer, goal[index], "") then
      cells.set(layer, index, goal[index])
    end
  end
end

--- Brings the maps and the cells of a world back to a state. Returns the layers of the state by
--- name. Errors: a map cannot be read; nothing has changed then.
---@param tables table? see `save`, of a state of this world
function recall.begin(world, st, tables)
  local maps, layers, made = recall.mapsOf(world), {}, tables and tables.made or {}
  for _, name in ipairs(tables and {} or keyOrder.sorted(maps.atlases)) do
    made[name] = maps.atlases[name]:_read(st.maps[name] or {})
  end
  for name, atlas in next, maps.atlases, nil do
    atlas:_set(made[name] or {})
  end
  for name in next, st.tiles or {}, nil do
    layers[name] = tables and tables.layers[name] or maps.here[name] or maps.away[name]
  end
  for name, layer in next, maps.here, nil do
    if layers[name] ~= layer then
      layer:unload()
    end
  end
  for name, layer in next, layers, nil do
    if layer._snapshot ~= st.tiles[name] then
      digTo(layer, st.tiles[name])
    end
  end
  return layers
end

-- Notes the objects of a list that were loaded, by name. `isOfLevel`: but for tiles, which may have
-- been dug out.
local function addNames(byName, list, isOfLevel)
  for i = 1, type(list) == "table" and #list or 0 do
    local name, record = recall.nameOf(list[i])
    if name and not (isOfLevel and record.tiles) then
      byName[name] = byName[name] or list[i]
    end
  end
end

--- Returns the objects that a state from elsewhere names, by number.
---@param layers table<string, physics.Tiles> see `begin`
function recall.find(world, st, layers)
  local byName, named = {}, {}
  for _, atlas in next, recall.mapsOf(world).atlases, nil do
    addNames(byName, atlas.objects, true) -- its map still has an object that has left the world
  end
  for _, members in next, world.objects, nil do
    addNames(byName, members)
  end
  for _, layer in next, layers, nil do
    ---@cast layer table
    addNames(byName, layer._isAway and cells.objects(layer))
  end
  for at = 1, #st.loaded, 2 do
    named[st.loaded[at]] = byName[st.loaded[at + 1]]
  end
  return named
end

--- Records which objects of tiles are in the world. `objects`: those of the state.
function recall.finish(world, st, layers, objects)
  local isOther = {} -- layers that have changed
  for name, layer in next, layers, nil do
    if layer._snapshot ~= st.tiles[name] then
      isOther[layer], layer._snapshot = true, st.tiles[name]
      cells.clear(layer)
    end
    recall.setHere(layer, true)
  end
  recall.place(world)
  for n = 1, next(isOther) and st.count or 0 do
    local _, record = recall.nameOf(objects[n])
    if record and isOther[record.tiles] then
      cells.register(record.tiles, objects[n])
    end
  end
end

require(root .. ".memory.compiler").leave(
  recall.place,
  snapshotOf,
  recall.save,
  recall.begin,
  recall.find,
  recall.finish
)

return recall
