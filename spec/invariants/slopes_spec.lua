--- Slopes in worlds at random, and what knows of them beside the step. What a step does with them
--- is in spec/scenarios/18_slopes_spec.lua.

local effort = require("spec.support.effort")
local newRandom = require("spec.support.random").new
local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local small = require("spec.support.small")

local GRADIENTS = { { 1, 1 }, { 1, 2 }, { 1, 3 }, { 2, 1 }, { 3, 1 } }
local OFFSETS = { 0, 0.1, 1 / 3, -1000.1, 100000.3, 1234567.8, 9000000.7 }
local HEIGHT = 24

--- Hilly ground from (x, y) on: flats and slopes of one size of tile, with solid tiles below them.
--- Returns the objects, and the pieces of the surface: left, right, height on the left and right.
local function buildHills(random, x, y)
  local size, list, pieces = random:pick({ 8, 16, 32 }), {}, {}
  local function add(fields)
    fields.static = true
    list[#list + 1] = fields
  end
  for n = 1, 18 do
    local kind, gradient = random:integer(0, 2), random:pick(GRADIENTS)
    local width, height = size * gradient[2], size * gradient[1]
    if n <= 3 or n > 15 then
      kind = 0
    end
    if n == 1 or n == 18 then
      width = 800
    end
    if kind == 0 then
      add({ x = x, y = y, width = width, height = size })
      pieces[n] = { x, x + width, y, y }
    elseif kind == 1 then
      add({ x = x, y = y - height, width = width, height = height, slope = "right" })
      add({ x = x, y = y, width = width, height = size })
      pieces[n] = { x, x + width, y, y - height }
      y = y - height
    else
      add({ x = x, y = y, width = width, height = height, slope = "left" })
      add({ x = x, y = y + height, width = width, height = size })
      pieces[n] = { x, x + width, y, y + height }
      y = y + height
    end
    x = x + width
  end
  return list, pieces
end

--- The highest place of the surface below a box.
local function topBelow(pieces, x, width)
  local best = math.huge
  for _, piece in ipairs(pieces) do
    local left, right = math.max(x, piece[1]), math.min(x + width, piece[2])
    if right > left + 1e-6 then
      local slant = (piece[4] - piece[3]) / (piece[2] - piece[1])
      best =
        math.min(best, piece[3] + (left - piece[1]) * slant, piece[3] + (right - piece[1]) * slant)
    end
  end
  return best
end

--- One walk over hills. Returns what went wrong, or nil.
local function walkOnce(seed)
  local random = newRandom(seed)
  local x, y = random:pick(OFFSETS), random:pick(OFFSETS)
  local list, pieces = buildHills(random, x, y)
  local width = random:integer(6, 40)
  local speed = random:chance(0.2) and random:between(600, 3600) or random:between(40, 600)
  local way, rate = random:chance(0.5) and 1 or -1, random:pick({ 30, 60, 144, 240, 0 })
  local world = physics.newWorld({ gravity = 800, broadphase = random:pick({ "grid", "pairs" }) })
  for _, object in ipairs(list) do
    world:add("ground", object)
  end
  local first, last = pieces[1][1] + 200, pieces[#pieces][2] - 200
  local start = way > 0 and first + 500 or last - 500
  local body = { x = start, width = width, height = HEIGHT }
  body.y = topBelow(pieces, start, width) - HEIGHT
  world:add("players", body)
  local hit
  function body.onBegin(_, _, side)
    hit = hit or side ~= "bottom" and side
  end
  local time, steps = 0, 0
  while body.x > first and body.x < last do
    local dt = rate == 0 and random:between(0.002, 1 / 30) or 1 / rate
    body.vx = way * speed
    world:update(dt)
    time, steps = time + dt, steps + 1
    local off = body.y - (topBelow(pieces, body.x, width) - HEIGHT)
    -- What is added up at 9 million px is rounded to 2e-9 px in every step, on a flat floor, too.
    local rounding = 1e-6 + steps * 2e-9 * math.abs(body.x) / 9e6
    if hit or body.vx ~= way * speed then
      return ("seed %d: hit on its %s, vx %g"):format(seed, tostring(hit), body.vx)
    elseif math.abs(off) > 1e-9 * (1 + math.abs(body.y)) or body.vy ~= 0 then
      return ("seed %d: %g px off the ground, vy %g"):format(seed, off, body.vy)
    elseif not body.touching.bottom then
      return ("seed %d: on nothing"):format(seed)
    elseif math.abs(body.x - start - way * speed * time) > rounding then
      return ("seed %d: %g px off its way"):format(seed, body.x - start - way * speed * time)
    end
  end
end

local NAMES = { "left", "right", "topleft", "topright" }

describe("slope: hills at random", function()
  it("bear walks over hills: no hit, no hop, no loss", function()
    local failures = {}
    for seed = 1, effort.isWhole and 300 or 20 do
      failures[#failures + 1] = walkOnce(seed)
    end
    assert.same({}, failures)
  end)

  -- Queries -------------------------------------------------------------------------------------

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
