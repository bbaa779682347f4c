--- Random games of the kinds that are made: a level and a player's keys from a seed. Each proves
--- that a player would notice nothing (watcher.lua, and `check` of each kind).

local newRandom = require("spec.support.random").new
local overlap = require("spec.support.overlap")
local physics = require("physics")
local watcher = require("spec.fuzz.watcher")

local abs, floor, max, min, sqrt = math.abs, math.floor, math.max, math.min, math.sqrt

local games = {}

-- Px by which what glides along a crate may shift it: both are flush, but for the last bits.
local ROUNDING = 1e-9
local RATES = { 1 / 30, 1 / 60, 1 / 60, 1 / 60, 1 / 120, 1 / 144 }
-- One game of so many is played in two more worlds, and these are compared at so many frames.
local COMPARED, HASHED = 8, 10

-- A game has its world and `room`; `movers`; `solids`, some of which are `carriers`, as are all
-- `machines` (that may crush); `hero`, which must not be stuck at the end; `seconds` that it takes;
-- `pull`, px/s2, the strongest acceleration; `carry`, px/s, the fastest carrier; perhaps `soft` and
-- `vice` (watcher.lua); and functions
-- `act(frame, dt)` and `check(frame)`, which returns what is wrong.
local function newGame(settings, width, height, seconds)
  local world = physics.newWorld(settings)
  world:setBounds(0, 0, width, height)
  local bounds = world.objects.bounds
  return {
    world = world,
    room = { 0, 0, width, height },
    seconds = seconds,
    movers = {},
    solids = { bounds.top, bounds.bottom, bounds.left, bounds.right },
    machines = {},
    carriers = {},
    pull = settings.gravity,
    carry = 0,
    act = function() end,
    check = function() end,
  }
end

-- Adds an object to the world and to `movers`, `solids` or `machines` of a game.
local function add(game, list, group, object)
  object.static, object.kinematic = list == "solids" or nil, list == "machines" or nil
  if object.kinematic or object.surfaceSpeed then
    table.insert(game.carriers, object)
  end
  table.insert(game[list], object)
  return game.world:add(group, object)
end

-- Adds an object if nothing is nearer to it than `gap` px.
local function addFree(game, list, group, object, gap)
  for _, others in ipairs({ game.solids, game.machines, game.movers }) do
    for _, other in ipairs(others) do
      if overlap.depth(object, other) > -gap then
        return
      end
    end
  end
  return add(game, list, group, object)
end

-- A box, or with `isRound` a circle.
local function thing(x, y, width, height, isRound)
  return { x = x, y = y, width = width, height = height, radius = isRound and width / 2 or nil }
end

local function tile(x, y, slope)
  local object = thing(16 * x, 16 * y, 16, 16)
  object.slope = slope
  return object
end

-- Lets an object go to and fro along an axis.
local function turn(object, axis, low, high)
  local speed = abs(object["v" .. axis])
  if object[axis] < low then
    object["v" .. axis] = speed
  elseif object[axis] > high then
    object["v" .. axis] = -speed
  end
end

-- Returns a function that gives a way on x and on y, each -1, 0 or 1, for some frames each.
local function newKeys(random, least, most)
  local wayX, wayY, left = 0, 0, 0
  return function()
    local isNew = left == 0
    if isNew then
      wayX, wayY = random:integer(-1, 1), random:integer(-1, 1)
      left = random:integer(least, most)
    end
    left = left - 1
    return wayX, wayY, isNew
  end
end

-- Lets all but the hero of a game go to it: `field` is "v" or "a", for px/s or px/s2.
local function approach(game, hero, field, size)
  for _, enemy in ipairs(game.movers) do
    local dx, dy = hero.x - enemy.x, hero.y - enemy.y
    local far = max(sqrt(dx * dx + dy * dy), 1)
    if enemy ~= hero then
      enemy[field .. "x"], enemy[field .. "y"] = size * dx / far, size * dy / far
    end
  end
