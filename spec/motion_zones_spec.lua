--- Zones: sensors with an `area`, which acts on what is inside.

local garbage = require("spec.support.garbage")
local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local small = require("spec.support.small")

local DT = 1 / 60
local RATES =
  { rate = { 30, 60, 144, 240 }, shift = { 0 }, order = { "forward" }, push = { "both" } }
local ONCE = play.ONCE

-- A zone from (0, 100) to (400, 400).
local function zone(area, changes)
  local place = { x = 0, y = 100, width = 400, height = 300, sensor = true, static = true }
  place.name = "zone"
  local entry = scene.thing("zones", place)(changes)
  entry[2].area = area
  return entry
end

local body = scene.thing("bodies", { name = "body", x = 180, y = 60, width = 20, height = 20 })
local INSIDE = body({ y = 200 })

describe("area: a zone", function()
  -- Inside from the beginning: 1 s under a constant acceleration, exact at every rate.
  play.row("area.gravity, area.gravityX, area.ax and area.ay act: {what}", RATES, function(v)
    return { zone(v.area), INSIDE }
  end, { 1, "body at 180 + dx, 200 + dy, 1e-9" }, {
    "what, area, dx, dy",
    { "gravity", { gravity = 100 }, 0, 50 },
    { "no gravity", { gravity = 0 }, 0, 0 },
    { "a gravity that lifts", { gravity = -100 }, 0, -50 },
    { "gravity sideways", { gravity = 0, gravityX = 60 }, 30, 0 },
    { "wind", { gravity = 0, ax = 40, ay = -20 }, 20, -10 },
    { "wind besides gravity", { ax = 40, ay = -760 }, 20, 20 },
  })

  -- (Without gravity the slope would be a wall.)
  local UP = scene.maker("slopes", { static = true, slope = "right" })("slope", 100, 200, 300, 150)
  local WALKER = { gravity = 0, zone({ gravity = 800 }), UP, body({ y = 230 }) }
  play.row("area.gravity: leads up a slope", RATES, WALKER, {
    { 1, keep = "body.vx = 100", "body.vx == 100", "body.vy >= 0" },
    "body at 280, 230",
  })

  -- k = 2 and 40 px/s² off 100 px/s: to -20 px/s, if it did not stop
  local SLOWED = body({ y = 200, vx = 100, airFriction = 0.5, drag = 10 })
  local MUD = zone({ gravity = 0, airFriction = 1.5, drag = 30 })
  play.row("area.airFriction and area.drag add to those of the body", RATES, { MUD, SLOWED }, {
    0.5,
    "body.vx ~ 120 * exp(-1) - 20, 1e-9; body.x ~ 180 + 60 * (1 - exp(-1)) - 10, 1e-9",
  })

  -- Of (120, 160) from the centre, which is at the rim, one half is inside.
  local AT_RIM = body({ x = 310, y = 350 })
  local PLATE = zone({ gravity = 0, ax = 100 }, { y = 0, height = 400, radius = 200 })
  play.row(
    "radius: acts on what is at its rim by the share inside",
    RATES,
    { PLATE, AT_RIM },
    { { steps = 1 }, "body.vx ~ 50 * dt, 1e-9; body.vy ~ 400 * dt, 1e-9" }
  )

  -- px that a second order method loses at an edge or around a centre, after 2 s, against 240 Hz:
  -- see docs/reliability.md.
  local LOST, ROUND =
    { [30] = 1.6, [60] = 0.4, [144] = 0.1, [240] = 0 }, { y = 0, height = 400, radius = 200 }
  play.row("does the same at each rate: {what}", RATES, function(v)
    return { zone(v.area, v.place), body(v.fields) }
  end, {
    2,
    function(run, it)
      local expected = { it.body.x, it.body.y }
      local fine = scene.run({ shift = 0, order = "forward", push = "both", rate = 240, turn = 0 })
      local named = fine:build({ zone(it.area, it.place), body(it.fields) })
      fine:play(2)
      run:at(named.body, expected[1], expected[2], LOST[run.rate])
    end,
  }, {
    "what, area, fields, place",
    { "a fall into water", { gravity = -300, airFriction = 3 } },
    { "a fall into another gravity", { gravity = 100 }, { y = 90 } },
    { "a ball that is stopped in mud", { gravity = 0, drag = 1200 } },
    { "through wind", { gravity = 0, ax = -300, airFriction = 1 }, { x = -60, y = 200, vx = 200 } },
    { "a swing", { gravity = 0, attract = 500, law = "linear" }, { y = 150, vx = 150 }, ROUND },
    {
      "an orbit",
      { gravity = 0, attract = 200, law = "inverse" },
      { x = 190, y = 90, vx = 200 },
      ROUND,
    },
  })

  -- The air brakes what comes to a wall, and no longer what leans on it.
  local COAST = {
    zone({ gravity = 150, airFriction = 4 }, { y = 290, height = 10 }),
    zone({ gravity = 150, airFriction = 4 }, { x = 160, y = 0, width = 20, height = 290 }),
    scene.thing("tiles", { static = true, x = 160, y = 300, width = 400, height = 20 })(),
    scene.thing("tiles", { static = true, x = 140, y = 0, width = 20, height = 300 })(),
  }
  play.row("area.airFriction: what lands in water, or at a wall, has speed 0", RATES, function(v)
    COAST[5] = body({ x = 300, y = 100 + v.off, vy = 300 })
    COAST[6] = body({ name = "other", x = 190 + v.off, y = 100, vx = -300 })
    return COAST
  end, {
    {
      1.5,
      "body.vy * (body.raw.touching.bottom and 1 or 0) == 0",
      "other.vx * (other.raw.touching.left and 1 or 0) == 0",
    },
    "body touches bottom; other touches left",
  }, { "off", { 0 }, { 0.5 }, { 3.1 }, { 4.7 } })

  -- 800 (1 - share) - 800 share = 0
  local WATER = { zone({ gravity = -800, airFriction = 4 }), body() }
  play.row("lets things float: half of a body in the water carries half as much", ONCE, WATER, {
    8,
    "body.y ~ 90, 0.05",
  })

  -- What attracts, in the middle, at a quarter of the way from there, and at the rim, where half of
  -- the body is inside.
  play.row("area.attract and area.law: {law}, at {share} of the radius", ONCE, function(v)
    local round = { x = -1000, y = -1000, radius = 1000, width = 2000, height = 2000 }
    local object = body({ x = -1000 * v.share - 0.5, y = -0.5, width = 1, height = 1 })
    return { gravity = 0, zone({ attract = -8, law = v.law }, round), object }
  end, { "run:step(1e-3)", "body.vx / 1e-3 ~ -8 * pull; body.vy ~ 0, 1e-12" }, {
    "law, share, pull",
    { "constant", 0.5, 1 },
    { "constant", 1, 0.5 },
    { "linear", 0.25, 0.25 },
    { "inverse", 0.5, 2 },
    { "inverse", 0.25, 4 },
    { "square", 0.25, 16 },
    { "square", 1, 0.5 },
  })

  -- A body that reaches 20 of its 30 px into a disc of 100 px, below and beside its middle.
  local DISC = zone({ ax = 1 }, { y = 0, width = 100, height = 100, radius = 50 })
  play.row(
    "area.ax acts by the share of a body in a disc: {width} x {height}",
    ONCE,
    function(v)
      return { gravity = 0, DISC, body(v) }
    end,
    { "run:step(1e-3)", "body.vx / 1e-3 ~ 2 / 3, 1e-6" },
    { "x, y, width, height", { 45, 80, 10, 30 }, { 80, 45, 30, 10 } }
  )

  local CALM = zone({ gravity = 0, attract = 4000, law = "square", airFriction = 20 }, ROUND)
  play.row("area.attract is calm in the centre", ONCE, { CALM, body({ y = 300 }) }, {
    4,
    "body at 190, 190, 1e-3",
  })

  local CEILING = scene.maker("walls", { kinematic = true, vx = 30 })("ceiling", 0, 100, 400, 20)
  play.row("area.gravity turns down: what it presses to a ceiling stands there", ONCE, {
    zone({ gravity = -800 }),
    CEILING,
    INSIDE,
  }, {
    1,
    "body.y == 120; body.touching.top == ceiling; x = body.x",
    { steps = 1 },
    "body.x ~ x + 0.5; body.vx == 0", -- it rides on it
  })

  local LAST = scene.thing("b", zone({ gravity = 20, ax = 6 })[2])({ name = "last" })
  local FIRST = scene.thing("a", zone({ gravity = 10, ax = 5 })[2])()
  local BOTH = { FIRST, LAST, INSIDE }
  play.row("area.gravity of the last one counts, others add up", ONCE, BOTH, {
    { "run:step(0.02)", "body.vy ~ 0.4, 1e-12; body.vx ~ 0.22, 1e-12" },
  })

  local LAKE = { gravity = 100, airFriction = 2 }
  play.row("goes on without a gap where zones are flush", ONCE, {
    zone(LAKE),
    zone(LAKE, { x = 400, name = "next" }),
    body({ x = 100, y = 200 }),
    body({ name = "between", x = 390, y = 200 }),
  }, { { steps = 20, "between.y ~ body.y" } })

  play.row("respects masks and active, and acts on nothing but dynamic objects", ONCE, {
    gravity = 0,
    masks = { zones = { ghosts = false } },
    zone({ ax = 60 }),
    scene.thing("ghosts", INSIDE[2])({ name = "ghost" }),
    body({ name = "shy", x = 10, y = 200, mask = { zones = false } }),
    body({ name = "lift", x = 40, y = 200, kinematic = true }),
    body({ name = "coin", x = 90, y = 200, sensor = true }),
  }, {
    { "run:step(0.02)", "ghost.vx == 0; shy.vx == 0; lift.raw.vx == nil; coin.vx ~ 1.2, 1e-12" },
    "zone.active = false; world:refresh(zone.raw); run:step(0.02); coin.vx ~ 1.2, 1e-12",
  })

  local FLOOR = scene.maker("tiles", { static = true })("floor", 0, 400, 400, 20)
  play.row("({kind}) wakes what rests in it", ONCE, function(v)
    local its = zone(
      { gravity = 100 },
      { static = v.kind == "static", [v.kind] = true, active = false }
    )
    return { its, FLOOR, body({ y = 380 }) }
  end, {
    { "run:play(1)", "world.stats.resting >= 1" },
    { "zone.active = true; world:refresh(zone.raw)", 1, "body.y == 380; world.stats.resting >= 1" },
    { "zone.raw.area.gravity = -100; world:refresh(zone.raw)", 1 / 6, "body.y < 380" },
    { "world:remove(zone.raw)", 1, "body.y == 380" },
    { "zone.raw.area.ax = 100; world:add('zones', zone.raw)", 1 / 6, "body.vx > 0" },
  }, { "kind", { "static" }, { "kinematic" } })

  it("acts on the rider of a train as on the ground that stands, seen from there", function()
    for _, rate in ipairs({ 30, 60, 144 }) do
      local ends = {}
      for n, speed in ipairs({ 120, 0 }) do
        local world = physics.newWorld({ gravity = 800 })
        local its = { x = 101, y = 0, width = 1000, height = 400, kinematic = true, sensor = true }
        its.vx, its.area = speed - 120, { ax = 600 }
        world:add("zones", its)
        local train = { x = -500, y = 400, width = 5000, height = 50, kinematic = true, vx = speed }
        world:add("trains", train)
        local rider = world:add("bodies", { x = 75, y = 380, width = 20, height = 20 })
        world:update(1 / rate)
        its.x, rider.x = 101, 75
        world:refresh(its)
        small.run(world, rate / 3, rate)
        ends[n] = rider.vx
      end
      assert.is_true(ends[2] > 50)
      assert.near(ends[2], ends[1], 1e-9)
    end
  end)

  -- A world with such a zone, and a body above it.
  local function newWorld(area)
    local world = physics.newWorld({ gravity = 800 })
    return world, world:add("zones", zone(area)[2]), world:add("bodies", body()[2])
  end

  it("is in states, and a restored world goes on with the same bits", function()
    local world, its, object = newWorld({ gravity = -500, ax = 3, law = "square", attract = 20 })
    small.run(world, 30)
    local saved, area, other = world:save(), its.area, physics.newWorld()
    other:restore(saved)
    assert.are.same(area, other.objects.zones[1].area)
    its.area = nil
    world:refresh(its)
    assert.is_true(world:hash() ~= other:hash())
    world:restore(saved)
    for _ = 1, 30 do
      world:update(DT)
      other:update(DT)
    end
    assert.same({ world:hash(), object.y }, { other:hash(), other.objects.bodies[1].y })
    saved.fields[2].area[1] = "wind"
    assert.is_false((pcall(other.restore, other, saved)))
  end)

  it("is where down is in a restored world at once, too, for a belt at its side", function()
    local world, _, object = newWorld({ gravity = 0, gravityX = 800 })
    local belt = { x = 350, y = 100, width = 20, height = 300, kinematic = true, surfaceSpeed = 30 }
    world:add("belts", belt)
    object.y = 120
    small.run(world, 120)
    local other = physics.newWorld()
    other:restore(world:save())
    assert.are.same({ 0, 30 }, { other:velocity(other.objects.bodies[1]) })
  end)

  it("is told by explain", function()
    local world, its, object = newWorld({ ax = 1 })
    local text = world:explain(object, its)
    assert.is_truthy(text:find("objects.zones[1] is a zone: its area acts", 1, true), text)
  end)

  it("makes no garbage", function()
    local world = newWorld({ gravity = -100, airFriction = 1, attract = 5 })
    local moving = { static = false, kinematic = true, vx = 1 }
    world:add("zones", zone({ ax = 3, drag = 4 }, moving)[2])
    local bytes = garbage.bytes(function()
      world:update(DT)
    end, 600, 100)
    assert.is_true(bytes <= 100, bytes)
  end)

  it("is refused where it is wrong, and nothing has changed", function()
    local world = physics.newWorld()
    for _, row in ipairs({
      { true, "zones[1].area must be a table { gravity = 100, … }, got true" },
      { { gravity = "1" }, 'zones[1].area.gravity must be a number, got "1"' },
      { { drag = -1 }, "zones[1].area.drag must be a number >= 0, got -1" },
      { { law = "cubic" }, '"inverse" or "square", got "cubic"' },
      { { gravty = 1 }, 'unknown entry "gravty" (did you mean "gravity"?)' },
      { { 1 }, "unknown entry 1; the entries are gravity, gravityX, ax" },
      { {}, "area must be nil unless the object is a sensor, got table", { sensor = false } },
    }) do
      small.refuses(row[2], world.add, world, "zones", zone(row[1], row[3])[2])
    end
    local its = world:add("zones", zone({ ax = 1 }, { static = false, kinematic = true })[2])
    world:update(DT)
    its.area.ax = "fast"
    assert.is_false((pcall(world.update, world, DT)))
    its.area.ax = 2
    world:update(DT)
  end)
end)
