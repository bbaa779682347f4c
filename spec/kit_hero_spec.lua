--- examples/kit/hero.lua: each ability, and all at once.

local hero = require("examples.kit.hero")
local kit = require("spec.support.kit")
local small = require("spec.support.small")

local DT = 1 / 60

-- With gravity 1600 a jump of 600 px/s is 112.5 px high, less what the first step takes.
local BASE = { runSpeed = 200, jumpSpeed = 600, runUp = 6000, runUpInAir = 6000 }

-- Plays a hero of 20 x 40 px that stands at x 100; `start`: other fields of it. Returns it, and
-- what was seen: `rise`, the most above the floor; `moods`, one after the other; `low`, its least
-- height.
local function play(settings, objects, keys, frames, start, each)
  local world = kit.world(objects, { "hero" })
  local player = small.set(small.put(100, 360, 20, 40), start)
  player.hero = hero.new(small.set(small.set({}, BASE), settings))
  world:add("players", player)
  hero.capLadders(world)
  world:update(DT)
  local held, seen = kit.keys(keys), { rise = 0, moods = "", low = 40, world = world, crushed = 0 }
  player.onCrush = function()
    seen.crushed = seen.crushed + 1
  end
  kit.play(world, frames, function(frame)
    hero.update(world, player, held(frame), DT)
    local mood = player.hero.mood
    if not seen.moods:find(mood .. "$") then
      seen.moods = seen.moods:gsub(".$", "%0,") .. mood
    end
    seen.rise = math.max(seen.rise, 360 - player.y)
    seen.low = math.min(seen.low, player.height)
    if each then
      each(world, player, frame)
    end
  end)
  return player, seen
end

local LEDGE = { static = true, oneWay = "top" }
local SENSOR = { static = true, sensor = true }

-- What stands in the place of a row, by its name there.
local THINGS = {
  belt = { "belts", 0, 384, 400, 16, { static = true, surfaceSpeed = 150 } },
  boss = { "enemies", 130, 360, 20, 40, { pushable = false } },
  edge = { "ledges", 60, 300, 60, 20 },
  foe = { "enemies", 220, 360, 20, 40 },
  high = { "ledges", 60, 240, 90, 10, LEDGE },
  ladder = { "ladders", 100, 200, 20, 200, SENSOR },
  ledge = { "ledges", 60, 300, 90, 10, LEDGE },
  low = { "ledges", 60, 340, 90, 10, LEDGE },
  slope = { "slopes", 140, 0, 100, 400, { static = true, slope = "right" } },
  train = { "trains", 0, 384, 300, 16, { kinematic = true, vx = 150 } },
  tunnel = { "walls", 110, 360, 100, 15 },
  wall = { "walls", 160, 0, 40, 400 },
}

-- What it does | keys | frames | what is expected | settings | its fields at the beginning | things
-- there. Expected are fields of the player, `rise`, `low` and `moods`; "1..2" is between them.
local ROWS = [[
runs, and stops | right:1-30 | 60 | vx=0 x=195..203
runs up to its speed | right:1-10 | 10 | vx=100 | runUp=600
jumps as high as its speed says | jump:1-60 | 60 | rise=111..113
jumps once for a key | jump:1-200 | 200 | y=360 moods=ground,air,ground
jumps lower if the key is let go | jump:1-3 | 60 | rise=30..45 | shortJump=200
jumps when the key came early | jump:10-40 | 30 | rise=80..120 | | y=310
does not jump when it came too early | jump:10-40 | 30 | y=360 | jumpBuffer=0.02 | y=290
jumps a moment after the edge | right:1-60 jump:10-40 | 20 | rise=160..213 | | y=260 | edge
does not, long after | right:1-60 jump:12-40 | 24 | rise=100..100 | coyoteTime=0 | y=260 | edge
jumps again in the air | jump:1-20 jump:24-34 jump:40-60 | 100 | rise=215..226 | airJumps=1
falls at most as fast as said | | 40 | vy=300 | fallSpeed=300 | y=0
slides down a wall | right:1-60 | 40 | vy=60 moods=air,wall | wallSlide=60 | y=200 x=140 | wall
slides down a slope that is steeper than its maxSlope, and jumps off it | right:1-60 jump:40-60 | 45
  | vx=-200 moods=air,wall,air | wallSlide=60 wallJump=200 | y=160 x=168 maxSlope=2 | slope
does not slide if it is not steered | | 20 | moods=air vy=400..600 | wallSlide=60 | y=0 x=140 | wall
jumps off a wall, and for a moment cannot come back | right:1-60 jump:20-60 | 31
  | vx=-200 x=100..110 rise=180..260 | wallSlide=60 wallJump=200 wallLock=0.2 | y=200 x=140 | wall
dashes in a straight line, once in the air | dash:1-1 dash:15-15 right:1-1 | 20
  | x=155..165 moods=dash,air | dash=600 dashTime=0.1 | y=0
dashes through an enemy, and is not stopped by the next one before it is out
  | dash:1-1 right:1-60 | 60 | x=200 vx=0 | dash=600 dashTime=0.1 dashThrough=enemies | | boss foe
crouches, and is slower | down:1-30 right:10-30 | 30 | height=20 y=380 vx=100 low=20 | crouch=20
stands up again | down:1-30 | 32 | height=40 y=360 | crouch=20
stays low without room | down:1-30 right:5-50 | 50 | height=20 y=380 | crouch=20 | x=80 | tunnel
stands up behind | down:1-30 right:5-120 | 120 | height=40 y=360 | crouch=20 | x=80 | tunnel
climbs a ladder | up:1-30 | 30 | y=300 vy=-120 | climb=120 | | ladder
stays on a ladder without a key | up:1-30 | 60 | y=300 vy=0 moods=climb | climb=120 | | ladder
stands at the upper end of a ladder | up:1-200 | 200
  | y=160 moods=climb,air,ground rise=200..204 | climb=120 | | ladder
climbs down, to the ground | down:5-200 | 200
  | y=360 moods=ground,climb,ground | climb=120 | y=160 | ladder
jumps off a ladder, with up held | up:1-60 jump:20-30 right:20-60 | 26
  | vy=-600..-300 moods=climb,air | climb=120 | | ladder
drops through a ledge | down:5-100 | 60 | y=300 | dropThrough=true | y=200 | high low
drops with down and jump if it can crouch | down:5-60 jump:20-30 | 60
  | y=380 height=20 | dropThrough=true crouch=20 | y=260 | ledge
keeps the speed of a train in a jump | jump:10-30 | 30
  | vx=150 x=174..178 | keepSpeed=true | y=344 | train
leaves it behind without | jump:10-30 | 30 | vx=0 | | y=344 | train
keeps that of a belt, and steers against it | jump:10-30 left:20-30 | 30
  | vx=-50 | keepSpeed=true | y=344 | belt
]]