end

-- Kinds -------------------------------------------------------------------------------------------

local kinds = {}

-- A floor with hills of 45 degrees, ledges, one-ways, a lift, crates, a hero that runs and jumps.
function kinds.platformer(random)
  local game = newGame({ gravity = 900 }, 640, 320, 6)
  local height, x = 18, 0
  while x < 40 do
    local step = x > 2 and x < 36 and random:integer(-1, 1) or 0
    if step ~= 0 and height + step < 20 and height + step > 14 then
      local isUp = step < 0
      local slope = tile(x, isUp and height - 1 or height, isUp and "right" or "left")
      add(game, "solids", "slopes", slope)
      for y = isUp and height or height + 1, 19 do
        add(game, "solids", "tiles", tile(x, y))
      end
      height, x = height + step, x + 1
    end
    for _ = 1, random:integer(2, 6) do
      for y = height, x < 40 and 19 or -1 do
        add(game, "solids", "tiles", tile(x, y))
      end
      x = x + 1
    end
  end
  for _ = 1, random:integer(2, 5) do
    local ledge = tile(random:integer(2, 34), random:integer(6, 11))
    ledge.width, ledge.static = 16 * random:integer(2, 5), true
    if random:chance(0.5) then
      ledge.oneWay = "top"
      game.world:add("ledges", ledge)
    else
      add(game, "solids", "ledges", ledge)
    end
  end
  local lift = thing(16 * random:integer(4, 30), 60, 48, 8)
  lift.vy, lift.oneWay = random:integer(30, 80), "top"
  game.carry = lift.vy
  add(game, "machines", "lifts", lift)
  for _ = 1, random:integer(0, 3) do
    local crate = thing(random:integer(40, 560), 20, 14, 14)
    crate.friction = 0.6
    addFree(game, "movers", "crates", crate, 1)
  end
  local hero = thing(8, 240, random:pick({ 10, 12, 14 }), random:pick({ 16, 20, 24 }))
  hero.nudge, hero.snap, hero.maxFallSpeed = 4, 8, 500
  game.hero = add(game, "movers", "heroes", hero)
  local keys, air, ground = newKeys(random, 5, 60), 0, nil
  function game.act()
    hero.vx = 140 * keys()
    if hero.touching.bottom and random:chance(0.03) then
      hero.vy, ground = -320, nil
    end
    turn(lift, "y", 50, 200)
  end
  function game.check()
    local wasOff = air == 1 and hero.y == ground
    air = hero.touching.bottom and 0 or air + 1
    if air == 0 and wasOff then
      return "off the ground", ("for a frame at %g, %g"):format(hero.x, hero.y)
    end
    ground = air == 0 and hero.y or ground
  end
  return game
end

-- A player with `strength`, seen from above, and a crowd that presses to it, between pillars.
function kinds.survivors(random)
  local soft = random:chance(0.5) and random:integer(60, 600) or nil
  local masks = soft and { enemies = { enemies = soft } }
  local game = newGame({ gravity = 0, soft = masks }, 240, 180, 2)
  local player = thing(112, 82, 16, 16)
  player.strength = 1
  game.hero, game.soft = add(game, "movers", "players", player), soft
  for _ = 1, random:integer(0, 4) do
    local size, x, y = random:integer(12, 32), random:integer(0, 208), random:integer(0, 148)
    addFree(game, "solids", "pillars", thing(x, y, size, size, random:chance(0.5)), 8)
  end
  local size = random:integer(10, 20)
  for n = 1, random:integer(8, random:chance(0.1) and 80 or 30) do
    local enemy = thing((n * 41) % 215 + 5, (n * 67) % 155 + 5, size, size, random:chance(0.3))
    addFree(game, "movers", "enemies", enemy, 1)
  end
  local speed, walk = random:integer(40, 100), random:chance(0.5) and 80 or 0
  local keys = newKeys(random, 20, 90)
  game.carry = walk
  function game.act()
    local wayX, wayY = keys()
    player.vx, player.vy = wayX * walk, wayY * walk
    approach(game, player, "v", speed)
  end
  return game
