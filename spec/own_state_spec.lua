--- What games need of states beside the bits: their own fields, and saves that cost what moves.

local physics = require("physics")

local function newScene(settings)
  local world = physics.newWorld(settings or { gravity = 800, ownFields = { "hp", "bag", "name" } })
  world:add("floors", { x = 0, y = 100, width = 400, height = 16, static = true })
  world:add("doors", { x = 380, y = 60, width = 8, height = 40, static = true, hp = 9 })
  for i = 1, 3 do
    world:add("men", { x = 40 * i, y = 76, width = 16, height = 24, hp = i, name = "n" .. i })
  end
  world:update(1 / 60)
  return world
end

describe("ownFields", function()
  it("are saved and restored: numbers, strings, booleans and tables", function()
    local world = newScene()
    local men = world.objects.men
    men[1].bag, men[2].bag = { "rope", { lamp = 2, isLit = true } }, false
    local state = world:save()
    men[1].hp, men[1].bag[2].lamp, men[2].bag, men[3].name, men[3].bag = 50, 7, nil, nil, 1
    world.objects.doors[1].hp = 0
    world:restore(state)
    assert.equal(1, men[1].hp)
    assert.same({ "rope", { lamp = 2, isLit = true } }, men[1].bag)
    assert.is_false(men[2].bag)
    assert.equal("n3", men[3].name)
    assert.is_nil(men[3].bag)
    assert.equal(9, world.objects.doors[1].hp)
    -- The copy of the state stays as it is.
    men[1].bag[2].lamp = 99
    world:restore(state)
    assert.equal(2, men[1].bag[2].lamp)
  end)

  it("come back with what was removed, and go with what was added", function()
    local world = newScene()
    local state = world:save()
    local two = world.objects.men[2]
    world:remove(two)
    two.hp = -5
    world:add("men", { x = 300, y = 0, width = 8, height = 8, hp = 77 })
    world:update(1 / 60)
    world:restore(state)
    assert.equal(3, #world.objects.men)
    assert.equal(two, world.objects.men[2])
    assert.equal(2, two.hp)
  end)

  it("of objects that no step has seen yet are saved, too", function()
    local world = newScene()
    local new = world:add("men", { x = 300, y = 0, width = 8, height = 8, hp = 77 })
    local state = world:save()
    new.hp = 1
    world:restore(state)
    assert.equal(77, new.hp)
    new.bag = print
    local ok, text = pcall(world.save, world)
    assert.is_false(ok)
    assert.matches("an object that was added.bag must be a number, string", text)
  end)

  it("are in another world, and in the hash", function()
    local world = newScene()
    world.objects.men[1].bag = { 1, 2 }
    local other = physics.newWorld({ ownFields = { "hp", "bag", "name" } })
    other:restore(world:save())
    assert.equal(3, other.objects.men[3].hp)
    assert.equal(9, other.objects.doors[1].hp)
    assert.same({ 1, 2 }, other.objects.men[1].bag)
    assert.equal(world:hash(), other:hash())
    for _, change in ipairs({
      function(men)
        men[1].hp = 8
      end,
      function(men)
        men[1].bag[2] = 3
      end,
      function(men)
        men[1].bag.more = true
      end,
      function(men)
        men[2].name = nil
      end,
    }) do
      change(other.objects.men)
      assert.are_not.equal(world:hash(), other:hash())
      other:restore(world:save())
      assert.equal(world:hash(), other:hash())
    end
  end)

  it("leave a state and a hash as they were where nothing is named", function()
    local plain, named = newScene({ gravity = 800 }), newScene({ gravity = 800, ownFields = {} })
    assert.equal(plain:hash(), named:hash())
    assert.is_nil(plain:save().own)
    local state = plain:save()
    plain.objects.men[1].hp = 70
    plain:restore(state)
    assert.equal(70, plain.objects.men[1].hp)
  end)

  it("count from the next save on when the setting changes, and fill a state again", function()
    local world = newScene()
    local state = world:save()
    assert.equal(3, #state.own)
    world.ownFields = { "hp" }
    assert.equal(state, world:save(state))
    assert.equal(1, #state.own)
    world.ownFields = nil
    world:save(state)
    assert.is_nil(state.own)
  end)

  it("make a rollback of the whole game: the same hash after it", function()
    local world = newScene()
    local states = {}
    local function step(n)
      states[n % 9] = world:save(states[n % 9])
      for i, man in ipairs(world.objects.men) do
        man.hp = man.hp + (n + i) % 3
        man.vx = man.hp % 2 == 0 and 60 or -60
      end
      world:update(1 / 60)
    end
    for n = 1, 100 do
      step(n)
      if n > 10 then
        local hash = world:hash()
        world:restore(states[(n - 8) % 9])
        for again = n - 8, n do
          step(again)
        end
        assert.equal(hash, world:hash())
      end
    end
  end)

  it("are refused when they cannot be written, and nothing has changed", function()
    local world = newScene()
    local cycle = {}
    cycle.again = cycle
    for _, row in ipairs({
      { print, "objects.men%[2%].hp must be a number, string, boolean or a table of these" },
      { 0 / 0, "objects.men%[2%].hp must be .*, got nan" },
      { math.huge, "objects.men%[2%].hp must be .*, got inf %(take a large number" },
      { { 1, { print } }, "objects.men%[2%].hp must be" },
      { { [true] = 1 }, "the key of a table in objects.men%[2%].hp must be" },
      { cycle, "tables in tables, or a cycle" },
    }) do
      world.objects.men[2].hp = row[1]
      local ok, text = pcall(function()
        world:save()
      end)
      assert.is_false(ok)
      assert.matches("own_state_spec.lua:%d+: physics: ", text)
      assert.matches(row[2], text)
    end
    world.objects.men[2].hp = 2
    for _, row in ipairs({
      { { "hp", "x" }, "ownFields%[2%] must be a field of your own; x is saved anyway" },
      { { "hp", 1 }, "ownFields%[2%] must be the name of a field, got 1" },
      { { "hp", "hp" }, 'ownFields must name each field once, got "hp" at %[1%] and %[2%]' },
    }) do
      world.ownFields = row[1]
      local ok, text = pcall(function()
        world:save()
      end)
      assert.is_false(ok)
      assert.matches(row[2], text)
      assert.is_false(pcall(world.update, world, 1 / 60))
    end
  end)

  it("are checked in a state", function()
    local world = newScene()
    local men = world.objects.men
    for _, row in ipairs({
      {
        function(st)
          st.own = 1
        end,
        "state.own must be a table, got 1",
      },
      {
        function(st)
          st.own[1].name = "x"
        end,
        "state.own%[1%].name must be a field of your own",
      },
      {
        function(st)
          st.own[1].values[1] = 99
        end,
        "state.own%[1%].values%[1%] must be the number of a later object, got 99",
      },
      {
        function(st)
          st.own[1].values[2] = print
        end,
        "state.own%[1%].values%[2%] must be a number",
      },
      {
        function(st)
          st.own[2] = 7
        end,
        "state.own%[2%] must have a name and values, got 7",
      },
    }) do
      local state = world:save()
      row[1](state)
      men[1].hp = 42
      local ok, text = pcall(world.restore, world, state)
      assert.is_false(ok)
      assert.matches(row[2], text)
      assert.equal(42, men[1].hp)
    end
  end)
end)

describe("a state from elsewhere", function()
  it("tells of a group under numbers that has another count here", function()
    local host, client = newScene({ gravity = 800 }), newScene({ gravity = 800 })
    host:remove(host.objects.men[1])
    host:update(1 / 60)
    local sentence = client:restore(host:save())
    assert.matches("^objects.men has 2 objects in the state and 3 here: numbers shift", sentence)
    assert.is_nil(client:restore(host:save()))
    assert.equal(host:hash(), client:hash())
  end)

  it("says nothing of string keys, of empty groups, and of a state of the same world", function()
    local host, client = physics.newWorld(), physics.newWorld()
    for _, world in ipairs({ host, client }) do
      world.objects.men = { a = { x = 0, y = 0, width = 1, height = 1 } }
      world.objects.men.b = { x = 9, y = 0, width = 1, height = 1 }
      world:update(1 / 60)
    end
    host.objects.men.a = nil
    host:update(1 / 60)
    assert.is_nil(client:restore(host:save()))
    assert.is_nil(physics.newWorld():restore(newScene():save()))
    local own = newScene()
    local state = own:save()
    own:remove(own.objects.men[1])
    own:update(1 / 60)
    assert.is_nil(own:restore(state))
  end)
end)

describe("a save and a restore", function()
  -- Tiles that count how often their fields are read.
  local function newCounted(count)
    local reads = { count = 0 }
    local class = {}
    local world = physics.newWorld({ gravity = 800 })
    for i = 1, count do
      local fields = { x = 16 * i, y = 100, width = 16, height = 16, static = true }
      fields.friction = i % 3 == 0 and 0.5 or nil
      fields.mask = i % 7 == 0 and { ghosts = false } or nil
      class[i] = setmetatable({}, {
        __index = function(_, name)
          reads.count = reads.count + 1
          return fields[name]
        end,
      })
      world:add("tiles", class[i])
    end
    world:add("men", { x = 40, y = 76, width = 16, height = 24, vx = 10 })
    world:add("boxes", { x = 400, y = 0, width = 16, height = 16 })
    world:update(1 / 60)
    world:update(1 / 60)
    return world, reads
  end

  it("look at what stands only once", function()
    local world, reads = newCounted(200)
    local state = world:save()
    reads.count = 0
    world:save(state)
    world:save()
    world:hash()
    world:restore(state)
    assert.is_true(reads.count <= 3 * 200, "read " .. reads.count .. " fields")
  end)

  it("say the same as those that look at all", function()
    local world = newCounted(40)
    for n = 1, 60 do
      world.objects.men[1].vx = 20 * (n % 7)
      if n % 20 == 5 then
        world:remove(world.objects.tiles[3])
      elseif n % 20 == 9 then
        world:add("boxes", { x = 300 + n, y = 0, width = 8, height = 8 })
      elseif n % 20 == 13 then
        world:add("tiles", { x = 900 + n, y = 0, width = 8, height = 8, static = true })
      end
      for _ = 1, 2 do -- what has come and gone is known the second time
        local first = world:save() -- of what was noted
        world._bodies.fixed = false
        assert.same(world:save(), first)
        world:update(1 / 60)
      end
    end
  end)

  it(
    "put back a static object that was changed and refreshed, removed or made another kind",
    function()
      for _, change in ipairs({
        function(world, tile)
          tile.x, tile.friction = 500, 0.9
          world:refresh(tile)
        end,
        function(world, tile)
          world:remove(tile)
          tile.x = 3
          world:update(1 / 60)
        end,
        function(world, tile)
          tile.static, tile.vy = false, 40
          world:refresh(tile)
        end,
        function(world, tile)
          tile.static, tile.kinematic, tile.vx = false, true, 50
          world:refresh(tile)
          for _ = 1, 5 do
            world:update(1 / 60)
          end
        end,
      }) do
        local world = physics.newWorld({ gravity = 800 })
        for i = 1, 10 do
          world:add("tiles", { x = 16 * i, y = 100, width = 16, height = 16, static = true })
        end
        world:add("men", { x = 40, y = 76, width = 16, height = 24 })
        world:update(1 / 60)
        world:update(1 / 60)
        world:save()
        local state, hash = world:save(), world:hash()
        local tile = world.objects.tiles[4]
        change(world, tile)
        world:update(1 / 60)
        world:restore(state)
        assert.equal(tile, world.objects.tiles[4])
        assert.equal(64, tile.x)
        assert.is_nil(tile.friction)
        assert.is_true(tile.static)
        assert.equal(hash, world:hash())
        for _ = 1, 30 do
          world:update(1 / 60)
        end
        local last = world:hash()
        world:restore(state)
        for _ = 1, 30 do
          world:update(1 / 60)
        end
        assert.equal(last, world:hash())
      end
    end
  )
end)
