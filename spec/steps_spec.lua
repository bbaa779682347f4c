--- Parts of the step, each by itself: sorting, broad phases, forces, friction, columns.

local columns = require("physics.memory.columns")
local allPairs = require("physics.broadphase.allPairs")
local forces = require("physics.motion.forces")
local friction = require("physics.solver.friction")
local grid = require("physics.broadphase.grid")
local newRandom = require("spec.support.random").new
local path = require("physics.motion.path")
local physics = require("physics")
local registry = require("physics.objects.registry")
local sort = require("physics.memory.sort")

local DYNAMIC, STATIC = columns.DYNAMIC, columns.STATIC
local DT = 1 / 60

--- Columns with some dynamic objects in slots 1, 2, …, all awake.
local function newBodies(count)
  local b = columns.new()
  for n = 1, count do
    local i = columns.claim(b)
    assert.equal(n, i)
    b.kind[i], b.inverseMass[i] = DYNAMIC, 1
    b.size[2 * i], b.size[2 * i + 1] = 16, 16
    b.awakeList[n], b.awake[i] = i, true
  end
  b.awakeCount = count
  b.flowPull, b.flowAir, b.flowDrag = b.pull, b.airFriction, b.drag -- as without zones
  path.begin(b)
  return b
end

describe("sort.by", function()
  it("sorts by the first column, then the second, then the third", function()
    local first = { 2, 1, 2, 1, 1 }
    local second = { 5, 7, 5, 6, 7 }
    local third = { 2, 2, 1, 9, 1 }
    local list = { 1, 2, 3, 4, 5 }
    sort.by(list, 5, first, second, third)
    assert.same({ 4, 5, 2, 3, 1 }, list)
  end)

  it("sorts lists of any length and leaves what is behind them alone", function()
    local random = newRandom(3)
    for count = 0, 40 do
      local list, column, same = {}, {}, {}
      for n = 1, count do
        list[n], column[n], same[n] = n, random:integer(1, 10), 0
      end
      list[count + 1] = "end"
      local number = {}
      for n = 1, count do
        number[n] = n
      end
      sort.by(list, count, column, same, number)
      for n = 2, count do
        local a, b = list[n - 1], list[n]
        assert.is_true(column[a] < column[b] or (column[a] == column[b] and a < b))
      end
      assert.equal("end", list[count + 1])
    end
  end)
end)