end

-- A paddle, bricks that break, and a ball that keeps its speed.
function kinds.breakout(random)
  local game = newGame({ gravity = 0 }, 320, 240, 8)
  local bricks = {}
  for row = 0, random:integer(2, 5) do
    for column = 0, 9 do
      if random:chance(0.8) then
        local brick =
          add(game, "solids", "bricks", thing(4 + 31.2 * column, 20 + 12 * row, 31.2, 12))
        bricks[brick] = true
      end
    end
  end
  local paddle = add(game, "machines", "paddles", thing(140, 220, 40, 8))
  local size = random:pick({ 6, 8 })
  local ball = thing(150, 180, size, size, random:chance(0.7))
  ball.restitution, ball.vx, ball.vy = 1, random:integer(-160, 160), -random:integer(120, 400)
  game.hero, game.carry = add(game, "movers", "balls", ball), 240
  function ball.onBegin(_, other)
    if bricks[other] then
      bricks[other] = nil
      for n, brick in ipairs(game.solids) do
        if brick == other then
          table.remove(game.solids, n)
        end
      end
      game.world:remove(other)
    end
  end
  local before
  function game.act()
    -- A ball beside the paddle is missed, and served anew. (It would be crushed against the wall.)
    if ball.y + size > paddle.y + 1 then
      ball.x, ball.y, ball.vy = 150, 180, -abs(ball.vy)
    end
    paddle.vx = max(-240, min(240, (ball.x - paddle.x - 16) * 12))
    if paddle.x < 2 and paddle.vx < 0 or paddle.x > 278 and paddle.vx > 0 then
      paddle.vx = 0
    end
    before = ball.vx * ball.vx + ball.vy * ball.vy
  end
  function game.check()
    local speed = ball.vx * ball.vx + ball.vy * ball.vy
    if speed < before * (1 - 1e-9) and ball.y <= 205 then
      return "slower", ("%g of %g"):format(speed, before)
    end
  end
  return game
end

-- Marbles that are poured onto ramps and roll into a pit.
function kinds.marbles(random)
  local game = newGame({ gravity = 800 }, 240, 280, 3)
  for n = 0, 2 do
    local isLeft, width = n % 2 == 0, random:integer(90, 165)
    local ramp = thing(isLeft and 0 or 240 - width, 60 + 60 * n, width, random:integer(15, 45))
    ramp.slope = isLeft and "left" or "right"
    add(game, "solids", "ramps", ramp)
  end
  local count = random:integer(5, random:chance(0.1) and 40 or 20)
  function game.act()
    if #game.movers < count and random:chance(0.5) then
      local size = 2 * random:integer(3, 8)
      local marble = thing(random:integer(10, 200), random:integer(0, 20), size, size, true)
      marble.restitution = random:pick({ 0, 0.2, 0.5 })
      game.hero = addFree(game, "movers", "marbles", marble, 0.5) or game.hero
    end
  end
  return game
end

