--- Bad input: what is refused and in which words, that the game's own line is blamed, and that a
--- refused call has changed nothing: repair the value, and the game goes on as if it never was.

local fields = require("physics.fields.fields")
local physics = require("physics")

local unpackList = rawget(_G, "unpack") or rawget(table, "unpack")

local NAN, INF = 0 / 0, 1 / 0
local DT = 1 / 60
local NAMES = { "floor", "box", "sleeper", "lift", "gate" }

-- Scenes ------------------------------------------------------------------------------------------

--- One object of each kind, after a few steps.
---
---                 box      lift ->
---      sleeper     |        ====       gate (sensor)
---     ====== floor v =======================
local function newScene(settings)
  local scene = {
    world = physics.newWorld(settings or { gravity = 800 }),
    floor = { x = 0, y = 200, width = 400, height = 16, static = true },
    box = { x = 100, y = 150, width = 16, height = 16, vx = 30, restitution = 0.5 },
    sleeper = { x = 20, y = 184, width = 16, height = 16 },
    lift = { x = 160, y = 140, width = 64, height = 8, kinematic = true, vx = 20 },
    gate = { x = 300, y = 150, width = 8, height = 50, static = true, sensor = true },
  }
  scene.world:add("floors", scene.floor)
  scene.world:add("boxes", scene.box)
  scene.world:add("boxes", scene.sleeper)
  scene.world:add("lifts", scene.lift)
  scene.world:add("gates", scene.gate)
  for _ = 1, 5 do
    scene.world:update(DT)
  end
  return scene
end

local function show(value)
  return type(value) == "number" and ("%.17g"):format(value) or tostring(value)
end

