--- What meets what: the field `hits`, sensors and `canCollide`. (Masks are in objects_spec and
--- fields_at_run_time_spec, soft groups in filters_soft_spec, one-ways in scenarios/07.)

local play = require("spec.support.play")
local scene = require("spec.support.scene")
local small = require("spec.support.small")

local DT = 1 / 60

local box = scene.thing("boxes", { name = "box", x = 0, y = 0, width = 16, height = 16 })
local solid = scene.maker("walls", { static = true })
local FLOOR = solid("floor", -200, 100, 800, 16)

local row = play.once()

local newWorld = small.still

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
  small.run(world, 60)
  return met, bullet, world
end

describe("hits", function()
  small.rows("lets an object collide with {1} only", {
    { "one group", { "players" }, { "players" } },
    { "two groups, in any order", { "gems", "walls" }, { "walls" } },
    { "a group that is not there", { "ghosts" }, {} },
    { "no group", {}, {} },
  }, function(_, hits, met)
    assert.same(met, (shoot({ hits = hits })))
  end)

  it("lets a sensor report these groups only", function()
    assert.same({ "enemies", "gems" }, (shoot({ hits = { "gems", "enemies" }, sensor = true })))
  end)

  it("mask and it: neither outvotes the other", function()
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
    small.refuses(text, world.update, world, DT)
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
    local NO_GROUP = "filter: there is no group palyers, did you mean players?"
    for _, given in ipairs({
      { "queryRect", "h): ", "palyers" },
      { "queryRect", "h): ", { "bullets", "palyers" } },
      { "explode", "impulse): walls: ", "bullets", "palyers" },
    }) do
      local call, text = world[given[1]], given[2] .. NO_GROUP
      small.refuses(text, call, world, 0, 0, 9, 9, given[3], given[4])
    end
    assert.equal(1, select(2, world:queryRect(0, 0, 9, 9, { "bullets", "coins" })))
  end)
end)

describe("sensor", function()
  -- A sensor with fields, what is there with fields, begins and ends in 1 s.
  row("sees {what}", function(v)
    local sensor = solid("sensor", 100, 0, 16, 16, { sensor = true })
    sensor = scene.thing("sensors", sensor[2])(v.fields)
    return { gravity = 0, sensor, scene.thing("boxes", box({ x = v.x })[2])(v.more) }
  end, {
    "listen sensor",
    { 1, "((box.raw.touching or {}).right or false) == false" },
    { "sensor heard begins, ends", "box.x ~ x + box.vx" },
  }, {
    "what, fields, x, more, begins, ends",
    { "nothing that is flush", {}, 84, { vx = 0 }, 0, 0 },
    { "what is a little in it", {}, 84.01, { vx = 0 }, 1, 0 },
    { "what passes, and stops nothing", {}, 0, { vx = 600 }, 1, 1 },
    { "no static sensor", {}, 100, { sensor = true, static = true, vx = 0 }, 0, 0 },
    { "a sensor that moves", {}, 0, { sensor = true, vx = 600 }, 1, 1 },
    { "what is kinematic", {}, 0, { kinematic = true, vx = 600 }, 1, 1 },
    { "when kinematic", { static = false, kinematic = true, vx = 600 }, 200, { vx = 0 }, 1, 1 },
    { "when it is dynamic", { static = false, vx = 600 }, 200, { vx = 0 }, 1, 1 },
    { "nothing that its mask refuses", { mask = { boxes = false } }, 0, { vx = 600 }, 0, 0 },
    { "nothing with a mask against it", {}, 0, { vx = 600, mask = { sensors = false } }, 0, 0 },
  })

  row("reports what comes, stays and goes, with the sides", {
    gravity = 0,
    solid("sensor", 100, -50, 50, 200, { sensor = true }),
    box({ vx = 600 }),
  }, {
    { "listen sensor", "listen box", 1, "sensor heard 1, 1", "box heard 1, 1" },
    { "heard.sensor.sides.left == 1", "heard.box.sides.right == 1", "heard.sensor.stays == 5" },
  })

  row("is told what is in it when it appears", {
    gravity = 0,
    solid("sensor", 8, -10, 50, 50, { sensor = true, active = false }),
    box(),
  }, {
    { "listen sensor", { steps = 10 } },
    { "sensor.active = true", "world:refresh(sensor.raw)", { steps = 10 }, "sensor heard 1, 0" },
    "heard.sensor.stays == 9",
    { "sensor.active = false", "world:refresh(sensor.raw)", { steps = 1 }, "sensor heard 1, 1" },
  })
end)

