--- Crowds that press to one point, or to one body: a step moves nothing farther than its speed
--- explains, whatever they do to each other.
---
---    @ @  @ @ @
---   @  @ > P < @ @     P: the player, in the middle
---    @ @ ^ @ @

local crowds = require("spec.support.crowd")
local effort = require("spec.support.effort")
local motion = require("spec.support.motion")
local overlap = require("spec.support.overlap")
local physics = require("physics")
local newRandom = require("spec.support.random").new
local newOverlaps = require("spec.support.overlap").checker
local small = require("spec.support.small")

-- px, the largest overlap of a crowd that starts apart. Less than a player sees.
local DEPTH = 0.01
-- px, where it presses from all sides against what cannot be pushed: what is between has no way out
-- in the step in which that happens.
local DEPTH_AT_FIRM = 1.5
local LOOK_EVERY = 5 -- steps, between two looks at the overlaps

-- Plays a crowd for some seconds and fails at the first step that breaks a bound.
local function play(options, seconds, rate)
  local crowd = crowds.new(options)
  local watch = motion.new(crowd.world, crowd.objects)
  local overlaps = newOverlaps(crowd.objects)
  local player = crowd.player
  local startX, startY = player and player.x, player and player.y
  for step = 1, seconds * rate do
    crowd:steer()
    watch:before()
    crowd.world:update(1 / rate)
    crowd.time = crowd.time + 1 / rate
    local problem = watch:after(1 / rate)
    if not problem and not options.startsInside and step % LOOK_EVERY == 0 then
      local depth = overlaps()
      local most = options.goal == "firm" and DEPTH_AT_FIRM or DEPTH
      problem = depth > most and ("two overlap by %.9g px"):format(depth)
    end
    if not problem and options.goal == "firm" and (player.x ~= startX or player.y ~= startY) then
      problem = ("the player was moved to %.17g, %.17g"):format(player.x, player.y)
    end
    if problem then
      error(("step %d: %s"):format(step, problem), 2)
    end
  end
  return crowd
end

