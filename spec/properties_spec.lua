--- What holds for every scene, tried on random ones. Failures name the seed.

local fold = require "spec.support.fold"
local newRandom = require("spec.support.random").new
local overlap = require "spec.support.overlap"
local script = require "spec.support.script"

local WILD = { steps = 120, boxes = 24, writes = 0.5, specials = true }
local CALM = { steps = 300, boxes = 40, writes = 0.04, specials = true }

--- Plays scripts with several seeds in pairs of worlds; fails with the first difference.
local function checkSame(seeds, options, settingsA, settingsB, insertA, insertB)
  for seed = 1, seeds do
    local random = script.new(seed, options)
    local text = script.compare(random, settingsA, settingsB, insertA, insertB)
    if text then error(("seed %d, %s"):format(seed, text), 2) end
  end
end

--- Plays two players to the end, with a look in between.
local function checkBoth(seed, a, b, before)
  local more = true
  while more do
    if before then before(a, b) end
    more = a:next()
    b:next()
    local text = more and script.difference(a, b)
    if text then error(("seed %d, step %d: %s"):format(seed, a.step, text), 2) end
  end
end

--- Lets 30 boxes fall on a floor and go again, in a seeded order.
local function comeAndGo(world, seed)
  local random, guests = newRandom(seed), {}
  guests[1] = world:add("guests", { x = 0, y = 100, width = 400, height = 8, static = true })
  for i = 2, 30 do
    guests[i] = world:add("guests", { x = 12 * i, y = 5 * i, width = 16, height = 16 })
  end
  for i, guest in ipairs(random:shuffled(guests)) do
    if i % 3 == 0 then world:update(1 / 60) end
    world:remove(guest)
  end
  world:update(1 / 60)
  world.objects.guests = nil
end

local function isFinite(value)
  return value == value and value > -1e9 and value < 1e9
end

