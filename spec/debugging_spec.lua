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
    local text = message:match("debugging_spec%.lua:%d+: physics: (.*)$")
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
  local text = "debugging_spec%.lua:%d+: physics: world:update%(dt%): dt is in seconds, got "
  assert.matches(text .. dt .. " %(milliseconds%? divide by 1000%)", message)
end

local NIL = {}
local BY_HAND = ": a static object is read only once, so call world:refresh(object)"
local ONE_WAY = ": one-way objects are static or kinematic; a dynamic one falls through the floor"
local NOTHING = " refuses nothing: true collides, as nil does, and false passes through"
local OF_CLASS = ", but its class has static = true: set it in the object, as in self.static = true"

local function class(fields)
  return setmetatable({}, fields) -- without __index: its fields are not the object's
end

describe("checked", function()
  for name, value in pairs({
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
  }) do
    it("refuses a static object with a changed " .. name .. ", until it is refreshed", function()
      local world, floor = newWorld()
      floor[name] = value
      local kind = type(value)
      local shown = kind == "string" and ("%q"):format(value)
        or (kind == "table" or kind == "function") and kind
        or tostring(value)
      refusesStep(world, "objects.floors[1]." .. name .. " was changed to " .. shown .. BY_HAND)
      floor.onStay, floor.canCollide = nil, nil
      world:refresh(floor)
      world:update(DT)
    end)
  end

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
    { "gravty", "gravity", "world" },
    { "onCollide", "onBegin", "world" },
  }) do
    it("takes " .. row[1] .. " for " .. row[2], function()
      local world, _, box = newWorld()
      local object = row[3] and world or box
      local text = (row[3] or "objects.boxes[1]")
        .. "."
        .. row[1]
        .. " is not a field of the library"
      local isCallback = row[2]:find("^on%u") or row[2] == "canCollide"
      local function callback() end
      object[row[1]] = isCallback and 1 or callback -- the game's own
      world:update(DT)
      object[row[1]] = isCallback and callback or 1
      refusesStep(world, text .. ": did you mean " .. row[2] .. "?")
      object[row[1]] = nil
      world:update(DT)
    end)
  end

  -- What is written to the box, the floor (read anew) or the world, or added as `new`; what is
  -- refused then; and what is written to make it fine.
  for _, row in ipairs({
    { "box", { static = true }, "objects.boxes[1].static was changed to true" .. BY_HAND },
    { "box", { oneWay = true }, "objects.boxes[1].oneWay must be nil, got true" .. ONE_WAY },
    {
      "box",
      { oneWay = "left" },
      'objects.boxes[1].oneWay must be nil, got "left"' .. ONE_WAY,
      { kinematic = true },
    },
    {
      "box",
      { mask = { floor = false } },
      "objects.boxes[1].mask: there is no group floor, did you mean floors?",
    },
    {
      "world",
      { masks = { boxes = { floor = false } } },
      "world.masks.boxes: there is no group floor, did you mean floors?",
    },
    {
      "world",
      { masks = { Floors = { boxes = false } } },
      "world.masks: there is no group Floors, did you mean floors?",
      { masks = { coins = { bullets = false }, [7] = { floors = false } } },
    }, -- may be still to come
    {
      "new",
      { mask = { men = true } },
      'objects.others[1].mask = { ["men"] = true }'
        .. NOTHING
        .. ' (did you mean hits = { "men" }?)',
      { mask = { men = true, floors = false } },
    },
    {
      "world",
      { masks = { men = { floors = false }, boxes = { coins = true } } },
      'world.masks.boxes = { ["coins"] = true }' .. NOTHING,
      { masks = { men = { floors = false, coins = true }, boxes = {} } },
    },
    {
      "box",
      { canCollide = function() end, y = 90 },
      "canCollide must return true or false, got nothing (which means true)",
    },
    {
      "box",
      { touching = NIL },
      "objects.boxes[1].touching was set to nil: the library writes it, and needs no help",
      { touching = { top = false, bottom = false, left = false, right = false } },
    },
    {
      "new",
      class({ static = true }),
      "objects.others[1].static is nil" .. OF_CLASS,
      { static = false },
    },
    {
      "new",
      { class = { static = true } },
      "objects.others[1].static is nil" .. OF_CLASS,
      { class = { static = {} } },
    }, -- as middleclass has it
    {
      "new",
      setmetatable({}, { __index = { touching = print } }),
      "objects.others[1].touching is written by the library, and hides the method touching of its"
        .. " class: give that another name",
    },
    {
      "new",
      { static = true, kinematic = true },
      "objects.others[1].kinematic must be nil, got true: the object is static, which counts",
    },
    {
      "new",
      { static = true, vx = 5 },
      "objects.others[1].vx must be nil, got 5: a static object never moves",
    },
    {
      "new",
      { surfaceSpeed = 9 },
      "objects.others[1].surfaceSpeed must be nil, got 9: belts are static or kinematic",
    },
  }) do
    it("refuses: " .. row[3], function()
      local world, floor, box = newWorld()
      local object = ({ box = box, floor = floor, world = world })[row[1]]
      if row[1] == "new" then
        object = setmetatable({ x = 50, y = 0, width = 5, height = 5 }, getmetatable(row[2]))
        world.objects.others = { object }
      end
      local before = {}
      for name, value in pairs(row[2]) do
        before[name] = object[name]
        if value == NIL then
          value = nil
        end
        object[name] = value
      end
      refusesStep(world, row[3])
      for name in pairs(row[2]) do
        object[name] = before[name]
      end
      for name, value in pairs(row[4] or {}) do
        object[name] = value
      end
      if row[1] == "new" and not row[4] then
        setmetatable(object, nil)
      end
      world:refresh(row[1] == "world" and box or object)
      world:update(DT)
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

  it("tells of a side that is none", function()
    local world, _, box = newWorld()
    world:update(DT)
    assert.is_false(box.touching.bottom)
    local ok, message = pcall(function()
      return box.touching.ground and 1
    end)
    assert.is_false(ok)
    assert.matches(
      "debugging_spec.lua:%d+: physics: touching.ground is no side: there are top, bottom, left",
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

  it("keeps no world alive", function()
    local weak = setmetatable({ (newWorld()) }, { __mode = "v" })
    collectgarbage()
    collectgarbage()
    assert.is_nil(weak[1])
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
end)
