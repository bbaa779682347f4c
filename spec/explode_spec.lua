--- world:explode: what is pushed, how far, and what is in the way.

local physics = require("physics")
local play = require("spec.support.play")

local function still()
  return physics.newWorld({ gravity = 0 })
end

local function crate(x, y, changes)
  local object = { name = "it", x = x, y = y, width = 20, height = 20 }
  for name, value in pairs(changes or {}) do
    object[name] = value
  end
  return object
end

describe("world:explode", function()
  -- A crate of 20 px, an explosion at (0, 0) of 100 px and 600.
  play.row("pushes away: {what}", play.ONCE, function(v)
    return { gravity = 0, { "crates", crate(v.x, v.y, v.fields) } }
  end, {
    "list, count = world:explode(0, 0, 100, 600); count == 1; list[1] == it.raw",
    "it.vx ~ vx; it.vy ~ vy",
  }, {
    "what, x, y, fields, vx, vy",
    { "to the right", 30, -10, {}, 420, 0 },
    { "its mass counts", 30, -10, { mass = 2 }, 210, 0 },
    { "what it had is kept", 30, -10, { vx = -20, vy = 7 }, 400, 7 },
    { "around the centre", -5, -10, {}, 600, 0 },
    { "in the centre: up", -10, -10, {}, 0, -600 },
    { "nearly at the rim", 99, -10, {}, 6, 0 },
    -- The nearest corner is 50 px away, the middle at (40, 50) of 64 px.
    { "askew", 30, 40, {}, 300 * 40 / math.sqrt(4100), 300 * 50 / math.sqrt(4100) },
    -- A circle: its middle is 50 px away, its rim 40 px.
    { "a circle", 20, 30, { radius = 10, sensor = true }, 360 * 0.6, 360 * 0.8 },
  })

  play.row("leaves alone: {what}", play.ONCE, function(v)
    return { gravity = 0, { "crates", crate(v.x, v.y, v.fields) } }
  end, {
    "list, count = world:explode(0, 0, 100, 600); count == 0; list[1] == nil",
    "it.vx == 0; it.vy == 0",
  }, {
    "what, x, y, fields",
    { "beyond the rim", 100, -10, {} },
    { "beyond the rim, in its square", 80, 80, {} },
    { "what is inactive", 30, -10, { active = false } },
    { "what is static", 30, -10, { static = true } },
    { "what is kinematic", 30, -10, { kinematic = true } },
  })

  play.row("draws in with a negative impulse, and wakes what rests", play.ONCE, {
    gravity = 0,
    { "crates", crate(30, -10) },
  }, { { "run:play(1 / 30); world:explode(0, 0, 100, -100)", 1 / 60, "it.x < 30" } })

  it("pushes those that the filter names, and are in sight", function()
    local world = still()
    local shown, hidden = world:add("crates", crate(-60, -10)), world:add("crates", crate(60, -10))
    local gem = world:add("gems", crate(-60, 20))
    local wall = world:add("walls", crate(30, -50, { height = 100, static = true }))
    local function pushed(...)
      local list, count = world:explode(0, 0, 100, 10, ...)
      assert.are.equal(count, #list)
      return list
    end
    assert.are.same({ shown, hidden, gem }, pushed())
    assert.are.same({ shown, hidden }, pushed("crates"))
    assert.are.same({ shown }, pushed("crates", "walls"))
    -- A crate does not hide itself.
    assert.are.same({ shown, gem }, pushed(nil, { "walls", "crates" }))
    assert.are.same(
      { gem },
      pushed("gems", function(object)
        return object == wall
      end)
    )
  end)

  -- (Wrong numbers are in debugging_bad_input_spec.)
  it("is refused where something is wrong, and has changed nothing", function()
    local world = still()
    local one, other = world:add("crates", crate(30, -10)), world:add("crates", crate(30, -40))
    for _, row in ipairs({
      { "walls: filter must be a group name", 1, 1, true },
      { "after it must be a number in", 1e-99, 1e50 },
      { 'mass must be a number > 0, got "heavy"', "heavy", 1 },
    }) do
      other.mass = row[2]
      local ok, message = pcall(world.explode, world, 0, 0, 100, row[3], nil, row[4])
      assert.is_false(ok)
      assert.matches("explode_spec.lua", message)
      assert.is_truthy(message:find(row[1], 1, true), message)
      assert.are.same({ 0, 0 }, { one.vx, one.vy })
    end
    other.mass, other.vx = 1, nil
    world:explode(0, 0, 100, 1)
    assert.is_true(one.vx > 0 and other.vx > 0)
  end)
end)
