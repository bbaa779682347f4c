--- `snap`: an object that stood on something stays on the ground when that drops by a little.
---
---      +-+
---      | |->
---      +-+__         stairs of 1 to 16 px, up by `nudge`, down by `snap`
---     __|   |__

local effort = require("spec.support.effort")
local physics = require("physics")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

effort.wholeOn("LuaJIT compiled")

local RATES = { 60, 30, 144, 240 }
local LEVELS = { rate = RATES, shift = { 0, 1 / 3 } }
local TURNED = { rate = RATES, turn = variants.TURNS, push = { "both", "first" } }
TURNED.order, TURNED.broadphase = { "forward", "shuffled" }, variants.BROADPHASES

local function solid(x, y, width, height, fields)
  local object = { x = x, y = y, width = width, height = height, static = true }
  for key, value in pairs(fields or {}) do
    object[key] = value
  end
  return { "tiles", object }
end

local function body(name, x, y, width, height, fields)
  local entry = solid(x, y, width, height, fields)
  entry[1], entry[2].name, entry[2].static = "bodies", name, nil
  return entry
end

local function man(x, y, fields)
  return body("man", x, y, 16, 24, fields)
end

local function lift(x, y, width, height, fields)
  local entry = solid(x, y, width, height, fields)
  entry[1], entry[2].name, entry[2].static, entry[2].kinematic = "lifts", "lift", nil, true
  return entry
end

-- A ledge on the left, up to x = 0, and ground that is `drop` px lower.
local function step(drop)
  return { solid(-300, 0, 300, 200), solid(0, drop, 600, 200 - drop) }
end

