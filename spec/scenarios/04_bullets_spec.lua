--- Nothing is too fast.

local costOf = require("spec.support.instructions")
local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE = variants.EVERYWHERE
local BOTH = { push = { "both" }, turn = variants.TURNS }
local row = play.row
local solid = scene.maker("walls", { static = true })
local bullet =
  scene.thing("bullets", { name = "bullet", x = 0, y = 48, width = 4, height = 4, vx = 6000 })

describe("vx and onBegin: bullets", function()
  --   +-+ vx = 6000     ||
  --   +-+ ->            ||  2 px
  --   o                500     100 px a step (at 60 Hz)
  it("(4) stop at a thin wall, or bounce at the right moment, from 100 distances", function()
    scene.each({ turn = variants.TURNS }, function(run)
      for o = 0, 99 do
        local restitution = o % 9 == 0 and 1 or 0
        local shot = bullet({ x = o, restitution = restitution })
        local named = run:build({ gravity = 0, solid("wall", 500, 0, 2, 100), shot })
        local log = run:listen(named.bullet)
        run:play(1 / 6)
        -- 1000 px of way: (496 - o) there, the rest back
        run:at(named.bullet, 496 - restitution * (504 + o), 48)
        run:near("vx", named.bullet.vx, -6000 * restitution)
        run:same("begins", log.begins, 1)
        run:same("begins on the right", log.sides.right, 1)
        run:same("ends", log.ends, restitution)
        run:near("speed", log.speed, 6000)
      end
    end)
  end)

  --   +-+ 90 000 px/s                       |
  --   +-+ ->                                | 1 px
  --   0                                    5000
  local FAST = { gravity = 0, solid("wall", 5000, 0, 1, 100), bullet({ vx = 90000 }) }
  row("of 90 000 px/s stop flush at a wall of 1 px", EVERYWHERE, FAST, {
    1 / 6,
    "bullet at 4996, 48; bullet still; bullet touches right",
  })

  --   +-+ ->                    <- +-+
  --   +-+  6000           -6000    +-+
  --   0                            100
  local function headOn(v)
    local fields = { x = 100, vx = -6000, restitution = v.restitution, name = "other" }
    return { gravity = 0, bullet({ restitution = v.restitution }), bullet(fields) }
  end
  row("head-on (4) meet in the middle of the step, restitution {restitution}", BOTH, headOn, {
    "listen bullet; run:step(1 / 60)",
    "bullet at a, 48; other at b, 48; bullet.vx ~ -vx; other.vx ~ vx",
    "heard.bullet.begins == 1; heard.bullet.speed ~ 12000",
  }, { "restitution, a, b, vx", { 0, 48, 52, 0 }, { 1, -4, 104, 6000 } })

  local FIRST = { push = { "first" }, turn = variants.TURNS, rate = variants.RATES }
  row("head-on do not pass each other with push first either", FIRST, headOn, {
    { 1 / 6, "other.x - bullet.x >= 4 - 1e-6" },
    "other.x - bullet.x ~ 4; bullet.vx ~ 0; other.vx ~ 0",
  }, { "restitution", { 0 } })

  --         +-+ B, 6000 px/s down
  --         +-+
  --          v
  --   +-+
  --   +-+ -> A, 6000 px/s          paths cross: B comes down on A at 0.45 of the step
  local box = scene.maker("boxes", {})
  local CROSS = { gravity = 0, box("a", 0, 100, 10, 10), box("b", 50, 45, 10, 10) }
  CROSS[1][2].vx, CROSS[2][2].vy = 6000, 6000
  -- both go on at 3000 px/s down for 0.55 steps of 50 px; nothing rubs, so A keeps its 6000
  row("that cross at a right angle meet", BOTH, CROSS, {
    "listen a; listen b; run:step(1 / 60)",
    "a at 100, 127.5; b at 50, 117.5; a.vx ~ 6000; a.vy ~ 3000; b.vx ~ 0; b.vy ~ 3000",
    "heard.a.sides.top == 1; heard.b.sides.bottom == 1",
    "run:step(1 / 60); a heard 1, 1; b heard 1, 1",
  })

  --   +-+ ->   ||  a sensor 2 px wide
  --   +-+      ||
  local SENSOR = scene.maker("sensors", { sensor = true, static = true })("sensor", 50, 0, 2, 100)
  row("(4) are seen by a sensor crossed in a step", EVERYWHERE, { gravity = 0, SENSOR, bullet() }, {
    "listen bullet; listen sensor; log = run:listenToWorld()",
    { 1 / 6, "bullet at 6000 * t, 48", "bullet.vx == 6000", "bullet touches" },
    "sensor heard 1, 1; bullet heard 1, 1; log.begins == 1; log.ends == 1",
  })
end)

--   \ | /
--   -  o  -      200 bullets from one place, at one speed; nothing is there to be hit
--   / | \
it("hits: bullets added together never have their neighbours looked up all in one step", function()
  local world, costs = physics.newWorld({ gravity = 0 }), {}
  for i = 1, 200 do
    local shot = { x = 0, y = 0, width = 6, height = 6, sensor = true, hits = { "players" } }
    shot.vx, shot.vy = math.sin(i) * 150, math.cos(i) * 150
    world:add("bullets", shot)
  end
  for n = -39, 100 do
    costs[n] = costOf(function()
      world:update(1 / 60)
    end)
  end
  table.sort(costs)
  assert(costs[100] <= 2 * costs[50], ("%g times the median"):format(costs[100] / costs[50]))
end)
