--- Fields that the game sets and takes back while the world runs, on an object that had none of
--- them: the next update must notice, as if it had been told by `refresh`.

local fields = require("physics.fields.fields")
local physics = require("physics")

local DT = 1 / 60
-- Before which update something happens. An object that is put elsewhere is read anew, so a field
-- is set (and taken back) before that as well as after it.
local JUMP, LAND, LAST = 52, 116, 200
local TIMES = { { set = 3, takeBack = 50 }, { set = 120, takeBack = 150 } }

local function never()
  return false
end

-- What is set; each must make a difference in the scene below.
local VALUES = {
  active = false,
  kinematic = true,
  sensor = true,
  pushable = false,
  oneWay = "top",
  mask = { floors = false },
  canCollide = never,
  gravity = 0,
  gravityX = 100,
  ax = 50,
  ay = -900,
  mass = 5,
  friction = 0.9,
  restitution = 0.8,
  airFriction = 3,
  drag = 100,
  maxSpeed = 20,
  maxSpeedX = 10,
  maxSpeedY = 20,
  surfaceSpeed = 40,
  nudge = 4,
  maxFallSpeed = 20,
  radius = 8,
  strength = 2,
  hits = { "others" },
}

-- Not here: where and how large it is, what a dynamic object does not feel, callbacks. (Slopes are
-- refused, and the scene has no stairs for `snap`.)
local OTHERS = "x y width height area vx vy static carry touching snap slope constantSpeed"
  .. " onBegin onStay onEnd onCrush "

-- A box that jumps against the corner of a ceiling, falls to the floor, jumps once more, gets
-- another one on top, and is pushed by a third. Returns the world, changing objects, events.
local function build()
  local world = physics.newWorld({ gravity = 800 })
  world:add("floors", { x = -400, y = 100, width = 900, height = 20, static = true })
  world:add("ceilings", { x = 54, y = 20, width = 60, height = 8, static = true })
  local box = world:add("boxes", { x = 40, y = 60, width = 16, height = 16, vx = -1, vy = -300 })
  local others = {
    world:add("boxes", { x = 300, y = 86, width = 14, height = 14, friction = 0.5 }),
    world:add("boxes", { x = -370, y = 84, width = 16, height = 16, vx = 120, ax = 60 }),
  }
  local log = {}
  local function note()
    for _, object in ipairs({ box, others[1], others[2] }) do
      log[#log + 1] = ("%.17g %.17g %.17g %.17g"):format(object.x, object.y, object.vx, object.vy)
    end
  end
  return { world = world, box = box, others = others, log = log, note = note }
end

-- Plays the scene; `set` and `takeBack` are called at their times. Returns what happened.
local function playAt(times, set, takeBack)
  local player = build()
  for n = 1, LAST do
    if n == times.set then
      set(player)
    elseif n == times.takeBack then
      takeBack(player)
    elseif n == JUMP then
      player.box.x, player.box.y, player.box.vy = 40, 84, -400
    elseif n == LAND then
      player.others[1].x, player.others[1].y = player.box.x, player.box.y - 20
    end
    player.world:update(DT)
    player.note()
  end
  return table.concat(player.log, "\n")
end

local function play(set, takeBack)
  return playAt(TIMES[1], set, takeBack) .. playAt(TIMES[2], set, takeBack)
end

local function nothing() end

-- What happens when nothing is set; each spec is compared with it.
local untouched
local function playUntouched()
  untouched = untouched or play(nothing, nothing)
  return untouched
end

local function write(name, value)
  return function(player)
    player.box[name] = value
  end
end

local function writeAndTell(name, value)
  return function(player)
    player.box[name] = value
    player.world:refresh(player.box)
  end
end

describe("a field of an object that had none", function()
  it("is in one of the lists of this spec", function()
    for _, field in ipairs(fields.objects) do
      assert.is_true(VALUES[field.name] ~= nil or OTHERS:find(field.name .. " ", 1, true) ~= nil)
    end
  end)

  for name, value in pairs(VALUES) do
    it("is noticed when it is set, and when it is taken back: " .. name, function()
      local set = play(write(name, value), nothing)
      assert.are_not.equal(playUntouched(), set)
      assert.equal(play(writeAndTell(name, value), nothing), set)
      local takenBack = play(write(name, value), write(name, nil))
      assert.are_not.equal(set, takenBack)
      assert.equal(play(writeAndTell(name, value), writeAndTell(name, nil)), takenBack)
    end)
  end

  it("tells of contacts from the next update on, and as long as it is there", function()
    local player, count = build(), 0
    player.box.vx = 0
    player.world:remove(player.others[2])
    for _ = 1, LAST do
      player.world:update(DT)
    end
    local function listen()
      count = count + 1
    end
    player.box.onStay = listen
    player.world:update(DT)
    assert.is_true(count > 0)
    player.box.onStay = nil
    local told = count
    player.world:update(DT)
    player.world:update(DT)
    assert.equal(told, count)
    assert.equal(2, player.world.stats.resting)
    player.box.onStay = listen
    player.world:update(DT)
    assert.is_true(count > told)
  end)
end)