local function with(description, ...)
  for _, entry in ipairs({ ... }) do
    description[#description + 1] = entry
  end
  return description
end

-- Stairs of `count` steps from x = 0 on to one side (`way`), upwards, a landing, and down again.
-- The lower ground is at y = 0.
local function stairs(way, count, size)
  local description = {}
  local function put(x, width, y)
    local left = way > 0 and x or -x - width
    description[#description + 1] = solid(left, y, width, 16 + size * (count + 1))
  end
  put(-300, 300, 0)
  for i = 1, count do
    put((i - 1) * size, size, -i * size)
  end
  put(count * size, 40, -count * size)
  for i = 1, count do
    put(count * size + 40 + (i - 1) * size, size, -(count - i) * size)
  end
  put(2 * count * size + 40, 4000, 0)
  return description
end

describe("stairs", function()
  for _, size in ipairs({ 1, 2, 4, 8, 16 }) do
    for _, speed in ipairs({ 60, 120, 200, 400 }) do
      local title = "of %d px, at %d px/s: it is on the ground in all steps, up and down"
      it(title:format(size, speed), function()
        local count = math.max(3, math.floor(48 / size))
        scene.each(LEVELS, function(run)
          for _, way in ipairs({ 1, -1 }) do
            local description = stairs(way, count, size)
            local x = way > 0 and -40 or 24
            local fields = { nudge = size, snap = size }
            description[#description + 1] = man(x, -24, fields)
            local named = run:build(description)
            run:step(1 / run.rate)
            local highest = 0
            local steps = math.floor((2 * count * size + 200) / speed * run.rate)
            for _ = 1, steps do
              named.man.vx = way * speed
              run:step(1 / run.rate)
              run:check(
                named.man.touching.bottom,
                "in the air at %.9g, %.9g",
                named.man.x,
                named.man.y
              )
              run:near("vy", named.man.vy, 0)
              highest = math.min(highest, named.man.y + 24)
            end
            run:near("the top", highest, -count * size)
            run:near("the end", named.man.y, -24)
            run:near("the way", named.man.x, x + way * speed * steps / run.rate)
          end
        end)
      end)
    end
  end
end)

describe("snap", function()
  it("leaves edges alone that are higher than it", function()
    scene.each(TURNED, function(run)
      local named = run:build(with(step(8.01), man(-40, -24, { snap = 8 })))
      local plain = run.rate
      run:step(1 / plain)
      local hasFallen = false
      for _ = 1, plain do
        named.man.vx = 90
        run:step(1 / plain)
        local drop = named.man.y + 24
        hasFallen = hasFallen or (drop > 0.01 and drop < 8)
        run:check(named.man.touching.bottom or drop < 8.01, "it hangs at y = %.9g", named.man.y)
      end
      run:check(hasFallen, "it did not fall")
      run:near("the end", named.man.y, 8.01 - 24)
    end)
  end)

  it("takes what drops by exactly that", function()
    scene.each(TURNED, function(run)
      local named = run:build(with(step(8), man(-40, -24, { snap = 8 })))
      run:step(1 / run.rate)
      for _ = 1, run.rate do
        named.man.vx = 90
        run:step(1 / run.rate)
        local y = named.man.y + 24
        run:check(named.man.touching.bottom, "it is in the air at y = %.9g", y)
        run:check(y < 1e-6 or y > 8 - 1e-6, "it is between, at y = %.9g", y)
      end
    end)
  end)

  it("changes no jump, whether on stairs or off an edge", function()
    scene.each(TURNED, function(run)
      local heights = {}
      for _, snap in ipairs({ 0, 16 }) do
        local named = run:build(with(step(4), man(-20, -24, { snap = snap })))
        run:step(1 / run.rate)
        named.man.vy = -200
        local highest, seconds = 0, 0
        repeat
          named.man.vx = 60
          run:step(1 / run.rate)
          seconds = seconds + 1 / run.rate
          highest = math.min(highest, named.man.y + 24)
        until named.man.touching.bottom or seconds > 2
        heights[#heights + 1] = { highest, seconds, named.man.y }
      end
      for n, name in ipairs({ "height", "time", "end" }) do
        run:near("the " .. name .. " of the jump", heights[2][n], heights[1][n])
      end
    end)
  end)

  it("does not draw down what falls, floats or is thrown up", function()
    scene.each({ rate = RATES }, function(run)
      local named = run:build(
        with(
          step(4),
          body("falls", -200, -30, 16, 24, { snap = 16 }),
          body("floats", -100, -30, 16, 24, { snap = 16, gravity = 0 }),
          body("flies", -60, -24, 16, 24, { snap = 16, ay = -1000 })
        )
      )
      run:step(1 / run.rate)
      run:near("floats", named.floats.y, -30)
      run:check(named.falls.y < -24 - 1, "it was drawn down")
      run:play(0.5)
      run:near("floats", named.floats.y, -30)
      run:check(named.flies.y < -26, "it stayed at %.9g", named.flies.y)
    end)
  end)

  it("takes along what stands on it: a crate, and a man on that", function()
    scene.each(TURNED, function(run)
      local named = run:build(
        with(
          step(6),
          man(-40, -24, { snap = 6 }),
          body("crate", -40, -40, 16, 16, { friction = 0.5 }),
          body("top", -38, -52, 12, 12)
        )
      )
      run:step(1 / run.rate)
      for _ = 1, run.rate do
        named.man.vx, named.crate.vx, named.top.vx = 60, 60, 60
        run:step(1 / run.rate)
        run:near("the crate", named.crate.y, named.man.y - 16)
        run:near("the man on it", named.top.y, named.crate.y - 12)
      end
      run:near("the end", named.man.y, 6 - 24)
    end)
  end)

  it("never leads into or through anything", function()
    scene.each(TURNED, function(run)
      local named = run:build(with(
        { solid(-300, 0, 300, 8), solid(0, 16, 600, 16) },
        solid(4, 4, 60, 2), -- a thin board on the way down
        man(-40, -24, { snap = 16 })
      ))
      run:step(1 / run.rate)
      local board = false
      for _ = 1, 2 * run.rate do
        named.man.vx = 60
        run:step(1 / run.rate)
        local x, y = named.man.x, named.man.y + 24
        board = board or (x > 0 and x < 60 and math.abs(y - 4) < 1e-6)
        run:check(named.man.touching.bottom, "it is in the air at %.9g, %.9g", x, y)
        if x > -11.5 and x < 63.5 then
          run:check(y <= 4 + 1e-6, "it is in the board at %.9g, %.9g", x, y)
        end
      end
      run:near("the end", named.man.y, 16 - 24)
      run:check(board, "it did not come to the board")
    end)
  end)

  it("stays on a sinking lift that does not carry, and on one that falls faster than it", function()
    scene.each(TURNED, function(run)
      for _, carry in ipairs({ true, false }) do
        local named = run:build({
          lift(-40, 0, 80, 8, { carry = carry }),
          man(-8, -24, { snap = 16 }),
        })
        run:step(1 / run.rate)
        named.lift.vy = 300
        for _ = 1, run.rate do
          run:step(1 / run.rate)
          run:near("the gap", named.lift.y - named.man.y - 24, 0)
          run:check(named.man.touching.bottom, "it does not stand on the lift")
        end
      end
    end)
  end)

  it("leads from a ledge down onto a train, and from there down to the ground", function()
    scene.each(TURNED, function(run)
      for _, speed in ipairs({ 10, -10 }) do
        local named = run:build({
          solid(-300, -4, 240, 8),
          solid(-300, 4, 900, 100),
          lift(-60, 0, 80, 4, { vx = speed }),
          man(-90, -28, { snap = 4 }),
        })
        run:step(1 / run.rate)
        for _ = 1, 2 * run.rate do
          named.man.vx = 90
          run:step(1 / run.rate)
          run:check(named.man.touching.bottom, "in the air at %.9g", named.man.x)
        end
        run:near("the end", named.man.y, 4 - 24)
      end
    end)
  end)

  it("lets through what dropThrough and canCollide let through", function()
    local world = physics.newWorld({ gravity = 800 })
    world:add("ledges", { x = -100, y = 0, width = 200, height = 4, static = true, oneWay = "top" })
    world:add("ledges", { x = -100, y = 8, width = 200, height = 4, static = true, oneWay = "top" })
    local one = world:add("men", { x = -50, y = -24, width = 16, height = 24, snap = 6 })
    world:update(1 / 60)
    assert.is_true(world:dropThrough(one))
    world:update(1 / 60)
    assert.is_true(one.y > -24 and one.y < -23)

    world = physics.newWorld({ gravity = 800 })
    world:add("tiles", { x = -100, y = 0, width = 100, height = 4, static = true })
    local ghost = world:add("ghosts", { x = 0, y = 4, width = 100, height = 4, static = true })
    local function refuse(_, other)
      return other ~= ghost
    end
    one = world:add("men", { x = -12, y = -24, width = 16, height = 24, snap = 6 })
    one.canCollide = refuse
    for _ = 1, 12 do
      one.vx = 200
      world:update(1 / 60)
    end
    assert.is_true(one.y > -20 and one.vy > 0)
  end)

  it("ends one contact and begins the other, once for each stair", function()
    local world = physics.newWorld({ gravity = 800 })
    for i = 0, 9 do
      world:add("tiles", { x = 16 * i, y = 4 * i, width = 16, height = 100, static = true })
    end
    local one = world:add("men", { x = 0, y = -24, width = 16, height = 24, snap = 4 })
    local begun, ended = 0, 0
    function one.onBegin(_, _, side, speed)
      assert.equal("bottom", side)
      assert.equal(0, speed)
      begun = begun + 1
    end
    function one.onEnd()
      ended = ended + 1
    end
    world:update(1 / 60)
    begun, ended = 0, 0
    for _ = 1, 100 do
      one.vx = 60
      world:update(1 / 60)
    end
    assert.equal(6, begun)
    assert.equal(6, ended)
    assert.equal(-24 + 24, one.y)
  end)
end)

-- Ground that goes down from x = 0 on. Each piece is { width, px that it begins lower, px that it
-- falls on its way }.
local DESCENTS = {
  ["from stairs onto a slope"] = {
    { 12, 8, 0 },
    { 12, 8, 0 },
    { 64, 8, 32 },
    { 12, 8, 0 },
    { 64, 8, 64 },
  },
  ["from a crest onto a slope"] = { { 64, 8, 64 }, { 20, 0, 0 }, { 64, 3, 32 }, { 20, 0, 0 } },
  ["from a slope onto the ground"] = { { 64, 0, 32 }, { 40, 8, 0 }, { 32, 0, 32 }, { 10, 5, 0 } },
  ["where a slope falls away"] = { { 64, 0, 16 }, { 64, 0, 64 }, { 32, 6, 8 }, { 32, 8, 64 } },
}

-- Adds the ground, to one side (`way`); returns a function that says how deep it is below a box of
-- 16 px with the left edge at x.
local function descend(description, pieces, way)
  local tops, x, y = { { -300, 0, 0, 300, 0 } }, 0, 0
  for _, piece in ipairs(pieces) do
    y = y + piece[2]
    tops[#tops + 1] = { x, x + piece[1], y, piece[1], piece[3] }
    x, y = x + piece[1], y + piece[3]
  end
  tops[#tops + 1] = { x, x + 4000, y, 4000, 0 }
  for _, top in ipairs(tops) do
    local left = way > 0 and top[1] or -top[2]
    if top[5] > 0 then
      local slope = way > 0 and "left" or "right"
      description[#description + 1] = solid(left, top[3], top[4], top[5], { slope = slope })
    end
    local base = top[3] + top[5]
    description[#description + 1] = solid(left, base, top[4], 400 - base)
  end
  return function(at)
    local depth, from = math.huge, way > 0 and at or -at - 16
    for _, top in ipairs(tops) do
      if from + 16 > top[1] + 1e-6 and from < top[2] - 1e-6 then
        local off = math.max(from - top[1], 0)
        depth = math.min(depth, top[3] + off * top[5] / top[4])
      end
    end
    return depth
  end
end

-- To the right under each gravity, to the left where that points down.
local function eachWay(f)
  scene.each({ rate = RATES, turn = variants.TURNS }, function(run)
    f(run, 1)
  end)
  scene.each({ rate = RATES }, function(run)
    f(run, -1)
  end)
end

describe("snap and slopes:", function()
  for title, pieces in pairs(DESCENTS) do
    for _, speed in ipairs({ 60, 150, 400 }) do
      it(("%s, at %d px/s, it is on the ground in all steps"):format(title, speed), function()
        eachWay(function(run, way)
          local description = {}
          local depthAt = descend(description, pieces, way)
          local x = way > 0 and -40 or 24
          description[#description + 1] = man(x, -24, { snap = 8 })
          description[#description + 1] = body("crate", x, -40, 16, 16)
          local named = run:build(description)
          run:step(1 / run.rate)
          local steps = math.floor(300 / speed * run.rate)
          for _ = 1, steps do
            named.man.vx, named.crate.vx = way * speed, way * speed
            run:step(1 / run.rate)
            local at = named.man
            run:check(at.touching.bottom, "in the air at %.9g, %.9g", at.x, at.y)
            run:near("the foot", at.y + 24, depthAt(at.x))
            run:near("vy", at.vy, 0)
            run:near("what it carries", named.crate.y + 16, at.y)
          end
          run:near("the way", named.man.x, x + way * speed * steps / run.rate)
        end)
      end)
    end
  end

  it("leaves a slope alone that begins lower than that", function()
    eachWay(function(run, way)
      local description = {}
      descend(description, { { 64, 8.01, 32 } }, way)
      description[#description + 1] = man(way > 0 and -40 or 24, -24, { snap = 8 })
      local named = run:build(description)
      run:step(1 / run.rate)
      local inAir = 0
      for _ = 1, run.rate do
        named.man.vx = way * 60
        run:step(1 / run.rate)
        inAir = inAir + (named.man.touching.bottom and 0 or 1)
      end
      run:check(inAir / run.rate > 0.1, "it fell for %d steps only", inAir)
    end)
  end)
end)

describe("snap that is set at run time", function()
  it("counts from the next step on, until it is taken back", function()
    local world = physics.newWorld({ gravity = 800 })
    for i = 0, 40 do
      world:add("tiles", { x = 10 * i, y = 4 * i, width = 10, height = 100, static = true })
    end
    local one = world:add("men", { x = 0, y = -24, width = 16, height = 24 })
    local function inAir(steps)
      local count = 0
      for _ = 1, steps do
        one.vx = 60
        world:update(1 / 60)
        count = count + (one.touching.bottom and 0 or 1)
      end
      return count
    end
    assert.is_true(inAir(100) > 20)
    one.snap = 4
    inAir(20)
    assert.equal(0, inAir(60))
    one.snap = nil
    assert.is_true(inAir(100) > 20)
  end)
end)

describe("snap in a world with everything", function()
  -- The same bits with rest and without, with either broad phase, and after a restored state.
  local function play(settings, doRestore)
    local world = physics.newWorld(settings)
    for i = 0, 30 do
      local y = 3 * (i % 7) + i % 2
      world:add("tiles", { x = 20 * i, y = y, width = 20, height = 100 - y, static = true })
    end
    world:add("tiles", { x = -20, y = -200, width = 20, height = 300, static = true })
    world:add("tiles", { x = 620, y = -200, width = 20, height = 300, static = true })
    world:add("lifts", { x = 200, y = -10, width = 40, height = 6, kinematic = true, vx = -20 })
    for i = 1, 24 do
      local one = { x = 22 * i, y = -40 - 20 * (i % 3), width = 10 + i % 5, height = 14 }
      one.snap, one.nudge, one.friction = i % 4 * 3, i % 5 * 2, i % 3 * 0.2
      world:add("men", one)
    end
    local hashes = {}
    for n = 1, 160 do
      for i, one in ipairs(world.objects.men) do
        if (n + 7 * i) % 90 < 60 then
          one.vx = (n + 13 * i) % 200 < 100 and 60 + 10 * i or -50 - 8 * i
        end
        if one.touching.bottom and (n + i) % 70 == 0 then
          one.vy = -200
        end
      end
      world:update(n % 3 == 0 and 1 / 144 or 1 / 60)
      if doRestore and n % 20 == 0 then
        local state = world:save()
        world:update(1 / 60)
        world:restore(state)
      end
      hashes[#hashes + 1] = world:hash()
    end
    return hashes
  end

  it("is the same to the bit with rest and without, in both broad phases, and restored", function()
    local expected = play({ gravity = 800 })
    assert.same(expected, play({ gravity = 800, rest = false }))
    assert.same(expected, play({ gravity = 800, broadphase = "pairs" }))
    assert.same(expected, play({ gravity = 800 }, true))
    assert.equal(24132238939601, expected[#expected]) -- on every Lua
  end)
end)