-- A room of cells, crates that stand still unless they are pushed, and a player of a cell's size.
function kinds.sokoban(random)
  local game = newGame({ gravity = 0 }, 256, 192, 8)
  local taken = {}
  local function place(list, group, size)
    local x, y
    repeat
      x, y = random:integer(1, 14), random:integer(1, 10)
    until not taken[16 * y + x]
    taken[16 * y + x] = true
    return add(game, list, group, thing(16 * x, 16 * y, size, size))
  end
  for _ = 1, random:integer(8, 24) do
    place("solids", "walls", 16)
  end
  for _ = 1, random:integer(3, 10) do
    place("movers", "crates", 16).drag = 4000
  end
  local crates = #game.movers
  local player = place("movers", "players", random:pick({ 12, 14, 16 }))
  player.nudge, game.hero = 3, player
  local keys, before = newKeys(random, 8, 40), {}
  function game.act()
    local wayX, wayY = keys()
    player.vx, player.vy = 64 * (wayY == 0 and wayX or 0), 64 * wayY
    for n = 1, crates do
      local crate = game.movers[n]
      before[n] = { x = crate.x, y = crate.y, stands = crate.vx == 0 and crate.vy == 0 }
    end
  end
  function game.check()
    for n = 1, crates do
      local crate, was = game.movers[n], before[n]
      local t = crate.touching
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
  local game = newGame({ gravity = 900 }, 480, 320, 8)
  for n = 0, 2 do
    local isEven = n % 2 == 0
    local belt = thing(isEven and 0 or 80, 120 + 80 * n, 340, 12)
    belt.friction, belt.surfaceSpeed = 0.9, (isEven and 1 or -1) * random:integer(30, 140)
    add(game, "solids", "belts", belt)
    game.carry = max(game.carry, 60, abs(belt.surfaceSpeed))
  end
  local lift, piston = thing(430, 260, 44, 8), thing(20, 40, 40, 16)
  lift.vy, piston.vx = -60, 50
  add(game, "machines", "machines", lift)
  add(game, "machines", "machines", piston)
  function game.act(frame)
    turn(lift, "y", 100, 300)
    turn(piston, "x", 10, 120)
    if frame % 30 == 1 and #game.movers < 24 then
      local size = random:integer(8, 20)
      local crate = thing(random:integer(70, 200), 4, size, size)
      crate.friction = 0.7
      game.hero = addFree(game, "movers", "crates", crate, 2) or game.hero
    end
  end
  return game
end

-- Slopes of all kinds and blocks at random, water, a lift and a train, crates and balls; a hero
-- that walks, dashes, jumps, swims and rides.
function kinds.caves(random)
  local game = newGame({ gravity = 900 }, 480, 320, 6)
  local share, slopes = random:between(0.1, 0.35), { "left", "right", "topleft", "topright" }
  for y = 0, 19 do
    for x = 0, 29 do
      local isFree = y > 15 and x < 4 or y == 12 or x == 25 or x == 26
      if not isFree and random:chance(share) then
        local slope = random:chance(0.6) and random:pick(slopes) or nil
        add(game, "solids", "caves", tile(x, y, slope))
      end
    end
  end
  if random:chance(0.5) then
    local water = thing(0, 208, 480, 112)
    water.static, water.sensor, water.area = true, true, { gravity = 60, airFriction = 2 }
    game.world:add("waters", water)
  end
  local lift, train = thing(402, 40, 28, 8), thing(16, 200, 64, 8)
  lift.vy, train.vx, game.carry = 50, 60, 60
  add(game, "machines", "lifts", lift)
  add(game, "machines", "trains", train)
  local hero = thing(20, 290, random:pick({ 10, 12, 14 }), random:pick({ 12, 20, 24 }))
  hero.nudge, hero.snap = random:chance(0.5) and 4 or nil, random:chance(0.5) and 8 or nil
  hero.maxFallSpeed = 500
  if random:chance(0.2) then
    hero.width, hero.height, hero.radius = 14, 14, 7
  end
  game.hero = add(game, "movers", "heroes", hero)
  for n = 1, random:chance(0.5) and random:integer(1, 6) or 0 do
    local crate = thing(10 + 60 * n, 193, 14, 14, random:chance(0.5))
    crate.friction = 0.6
    addFree(game, "movers", "things", crate, -1)
  end
  local keys, dash = newKeys(random, 5, 60), 0
  function game.act()
    local way, rise, isNew = keys()
    dash = isNew and random:chance(0.3) and 8 or dash - 1
    hero.gravity = dash > 0 and 0 or nil
    hero.vx = (dash > 0 and 500 or 130) * way
    if dash > 0 then
      hero.vy = 500 * rise
    elseif hero.y > 208 and rise ~= 0 and random:chance(0.5) then
      hero.vy = 90 * rise
    elseif hero.touching.bottom and random:chance(0.05) then
      hero.vy = -320
    end
    turn(lift, "y", 8, 304)
    turn(train, "x", 8, 408)
  end
  return game
