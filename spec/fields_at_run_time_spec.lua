--- Fields that the game sets and takes back while the world runs, also of an object that had none
--- of them: the next update must notice, as if it had been told by `refresh`.

local fields = require("physics.fields.fields")
local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local small = require("spec.support.small")

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
local OTHERS = "x y width height area vx vy static carry touching snap slope maxSlope constantSpeed"
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

local function playTwice(set, takeBack)
  return playAt(TIMES[1], set, takeBack) .. playAt(TIMES[2], set, takeBack)
end

local function nothing() end

-- What happens when nothing is set; each spec is compared with it.
local untouched
local function playUntouched()
  untouched = untouched or playTwice(nothing, nothing)
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

describe("every field: of an object that had none", function()
  it("is in one of the lists of this spec", function()
    for _, field in ipairs(fields.objects) do
      assert.is_true(VALUES[field.name] ~= nil or OTHERS:find(field.name .. " ", 1, true) ~= nil)
    end
  end)

  for name, value in pairs(VALUES) do
    it("is noticed when it is set, and when it is taken back: " .. name, function()
      local set = playTwice(write(name, value), nothing)
      assert.are_not.equal(playUntouched(), set)
      assert.equal(playTwice(writeAndTell(name, value), nothing), set)
      local takenBack = playTwice(write(name, value), write(name, nil))
      assert.are_not.equal(set, takenBack)
      assert.equal(playTwice(writeAndTell(name, value), writeAndTell(name, nil)), takenBack)
    end)
  end

  it("tells of contacts from the next update on, and as long as it is there", function()
    local player, count = build(), 0
    player.box.vx = 0
    player.world:remove(player.others[2])
    small.run(player.world, LAST)
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

local box = scene.thing("boxes", { name = "box", x = 0, y = 84, width = 16, height = 16 })
local solid = scene.maker("tiles", { static = true })
local FLOOR = solid("floor", -200, 100, 800, 16)
local STANDS = { FLOOR, box() }

local row = play.once({
  DT = DT,
  down = { boxes = { tiles = false } },
  up = { tiles = { boxes = false } },
})

describe("every field and setting at run time:", function()
  row("vx and vy become numbers", STANDS, {
    { steps = 2 },
    "box.raw.vx == 0; box.raw.vy == 0",
    { "box.raw.vx, box.raw.vy = nil, nil", { steps = 1 }, "box.raw.vx == 0", "box.raw.vy == 0" },
  })

  -- Fields of a box that stands at y = 84 (`nil` takes away), for how many steps, where it is then.
  row("{what}", STANDS, {
    { steps = 5 },
    "{first}",
    { time = "steps / 60" },
    "box.y ~ y, 1e-9",
    "{second}",
    { time = "steps2 / 60" },
    "box.y ~ y2, 1e-9; box.touching.bottom == floor",
  }, {
    "what, first, steps, y, second, steps2, y2",
    { "height and y", "box.height, box.y = 24, 76", 5, 76, "box.height = 8", 30, 92 },
    { "width, x and y", "box.x, box.y, box.width = 300, -50, 32", 1, -50 + 1 / 9, "", 60, 84 },
    { "height, into the floor: it leaves upwards", "", 5, 84, "box.height = 20", 5, 80 },
    { "masks", "world.masks = down", 30, 184, "box.y, box.vy, world.masks = 0, 0, {}", 60, 84 },
    { "masks, the other way", "world.masks = up", 30, 184, "box.y, world.masks = 0, nil", 60, 84 },
  })

  -- Far away it has not been tested yet whether the two can meet.
  row("mask of a static object is read once, {x} px away", function(v)
    v.mask = { boxes = true }
    local wall = solid("wall", v.x, 0, 10, 10, { mask = v.mask })
    return { gravity = 0, wall, box({ y = 0, width = 10, height = 10, vx = 600 }) }
  end, {
    { steps = 1 },
    { "mask.boxes = false", "world:explain(box.raw, wall.raw):find('mask', 1, true) == nil" },
    1,
    "box.x == x - 10",
    { "world:refresh(wall.raw)", "box.vx = 600", { steps = 1 }, "box.x == x" },
  }, { "x", { 26 }, { 300 } })
end)

-- Each set of fields has a function that compares objects (readFields). One that says "it may have
-- changed" of an object that has not changed is slow in each update from then on.
describe("mass, sensor and the others: a field", function()
  local function isFound(world, object)
    local b = world._bodies
    local i = b.slotOf[object]
    return b.comparer[i](b, i, object) == true
  end

  local title = "is compared at once after its default was written: {1}"
  small.rows(title, { "sensor", "mass" }, function(name)
    local world = small.still()
    local object = world:add("boxes", small.box(0, 0))
    world:update(DT)
    object[name] = fields.objectByName[name].default
    world:update(DT)
    assert.is_true(isFound(world, object))
    object[name] = nil
    world:update(DT)
    assert.is_true(isFound(world, object))
  end)

  it("is compared at once in a game of many sets of fields", function()
    local world, object = small.still(), nil
    local names = { "mass", "friction", "restitution", "drag", "strength", "snap", "nudge", "ax" }
    for n = 0, 255 do
      object = small.box(20 * n, 0)
      for bit, name in ipairs(names) do
        object[name] = math.floor(n / 2 ^ bit) % 2 == 1 and 0.5 or nil
      end
      world:add("boxes", object)
    end
    world:update(DT)
    assert.is_true(isFound(world, object))
  end)
end)
