--- The memory of a world (physics/memory/columnStore.lua): typed columns, which nothing guards, are
--- used as they must be, and give the same bits as tables.

local columnStore = require("physics.memory.columnStore")
local case = require("spec.fuzz.case")
local checked = require("spec.support.checked_columns")
local effort = require("spec.support.effort")
local everything = require("spec.support.everything")
local fresh = require("spec.support.fresh")
local physics = require("physics")
local trial = require("spec.fuzz.trial")

effort.wholeOn("LuaJIT compiled")

local long = effort.playsLong and it or pending

local jit = rawget(_G, "jit")
local LAYOUT = {
  { kind = "number", width = 1, names = { "mass" } },
  { kind = "number", width = 2, names = { "place" } },
  { kind = "integer", width = 1, names = { "head" } },
  { kind = "boolean", width = 1, names = { "awake" } },
  { kind = "any", width = 1, names = { "object" } },
}

describe("a column store", function()
  it("keeps what is in its columns when they grow", function()
    checked.during(function()
      local owner = {}
      local self = columnStore.new(owner, LAYOUT)
      assert.equal(0, self.room)
      owner.mass[0], owner.place[1], owner.awake[0], owner.object[7] = 1, 2, true, "anything"
      local old = owner.mass
      columnStore.grow(self, 3)
      assert.is_true(self.room >= 3)
      assert.same({ 1, 2, true }, { owner.mass[0], owner.place[1], owner.awake[0] })
      assert.same({ 0, 0, false }, { owner.mass[3], owner.place[7], owner.awake[3] })
      assert.equal("anything", owner.object[7])
      assert.has_error(function()
        return old[0]
      end, "a column that has been replaced is used")
    end)
  end)

  it("takes no other field's place", function()
    assert.has_error(function()
      columnStore.new({ awake = 3 }, LAYOUT)
    end, "the owner has another awake")
  end)

  it("that began with tables takes over what they hold", function()
    local before = columnStore.use(false)
    local owner = {}
    local self = columnStore.new(owner, LAYOUT)
    columnStore.use(before)
    owner.mass[0], owner.mass[2], owner.place[5], owner.awake[1] = 1, 3, 4, true
    checked.during(function()
      columnStore.adopt(self, 2)
    end)
    assert.same({ 1, 0, 3, 4 }, { owner.mass[0], owner.mass[1], owner.mass[2], owner.place[5] })
    assert.same({ false, true }, { owner.awake[0], owner.awake[1] })
  end)
end)

