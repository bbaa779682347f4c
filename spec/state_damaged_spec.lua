--- world:restore, given what is no state, or a damaged one: it is refused in these words, and
--- nothing has changed.

local effort = require("spec.support.effort")
local physics = require("physics")
local small = require("spec.support.small")
local states = require("spec.support.states")

effort.interpretQuickly(setup, teardown)

local DT = 1 / 60
local put = states.put

-- Objects in the order of the state: the floor, four walls, two boxes, a ghost, the player, and one
-- that no update has seen yet.
local function newFull()
  local world = physics.newWorld({ gravity = 600, masks = { boxes = { ghosts = false } } })
  world.order = { "floor" }
  world:add("floor", { x = 0, y = 100, width = 400, height = 20, static = true })
  world:add("boxes", { x = 10, y = 80, width = 16, height = 16, mask = { ghosts = false } })
  local box = world:add("boxes", { x = 60, y = 80, width = 16, height = 16 })
  world.objects.player = { x = 100, y = 84, width = 16, height = 16 }
  world.objects.ghosts = { odd = { x = 200, y = 84, width = 16, height = 16 } }
  world:setBounds(0, 0, 400, 300)
  world:update(DT)
  box.onBegin = function()
    error("no")
  end
  while pcall(world.update, world, DT) do
  end
  box.onBegin = nil
  world:add("late", { x = 300, y = 84, width = 16, height = 16 })
  return world
end

local NAN, INFINITE = 0 / 0, 1 / 0

-- path, the value that is put there, what the message says
local ROWS = {
  { "version", 2, "state.version must be 11, got 2: an older version of the library wrote it" },
  { "version", 10, "state.version must be 11, got 10: an older version of the library wrote it" },
  { "version", 12, "state.version must be 11, got 12: a newer version of the library wrote it" },
  { "settings", 1, "state.settings must be a table, got 1" },
  { "settings.push", "none", 'state.settings.push must be "both" or "first"' },
  { "settings.gravity", nil, "state.settings.gravity must be a number, got nil" },
  { "settings.masks", { "b" }, "state.settings.masks[1] must be a table { [group] = false }" },
  { "settings.order", "boxes", "state.settings.order must be" },
  { "saved", -1e-8, "state.saved must be a number in -1e-09..0.25" },
  { "count", 9, "state.count must be an integer in 10..10, got 9" },
  { "groups[1].count", 0, "state.count must be an integer in 9..9, got 10" },
  { "count", 10.5, "state.count must be an integer in 0..2147483648, got 10.5" },
  { "groups", nil, "state.groups must be a table, got nil" },
  { "groups[2].count", 10, "#state.groups[2].keys must be an integer in 10..10, got 4" },
  { "groups[2].name", "floor", 'state.groups[2].name must be a name that is there once, got "fl' },
  { "groups[1].direct", nil, "state.groups[1].direct must be true or false, got nil" },
  { "groups[3].direct", true, "state.groups[3].count must be an integer in 1..1, got 2" },
  { "groups[2].keys[4]", nil, "#state.groups[2].keys must be an integer in 4..4, got 3" },
  { "groups[2].keys[4]", "left", "state.groups[2].keys[4] must be a key that is there once" },
  { "boxes", nil, "state.boxes must be a table, got nil" },
  { "boxes[21]", 0, "#state.boxes must be an integer in 20..20, got 21" },
  { "boxes[1]", NAN, "state.boxes[1] must be a number, got nan" },
  { "boxes[2]", 1e101, "state.boxes[2] must be a number in" },
  { "boxes[19]", false, "state.boxes[19] must be a number > 0, got false" },
  { "boxes[20]", 0, "state.boxes[20] must be a number > 0, got 0" },
  { "boxes[20]", "1", 'state.boxes[20] must be a number > 0, got "1"' },
  { "others", nil, "state.others must be a table, got nil" },
  { "others[1]", 11, "state.others[1] must be an integer in 1..10, got 11" },
  { "others[2]", 6, "state.others[2] must be an integer in 7..10, got 6" },
  { "others[5]", nil, "#state.boxes must be an integer in 24..24, got 20" },
  { "fields", nil, "state.fields must be a table, got nil" },
  { "fields[5]", nil, "state.fields[5] must be a table, got nil" },
  { "fields[1].static", 1, "state.fields[1].static must be true or false, got 1" },
  { "fields[2].vy", INFINITE, "state.fields[2].vy must be a finite number, got inf" },
  { "fields[2].x", nil, "state.fields[2].x must be a number, got nil" },
  { "fields[1].mass", 0, "state.fields[1].mass must be a number > 0, got 0" },
  { "settings.masks", { a = { [INFINITE] = false } }, "state.settings.masks.a must have" },
  { "fields[1].mask", { a = 1 }, "state.fields[1].mask.a must be true or false, got 1" },
  { "fields[1].radius", 5, "state.fields[1].radius must be half of width and height, which" },
  { "fields[2].slope", "left", "state.fields[2].slope must be nil for a dynamic object" },
  { "fields[4].area", { drag = 1 }, "state.fields[4].area must be nil unless the object is a" },
  { "memory", nil, "state.memory must be a table, got nil" },
  {
    "memory.moved",
    { 7, 1, 6, 1 },
    "state.memory.moved[3] must be an integer in 8..10, got 6",
  },
  { "memory.moved", { 6, 3 }, "state.memory.moved[2] must be an integer in 1..2, got 3" },
  { "memory.carrier", { 6, 11 }, "state.memory.carrier[2] must be an integer in 1..10, got 11" },
  { "memory.carried", { 6, 1, "a" }, 'state.memory.carried[3] must be a number, got "a"' },
  { "memory.wasCrushed", { 6, 1, true }, "state.memory.wasCrushed[2] must be true or false, got" },
  { "touching[2]", 11, "state.touching[2] must be an integer in 0..10, got 11" },
  { "contacts[25]", 1, "#state.contacts must be an integer in 24..24, got 25" },
  { "contacts[1]", 11, "state.contacts[1] must be an integer in 1..10, got 11" },
  { "contacts[2]", 1, "state.contacts[2] must be an integer in 2..10, got 1" },
  { "contacts[3]", 5, "state.contacts[3] must be an integer in 0..4, got 5" },
  { "contacts[4]", true, "state.contacts[4] must be an integer in 0..4, got true" },
  { "contacts[6]", true, "state.contacts[6] must be a number, got true" },
  { "contacts[6]", 1 / 0, "state.contacts[6] must be a finite number, got inf" },
  { "events[3]", 11, "state.events[3] must be an integer in 0..10, got 11" },
  { "events[4]", 0, 'state.events[4] must be "onBegin", "onStay", "onEnd" or "onCrush", got 0' },
  { "events[5]", "x", 'state.events[5] must be an integer in 1..4, got "x"' },
  { "events[4]", "onCrush", 'state.events[5] must be "x" or "y", got 3' },
  { "events[6]", NAN, "state.events[6] must be a number, got nan" },
  { "heardBy", 4, "state.heardBy must be an integer in 0..3, got 4" },
  { "gone", 1, "state.gone must be a table, got 1" },
  { "gone[1]", 1, "state.gone[1] must be a table, got 1" },
  { "gone[1]", { mass = 0 }, "state.gone[1].mass must be a number > 0, got 0" },

  { "memory.support", { 6, 0 }, "state.memory.support[2] must be an integer in 1..10, got 0" },
  { "events", { 1 }, "#state.events must be" },
  { "own", false, "state.own must be a list of names of fields, got false" },
  { "shiftedX", NAN, "state.shiftedX must be a number, got nan" },
  { "shiftedY", "1", 'state.shiftedY must be a number, got "1"' },
  { "tiles", { a = 1 }, "state.maps must be a table, got nil" },
  { "events", {}, "state.heardBy must be an integer in 0..0, got 2" },
}