-- A table of "a=1 b=2..3 c=word".
local function read(text)
  local values = {}
  for name, value in text:gmatch("(%w+)=(%S+)") do
    local low, high = value:match("^(.+)%.%.(.+)$")
    values[name] = low and { tonumber(low), tonumber(high) } or tonumber(value) or value
  end
  return values
end

describe("examples/kit/hero.lua: a hero", function()
  for row in ROWS:gsub("\n  |", " |"):gmatch("[^\n]+") do
    local parts = {}
    for part in (row .. " |  |  |  |"):gmatch("(.-) |") do
      parts[#parts + 1] = part
    end
    local title, keys, frames, expected, settings, start, things = small.unpack(parts)
    it(title, function()
      local objects = {}
      for name in things:gmatch("%a+") do
        objects[#objects + 1] = THINGS[name]
      end
      local player, seen = play(read(settings), objects, keys, tonumber(frames), read(start))
      for name, value in pairs(read(expected)) do
        kit.check(value, player[name] or seen[name], name)
      end
      assert.equal(0, seen.crushed)
    end)
  end

  it("refuses a setting that does not exist", function()
    assert.has_error(function()
      hero.new({ jumpHeight = 3 })
    end, "hero: there is no setting jumpHeight")
  end)

  it("is as new after a reset", function()
    local player = play({ crouch = 20, dash = 600 }, {}, "down:1-9 right:1-9 dash:5-9", 9)
    hero.reset(player)
    assert.same({ 40, 360, 0 }, { player.height, player.y, player.vx })
    assert.is_nil(player.gravity)
    assert.equal(0, player.hero.dashLeft)
  end)
end)

-- All abilities, in a place with everything, by keys at random.
local ALL = read("airJumps=1 wallSlide=60 wallJump=200 dash=500 crouch=20 climb=120 fallSpeed=700")
ALL.dropThrough, ALL.keepSpeed = true, true
local PLACE = {
  { "walls", -60, 0, 40, 400 },
  { "walls", 500, 0, 40, 400 },
  { "walls", 300, 360, 80, 15 },
  { "ledges", 60, 300, 90, 10, LEDGE },
  { "ladders", 200, 200, 20, 100, SENSOR },
  { "ladders", 200, 300, 20, 100, SENSOR },
  { "belts", 380, 384, 60, 16, { static = true, surfaceSpeed = -80 } },
  { "lifts", 440, 384, 60, 16, { kinematic = true, vy = -40 } },
}

local function randomKeys(seed)
  local held = {}
  return function()
    seed = seed * 16807 % 2147483647
    local names = { "left", "right", "up", "down", "jump", "dash" }
    local name = names[seed % 6 + 1]
    if seed % 7 == 0 then
      held[name] = not held[name]
    end
    return held
  end
end

it("examples/kit/hero.lua owns gravity and height in each mood; a state plays the same", function()
  for seed = 1, 6 do
    local player, seen = play(ALL, PLACE, "", 1)
    local world, moods, replayed = seen.world, {}, randomKeys(seed * 1000)
    local lift = world.objects.lifts[1]
    local function step()
      lift.vy = lift.y < 200 and 40 or lift.y > 380 and -40 or lift.vy
      hero.update(world, player, replayed() or {}, DT)
    end
    kit.play(world, 400, function()
      step()
      local mood = player.hero.mood
      local isFree = mood ~= "dash" and mood ~= "climb"
      moods[mood] = true
      assert.equal(isFree, player.gravity == nil, mood)
      assert.equal(mood == "wall", player.maxFallSpeed == 60, mood)
      assert.is_true(player.height == 40 or player.height == 20)
      assert.is_true(player.x > -20.001 and player.x < 480.001 and player.y < 380.001)
    end)
    local state, hash = world:save(), nil
    for _ = 1, 2 do
      world:restore(state)
      replayed = randomKeys(77)
      kit.play(world, 60, step)
      hash = hash or world:hash()
    end
    assert.same({ hash, 0 }, { world:hash(), seen.crushed })
    assert.is_true(moods.ground and moods.air and moods.dash)
  end
end)
