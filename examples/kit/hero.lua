-- The hero of a platformer: run, jump, wall jump, dash, crouch, climb. Copy this file, and switch
-- on what you need:
--
--   local player = world:add("players", { x = 40, y = 100, width = 20, height = 30 })
--   player.hero = hero.new({ airJumps = 1, wallSlide = 60, dash = 600 })
--
--   hero.update(world, player, keys, dt)   -- before world:update
--
-- `keys` says what is held: left, right, up, down, jump, dash. All that the hero remembers is in
-- player.hero, as plain values: with `world.ownFields = { "hero" }` it is part of each saved state.
-- With `player.maxSlope = 1.5` steeper slopes are walls, which it slides down and jumps off, too.
-- The settings are there, too, so that an ability that is found later is `player.hero.dash = 600`.

local hero = {}

local NEVER = 1e9 -- s
local LADDER_PAUSE = 0.2 -- s, in which a hero that has jumped off a ladder takes hold of none

-- What is false is off.
local SETTINGS = {
  runSpeed = 230, -- px/s
  runUp = 1800, -- px/s², on the ground: how fast it gets there, and stops
  runUpInAir = 1200, -- px/s²
  keepSpeed = false, -- true: in the air it keeps the speed of the train or belt that it left
  jumpSpeed = 620, -- px/s; the height is jumpSpeed² / (2 * gravity)
  shortJump = 250, -- px/s that are left of a jump when the key is let go
  coyoteTime = 0.08, -- s, in which it may still jump after it has left the ground
  jumpBuffer = 0.1, -- s, for which a jump key that comes too early is remembered
  airJumps = 0, -- 1: double jump
  fallSpeed = false, -- px/s, the highest
  wallSlide = false, -- px/s, at which it slides down a wall that it is steered against
  wallJump = false, -- px/s, away from the wall
  wallLock = 0.15, -- s after a wall jump, in which the keys do not steer
  dash = false, -- px/s; once, until it is on the ground, a wall or a ladder again
  dashTime = 0.15, -- s
  dashThrough = false, -- the group that it passes through meanwhile ("enemies"): by its `mask`
  crouch = false, -- px: its height, while down is held
  crouchSpeed = 0.5, -- share of runSpeed
  climb = false, -- px/s, on ladders
  ladders = "ladders", -- the group of the ladders, which are sensors
  dropThrough = false, -- true: down (with crouch: down and jump) leads through one-way ledges
  gravity = false, -- px/s², another one than the world's
}

-- What it remembers, to begin with.
local MEMORY = {
  isLow = false,
  mood = "air", -- "ground", "air", "wall", "climb" or "dash": for the picture
  direction = 0, -- -1, 0 or 1: where the keys lead
  facing = 1, -- -1 or 1
  locked = 0, -- s, for which the keys do not steer: write it for a knock-back
  isJumping = false, -- a jump that the key may cut short; a spring writes false
  jumpsLeft = 0,
  canDash = true,
  sinceGround = NEVER, -- s
  sinceWall = NEVER,
  sinceJump = NEVER, -- since its key was pressed
  wall = 0, -- -1, 1: where the last wall was
  drift = 0, -- px/s, which what it stood on has given to it
  dashLeft = 0, -- s
  isPassing = false, -- through a group
  ladderPause = 0, -- s
  holdsJump = false, -- the keys of the last frame
  holdsDash = false,
  holdsDown = false,
}

--- Returns what goes into player.hero. Errors: a setting that does not exist.
function hero.new(settings)
  local me = {}
  for name, value in pairs(MEMORY) do
    me[name] = value
  end
  for name, value in pairs(SETTINGS) do
    me[name] = value
  end
  for name, value in pairs(settings or {}) do
    if SETTINGS[name] == nil then
      error(("hero: there is no setting %s"):format(tostring(name)), 2)
    end
    me[name] = value
  end
  return me
end

-- Height -----------------------------------------------------------------------------------------

-- Changes the height with the feet in place.
local function setHeight(player, height)
  player.y, player.height = player.y + player.height - height, height