describe("canCollide", function()
  local FALLS = { FLOOR, box({ y = 60 }) }

  row("is asked with self, the other and the side of self; of the world with both", FALLS, {
    "asked = {}",
    "function ask(a, b, side) asked[#asked + 1] = a.name .. b.name .. side return true end",
    "box.raw.canCollide, floor.raw.canCollide, world.canCollide = ask, ask, ask",
    "world:refresh(floor.raw)",
    1,
    "asked[1] == 'boxfloorbottom'; asked[2] == 'floorboxtop'; asked[3] == 'boxfloorbottom'",
    "box.y == 84",
  })

  row("says no with false and nothing else", FALLS, {
    "function box.raw.canCollide() return answer end",
    { "answer = nil", 1, "box.y == 84" },
    { "answer = false", 0.5, "box.y > 100" },
  })

  it("is asked once a step where two overlap, whatever it says", function()
    for n = 0, 7 do
      local world, asked = newWorld(), 0
      world:add("walls", { x = 0, y = 0, width = 99, height = 99, static = n % 2 == 0 or nil })
      local object = { x = 90, y = 40, width = 20, height = 20, radius = n > 3 and 10 or nil }
      world:add("boxes", object)
      function world.canCollide()
        asked = asked + 1
        return n % 4 < 2
      end
      for step = 1, 5 do
        world:update(DT)
        assert.same({ n, step }, { n, asked })
      end
      assert.equal(n % 4 > 1, object.x == 90)
    end
  end)

  it("is asked again after an error in a step", function()
    local world, answers = newWorld(), { true, "fails", false, false }
    world:add("walls", { x = 0, y = 0, width = 99, height = 99, static = true })
    local one = world:add("boxes", { x = 90, y = 10, width = 20, height = 20 })
    world:add("boxes", { x = 90, y = 50, width = 20, height = 20 })
    function world.canCollide()
      local answer = table.remove(answers, 1)
      return assert(answer ~= "fails") and answer
    end
    assert.is_false((pcall(world.update, world, DT)))
    world:update(DT)
    assert.same({ 90, 0 }, { one.x, #answers })
  end)

  -- 10 px a step: it is inside the floor then
  row("lets pass for this step only", { FLOOR, box({ y = 75, vy = 600 }) }, {
    { "listen box", "passes = 1" },
    "function box.raw.canCollide() passes = passes - 1 return passes < 0 end",
    { steps = 1, "box.y > 84.5", "box.touching.bottom == false", "box heard 0, 0" },
    { steps = 1, "box.y == 84" },
    { steps = 5 },
    "box heard 1, 0",
  })

  row("of the {owner} is asked by objects that rest, too: it may say something else today", FALLS, {
    "isOpen = false",
    "function {owner}.canCollide() return not isOpen end",
    3,
    "box.y == 84",
    { "isOpen = true", 0.5, "box.y > 100" },
  }, { "owner", { "box.raw" }, { "world" } })

  row("is asked about sensors, too", {
    FLOOR,
    solid("sensor", -50, 70, 200, 4, { sensor = true }),
    box({ y = 40 }),
  }, {
    "listen sensor",
    "function sensor.raw.canCollide() return false end",
    1,
    "sensor heard 0, 0",
    { "sensor.raw.canCollide = nil", "world:refresh(sensor.raw)", "box.y, box.vy = 40, 0", 1 },
    "heard.sensor.begins == 1",
  })

  -- The box is held by one of the two, so that it does not run into the other.
  row("touches none of two floors that is refused: {refused}, {broadphase}", function(v)
    local one, two = solid("one", -200, 100, 300, 16), solid("two", 100, 100, 100, 16)
    return { broadphase = v.broadphase, one, two, box({ x = 92, y = 84 }) }
  end, {
    { "listen one", "listen two", "asked = 0" },
    "function box.raw.canCollide(_, tile) asked = asked + 1 return tile.name ~= refused end",
    { steps = 30, "run:support(box).name == other", "box.y == 84" },
    { "asked == 60", "heard[refused].begins == 0", "heard[other].begins == 1" },
  }, {
    "refused, other, broadphase",
    { "one", "two", "grid" },
    { "two", "one", "pairs" },
  })

  row("is asked in every step about a wall beside an object that does not press it", {
    FLOOR,
    solid("wall", 16, 0, 16, 100),
    box({ y = 84, vx = 60 }),
  }, {
    { "listen wall", "isWall = true" },
    "function wall.raw.canCollide() return isWall end",
    "world:refresh(wall.raw)",
    { steps = 5 },
    "box.touching.right == wall",
    { "isWall = false", { steps = 1 }, "box.touching.right == false", "wall heard 1, 1" },
  })
end)
