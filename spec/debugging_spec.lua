--- Debugging: what the setting `checked` finds, in which words, and what `explain` says. (Drawing
--- and errors have files of their own.)

local physics = require("physics")
local small = require("spec.support.small")

local sized = small.put

local DT = 1 / 60

local function newWorld(settings)
  settings = settings or {}
  settings.checked = true
  local world = physics.newWorld(settings)
  local floor = world:add("floors", { x = 0, y = 100, width = 200, height = 10, static = true })
  local box = world:add("boxes", { x = 20, y = 80, width = 10, height = 10 })
  world:update(DT)
  return world, floor, box
end

-- Makes an update that must be refused, with this message, naming this file, moving nothing.
local function refusesStep(world, expected, dt)
  local box = world.objects.boxes[1]
  local x, y, vx, vy = box.x, box.y, box.vx, box.vy
  for _ = 1, 2 do
    local isDone, message = pcall(function()
      world:update(dt or DT)
    end)
    assert.is_false(isDone, "it was not refused: " .. expected)
    assert.equal(expected, message:match("debugging_spec%.lua:%d+: physics: (.*)$") or message)
    assert.same({ x, y, vx, vy }, { box.x, box.y, box.vx, box.vy })
  end
end

local BY_HAND = ": a static object is read only once, so call world:refresh(object)"
local ONE_WAY = ": one-way objects are static or kinematic; a dynamic one falls through the floor"
local NOTHING = " refuses nothing: true collides, as nil does, and false passes through"

-- What makes it fine: masks of groups that may be still to come, a mask that is switched.
local LATER = { masks = { coins = { bullets = false }, [7] = { floors = false } } }
local SWITCHED = { masks = { men = { floors = false, coins = true }, boxes = {} } }

local ONLY_TRUE = { men = { floors = false }, boxes = { coins = true } }
local REFUSES = { mask = { men = true, floors = false } }
local MACHINE = { kinematic = true }

