--- The other files of examples/kit: lift, enemy, crumble, checkpoint and bullet.

local bullet = require("examples.kit.bullet")
local checkpoint = require("examples.kit.checkpoint")
local crumble = require("examples.kit.crumble")
local enemy = require("examples.kit.enemy")
local kit = require("spec.support.kit")
local lift = require("examples.kit.lift")
local small = require("spec.support.small")

local DT = 1 / 60

-- Plays frames, and again from the state in the middle: both must end with the same hash.
local function playTwice(world, frames, each)
  kit.play(world, frames, each)
  local state = world:save()
  kit.play(world, frames, each)
  local hash = world:hash()
  world:restore(state)
  kit.play(world, frames, each)
  assert.equal(hash, world:hash())
end

describe("examples/kit/lift.lua: a lift", function()
  local function newLift(points, settings, objects, fields)
    local world = kit.world(objects, { "lift" })
    local platform = { x = 40, y = 300, width = 80, height = 16, kinematic = true }
    small.set(platform, fields)
    world:add("lifts", platform)
    platform.lift = lift.new(platform, points, settings)
    local seen = { crushed = 0, places = {} }
    local function each()
      lift.update(world, platform, DT)
      seen.places[("%.0f %.0f"):format(platform.x, platform.y)] = true
    end
    return world, platform, each, seen
  end
  local function rider(world, x, y)
    local object = { x = x, y = y, width = 20, height = 40 }
    object.onCrush = function()
      object.crushes = (object.crushes or 0) + 1
    end
    return world:add("riders", object)
  end

  it("goes through all points, there and back, with its riders", function()
    local world, platform, each, seen = newLift({ { 5, 5 }, { 105, 5 }, { 105, -95 } })
    local object = rider(world, 60, 260)
    kit.play(world, 2, each)
    local along = object.x - platform.x
    kit.play(world, 400, function()
      assert.near(platform.y - 40, object.y, 1e-9)
      assert.near(along, object.x - platform.x, 1e-9)
      each()
    end)
    for _, place in ipairs({ "40 300", "140 300", "140 200" }) do
      assert.is_true(seen.places[place], place)
    end
    assert.is_nil(seen.places["40 200"])
  end)

  it("waits at the ends", function()
    local world, platform, each = newLift({ { 0, 0 }, { 80, 0 } }, { wait = 0.5 })
    kit.play(world, 60, each)
    assert.equal(120, platform.x)
    kit.play(world, 29, each)
    assert.equal(120, platform.x)
    kit.play(world, 61, each)
    assert.near(40, platform.x, 2)
  end)

  it("turns at walls", function()
    local wall = { "walls", 200, 200, 20, 200 }
    local world, platform, each = newLift({ { 0, 0 }, { 400, 0 } }, { wait = 0 }, { wall })
    local most = 0
    playTwice(world, 120, function()
      each()
      most = math.max(most, platform.x)
    end)
    assert.is_true(most > 118 and most <= 120, most)
    assert.is_true(platform.x < 120)
  end)

  it("stops before it crushes, also through crates, and goes on when there is room", function()
    local ceiling = { "walls", 0, 150, 200, 20 }
    local crate = { "crates", 60, 276, 24, 24, {} }
    local world, platform, each = newLift({ { 0, 0 }, { 0, -200 } }, {}, { ceiling, crate })
    local object = rider(world, 60, 236)
    kit.play(world, 120, each)
    assert.near(170 + 40 + 24, platform.y, 1.4)
    assert.is_nil(object.crushes)
    object.x = 300
    kit.play(world, 90, each)
    assert.near(170 + 24, platform.y, 1.4)
  end)

  it("sinks onto the ground beside a player, not stopped by one below a one-way lift", function()
    local oneWay = { oneWay = "top" }
    local world, platform, each = newLift({ { 0, 0 }, { 0, 84 } }, {}, {}, oneWay)
    rider(world, 60, 360)
    kit.play(world, 70, each)
    assert.equal(384, platform.y)
    world, platform, each = newLift({ { 0, 0 }, { 0, 84 } })
    rider(world, 60, 360)
    kit.play(world, 70, each)
    assert.near(344, platform.y, 1.4) -- above its head
  end)
end)