describe("the memory of objects that have left", function()
  -- A level of 200 tiles with ten boxes that come to rest on its floor.
  local function newLevel()
    local world, tiles = physics.newWorld({ gravity = 800 }), {}
    local floor = { x = -100, y = 200, width = 900, height = 16, static = true, friction = 0.4 }
    world:add("floors", floor)
    for i = 0, 199 do
      local x, y = 16 * (i % 100), 400 + 16 * math.floor(i / 100)
      tiles[i + 1] = world:add("tiles", { x = x, y = y, width = 16, height = 16, static = true })
    end
    return world, tiles
  end

  local function addBoxes(world, from, to)
    for i = from, to do
      local x, y = 15 * (i % 6), 20 * (i % 4)
      local box = { x = x, y = y, width = 14, height = 10 + i % 5, friction = 0.3, vx = 40 }
      world:add("boxes", box)
    end
  end

  -- Returns the hash of each of 120 steps. After 20 the level leaves, if `leaves`, after 60 more
  -- boxes come.
  local function play(leaves)
    local world, hashes, slots = newLevel(), {}, {}
    local b = rawget(world, "_bodies")
    for step = 1, 120 do
      if step == 10 then
        addBoxes(world, 1, 10)
      elseif step == 21 and leaves then
        world.objects.tiles = nil
      elseif step == 60 then
        addBoxes(world, 11, 40)
      end
      world:update(1 / 60)
      slots[step] = b.slots
      local sum = 0
      for _, box in ipairs(world.objects.boxes or {}) do
        sum = sum * 0.9 + box.x + 3 * box.y + box.vx + 7 * box.vy
      end
      hashes[step] = sum
    end
    return hashes, slots
  end

  local function check()
    local expected = play(false)
    local found, slots = play(true)
    assert.same(expected, found)
    assert.is_true(slots[20] > 200, "slots: " .. slots[20])
    -- The boxes have the last slots: nothing can be given back as long as they are there.
    assert.is_true(slots[120] > 200)
  end

  it("is kept below what stays, which goes on with the same bits", check)

  -- The same with the boxes first.
  local function checkCut(count, turns)
    local world = physics.newWorld({ gravity = 800 })
    world:add("floors", { x = -100, y = 200, width = 900, height = 16, static = true })
    addBoxes(world, 1, 10)
    world:update(1 / 60)
    local b = rawget(world, "_bodies")
    for _ = 1, turns do
      for i = 1, count do
        local x, y = 16 * (i % 100), 400 + 16 * math.floor(i / 100)
        world:add("tiles", { x = x, y = y, width = 16, height = 16, static = true })
      end
      world:update(1 / 60)
      assert.equal(11 + count, b.slots)
      local twin = physics.newWorld()
      twin:restore(world:save())
      local floor = twin.objects.floors[1]
      for step = 1, 40 do
        if step == 3 then
          world.objects.tiles = nil
        end
        world:update(1 / 60)
        twin:update(1 / 60)
        for i, box in ipairs(world.objects.boxes) do
          local other = twin.objects.boxes[i]
          assert.same({ box.x, box.y, box.vx, box.vy }, { other.x, other.y, other.vx, other.vy })
          assert.equal(
            box.touching.bottom == world.objects.floors[1],
            other.touching.bottom == floor
          )
        end
      end
      assert.equal(11, b.slots)
      assert.equal(0, b.freeCount)
      assert.equal(11, b.count)
    end
  end

  it("is given back behind what stays, which goes on with the same bits", function()
    checkCut(200, 3)
  end)

  long("is given back as it must be", function()
    checked.during(function()
      checkCut(70, 1)
    end)
  end)

  it("is given back by a table, too", function()
    local before = columnStore.use(false)
    local owner = {}
    local self = columnStore.new(owner, LAYOUT)
    columnStore.use(before)
    for k = 0, 9 do
      owner.mass[k], owner.place[2 * k], owner.place[2 * k + 1], owner.object[k] = k, 1, 2, "it"
    end
    columnStore.shrink(self, 3)
    assert.same(
      { 3, 1, 2, "it" },
      { owner.mass[3], owner.place[6], owner.place[7], owner.object[3] }
    )
    assert.is_nil(owner.mass[4] or owner.place[8] or owner.object[4])
  end)
end)

