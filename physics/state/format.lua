--- What a state holds: all that a future step depends on, as tables of plain values.
--
-- In a state, objects are numbers: first those that the library knows, in the order of the world,
-- then those that the game has added since. Lists are dense. A "sparse" list has entries one after
-- the other, for the objects only that have one; each entry begins with the number of its object.
--
--   version       of this layout
--   settings      name -> value; masks = { group, other, collides, ... }; soft = { group, other,
--                 px/s, ... }
--   saved         s, saved up for the next fixed step
--   groups        { name, count, direct, keys } in order: the known objects. Without keys: 1 to
--                 count
--   tables        { name, direct, keys, objects } in order: what the game's tables hold now; only
--                 if that differs
--   count, known  number of objects, number of known objects
--   x, y, width, height, vx, vy   one entry for each object, false: not set
--   fields        name -> sparse: value. The other fields, where they are set
--   read          name -> sparse: value, false if not set. What the library has read, where the
--                 game has written something else since
--   memory        column -> sparse: value (see LINKS, POINTS); or just objects (see FLAGS; `lost`)
--   walls         side -> object: the walls of setBounds
--   touching      sparse: object (0: none) at the left, right, top, bottom
--   contacts      first, second, and a value for each of PAIRS, for each pair that has one
--   events        three objects (0: none) and the values of EVENT each: the events that wait
--   sorted        how many of the events are in order already, nil: none; the others follow them
--   heardBy       if a callback has interrupted the first event: how many objects have heard of it,
--                 1 or 2
--   gone          fields by name of objects that have left the world, but are named in `touching`
--                 or `events`; nil: none. Their numbers follow all others
--
--   own           the game's own fields that the setting `ownFields` names (see own.lua)
--
-- The broad phase and sleep are not saved, since they change no result. Functions and the game's
-- other fields stay on the objects.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local fields = require(root .. ".world.fields")
local keyOrder = require(root .. ".memory.keyOrder")

local format = {}

--- Version of the layout of a state; states of other versions are refused.
format.VERSION = 2

-- Columns that outlive a step. A new column of this kind in layout.lua must be added here, too.

--- By slot: flags, saved where they are true.
format.FLAGS = { "moved", "inside", "jumped", "grown", "stuck", "exiting" }
--- By slot: a slot, 0 for none.
format.LINKS = { "support", "carrier", "crowd" }
--- By slot and axis: name, and the usual value or the column that has it. `last` is only for
--- drawing, in worlds with a `timestep`.
format.POINTS = {
  { "position", "written" },
  { "last", "position" },
  { "carried", 0 },
  { "kept", 0 },
  { "drift", 0 },
  { "behind", 0 },
  { "wasCrushed", false },
  { "crowdAge", 0 },
  { "knotted", 0 },
  { "knotWas", 0 },
  { "jam", 0 },
  { "jamWay", 0 },
  { "wasAt", 0 },
  { "wasSize", 0 },
}
--- By pair: name, the value of a pair with nothing to remember, and what another value becomes if
--- the two of the pair are swapped.
format.PAIRS = {
  { "contact", 0, columns.OPPOSITE },
  { "wedged", 0, columns.OPPOSITE },
  { "overlapping", false, { [true] = true } },
  { "dropping", false, { [true] = true } },
}

-- Settings that are not in SETTINGS. All but `masks`, `soft` and `order` change no result; these
-- have a format of their own.
local UNSAVED = {
  broadphase = true,
  cellSize = true,
  rest = true,
  checked = true,
  masks = true,
  soft = true,
  order = true,
  ownFields = true,
}

--- Settings in a state, in order, apart from masks, soft and order.
format.SETTINGS = {}
for _, field in ipairs(fields.settings) do
  if not UNSAVED[field.name] and field.type ~= "function" then
    format.SETTINGS[#format.SETTINGS + 1] = field.name
  end
end

--- What an event holds besides its objects (`a`, `b`, `c`).
format.EVENT = { "kind", "side", "speed", "leant", "rankA", "rankB", "x1", "y1", "x2", "y2" }

--- Returns the list of that name; makes it if there is none.
function format.listIn(owner, name)
  local list = owner[name]
  if type(list) ~= "table" then
    list = {}
    owner[name] = list
  end
  return list
end

--- Cuts off what an earlier state left behind the first n entries.
function format.cut(list, n)
  for at = #list, n + 1, -1 do
    list[at] = nil
  end
end

--- Returns a copy of a list.
function format.copyList(list)
  local copy = {}
  for n = 1, #list do
    copy[n] = list[n]
  end
  return copy
end

-- Returns a mask as { group, collides, ... }.
local function listMask(mask)
  local list = {}
  for _, group in ipairs(keyOrder.sorted(mask)) do
    list[#list + 1] = group
    list[#list + 1] = mask[group]
  end
  return list
end

-- An area as { name, value, ... }.
local function listArea(area)
  local list = {}
  for _, name in ipairs(fields.areaNames) do
    if area[name] ~= nil then
      list[#list + 1] = name
      list[#list + 1] = area[name]
    end
  end
  return list
end

--- By name: returns what a state holds of a field that is a table.
format.LISTED = { mask = listMask, area = listArea, hits = format.copyList }

--- Returns the masks of a world, or what is soft, as { group, other, value, ... }.
function format.listMasks(masks)
  local list = {}
  for _, group in ipairs(keyOrder.sorted(masks)) do
    for _, other in ipairs(keyOrder.sorted(masks[group])) do
      local n = #list
      list[n + 1], list[n + 2], list[n + 3] = group, other, masks[group][other]
    end
  end
  return list
end

return format