describe("examples/kit/enemy.lua: an enemy", function()
  local LEDGE = { "walls", 100, 300, 200, 20 }

  -- An enemy that stands at x 200 on a ledge from x 100 to 300.
  local function newEnemy(settings, objects, player)
    local world = kit.world(objects or { LEDGE }, { "enemy" })
    local body = { x = 200, y = 270, width = 20, height = 30, enemy = enemy.new(settings) }
    world:add("enemies", body)
    player = player and world:add("players", player)
    local seen = { least = 1000, most = 0, turns = 0, sees = false }
    local direction = body.enemy.direction
    local function each()
      seen.sees = enemy.update(world, body, DT, player)
      seen.least, seen.most = math.min(seen.least, body.x), math.max(seen.most, body.x)
      if body.enemy.direction ~= direction then
        direction, seen.turns = body.enemy.direction, seen.turns + 1
      end
    end
    return world, body, seen, each
  end

  it("walks to and fro on a ledge, and never falls", function()
    local world, body, seen, each = newEnemy({})
    playTwice(world, 400, each)
    assert.equal(270, body.y)
    assert.is_true(seen.least > 98 and seen.least < 101 and seen.most > 279 and seen.most < 282)
    assert.is_true(seen.turns >= 4)
  end)

  it("turns at walls, and at others of its kind", function()
    local walls = { LEDGE, { "walls", 130, 200, 20, 100 }, { "enemies", 260, 270, 20, 30, {} } }
    local world, _, seen, each = newEnemy({}, walls)
    kit.play(world, 300, each)
    assert.near(150, seen.least, 1e-6)
    assert.near(240, seen.most, 1) -- (a step long it pushes)
  end)

  it("walks over slopes", function()
    local slopes = {
      { "walls", 140, 380, 40, 20, { static = true, slope = "right" } },
      { "walls", 180, 380, 40, 20, { static = true } },
      { "walls", 220, 360, 40, 40, { static = true } },
    }
    local world, body, seen, each = newEnemy({}, slopes)
    body.x, body.y = 190, 350
    kit.play(world, 180, each)
    assert.equal(370, body.y)
    assert.is_true(seen.least < 60)
  end)

  it("does not tremble in a pit of its own width", function()
    local pit = { { "walls", 180, 300, 20, 100 }, { "walls", 221, 300, 20, 100 } }
    local world, body, seen, each = newEnemy({}, pit)
    body.x, body.y = 200, 370
    kit.play(world, 120, each)
    assert.is_true(seen.turns >= 2 and seen.turns <= 10, seen.turns)
  end)

  -- what, settings, where the player is, another wall, is it seen
  local GAS = { "gas", 160, 200, 10, 100, { static = true, sensor = true } }
  local SIGHTS = {
    { "in front", {}, { 120, 270 }, nil, true },
    { "behind it", {}, { 280, 270 }, nil, false },
    { "behind it, if it looks there, too", { behind = true }, { 280, 270 }, nil, true },
    { "too far away", { sight = 60 }, { 120, 270 }, nil, false },
    { "behind a wall", {}, { 120, 270 }, { "walls", 160, 200, 10, 100 }, false },
    { "behind a sensor", {}, { 120, 270 }, GAS, true },
    { "below the floor", {}, { 150, 340 }, nil, false },
  }
  small.rows("looks at a player {1}", SIGHTS, function(_, settings, at, wall, isSeen)
    local player = { x = at[1], y = at[2], width = 20, height = 30, gravity = 0 }
    local world, _, seen, each = newEnemy(settings, { LEDGE, wall }, player)
    kit.play(world, 1, each)
    assert.equal(isSeen, seen.sees)
  end)

  it("chases a player up to the edge, and for a while when it is hidden", function()
    local player = { x = 30, y = 270, width = 20, height = 30, gravity = 0, pushable = false }
    local world, body, seen, each = newEnemy({ chase = 120 }, nil, player)
    kit.play(world, 20, each)
    assert.equal(-120, body.vx)
    kit.play(world, 100, each)
    assert.equal(0, body.vx)
    assert.is_true(body.x > 76 and body.y == 270 and seen.turns == 0)
    world.objects.players[1].active = false
    kit.play(world, 90, each)
    assert.equal(60, body.vx)
  end)
end)

describe("examples/kit/crumble.lua: a floor", function()
  local function newFloor(settings)
    local world = kit.world(nil, { "crumble" })
    local tile = { x = 80, y = 300, width = 60, height = 16, static = true }
    tile.crumble, tile.onBegin = crumble.new(settings), crumble.onBegin
    world:add("crumbling", tile)
    local player = world:add("players", { x = 100, y = 240, width = 20, height = 40 })
    return world, tile, player, function()
      crumble.update(world, tile, DT)
    end
  end

  it("goes a moment after the landing, and comes back", function()
    local world, tile, player, each = newFloor({ after = 0.5, back = 1 })
    kit.play(world, 40, each)
    assert.equal(260, player.y)
    kit.play(world, 30, each)
    assert.is_false(tile.active)
    assert.is_true(player.y > 260)
    kit.play(world, 60, each)
    assert.is_true(tile.active)
    player.x, player.y, player.vy = 100, 200, 0
    kit.play(world, 20, each)
    assert.equal(260, player.y)
  end)

  it("waits until its place is free, and a saved state knows when", function()
    local world, tile, player, each = newFloor({ after = 0.1, back = 0.2 })
    kit.play(world, 20, each)
    player.x, player.y, player.gravity, player.vy = 100, 290, 0, 0
    playTwice(world, 30, each)
    assert.is_false(tile.active)
    player.x = 300
    kit.play(world, 2, each)
    assert.is_true(tile.active)
  end)
end)