describe("checked", function()
  small.each("refuses a static object with a changed {1}, until it is refreshed", {
    x = 5,
    y = 101,
    width = 201,
    height = 9,
    sensor = true,
    active = false,
    oneWay = "top",
    restitution = 0.5,
    friction = 0.5,
    surfaceSpeed = 10,
    mask = { boxes = false },
    canCollide = print,
    onStay = print,
    static = false,
  }, function(name, value)
    local world, floor = newWorld()
    floor[name] = value
    local shown = tostring(value):gsub("^(%a+): .*", "%1"):gsub("^top$", '"top"')
    refusesStep(world, "objects.floors[1]." .. name .. " was changed to " .. shown .. BY_HAND)
    floor.onStay, floor.canCollide = nil, nil
    world:refresh(floor)
    world:update(DT)
  end)

  it("lets a static object have what means nothing to it, such as a mass", function()
    local world, floor = newWorld()
    local numbers = "vx vy ax ay gravity gravityX mass strength airFriction drag nudge snap"
      .. " maxSpeed maxSpeedX maxSpeedY maxFallSpeed"
    for name in numbers:gmatch("%a+") do
      floor[name] = 5
    end
    floor.pushable, floor.constantSpeed = false, true
    world:update(DT)
  end)

  it("refuses a mask that was changed in place, not one that says the same", function()
    local world, floor = newWorld()
    floor.mask = { boxes = true, ghosts = false }
    world:refresh(floor)
    world:update(DT)
    floor.mask = { boxes = true, ghosts = false }
    world:update(DT)
    for _, name in ipairs({ "boxes", "others" }) do
      floor.mask[name] = false
      refusesStep(world, "objects.floors[1].mask was changed to table" .. BY_HAND)
      world:refresh(floor)
      world:update(DT)
    end
  end)

  -- what is written, what was meant; a callback's name is one for functions only
  for wrong, meant in pairs({
    widht = "width",
    Mass = "mass",
    maxspeed = "maxSpeed",
    frictoin = "friction",
    VX = "vx",
    X = "x",
    velocityX = "vx",
    isStatic = "static",
    elasticity = "restitution",
    isTrigger = "sensor",
    gravityScale = "gravity",
    onbegin = "onBegin",
    canColide = "canCollide",
    onCollision = "onBegin",
  }) do
    it("takes " .. wrong .. " for " .. meant, function()
      local world, _, box = newWorld()
      local isCallback = meant == "onBegin" or meant == "canCollide"
      box[wrong] = isCallback and 1 or print -- the game's own
      world:update(DT)
      box[wrong] = isCallback and print or 1
      local text = ".%s is not a field of the library: did you mean %s?"
      refusesStep(world, "objects.boxes[1]" .. text:format(wrong, meant))
      box[wrong] = nil
    end)
  end

  it("takes gravty for gravity of the world, and onCollide for onBegin", function()
    local world = newWorld()
    for wrong, meant in pairs({ gravty = "gravity", onCollide = "onBegin" }) do
      world[wrong] = wrong == "gravty" and 1 or print
      local text = "world.%s is not a field of the library: did you mean %s?"
      refusesStep(world, text:format(wrong, meant))
      world[wrong] = nil
    end
  end)

  -- Where it is written (`new`: in a third object); what is written; what is said of it; what is
  -- written to make it fine.
  local PLACES = { box = "objects.boxes[1].", world = "world.", new = "objects.others[1]." }
  local FLOORS = "there is no group floor, did you mean floors?"
  local HITS = { men = true }
  local COUNTS = "kinematic must be nil, got true: the object is static, which counts"
  for _, row in ipairs({
    { "box", { static = true }, "static was changed to true" .. BY_HAND },
    { "box", { oneWay = true }, "oneWay must be nil, got true" .. ONE_WAY },
    { "box", { oneWay = "left" }, 'oneWay must be nil, got "left"' .. ONE_WAY, MACHINE },
    { "box", { mask = { floor = false } }, "mask: " .. FLOORS },
    { "world", { masks = { boxes = { floor = false } } }, "masks.boxes: " .. FLOORS },
    {
      "world",
      { masks = { Floors = { boxes = false } } },
      "masks: " .. "there is no group Floors, did you mean floors?",
      LATER,
    },
    {
      "new",
      { mask = { true, Floors = false } },
      "mask: there is no group Floors, did you mean floors?",
      REFUSES,
    },
    { "world", { masks = ONLY_TRUE }, 'masks.boxes = { ["coins"] = true }' .. NOTHING, SWITCHED },
    {
      "new",
      { mask = HITS },
      'mask = { ["men"] = true }' .. NOTHING .. ' (did you mean hits = { "men" }?)',
      REFUSES,
    },
    { "new", { static = true, kinematic = true }, COUNTS },
    {
      "new",
      { surfaceSpeed = 1 },
      "surfaceSpeed must be nil, got 1: belts are static or kinematic",
    },
  }) do
    it("refuses: " .. PLACES[row[1]] .. row[3], function()
      local world, _, box = newWorld()
      local object = row[1] == "box" and box or world
      if row[1] == "new" then
        object = { x = 50, y = 0, width = 5, height = 5 }
        world.objects.others = { object }
      end
      local before = {}
      for name, value in pairs(row[2]) do
        before[name], object[name] = object[name], value
      end
      refusesStep(world, PLACES[row[1]] .. row[3])
      for name in pairs(row[2]) do
        object[name] = before[name]
      end
      small.set(object, row[4])
      world:refresh(object == world and box or object)
      world:update(DT)
    end)
  end

  -- (The game has switched the mask on in a world that it played before.)
  small.rows(
    "asks no mask of {1}",
    { "objects that were restored", "a world checked later" },
    function(what)
      local isRestored = what == "objects that were restored"
      local world = physics.newWorld({ checked = isRestored })
      local man = world:add("men", small.box(0, 0, { mask = { boxes = false } }))
      world:add("boxes", small.box(0, 0))
      world:update(DT)
      man.mask.boxes = true
      world:update(DT)
      if isRestored then
        local other = physics.newWorld({ checked = true })
        other:restore(world:save())
        other:update(DT)
      end
      world.checked = true
      world:update(DT)
    end
  )

  it("refuses canCollide that returns nothing", function()
    local world, _, box = newWorld()
    box.canCollide, box.y = function() end, 90
    refusesStep(world, "canCollide must return true or false, got nothing (which means true)")
  end)

  it("refuses a response that returns nothing: bump.lua would ignore", function()
    local world, _, box = newWorld()
    local y = box.y
    local function move()
      return (select(2, world:move(box, box.x, 500, function() end)))
    end
    local _, message = pcall(move)
    assert.equal(
      "world:move(object, x, y): response must return false to ignore, got nothing",
      message:match("debugging_spec%.lua:%d+: physics: (.*)$")
    )
    assert.equal(y, box.y)
    world.checked = false
    assert.equal(90, move())
  end)

  it("says nothing of a mask that is switched in the game, or of a group that was there", function()
    local world, _, box = newWorld()
    world.masks = { men = { floors = false } }
    world:update(DT)
    box.mask, world.masks.men.floors = { men = true }, true
    world.objects.floor = {} -- a group of its own, which is empty still
    world:update(DT)
    world.objects.floor, box.mask = nil, { floor = false }
    world:update(DT)
  end)

  it("finds dt in milliseconds, but not a game that was stopped for a while", function()
    local world = newWorld()
    world:update(3)
    world:update(DT)
    world:update(5)
    local text = "world:update(dt): dt is in seconds, got 16.7 (milliseconds? divide by 1000)"
    refusesStep(world, text, 16.7)
    world.checked = false
    world:update(16.7)
    world:update(16.7)
  end)

  it("tells of a side that is none", function()
    local world, _, box = newWorld()
    world:update(DT)
    assert.is_false(box.touching.bottom)
    small.refuses("touching.ground is no side: there are top, bottom", function()
      return box.touching.ground and 1
    end)
  end)

  it("refuses an object that stands in another checked world, until it has left it", function()
    local world, _, box = newWorld()
    local other = newWorld()
    other.objects.cursor = box
    local text = "physics: objects.cursor is also in another world, as objects.boxes[1]"
    local function update()
      other:update(DT)
    end
    assert.error_matches(update, text, 1, true)
    world:remove(box)
    world:queryPoint(0, 0) -- sees that it has gone
    world:add("boxes", box)
    assert.error_matches(update, text, 1, true)
    world:remove(box)
    world:update(DT)
    other:update(DT)
    other.objects.cursor = nil
    other:update(DT)
    world:add("boxes", box)
    world:update(DT)
  end)

  it("goes the way of any other, and may be switched at any time", function()
    local world, _, box = newWorld()
    local plain = physics.newWorld()
    plain:restore(world:save())
    for _ = 1, 30 do
      world:update(DT)
      plain:update(DT)
      assert.equal(plain:hash(), world:hash())
    end
    box.widht = 1
    world.checked = false
    world:update(DT)
    world.checked = true
    assert.is_false((pcall(world.update, world, DT)))
  end)

  it("keeps no world alive", function()
    local weak = setmetatable({ (newWorld()) }, { __mode = "v" })
    collectgarbage()
    collectgarbage()
    assert.is_nil(weak[1])
  end)

  it("leaves the game's own fields and the methods of its classes alone", function()
    local world, floor, box = newWorld()
    local names = { "w", "h", "z", "vz", "hp", "mas", "_width", "name", "state", "image", 1, true }
    for _, name in ipairs({ "draw", "update", "weight", "velocity", "fraction", "masks" }) do
      names[#names + 1] = name
      box[name], floor[name] = print, print
    end
    world:update(DT)
    for _, name in ipairs(names) do
      box[name], floor[name] = 1, 1
    end
    for name in ("hp player camera paused velocity"):gmatch("%a+") do
      world[name] = 1
    end
    local Crate = { velocity = 1, widht = 2 }
    Crate.__index = Crate
    world:add("boxes", setmetatable({ x = 50, y = 0, width = 5, height = 5 }, Crate))
    world:update(DT)
  end)
end)

describe("explain", function()
  local NAMES = "objects.a[1] and objects.b[1] "
  small.rows("says: {3}", {
    { { x = 30 }, {}, "can collide: now they are 20 px apart." },
    { { x = 4, y = 20 }, {}, "can collide: now they are 10 px apart." },
    { { x = 10 }, {}, "can collide: now they are flush at the right of objects.a[1]." },
    { { x = 10, y = 10 }, {}, "can collide: now they are flush at a corner only" },
    { { x = 9, y = 10 }, {}, "can collide: now they are flush at the bottom of objects.a[1]." },
    { { x = 8 }, {}, "can collide: now they overlap by 2 px." },
    { { active = false }, {}, "never collide: one of them is not active." },
    {
      {},
      { mask = { b = false } },
      'never collide: the mask of objects.a[1] refuses the group "b".',
    },
    { { static = true }, { kinematic = true }, "never collide: neither of them is dynamic." },
    { { sensor = true }, {}, "objects.b[1] is a sensor" },
    { { oneWay = "top" }, {}, "objects.b[1] is solid only at its top" },
    { { oneWay = true }, {}, "objects.b[1] is solid only at its top" },
    { { canCollide = function() end }, {}, "canCollide of objects.b[1] may refuse" },
  }, function(its, mine, words)
    local world = physics.newWorld({ gravity = 0 })
    local a = world:add("a", sized(0, 0, 10, 10, mine))
    local b = world:add("b", sized(0, 0, 10, 10, its))
    local sentence = world:explain(a, b)
    assert.is_truthy(sentence:find(NAMES, 1, true), sentence)
    assert.is_truthy(sentence:find(words, 1, true), sentence)
  end)

  it("says which object is not there, what the world's masks and its canCollide do", function()
    local world = physics.newWorld({ gravity = 0, masks = { a = { b = false } } })
    local a, b = world:add("a", sized(0, 0, 10, 10)), world:add("b", sized(0, 0, 10, 10))
    local text = 'the world\'s masks let objects.a[1] pass through the group "b"'
    assert.is_truthy(world:explain(b, a):find(text, 1, true))
    assert.is_truthy(world:explain(a, a):find("same object", 1, true))
    assert.is_truthy(world:explain(a, {}):find("b is not in the world", 1, true))
    world.masks, world.canCollide = nil, function() end
    assert.is_truthy(world:explain(a, b):find("canCollide of the world may refuse", 1, true))
  end)
end)
