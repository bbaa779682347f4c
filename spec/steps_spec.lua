--- The broad phases, by themselves, and the limit of a speed inside a step.

local columns = require("physics.memory.columns")
local allPairs = require("spec.support.all_pairs")
local grid = require("physics.broadphase.grid")
local newRandom = require("spec.support.random").new
local path = require("physics.motion.path")
local physics = require("physics")

local DYNAMIC = columns.DYNAMIC

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
  path.begin(b)
  return b
end

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