small.rows("world:restore, a damaged state is refused: {1} = {2}", ROWS, function(path, value, text)
  local world = newFull()
  local state, hash = world:save(), world:hash()
  put(state, path, value)
  small.refuses("world:restore(state): " .. text, world.restore, world, state)
  assert.are.equal(hash, world:hash())
end)

describe("world:restore, a damaged state of a world with maps", function()
  small.rows("is refused: {1} = {2}", {
    { "maps", nil, "state.maps must be a table, got nil" },
    { "maps", { a = 1 }, "state.maps.a must be a table, got 1" },
    { "tiles", nil, "state.tiles must be a table, got nil" },
    { "tiles.a", 1, "state.tiles.a must be a table, got 1" },
    { "tiles.a", { 0, 1 }, "state.tiles.a[1] must be an integer in 1.." },
    { "tiles.a", { 2, 1, 1, 1 }, "state.tiles.a[3] must be an integer in 3" },
  }, function(path, value, words)
    local world = physics.newWorld()
    world:addTiles("earth", { "##" }, nil, 16):setTile(1, 1, 0)
    local state, hash = states.read(states.write(world:save())), world:hash()
    put(state, path, value)
    small.refuses("world:restore(state): " .. words, world.restore, world, state)
    assert.are.equal(hash, world:hash())
  end)

  it("is taken where it names cells, boxes or objects that are not there", function()
    local world = physics.newWorld()
    local tiles = world:addTiles("earth", { "##" }, nil, 16)
    local state = states.read(states.write(world:save()))
    state.tiles = { [next(state.tiles)] = { 2, {}, 3, "#", 99, "#" }, b = {} }
    state.loaded = { 1, "b" }
    world:restore(state)
    assert.are.same({ 0, "#" }, { tiles.tiles, tiles:getTile(2, 1) })
    world:update(DT)
  end)
end)

it("world:restore, what is no state is refused", function()
  local world = newFull()
  local hash = world:hash()
  for text, value in pairs({
    ["state must be a table, got nil"] = false,
    ['state must be a table, got "state"'] = "state",
    ["state.version must be 11, got nil: this is no state"] = {},
  }) do
    small.refuses("world:restore(state): " .. text, world.restore, world, value or nil)
    assert.are.equal(hash, world:hash())
  end
end)

small.rows("world:restore, a state at its limits is accepted: {1} = {2}", {
  { "saved", -1e-10 },
  { "saved", 0.25 },
  { "heardBy", 1 },
  { "heardBy", nil },
  { "sorted", nil },
  { "settings.order", nil },
  { "contacts[19]", 2 },
  { "memory.wasCrushed", { 6, true, false } },
}, function(path, value)
  local world = newFull()
  local state = world:save()
  put(state, path, value)
  world:restore(state)
  world:update(DT)
  assert.are.equal(10, world.stats.objects)
end)
