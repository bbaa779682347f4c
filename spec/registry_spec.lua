--- Which objects are in the world, and in which order, whatever the game does to its tables between
--- updates.

local newRandom = require("spec.support.random").new
local physics = require("physics")
local registry = require("physics.objects.registry")

local NAMES = { 7, "crates", "tiles" }

local function comesBefore(a, b)
  if type(a) ~= type(b) then
    return type(a) == "number"
  end
  return a < b
end

-- All objects in the order that the README promises, with group and key.
local function inOrder(objects)
  local list = {}
  for _, name in ipairs(NAMES) do
    local keys = {}
    for key in pairs(objects[name] or {}) do
      keys[#keys + 1] = key
    end
    table.sort(keys, comesBefore)
    for _, key in ipairs(keys) do
      list[#list + 1] = { object = objects[name][key], name = name, key = key }
    end
  end
  return list
end

-- A world that knows only its objects. `isBroken(object)`: it fails while it is read.
local function newBook(isBroken)
  local b = { object = { [0] = false }, slotOf = {}, group = {}, key = {}, rank = {}, free = {} }
  b.count, b.entered, b.left = 0, 0, 0
  function b.enter(_, object, record, key)
    assert(not isBroken(object), "fails when it is read")
    local slot = table.remove(b.free) or #b.object + 1
    b.object[slot], b.slotOf[object], b.group[slot], b.key[slot] = object, slot, record, key
    b.count, b.entered = b.count + 1, b.entered + 1
    return slot
  end
  function b.leave(_, slot)
    assert(b.slotOf[b.object[slot]] == slot, "leaves twice")
    b.slotOf[b.object[slot]] = nil
    b.object[slot], b.group[slot] = false, false
    b.free[#b.free + 1] = slot
    b.count, b.left = b.count - 1, b.left + 1
  end
  function b.rename(_, slot, record)
    b.group[slot] = record
  end
  return b
end

local function update(b, r, objects)
  return registry.update(b, r, objects, b.enter, b.leave, b.rename)
end

-- Where each object stands: in which table, and at which place.
local function placesOf(objects)
  local places = {}
  for n, entry in ipairs(inOrder(objects)) do
    places[entry.object] = { group = objects[entry.name], at = n }
  end
  return places
end

-- Finds objects that stand in the same table as before, behind one that they stood before.
local function movedSince(places, objects)
  local moved, last, group = {}, 0, nil
  for _, entry in ipairs(inOrder(objects)) do
    local old = places[entry.object]
    if group ~= objects[entry.name] then
      group, last = objects[entry.name], 0
    end
    if old and old.group == group then
      moved[entry.object] = old.at < last or nil
      last = math.max(last, old.at)
    end
  end
  return moved
end

-- Updates, and checks which objects the registry reports as moved.
local function updateMoved(b, r, objects, places)
  local expected, found = movedSince(places, objects), {}
  registry.update(b, r, objects, b.enter, b.leave, b.rename, function(_, slot, isRenamed)
    found[b.object[slot]] = not isRenamed or nil
  end)
  for _, entry in ipairs(inOrder(objects)) do
    assert.equal(expected[entry.object], found[entry.object])
  end
end

-- What is wrong with what the book has of an entry, which comes behind rank `last`; nil: nothing.
local function problemOf(b, entry, last)
  local slot = b.slotOf[entry.object]
  if not slot or b.object[slot] ~= entry.object then
    return "is not known"
  elseif b.key[slot] ~= entry.key or b.group[slot].name ~= entry.name then
    return "is known under " .. b.group[slot].name .. ", " .. b.key[slot]
  elseif b.rank[slot] <= last then
    return "is out of order"
  end
end

local function assertKnows(b, objects)
  local expected, last = inOrder(objects), -1
  assert.equal(#expected, b.count)
  for _, entry in ipairs(expected) do
    local problem = problemOf(b, entry, last)
    if problem then
      error(("objects.%s[%s] %s"):format(entry.name, entry.key, problem))
    end
    last = b.rank[b.slotOf[entry.object]]
  end
end

local function newObject()
  return { x = 0, y = 0, width = 1, height = 1 }
end

-- (A list with a hole may end before it.)
local function removeAt(list, n)
  if n <= #list then
    table.remove(list, n)
  end
end

-- What a game does to a group, by list.
local EDITS = {
  function(list)
    list[#list + 1] = newObject()
  end,
  function(list, random)
    table.remove(list, random:integer(1, #list))
  end,
  function(list, random)
    table.insert(list, random:integer(1, #list), newObject())
  end,
  function(list, random) -- an explosion
    for _ = 1, random:integer(2, 50) do
      removeAt(list, random:integer(1, math.max(#list, 1)))
    end
  end,
  function(list, random) -- some that stand side by side
    local first = random:integer(1, #list)
    for _ = 1, random:integer(2, 50) do
      removeAt(list, first)
    end
  end,
  function(list, random) -- goes to the end
    table.insert(list, table.remove(list, random:integer(1, #list)))
  end,
  function(list, random) -- fills the hole with the last one
    list[random:integer(1, #list)] = list[#list]
    list[#list] = nil
  end,
  function(list, random)
    local i, j = random:integer(1, #list), random:integer(1, #list)
    list[i], list[j] = list[j], list[i]
  end,
  function(list, random)
    list[random:integer(1, #list)] = newObject()
  end,
  function(list)
    list[#list] = nil
  end,
  function(list, random, other) -- moves to another group
    local object = table.remove(list, random:integer(1, #list))
    table.insert(other, random:integer(1, #other + 1), object)
  end,
  function(list, random)
    list["n" .. random:integer(1, 5)] = newObject()
  end,
  function(list, random)
    list["n" .. random:integer(1, 5)] = nil
  end,
  function(list, random) -- a hole, which is closed again
    local object = table.remove(list)
    list[#list + random:integer(1, 3)] = object
  end,
  function(list)
    for key, object in pairs(list) do
      if type(key) == "number" and key > #list then
        list[key] = nil
        table.insert(list, object)
        return
      end
    end
  end,
}

local function edit(objects, random)
  local name, other = random:pick(NAMES), random:pick(NAMES)
  if random:chance(0.02) then
    objects[name] = {}
  end
  local list = objects[name]
  while #list < 3 do
    list[#list + 1] = newObject()
  end
  random:pick(EDITS)(list, random, objects[other])
end

-- Groups of so many; with a generator they are filled out of order, as by id.
local function fill(size, random)
  local objects, ids = {}, {}
  for n = 1, size do
    ids[n] = n
  end
  for _, name in ipairs(NAMES) do
    objects[name] = {}
    for _, n in ipairs(random and random:shuffled(ids) or ids) do
      objects[name][n] = newObject()
    end
  end
  return objects
end

describe("the registry", function()
  for _, size in ipairs({ 4, 100 }) do
    for seed = 1, 12 do
      local tag = seed > 4 and " #slow" or ""
      local edited = ("knows all objects after edits of groups of %d, seed %d"):format(size, seed)
      it(edited .. tag, function()
        local random = newRandom(seed)
        local objects = fill(size, size < 64 and seed % 2 == 0 and random)
        local b, r, places = newBook(function() end), registry.new(), {}
        for _ = 1, 80 do
          updateMoved(b, r, objects, places)
          assertKnows(b, objects)
          places = placesOf(objects)
          for _ = 1, random:integer(0, 4) do
            edit(objects, random)
          end
        end
        assert.equal(b.count, b.entered - b.left)
      end)

      local failed = ("recovers from objects that fail, groups of %d, seed %d"):format(size, seed)
      it(failed .. tag, function()
        local random = newRandom(1000 + seed)
        local objects = fill(size, size < 64 and seed % 2 == 0 and random)
        local broken, failures = {}, 0
        local b, r =
          newBook(function(object)
            return broken[object]
          end), registry.new()
        update(b, r, objects)
        for _ = 1, 80 do
          for _ = 1, random:integer(1, 4) do
            edit(objects, random)
          end
          for _, entry in ipairs(inOrder(objects)) do
            broken[entry.object] = not b.slotOf[entry.object] and random:chance(0.2)
          end
          local isDone, problem = pcall(update, b, r, objects)
          while not isDone do
            assert.matches("fails when it is read", problem, 1, true)
            failures = failures + 1
            edit(objects, random)
            broken = random:chance(0.3) and {} or broken
            isDone, problem = pcall(update, b, r, objects)
          end
          assertKnows(b, objects)
        end
        assert.is_true(failures > 5)
      end)
    end
  end

  it("loses no object of a group filled by id when one goes", function()
    for _, n in ipairs({ 71, 271, 1025 }) do
      for seed = 1, 10 do
        local random = newRandom(seed)
        local objects = fill(n, random)
        objects.crates, objects[7] = {}, {}
        local b, r = newBook(function() end), registry.new()
        update(b, r, objects)
        objects.tiles[random:integer(n - 10, n)] = nil
        update(b, r, objects)
        assertKnows(b, objects)
        objects.tiles.boss = newObject()
        table.insert(objects.tiles, newObject()) -- with the numbers changes what is known of names
        update(b, r, objects)
        assertKnows(b, objects)
      end
    end
  end)

  it("sees that an object was replaced by one that is equal by a metamethod", function()
    local class = {
      __eq = function()
        return true
      end,
    }
    local function newEqual()
      local object = newObject()
      object.static = true
      return setmetatable(object, class)
    end
    local objects = { crates = setmetatable({ newEqual() }, class), tiles = newEqual(), [7] = {} }
    objects.walls = { newEqual(), newEqual() }
    local b, r = newBook(function() end), registry.new()
    update(b, r, objects)
    local old, wall = objects.tiles, objects.walls[2]
    objects.tiles, objects.crates = newEqual(), setmetatable({ newEqual(), newEqual() }, class)
    objects.walls[2] = newEqual()
    update(b, r, objects)
    assert.is_nil(rawget(b.slotOf, old))
    assert.is_nil(rawget(b.slotOf, wall))
    assert.is_not_nil(rawget(b.slotOf, objects.walls[2]))
    assert.equal(5, b.count)
  end)

  it("sees that too where they became members of their class later", function()
    local class = {
      __eq = function(one, other)
        return one.id == other.id
      end,
    }
    for _, row in ipairs({ { "movers" }, { "static ones that are refreshed", true } }) do
      local isStatic = row[2]
      local world = physics.newWorld({ gravity = 0 })
      local function newBox(x)
        return { id = 1, x = x, y = 0, width = 10, height = 10, vx = 60, static = isStatic }
      end
      local first, second = world:add("a", newBox(0)), setmetatable(newBox(100), class)
      world:update(1 / 60)
      assert.equal(1, select(2, world:queryPoint(5, 5)))
      setmetatable(first, class)
      if isStatic then
        world:refresh(first)
        world:update(1 / 60)
      end
      world.objects.a[1] = second
      world:update(1 / 60)
      assert.equal(isStatic and 100 or 101, second.x)
      local found, count = world:queryPoint(105, 5)
      assert.equal(1, count, row[1])
      assert.is_true(rawequal(second, found[1]))
      assert.is_false(world:remove(first))
    end
  end)

  -- On plain Lua the number after the last one may stand before that, where others have gone.
  it("sees an object that is added to a table that holds its numbers in any order", function()
    local tried = 0
    for late = 1, 9 do
      for gone = 1, 9 do
        for count = 65, 68 do
          local group = {}
          for i = 1, 64 - late do
            group[i] = newObject()
          end
          for i = 65, 64 + gone do
            group[i] = true
          end
          for i = 65, 64 + gone do
            group[i] = nil
          end
          for i = 65 - late, count do
            group[i] = newObject()
          end
          local objects = { group = group }
          local b, r = newBook(function() end), registry.new()
          update(b, r, objects)
          table.insert(group, newObject())
          update(b, r, objects)
          tried = tried + 1
          assert.equal(count + 1, b.count, late .. " " .. gone .. " " .. count)
        end
      end
    end
    assert.equal(324, tried)
  end)

  -- Passes the check, and fails when it is read.
  local function newUnreadable()
    local reads = 0
    return setmetatable(newObject(), {
      __index = function(_, field)
        reads = reads + (field == "drag" and 1 or 0)
        if reads == 2 then
          error("does not want to be read again", 0)
        end
      end,
    })
  end

  it("moves all but the static ones, whatever has left and come", function()
    local random = newRandom(5)
    local world, objects = physics.newWorld({ gravity = 800 }), {}
    world.objects.tiles = objects
    local function newAny(isBroken)
      return {
        x = random:integer(-1e6, 1e6),
        y = 0,
        width = isBroken and -1 or 1,
        height = 1,
        static = random:chance(0.9),
      }
    end
    for n = 1, 200 do
      objects[n] = newAny()
    end
    for step = 1, 400 do
      for _ = 1, random:integer(0, 3) do
        table.remove(objects, random:integer(1, #objects))
      end
      for _ = 1, random:integer(0, 3) do
        table.insert(objects, random:chance(0.8) and #objects + 1 or 1, newAny())
      end
      if step % 20 == 0 then
        objects[#objects + 1] = newAny(true)
        assert.has_error(function()
          world:update(1 / 60)
        end)
        objects[#objects] = nil
        table.remove(objects, 1)
      elseif step % 20 == 10 then
        table.remove(objects, 1)
        world.objects.zoo = { newUnreadable() } -- is read when the tiles are known
        assert.has_error(function()
          world:update(1 / 60)
        end, "does not want to be read again")
        world.objects.zoo = nil
        table.remove(objects, #objects - 10)
      elseif step % 30 == 7 then
        local object = objects[random:integer(1, #objects)]
        object.static = not object.static
        world:refresh(object)
      end
      local before = {}
      for n, object in ipairs(objects) do
        before[n] = object.y
      end
      world:update(1 / 60)
      for n, object in ipairs(objects) do
        assert.equal(not object.static, object.y > before[n])
      end
    end
  end)

  it("names where an object stands that has moved up, if it stands elsewhere, too", function()
    for _, gone in ipairs({ { 2 }, { 2, 3 }, { 9, 2 } }) do
      local objects = fill(100)
      local b, r = newBook(function() end), registry.new()
      update(b, r, objects)
      local twice, again = objects.tiles[50], nil
      for _, n in ipairs(gone) do
        again = table.remove(objects.tiles, n)
      end
      objects.crates[101], objects.crates[102] = again, twice -- one may move, not both
      assert.has_error(
        function()
          update(b, r, objects)
        end,
        "physics: objects.crates[102] is the same object as objects.tiles["
          .. (50 - #gone)
          .. "]: an object must be in one place only, got table in two"
      )
      objects.crates[102] = nil
      update(b, r, objects)
      assertKnows(b, objects)
    end
  end)

  -- Looking through all numbers before the one that it had would take for ever.
  it("finds one at once that stood under a large number, and does no more", function()
    local world = physics.newWorld()
    for _, id in ipairs({ 2 ^ 50, 2 ^ 50 + 0.5, -3 }) do
      local object, other = newObject(), newObject()
      world.objects.crates = { [id] = object, boss = other }
      world:update(1 / 60)
      world.objects.crates[id], world.objects.crates.hero = nil, object
      assert.is_true(world:remove(object))
      assert.is_nil(world.objects.crates.hero)
      assert.is_false(world:remove(object))
      assert.equal(other, world.objects.crates.boss)
    end
  end)

  it("changes nothing when a newcomer is of no use", function()
    local objects = fill(100)
    local b, r = newBook(function() end), registry.new()
    update(b, r, objects)
    local removed = table.remove(objects.tiles, 3)
    objects.crates[101] = { x = 0, y = 0, width = -1, height = 1 }
    assert.has_error(function()
      update(b, r, objects)
    end, "physics: objects.crates[101].width must be a number > 0, got -1")
    assert.equal(300, b.count)
    assert.is_not_nil(b.slotOf[removed])
    objects.crates[101] = nil
    update(b, r, objects)
    assertKnows(b, objects)
  end)
end)

describe("an object in two places is named with both", function()
  local function refused(objects, change, message)
    local world = physics.newWorld()
    world.objects = objects
    world:update(0)
    change(objects)
    local isDone, found = pcall(world.update, world, 0)
    assert.is_false(isDone)
    assert.matches(message, found, 1, true)
  end

  it("in one group, behind what has not changed", function()
    refused(fill(100), function(objects)
      objects.tiles[101] = objects.tiles[4]
    end, "objects.tiles[101] is the same object as objects.tiles[4]")
  end)

  it("in one group, both in what has changed", function()
    refused(fill(100), function(objects)
      table.remove(objects.tiles, 2)
      objects.tiles[100] = objects.tiles[50]
    end, "objects.tiles[100] is the same object as objects.tiles[50]")
  end)

  it("in two groups, one of which has not changed", function()
    refused(fill(100), function(objects)
      objects.tiles[101] = objects.crates[100]
    end, "objects.tiles[101] is the same object as objects.crates[100]")
  end)

  it("in two groups, both changed", function()
    refused(fill(100), function(objects)
      table.remove(objects.crates, 99)
      objects.tiles[50] = objects.crates[98]
    end, "objects.tiles[50] is the same object as objects.crates[98]")
  end)

  it("newcomers in one group", function()
    refused(fill(3), function(objects)
      local object = newObject()
      objects.tiles[4], objects.tiles[5] = object, object
    end, "objects.tiles[5] is the same object as objects.tiles[4]")
  end)

  it("newcomers in two groups", function()
    refused(fill(3), function(objects)
      local object = newObject()
      objects.crates[4], objects.tiles[4] = object, object
    end, "objects.tiles[4] is the same object as objects.crates[4]")
  end)
end)

describe("one of many", function()
  local COUNT = 5000
  -- Bytes: less than two for each of the others. (On Lua 5.2 and 5.3 three KB are the stack, which
  -- the collector has shrunk and which grows again.)
  local FEW = 8192

  local function level()
    local world = physics.newWorld()
    for n = 0, COUNT - 1 do
      local row = math.floor(n / 100)
      world:add(
        "tiles",
        { x = 16 * (n - 100 * row), y = 16 * row, width = 16, height = 16, static = true }
      )
    end
    world:update(1 / 60)
    return world
  end

  -- Bytes that an update takes after `change`, without the trace compiler's own.
  local function bytesOf(change)
    local jit = rawget(_G, "jit")
    local wasOn = jit and jit.status()
    if wasOn then
      jit.off()
      jit.flush()
    end
    local world = level()
    local bytes
    for round = 1, 3 do -- the first ones make arrays
      change(world, round)
      collectgarbage()
      collectgarbage("stop")
      local before = collectgarbage("count")
      world:update(1 / 60)
      bytes = (collectgarbage("count") - before) * 1024
      collectgarbage("restart")
    end
    if wasOn then
      jit.on()
    end
    return bytes
  end

  it("costs no garbage for the others when it leaves", function()
    assert.is_true(bytesOf(function(world, round)
      world:remove(world.objects.tiles[10 * round])
    end) < FEW)
  end)

  it("nor when it comes", function()
    assert.is_true(bytesOf(function(world, round)
      table.insert(
        world.objects.tiles,
        10 * round,
        { x = -16, y = 16 * round, width = 16, height = 16, static = true }
      )
    end) < FEW)
  end)
end)