describe("examples/kit/checkpoint.lua: a player", function()
  local function newGame(objects)
    local world = kit.world(objects, { "checkpoint" })
    local player = { x = 100, y = 360, width = 20, height = 40, maxFallSpeed = 500 }
    world:add("players", player)
    player.checkpoint = checkpoint.new(player)
    local back = 0
    local function each()
      back = back + (checkpoint.update(world, player, DT) and 1 or 0)
      return back
    end
    return world, player, each
  end

  it("dies once, and comes back at the checkpoint with its fields", function()
    local world, player, each = newGame()
    checkpoint.reach(player, 200, 300)
    player.gravity, player.maxFallSpeed, player.mask = 0, 60, { tiles = false }
    player.height, player.vx = 20, 100
    assert.same({ true, false }, { checkpoint.die(player), checkpoint.die(player) })
    kit.play(world, 40, each)
    assert.is_false(player.active)
    kit.play(world, 9, each)
    assert.equal(1, each())
    assert.same({ 200, 40, 500 }, { player.x, player.height, player.maxFallSpeed })
    assert.equal(1, player.checkpoint.deaths)
    assert.is_nil(player.gravity or player.mask)
    kit.play(world, 60, each)
    assert.same({ 360, 1 }, { player.y, each() })
  end)

  it("comes back at the nearest free place", function()
    local world, player, each = newGame({ { "crates", 190, 350, 50, 50, {} } })
    checkpoint.reach(player, 200, 360)
    checkpoint.die(player)
    repeat
      world:update(DT)
    until each() == 1
    assert.is_true(world:fits(player.x, player.y, 20, 40, player))
    assert.is_true(math.abs(player.x - 200) <= 40 and math.abs(player.y - 360) <= 80)
  end)

  it("is in the text of a world, to the bit", function()
    local world, player, each = newGame()
    player.vx, player.y, player.vy = 1 / 3, 200, -0.1
    checkpoint.reach(player, 0.1, 7)
    kit.play(world, 5, each)
    local text, hash = checkpoint.write(world), world:hash()
    local other, copy = newGame()
    assert.is_nil(checkpoint.read(other, text))
    assert.same({ hash, 0.1 }, { other:hash(), copy.checkpoint.x })
    assert.has_error(function()
      checkpoint.read(other, "return os.exit()")
    end)
    assert.equal(hash, other:hash())
  end)
end)

describe("examples/kit/bullet.lua: a bullet", function()
  local hits

  -- Enemies at x 200 and 300, a wall at x 400; bullets fly to the right.
  local function newGame(fields)
    local world = kit.world({ { "walls", 400, 300, 20, 100 } }, { "bullet", "health" })
    local enemies = {}
    for i = 1, 2 do
      enemies[i] = { x = 100 + 100 * i, y = 360, width = 20, height = 40, health = 3 }
      world:add("enemies", enemies[i])
    end
    world:add("players", { x = 100, y = 360, width = 20, height = 40, health = 9 })
    local shot = { x = 105, y = 370, width = 6, height = 4, vx = 900, owner = "players" }
    small.set(shot, fields)
    world:update(DT)
    bullet.shoot(world, "bullets", shot)
    hits = {}
    bullet.onHit = function(_, _, other)
      hits[#hits + 1] = math.floor(other.x + 0.5)
    end
    return world, enemies, function()
      bullet.update(world, "bullets", DT)
    end
  end
  after_each(function()
    bullet.onHit = nil
  end)

  -- what, fields, health of both enemies, hits, in order
  local ROWS = {
    { "hits the first enemy only, and not its owner", {}, { 2, 3 }, { 200 } },
    { "as fast as you like", { vx = 20000 }, { 2, 3 }, { 200 } },
    { "takes as much as it is worth", { damage = 2 }, { 1, 3 }, { 200 } },
    { "pierces one enemy", { pierce = 1 }, { 2, 2 }, { 200, 300 } },
    { "pierces all, up to the wall", { pierce = 9 }, { 2, 2 }, { 200, 300, 400 } },
    { "pierces nothing behind a wall", { pierce = 9, x = 425, vx = -20000 }, { 3, 3 }, { 400 } },
    { "ends with its life", { life = 0.05 }, { 3, 3 }, {} },
  }
  small.rows("{1}", ROWS, function(_, fields, health, expected)
    local world, enemies, each = newGame(fields)
    kit.play(world, 40, each)
    assert.same(health, { enemies[1].health, enemies[2].health })
    assert.same(expected, hits)
    assert.equal(0, #world.objects.bullets)
  end)

  it("in the air is part of a saved state, also in a new world", function()
    local world, enemies, each = newGame()
    kit.play(world, 3, each)
    local state = world:save()
    kit.play(world, 20, each)
    world:restore(state)
    assert.equal(3, enemies[1].health)
    kit.play(world, 20, each)
    assert.equal(2, enemies[1].health)
    local other, others, eachOther = newGame({ life = 0.01 })
    kit.play(other, 3, eachOther)
    other:restore(state)
    kit.play(other, 20, eachOther)
    assert.same({ 2, 0 }, { others[1].health, #other.objects.bullets })
  end)
end)
