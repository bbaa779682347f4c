--- world:restore: what comes back and to which objects, callbacks, and `ownFields` of the game.

local effort = require("spec.support.effort")
local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local small = require("spec.support.small")
local states = require("spec.support.states")

effort.interpretQuickly(setup, teardown)

local DT = 1 / 60
local mover, run = small.put, small.run
local put, read, smallWorld, write = states.put, states.read, states.smallWorld, states.write

local thing = scene.thing("boxes", { name = "box", x = 10, y = 84, width = 16, height = 16 })
local FLOOR = scene.maker("floor", { static = true })("floor", 0, 100, 400, 20)
local TWO = { gravity = 600, FLOOR, thing(), thing({ name = "other", x = 60, y = 20 }) }

local replay = play.once({
  copy = function(state)
    return read(write(state))
  end,
  newWorld = physics.newWorld,
  DT = DT,
})

describe("world:restore", function()
  replay("keeps the tables of the objects, also of those that were removed", TWO, {
    { steps = 1 },
    { "listen other", "other.raw.mine = 5", "state = world:save()" },
    { "world:remove(other.raw)", 1 / 60 },
    { "bullet = world:add('bullets', { x = 0, y = 0, width = 2, height = 2 })", 1 / 60 },
    "world:restore(state)",
    { "world.objects.boxes[1] == box.raw", "world.objects.boxes[2] == other.raw" },
    { "world.objects.bullets[1] == nil", "world:remove(bullet) == false", "other.raw.mine == 5" },
    { "run:play(1)", "heard.other.begins == 1" },
  })

  replay("gives a state from elsewhere to the object at the same place", TWO, {
    { steps = 1 },
    { "state, y = copy(world:save()), other.y", "group = world.objects.boxes" },
    { "world:remove(other.raw)", "box.raw.mine, box.x, box.raw.restitution = 5, 300, 1", 1 / 60 },
    "world:restore(state)",
    { "world.objects.boxes == group", "group[1] == box.raw", "box.raw.mine == 5", "box.x == 10" },
    { "box.raw.restitution == nil", "group[2].x == 60", "group[2].y == y" },
  })

  replay("shows at once what touches what, also in another world", TWO, {
    { "run:play(2 / 60)", "state = world:save()", "twin = newWorld()" },
    { "box.y = 0", 1 / 60, "box.touching.bottom == false" },
    { "world:restore(state)", "box touches bottom", "box.touching.bottom == floor" },
    "twin:restore(copy(state)); twin.objects.boxes[1].touching.bottom == twin.objects.floor[1]",
    "twin:touching(twin.objects.boxes[1], twin.objects.floor[1]) == 'bottom'",
  })

  replay("tells no event for the jump", TWO, {
    { steps = 1 },
    { "listen box", "state = world:save()" },
    { "box.y = 0", 1 / 60, "box heard 0, 1" },
    { "world:restore(state)", 2 / 60, "box heard 0, 1" },
  })

  replay("may happen inside a callback", TWO, {
    { "world:update(DT)", "state, count = world:save(), 0" },
    "function back() count = count + 1 if count == 1 then world:restore(state) end end",
    "other.raw.onBegin = back",
    { "run:play(2)", "count == 2", "other.y == 84" },
  })

  replay("brings back the walls of setBounds, and the list `order` as the same table", TWO, {
    { "world:setBounds(0, 0, 400, 300)", "order = { 'boxes' }", "world.order = order", 1 / 60 },
    { "state = world:save()", "world:setBounds()", 1 / 60 },
    { "world:restore(state)", "world.order == order", "world.objects.bounds.left ~= nil" },
    { "world:setBounds(0, 0, 500, 300)", "world.objects.bounds.right.x == 500" },
  })

  replay("keeps the table `touching` of one that was away, or {what}", TWO, {
    { "world:update(DT)", "state, touching = world:save(), box.raw.touching" },
    { "{does}", "world:refresh(box.raw)", 1 / 60 },
    { "world:restore(state)", 2 / 60 },
    { "box.raw.touching == touching", "touching.bottom == floor.raw" },
  }, {
    "what, does",
    { "removed", "world:remove(box.raw); world:add('boxes', box.raw); box.active = false" },
    { "static", "box.static = true" },
    { "kinematic", "box.kinematic = true" },
  })

  replay("brings back groups, single objects, odd keys, masks and settings", TWO, {
    "mask = { boxes = false, [3] = true }",
    "world.objects.player = { x = 200, y = 50, width = 8, height = 8, mask = mask }",
    "world.objects[7] = { left = { x = 250, y = 0, width = 9, height = 9 } }",
    "world.masks, world.order = { boxes = { [7] = false } }, { 'player', 7 }; world:update(DT)",
    "state, hash, player = world:save(), world:hash(), world.objects.player; text = copy(state)",
    "world.objects.player, world.objects[7], world.masks, world.order = nil, nil, nil, nil",
    "world.gravity, mask.boxes = 5, true; world:update(DT); world:restore(state)",
    "world:hash() == hash; world.objects.player == player; world.gravity == 600",
    "player.mask.boxes == false; player.mask[3] == true; world.masks.boxes[7] == false",
    "twin = newWorld(); twin:restore(text); twin:hash() == hash; twin.objects[7].left.x == 250",
    "twin.objects.player.mask.boxes == false; twin.objects.player.mask[3] == true",
  })

  -- The game may change `masks` in place, so the table that it holds must stay the world's.
  it("writes into the masks that the world has", function()
    local masks = { bullets = { players = true }, boxes = {} }
    local world = physics.newWorld({ gravity = 0, masks = masks })
    local state = read(write(world:save()))
    masks.bullets.players, masks.others, masks.boxes = false, { boxes = false }, nil
    world:restore(state)
    assert.is_true(rawequal(masks, world.masks))
    assert.are.same({ bullets = { players = true }, boxes = {} }, masks)
    world.masks = nil
    world:restore(state)
    assert.are.same({ bullets = { players = true }, boxes = {} }, world.masks)
  end)

  it("counts each entry of a mask in the hash, however the mask was filled", function()
    local function hashOf(mask)
      local world = physics.newWorld()
      world:add("boxes", mover(0, 0, 10, 10, { mask = mask }))
      return world:hash()
    end
    local filled = { fields = false }
    filled[3], filled[1] = false, false
    assert.equal(hashOf({ false, nil, false, fields = false }), hashOf(filled))
    assert.is_false(hashOf({ false, nil, false }) == hashOf(filled))
  end)

  -- A callback fails at the first end of a contact, which is that of the second box; so the end of
  -- the third is still to be told. Both have left.
  it("keeps events of objects that have left the world", function()
    local world, boxes, told = smallWorld(), {}, nil
    for n = 2, 3 do
      local more = { mass = n, mask = n == 3 and { ghosts = false } or nil }
      boxes[n] = world:add("crates", mover(50 * n, 90, 10, 10, more))
    end
    run(world, 3)
    function world.onEnd()
      error("no")
    end
    world:remove(boxes[2])
    world:remove(boxes[3])
    assert.is_false((pcall(world.update, world, 0)))
    local state, hash, twin = world:save(), world:hash(), physics.newWorld()
    boxes[3].x, boxes[3].mass, boxes[3].sensor = 7, nil, true
    for _, one in ipairs({ world, twin }) do
      one:restore(one == world and state or read(write(state)))
      assert.are.equal(hash, one:hash())
      function one.onEnd(a, b)
        assert.are.same({ 150, 10, 3, false, 0 }, { a.x, a.width, a.mass, a.mask.ghosts, b.x })
        assert.is_true(one == twin or a == boxes[3] and a.sensor == nil)
        told = one
      end
      one:update(DT)
      assert.is_true(told == one)
    end
    assert.are.equal(world:hash(), twin:hash())
  end)

  it("tells the events that were still to come when it was saved, by whomever", function()
    for _, where in ipairs({ "box", "floor", "world" }) do
      local world, one, other = smallWorld()
      local told, state = {}, nil
      local function listen(owner, name)
        owner.onBegin = function(_, hit)
          told[#told + 1] = ("%s %d"):format(name, hit.x)
          state = state or (name == where and world:save() or nil)
        end
      end
      one.y, other.y = 60, 60
      world:update(DT)
      listen(one, "box")
      listen(world.objects.floor[1], "floor")
      listen(world, "world")
      while not state do
        world:update(DT)
      end
      assert.are.same({ "box 0", "floor 10", "world 0", "floor 60", "world 0" }, told)
      local rest = {}
      for n = where == "box" and 2 or where == "floor" and 3 or 4, #told do
        rest[#rest + 1] = told[n]
      end
      told = {}
      world:restore(state)
      world:update(0)
      assert.are.same(rest, told)
    end
  end)

  it("keeps between which two an object was crushed, if that was still to come", function()
    local world, state, told = physics.newWorld({ gravity = 0 }), nil, nil
    world:add("walls", mover(0, 0, 10, 10, { static = true }))
    local box = world:add("boxes", mover(10, 0, 10, 10))
    world:add("machines", mover(20, 0, 10, 10, { kinematic = true, vx = -60 }))
    function box.onCrush() -- before world.onCrush
      state = world:save()
    end
    world:update(DT)
    local copy = physics.newWorld()
    copy:restore(state)
    function copy.onCrush(object, a, b)
      told = { object.x, math.min(a.x, b.x), math.max(a.x, b.x) }
    end
    copy:update(0)
    assert.are.same({ copy.objects.boxes[1].x, 0, 19 }, told)
  end)

  it("keeps no object alive that has left, whatever the game has put into `touching`", function()
    local world = physics.newWorld({ gravity = 600 })
    local alive = setmetatable({}, { __mode = "k" })
    for n = 1, 20 do
      local object = world:add("boxes", mover(40 * n, 0, 16, 16))
      object.touching.owner, alive[object] = object, true
      world:update(DT)
      world:remove(object)
    end
    run(world, 2)
    collectgarbage()
    collectgarbage()
    assert.is_nil(next(alive))
  end)
end)

-- Fields of the game -----------------------------------------------------------------------------

local men = scene.thing("men", { y = 76, width = 16, height = 24 })
local DOOR = scene.maker("doors", { static = true, hp = 9 })("door", 380, 60, 8, 40)
local OWN = { FLOOR, DOOR, ownFields = { "hp", "bag" } }
for n, name in ipairs({ "one", "two", "three" }) do
  OWN[n + 2] = men({ name = name, x = 40 * n, hp = n })
end

-- A world of these.
local function newScene(ownFields)
  local world = physics.newWorld({ gravity = 800, ownFields = ownFields })
  for _, entry in ipairs(OWN) do
    world:add(entry[1], scene.thing(entry[1], entry[2])()[2])
  end
  world:update(DT)
  return world
end

describe("ownFields", function()
  replay("are saved and restored: numbers, strings, booleans and tables", OWN, {
    "one.raw.bag, two.raw.bag = { 'rope', { lamp = 2, isLit = true } }, false",
    "state = world:save()",
    "one.raw.hp, one.raw.bag[2].lamp, two.raw.bag, door.raw.hp = 5, 7, nil, 0",
    "three.raw.bag = 1; world:restore(state)",
    "one.raw.hp == 1; one.raw.bag[1] == 'rope'; one.raw.bag[2].lamp == 2",
    "one.raw.bag[2].isLit == true; two.raw.bag == false; three.raw.bag == nil; door.raw.hp == 9",
    -- The copy of the state stays as it is.
    "one.raw.bag[2].lamp = 99; world:restore(state); one.raw.bag[2].lamp == 2",
  })

  replay("are in another world, and in the hash", OWN, {
    "one.raw.bag = { 1, 2 }; hash = world:hash()",
    "twin = newWorld({ ownFields = { 'hp', 'bag' } }); twin:restore(world:save())",
    "twin.objects.men[3].hp == 3; twin.objects.doors[1].hp == 9; twin.objects.men[1].bag[2] == 2",
    "twin:hash() == hash; twin.objects.men[1].bag[2] = 3; twin:hash() ~= hash",
    "twin:restore(world:save()); twin:hash() == hash",
    "twin.objects.men[2].hp = nil; twin:hash() ~= hash",
  })

  it("of tiles come back, and leave those that had none", function()
    local world = physics.newWorld({ ownFields = { "hp" } })
    local door = world:add("tiles", { x = 0, y = 0, width = 8, height = 8, static = true, hp = 9 })
    local tile = world:add("tiles", { x = 8, y = 0, width = 8, height = 8, static = true })
    world:update(DT)
    local state = world:save()
    door.hp, tile.hp = 0, 1
    world:restore(state)
    assert.same({ 9 }, { door.hp, tile.hp })
  end)

  it("leave a state and a hash as they were where nothing is named", function()
    local plain, named = newScene(), newScene({})
    assert.equal(plain:hash(), named:hash())
    assert.is_nil(plain:save().own)
    local state = plain:save()
    plain.objects.men[1].hp = 70
    plain:restore(state)
    assert.equal(70, plain.objects.men[1].hp)
  end)

  replay("count from the next save on when the setting changes, and fill a state again", OWN, {
    "state = world:save(); #state.own == 2; world.ownFields = { 'hp' }",
    "world:save(state) == state; #state.own == 1",
    "world.ownFields = nil; world:save(state); state.own == nil",
  })

  it("are refused when they cannot be written, and nothing has changed", function()
    local world, cycle = newScene({ "hp", "bag" }), {}
    cycle.again = cycle
    for _, row in ipairs({
      { print, "hp must be a number, string, boolean or a table of these, without a cycle, got" },
      { 0 / 0, "got nan" },
      { math.huge, "got inf" },
      { { 1, { print } }, "objects.men[2].hp must be" },
      { { [true] = 1 }, "objects.men[2].hp must be" },
      { cycle, "without a cycle, got table" },
    }) do
      world.objects.men[2].hp = row[1]
      small.refuses(row[2], world.save, world)
    end
    world.objects.men[2].hp = 2
    for _, row in ipairs({
      { { "x", "hp" }, 'ownFields[1] must be the name of a field of your own, got "x"' },
      { { "hp", "x" }, 'ownFields[2] must be the name of a field of your own, got "x"' },
      { { "hp", 1 }, "ownFields[2] must be the name of a field of your own, got 1" },
    }) do
      world.ownFields = row[1]
      small.refuses(row[2], world.save, world)
      small.refuses(row[2], world.update, world, DT)
    end
  end)

  it("are checked in a state, and nothing has changed", function()
    for path, row in pairs({
      own = { 1, "state.own must be a list of names of fields, got 1" },
      ["own[1]"] = { "x", "state.own[1] must be the name of a field of your own" },
      ["fields[1].hp"] = { print, "state.fields[1].hp must be a number" },
    }) do
      local world = newScene({ "hp", "bag" })
      local state = world:save()
      put(state, path, row[1])
      world.objects.men[1].hp = 42
      small.refuses(row[2], world.restore, world, state)
      assert.equal(42, world.objects.men[1].hp)
    end
  end)
end)

it("world:restore tells of a group under numbers that has another count here", function()
  local host, client = newScene(), newScene()
  host:remove(host.objects.men[1])
  host:update(DT)
  local sentence = client:restore(host:save())
  assert.matches("^objects.men has 2 objects in the state and 3 here: numbers shift", sentence)
  assert.is_nil(client:restore(host:save()))
  assert.equal(host:hash(), client:hash())
end)

it("world:restore tells of the first such group, of none with other keys or alone", function()
  local function newWorld(count)
    local world = physics.newWorld({ gravity = 0 })
    for n = 1, count do
      world:add("a", mover(20 * n, 0, 8, 8))
      world:add("b", mover(20 * n, 20, 8, 8))
    end
    return world
  end
  local sentence = newWorld(3):restore(read(write(newWorld(2):save())))
  assert.matches("^objects.a has 2 objects in the state and 3 here", sentence)
  local named, numbered = physics.newWorld({ gravity = 0 }), newWorld(2)
  named.objects.a = { one = mover(0, 0, 8, 8) }
  named.objects.b = mover(0, 20, 8, 8)
  numbered.objects.a.one = mover(60, 0, 8, 8)
  numbered.objects.b = mover(0, 20, 8, 8)
  numbered.objects[1], numbered.objects[2] = { mover(80, 0, 8, 8) }, { mover(99, 0, 8, 8) }
  assert.is_nil(numbered:restore(read(write(named:save()))))
end)