describe("the same scene goes the same way, to the bit,", function()
  for _, row in ipairs {
    { "with both broad phases", { broadphase = "pairs" }, { broadphase = "grid" } },
    { "with the automatic broad phase", { broadphase = "pairs" }, {} },
    { "with resting objects skipped or not", { rest = true }, { rest = false } },
    {
      "with resting objects skipped or not, pair by pair",
      { rest = true, broadphase = "pairs" },
      { rest = false, broadphase = "grid" },
    },
    { "in cells of 8 px", { broadphase = "grid", cellSize = 8 }, { broadphase = "grid" } },
    { "in cells of 37.5 px", { broadphase = "grid", cellSize = 37.5 }, { broadphase = "pairs" } },
    { "in cells of 1000 px", { broadphase = "grid", cellSize = 1000 }, { broadphase = "grid" } },
    {
      "with push first and both broad phases",
      { push = "first", broadphase = "pairs" },
      { push = "first", broadphase = "grid", rest = false },
    },
  } do
    it(row[1] .. ", wild", function() checkSame(10, WILD, row[2], row[3]) end)
    it(row[1] .. ", calm", function() checkSame(4, CALM, row[2], row[3]) end)
  end

  it("however its objects were put in", function()
    local inserts = script.inserts
    local options = { steps = 100, boxes = 24, writes = 0, specials = true }
    checkSame(6, options, nil, nil, inserts.add, inserts.insert)
    checkSame(6, options, nil, nil, inserts.add, inserts.assign)
  end)

  it("under the same keys, whatever came and went before", function()
    for seed = 1, 6 do
      local random = script.new(seed, { steps = 100, boxes = 24, writes = 0.3, specials = true })
      local function visit(world) comeAndGo(world, seed) end
      checkBoth(seed, script.play(random), script.play(random, nil, nil, visit))
    end
  end)

  it("under the same keys, whatever comes and goes far away", function()
    for seed = 1, 6 do
      local random = script.new(seed, { steps = 100, boxes = 24, writes = 0.3, specials = true })
      local guests, list, x = newRandom(seed), {}, 5000
      checkBoth(seed, script.play(random), script.play(random), function(_, b)
        x = x + 50
        local guest = { x = x, y = -3000, width = 8, height = 8, gravity = 0 }
        guest.static = guests:chance(0.5)
        list[#list + 1] = b.world:add("guests", guest)
        if guests:chance(0.7) then
          b.world:remove(table.remove(list, guests:integer(1, #list)))
        end
      end)
    end
  end)

  it("under the same keys, in whatever order they were filled", function()
    for seed = 1, 6 do
      local random = script.new(seed, { steps = 100, boxes = 24, writes = 0, specials = true })
      local a, b = script.play(random), script.play(random, nil, function() end)
      local keys, last = {}, {}
      for i, entry in ipairs(random.objects) do
        last[entry[1]] = (last[entry[1]] or 0) + 1
        keys[i] = last[entry[1]]
      end
      for i = #random.objects, 1, -1 do
        local group = random.objects[i][1]
        b.world.objects[group] = b.world.objects[group] or {}
        b.world.objects[group][keys[i]] = b.list[i]
      end
      checkBoth(seed, a, b)
    end
  end)

  it("on every Lua", function()
    local sum = fold.START
    for seed = 1, 4 do
      local player = script.play(script.new(seed, WILD))
      while player:next() do end
      for i = 1, player.count do
        if player.list[i] then sum = fold.objects(sum, { player.list[i] }) end
      end
    end
    assert.are.equal("0", ("%.0f"):format(sum))
  end)
end)

describe("whatever happens,", function()
  it("every number stays finite", function()
    for _, push in ipairs { "both", "first" } do
      for seed = 100, 120 do
        local player = script.play(script.new(seed, WILD), { push = push })
        while player:next() do
          for i = 1, player.count do
            local object = player.list[i]
            if object then
              local moves = isFinite(object.vx or 0) and isFinite(object.vy or 0)
              local is = isFinite(object.x) and isFinite(object.y) and moves
              local text = "seed %d, push %s, step %d: object %d is lost"
              assert(is, text:format(seed, push, player.step, i))
            end
          end
        end
      end
    end
  end)

  it("nothing sinks into what is static", function()
    local options = { steps = 200, boxes = 40, writes = 0, specials = false }
    for _, push in ipairs { "both", "first" } do
      for seed = 200, 215 do
        local player = script.play(script.new(seed, options), { push = push })
        while player:next() do
          for i = 1, player.count do
            local box = player.list[i]
            for j = 1, box.static and 0 or player.count do
              local wall = player.list[j]
              local depth = wall.static and overlap.depth(box, wall) or 0
              if depth > 1e-6 then
                local text = "seed %d, push %s, step %d: object %d is %.3g px inside %d"
                error(text:format(seed, push, player.step, i, depth, j))
              end
            end
          end
        end
      end
    end
  end)

  it("boxes that may touch do not sink into each other", function()
    for seed = 300, 315 do
      local random = script.new(seed, { steps = 200, boxes = 40, writes = 0, specials = false })
      for _, entry in ipairs(random.objects) do entry[2].mask = nil end
      local player = script.play(random)
      local deepest = overlap.checker(player.list)
      while player:next() do
        local depth = deepest()
        assert(depth <= 1e-6, ("seed %d, step %d: %.3g px"):format(seed, player.step, depth))
      end
    end
  end)

  it("two worlds do not disturb each other", function()
    local first, second = script.new(1, WILD), script.new(2, WILD)
    local a, b, c = script.play(first), script.play(first), script.play(second)
    while a:next() do
      b:next()
      c:next()
    end
    for i = 1, a.count do
      if a.list[i] then assert(a.list[i].x == b.list[i].x, "object " .. i .. " differs") end
    end
  end)
end)

describe("a saved state", function()
  it("goes on as the first time, to the bit", function()
    for seed = 1, 6 do
      local random = script.new(seed, { steps = 160, boxes = 24, writes = 0, specials = true })
      local player = script.play(random)
      for _ = 1, 80 do player:next() end
      local state, first = player.world:save(), {}
      while player:next() do first[#first + 1] = player.world:hash() end
      player.world:restore(state)
      for i = 1, 80 do
        player.world:update(random.steps[80 + i].dt)
        local text = "seed %d: step %d differs"
        assert(player.world:hash() == first[i], text:format(seed, 80 + i))
      end
    end
  end)

  it("is the same with either broad phase", function()
    for seed = 1, 4 do
      local random = script.new(seed, WILD)
      local a = script.play(random, { broadphase = "pairs" })
      local b = script.play(random, { broadphase = "grid" })
      while a:next() do
        b:next()
        assert(a.world:hash() == b.world:hash(), ("seed %d, step %d"):format(seed, a.step))
      end
    end
  end)
end)
