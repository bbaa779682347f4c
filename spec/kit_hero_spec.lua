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
  local all = {}
  for _, list in ipairs({ BASE, settings }) do
    for name, value in pairs(list) do
      all[name] = value
    end
  end
  local player = { x = 100, y = 360, width = 20, height = 40, hero = hero.new(all) }
  for name, value in pairs(start or {}) do
    player[name] = value
  end
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
      seen.moods = seen.moods .. " " .. mood
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
local WALL = { "walls", 160, 0, 40, 400 }
local LADDER = { "ladders", 100, 200, 20, 200, SENSOR }
local TRAIN = { "trains", 0, 384, 300, 16, { kinematic = true, vx = 150 } }
local BELT = { "belts", 0, 384, 400, 16, { static = true, surfaceSpeed = 150 } }

-- name, settings, objects, keys, frames, what is expected, fields of the hero at the beginning.
-- Expected: fields of the player, `rise`, `low`, `moods`. A list of two numbers: between them.
local ROWS = {
  { "runs, and stops", {}, {}, "right:1-30", 60, { vx = 0, x = { 195, 203 } } },
  { "runs up to its speed", { runUp = 600 }, {}, "right:1-10", 10, { vx = 100 } },
  { "jumps as high as its speed says", {}, {}, "jump:1-60", 60, { rise = { 111, 113 } } },
  { "jumps once for a key", {}, {}, "jump:1-200", 200, { y = 360, moods = " ground air ground" } },
  {
    "jumps lower if the key is let go",
    { shortJump = 200 },
    {},
    "jump:1-3",
    60,
    { rise = { 30, 45 } },
  },
  {
    "jumps when the key came early",
    {},
    {},
    "jump:10-40",
    30,
    { rise = { 80, 120 } },
    { y = 310 },
  },
  {
    "does not jump when it came too early",
    { jumpBuffer = 0.02 },
    {},
    "jump:10-40",
    30,
    { y = 360 },
    { y = 290 },
  },
  {
    "jumps a moment after the edge: coyote time",
    {},
    { { "ledges", 60, 300, 60, 20 } },
    "right:1-60 jump:10-40",
    20,
    { rise = { 160, 213 } },
    { y = 260 },
  },
  {
    "does not jump long after the edge",
    { coyoteTime = 0 },
    { { "ledges", 60, 300, 60, 20 } },
    "right:1-60 jump:12-40",
    24,
    { rise = { 100, 100 } },
    { y = 260 },
  },
  {
    "jumps again in the air",
    { airJumps = 1 },
    {},
    "jump:1-20 jump:24-34 jump:40-60",
    100,
    { rise = { 215, 226 } },
  },
  { "falls at most as fast as said", { fallSpeed = 300 }, {}, "", 40, { vy = 300 }, { y = 0 } },
  {
    "slides down a wall that it is steered against",
    { wallSlide = 60 },
    { WALL },
    "right:1-60",
    40,
    { vy = 60, moods = " air wall" },
    { y = 200, x = 140 },
  },
  {
    "slides down a slope that is steeper than its maxSlope, and jumps off it",
    { wallSlide = 60, wallJump = 200 },
    { { "slopes", 140, 0, 100, 400, { static = true, slope = "right" } } },
    "right:1-60 jump:40-60",
    45,
    { vx = -200, moods = " air wall air" },
    { y = 160, x = 168, maxSlope = 2 },
  },
  {
    "does not slide if it is not steered",
    { wallSlide = 60 },
    { WALL },
    "",
    20,
    { moods = " air", vy = { 400, 600 } },
    { y = 0, x = 140 },
  },
  {
    "jumps off a wall, and for a moment cannot come back",
    { wallSlide = 60, wallJump = 200, wallLock = 0.2 },
    { WALL },
    "right:1-60 jump:20-60",
    31,
    { vx = -200, x = { 100, 110 }, rise = { 180, 260 } },
    { y = 200, x = 140 },
  },
  {
    "dashes in a straight line, once in the air",
    { dash = 600, dashTime = 0.1 },
    {},
    "dash:1-1 dash:15-15 right:1-1",
    20,
    { x = { 155, 165 }, moods = " dash air" },
    { y = 0 },
  },
  {
    "dashes through an enemy, and is not stopped by the next one before it is out",
    { dash = 600, dashTime = 0.1, dashThrough = "enemies" },
    { { "enemies", 130, 360, 20, 40, { pushable = false } }, { "enemies", 220, 360, 20, 40 } },
    "dash:1-1 right:1-60",
    60,
    { x = 200, vx = 0 },
  },
  {
    "crouches, and is slower",
    { crouch = 20 },
    {},
    "down:1-30 right:10-30",
    30,
    { height = 20, y = 380, vx = 100, low = 20 },
  },
  { "stands up again", { crouch = 20 }, {}, "down:1-30", 32, { height = 40, y = 360 } },
  {
    "stays low where there is no room",
    { crouch = 20 },
    { { "walls", 110, 360, 100, 15 } },
    "down:1-30 right:5-50",
    50,
    { height = 20, y = 380 },
    { x = 80 },
  },
  {
    "stands up behind a tunnel",
    { crouch = 20 },
    { { "walls", 110, 360, 100, 15 } },
    "down:1-30 right:5-120",
    120,
    { height = 40, y = 360 },
    { x = 80 },
  },
  { "climbs a ladder", { climb = 120 }, { LADDER }, "up:1-30", 30, { y = 300, vy = -120 } },
  {
    "stays on a ladder without a key",
    { climb = 120 },
    { LADDER },
    "up:1-30",
    60,
    { y = 300, vy = 0, moods = " climb" },
  },
  {
    "stands at the upper end of a ladder",
    { climb = 120 },
    { LADDER },
    "up:1-200",
    200,
    { y = 160, moods = " climb air ground", rise = { 200, 204 } },
  },
  {
    "climbs down from there, to the ground",
    { climb = 120 },
    { LADDER },
    "down:5-200",
    200,
    { y = 360, moods = " ground climb ground" },
    { y = 160 },
  },
  {
    "jumps off a ladder, with up held",
    { climb = 120 },
    { LADDER },
    "up:1-60 jump:20-30 right:20-60",
    26,
    { vy = { -600, -300 }, moods = " climb air" },
  },
  {
    "drops through a ledge",
    { dropThrough = true },
    { { "ledges", 60, 240, 90, 10, LEDGE }, { "ledges", 60, 340, 90, 10, LEDGE } },
    "down:5-100",
    60,
    { y = 300 },
    { y = 200 },
  },
  {
    "drops with down and jump if it can crouch",
    { dropThrough = true, crouch = 20 },
    { { "ledges", 60, 300, 90, 10, LEDGE } },
    "down:5-60 jump:20-30",
    60,
    { y = 380, height = 20 },
    { y = 260 },
  },
  {
    "keeps the speed of a train in a jump",
    { keepSpeed = true },
    { TRAIN },
    "jump:10-30",
    30,
    { vx = 150, x = { 174, 178 } },
    { y = 344 },
  },
  { "leaves it behind without", {}, { TRAIN }, "jump:10-30", 30, { vx = 0 }, { y = 344 } },
  {
    "keeps the speed of a belt, and steers against it",
    { keepSpeed = true },
    { BELT },
    "jump:10-30 left:20-30",
    30,
    { vx = -50 },
    { y = 344 },
  },
}