--- All fields of all objects as one text.
local function snapshot(scene)
  local lines = {}
  for _, name in ipairs(NAMES) do
    for key, value in pairs(scene[name]) do
      lines[#lines + 1] = name .. "." .. tostring(key) .. "=" .. show(value)
    end
    for side, other in pairs(scene[name].touching or {}) do
      lines[#lines + 1] = name .. ".touching." .. side .. "=" .. tostring(other)
    end
  end
  table.sort(lines)
  return table.concat(lines, "\n")
end

--- Where everything is and how fast, to the bit.
local function state(scene)
  local lines = {}
  for _, name in ipairs(NAMES) do
    local object = scene[name]
    local row = { name, show(object.x), show(object.y), show(object.vx), show(object.vy) }
    for _, side in ipairs({ "top", "bottom", "left", "right" }) do
      row[#row + 1] = tostring(object.touching and object.touching[side] and side)
    end
    lines[#lines + 1] = table.concat(row, " ")
  end
  return table.concat(lines, "\n")
end

-- Refusals ----------------------------------------------------------------------------------------

--- Runs a call that must be refused: with exactly this message, and blaming a line of the call.
local function refuses(expected, call)
  local ok, message = pcall(call)
  assert.is_false(ok, "it was not refused: " .. expected)
  local line, text = message:match("bad_input_spec%.lua:(%d+): physics: (.*)$")
  assert.truthy(line, "blames another line: " .. tostring(message))
  assert.equal(expected, text)
  local info = debug.getinfo(call, "S")
  line = tonumber(line)
  assert.is_true(line >= info.linedefined and line <= info.lastlinedefined, "blames line " .. line)
end

--- Fails unless two scenes go on the same way, to the bit.
local function checkGoesOn(scene, twin, steps)
  for i = 1, steps do
    scene.world:update(DT)
    twin.world:update(DT)
    if i % 10 == 1 or i == steps then
      assert.equal(state(twin), state(scene))
    end
  end
end

--- Spoils a scene; the next step must be refused and change nothing; repairs it, and it must go on
--- like a twin to which all that never happened.
local function refusesStep(expected, spoil, repair, settings)
  local scene, twin = newScene(settings), newScene(settings)
  spoil(scene)
  local before = snapshot(scene)
  for _ = 1, 2 do
    refuses(expected, function()
      scene.world:update(DT)
    end)
    assert.equal(before, snapshot(scene))
  end
  repair(scene)
  checkGoesOn(scene, twin, 21)
end

-- Fields ------------------------------------------------------------------------------------------

local NUMBERS = { "12", true, {}, NAN, INF, -INF }

-- By type of a row: values that do not fit, and what the message expects.
local WRONG = {
  boolean = { { 1, "yes", {}, NAN }, "true or false" },
  ["function"] = { { 1, "print", true, {} }, "a function" },
  mask = { { 1, "boxes", true }, "a table { [group] = false }" },
  masks = { { 1, "boxes" }, "a table { [group] = { [group] = false } }" },
  soft = { { 1, "boxes" }, "a table { [group] = { [group] = px/s } }" },
  area = { { 1, "water", true }, "a table { gravity = 100, … }" },
  names = { { 1, "boxes", { boxes = true } }, "a list of group names" },
  ownFields = { { 1, "hp", { hp = true } }, "a list of names of fields" },
}

-- Returns the numbers that a row refuses, and the words for those that it accepts.
local function numbersOf(row)
  local values = { unpackList(NUMBERS) }
  local low = row.min or row.above
  values[#values + 1] = low and low - 0.1
  values[#values + 1] = row.above
  values[#values + 1] = row.max and row.max + 0.1
  if row.max then
    return values, ("a number in %.14g..%.14g"):format(row.min, row.max)
  end
  local range = row.min and " >= %.14g" or row.above and " > %.14g" or ""
  return values, "a number" .. range:format(low)
end

-- Returns the texts that a row refuses, and those that it accepts.
local function choiceOf(row)
  local words = {}
  for n, value in ipairs(row.values) do
    words[n] = '"' .. value .. '"'
  end
  local last = table.remove(words)
  local text = (row.yes and "true, false, " or "") .. table.concat(words, ", ") .. " or " .. last
  return { 1, "north", row.values[1]:upper(), {}, not row.yes or nil }, text
end

local function wrongOf(row)
  if row.type == "number" then
    return numbersOf(row)
  elseif row.type == "string" then
    return choiceOf(row)
  end
  return WRONG[row.type][1], WRONG[row.type][2]
end

local function shown(value)
  if type(value) == "string" then
    return '"' .. value .. '"'
  elseif type(value) ~= "number" then
    return type(value) == "boolean" and tostring(value) or type(value)
  elseif value ~= value then
    return "nan"
  end
  return value == INF and "inf" or value == -INF and "-inf" or ("%.14g"):format(value)
end

local function messageFor(place, name, expected, value)
  if value == INF or value == -INF then
    expected = expected:gsub("^a number", "a finite number")
  end
  local hint = name == "mass" and value == INF and " (pushable = false: never pushed)" or ""
  return place .. "." .. name .. " must be " .. expected .. ", got " .. shown(value) .. hint
end

--- Puts a value into a field for one refused step.
local function refusesLater(part, place, name, expected, value)
  local old
  refusesStep(messageFor(place, name, expected, value), function(scene)
    old = scene[part][name]
    scene[part][name] = value
  end, function(scene)
    scene[part][name] = old
  end)
end

local function newBox(name, value)
  local box = { x = 50, y = 50, width = 16, height = 16 }
  if name then
    box[name] = value
  end
  return box
end

local function refusesAdd(name, expected, value)
  local scene = newScene()
  local box = newBox(name, value)
  refuses(messageFor("objects.boxes[3]", name, expected, value), function()
    scene.world:add("boxes", box)
  end)
  refuses(messageFor("objects.crates[1]", name, expected, value), function()
    scene.world:add("crates", box)
  end)
  assert.equal(2, #scene.world.objects.boxes)
  assert.is_nil(scene.world.objects.crates)
  assert.is_nil(box.touching)
end

local function refusesNew(name, expected, value)
  refusesStep(messageFor("objects.boxes[3]", name, expected, value), function(scene)
    scene.world.objects.boxes[3] = newBox(name, value)
  end, function(scene)
    scene.world.objects.boxes[3] = nil
  end)
  refusesStep(messageFor("objects.player", name, expected, value), function(scene)
    scene.world.objects.player = newBox(name, value)
  end, function(scene)
    scene.world.objects.player = nil
  end)
end

local function refusesRefresh(name, expected, value)
  local scene, twin = newScene(), newScene()
  local old = scene.floor[name]
  scene.floor[name] = value
  local before = snapshot(scene)
  refuses(messageFor("objects.floors[1]", name, expected, value), function()
    scene.world:refresh(scene.floor)
  end)
  assert.equal(before, snapshot(scene))
  scene.floor[name] = old
  checkGoesOn(scene, twin, 11)
end

-- `static` is read once, and a callback that has no column when it would be called.
local function checkValue(row, value, expected)
  local name = row.name
  refusesAdd(name, expected, value)
  refusesNew(name, expected, value)
  refusesRefresh(name, expected, value)
  if name ~= "static" and (row.column or row.type ~= "function") then
    refusesLater("box", "objects.boxes[1]", name, expected, value)
    refusesLater("sleeper", "objects.boxes[2]", name, expected, value)
    refusesLater("lift", "objects.lifts[1]", name, expected, value)
  end
end

describe("the field slope of a dynamic object", function()
  local EXPECTED = 'slope must be nil for a dynamic object, got "left"'
    .. " (set static = true or kinematic = true)"

  it("is refused when it is added, and later", function()
    local scene = newScene()
    refuses("objects.boxes[3]." .. EXPECTED, function()
      scene.world:add("boxes", newBox("slope", "left"))
    end)
    refusesStep("objects.boxes[1]." .. EXPECTED, function(its)
      its.box.slope = "left"
    end, function(its)
      its.box.slope = nil
    end)
    refusesStep("objects.boxes[2]." .. EXPECTED, function(its)
      its.sleeper.slope = "left"
    end, function(its)
      its.sleeper.slope = nil
    end)
  end)

  it("is refused when a kinematic slope becomes dynamic", function()
    local scene = newScene()
    scene.lift.slope = "left"
    scene.world:update(DT)
    scene.lift.kinematic = nil
    refuses("objects.lifts[1]." .. EXPECTED, function()
      scene.world:update(DT)
    end)
    scene.lift.slope = nil
    scene.world:update(DT)
  end)
end)

describe("the field", function()
  for _, row in ipairs(fields.objects) do
    describe(row.name, function()
      local values, expected = {}, nil
      if not row.written then
        values, expected = wrongOf(row)
      end
      for _, value in ipairs(values) do
        it("refuses " .. shown(value) .. ", at first and later", function()
          checkValue(row, value, expected)
        end)
      end

      if row.required then
        it("may not be missing, at first and later", function()
          checkValue(row, nil, expected)
        end)
      end
    end)
  end

  -- `update` makes a number of a velocity that is not there.
  for _, name in ipairs({ "box", "lift" }) do
    for _, row in ipairs({ { "vx", "vy" }, { "vy", "vx" } }) do
      it(
        ("%s of a %s is not false, not even beside one that is missing"):format(row[1], name),
        function()
          local place, velocity = name == "box" and "boxes" or "lifts", {}
          refusesStep(
            ("objects.%s[1].%s must be a number, got false"):format(place, row[1]),
            function(scene)
              local object = scene[name]
              velocity[1], velocity[2] = object[row[1]], object[row[2]]
              object[row[1]], object[row[2]] = false, nil
            end,
            function(scene)
              scene[name][row[1]], scene[name][row[2]] = velocity[1], velocity[2]
            end
          )
        end
      )
    end
  end

  it("mask refuses what is no group, and what is no answer", function()
    local expected = "objects.boxes[1].mask.lifts must be true or false, got 0"
    refusesStep(expected, function(scene)
      scene.box.mask = { lifts = 0 }
    end, function(scene)
      scene.box.mask = nil
    end)
    expected = "objects.boxes[1].mask must have group names as keys, got true"
    refusesStep(expected, function(scene)
      scene.box.mask = { [true] = false }
    end, function(scene)
      scene.box.mask = nil
    end)
  end)

  for _, name in ipairs({ "onBegin", "onEnd" }) do
    do
      it(name .. " that turns bad is refused when it would be called, and not lost", function()
        local world, told = physics.newWorld({ gravity = 0 }), 0
        local wall = world:add("walls", { x = 20, y = 0, width = 4, height = 16, static = true })
        local box = world:add("boxes", { x = 0, y = 0, width = 16, height = 16, vx = 960 })
        wall[name] = function()
          told = told + 1
        end
        box.vx = 0
        world:update(DT)
        box[name], box.vx = "bang", 960
        refuses("objects.boxes[1]." .. name .. ' must be a function, got "bang"', function()
          world:update(DT)
          box.vx = -960
          world:update(DT)
        end)
        assert.equal(0, told)
        box[name] = nil
        world:update(DT)
        assert.equal(1, told)
      end)
    end
  end
end)

describe("a callback that another one spoils", function()
  for _, row in ipairs({
    { "player", 'objects.player.onBegin must be a function, got "boom"', 2 },
    { "crate", 'objects.crates[1].onBegin must be a function, got "boom"', 1 },
    { "world", 'world.onBegin must be a function, got "boom"', 0 },
  }) do
    local which, message = row[1], row[2]
    it("is refused before it is called, and not lost: " .. which, function()
      local world = physics.newWorld({ gravity = 0 })
      local coin = { x = 0, y = 0, width = 8, height = 8, static = true, sensor = true }
      local crate = world:add("crates", { x = 40, y = 0, width = 16, height = 16, vx = 0.5 })
      local player = { x = 56, y = 0, width = 16, height = 16, vx = -0.5 }
      world.objects.player = player
      world:add("coins", coin)
      local guest = world:add("aGuest", { x = 2, y = 2, width = 4, height = 4 })
      local owner, told = { player = player, crate = crate, world = world }, { count = 0 }
      owner = owner[which]
      local function count()
        told.count = told.count + 1
      end
      crate.onBegin, player.onBegin, world.onBegin = count, count, count
      guest.onBegin = function()
        owner.onBegin = "boom"
      end
      refuses(message, function()
        world:update(DT)
      end)
      -- By then the world has heard, of the guest's event, and the crate, if it comes first.
      assert.equal(row[3], told.count)
      owner.onBegin = count
      world:update(DT)
      assert.equal(4, told.count)
    end)
  end
end)

-- Places ------------------------------------------------------------------------------------------

-- Twice in the world: the first place, the second one.
local function twice(second, first)
  return second
    .. " is the same object as "
    .. first
    .. ": an object must be in one place only, got table in two"
end

-- What is put into the groups: group, key in it (nil: the group itself), value, message.
local function newPlaces(scene)
  local player = newBox()
  local keys = "has a key that is neither a number nor a string, got "
  return {
    { "coins", nil, 5, "objects.coins must be a group (a table of objects) or an object, got 5" },
    { true, nil, {}, "objects " .. keys .. "true" },
    { NAMES, nil, {}, "objects " .. keys .. "table" },
    { "boxes", NAMES, newBox(), "objects.boxes " .. keys .. "table" },
    { "boxes", false, newBox(), "objects.boxes " .. keys .. "false" },
    { "boxes", 3, "crate", 'objects.boxes[3] must be an object (a table), got "crate"' },
    { "boxes", "hit", print, "objects.boxes.hit must be an object (a table), got function" },
    { "boxes", 3, scene.box, twice("objects.boxes[3]", "objects.boxes[1]") },
    { "coins", nil, { scene.sleeper }, twice("objects.coins[1]", "objects.boxes[2]") },
    { "player", nil, scene.lift, twice("objects.player", "objects.lifts[1]") },
    { "player", nil, player, twice("objects.zoo[1]", "objects.player"), { player } },
  }
end

describe("the table of objects", function()
  for n, row in ipairs(newPlaces({})) do
    it("refuses " .. row[4], function()
      local its
      refusesStep(row[4], function(scene)
        its = newPlaces(scene)[n]
        local objects = scene.world.objects
        objects.zoo = its[5]
        if its[2] == nil then
          objects[its[1]] = its[3]
        else
          objects[its[1]][its[2]] = its[3]
        end
      end, function(scene)
        local objects = scene.world.objects
        objects.zoo = nil
        if its[2] == nil then
          objects[its[1]] = nil
        else
          objects[its[1]][its[2]] = nil
        end
      end)
    end)
  end

  it("must be a table", function()
    local objects
    refusesStep("objects must be a table of groups, got 7", function(scene)
      objects, scene.world.objects = scene.world.objects, 7
    end, function(scene)
      scene.world.objects = objects
    end)
  end)

  it("is told by the first that is wrong, and nothing new enters before all is right", function()
    local scene = newScene()
    local good, bad = newBox(), newBox("mass", 0)
    scene.world.objects.boxes[3], scene.world.objects.boxes[4] = good, bad
    refuses("objects.boxes[4].mass must be a number > 0, got 0", function()
      scene.world:update(DT)
    end)
    assert.is_nil(good.touching)
    bad.mass = 2
    scene.world:update(DT)
    assert.is_table(good.touching)
    assert.equal(6, scene.world.stats.objects - 1)
  end)
end)

-- Settings ----------------------------------------------------------------------------------------

describe("the setting", function()
  local function checkSetting(name, value, expected)
    local text = messageFor("", name, expected, value):sub(2)
    refuses("newWorld(settings): " .. text, function()
      physics.newWorld({ [name] = value })
    end)
    refuses("load(settings): " .. text, function()
      physics.load({ [name] = value })
    end)
    local old
    refusesStep("world." .. text, function(scene)
      old = scene.world[name]
      scene.world[name] = value
    end, function(scene)
      scene.world[name] = old
    end)
  end

  for _, row in ipairs(fields.settings) do
    local values, expected = wrongOf(row)
    for _, value in ipairs(values) do
      it(row.name .. " refuses " .. shown(value) .. ", at first and later", function()
        checkSetting(row.name, value, expected)
      end)
    end
  end

  it("gravity may not be taken away", function()
    refusesStep("world.gravity must be a number, got nil", function(scene)
      scene.world.gravity = nil
    end, function(scene)
      scene.world.gravity = 800
    end)
  end)

  it("masks refuses what is wrong deep inside, also when it turns wrong in place", function()
    refuses("newWorld(settings): masks.boxes.lifts must be true or false, got 1", function()
      physics.newWorld({ masks = { boxes = { lifts = 1 } } })
    end)
    local settings = { gravity = 800, masks = { boxes = { gates = false } } }
    refusesStep("world.masks.boxes.gates must be true or false, got 0", function(scene)
      scene.world.masks.boxes.gates = 0
    end, function(scene)
      scene.world.masks.boxes.gates = false
    end, settings)
  end)

  it("order refuses what is no name, and a name twice", function()
    refuses("newWorld(settings): order[2] must be a group name, got true", function()
      physics.newWorld({ order = { "boxes", true } })
    end)
    refuses(
      'newWorld(settings): order must name each group once, got "boxes" at [1] and [3]',
      function()
        physics.newWorld({ order = { "boxes", "lifts", "boxes" } })
      end
    )
  end)

  it("that is unknown is refused, with a guess", function()
    local ok, message = pcall(function()
      physics.newWorld({ gravty = 5 })
    end)
    assert.is_false(ok)
    assert.truthy(message:find("bad_input_spec.lua:", 1, true))
    local expected =
      'newWorld(settings): unknown setting "gravty" (did you mean "gravity"?); the settings are '
    assert.truthy(message:find(expected, 1, true))
    ok, message = pcall(physics.load, { [1] = 800 })
    assert.is_false(ok)
    assert.truthy(message:find("load(settings): unknown setting 1; the settings are", 1, true))
  end)

  it("list must be a table", function()
    refuses("newWorld(settings): settings must be a table, got 800", function()
      physics.newWorld(800)
    end)
  end)

  it("refused by load leaves the default world as it was", function()
    physics.load({ gravity = 5 })
    local objects = physics.objects
    pcall(physics.load, { gravity = "x" })
    assert.equal(objects, physics.objects)
    assert.equal(5, physics.gravity)
    physics.load()
  end)
end)

-- Calls -------------------------------------------------------------------------------------------

describe("update", function()
  for _, row in ipairs({
    { "nothing", nil, "a number >= 0, got nil" },
    { "a text", "0.1", 'a number >= 0, got "0.1"' },
    { "true", true, "a number >= 0, got true" },
    { "a table", {}, "a number >= 0, got table" },
    { "NaN", NAN, "a number >= 0, got nan" },
    { "a negative dt", -1, "a number >= 0, got -1" },
    { "infinity", INF, "a finite number >= 0, got inf" },
    { "minus infinity", -INF, "a finite number >= 0, got -inf" },
  }) do
    it("refuses " .. row[1], function()
      local scene = newScene()
      local before = snapshot(scene)
      refuses("world:update(dt): dt must be " .. row[3], function()
        scene.world:update(row[2])
      end)
      refuses("world:update(dt): dt must be " .. row[3], function()
        physics.update(row[2])
      end)
      assert.equal(before, snapshot(scene))
    end)
  end

  it("with a fixed step loses no time over a refused value", function()
    local settings = { gravity = 800, timestep = DT }
    for _, dt in ipairs({ DT, 2.5 * DT }) do
      local scene, twin = newScene(settings), newScene(settings)
      scene.box.width = -1
      for _ = 1, 4 do
        pcall(scene.world.update, scene.world, dt)
      end
      scene.box.width = 16
      for _ = 1, 20 do
        scene.world:update(dt)
        twin.world:update(dt)
        assert.equal(state(twin), state(scene))
      end
    end
  end)
end)

describe("add", function()
  for _, row in ipairs({
    { "no group", nil, "group must be a string or a number, got nil" },
    {
      "a group that is a table",
      {},
      "group must be a string or a number, got table (the group comes first, then the object)",
    },
    { "a group that is true", true, "group must be a string or a number, got true" },
    { "a group that is NaN", NAN, "group must be a string or a number, got nan" },
  }) do
    it("refuses " .. row[1], function()
      local world = physics.newWorld()
      refuses("world:add(group, object): " .. row[3], function()
        world:add(row[2], newBox())
      end)
      assert.is_nil(next(world.objects))
    end)
  end

  it("refuses the place as arguments", function()
    local world = physics.newWorld()
    refuses(
      "world:add(group, object): the place is a part of the object, as in"
        .. ' world:add("boxes", { x = 0, y = 0, width = 16, height = 16 })',
      function()
        world:add(newBox(), 1, 2, 16, 16)
      end
    )
    assert.is_nil(next(world.objects))
  end)

  it("refuses what is no object", function()
    local world = physics.newWorld()
    refuses("world:add(group, object): object must be a table, got nil", function()
      world:add("boxes")
    end)
    refuses('world:add(group, object): object must be a table, got "box"', function()
      world:add("boxes", "box")
    end)
    assert.is_nil(next(world.objects))
  end)

  it("refuses an object that stands in the world, seen or not", function()
    local world = physics.newWorld()
    local box = world:add("boxes", newBox())
    for _ = 1, 2 do
      refuses("world:add(group, object): the object already stands at objects.boxes[1]", function()
        world:add("crates", box)
      end)
      assert.is_nil(world.objects.crates)
      world:update(DT)
    end
    world.objects.player = newBox()
    world:update(DT)
    refuses("world:add(group, object): the object already stands at objects.player", function()
      world:add("boxes", world.objects.player)
    end)
  end)

  it("refuses a group that is none", function()
    local world = physics.newWorld()
    world.objects.player, world.objects.coins = newBox(), 5
    refuses("world:add(group, object): objects.player is not a group, got an object", function()
      world:add("player", newBox())
    end)
    refuses("world:add(group, object): objects.coins is not a group, got 5", function()
      world:add("coins", newBox())
    end)
    world.objects = 5
    refuses("objects must be a table of groups, got 5", function()
      world:add("boxes", newBox())
    end)
  end)
end)

describe("remove and refresh", function()
  it("refuse what is no table", function()
    local world = physics.newWorld()
    refuses("world:remove(object): object must be a table, got nil", function()
      world:remove()
    end)
    refuses("world:refresh(object): object must be a table, got 1", function()
      world:refresh(1)
    end)
    refuses("world:interpolate(object): object must be a table, got nil", function()
      world:interpolate()
    end)
  end)

  it("a stranger cannot be refreshed", function()
    refuses(
      "world:refresh(object): the object is not in the world (removed, or never added)",
      function()
        physics.newWorld():refresh(newBox())
      end
    )
  end)

  it("an object that is not in the world any more is neither refreshed nor dropped", function()
    local world = physics.newWorld()
    local box, tile = world:add("boxes", newBox()), newBox()
    tile.static, world.objects.tile = true, tile
    for n = 1, 3 do
      world:update(n > 1 and 1 / 60 or 0)
      world:remove(box)
      world.objects.tile, world.objects.others = nil, nil
      for _, object in ipairs({ box, tile }) do
        refuses(
          "world:refresh(object): the object is not in the world (removed, or never added)",
          function()
            world:refresh(object)
          end
        )
        refuses(
          "world:dropThrough(object): the object is not in the world (removed, or never added)",
          function()
            world:dropThrough(object)
          end
        )
      end
      -- In another place they are.
      world.objects.others, world.objects.tile = { tile }, box
      world:refresh(box)
      world:refresh(tile)
      assert.is_false(world:dropThrough(box))
    end
  end)

  it("an object that was not seen yet is checked by refresh, too", function()
    local world = physics.newWorld()
    local box, player = world:add("boxes", newBox()), newBox()
    box.mass, player.mass, world.objects.player = -1, 0, player
    refuses("objects.boxes[1].mass must be a number > 0, got -1", function()
      world:refresh(box)
    end)
    refuses("objects.player.mass must be a number > 0, got 0", function()
      world:refresh(player)
    end)
  end)

  it("no world without a table of objects lets fall", function()
    local world = physics.newWorld()
    world.objects = nil
    refuses("objects must be a table of groups, got nil", function()
      world:dropThrough(newBox())
    end)
  end)

  it("no world without a table of objects gives anybody an impulse", function()
    local world = physics.newWorld()
    world.objects = 3
    refuses("objects must be a table of groups, got 3", function()
      world:impulse(newBox(), 1, 0)
    end)
  end)
end)

describe("every method of a world", function()
  it("says so when it is called with a dot instead of a colon", function()
    local names = {}
    for name, method in pairs(getmetatable(physics.newWorld()).__index) do
      if type(method) == "function" then
        names[#names + 1] = name
      end
    end
    table.sort(names)
    for _, name in ipairs(names) do
      local world = physics.newWorld()
      for _, wrong in ipairs({ DT, "boxes", {} }) do
        local ok, message = pcall(function()
          world[name](wrong, newBox())
        end)
        assert.is_false(ok, name)
        local words = "must be called with a colon on a world, got " .. shown(wrong)
        assert.truthy(message:find(words, 1, true), name .. ": " .. message)
        assert.truthy(message:find("physics: world:" .. name .. "(", 1, true), message)
        assert.truthy(message:find("bad_input_spec.lua:", 1, true), message)
      end
    end
  end)
end)

describe("every function of the module", function()
  local NO_ARGUMENTS = { globals = true }

  it("says so when it is called with a colon instead of a dot, and does nothing", function()
    local names = {}
    for name, value in pairs(physics) do
      if type(value) == "function" and not NO_ARGUMENTS[name] then
        names[#names + 1] = name
      end
    end
    assert.is_true(#names > 25)
    table.sort(names)
    physics.load({ gravity = 800 })
    local coin = physics.add("coins", newBox())
    local hash = physics.hash()
    for _, name in ipairs(names) do
      for _, argument in ipairs({ DT, "coins", coin, {} }) do
        local ok, message = pcall(function()
          local result = physics[name](physics, argument, coin)
          return result
        end)
        assert.is_false(ok, name)
        local words = "physics: physics." .. name .. " must be called with a dot, not with a colon"
        assert.truthy(message:find(words, 1, true), message)
        assert.truthy(message:find("bad_input_spec.lua:", 1, true), message)
      end
      assert.is_false((pcall(physics[name], physics)), name)
    end
    assert.equal(hash, physics.hash())
    assert.equal(coin, physics.objects.coins[1])
    physics.load()
  end)
end)

-- canCollide --------------------------------------------------------------------------------------

describe("from inside canCollide", function()
  for _, row in ipairs({
    { "update(dt)", "update", DT },
    { "add(group, object)", "add", "boxes", newBox() },
    { "remove(object)", "remove", "lift" },
    { "refresh(object)", "refresh", "floor" },
  }) do
    it(row[1] .. " is refused", function()
      for _, which in ipairs({ "sleeper", "floor", "world" }) do
        local function make()
          local scene = newScene({ gravity = 800, rest = false })
          scene[which].canCollide = function()
            return true
          end
          scene.world:refresh(scene.floor)
          return scene
        end
        local scene, twin = make(), make()
        local works = scene[which].canCollide
        scene[which].canCollide = function()
          scene.world[row[2]](scene.world, scene[row[3]] or row[3], row[4])
        end
        scene.world:refresh(scene.floor)
        local before = snapshot(scene)
        local ok, message = pcall(scene.world.update, scene.world, DT)
        assert.is_false(ok)
        local words = "physics: world:" .. row[1] .. " cannot be called from inside canCollide"
        assert.truthy(message:find(words, 1, true), message)
        assert.truthy(message:find("bad_input_spec.lua:", 1, true))
        assert.equal(before, snapshot(scene))
        scene[which].canCollide = works
        scene.world:refresh(scene.floor)
        checkGoesOn(scene, twin, 11)
      end
    end)
  end
end)
