--- The setting `checked`: what is found, in which words, and what is left alone.

local physics = require("physics")

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

-- Runs a step that must be refused, with this message, naming this file, moving nothing.
local function refusesStep(world, expected)
  local box = world.objects.boxes[1]
  local x, y, vx, vy = box.x, box.y, box.vx, box.vy
  for _ = 1, 2 do
    local ok, message = pcall(function()
      world:update(DT)
    end)
    assert.is_false(ok, "it was not refused: " .. expected)
    local text = message:match("guard_spec%.lua:%d+: physics: (.*)$")
    assert.equal(expected, text or message)
    assert.same({ x, y, vx, vy }, { box.x, box.y, box.vx, box.vy })
  end
end

-- The same of an update by `dt` s that comes after a long one.
local function refusesTime(world, dt)
  local ok, message = pcall(function()
    world:update(dt)
  end)
  assert.is_false(ok)
  local text = "guard_spec%.lua:%d+: physics: world:update%(dt%): dt is in seconds, got "
  assert.matches(text .. dt .. " %(milliseconds%? divide by 1000%)", message)
end

local BY_HAND = ": a static object is read only once, so call world:refresh(object)"

describe("a checked world", function()
  for _, row in ipairs({
    { "x", 5, "5" },
    { "y", 101, "101" },
    { "width", 201, "201" },
    { "height", 9, "9" },
    { "sensor", true, "true" },
    { "active", false, "false" },
    { "oneWay", "top", '"top"' },
    { "restitution", 0.5, "0.5" },
    { "friction", 0.5, "0.5" },
    { "surfaceSpeed", 10, "10" },
    { "mask", { boxes = false }, "table" },
    { "canCollide", print, "function" },
    { "onStay", print, "function" },
    { "static", false, "false" },
  }) do
    local name, value = row[1], row[2]

    it("refuses a static object with a changed " .. name .. ", until it is refreshed", function()
      local world, floor = newWorld()
      floor[name] = value
      refusesStep(world, "objects.floors[1]." .. name .. " was changed to " .. row[3] .. BY_HAND)
      floor.onStay, floor.canCollide = nil, nil
      world:refresh(floor)
      world:update(DT)
    end)
  end

  it(
    "refuses a static object with a mask that was changed in place, not one that says the same",
    function()
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
      floor.mask = 5
      refusesStep(world, "objects.floors[1].mask was changed to 5" .. BY_HAND)
      assert.is_false(pcall(world.save, world))
      floor.mask = { boxes = false }
      refusesStep(world, "objects.floors[1].mask was changed to table" .. BY_HAND)
    end
  )

  it("refuses a box that was made static", function()
    local world, _, box = newWorld()
    box.static = true
    refusesStep(world, "objects.boxes[1].static was changed to true" .. BY_HAND)
    world:refresh(box)
    world:update(DT)
  end)

  for _, row in ipairs({
    { "widht", "width" },
    { "hieght", "height" },
    { "statc", "static" },
    { "Mass", "mass" },
    { "maxspeed", "maxSpeed" },
    { "onbegin", "onBegin" },
    { "oneway", "oneWay" },
    { "frictoin", "friction" },
    { "canColide", "canCollide" },
    { "VX", "vx" },
    { "X", "x" },
    { "velocityX", "vx" },
    { "isStatic", "static" },
    { "elasticity", "restitution" },
    { "isTrigger", "sensor" },
    { "gravityScale", "gravity" },
    { "onCollision", "onBegin" },
  }) do
    it("takes " .. row[1] .. " for " .. row[2], function()
      local world, _, box = newWorld()
      local text = " is not a field of the library: did you mean " .. row[2] .. "?"
      local isCallback = row[2]:find("^on%u") or row[2] == "canCollide"
      local function callback() end
      box[row[1]] = isCallback and 1 or callback -- the game's own
      world:update(DT)
      box[row[1]] = isCallback and callback or 1
      refusesStep(world, "objects.boxes[1]." .. row[1] .. text)
      box[row[1]] = nil
      world:update(DT)
    end)
  end

  it("finds a misspelled setting", function()
    local world = newWorld()
    world.gravty = 0
    refusesStep(world, "world.gravty is not a field of the library: did you mean gravity?")
    world.gravty = nil
    world:update(DT)
    world.onCollide = 1 -- the game's own
    world:update(DT)
    function world.onCollide() end
    refusesStep(world, "world.onCollide is not a field of the library: did you mean onBegin?")
    world.onCollide = nil
    world:update(DT)
  end)

  it("leaves a static object alone that is one-way by `true`", function()
    local world = newWorld()
    local ledge = { x = 0, y = 50, width = 50, height = 10, static = true, oneWay = true }
    world:add("ledges", ledge)
    world:update(DT)
    ledge.oneWay = "left"
    refusesStep(
      world,
      'objects.ledges[1].oneWay was changed to "left": a static object is read only once, so call'
        .. " world:refresh(object)"
    )
  end)

  it("refuses a dynamic object that is one-way, not a kinematic one", function()
    local world, _, box = newWorld()
    local text = " must be nil, got %s: one-way objects are static or kinematic; a dynamic one"
      .. " falls through the floor"
    for _, side in ipairs({ true, "top", "left" }) do
      box.oneWay = side
      local shown = side == true and "true" or ('"%s"'):format(side)
      refusesStep(world, "objects.boxes[1].oneWay" .. text:format(shown))
    end
    box.oneWay = false
    world:update(DT)
    box.oneWay, box.kinematic = "top", true
    world:update(DT)
  end)

  it("finds a mask that names a group which is not there, but one with nearly that name", function()
    local world, _, box = newWorld()
    local text = ": there is no group floor, did you mean floors?"
    box.mask = { floor = false }
    refusesStep(world, "objects.boxes[1].mask" .. text)
    box.mask = nil
    world.masks = { boxes = { floor = false } }
    refusesStep(world, "world.masks.boxes" .. text)
    world.masks = { floor = { boxes = false } }
    refusesStep(world, "world.masks" .. text)
    world.objects.floor = {} -- it is a group of its own, which is empty still
    world:update(DT)
    world.objects.floor = nil
    world.masks = { Floors = { boxes = false } }
    refusesStep(world, "world.masks: there is no group Floors, did you mean floors?")
    world.masks = { coins = { bullets = false, boxs = true }, [7] = { floors = false } }
    refusesStep(world, "world.masks.coins: there is no group boxs, did you mean boxes?")
    world.masks = { coins = { bullets = false }, [7] = { floors = false } } -- may be still to come
    world:update(DT)
    world.objects.floor1 = {} -- it may come back
    world:update(DT)
    world.objects.floor1, world.masks = nil, { floor1 = { boxes = false } }
    world:update(DT)
  end)

  it("leaves the game's own fields alone", function()
    local world, floor, box = newWorld()
    local names = { "w", "h", "z", "vz", "hp", "mas", "_width", "name", "state", "image" }
    for _, name in ipairs({ "draw", "update", "weight", "velocity", "fraction", "masks" }) do
      names[#names + 1] = name
      box[name], floor[name] = function() end, function() end
    end
    world:update(DT)
    for _, name in ipairs(names) do
      box[name], floor[name] = 1, 1
      world[name] = name ~= "masks" and name ~= "draw" and name ~= "update" and 1 or nil
    end
    box[1], box[true] = 1, 1
    world.player, world.camera, world.paused = box, 1, true
    world:update(DT)
  end)

  it("leaves methods of classes alone", function()
    local world = newWorld()
    local Crate = { velocity = 1, widht = 2 }
    Crate.__index = Crate
    world:add("boxes", setmetatable({ x = 50, y = 0, width = 5, height = 5 }, Crate))
    world:update(DT)
  end)

  it("finds dt in milliseconds, but not a game that was stopped for a while", function()
    local world = newWorld()
    world:update(3)
    world:update(DT)
    world:update(5)
    refusesTime(world, 16.7)
    world.checked = false
    world:update(16.7)
    world:update(16.7)
  end)

  it("finds a mask that refuses nothing, when its object is new", function()
    local world, _, box = newWorld()
    local one = world:add("boxes", { x = 50, y = 0, width = 5, height = 5, mask = { men = true } })
    refusesStep(
      world,
      'objects.boxes[2].mask = { ["men"] = true } refuses nothing: true collides, as nil does, and'
        .. ' false passes through (did you mean hits = { "men" }?)'
    )
    one.mask = { men = true, floors = false }
    world:update(DT)
    box.mask = { men = true } -- it is switched in the game
    world:update(DT)
  end)

  it("finds a row of masks that refuses nothing, when they are new", function()
    local world = newWorld()
    world.masks = { men = { floors = false }, boxes = { coins = true } }
    refusesStep(
      world,
      'world.masks.boxes = { ["coins"] = true } refuses nothing: true collides, as nil does, and'
        .. " false passes through"
    )
    world.masks = { men = { floors = false, coins = true }, boxes = {} }
    world:update(DT)
    world.masks.men.floors = true -- it is switched in the game
    world:update(DT)
  end)

  it("finds canCollide that returns nothing", function()
    local world, _, box = newWorld()
    box.canCollide = function() end
    box.y = 90
    refusesStep(world, "canCollide must return true or false, got nothing (which means true)")
    box.canCollide = function()
      return true
    end
    world:update(DT)
  end)

  it("finds a class that keeps static, kinematic or sensor for itself", function()
    for _, name in ipairs({ "static", "kinematic", "sensor" }) do
      local Wall = { [name] = true }
      local world = newWorld()
      local wall = setmetatable({ x = 50, y = 0, width = 5, height = 5 }, Wall)
      world:add("walls", wall)
      local text = "objects.walls[1].NAME is nil, but its class has NAME = true: set it in the"
        .. " object, as in self.NAME = true"
      refusesStep(world, (text:gsub("NAME", name)))
      wall[name] = false
      world:refresh(wall)
      world:update(DT)
      wall[name] = nil
      Wall.__index = Wall
      world:refresh(wall)
      world:update(DT)
    end
    -- As middleclass does: the class is in the field `class`, and has a table of that name.
    local Class = { static = {} }
    local world = newWorld()
    local one = world:add("walls", { x = 50, y = 0, width = 5, height = 5, class = Class })
    world:update(DT)
    Class.static = true
    local text = "objects.walls[1].static is nil, but its class has static = true: set it in the"
      .. " object, as in self.static = true"
    refusesStep(world, text)
    one.class = nil
    world:update(DT)
  end)

  it("finds a method that the field touching hides", function()
    local Player = {}
    Player.__index = Player
    function Player.touching() end
    local world = newWorld()
    world:add("men", setmetatable({ x = 50, y = 0, width = 5, height = 5 }, Player))
    refusesStep(
      world,
      "objects.men[1].touching is written by the library, and hides the method touching of its"
        .. " class: give that another name"
    )
    Player.touching = nil
    world:update(DT)
  end)

  it("tells of a side that is none", function()
    local world, _, box = newWorld()
    world:update(DT)
    assert.is_false(box.touching.bottom)
    local ok, message = pcall(function()
      return box.touching.ground and 1
    end)
    assert.is_false(ok)
    assert.matches(
      "guard_spec.lua:%d+: physics: touching.ground is no side: there are top, bottom, left and",
      message
    )
  end)

  it("refuses an object that stands in another checked world, until it has left it", function()
    local world, _, box = newWorld()
    local other = newWorld()
    other.objects.cursor = box
    local ok, message = pcall(other.update, other, DT)
    assert.is_false(ok)
    local text = "physics: objects.cursor is also in another world, as objects.boxes[1]"
    assert.truthy(message:find(text, 1, true), message)
    world:remove(box)
    world:update(DT)
    other:update(DT)
    other.objects.cursor = nil
    other:update(DT)
    world:add("boxes", box)
    world:update(DT)
  end)

  for _, row in ipairs({
    {
      "from a group",
      function(world, box)
        world:remove(box)
      end,
    },
    {
      "from where it stood alone",
      function(world, box)
        world:remove(box)
        world.objects.player = box
        world:update(DT)
        world.objects.player = nil
      end,
    },
    {
      "with its group",
      function(world)
        world.objects.boxes = nil
      end,
    },
    {
      "with all others",
      function(world)
        world.objects = nil
      end,
    },
  }) do
    it("lets an object go to another world, " .. row[1] .. ", before it is stepped", function()
      local world, _, box = newWorld()
      local other = newWorld()
      row[2](world, box)
      other:add("game", box)
      other:update(DT)
      world.objects = world.objects or {}
      world:update(DT)
      world:add("boxes", box)
      local ok, message = pcall(world.update, world, DT)
      assert.is_false(ok)
      local text = "physics: objects.boxes[1] is also in another world, as objects.game[1]"
      assert.truthy(message:find(text, 1, true), message)
    end)
  end

  it("refuses a mover that is much larger than the grid's cells", function()
    local world, floor, box = newWorld({ cellSize = 2 })
    floor.width = 5000
    world:refresh(floor)
    box.height = 2049
    refusesStep(
      world,
      "objects.boxes[1].height must be at most 1024 cells of 2 px, got 2049: set world.cellSize to"
        .. " the size of most objects"
    )
    world.cellSize = 16
    world:update(DT)
  end)

  it("goes the way of any other, and may be switched at any time", function()
    local world, _, box = newWorld()
    local plain = physics.newWorld()
    plain:add("floors", { x = 0, y = 100, width = 200, height = 10, static = true })
    local its = plain:add("boxes", { x = 20, y = 80, width = 10, height = 10 })
    plain:update(DT)
    for _ = 1, 30 do
      world:update(DT)
      plain:update(DT)
      assert.same({ box.x, box.y, box.vy }, { its.x, its.y, its.vy })
    end
    assert.equal(plain:hash(), world:hash())
    box.widht = 1
    world.checked = false
    world:update(DT)
    world.checked = true
    assert.is_false((pcall(world.update, world, DT)))
  end)

  for _, row in ipairs({
    {
      { static = true, kinematic = true },
      ".kinematic must be nil, got true: the object is static",
    },
    { { static = true, vx = 5 }, ".vx must be nil, got 5: a static object never moves" },
    { { static = true, vy = -5 }, ".vy must be nil, got -5: a static object never moves" },
    { { surfaceSpeed = 9 }, ".surfaceSpeed must be nil, got 9: belts are static or kinematic" },
  }) do
    it("refuses what has no effect: " .. row[2], function()
      local world = newWorld()
      local object = { x = 150, y = 0, width = 5, height = 5 }
      for name, value in pairs(row[1]) do
        object[name] = value
      end
      world.objects.others = { object }
      local ok, message = pcall(world.update, world, DT)
      assert.is_false(ok)
      assert.truthy(message:find("objects.others[1]" .. row[2], 1, true), message)
    end)
  end

  it("refuses a belt where nothing is pulled down", function()
    local world, floor = newWorld()
    floor.surfaceSpeed = 9
    world:refresh(floor)
    world:update(DT)
    world.gravity = 0
    refusesStep(
      world,
      "objects.floors[1].surfaceSpeed moves what gravity presses on it, and there is no gravity"
    )
    world.objects.boxes[1].gravity = 100
    world:update(DT)
  end)

  it("finds another form of a group's name, after the first second", function()
    local world = newWorld()
    world:add("enemies", { x = 150, y = 0, width = 5, height = 5 })
    world.soft = { enemy = { boxes = 9 } }
    for _ = 1, 54 do
      world:update(DT)
    end
    world:update(0.08)
    refusesStep(world, "world.soft: there is no group enemy, did you mean enemies?")
  end)

  it("finds a `touching` that was taken away", function()
    local world, _, box = newWorld()
    world:update(DT)
    box.touching = nil
    refusesStep(
      world,
      "objects.boxes[1].touching was set to nil: the library writes it, and needs no help"
    )
  end)

  it("keeps no world alive", function()
    local weak = setmetatable({ (newWorld()) }, { __mode = "v" })
    collectgarbage()
    collectgarbage()
    assert.is_nil(weak[1])
  end)
end)