-- Each index, each kind and each column that was kept too long is an error here.
describe("columns that are checked", function()
  it("notice what nothing else would", function()
    checked.during(function()
      local owner = {}
      columnStore.grow(columnStore.new(owner, LAYOUT), 1)
      for _, row in ipairs({
        { "mass", 2, 1, "index 2 in a column of 2" },
        { "mass", -1, 1, "index -1 in a column of 2" },
        { "mass", 0.5, 1, "index 0.5 in a column of 2" },
        { "mass", 1, false, "false in a column of numbers" },
        { "awake", 1, 0, "0 in a column of booleans" },
        { "head", 1, 0.5, "0.5 in a column of integers" },
        { "head", 1, 2 ^ 31, "in a column of integers" },
        { "head", 1, false, "false in a column of integers" },
      }) do
        assert.error_matches(function()
          owner[row[1]][row[2]] = row[3]
        end, row[4], 1, true)
      end
    end)
  end)

  it("are used as they must be, with the same bits, in the scene with all in it #slow", function()
    local expected = everything.fold(everything.new({}))
    local found = checked.during(function()
      return everything.fold(everything.new({}))
    end)
    assert.equal(expected, found)
  end)

  -- What counts steps, stamps and changes grows for ever, and must not stand where whole numbers
  -- are kept that 32 bits hold.
  long("hold what has been counted in a game that is played for years", function()
    local YEARS = 2 ^ 40
    local counted = { "step", "stamp", "forceStamp", "roundStamp", "links" }
    counted[#counted + 1] = "solveStamp"
    counted[#counted + 1] = "awakenings"
    local function newPile()
      local world, boxes = physics.newWorld({ gravity = 800 }), {}
      world:add("tiles", { x = 0, y = 200, width = 200, height = 20, static = true })
      for i = 0, 29 do
        local x, y = 20 + 13 * (i % 6), 150 - 20 * math.floor(i / 6)
        local vx, friction = 30 * (i % 7) - 90, 0.1 * (i % 3)
        boxes[i + 1] = { x = x, y = y, width = 12, height = 16, vx = vx, friction = friction }
        boxes[i + 1].restitution = i % 5 == 0 and 0.5 or nil
        world:add("boxes", boxes[i + 1])
      end
      return world, boxes
    end
    checked.during(function()
      local young, youngBoxes = newPile()
      local old, oldBoxes = newPile()
      for step = 1, 90 do
        young:update(1 / 60)
        old:update(1 / 60)
        local b = rawget(old, "_bodies")
        if step == 10 then
          for _, name in ipairs(counted) do
            b[name] = b[name] + YEARS
          end
        end
        for i, box in ipairs(youngBoxes) do
          local twin = oldBoxes[i]
          assert.same({ box.x, box.y, box.vx, box.vy }, { twin.x, twin.y, twin.vx, twin.vy })
        end
      end
    end)
  end)

  long("are used as they must be in random games", function()
    checked.during(function()
      for seed = 501, 500 + effort.share(10, 2) do
        local failure = trial.run(case.new(seed, 40))
        if failure then
          error(("seed %d: %s: %s"):format(seed, failure.check, failure.text))
        end
      end
    end)
  end)
end)

if jit and jit.status() then
  describe("compile()", function()
    local function isTyped(world)
      local bodies = rawget(world, "_bodies")
      return type(bodies.from) == "cdata" and type(bodies.other) == "cdata"
    end

    after_each(function()
      jit.opt.start("maxtrace=1000", "maxmcode=512")
      jit.flush()
    end)

    it("gives typed columns to the worlds that are made after it", function()
      fresh.during(function(module)
        local before = module.newWorld()
        assert.is_true(module.compile())
        assert.is_false(isTyped(before))
        assert.is_true(isTyped(module.newWorld()))
      end)
    end)

    -- The default world is the one on which `update` gets into `step`.
    local function defaultWorldOf(module)
      local found
      local carrier = require("physics.motion.carriers")
      local dismount = carrier.dismount
      function carrier.dismount(b)
        found = b.world
        return dismount(b)
      end
      module.update(1 / 60)
      carrier.dismount = dismount
      return found
    end

    it("gives memory back as it must be", function()
      fresh.during(function(module)
        assert.is_true(module.compile())
        local world = module.newWorld({ gravity = 800 })
        world:add("floors", { x = 0, y = 200, width = 900, height = 16, static = true })
        local box = world:add("boxes", { x = 20, y = 0, width = 16, height = 16 })
        for turn = 1, 4 do
          for i = 1, 300 do
            world:add("tiles", { x = 16 * i, y = 400, width = 16, height = 16, static = true })
          end
          for _ = 1, 20 do
            world:update(1 / 60)
          end
          world.objects.tiles = nil
          for _ = 1, 20 do
            world:update(1 / 60)
          end
          assert.equal(2, rawget(world, "_bodies").slots)
          assert.is_true(turn < 2 or box.y == 184)
        end
        assert.is_true(isTyped(world))
      end)
    end)

    it("also to the default world, when no object is in it any more", function()
      fresh.during(function(module)
        for i = 1, 16 do
          module.add("boxes", { x = 20 * i, y = 0, width = 10, height = 10 })
        end
        module.update(1 / 60)
        module.objects.boxes = nil
        module.update(1 / 60)
        module.compile()
        module.add("tiles", { x = 0, y = 100, width = 2000, height = 10, static = true })
        local boxes = {}
        for i = 1, 60 do
          boxes[i] = module.add("boxes", { x = 20 * i, y = 0, width = 10, height = 10 })
        end
        for _ = 1, 60 do
          module.update(1 / 60)
        end
        assert.is_true(isTyped(defaultWorldOf(module)))
        for _, box in ipairs(boxes) do
          assert.equal(90, box.y)
        end
      end)
    end)

    it("also to the default world, as long as no object has been in it", function()
      fresh.during(function(module)
        module.add("boxes", { x = 0, y = 0, width = 10, height = 10 })
        module.compile()
        local default = defaultWorldOf(module)
        assert.is_true(isTyped(default))
        local phase = rawget(default, "_bodies").broadphase
        assert.same({ "cdata", "cdata" }, { type(phase.next), type(phase.heads) })
      end)
      fresh.during(function(module)
        module.add("boxes", { x = 0, y = 0, width = 10, height = 10 })
        module.update(0)
        module.compile()
        assert.is_false(isTyped(defaultWorldOf(module)))
      end)
    end)
  end)
end