describe("x, vx and pushable: a crowd", function()
  it("of 300 presses for 20 s to an unpushable player, which stays #slow", function()
    play({ count = 300, seed = 1, goal = "firm", drive = "vx" }, 20, 60)
  end)

  -- Without this it could be the bounds that hold the crowd, instead of pressing.
  local function expectNear(enemies)
    local near = 0
    for _, enemy in ipairs(enemies) do
      if enemy.x ^ 2 + enemy.y ^ 2 < 120 ^ 2 then
        near = near + 1
      end
    end
    assert.is_true(near >= 60, near .. " of 80 are near the player")
  end

  -- Its relatives, fewer and shorter, at other rates (Hz).
  local row = 0
  for _, goal in ipairs({ "point", "firm", "heavy", "walker" }) do
    for _, drive in ipairs({ "vx", "ax" }) do
      row = row + 1
      local isUsual = goal == "firm" and drive == "vx"
      for _, rate in ipairs(isUsual and { 60, 30, 144 } or { 60 }) do
        local tag = rate == 60 and "" or " #slow"
        local name = ("keeps its bounds: %s, by %s, %d Hz%s"):format(goal, drive, rate, tag)
        -- What is most like a game is played in each selection but a short one.
        if isUsual and effort.isFirst or effort.plays(row, 8) then
          it(name, function()
            local options = { count = 80, seed = 4, goal = goal, drive = drive }
            -- Others than the usual one are watched while the crowd arrives.
            local seconds = (isUsual and rate == 60) and 6 or 3
            local crowd = play(options, seconds, rate)
            if isUsual and seconds >= 6 then
              expectNear(crowd.enemies)
            end
          end)
        end
      end
      local name = ("keeps the bound of motion, begun inside itself: %s, by %s"):format(goal, drive)
      if effort.plays(row, 8) then
        it(name, function()
          local options = { count = 120, seed = 5, goal = goal, drive = drive, startsInside = true }
          play(options, effort.isWhole and 4 or 2, 60)
        end)
      end
    end
  end

  it("of a box and two circles leaves an unpushable player on its straight way", function()
    local world = physics.newWorld({ gravity = 0 })
    world:setBounds(0, 0, 100, 60)
    local player = world:add("players", small.put(2, 20, 16, 16, { pushable = false }))
    for n, place in ipairs({ { 78, 27 }, { 53, 7 }, { 27, 16 } }) do
      world:add("enemies", small.put(place[1], place[2], 12, 12, { radius = n ~= 2 and 6 or nil }))
    end
    for _ = 1, 90 do
      for _, enemy in ipairs(world.objects.enemies) do
        local dx, dy = player.x + 5 - enemy.x, player.y + 5 - enemy.y
        local share = 75 / math.max(1, math.sqrt(dx * dx + dy * dy))
        enemy.vx, enemy.vy = share * dx, share * dy
      end
      player.vx, player.vy = 60, 0
      world:update(1 / 60)
      assert.same({ 20, 0 }, { player.y, player.vy })
    end
  end)

  -- Most of them overlap the player, or each other; it must not go anywhere.
  it("of bodies put onto an unpushable player at rest leaves it where it is", function()
    for seed = 1, effort.share(5, 2) do
      local crowd = crowds.new({ count = 0, seed = seed, goal = "firm", drive = "vx" })
      local random = newRandom(seed)
      for _ = 1, 40 do
        local size = random:between(10, 20)
        local x, y = random:between(-30, 30) - size / 2, random:between(-30, 30) - size / 2
        local enemy = { x = x, y = y, width = size, height = size }
        crowd.world:add("enemies", enemy)
        crowd.objects[#crowd.objects + 1] = enemy
      end
      local watch, player = motion.new(crowd.world, crowd.objects), crowd.player
      for step = 1, 120 do
        watch:before()
        crowd.world:update(1 / 60)
        local problem = watch:after(1 / 60)
        assert.is_nil(problem, problem and ("seed %d, step %d: %s"):format(seed, step, problem))
        assert.same({ -8, -12 }, { player.x, player.y })
      end
      assert.is_true(newOverlaps(crowd.objects)() <= DEPTH)
    end
  end)

  -- Else they would go through each other from one side of the crowd to the other.
  it("at one spot goes on at one velocity, with the momentum that it had", function()
    local world, bodies, momentum, mass = physics.newWorld({ gravity = 0 }), {}, 0, 0
    for i = 1, 12 do
      bodies[i] = world:add("bodies", { x = 0, y = 0, width = 10, height = 10, mass = i })
      bodies[i].vx, bodies[i].vy = 10 * (i % 5) - 20, 30
      momentum, mass = momentum + i * bodies[i].vx, mass + i
    end
    world:update(1 / 60)
    for _, body in ipairs(bodies) do
      assert.near(momentum / mass, body.vx, 1e-9)
      assert.near(30, body.vy, 1e-9)
    end
  end)

  it("at one spot without room for it goes to even places, and does not fall before", function()
    local world = physics.newWorld({ gravity = 800 })
    world:setBounds(-12.5, -12.5, 25, 25)
    for _ = 1, 9 do
      world:add("bodies", { x = -5, y = -5, width = 10, height = 10 })
    end
    small.run(world, 2) -- half of its size a step
    for n, body in ipairs(world.objects.bodies) do
      local column, line = math.floor((n - 1) / 2), (n - 1) % 2
      assert.same({ n, 3.75 * column - 12.5, 10 * line - 10 }, { n, body.x, body.y })
    end
  end)

  it("at one spot lies beside a wall that begins or ends near it", function()
    for _, y in ipairs({ -62, 2 }) do
      local world = physics.newWorld({ gravity = 0 })
      world:add("walls", { x = 8, y = y, width = 20, height = 60, static = true })
      for _ = 1, 9 do
        world:add("bodies", { x = -5, y = -5, width = 10, height = 10 })
      end
      small.run(world, 60)
      for n, body in ipairs(world.objects.bodies) do
        local column, line = math.floor((n - 1) / 3), (n - 1) % 3
        assert.same({ y, 10 * column - 22, 10 * line - 15 }, { y, body.x, body.y })
      end
    end
  end)

  -- count of boxes of 10 px; width and height of the room around them; columns and rows
  local SPOTS = { { 9, 900, 900, 3, 3 }, { 12, 900, 25, 6, 2 }, { 12, 25, 900, 2, 6 } }
  small.rows(
    "at one spot, {1} in {2} x {3}, lies in {4} columns",
    SPOTS,
    function(count, width, height, columns, rows)
      local world, cells = physics.newWorld({ gravity = 0 }), {}
      world:setBounds(-width / 2, -height / 2, width, height)
      for _ = 1, count do
        world:add("bodies", { x = -5, y = -5, width = 10, height = 10 })
      end
      small.run(world, 60)
      for _, body in ipairs(world.objects.bodies) do
        local column, line = body.x / 10 + columns / 2, body.y / 10 + rows / 2
        cells[1 + math.floor(column + 0.5) + columns * math.floor(line + 0.5)] = true
        assert.near(math.floor(column + 0.5), column, 1e-6)
        assert.near(math.floor(line + 0.5), line, 1e-6)
      end
      assert.equal(count, #cells)
    end
  )
end)

-- Pressed slanted, circles are left to their heap: as impacts they met again until the rounds ran
-- out, and what overlapped then hopped by up to 9 px.
it("radius: a crowd, half circles, presses to an unpushable player without a hop", function()
  local crowd = crowds.new({ count = 60, seed = 2, goal = "firm", drive = "vx", balls = 0.5 })
  local most = crowds.FASTEST / 60 + 20 / 16 -- its own way, and a sixteenth of its size
  for step = 1, 120 do
    local places = {}
    for n, enemy in ipairs(crowd.enemies) do
      places[n] = { enemy.x, enemy.y }
    end
    crowd:step(1 / 60)
    for n, enemy in ipairs(step > 30 and crowd.enemies or {}) do
      local x, y = enemy.x - places[n][1], enemy.y - places[n][2]
      assert.is_true(math.max(x, -x, y, -y) <= most, x .. ", " .. y)
    end
  end
end)

-- Plays a crowd that begins near its goal, for a second. Returns how deep its boxes have been in
-- each other, and any of it in `middle`, px.
local function press(crowd, middle)
  local depths, between, inMiddle = newOverlaps(crowd.enemies), 0, 0
  for _ = 1, 60 do
    crowd:step(1 / 60)
    between = math.max(between, (depths()))
    for _, enemy in ipairs(crowd.enemies) do
      inMiddle = math.max(inMiddle, overlap.depth(enemy, middle))
    end
  end
  return between, inMiddle
end

describe("radius, pushable and strength: what presses to", function()
  it("nothing is no crowd: small balls in the corner of the square around a large one", function()
    local world, balls = physics.newWorld({ gravity = 0 }), {}
    balls[1] = world:add("balls", { x = 0, y = 0, radius = 40 })
    for n = 2, 7 do
      local x, y = 68 + 4.1 * (n % 3), n < 5 and 68 or 72.1
      balls[n] = world:add("balls", { x = x, y = y, radius = 2 })
    end
    small.run(world, 2)
    assert.same({ 0, 0, 76.2, 68 }, { balls[1].x, balls[1].y, balls[2].x, balls[2].y })
  end)

  -- What pushed a box along one axis pressed it into the slant again, until the rounds ran out.
  small.rows("a round stone ends in no other and not in the stone: {1}", { 2, 3, 4 }, function(seed)
    local crowd = crowds.new({ count = 12, seed = seed, goal = "point", drive = "vx", ring = 2 })
    local stone = { x = -16, y = -16, radius = 16, static = true }
    crowd.world:add("stones", stone)
    local between, inStone = press(crowd, stone)
    -- The passes over slanted contacts come as near as 1e-5.
    assert.same({ seed, true, true }, { seed, between < 1e-5, inStone < 1e-6 })
  end)

  -- A ball was pushed away from a box before that came: they ended 1.8 px in each other.
  small.rows("a point, half of it balls, ends apart: {1}", { 1, 12 }, function(seed)
    local options = { count = 30, seed = seed, goal = "point", drive = "vx", ring = 2, balls = 0.5 }
    local crowd = crowds.new(options)
    for _ = 1, 60 do
      crowd:step(1 / 30)
      for n, one in ipairs(crowd.enemies) do
        for m = n + 1, #crowd.enemies do
          assert.is_true(overlap.depth(one, crowd.enemies[m]) < 0.12)
        end
      end
    end
  end)

  -- Enemies pass neither each other in the lane nor the player. (They were 0.45 px in it.)
  --
  --    |@@ @|      walls at 0 and 58, enemies with a radius of 7, 11 or 17 px, the player with 13
  --    | P ^|
  it("a strong round player in a lane is never in it", function()
    local world, random, list = physics.newWorld({ gravity = 0 }), newRandom(1), {}
    for x = -24, 58, 82 do
      world:add("walls", { x = x, y = 0, width = 24, height = 900, static = true })
    end
    local player = { x = 32, y = 760, radius = 13, strength = 1, mass = 10 }
    world:add("players", player)
    for n = 1, 24 do
      local r = random:pick({ 7, 11, 17 })
      local x = 58 - 2 * r - random:between(0, 58 - 2 * r)
      list[n] = { x = x, y = 700 - n * 36 - r, radius = r, mass = r * r / 100 }
      world:add("enemies", list[n])
    end
    for frame = 1, 90 do
      player.vy = frame > 30 and frame < 75 and -150 or 0
      for _, enemy in ipairs(list) do
        local dx, dy =
          player.x + 13 - enemy.x - enemy.radius, player.y + 13 - enemy.y - enemy.radius
        local share = 80 / math.max(1, math.sqrt(dx * dx + dy * dy))
        enemy.vx, enemy.vy = dx * share, dy * share
      end
      world:update(1 / 30)
      for _, enemy in ipairs(list) do
        local depth = overlap.depth(enemy, player)
        assert.is_true(depth < 0.3, ("frame %d: %g px"):format(frame, depth))
      end
    end
  end)

  -- It was 3.2 px in the small ball that four large ones held back, and passes reached slowly.
  --
  --    |@@@ @@@|     vy = 200
  --    |@@@ @@@|
  --    |   @@@o|
  --    |PP     |     vy = -150
  small.rows("a strong player presses a light ball along a wall: {1}", { 30, 60 }, function(hz)
    local world, list = physics.newWorld({ gravity = 0 }), {}
    world:add("walls", small.tile(-20, -900, 20, 1800))
    world:add("walls", small.tile(30, -900, 20, 1800))
    local player = small.ball(11, 0, 11, { strength = 1, mass = 10 })
    list[1] = world:add("balls", small.ball(23, -18, 7, { mass = 0.2 }))
    for n = 2, 5 do
      list[n] = world:add("balls", small.ball(14.5 + n % 2, 24 - 30 * n, 14.5, { mass = 2 }))
    end
    world:add("players", player)
    for _ = 1, 2 * hz do
      player.vy = -150
      for _, one in ipairs(list) do
        one.vx, one.vy = 0, 200
      end
      world:update(1 / hz)
      assert.is_true(overlap.depth(list[1], player) < 1e-6)
    end
  end)

  -- It went 9 px into the ball.
  --
  --     P          vy = 150
  --     o
  --    # #         two round pillars
  it("a strong player stops at a ball that two pillars hold", function()
    local world = physics.newWorld({ gravity = 0 })
    local player = world:add("players", small.ball(0, -30, 13, { strength = 1, mass = 10 }))
    local ball = world:add("balls", small.ball(0, -10, 6, { mass = 0.2 }))
    for x = -12, 12, 24 do
      world:add("pillars", small.ball(x, 0, 8, { static = true }))
    end
    for _ = 1, 60 do
      player.vy = 150
      world:update(1 / 60)
      assert.is_true(overlap.depth(ball, player) < 1e-6)
    end
  end)

  -- seed, number, squares to the first of them, share of circles, strength
  for _, row in ipairs({ { 48, 36, 2 }, { 188, 20, 1, 0.4 }, { 188, 20, 1, 0.4, 1 } }) do
    local goal = row[5] and "heavy" or "firm"
    local name = row[5] and "strong" or goal
    it(("a %s player is never in it: %d, of seed %d"):format(name, row[2], row[1]), function()
      local options = { count = row[2], seed = row[1], goal = goal, drive = "vx" }
      options.ring, options.balls = row[3], row[4]
      local crowd = crowds.new(options)
      crowd.player.strength = row[5]
      local _, inPlayer = press(crowd, crowd.player)
      assert.is_true(inPlayer < 1e-3, inPlayer .. " px")
    end)
  end
end)
