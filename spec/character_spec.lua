--- The character of a game: how fast it falls (`maxFallSpeed`), and `strength`: the stronger
--- pushes weaker ones, and is not moved by them. (`nudge`, `snap`: scenarios.)

local effort = require("spec.support.effort")
local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local small = require("spec.support.small")
local variants = require("spec.support.variants")

local DT = 1 / 60

local man = scene.thing("men", { name = "man", x = 0, y = 0, width = 8, height = 8 })
local lift = scene.maker("lifts", { kinematic = true })
local RATES = { rate = { 20, 60, 144, 240 }, turn = variants.TURNS, shift = { 0 } }

describe("maxFallSpeed", function()
  -- Up and down for 0.75 s, until it falls at 200 px/s; then evenly.
  local JUMPER = { man({ vy = -400, maxFallSpeed = 200 }) }
  play.row("limits the fall and not the jump, exactly, at every rate", RATES, JUMPER, {
    { 0.75, "man at 0, -400 * t + 400 * t * t, 1e-8", "man.vy ~ -400 + 800 * t, 1e-8" },
    { 1, "man at 0, -75 + 200 * t, 1e-8", "man.vy ~ 200, 1e-8" },
  })

  play.row("cuts a fall that is faster already, and counts along gravity", RATES, {
    man({ vy = 500, maxFallSpeed = 100 }),
    man({ name = "up", x = 40, vy = -500, maxFallSpeed = 100 }),
    man({ name = "across", x = 80, y = 80, vx = 500, maxFallSpeed = 100 }),
  }, {
    { steps = 1 },
    "man.vy == 100; up.vy ~ -500 + 800 / run.rate; across.vx == 500",
  })

  local GLIDER = { man({ ax = 300, maxFallSpeed = 300, maxSpeed = 500 }) }
  play.row("leaves to the other axis what maxSpeed allows, at every rate", RATES, GLIDER, {
    2,
    "man.vx ~ 400, 1e-9; man.vy ~ 300, 1e-9",
  })

  local RIDES = { lift("lift", 0, 8, 80, 8, { vy = 300 }), man({ maxFallSpeed = 50 }) }
  play.row("changes nothing of what stands, and rides on", RATES, RIDES, {
    { 1, "man.y ~ lift.y - 8", "man.vy == 0" },
  })
end)

-- Without gravity, along each axis and both ways.
local LEVELS = { turn = variants.TURNS, shift = { 0 }, push = { "both" } }

-- Two boxes on a line, `gap` px apart.
local function two(v)
  local boxes = scene.thing("boxes", { y = 0, width = 10, height = 10, vx = 0 })
  local one, other = boxes(v.one), boxes(v.other)
  one[2].name, one[2].x, other[2].name, other[2].x = "one", 0, "other", 10 + v.gap
  return { gravity = 0, one, other }
end

