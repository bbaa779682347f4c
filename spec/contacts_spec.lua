--- The contacts of an object: the field `touching`, what bounces, and what friction lifts. (More of
--- friction is in contacts_friction_spec.lua; overlaps and crushing are scenarios.)

local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local small = require("spec.support.small")
local variants = require("spec.support.variants")

local newBox, update = small.box, small.run

local DT = 1 / 60

local box = scene.thing("boxes", { name = "box", x = 0, y = 84, width = 16, height = 16 })
local solid = scene.maker("tiles", { static = true })
local FLOOR = solid("floor", -200, 100, 800, 16)

local body = scene.maker("bodies")

local function row(title, entries, given, rows)
  play.row(title, play.ONCE, entries, given, rows)
end

describe("touching", function()
  local NONE = { top = false, bottom = false, left = false, right = false }

  it("is there at once with add, at the first update with plain Lua, also of dt 0", function()
    local world = physics.newWorld()
    local first, other = world:add("boxes", newBox(0, 0)), newBox(40, 0)
    local touching = first.touching
    assert.same(NONE, touching)
    table.insert(world.objects.boxes, other)
    world:update(0)
    assert.same(NONE, other.touching)
    world:update(DT)
    assert.equal(touching, first.touching)
  end)

  row("belongs to dynamic objects only", { FLOOR, box({ kinematic = true }) }, {
    { steps = 2 },
    "floor.raw.touching == nil; box.raw.touching == nil",
  })

  local FRESH = { rest = false, FLOOR, box() }
  row("comes back when the game replaces it, or the object changes its kind", FRESH, {
    { steps = 3 },
    { "first = box.raw.touching", "box.raw.touching = {}", { steps = 1 } },
    { "box.raw.touching == first", "first.bottom == floor.raw" },
    { "box.kinematic = true", { steps = 1 }, "first.bottom == false" },
    { "box.kinematic = nil", { steps = 2 }, "box.touching.bottom == floor" },
    { "box.active = false", { steps = 1 }, "box.touching.bottom == false" },
    { "box.active = nil", { steps = 2 }, "box.touching.bottom == floor" },
  })

  local PAIR = { FLOOR, box(), box({ name = "rider", y = 68 }) }
  row("is there when it was of another kind for no step", PAIR, {
    { steps = 3 },
    { "rider.kinematic = true", "world:update(0)", "rider.kinematic = nil", { steps = 1 } },
    "rider.touching.bottom == box",
  })

  local TWO = { solid("narrow", 0, 100, 6, 8), solid("wide", 6, 100, 40, 8), box() }
  row("is the neighbour with the widest common edge, the first of equals: {which}", TWO, {
    { steps = 1 },
    { "box.x = x", { steps = 2 }, "box.touching.bottom.name == which" },
  }, { "x, which", { 0, "wide" }, { -2, "wide" }, { -4, "narrow" } }) -- 6 px each
end)

--   #####     hit, and left again in the same step
--    +-+ ^
-- `touching.top` was false in each update of each jump.
describe("touching: a side that was hit and left again", function()
  small.rows("shows for one update: {1}", { 60, 30, 144, 20 }, function(rate)
    for _, rest in ipairs({ true, false }) do
      local world = physics.newWorld({ gravity = 800, rest = rest })
      world:add("tiles", { x = 0, y = 100, width = 100, height = 16, static = true })
      local ceiling = { x = 0, y = 40, width = 100, height = 16, static = true }
      world:add("tiles", ceiling)
      local man = world:add("men", { x = 10, y = 80, width = 10, height = 20 })
      local hits, shown, before = 0, 0, 0
      function man.onBegin(_, _, side)
        hits = hits + (side == "top" and 1 or 0)
      end
      for _ = 1, 3 do
        world:update(1 / rate)
        man.vy = -400
        update(world, rate, rate, function()
          assert.equal(hits > before and ceiling or false, man.touching.top)
          shown, before = shown + (man.touching.top and 1 or 0), hits
        end)
      end
      assert.same({ 3, 3 }, { hits, shown })
    end
  end)

  it("shows on both that bounce, and the wider of two", function()
    local world = physics.newWorld({ gravity = 0 })
    local narrow = world:add("boxes", { x = 0, y = 0, width = 20, height = 20, vx = 100 })
    narrow.restitution = 1
    local first = world:add("walls", { x = 20.5, y = -20, width = 8, height = 25, static = true })
    local second = world:add("walls", { x = 20.5, y = 5, width = 8, height = 25, static = true })
    world:update(1 / 60)
    assert.equal(second, narrow.touching.right)
    assert.is_nil(first.touching)
    world:update(1 / 60)
    assert.is_false(narrow.touching.right)
    local other = world:add("boxes", { x = narrow.x - 21, y = 0, width = 20, height = 20 })
    world:update(1 / 60)
    assert.equal(other, narrow.touching.left)
    assert.equal(narrow, other.touching.right)
    world:update(1 / 60)
    assert.same({ false, false }, { narrow.touching.left, other.touching.right })
  end)

  it("carries nothing and is no ground: a bounce on a lift takes no ride", function()
    local world = physics.newWorld({ gravity = 800 })
    local lift = { x = 0, y = 100, width = 60, height = 8, kinematic = true, vx = 200 }
    world:add("lifts", lift)
    local ball = world:add("balls", { x = 0, y = 60, width = 8, height = 8, restitution = 1 })
    update(world, 40, 60, function()
      assert.equal(0, ball.x)
    end)
  end)

  it("is not remembered of what has left, or of another that took its place", function()
    local world = physics.newWorld({ gravity = 0 })
    local ball = { x = 0, y = 0, width = 8, height = 8, vx = 600, restitution = 1 }
    world:add("balls", ball)
    local wall = world:add("walls", { x = 9, y = 0, width = 8, height = 8, static = true })
    function ball.onBegin(_, other)
      world:remove(other)
      world:add("walls", { x = 900, y = 0, width = 8, height = 8, static = true })
    end
    world:update(1 / 10) -- four steps
    assert.is_false(ball.touching.right)
    assert.is_nil(wall.touching)
  end)
end)