local function check(expected, found, what)
  if type(expected) == "table" then
    assert(
      found >= expected[1] and found <= expected[2],
      ("%s is %s"):format(what, tostring(found))
    )
  elseif type(expected) == "number" then
    assert.near(expected, found, 1e-6, what)
  else
    assert.equal(expected, found, what)
  end
end

describe("examples/kit/hero.lua: a hero", function()
  small.rows("{1}", ROWS, function(_, settings, objects, keys, frames, expected, start)
    local player, seen = play(settings, objects, keys, frames, start)
    for name, value in pairs(expected) do
      check(value, player[name] or seen[name], name)
    end
    assert.equal(0, seen.crushed)
  end)

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
local ALL = {
  airJumps = 1,
  wallSlide = 60,
  wallJump = 200,
  dash = 500,
  crouch = 20,
  climb = 120,
  dropThrough = true,
  keepSpeed = true,
  fallSpeed = 700,
}
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

describe("examples/kit/hero.lua: everything at once", function()
  it("owns gravity and its height in each mood, and the same state plays the same", function()
    for seed = 1, 6 do
      local world, state, hash
      local player, seen = play(ALL, PLACE, "", 1)
      world = seen.world
      local lift = world.objects.lifts[1]
      local keys, replayed = randomKeys(seed * 1000), nil
      local moods = {}
      local function step(_)
        lift.vy = lift.y < 200 and 40 or lift.y > 380 and -40 or lift.vy
        hero.update(world, player, replayed() or {}, DT)
      end
      replayed = keys
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
      state = world:save()
      replayed = randomKeys(77)
      kit.play(world, 60, step)
      hash = world:hash()
      world:restore(state)
      replayed = randomKeys(77)
      kit.play(world, 60, step)
      assert.equal(hash, world:hash())
      assert.equal(0, seen.crushed)
      assert.is_true(moods.ground and moods.air and moods.dash)
    end
  end)
end)
