-- The field `strength`: the stronger object pushes weaker ones, and is not moved by them.

local effort = require("spec.support.effort")
local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")

local DT = 1 / 60

-- Two boxes on a line along x (y if `isTurned`), `gap` px apart. Returns their velocities after a
-- second, and them.
local function meet(one, other, gap, isTurned)
  local world, objects = physics.newWorld({ gravity = 0 }), {}
  local along, speed = isTurned and "y" or "x", isTurned and "vy" or "vx"
  for n, fields in ipairs({ one, other }) do
    local object = { x = 0, y = 0, width = 10, height = 10 }
    object.mass, object.strength, object.restitution =
      fields.mass, fields.strength, fields.restitution
    object[along], object[speed] = n == 1 and 0 or 10 + gap, fields.v or 0
    objects[n] = world:add("boxes", object)
  end
  for _ = 1, 60 do
    world:update(DT)
  end
  return objects[1][speed], objects[2][speed], objects[1], objects[2]
end

describe("strength", function()
  for _, gap in ipairs({ 0, 20 }) do
    for _, row in ipairs({
      { "stands, and is run into", { strength = 1 }, { v = -60 }, 0, 0 },
      { "stands before ten times its mass", { strength = 1 }, { v = -60, mass = 10 }, 0, 0 },
      { "pushes a fifth of what stands", { v = 60, strength = 1 }, {}, 50, 50 },
      { "pushes a fifth of what comes towards it", { v = 60, strength = 1 }, { v = -90 }, 50, 50 },
      { "pushes a fifth of five times its mass", { v = 60, strength = 1 }, { mass = 5 }, 30, 30 },
      { "pushes what flees slowly", { v = 60, strength = 1 }, { v = 30 }, 55, 55 },
      { "flees, and is caught up", { v = 90 }, { v = 60, strength = 1 }, 60, 60 },
      { "is as strong", { v = 60, strength = 1 }, { v = -60, strength = 1 }, 0, 0 },
      { "is weaker than 0", { v = -0.0, strength = 0 }, { v = -60, strength = -1 }, 0, 0 },
    }) do
      it(("of one that %s, %d px apart"):format(row[1], gap), function()
        for _, isTurned in ipairs({ false, true }) do
          local one, other = meet(row[2], row[3], gap, isTurned)
          assert.near(row[4], one, 1e-9)
          assert.near(row[5], other, 1e-9)
          -- Mirrored.
          local a, b = { v = -(row[3].v or 0) }, { v = -(row[2].v or 0) }
          for _, name in ipairs({ "mass", "strength" }) do
            a[name], b[name] = row[3][name], row[2][name]
          end
          one, other = meet(a, b, gap, isTurned)
          assert.near(-row[5], one, 1e-9)
          assert.near(-row[4], other, 1e-9)
        end
      end)
    end
  end

  it("leaves no overlap when the two are put into each other: the weaker one leaves", function()
    local _, _, one, other = meet({ strength = 1 }, {}, -4)
    assert.equal(0, one.x)
    assert.near(10, other.x, 1e-6)
  end)

  it("lets the weaker one bounce", function()
    local one, other = meet({ strength = 2 }, { v = -60, restitution = 1 }, 20)
    assert.equal(0, one)
    assert.near(60, other, 1e-9)
  end)

  local strong = scene.maker("players", { strength = 1 })
  -- A ball above and to the left of another one, or of a box, at 45 degrees or so.
  play.row("holds where a ball meets a {what} slanted", play.ONCE, function(v)
    local one = strong("player", 0, 0, 20, 20, { radius = v.radius })
    local ball = scene.maker("enemies", { radius = 10, vx = -60, vy = -58 })("ball", 30, 29, 20, 20)
    return { gravity = 0, one, ball }
  end, {
    { "run:play(1); player at 0, 0; player still" },
    -- It pushes a fifth of the mass of what it runs into.
    "other = world:add('enemies', { x = 330, y = 14, radius = 10 })",
    { "player.x, player.y, player.vx = 300, 0, 100", 1, "player.vx + 0.2 * other.vx ~ 100, 1e-6" },
    "other.vx > 40; player.vx > 70",
  }, { "what, radius", { "box" }, { "ball", 10 } })

  play.row("does not let it through walls, nor what it pushes", play.ONCE, {
    gravity = 0,
    strong("player", 0, 0, 10, 10),
    scene.maker("crates", {})("crate", 20, 0, 10, 10),
    scene.maker("walls", { static = true })("wall", 50, 0, 10, 10),
  }, { { 1, keep = "player.vx = 300" }, "player.x ~ 30" })

  -- `count` enemies press to a player for some seconds, then it walks out for 2 s. Returns how far
  -- it was pushed about, and how far it got.
  local function walkOut(fields, count, seconds, soft)
    local world = physics.newWorld({ gravity = 0, soft = soft })
    local player = world:add("players", { x = 390, y = 290, width = 20, height = 20 })
    for name, value in pairs(fields) do
      player[name] = value
    end
    for n = 1, count do
      local y = n * (n % 2 == 1 and 61 or 41) % 580
      world:add("enemies", { x = n * 97 % 780, y = y, width = 16, height = 16 })
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

  for _, count in ipairs({ 40, 100 }) do
    it("keeps a player where it stands among " .. count .. ", and lets it walk out", function()
      local pushed, out = walkOut({ strength = 1, mass = 10 }, count, 8)
      assert.near(0, pushed, 0.5)
      assert.is_true(out > 120 and out < 299)
    end)
  end

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
    assert.equal(7, rows)
  end)
end)