end

local function crouch(world, player, me, isWanted)
  if isWanted then
    setHeight(player, me.crouch)
  elseif player.height < me.tall then
    local y = player.y + player.height - me.tall
    if world:fits(player.x, y, player.width, me.tall, player) then -- else it stays low: a tunnel
      setHeight(player, me.tall)
    end
  end
end

--- Forgets what it did, and stands up: for a hero that comes back elsewhere.
function hero.reset(player)
  local me = player.hero
  if me.isPassing then
    player.mask = nil
  end
  for name, value in pairs(MEMORY) do
    me[name] = value
  end
  setHeight(player, me.tall or player.height)
  player.vx, player.vy, player.gravity, player.maxFallSpeed = 0, 0, me.gravity or nil, nil
end

-- What is around it ------------------------------------------------------------------------------

local function isWall(other)
  return other and (other.static or other.kinematic)
end

local function sense(world, player, me, keys, dt)
  local touching = player.touching
  local ground = player.vy >= 0 and touching.bottom
  me.direction = (keys.right and 1 or 0) - (keys.left and 1 or 0)
  if me.direction ~= 0 and me.locked <= 0 and me.dashLeft <= 0 then
    me.facing = me.direction
  end
  me.sinceJump = keys.jump and not me.holdsJump and 0 or me.sinceJump + dt
  me.sinceGround, me.sinceWall = me.sinceGround + dt, me.sinceWall + dt
  local isAtWall = isWall(touching.right) and me.direction > 0
    or isWall(touching.left) and me.direction < 0
  if ground then
    me.sinceGround, me.sinceWall = 0, NEVER
    me.drift = me.keepSpeed and world:velocity(player) - player.vx or 0
  elseif isAtWall then
    me.sinceWall, me.wall, me.drift = 0, me.direction, 0
  end
  if ground or me.mood == "climb" or isAtWall and (me.wallSlide or me.wallJump) then
    me.jumpsLeft, me.canDash = me.airJumps, true
  end
  me.locked, me.ladderPause = math.max(0, me.locked - dt), math.max(0, me.ladderPause - dt)
  return ground
end

-- Is there a ladder where it is, or below the ledge at its upper end?
local function findLadder(world, player, me, keys, ground)
  local _, count = world:overlapping(player, me.ladders)
  if count == 0 and keys.down and ground and ground.oneWay then
    local y = player.y + player.height + 1
    _, count = world:queryRect(player.x, y, player.width, 1, me.ladders)
    return count > 0 and world:dropThrough(player)
  end
  local isAtLowerEnd = ground and keys.down
  return count > 0 and not isAtLowerEnd and (me.mood == "climb" or keys.up or keys.down)
end

-- What it does -----------------------------------------------------------------------------------

local function leap(player, me)
  player.vy, me.isJumping = -me.jumpSpeed, true
  me.sinceJump, me.sinceGround, me.sinceWall = NEVER, NEVER, NEVER
end

-- A key that was pressed a moment ago counts, and so does the ground or wall of a moment ago.
local function jump(player, me)
  if me.sinceJump > me.jumpBuffer then
    return
  elseif me.mood == "climb" then
    leap(player, me)
    me.mood, me.ladderPause = "air", LADDER_PAUSE
  elseif me.sinceGround <= me.coyoteTime then
    leap(player, me)
  elseif me.wallJump and me.sinceWall <= me.coyoteTime then
    leap(player, me)
    player.vx, me.locked, me.facing = -me.wall * me.wallJump, me.wallLock, -me.wall
  elseif me.jumpsLeft > 0 then
    leap(player, me)
    me.jumpsLeft = me.jumpsLeft - 1
  end
end

local function run(player, me, isOnGround, dt)
  if me.locked > 0 then
    return
  end
  local speed = me.runSpeed * (isOnGround and me.isLow and me.crouchSpeed or 1)
  local missing = me.direction * speed + (isOnGround and 0 or me.drift) - player.vx
  local most = (isOnGround and me.runUp or me.runUpInAir) * dt
  player.vx = player.vx + math.max(-most, math.min(most, missing))
