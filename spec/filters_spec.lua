-- The field `hits`: an object collides with the groups that it lists, and with nothing else.

local physics = require("physics")

local DT = 1 / 60

local function newWorld(settings)
  settings = settings or {}
  settings.gravity = settings.gravity or 0
  return physics.newWorld(settings)
end

-- A bullet that flies right through a row of one object of each group.
local function shoot(fields, settings)
  local world = newWorld(settings)
  local met = {}
  for n, group in ipairs({ "walls", "enemies", "players", "gems" }) do
    world:add(group, { x = 40 * n, y = 0, width = 10, height = 10, static = group == "walls" })
  end
  fields.x, fields.y, fields.width, fields.height, fields.vx = 0, 3, 4, 4, 300
  fields.mass = 1e-6
  function fields.onBegin(_, other)
    for group, members in pairs(world.objects) do
      met[#met + 1] = members[1] == other and group or nil
    end
  end
  local bullet = world:add("bullets", fields)
  for _ = 1, 60 do
    world:update(DT)
  end
  return met, bullet, world
end

describe("hits", function()
  for _, row in ipairs({
    { "one group", { "players" }, { "players" } },
    { "two groups, in any order", { "gems", "walls" }, { "walls" } },
    { "a group that is not there", { "ghosts" }, {} },
    { "no group", {}, {} },
  }) do
    it("lets an object collide with " .. row[1] .. " only", function()
      assert.same(row[3], (shoot({ hits = row[2] })))
    end)
  end

  it("lets a sensor report these groups only", function()
    assert.same({ "enemies", "gems" }, (shoot({ hits = { "gems", "enemies" }, sensor = true })))
  end)

  it("does not outvote a mask, and a mask does not outvote it", function()
    local hits = { "players", "gems" }
    assert.same({ "gems" }, (shoot({ hits = hits, mask = { players = false } })))
    assert.same({ "players" }, (shoot({ hits = hits }, { masks = { gems = { bullets = false } } })))
  end)

  it("may be refused by the other object, too", function()
    local world = newWorld()
    local wall = world:add("walls", { x = 50, y = 0, width = 9, height = 9, static = true })
    wall.hits = { "players" }
    world:refresh(wall)
    local crate = world:add("crates", { x = 20, y = 0, width = 9, height = 9, vx = 300 })
    local player = world:add("players", { x = 20, y = 3, width = 3, height = 3, vx = 300 })
    player.mask = { crates = false }
    for _ = 1, 30 do
      world:update(DT)
    end
    assert.near(170, crate.x, 1e-9)
    assert.near(47, player.x, 1e-9)
  end)

  it("holds for queries of an object's way, and is told by explain", function()
    local _, bullet, world = shoot({ hits = { "players" } })
    local wall, player = world.objects.walls[1], world.objects.players[1]
    bullet.x = 0
    assert.equal(player, (world:sweep(bullet, 400, 0)))
    assert.matches(
      'never collide: .*bullets%[1%] does not hit the group "walls"%.',
      world:explain(bullet, wall)
    )
    assert.matches("can collide", world:explain(bullet, player))
  end)

  it("may be changed at any time, by setting another list", function()
    local world = newWorld()
    local wall = world:add("walls", { x = 100, y = 0, width = 10, height = 10, static = true })
    local ball = world:add("balls", { x = 0, y = 0, width = 10, height = 10, vx = 60, hits = {} })
    for _ = 1, 60 do
      world:update(DT)
    end
    ball.hits = { "walls" }
    for _ = 1, 60 do
      world:update(DT)
    end
    assert.equal(wall, ball.touching.right)
    ball.hits = nil
    world:update(DT)
    assert.equal(wall, ball.touching.right)
    ball.hits, ball.vx = {}, 60
    world:update(DT)
    assert.equal(91, ball.x)
    assert.is_false(ball.touching.right)
  end)
end)

describe("hits, checked,", function()
  local world, bullet

  before_each(function()
    world = newWorld({ checked = true })
    world:add("players", { x = 90, y = 90, width = 10, height = 10 })
    bullet = world:add("bullets", { x = 0, y = 0, width = 4, height = 4, vx = 9 })
  end)

  local function fails(text)
    local ok, message = pcall(world.update, world, DT)
    assert.is_false(ok)
    assert.equal("physics: " .. text, message:match("physics: .*"))
  end

  it("finds a name that is one slip away from a group", function()
    bullet.hits = { "playres" }
    fails("objects.bullets[1].hits: there is no group playres, did you mean players?")
  end)

  it("finds a list that was changed inside its table", function()
    bullet.hits = { "players" }
    world:update(DT)
    bullet.hits[2] = "bullets"
    fails(
      "objects.bullets[1].hits was changed inside its table: the list is read when it is set, so"
        .. " set another list"
    )
  end)

  it("finds a filter of a query that is one slip away from a group", function()
    world:update(DT)
    for _, filter in ipairs({ "palyers", { "bullets", "palyers" } }) do
      local ok, message = pcall(world.queryRect, world, 0, 0, 9, 9, filter)
      assert.is_false(ok)
      assert.matches(
        "spec/filters_spec.lua:%d+: physics: world:queryRect%(.*%): filter: there is no group"
          .. " palyers, did you mean players%?",
        message
      )
    end
    assert.equal(1, select(2, world:queryRect(0, 0, 9, 9, { "bullets", "coins" })))
    local ok, message = pcall(world.explode, world, 0, 0, 9, 9, "bullets", "palyers")
    assert.is_false(ok)
    assert.matches(
      "spec/filters_spec.lua:%d+: physics: world:explode%(.*%): walls: filter: there is no group"
        .. " palyers, did you mean players%?",
      message
    )
  end)
end)
