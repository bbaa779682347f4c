--- A state that was changed by hand, or torn on its way, is refused before anything of it is used:
--- each row damages one place of a state that has something in every part.

local physics = require("physics")

-- Objects in the order of the state: the floor, four walls, two boxes, a ghost, the player, and one
-- that no update has seen yet.
local function newWorld()
  local world = physics.newWorld({ gravity = 600, masks = { boxes = { ghosts = false } } })
  world.order = { "floor" }
  world:add("floor", { x = 0, y = 100, width = 400, height = 20, static = true })
  world:add("boxes", { x = 10, y = 80, width = 16, height = 16, mask = { ghosts = false } })
  local box = world:add("boxes", { x = 60, y = 80, width = 16, height = 16 })
  world.objects.player = { x = 100, y = 84, width = 16, height = 16 }
  world.objects.ghosts = { odd = { x = 200, y = 84, width = 16, height = 16 } }
  world:setBounds(0, 0, 400, 300)
  world:update(1 / 60)
  box.onBegin = function()
    error("no")
  end
  while pcall(world.update, world, 1 / 60) do
  end
  box.onBegin = nil
  world:add("late", { x = 300, y = 84, width = 16, height = 16 })
  return world
end

-- Sets what a path like "groups[2].name" leads to.
local function set(state, path, value)
  local keys = {}
  for key in path:gmatch("[^%.%[%]]+") do
    keys[#keys + 1] = tonumber(key) or key
  end
  local place = state
  for n = 1, #keys - 1 do
    place = assert(place[keys[n]] ~= nil and place[keys[n]], path)
  end
  place[keys[#keys]] = value
end

local NAN, INFINITE = 0 / 0, 1 / 0

-- path, the value that is put there, what the message says
local ROWS = {
  { "version", 0, "state.version must be 2 (it was saved by another version" },
  { "settings", 1, "state.settings must be a table, got 1" },
  { "settings.push", "none", 'state.settings.push must be "both" or "first"' },
  { "settings.gravity", nil, "state.settings.gravity must be a number, got nil" },
  { "settings.masks", { "a", "b" }, "#state.settings.masks must be a multiple of 3, got 2" },
  { "settings.masks[1]", true, "state.settings.masks[1] must be a string or a number, got true" },
  { "settings.masks[3]", 0, "state.settings.masks[3] must be true or false, got 0" },
  { "settings.order", "boxes", "state.settings.order must be" },
  { "saved", -1e-8, "state.saved must be a number in 0..0.25" },
  { "saved", 0.2501, "state.saved must be a number in 0..0.25" },
  { "saved", NAN, "state.saved must be a number in 0..0.25, got nan" },
  { "count", -1, "state.count must be an integer in 0..2147483648, got -1" },
  { "count", 10.5, "state.count must be an integer in 0..2147483648, got 10.5" },
  { "count", INFINITE, "state.count must be an integer in 0..2147483648, got inf" },
  { "count", "10", 'state.count must be an integer in 0..2147483648, got "10"' },
  { "known", 11, "state.known must be an integer in 0..10, got 11" },
  { "known", 8, "state.known must be 9, as many as the groups have, got 8" },
  { "groups", nil, "state.groups must be a table, got nil" },
  { "groups[2]", false, "state.groups[2] must be a table, got false" },
  { "groups[2].count", 10, "state.groups[2].count must be an integer in 0..9, got 10" },
  { "groups[2].name", "floor", 'state.groups[2].name must be a name that is there once, got "fl' },
  { "groups[2].name", NAN, "state.groups[2].name must be a name that is there once, got nan" },
  { "groups[2].name", true, "state.groups[2].name must be a name that is there once, got true" },
  { "groups[1].direct", nil, "state.groups[1].direct must be true or false, got nil" },
  { "groups[3].direct", true, "state.groups[3].count must be 1, got 2" },
  { "groups[2].keys[4]", nil, "#state.groups[2].keys must be 4, got 3" },
  { "groups[2].keys[4]", "left", "state.groups[2].keys[4] must be a key that is there once" },
  { "groups[2].keys[1]", {}, "state.groups[2].keys[1] must be a string or a number" },
  { "tables", nil, "state.count must be 9, got 10" },
  { "tables", true, "state.tables must be a table, got true" },
  { "tables[1]", 1, "state.tables[1] must be a table, got 1" },
  { "tables[1].objects[1]", 11, "state.tables[1].objects[1] must be an integer in 1..10, got 11" },
  { "tables[1].objects[1]", 0, "state.tables[1].objects[1] must be an integer in 1..10, got 0" },
  { "tables[1].keys", nil, "state.tables[1].keys must be a table, got nil" },
  { "tables[3].objects[2]", 6, "state.tables[3].objects[2] must be an object that is there once" },
  { "tables[4].name", "boxes", "state.tables[4].name must be a name that is there once" },
  { "tables[5]", nil, "state.tables must be a place for object 10, got nil" },
  { "x[11]", 0, "#state.x must be 10, got 11" },
  { "y", nil, "state.y must be a table, got nil" },
  { "x[1]", NAN, "objects.floor[1].x must be a number, got nan" },
  { "height[2]", -1, "objects.bounds.bottom.height must be a number > 0, got -1" },
  { "width[8]", false, "objects.ghosts.odd.width must be a number > 0, got false" },
  { "vx[7]", "no", 'objects.boxes[2].vx must be a number, got "no"' },
  { "vy[9]", INFINITE, "objects.player.vy must be" },
  { "width[10]", 0, "new object 10.width must be a number > 0, got 0" },
  { "fields", nil, "state.fields must be a table, got nil" },
  { "fields.mass", nil, "state.fields.mass must be a table, got nil" },
  { "fields.mass", { 1 }, "#state.fields.mass must be even, got 1" },
  { "fields.mass", { 0, 1 }, "state.fields.mass[1] must be an integer in 1..10, got 0" },
  { "fields.mass", { 11, 1 }, "state.fields.mass[1] must be an integer in 1..10, got 11" },
  { "fields.mass", { 2, 1, 2, 1 }, "state.fields.mass[3] must be > 2, got 2" },
  { "fields.mass", { 9, false }, "objects.player.mass must be a number > 0, got false" },
  { "fields.mask", { 6, { "a" } }, "#state.fields.mask[2] must be a multiple of 2, got 1" },
  { "fields.mask", { 6, { "a", 1 } }, "state.fields.mask[2][2] must be true or false, got 1" },
  { "fields.mask", { 6, false }, "state.fields.mask[2] must be a table, got false" },
  { "read", 0, "state.read must be a table, got 0" },
  { "read.mass", { 10, 1 }, "state.read.mass[1] must be an integer in 1..9, got 10" },
  { "read.x", { 7, "here" }, 'objects.boxes[2].x must be a number, got "here"' },
  { "memory", nil, "state.memory must be a table, got nil" },
  { "memory.moved", { 10 }, "state.memory.moved[1] must be an integer in 1..9, got 10" },
  { "memory.moved", { 7, 6 }, "state.memory.moved[2] must be > 7, got 6" },
  { "memory.lost", { 0 }, "state.memory.lost[1] must be an integer in 1..9, got 0" },
  { "memory.carrier", { 6 }, "#state.memory.carrier must be a multiple of 2, got 1" },
  { "memory.carrier", { 6, 10 }, "state.memory.carrier[2] must be an integer in 1..9, got 10" },
  {
    "memory.carried",
    { 6, 1, "a" },
    "state.memory.carried[3] must be a number in -1e+100..1e+100",
  },
  { "memory.carried", { 6, 1e101, 0 }, "state.memory.carried[2] must be a number in -1e+100..1e" },
  { "memory.wasCrushed", { 6, 1, true }, "state.memory.wasCrushed[2] must be true or false, got" },
  { "touching[2]", 11, "state.touching[2] must be an integer in 0..10, got 11" },
  { "touching[1]", 0, "state.touching[1] must be an integer in 1..9, got 0" },
  { "walls", nil, "state.walls must be a table, got nil" },
  { "walls.left", 0, 'state.walls."left" must be an integer in 1..10, got 0' },
  { "walls.left", 11, 'state.walls."left" must be an integer in 1..10, got 11' },
  { "walls[1]", 2, "state.walls.1 must be an integer in 1..10, got 2" },
  { "contacts[25]", 1, "#state.contacts must be a multiple of 6, got 25" },
  { "contacts[1]", 10, "state.contacts[1] must be an integer in 1..9, got 10" },
  { "contacts[2]", 1, "state.contacts[2] must be > 1, got 1" },
  { "contacts[8]", 6, "state.contacts[8] must be behind the pair before it, got 6" },
  { "contacts[14]", 6, "state.contacts[14] must be behind the pair before it, got 6" },
  { "contacts[3]", 5, "state.contacts[3] must be a contact of a pair, got 5" },
  { "contacts[4]", true, "state.contacts[4] must be a wedged of a pair, got true" },
  { "contacts[5]", 0, "state.contacts[5] must be a overlapping of a pair, got 0" },
  { "events[3]", 11, "state.events[3] must be an integer in 0..10, got 11" },
  { "events[1]", 0, "state.events[1] must be an integer in 1..10, got 0" },
  { "events[4]", 0, "state.events[4] must be an integer in 1..5, got 0" },
  { "events[4]", 6, "state.events[4] must be an integer in 1..5, got 6" },
  { "events[5]", 0, "state.events[5] must be a side, got 0" },
  { "events[5]", 5, "state.events[5] must be a side, got 5" },
  { "events[5]", "x", 'state.events[5] must be a side of this kind of event, got "x"' },
  { "events[4]", 5, "state.events[5] must be a side of this kind of event, got 3" },
  { "events[6]", NAN, "state.events[6] must be a number in -1e+100..1e+100" },
  { "heardBy", 0, "state.heardBy must be nil, or 1 or 2 where events wait, got 0" },
  { "heardBy", 3, "state.heardBy must be nil, or 1 or 2 where events wait, got 3" },
  { "sorted", false, "state.sorted must be nil, or an integer in 0..1, got false" },
  { "sorted", 2, "state.sorted must be nil, or an integer in 0..1, got 2" },
  { "gone", 1, "state.gone must be a table, got 1" },
  { "gone", { 1 }, "state.gone[1] must be a table, got 1" },
  { "gone", { { width = 0 } }, "state.gone[1].width must be a number > 0, got 0" },
  { "gone", { { mask = { 1 } } }, "#state.gone[1].mask must be a multiple of 2, got 1" },
  { "events", {}, "state.heardBy must be nil, or 1 or 2 where events wait, got 2" },
}

describe("a damaged state", function()
  for _, row in ipairs(ROWS) do
    local path, value, text = row[1], row[2], row[3]
    it("is refused: " .. path .. " = " .. tostring(value), function()
      local world = newWorld()
      local state, hash = world:save(), world:hash()
      set(state, path, value)
      local ok, message = pcall(function()
        world:restore(state)
      end)
      assert.is_false(ok)
      local start = "physics: world:restore(state): "
      assert.is_truthy(message:find(start .. text, 1, true), message)
      assert.are.equal(hash, world:hash())
    end)
  end
end)

describe("a state at its limits", function()
  for _, row in ipairs({
    { "saved", -1e-10 },
    { "saved", 0.25 },
    { "heardBy", 1 },
    { "heardBy", nil },
    { "sorted", nil },
    { "gone", { {}, { x = 1, static = true, mask = { "boxes", false } } } },
    { "read.mass", { 9, false } },
    { "settings.order", nil },
    { "walls.left", 10 },
    { "contacts[19]", 2 },
    { "memory.wasCrushed", { 6, true, false } },
  }) do
    it("is accepted: " .. row[1] .. " = " .. tostring(row[2]), function()
      local world = newWorld()
      local state = world:save()
      set(state, row[1], row[2])
      world:restore(state)
      world:update(1 / 60)
      assert.are.equal(10, world.stats.objects)
    end)
  end
end)