end

local function startDash(me, keys)
  if me.dash and me.canDash and keys.dash and not me.holdsDash then
    me.dashLeft, me.canDash, me.isJumping = me.dashTime, false, false
    me.facing = me.direction ~= 0 and me.direction or me.facing
  end
end

-- Returns the mood, which decides on gravity and the fall: so no ability undoes another.
local function choose(world, player, me, keys, ground, dt)
  startDash(me, keys)
  if me.dashLeft > 0 then
    me.dashLeft = me.dashLeft - dt
    player.vx, player.vy = me.facing * (me.dashLeft > 0 and me.dash or me.runSpeed), 0
    return me.dashLeft > 0 and "dash" or "air"
  elseif me.climb and me.ladderPause <= 0 and findLadder(world, player, me, keys, ground) then
    local way = (keys.down and 1 or 0) - (keys.up and 1 or 0)
    player.vx, player.vy, me.isJumping = me.direction * me.climb, way * me.climb, false
    return "climb"
  elseif me.mood == "climb" then
    player.vy = 0 -- no hop at the upper end
  end
  if ground then
    return "ground"
  end
  return me.wallSlide and me.sinceWall == 0 and player.vy > 0 and "wall" or "air"
end

local function drop(world, player, me, keys, ground)
  local isAsked = keys.down and not me.holdsDown
  if me.crouch then
    isAsked = keys.down and me.sinceJump == 0
  end
  if me.dropThrough and isAsked and ground and ground.oneWay and world:dropThrough(player) then
    me.sinceJump, me.sinceGround = NEVER, NEVER
  end
end

-- Also behind the dash it passes through, until it is out of all.
local function pass(world, player, me)
  if me.mood == "dash" then
    player.mask, me.isPassing = { [me.dashThrough] = false }, true
  elseif me.isPassing then
    local _, count = world:overlapping(player, me.dashThrough)
    if count == 0 then
      player.mask, me.isPassing = nil, false
    end
  end
end

--- Steers a player for the next step of dt s. To be called before `world:update`, or in `onStep`.
function hero.update(world, player, keys, dt)
  local me = player.hero
  me.tall = me.tall or player.height
  local ground = sense(world, player, me, keys, dt)
  local mood = choose(world, player, me, keys, ground, dt)
  me.mood = mood
  if me.crouch then
    me.isLow = player.height < me.tall
    crouch(world, player, me, keys.down and mood ~= "climb" and (mood == "ground" or me.isLow))
    me.isLow = player.height < me.tall
  end
  if mood ~= "dash" then
    drop(world, player, me, keys, ground)
    jump(player, me)
    if mood ~= "climb" then
      run(player, me, mood == "ground", dt)
    end
  end
  if me.isJumping and not keys.jump then
    player.vy, me.isJumping = math.max(player.vy, -me.shortJump), false
  end
  if me.dashThrough then
    pass(world, player, me)
  end
  local floats = mood == "dash" or me.mood == "climb"
  player.gravity = floats and 0 or me.gravity or nil
  player.maxFallSpeed = mood == "wall" and me.wallSlide or me.fallSpeed or nil
  me.holdsJump, me.holdsDash = keys.jump or false, keys.dash or false
  me.holdsDown = keys.down or false
end

--- Puts a one-way ledge at the upper end of each ladder that has none above it, so that a hero can
--- stand there. For ladders that are many tiles, too. `group`: of the ladders ("ladders").
function hero.capLadders(world, group)
  for _, ladder in ipairs(world.objects[group or "ladders"] or {}) do
    local x, y, width = ladder.x, ladder.y, ladder.width
    local _, count = world:queryRect(x + 1, y - 2, width - 2, 1, group or "ladders")
    if count == 0 then
      local ledge = { x = x, y = y, width = width, height = 8, static = true, oneWay = "top" }
      world:add("ladderTops", ledge)
    end
  end
end

return hero
