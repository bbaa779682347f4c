--- Slopes in worlds at random, and what knows of them beside the step. What a step does with them
--- is in spec/scenarios/18_slopes_spec.lua.

local newRandom = require("spec.support.random").new
local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local small = require("spec.support.small")

local NAMES = { "left", "right", "topleft", "topright" }

describe("slope: queries", function()
  --- Whether a point is in a slope, by the sides of its three edges; px to the nearest edge, too.
  local function isIn(slope, x, y)
    local u, v = (x - slope.x) / slope.width, (y - slope.y) / slope.height
    if slope.slope == "right" or slope.slope == "topright" then
      u = 1 - u -- 0 at the upright side
    end
    if slope.slope == "left" or slope.slope == "right" then
      v = 1 - v -- 0 at the level side
    end
    local least = math.min(u, v, 1 - u - v) * math.min(slope.width, slope.height)
    return least > 0, math.abs(least)
  end

  local function newSlopes(seed)
    local random, world, list = newRandom(seed), physics.newWorld({ gravity = 0 }), {}
    for n = 1, 6 do
      local slope = { x = random:between(0, 200), y = random:between(0, 200), static = true }
      slope.width, slope.height = random:between(5, 80), random:between(5, 80)
      slope.slope = random:pick(NAMES)
      list[n] = world:add("hills", slope)
    end
    return random, world, list
  end

  it("are found by points as a plain formula says", function()
    for seed = 1, 50 do
      local random, world, slopes = newSlopes(seed)
      for _ = 1, 40 do
        local x, y, found = random:between(-20, 300), random:between(-20, 300), {}
        for _, object in ipairs((world:queryPoint(x, y))) do
          found[object] = true
        end
        for _, slope in ipairs(slopes) do
          local isInside, margin = isIn(slope, x, y)
          assert.is_true(margin <= 1e-6 or isInside == (found[slope] or false))
        end
      end
    end
  end)

  -- The true normal of 1:2, up to the right.
  local function isNormal(nx, ny)
    assert.near(-1 / math.sqrt(5), nx or 0, 1e-12)
    assert.near(-2 / math.sqrt(5), ny or 0, 1e-12)
  end

  it("tell a ray where it meets the edge, and the true normal there", function()
    local world = physics.newWorld({ gravity = 800 })
    local slope = { x = 80, y = 336, width = 128, height = 64, static = true, slope = "right" }
    world:add("ground", slope)
    local object, x, y, nx, ny, fraction = world:raycast(144, 0, 144, 736)
    assert.same({ slope, 144, 368, 0.5 }, { object, x, y, fraction })
    isNormal(nx, ny)
    assert.same({ slope, 208, 380, 1, 0, 0.46 }, { world:raycast(300, 380, 100, 380) })
    assert.is_nil((world:raycast(90, 300, 150, 360)))
  end)

  -- `isTurned`: the same with x in place of y, and gravity to the right.
  local function newHill(isTurned)
    local world =
      physics.newWorld(isTurned and { gravity = 0, gravityX = 800 } or { gravity = 800 })
    local function add(x, y, width, height, slope)
      local object = { x = x, y = y, width = width, height = height, static = true, slope = slope }
      if isTurned then
        object.x, object.y, object.width, object.height = y, x, height, width
      end
      return world:add("ground", object)
    end
    add(-400, 400, 480, 40)
    local slope = add(80, 336, 128, 64, "right")
    add(208, 336, 100, 64)
    add(300, 200, 8, 136)
    local body = { x = 20, y = 376, width = 16, height = 24 }
    if isTurned then
      body = { x = 376, y = 20, width = 24, height = 16 }
    end
    world:add("players", body)
    world:update(1 / 60)
    return world, body, slope
  end

  it("stop a sweep at the edge, with its normal, and meet what is inside at once", function()
    local world, body, slope = newHill()
    -- Where it is, where it goes, and what it meets there: x, y, fraction.
    for _, row in ipairs({
      { 20, 376, 176, 0, 64, 376, 0.25 },
      { 100, 300, 0, 100, 100, 358, 0.58 },
      { 150, 372, -30, 0, 150, 372, 0 },
    }) do
      body.x, body.y = row[1], row[2]
      local object, x, y, nx, ny, fraction = world:sweep(body, row[3], row[4])
      assert.same({ slope, row[5], row[6], row[7] }, { object, x, y, fraction })
      if fraction > 0 then
        isNormal(nx, ny)
      end
    end
  end)

  it("let a sweep pass that begins inside, below or behind where they are one-way", function()
    local world, body, slope = newHill()
    slope.oneWay = "top"
    world:refresh(slope)
    world:remove(world.objects.ground[3])
    for _, row in ipairs({ { 150, 372, -30, 0 }, { 120, 410, 0, -100 }, { 230, 350, -40, 0 } }) do
      body.x, body.y = row[1], row[2]
      assert.is_nil((world:sweep(body, row[3], row[4])))
    end
    body.x, body.y = 100, 300
    assert.equal(slope, (world:sweep(body, 0, 100)))
  end)

  it("are met at the edge, not at the foot, by what stands there to rounding", function()
    for _, o in ipairs({ 0, 0.1, -1000.1, 100000.3 }) do
      local world = physics.newWorld({ gravity = 800 })
      local foot = { x = o + 80, y = o + 336, width = 128, height = 64, slope = "right" }
      foot.static = true
      world:add("ground", foot)
      local body = world:add("players", { x = 0, y = 0, width = 16, height = 24 })
      for n = 0, 35 do -- each of three by three places, and of four ways
        body.x, body.y = o + 64 + (n % 3 - 1) * 1e-8, o + 376 + (math.floor(n / 3) % 3 - 1) * 1e-8
        local way = ({ 10, 0.1, 1e-3, 1e-5 })[math.floor(n / 9) + 1]
        local _, _, _, nx, ny = world:sweep(body, way, 0)
        isNormal(nx, ny)
      end
    end
  end)

  it("lead a move along the edge, over the crest and to the wall", function()
    local world, body, slope = newHill()
    local function move(fromX, fromY, toX, toY, response)
      body.x, body.y = fromX, fromY
      local x, y, hits = world:move(body, toX, toY, response)
      local last = hits[#hits]
      return { x, y, #hits, last and last.side }, last
    end
    local told, hit = move(20, 376, 260, 376)
    assert.same({ 260, 312, 1, "bottom" }, told)
    assert.equal(slope, hit.other)
    isNormal(hit.nx, hit.ny)
    assert.same({ 284, 312, 2, "right" }, (move(20, 376, 400, 376)))
    assert.same({ 64, 376, 1, "bottom" }, (move(20, 376, 260, 376, "touch")))
    told = move(100, 300, 100, 400, "bounce")
    assert.near(100 - 42 * 0.8, told[1], 1e-9)
    assert.near(358 - 42 * 0.6, told[2], 1e-9)
  end)

  it("do the same where gravity points to the right", function()
    local world, body = newHill()
    local turned, other = newHill(true)
    -- Where it is, and where it wants to go.
    local WAYS = { { 20, 376, 196, 376 }, { 100, 300, 100, 400 }, { 20, 376, 400, 376 } }
    for _, row in ipairs(WAYS) do
      local dx, dy = row[3] - row[1], row[4] - row[2]
      for _, response in ipairs({ "slide", "touch", "bounce" }) do
        body.x, body.y, other.x, other.y = row[1], row[2], row[2], row[1]
        local _, x, y, nx, ny, fraction = world:sweep(body, dx, dy)
        assert.same({ y, x, ny, nx, fraction }, { select(2, turned:sweep(other, dy, dx)) })
        local toX, toY, hits, count = world:move(body, row[3], row[4], response)
        local y2, x2, hits2, count2 = turned:move(other, row[4], row[3], response)
        assert.same({ toX, toY, count }, { x2, y2, count2 })
        for n = 1, count do
          local hit, hit2 = hits[n], hits2[n]
          assert.same({ hit.nx, hit.ny, hit.x, hit.y }, { hit2.ny, hit2.nx, hit2.y, hit2.x })
        end
      end
    end
  end)

  play.row("tell how fast something came, restitution {e}", play.ONCE, function(v)
    local fields = { slope = "right", restitution = v.e }
    local slope = scene.maker("ground", { static = true })("slope", 19, 16, 1, 3, fields)
    return { gravity = 40, slope, scene.maker("boxes", { vy = 20 })("box", 19, 15, 1, 1) }
  end, { "listen box; run:step(0.05); heard.box.speed == 20" }, { "e", { 0 }, { 0.5 }, { 1 } })

  it("are named by explain and told by touching", function()
    local world, body, slope = newHill()
    body.x, body.y = 100, 345
    local text = world:explain(body, slope)
    assert.truthy(text:find("objects.ground[2] is a slope, high at its right", 1, true))
    assert.truthy(text:find("they are 11.628 px apart at the sloped edge", 1, true))
    body.y = 358
    assert.truthy(
      world:explain(body, slope):find("flush at the bottom of objects.players[1]", 1, true)
    )
    small.run(world, 3)
    assert.equal("bottom", world:touching(body, slope))
  end)

  local RAMP = scene.maker("ramps", { kinematic = true, slope = "right" })("ramp", 0, 100, 400, 50)
  play.row("may change while the game runs, if they are kinematic", play.ONCE, {
    RAMP,
    scene.maker("players", {})("body", 150, 60, 10, 10),
  }, {
    { "run:play(1.5); body.y ~ 120; ramp.slope = 'left'" },
    { "run:play(1.5); body.y ~ 108.75; ramp.slope = nil" },
    { "run:play(1.5); body.y ~ 90; ramp.slope = 'right'" },
    { "run:play(1.5); body.y ~ 120" },
    "#world:queryPoint(380, 140) == 1; #world:queryPoint(20, 110) == 0",
  })
end)

--          topright
--   ________________
--    `-.._          |
--         `-.._     |      the way becomes narrower
--          .-'|  `--|
--      .-'    |
--  .-'________|
it("slope: below a roof that comes down it stops what walks up where it meets the roof", function()
  for _, y in ipairs({ -400, 300 }) do
    local world = physics.newWorld({ gravity = 800 })
    world:add("floor", { x = -400, y = 0, width = 1000, height = 20, static = true })
    local hill = { x = 0, y = -100, width = 200, height = 100, static = true, slope = "right" }
    world:add("slopes", hill)
    world:add("other", { x = 2000, y = y, width = 10, height = 10, static = true })
    local roof = { x = 0, y = -140, width = 200, height = 40, static = true, slope = "topright" }
    world:add("slopes", roof)
    local walker = world:add("walkers", { x = -40, y = -16, width = 16, height = 16 })
    for _ = 1, 180 do
      walker.vx = 100
      world:update(1 / 60)
    end
    -- The corner is at (x, -x / 2 - 16), the roof there at -140 + x / 5.
    local x = 124 / 0.7
    assert.near(x, walker.x + 16, 1e-6)
    assert.near(-x / 2, walker.y + 16, 1e-6)
  end
end)

--  -----------
--      O         up, back from the ceiling, and off the slope
--     .-'|
--  .-'   |
it("slope: met after a bounce in the same step, it deflects along its normal", function()
  for _, speed in ipairs({ 500, 3150 }) do
    local world = physics.newWorld({ gravity = 0 })
    world:add("walls", { x = -900, y = -60, width = 2000, height = 20, static = true })
    local slope = { x = 0, y = 0, width = 200, height = 100, static = true, slope = "right" }
    world:add("slopes", slope)
    local box = { x = 90, y = -20, width = 10, height = 10, vy = -speed, restitution = 1 }
    world:add("boxes", box)
    local steps = math.floor(7800 / speed)
    small.run(world, steps)
    -- 20 px up to the ceiling at -40, then down until its corner, at x = 100, is at 50. The
    -- normal is (-1, -2) / √5: (0, v) becomes (-0.8, -0.6) * v.
    local late = steps / 60 - (20 + 80) / speed
    assert.is_true(late > 0)
    assert.near(90 - 0.8 * speed * late, box.x, 1e-6)
    assert.near(40 - 0.6 * speed * late, box.y, 1e-6)
  end
end)
