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

local jit = rawget(_G, "jit")
local LAYOUT = {
  { name = "mass", kind = "number", width = 1 },
  { name = "place", kind = "number", width = 2 },
  { name = "head", kind = "integer", width = 1 },
  { name = "awake", kind = "boolean", width = 1 },
  { name = "object", kind = "any", width = 1 },
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
  it("hold what has been counted in a game that is played for years", function()
    local YEARS = 2 ^ 40
    local counted = { "step", "stamp", "liveStamp", "forceStamp", "roundStamp", "links" }
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

  it("are used as they must be in random games", function()
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
      local carrier = require("physics.objects.carriers")
      local dismount = carrier.dismount
      function carrier.dismount(b)
        found = b.world
        return dismount(b)
      end
      module.update(1 / 60)
      carrier.dismount = dismount
      return found
    end

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
