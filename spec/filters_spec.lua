-- The field `hits`: an object collides with the groups that it lists, and with nothing else.

local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")

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

  local maker = scene.maker
  play.row("may be refused by the other object, too", play.ONCE, {
    gravity = 0,
    maker("walls", { static = true, hits = { "players" } })("wall", 50, 0, 9, 9),
    maker("crates", { vx = 300 })("crate", 20, 0, 9, 9),
    maker("players", { vx = 300, mask = { crates = false } })("player", 20, 3, 3, 3),
  }, { 0.5, "crate.x ~ 170; player.x ~ 47" })

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

  play.row("may be changed at any time, by setting another list", play.ONCE, {
    gravity = 0,
    maker("walls", { static = true })("wall", 100, 0, 10, 10),
    maker("balls", { vx = 60, hits = {} })("ball", 0, 0, 10, 10),
  }, {
    { "run:play(1); ball.raw.hits = { 'walls' }", 1, "ball.touching.right == wall" },
    { "ball.raw.hits = nil", 1 / 60, "ball.touching.right == wall" },
    { "ball.raw.hits, ball.vx = {}, 60", 1 / 60, "ball.x == 91; ball.touching.right == false" },
  })
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
    local NO_GROUP = "filter: there is no group palyers, did you mean players%?"
    for _, row in ipairs({
      { "queryRect", "%(.*%): ", "palyers" },
      { "queryRect", "%(.*%): ", { "bullets", "palyers" } },
      { "explode", "%(.*%): walls: ", "bullets", "palyers" },
    }) do
      local ok, message = pcall(world[row[1]], world, 0, 0, 9, 9, row[3], row[4])
      assert.is_false(ok)
      local text = "spec/filters_spec.lua:%d+: physics: world:" .. row[1] .. row[2] .. NO_GROUP
      assert.matches(text, message)
    end
    assert.equal(1, select(2, world:queryRect(0, 0, 9, 9, { "bullets", "coins" })))
  end)
end)
