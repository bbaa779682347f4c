--- Random games of the kinds that are made: a level and a player's keys from a seed. Each proves
--- that a player would notice nothing in so many frames (watcher.lua, and `check` of each kind).

local newRandom = require("spec.support.random").new
local overlap = require("spec.support.overlap")
local physics = require("physics")
local watcher = require("spec.fuzz.watcher")

local abs, floor, max = math.abs, math.floor, math.max

local games = {}

-- Px by which a mixed crowd may press one of its own into a player with `strength` of 16 px: a
-- circle that boxes wedge in at its corner. (1.0.0: 2.4 px. Boxes alone: none.)
local PRESSED = 4
-- Px by which what glides along a crate may shift it: both are flush, but for the last bits.
local ROUNDING = 1e-9
-- Px by which round objects may overlap where all give way.
local OVERLAP = 0.5
-- Times what energy was before: what is squeezed in a crowd shoots out.
local SQUEEZED = 1.25
local RATES = { 1 / 30, 1 / 60, 1 / 60, 1 / 60, 1 / 120, 1 / 144 }

-- A game has its world, `movers`, `solids`, `machines` (that may crush), `room`, `carried` (px that
-- a frame may add to a way), `hero` (which must not be stuck at the end), and functions
-- `act(frame, dt)` and `check(frame)`, which returns what is wrong.
local function newGame(settings, width, height)
  local world = physics.newWorld(settings)
  local game = {
    world = world,
    room = { 0, 0, width, height },
    movers = {},
    solids = {},
    machines = {},
    carried = 0,
    act = function() end,
    check = function() end,
  }
  for _, wall in ipairs({
    { -32, -32, 32, height + 64 },
    { width, -32, 32, height + 64 },
    { 0, -32, width, 32 },
    { 0, height, width, 32 },
  }) do
    local object = { x = wall[1], y = wall[2], width = wall[3], height = wall[4], static = true }
    game.solids[#game.solids + 1] = world:add("walls", object)
  end
  return game
end

local function addSolid(game, group, object)
  object.static = true
  game.solids[#game.solids + 1] = game.world:add(group, object)
  return object
end

local function addMover(game, group, object)
  game.movers[#game.movers + 1] = game.world:add(group, object)
  return object
end

local function addMachine(game, group, object)
  object.kinematic = true
  game.machines[#game.machines + 1] = game.world:add(group, object)
  return object
end

-- Returns the energy of objects if each of them were faster by `more` px/s.
local function energyOf(movers, more)
  local energy = 0
  for _, object in ipairs(movers) do
    local vx, vy = object.vx or 0, object.vy or 0
    local speed = math.sqrt(vx * vx + vy * vy) + more
    energy = energy + (object.mass or 1) / 2 * speed * speed
  end
  return energy
end

local function tile(x, y, slope)
  return { x = 16 * x, y = 16 * y, width = 16, height = 16, slope = slope }
end

-- Kinds -------------------------------------------------------------------------------------------

local kinds = {}

-- A floor with hills of 45 degrees, ledges, one-ways, a lift, crates, a hero that runs and jumps.
function kinds.platformer(random)
  local game = newGame({ gravity = 900 }, 640, 320)
  local ground, x = 18, 0
  while x < 40 do
    local step = x > 2 and x < 36 and random:integer(-1, 1) or 0
    if step ~= 0 and ground + step < 20 and ground + step > 14 then
      addSolid(
        game,
        "slopes",
        tile(x, step < 0 and ground - 1 or ground, step < 0 and "right" or "left")
      )
      for y = step < 0 and ground or ground + 1, 19 do
        addSolid(game, "tiles", tile(x, y))
      end
      ground, x = ground + step, x + 1
    end
    for _ = 1, random:integer(2, 6) do
      for y = ground, x < 40 and 19 or -1 do
        addSolid(game, "tiles", tile(x, y))
      end
      x = x + 1
    end
  end
  for _ = 1, random:integer(2, 5) do
    local ledge = tile(random:integer(2, 34), random:integer(6, 11))
    ledge.width, ledge.static = 16 * random:integer(2, 5), true
    ledge.oneWay = random:chance(0.5) and "top" or nil
    if ledge.oneWay then
      game.world:add("ledges", ledge)
    else
      addSolid(game, "ledges", ledge)
    end
  end
  local lift = addMachine(game, "lifts", {
    x = 16 * random:integer(4, 30),
    y = 60,
    width = 48,
    height = 8,
    vy = random:integer(30, 80),
    oneWay = "top",
  })
  for _ = 1, random:integer(0, 3) do
    addMover(
      game,
      "crates",
      { x = random:integer(40, 560), y = 20, width = 14, height = 14, friction = 0.6 }
    )
  end
  local hero = addMover(game, "heroes", {
    x = 8,
    y = 240,
    width = random:pick({ 10, 12, 14 }),
    height = random:pick({ 16, 20, 24 }),
    nudge = 4,
    snap = 8,
    maxFallSpeed = 500,
  })
  local way, left, air, jumps = 0, 0, 0, false
  game.carried = 8 + 8 + 4 -- snap, a lift, nudge
  function game.act()
    if left == 0 then
      way, left = random:pick({ -1, 0, 1, 1, -1 }), random:integer(5, 60)
    end
    left = left - 1
    hero.vx = 140 * way
    jumps = hero.touching.bottom and random:chance(0.03)
    if jumps then
      hero.vy = -320
    end
    if lift.y > 200 or lift.y < 50 then
      lift.vy = (lift.y < 50 and 1 or -1) * abs(lift.vy)
    end
  end
  function game.check()
    if jumps or hero.touching.bottom then
      air = jumps and 9 or 0
    elseif hero.vy >= 0 then
      air = air + 1
    end
    local before = game.heroBefore
    local isFlicker = before and before.stood and hero.touching.bottom and before.y == hero.y
    if isFlicker and air == 1 then
      return "off the ground", ("at %g, %g"):format(hero.x, hero.y)
    end
    game.heroBefore = { stood = hero.touching.bottom, y = hero.y }
  end
  return game
end

-- A player with `strength`, seen from above, and a crowd that presses to it, between pillars.
function kinds.survivors(random)
  local soft = random:chance(0.5) and random:integer(60, 600) or nil
  local game = newGame({ gravity = 0, soft = soft and { enemies = { enemies = soft } } }, 480, 360)
  local player =
    addMover(game, "players", { x = 230, y = 170, width = 16, height = 16, strength = 1 })
  for _ = 1, random:integer(0, 5) do
    local size = random:integer(16, 48)
    local pillar =
      { x = random:integer(20, 420), y = random:integer(20, 300), width = size, height = size }
    pillar.radius = random:chance(0.5) and size / 2 or nil
    if overlap.depth(player, pillar) <= -8 then
      addSolid(game, "pillars", pillar)
    end
  end
  local size = random:integer(10, 20)
  for n = 1, random:integer(40, 120) do
    local enemy = { x = (n * 41) % 440 + 10, y = (n * 67) % 320 + 10, width = size, height = size }
    enemy.radius = random:chance(0.3) and size / 2 or nil
    local isFree = overlap.depth(enemy, player) < -4
    for _, solid in ipairs(game.solids) do
      isFree = isFree and overlap.depth(enemy, solid) < -1
    end
    if isFree then
      addMover(game, "enemies", enemy)
    end
  end
  local speed, walk = random:integer(40, 100), random:chance(0.5) and 80 or 0
  local turn, wayX, wayY = 0, 0, 0
  function game.act(frame, dt)
    if turn == 0 then
      turn, wayX, wayY = random:integer(20, 90), random:integer(-1, 1), random:integer(-1, 1)
    end
    turn = turn - 1
    player.vx, player.vy = wayX * walk, wayY * walk
    for n = 2, #game.movers do
      local enemy = game.movers[n]
      local dx, dy = player.x - enemy.x, player.y - enemy.y
      local far = max(math.sqrt(dx * dx + dy * dy), 1)
      enemy.vx, enemy.vy = speed * dx / far, speed * dy / far
    end
    -- What overlaps parts by up to a quarter of its size; the watcher allows a sixteenth. Soft ones
    -- part as fast as `soft` says.
    game.carried = frame < 60 and 40 or walk / 30 + size * 3 / 16 + (soft or 0) * dt
  end
  function game.check()
    for n = 2, #game.movers do
      local depth = overlap.depth(game.movers[n], player)
      if depth > PRESSED then
        return "inside the player", ("%d by %g px"):format(n, depth)
      end
    end
  end
  return game
end

-- A paddle, bricks that break, and a ball that keeps its speed.
function kinds.breakout(random)
  local game = newGame({ gravity = 0 }, 320, 240)
  local bricks = {}
  for row = 0, random:integer(2, 5) do
    for column = 0, 9 do
      if random:chance(0.8) then
        bricks[#bricks + 1] = game.world:add("bricks", {
          x = 4 + 31.2 * column,
          y = 20 + 12 * row,
          width = 31.2,
          height = 12,
          static = true,
        })
      end
    end
  end
  local paddle = addMachine(game, "paddles", { x = 140, y = 220, width = 40, height = 8 })
  local size = random:pick({ 6, 8 })
  local ball = addMover(game, "balls", {
    x = 150,
    y = 180,
    width = size,
    height = size,
    radius = random:chance(0.7) and size / 2 or nil,
    restitution = 1,
    vx = random:integer(-160, 160),
    vy = -random:integer(120, 400),
  })
  function ball.onBegin(_, other)
    if other ~= paddle and not other.isGone then
      for n, brick in ipairs(bricks) do
        if brick == other then
          table.remove(bricks, n)
          other.isGone = true
          game.world:remove(other)
          break
        end
      end
    end
  end
  function game.act()
    -- A ball beside the paddle is missed, and served anew. (It would be crushed against the wall.)
    if ball.y + size > paddle.y + 1 then
      ball.x, ball.y, ball.vy = 150, 180, -abs(ball.vy)
    end
    paddle.vx = max(-240, math.min(240, (ball.x - paddle.x - 16) * 12))
    if paddle.x < 2 and paddle.vx < 0 or paddle.x > 278 and paddle.vx > 0 then
      paddle.vx = 0
    end
    game.speed = ball.vx * ball.vx + ball.vy * ball.vy
    game.carried = 10 -- a paddle that comes from the side
  end
  function game.check()
    local speed = ball.vx * ball.vx + ball.vy * ball.vy
    if speed < game.speed * (1 - 1e-9) and ball.y <= 205 then
      return "slower", ("%g of %g"):format(speed, game.speed)
    end
    for n, brick in ipairs(bricks) do
      if overlap.depth(ball, brick) > 0.02 then
        return "inside", "the ball is in brick " .. n
      end
    end
  end
  return game
end

-- Marbles that are poured onto ramps and roll into a pit.
function kinds.marbles(random)
  local game = newGame({ gravity = 800 }, 320, 400)
  for n = 0, 2 do
    local isLeft, width = n % 2 == 0, random:integer(120, 220)
    addSolid(game, "ramps", {
      x = isLeft and 0 or 320 - width,
      y = 90 + 90 * n,
      width = width,
      height = random:integer(20, 60),
      slope = isLeft and "left" or "right",
    })
  end
  for _ = 1, random:integer(5, 30) do
    local r = random:integer(3, 8)
    addMover(game, "marbles", {
      x = random:integer(10, 280),
      y = random:integer(0, 60),
      radius = r,
      restitution = random:pick({ 0, 0.2, 0.5 }),
    })
  end
  function game.act(frame)
    game.carried = frame > 1 and 12 or 18 -- by which they push each other; some begin in others
  end
  function game.check(frame)
    for n, one in ipairs(game.movers) do
      for m = n + 1, frame < 60 and 0 or #game.movers do
        if m ~= n and overlap.depth(one, game.movers[m]) > 1 then
          return "overlap", ("%d and %d by %g px"):format(n, m, overlap.depth(one, game.movers[m]))
        end
      end
    end
  end
  return game
end

-- A room of cells, crates that stand still unless they are pushed, and a player of a cell's size.
function kinds.sokoban(random)
  local game = newGame({ gravity = 0 }, 256, 192)
  local taken = {}
  local function place()
    local x, y
    repeat
      x, y = random:integer(1, 14), random:integer(1, 10)
    until not taken[16 * y + x]
    taken[16 * y + x] = true
    return 16 * x, 16 * y
  end
  for _ = 1, random:integer(8, 24) do
    local x, y = place()
    addSolid(game, "walls", { x = x, y = y, width = 16, height = 16 })
  end
  local crates = {}
  for n = 1, random:integer(3, 10) do
    local x, y = place()
    crates[n] = addMover(game, "crates", { x = x, y = y, width = 16, height = 16, drag = 4000 })
  end
  local x, y = place()
  local size = random:pick({ 12, 14, 16 })
  local player = addMover(game, "players", { x = x, y = y, width = size, height = size, nudge = 3 })
  local left, wayX, wayY = 0, 0, 0
  function game.act()
    if left == 0 then
      left, wayX, wayY = random:integer(8, 40), 0, 0
      if random:chance(0.5) then
        wayX = random:pick({ -1, 1 })
      else
        wayY = random:pick({ -1, 1 })
      end
    end
    left = left - 1
    player.vx, player.vy = 64 * wayX, 64 * wayY
    for n, crate in ipairs(crates) do
      game[n] = { x = crate.x, y = crate.y, stands = crate.vx == 0 and crate.vy == 0 }
    end
    game.carried = 3
  end
  function game.check()
    for n, crate in ipairs(crates) do
      local t, was = crate.touching, game[n]
      local isTouched = t.left or t.right or t.top or t.bottom
      local isMoved = max(abs(crate.x - was.x), abs(crate.y - was.y)) > ROUNDING
      if was.stands and not isTouched and isMoved then
        return "shaken", ("crate %d moves by itself"):format(n)
      end
    end
  end
  return game
end

-- Belts in a row, a lift at their end, pistons, crates that drop in.
function kinds.factory(random)
  local game = newGame({ gravity = 900 }, 480, 320)
  for n = 0, 2 do
    addSolid(game, "belts", {
      x = n % 2 == 0 and 0 or 80,
      y = 120 + 80 * n,
      width = 340,
      height = 12,
      friction = 0.9,
      surfaceSpeed = (n % 2 == 0 and 1 or -1) * random:integer(30, 140),
    })
  end
  local lift = addMachine(game, "machines", { x = 430, y = 260, width = 44, height = 8, vy = -60 })
  local piston = addMachine(game, "machines", { x = 20, y = 40, width = 40, height = 16, vx = 50 })
  game.carried = 12
  function game.act(frame)
    lift.vy = lift.y < 100 and 60 or lift.y > 300 and -60 or lift.vy
    piston.vx = piston.x < 10 and 50 or piston.x > 120 and -50 or piston.vx
    if frame % 45 == 1 and #game.movers < 24 then
      local size = random:integer(8, 20)
      local crate =
        { x = random:integer(70, 200), y = 4, width = size, height = size, friction = 0.7 }
      for _, other in ipairs(game.movers) do
        if overlap.depth(crate, other) > -2 then
          return
        end
      end
      addMover(game, "crates", crate)
    end
  end
  return game
end

-- Slopes of all kinds and blocks at random, water, a lift and a train, crates and balls; a hero
-- that walks, dashes, jumps, swims and rides.
function kinds.caves(random)
  local game = newGame({ gravity = 900 }, 480, 320)
  local share, slopes = random:between(0.1, 0.35), { "left", "right", "topleft", "topright" }
  for y = 0, 19 do
    for x = 0, 29 do
      local isFree = y > 15 and x < 4 or y == 12 or x == 25 or x == 26
      if not isFree and random:chance(share) then
        addSolid(game, "caves", tile(x, y, random:chance(0.6) and random:pick(slopes) or nil))
      end
    end
  end
  if random:chance(0.5) then
    local water = { x = 0, y = 208, width = 480, height = 112, static = true, sensor = true }
    water.area = { gravity = 60, airFriction = 2 }
    game.world:add("waters", water)
  end
  local lift = addMachine(game, "lifts", { x = 402, y = 40, width = 28, height = 8, vy = 50 })
  local train = addMachine(game, "trains", { x = 16, y = 200, width = 64, height = 8, vx = 60 })
  local hero = addMover(game, "heroes", {
    x = 20,
    y = 290,
    width = random:pick({ 10, 12, 14 }),
    height = random:pick({ 12, 20, 24 }),
    nudge = random:chance(0.5) and 4 or nil,
    snap = random:chance(0.5) and 8 or nil,
    maxFallSpeed = 500,
  })
  game.hero = hero
  if random:chance(0.2) then
    hero.width, hero.height, hero.radius = 14, 14, 7
  end
  for n = 1, random:chance(0.5) and random:integer(1, 6) or 0 do
    local thing = { x = 10 + 60 * n, y = 193, width = 14, height = 14, friction = 0.6 }
    thing.radius = random:chance(0.5) and 7 or nil
    addMover(game, "things", thing)
  end
  local way, rise, left, dash = 0, 0, 0, 0
  game.carried = 8 + 8 + 4 -- snap, a carrier, nudge
  function game.act()
    if left == 0 then
      way, rise, left = random:pick({ -1, 0, 1 }), random:pick({ -1, 0, 1 }), random:integer(5, 60)
      dash = random:chance(0.3) and 8 or 0
    end
    left, dash = left - 1, dash - 1
    hero.gravity = dash > 0 and 0 or nil
    hero.vx = (dash > 0 and 500 or 130) * way
    if dash > 0 then
      hero.vy = 500 * rise
    elseif hero.y > 208 and rise ~= 0 and random:chance(0.5) then
      hero.vy = 90 * rise
    elseif hero.touching.bottom and random:chance(0.05) then
      hero.vy = -320
    end
    lift.vy = lift.y < 8 and 50 or lift.y > 304 and -50 or lift.vy
    train.vx = train.x < 8 and 60 or train.x > 408 and -60 or train.vx
  end
  return game
end

-- Round enemies of mixed sizes, by velocity or by acceleration, around a round player that walks,
-- in a room with pillars and walls.
function kinds.arena(random)
  local game = newGame({ gravity = 0 }, 480, 360)
  local kind = random:pick({ "plain", "strong", "fixed" })
  local player = addMover(game, "players", { x = 230, y = 170, radius = random:integer(6, 12) })
  player.strength = kind == "strong" and 1 or nil
  player.pushable = kind ~= "fixed" and nil
  game.machines[1] = kind ~= "plain" and player or nil
  for n = 1, random:integer(0, 8) do
    local size = random:integer(16, 48)
    local x, y = 100 * (n % 4) + random:integer(20, 70), 120 * (n % 3) + random:integer(10, 60)
    local pillar = { x = x, y = y, width = size, height = size }
    pillar.radius = n % 2 == 0 and random:chance(0.6) and size / 2 or nil
    if overlap.depth(player, pillar) < -30 then
      addSolid(game, "pillars", pillar)
    end
  end
  local isDriven, speed, drag = random:chance(0.5), random:integer(30, 120), random:integer(0, 300)
  local restitution = random:chance(0.3) and 0.5 or nil
  for n = 1, random:integer(15, 80) do
    local r = random:integer(4, 12)
    local enemy =
      { x = (n * 41) % 440 + 10, y = (n * 67) % 320 + 10, width = 2 * r, height = 2 * r }
    enemy.radius, enemy.restitution, enemy.mass = r, restitution, random:pick({ 1, 1, 3 })
    enemy.maxSpeed, enemy.drag = not isDriven and speed or nil, not isDriven and drag or nil
    local isFree = true
    for _, list in ipairs({ game.solids, game.movers }) do
      for _, other in ipairs(list) do
        isFree = isFree and overlap.depth(enemy, other) < -1
      end
    end
    if isFree then
      addMover(game, "enemies", enemy)
    end
  end
  local turn, wayX, wayY = 0, 0, 0
  function game.act(_, dt)
    if turn == 0 then
      turn, wayX, wayY = random:integer(20, 90), random:integer(-1, 1), random:integer(-1, 1)
    end
    turn = turn - 1
    player.vx, player.vy = wayX * 80, wayY * 80
    for n = 2, #game.movers do
      local enemy = game.movers[n]
      local dx, dy = player.x - enemy.x, player.y - enemy.y
      local far = max(math.sqrt(dx * dx + dy * dy), 1)
      if isDriven then
        enemy.vx, enemy.vy = speed * dx / far, speed * dy / far
      else
        enemy.ax, enemy.ay = 400 * dx / far, 400 * dy / far
      end
    end
    game.carried = 80 * dt + 2 -- the player pushes them, and what overlaps parts
    game.energy = energyOf(game.movers, isDriven and 0 or 400 * dt)
  end
  function game.check()
    local energy = energyOf(game.movers, 0)
    if kind == "plain" and energy > game.energy * SQUEEZED then
      return "energy", ("%g of %g"):format(energy, game.energy)
    end
    for n, one in ipairs(game.movers) do
      for m = n + 1, #game.movers do
        local depth = overlap.depth(one, game.movers[m])
        if depth > (kind == "plain" and OVERLAP or PRESSED) then
          return "overlap", ("%d and %d by %g px"):format(n, m, depth)
        end
      end
    end
  end
  return game
end

games.kinds =
  { "platformer", "survivors", "breakout", "marbles", "sokoban", "factory", "caves", "arena" }

-- Playing -----------------------------------------------------------------------------------------

--- Starts a game; the same seed gives the same one. Returns s of its frames, too.
function games.start(kind, seed)
  local random = newRandom(seed)
  local game = kinds[kind](random)
  return game, random:pick(RATES)
end

-- Whether the hero of a game is stuck: not pressed by a machine, and it can leave in no direction.
local function isStuck(game, watched)
  local hero, state = game.hero, game.world:save()
  if not hero or watched.held[hero] then
    return false
  end
  for _, machine in ipairs(game.machines) do
    if overlap.depth(hero, machine) > -2 then
      return false
    end
  end
  local most = 0
  for n = 0, 3 do
    local x, y = hero.x, hero.y
    for _ = 1, 10 do
      hero.gravity = 0
      hero.vx, hero.vy = 60 * ({ 1, -1, 0, 0 })[n + 1], 60 * ({ 0, 0, 1, -1 })[n + 1]
      game.world:update(1 / 60)
    end
    most = max(most, abs(hero.x - x), abs(hero.y - y))
    game.world:restore(state)
  end
  return most < 0.5
end

--- Plays a game, and unless it is alone two others beside it that must be the same to the last bit:
--- one without rest, pair by pair; one that is saved and restored in the middle.
---@param kind string one of `games.kinds`
---@param seed integer 1 …
---@param frames integer
---@param isAlone? boolean
---@return table? failure `check`, `text` and `at`, the frame; nil: nothing to notice
function games.play(kind, seed, frames, isAlone)
  local game, dt = games.start(kind, seed)
  local plain, restored = games.start(kind, seed), games.start(kind, seed)
  local others = isAlone and {} or { plain = plain, restored = restored }
  plain.world.broadphase, plain.world.rest = "pairs", false
  local watched = watcher.new(game.world, game.room, game.machines)
  for _, other in pairs(others) do
    watcher.new(other.world, other.room) -- a world that is listened to has other events
  end
  for frame = 1, frames do
    game.act(frame, dt)
    watcher.note(watched, game.movers)
    game.world:update(dt)
    local check, text = watcher.check(watched, game.movers, game.solids, dt, game.carried)
    if not check then
      check, text = game.check(frame)
    end
    for name, other in pairs(others) do
      other.act(frame, dt)
      if other == restored and frame == floor(frames / 2) then
        other.world:restore(other.world:save())
      end
      other.world:update(dt)
      if not check and other.world:hash() ~= game.world:hash() then
        check, text = "same", "the hashes differ: " .. name
      end
    end
    if not check and frame == frames and isStuck(game, watched) then
      check, text = "stuck", ("the hero at %g, %g"):format(game.hero.x, game.hero.y)
    end
    if check then
      return { check = check, text = text, at = frame }
    end
  end
end

return games