--   [4] ->  .  [4]     some ten bounces, within a step or in a few
-- Less than half of the energy was left after one step.
describe("restitution: a row of different masses", function()
  local LEVELS = { rate = variants.RATES, turn = { 0, 2 }, order = { "forward", "backward" } }

  -- Masses, px between them, restitution, the least part of the energy that is left, and how fast
  -- the first one is in the end. (Of rows of which light ones are hit from both sides
  -- the rounds of a step end first, see docs/reliability.md: up to what is left with all at one
  -- speed is lost.)
  local LIGHT, ALIKE = { 4, 0.1, 4 }, { 1, 1, 1, 1, 1 }
  for _, given in ipairs({
    { LIGHT, 0, 1, 1, -4.7 },
    { LIGHT, 5, 1, 1, -4.7 },
    { ALIKE, 0, 1, 1, 0 },
    { { 4, 1, 4 }, 2, 1, 1 },
    { { 1, 4, 0.1 }, 2, 1, 1 },
    { { 4, 0.1, 4, 0.1, 4 }, 2, 1, 0.86 },
    { { 10, 1, 0.1, 1, 10 }, 0.5, 1, 0.6 },
    { { 100, 1, 100 }, 0.5, 1, 1 },
    { { 1, 0.01, 1, 0.01, 1 }, 0.5, 1, 0.49 },
    { { 10, 1, 0.1, 1, 10 }, 0.5, 0.9, 0 },
    { { 1, 0.01, 1, 0.01, 1 }, 0.5, 0.9, 0 },
  }) do
    local masses, gap, restitution, least, first = small.unpack(given, 1, 5)
    local title = "%s, %g px apart, restitution %g: keeps momentum and energy"
    scene.it(title:format(table.concat(masses, ", "), gap, restitution), LEVELS, function(run)
      local description, energy = { gravity = 0 }, masses[1] * 400 * 400
      for i, mass in ipairs(masses) do
        local fields = { mass = mass, restitution = restitution, vx = i == 1 and 400 or 0 }
        description[i] = body("ball" .. i, (16 + gap) * (i - 1), 0, 16, 16, fields)
      end
      local named, before = run:build(description), energy
      for _ in run:steps(0.5) do
        local now, momentum = 0, 0
        for i, mass in ipairs(masses) do
          local one, beside = named["ball" .. i], named["ball" .. i - 1]
          now, momentum = now + mass * one.vx ^ 2, momentum + mass * one.vx
          run:check(not beside or one.x >= beside.x + 16 - 1e-6, "%d passed the one before", i)
        end
        run:near("the momentum", momentum, masses[1] * 400, 1e-9 * masses[1] * 400)
        run:check(now <= before * (1 + 1e-9), "energy grew from %.17g to %.17g", before, now)
        run:check(now >= energy * (least - 1e-9), "%.3g of the energy is left", now / energy)
        before = now
      end
      run:near("vx of the first", named.ball1.vx, first or named.ball1.vx, 0.1)
    end)
  end
end)

describe("friction: a box that leans on a lift that rises", function()
  --    +--+----+ ^ 50
  --  > |  |    |      friction lifts with half of what it leans with,
  --    +--+    |      its weight is 600
  --   ====|    |
  local GROUND = scene.maker("floors", { static = true, friction = 0 })("floor", -100, 100, 120, 4)
  local LIFT = scene.maker("lifts", { kinematic = true, vy = -50 })("lift", 20, 60, 20, 400)
  local LEVELS = { rate = { 30, 144 }, shift = { 0 } }
  play.row("with {ax} px/s² {what}", LEVELS, function(v)
    local crate = scene.maker("boxes", { friction = 0.5, ax = v.ax })("box", 0, 80, 20, 20)
    return { gravity = 600, GROUND, LIFT, crate }
  end, { 1, "box.x == 0; box.y ~ 80 - way, 1e-9" }, {
    "ax, what, way",
    { 300, "stays on the floor", 0 },
    { 1100, "stays on the floor", 0 },
    { 1300, "is lifted by the difference, 50 px/s²", 25 },
    { 3000, "is as fast as the lift after 50 / 900 s", 50 - 50 * 50 / 900 / 2 },
  })
end)