describe("the broad phases", function()
  --- Puts a box with random size into the fat boxes of slot i: somewhere, or where it is (`stays`).
  local function place(b, random, i, stays)
    local scale = random:pick({ 1, 1, 1, 10, 300 })
    local x, y = random:between(-500, 500), random:between(-500, 500)
    if stays then
      x, y = b.fatLow[2 * i], b.fatLow[2 * i + 1]
    end
    b.fatLow[2 * i], b.fatHigh[2 * i] = x, x + scale * random:between(0.1, 30)
    b.fatLow[2 * i + 1], b.fatHigh[2 * i + 1] = y, y + scale * random:between(0.1, 30)
  end

  -- Puts boxes there for slot i and some of those that are in; returns the list of all these.
  local function placeSome(b, random, i, isIn)
    local list = { i }
    place(b, random, i)
    for j = 1, #isIn do
      if isIn[j] and j ~= i and random:chance(8 / (#isIn + 12)) then
        place(b, random, j, random:chance(0.5))
        list[#list + 1] = j
      end
    end
    return list
  end

  local function ask(phase, left, top, right, bottom)
    local found = { "old", "old" }
    local count = phase:query(left, top, right, bottom, found)
    local list = {}
    for n = 1, count do
      list[n] = found[n]
    end
    table.sort(list)
    -- The concatenation of one number is a number in gopher-lua.
    return tostring(table.concat(list, " "))
  end

  -- Few of them, too: of many one is as wide as any can be.
  local SIZES = { { 150, 32 }, { 150, 1 }, { 150, 7.3 }, { 150, 4000 }, { 4, 32 }, { 4, 9 } }
  for _, row in ipairs(SIZES) do
    it(("find the same among %d, in cells of %g"):format(row[1], row[2]), function()
      local random = newRandom(9)
      local b = newBodies(row[1])
      local phases = { allPairs.new(b), grid.new(b, row[2]) }
      local isIn = {}
      for i = 1, row[1] do
        isIn[i] = false
      end
      for _ = 1, 600 do
        local i = random:integer(1, row[1])
        local last = i
        if isIn[i] and random:chance(0.4) then
          for _, phase in ipairs(phases) do
            phase:remove(i)
          end
          isIn[i] = false
        else
          local list = placeSome(b, random, i, isIn)
          last = list[#list]
          for _, phase in ipairs(phases) do
            if not isIn[i] then
              phase:insert(i)
            end
            phase:update(list, #list)
          end
          isIn[i] = true
        end
        local x, y = random:between(-600, 600), random:between(-600, 600)
        local w, h = random:between(0, 200), random:between(0, 200)
        if isIn[last] and random:chance(0.7) then -- the far corner of one that has changed
          x, y, w, h = b.fatHigh[2 * last] - 0.05, b.fatHigh[2 * last + 1] - 0.05, 0, 0
        end
        if random:chance(0.05) then
          w = 1e9
        end
        assert.equal(ask(phases[1], x, y, x + w, y + h), ask(phases[2], x, y, x + w, y + h))
      end
    end)
  end

  it("find a box that has become wider where it stands", function()
    local b = newBodies(1)
    local phases = { allPairs.new(b), grid.new(b, 32) }
    b.fatLow[2], b.fatHigh[2], b.fatLow[3], b.fatHigh[3] = 30, 34, 30, 34
    for _, phase in ipairs(phases) do
      phase:insert(1)
    end
    b.fatHigh[2] = 60
    for _, phase in ipairs(phases) do
      phase:update({ 1 }, 1)
      assert.equal("1", ask(phase, 50, 30, 51, 31))
    end
  end)

  it("work far out, and at the edges", function()
    local b = newBodies(3)
    local phases = { allPairs.new(b), grid.new(b) }
    for i, x in ipairs({ -1e12, 0, 1e12 }) do
      b.fatLow[2 * i], b.fatHigh[2 * i] = x, x + 16
      b.fatLow[2 * i + 1], b.fatHigh[2 * i + 1] = 0, 16
      for _, phase in ipairs(phases) do
        phase:insert(i)
      end
    end
    for _, phase in ipairs(phases) do
      assert.equal("1", ask(phase, -1e12, 0, -1e12 + 1, 1))
      assert.equal("2", ask(phase, 16, 16, 20, 20))
      assert.equal("2", ask(phase, -5, -5, 0, 0))
      assert.equal("", ask(phase, 16.001, 0, 20, 1))
      assert.equal("3", ask(phase, 1e12, 0, 1e12 + 1, 1))
      assert.equal("1 2 3", ask(phase, -1e13, -1e13, 1e13, 1e13))
    end
  end)
end)

describe("maxSpeed", function()
  for _, rate in ipairs({ 30, 60, 144, 240 }) do
    it(("is reached inside a step, at %d Hz"):format(rate), function()
      local world = physics.newWorld({ gravity = 900 })
      local box = world:add("boxes", { x = 0, y = 0, width = 16, height = 16, maxSpeed = 250 })
      -- One that is put in faster, and up: it begins at 250 px/s, and turns as gravity has it.
      local fast = { x = 0, y = 0, width = 16, height = 16, vx = 200, vy = -400, maxSpeed = 250 }
      world:add("others", fast)
      fast.mask = { boxes = false }
      for _ = 1, 1.5 * rate do
        world:update(1 / rate)
      end
      assert.near(250 ^ 2 / 1800 + 250 * (1.5 - 250 / 900), box.y, 1e-9)
      assert.near(86.8674, fast.x, 0.002) -- in steps of 1/4800 s
      assert.near(247.0108, fast.y, 0.02)
    end)
  end
end)

describe("forces", function()
  -- From 8 px/s to a stop at 150 px/s², and on at 100.
  local FORTH = -8 * 8 / 300 + 100 / 2 * (1 - 8 / 150) ^ 2
  -- what, velocity, acceleration, air friction, drag, limit, dt; velocity and way afterwards
  for _, row in ipairs({
    { "none: it flies on", 60, 0, 0, 0, nil, 0.5, 60, 30 },
    { "gravity: v + a t, and v t + a t² / 2", 10, 800, 0, 0, nil, 0.5, 410, 105 },
    { "air friction alone: e^-kt", 100, 0, 2, 0, nil, 0.5, 36.787944117144, 31.606027941428 },
    { "air friction against gravity", 0, 100, 1, 0, nil, 1, 63.212055882856, 36.787944117144 },
    { "drag, moving", 100, 0, 0, 50, nil, 1, 50, 75 },
    { "drag, until it stands", 100, 0, 0, 400, nil, 1, 0, 12.5 },
    { "drag, the other way", -100, 0, 0, 400, nil, 1, 0, -12.5 },
    { "drag, stronger than the pull", 0, 100, 0, 200, nil, 1, 0, 0 },
    { "drag, with a weaker pull", 50, 100, 0, 200, nil, 1, 0, 12.5 },
    { "drag, against a weaker pull", -50, 100, 0, 200, nil, 1, 0, -50 * 50 / 600 },
    { "drag, with a stronger pull", 50, 300, 0, 200, nil, 1, 150, 100 },
    { "drag, against a stronger pull", -8, 125, 0, 25, nil, 1, 100 * (1 - 8 / 150), FORTH },
    { "a limit reached half-way", 0, 100, 0, 0, 50, 1, 50, 37.5 },
    { "a limit exceeded before", 90, 0, 0, 0, 50, 1, 50, 50 },
  }) do
    it(row[1], function()
      for axis = 0, 1 do
        local b = newBodies(1)
        local k = 2 + axis
        b.velocity[k], b.pull[k], b.airFriction[1], b.drag[1] = row[2], row[3], row[4], row[5]
        b.fastest[k] = row[6] or math.huge
        b.slowest[k] = -b.fastest[k]
        b.isFree[1] = not row[6] and row[4] == 0
        b.hasHinders = true
        forces.run(b, row[7], 1, 1)
        assert.near(row[8], b.speed[k], 1e-9)
        assert.near(row[9], b.way[k], 1e-9)
        assert.equal(0, b.speed[5 - k])
        assert.equal(0, b.way[5 - k])
      end
    end)
  end

  it("limit the length of a velocity, whatever its direction", function()
    local b = newBodies(1)
    b.velocity[2], b.velocity[3], b.maxSpeed[1], b.hasHinders = 300, -400, 100, true
    forces.run(b, 0.5, 1, 1)
    assert.near(60, b.speed[2], 1e-9)
    assert.near(-80, b.speed[3], 1e-9)
    assert.near(30, b.way[2], 1e-9)
    assert.near(-40, b.way[3], 1e-9)
  end)

  it("damp the same in one long step and in many short ones", function()
    local long, short, way = newBodies(1), newBodies(1), 0
    long.velocity[2], long.airFriction[1], long.pull[2] = 100, 3, 40
    short.velocity[2], short.airFriction[1], short.pull[2] = 100, 3, 40
    forces.run(long, 1, 1, 1)
    for _ = 1, 200 do
      forces.run(short, 1 / 200, 1, 1)
      short.velocity[2], way = short.speed[2], way + short.way[2]
    end
    assert.near(long.speed[2], short.speed[2], 1e-9)
    assert.near(long.way[2], way, 1e-9)
  end)
end)

describe("friction", function()
  -- of one, of the other (nil: not set), the pair's
  for _, row in ipairs({
    { 0.5, 0.5, 0.5 },
    { 0.4, 0.9, 0.6 },
    { 0, 1, 0 },
    { nil, 0.3, 0.3 },
    { 0.3, nil, 0.3 },
    { nil, nil, 0 },
  }) do
    it(("of %s and %s is %g"):format(tostring(row[1]), tostring(row[2]), row[3]), function()
      local b = newBodies(2)
      b.friction[1], b.friction[2] = row[1] or -1, row[2] or -1
      assert.near(row[3], friction.coefficient(b, 1, 2), 1e-12)
      assert.near(row[3], friction.coefficient(b, 2, 1), 1e-12)
    end)
  end

  it("slows by its share of the weight, and stops exactly", function()
    local world = physics.newWorld({ gravity = 800 })
    world:add("tiles", { x = -100, y = 16, width = 900, height = 16, static = true })
    local box = world:add("boxes", { x = 0, y = 0, width = 16, height = 16, vx = 90 })
    box.friction = 0.5
    world:update(DT)
    assert.near(90 - 400 * DT, box.vx, 1e-9)
    for _ = 1, 20 do
      world:update(DT)
    end
    assert.equal(0, box.vx)
    assert.near(90 * 90 / (2 * 400), box.x, 1e-6)
  end)
end)

describe("a path", function()
  it("begins anew where the object is at a moment", function()
    local b = newBodies(1)
    b.to[2], b.to[3] = 8, -4
    path.advance(b, 1, 0.5)
    assert.same({ 4, -2, 0.5 }, { b.from[2], b.from[3], b.time[1] })
    path.advance(b, 1, 0.75)
    assert.same({ 6, -3, 0.75 }, { b.from[2], b.from[3], b.time[1] })
    path.advance(b, 1, 0.25) -- not back
    assert.same({ 6, -3, 0.75 }, { b.from[2], b.from[3], b.time[1] })
    b.kind[1] = STATIC
    path.advance(b, 1, 1)
    assert.equal(0.75, b.time[1])
  end)
end)

describe("the columns", function()
  it("give slots and pairs back and use them again", function()
    local b = newBodies(3)
    local first, second = columns.link(b, 1, 2), columns.link(b, 2, 3)
    assert.equal(first, columns.pairOf(b, 2, 1))
    assert.equal(second, columns.pairOf(b, 2, 3))
    assert.is_nil(columns.pairOf(b, 1, 3))
    columns.unlinkAll(b, { first }, 1)
    assert.is_nil(columns.pairOf(b, 1, 2))
    assert.equal(second, columns.pairOf(b, 3, 2))
    local third = columns.link(b, 3, 1) -- lists of this step still hold `first`
    assert.is_true(third ~= first and third ~= second)
    columns.unlinkAll(b, { third }, 1)
    columns.freeEnded(b)
    local again = columns.link(b, 1, 2)
    assert.is_true(again == first or again == third)
    columns.link(b, 1, 3)
    assert.equal(3, b.pairSlots)
    assert.equal(3, b.pairCount)
    columns.unlinkAll(b, { again }, 1)
    b.mass[2] = 7
    columns.unlinkAll(b, { second }, 1)
    columns.release(b, 2)
    assert.equal(2, b.count)
    assert.equal(2, columns.claim(b))
    assert.equal(1, b.mass[2])
  end)
end)

describe("the registry", function()
  it("reports what is new, gone or moved, and nothing when all is the same", function()
    local b, self = columns.new(), registry.new()
    local lines = {}
    local function enter(_, object)
      local slot = columns.claim(b)
      b.slotOf[object], b.object[slot] = slot, object
      lines[#lines + 1] = "+" .. object.name
      return slot
    end
    local function leave(_, slot)
      lines[#lines + 1] = "-" .. b.object[slot].name
      b.slotOf[b.object[slot]] = nil
      columns.release(b, slot)
    end
    local function rename(_, slot, record)
      lines[#lines + 1] = b.object[slot].name .. ">" .. record.name
      b.group[slot] = record
    end
    local function update(objects)
      lines = {}
      local realEnter = function(_, object, record, key)
        local slot = enter(b, object)
        b.group[slot], b.key[slot] = record, key
        return slot
      end
      local changed = registry.update(b, self, objects, realEnter, leave, rename)
      return changed, table.concat(lines, " ")
    end
    local function newNamed(name)
      return { name = name, x = 0, y = 0, width = 1, height = 1 }
    end
    local p, q, r = newNamed("p"), newNamed("q"), newNamed("r")
    local objects = { boxes = { p, q }, hero = r }
    assert.same({ true, "+p +q +r" }, { update(objects) })
    assert.same({ false, "" }, { update(objects) })
    assert.is_true(b.rank[b.slotOf[p]] < b.rank[b.slotOf[q]])
    assert.is_true(b.rank[b.slotOf[q]] < b.rank[b.slotOf[r]])
    objects.boxes[1], objects.boxes[2] = q, p
    assert.same({ true, "" }, { update(objects) })
    assert.is_true(b.rank[b.slotOf[q]] < b.rank[b.slotOf[p]])
    objects.boxes[2], objects.crates = nil, { p }
    assert.same({ true, "p>crates" }, { update(objects) })
    objects.hero = nil
    assert.same({ true, "-r" }, { update(objects) })
    assert.same({ true, "-q -p" }, { update({}) })
    assert.equal(0, b.count)
  end)
end)