end

-- Round enemies of mixed sizes, by velocity or by acceleration, around a round player that walks,
-- in a room with pillars and walls.
function kinds.arena(random)
  local game = newGame({ gravity = 0 }, 240, 180, 2)
  local kind, size = random:pick({ "plain", "strong", "fixed" }), 2 * random:integer(6, 12)
  local player = thing(110, 80, size, size, true)
  player.strength, player.pushable = kind == "strong" and 1 or nil, kind ~= "fixed" and nil
  game.hero, game.carry, game.vice = add(game, "movers", "players", player), 80, 9
  if kind ~= "plain" then -- it presses others to the walls
    game.machines[1], game.carriers[1] = player, player
  end
  for n = 1, random:integer(0, 6) do
    local x, y = 70 * (n % 3) + random:integer(5, 35), 90 * (n % 2) + random:integer(5, 55)
    size = random:integer(12, 32)
    local isRound = n % 2 == 0 and random:chance(0.6)
    addFree(game, "solids", "pillars", thing(x, y, size, size, isRound), 8)
  end
  local isDriven, speed, drag = random:chance(0.5), random:integer(30, 120), random:integer(0, 300)
  local restitution = random:chance(0.3) and 0.5 or nil
  for n = 1, random:integer(8, random:chance(0.1) and 60 or 25) do
    size = 2 * random:integer(4, 12)
    local enemy = thing((n * 41) % 210 + 5, (n * 67) % 150 + 5, size, size, true)
    enemy.restitution, enemy.mass = restitution, random:pick({ 1, 1, 3 })
    if not isDriven then
      enemy.maxSpeed, enemy.drag = speed, drag
    end
    addFree(game, "movers", "enemies", enemy, 1)
  end
  game.pull = isDriven and 0 or 400
  local keys = newKeys(random, 20, 90)
  function game.act()
    local wayX, wayY = keys()
    player.vx, player.vy = wayX * 80, wayY * 80
    approach(game, player, isDriven and "v" or "a", isDriven and speed or 400)
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

-- The worlds beside one, by name: without rest, pair by pair; restored in the middle.
local function startOthers(kind, seed)
  local plain, restored = games.start(kind, seed), games.start(kind, seed)
  plain.world.broadphase, plain.world.rest = "pairs", false
  for _, other in ipairs({ plain, restored }) do
    watcher.new(other) -- a world that is listened to has other events
  end
  return { plain = plain, restored = restored }
end

--- Plays a game. One of eight is played in two other worlds, too, which must be the same to the
--- last bit.
---@param kind string one of `games.kinds`
---@param seed integer 1 …
---@param isAlone? boolean
---@return table? failure `check`, `text` and `at`, the frame; nil: nothing to notice
function games.play(kind, seed, isAlone)
  local game, dt = games.start(kind, seed)
  local others = not isAlone and seed % COMPARED == 0 and startOthers(kind, seed) or {}
  local watched, frames = watcher.new(game), floor(game.seconds / dt)
  for frame = 1, frames do
    game.act(frame, dt)
    watcher.note(watched, dt)
    game.world:update(dt)
    local check, text = watcher.check(watched, dt)
    if not check then
      check, text = game.check(frame)
    end
    for name, other in pairs(others) do
      other.act(frame, dt)
      if other == others.restored and frame == floor(frames / 2) then
        other.world:restore(other.world:save())
      end
      other.world:update(dt)
      local isCompared = not check and (frame % HASHED == 0 or frame == frames)
      if isCompared and other.world:hash() ~= game.world:hash() then
        check, text = "same", "the hashes differ: " .. name
      end
    end
    if not check and frame == frames then
      check, text = watcher.findStuck(watched)
    end
    if check then
      return { check = check, text = text, at = frame }
    end
  end
end

return games