describe("strength", function()
  local ONE = { strength = 1 }
  local PUSHES = { vx = 60, strength = 1 }
  for _, gap in ipairs({ 0, 20 }) do
    play.row("of one that {what}, {gap} px apart", LEVELS, two, {
      1,
      "one.vx ~ vx, 1e-9; other.vx ~ vx, 1e-9",
    }, {
      "gap, what, one, other, vx",
      { gap, "stands, and is run into", ONE, { vx = -60 }, 0 },
      { gap, "stands before ten times its mass", ONE, { vx = -60, mass = 10 }, 0 },
      { gap, "pushes a fifth of what stands", PUSHES, {}, 50 },
      { gap, "pushes a fifth of what comes towards it", PUSHES, { vx = -90 }, 50 },
      { gap, "pushes a fifth of five times its mass", PUSHES, { mass = 5 }, 30 },
      { gap, "pushes what flees slowly", PUSHES, { vx = 30 }, 55 },
      { gap, "flees, and is caught up", { vx = 90 }, PUSHES, 60 },
      { gap, "is as strong", PUSHES, { vx = -60, strength = 1 }, 0 },
      { gap, "is weaker than 0", { strength = 0 }, { vx = -60, strength = -1 }, 0 },
    })
  end

  play.row(
    "leaves no overlap of two put into each other: the {what} leaves",
    LEVELS,
    two,
    { { "run:play(1); one.x == x; other.x ~ x + 10, 1e-6" } },
    {
      "what, gap, one, other, x",
      { "second, weaker one", -4, ONE, {}, 0 },
      { "first, weaker one", -4, {}, ONE, -4 },
    }
  )

  play.row("lets the weaker one bounce", LEVELS, two, {
    { "run:play(1); one.vx == 0; other.vx ~ 60, 1e-9" },
  }, { "gap, one, other", { 20, { strength = 2 }, { vx = -60, restitution = 1 } } })

  local strong = scene.maker("players", { strength = 1 })
  -- A ball above and to the left of another one, or of a box, at 45 degrees or so.
  play.row("holds where a ball meets a {what} slanted", play.ONCE, function(v)
    local one = strong("player", 0, 0, 20, 20, { radius = v.radius, mass = 2 })
    local ball = scene.maker("enemies", { radius = 10, vx = -60, vy = -58 })("ball", 30, 29, 20, 20)
    return { gravity = 0, one, ball }
  end, {
    { "run:play(1); player at 0, 0; player still" },
    -- It pushes a fifth of the mass of what it runs into.
    "other = world:add('enemies', { x = 330, y = 14, radius = 10, mass = 3 })",
    {
      "player.x, player.y, player.vx = 300, 0, 100",
      1,
      "2 * player.vx + 0.2 * 3 * other.vx ~ 200, 1e-6",
    },
    "other.vx > 39; player.vx > 70",
  }, { "what, radius", { "box" }, { "ball", 10 } })

  play.row("does not let it through walls, nor what it pushes", play.ONCE, {
    gravity = 0,
    strong("player", 0, 0, 10, 10),
    scene.maker("crates", {})("crate", 20, 0, 10, 10),
    scene.maker("walls", { static = true })("wall", 50, 0, 10, 10),
  }, { { 1, keep = "player.vx = 300" }, "player.x ~ 30" })

  -- `count` enemies of 20 px press to a player of 28 px for a while; then it walks out for 2 s.
  -- Returns how far it was pushed about, and how far it got. Every so many (`every`) are circles.
  local function walkOut(fields, count, seconds, soft, every)
    local world = physics.newWorld({ gravity = 0, soft = soft })
    local player = world:add("players", small.put(390, 290, 28, 28, fields))
    for n = 1, count do
      local y = n * (n % 2 == 1 and 61 or 41) % 580
      local enemy = world:add("enemies", { x = n * 97 % 780, y = y, width = 20, height = 20 })
      enemy.radius = every and n % every == 0 and 10 or nil
    end
    local function step(vx)
      for _, enemy in ipairs(world.objects.enemies) do
        local dx, dy = player.x - enemy.x, player.y - enemy.y
        local distance = math.max(1, math.sqrt(dx * dx + dy * dy))
        enemy.vx, enemy.vy = 75 * dx / distance, 75 * dy / distance
      end
      player.vx, player.vy = vx, 0
      world:update(DT)
    end
    local pushed = 0
    for _ = 1, seconds * 60 do
      step(0)
      local dx, dy = player.x - 390, player.y - 290
      pushed = math.max(pushed, math.sqrt(dx * dx + dy * dy))
    end
    local x = player.x
    for _ = 1, 120 do
      step(150)
    end
    return pushed, player.x - x
  end

  small.rows("keeps a player in its place among {1}, and lets it out", { 40, 100 }, function(count)
    local pushed, out = walkOut({ strength = 1, mass = 10 }, count, 3)
    assert.near(0, pushed, 0.5)
    assert.is_true(out > 120 and out < 299)
  end)

  -- (It stood in each step in which the rounds ran out: 23 px in 2 s.)
  small.rows("lets it walk out of a crowd, one of {1} a circle", { 1, 2 }, function(every)
    local _, out = walkOut({ strength = 1, mass = 10 }, 36, 3, nil, every)
    assert.is_true(out > 260, out)
  end)

  -- The table of docs/topdown.md. (10 px: how the crowd lies changes with every version.)
  it("gets as far through a crowd as the page says #slow", function()
    local file = assert(io.open("docs/topdown.md"))
    local text, rows = file:read("*a"), 0
    file:close()
    local ROW = "\n| ([^|]*`[^|]+`[^|]*) | (%d+) px | (-?%d+) px[^|]* | (%d+) px |"
    for setting, pushed, out, softOut in text:gmatch(ROW) do
      local fields = {
        mass = tonumber(setting:match("mass = (%d+)")),
        strength = tonumber(setting:match("strength = (%d+)")),
      }
      if setting:find("pushable = false", 1, true) then
        fields.pushable = false
      end
      rows = rows + 1
      if effort.plays(rows, 3) then
        local itsPushed, itsOut = walkOut(fields, 100, 10)
        assert.near(tonumber(pushed), itsPushed, 10)
        assert.near(tonumber(out), itsOut, 10)
        local _, soft = walkOut(fields, 100, 10, { enemies = { enemies = 350 } })
        assert.near(tonumber(softOut), soft, 10)
      end
    end
    assert.equal(5, rows)
  end)
end)
