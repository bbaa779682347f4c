--- Wrong values: in which words they are refused, that the game's own line is blamed, and that a
--- refused call has changed nothing: repair the value, and the game goes on as if it never was. The
--- values of fields and settings are made from the rows of physics/fields/fields.lua. Whatever else
--- may be given stands in bad_matrix_spec.lua, how values and places are written in check_spec.lua.

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
  local world = physics.newWorld(settings or { gravity = 800 })
  local scene = {
    world = world,
    objects = world.objects,
    floor = { x = 0, y = 200, width = 400, height = 16, static = true },
    box = { x = 100, y = 150, width = 16, height = 16, vx = 30, restitution = 0.5 },
    sleeper = { x = 20, y = 184, width = 16, height = 16 },
    lift = { x = 160, y = 140, width = 64, height = 8, kinematic = true, vx = 20 },
    gate = { x = 300, y = 150, width = 8, height = 50, static = true, sensor = true },
  }
  world:add("floors", scene.floor)
  world:add("boxes", scene.box)
  world:add("boxes", scene.sleeper)
  world:add("lifts", scene.lift)
  world:add("gates", scene.gate)
  scene.boxes = world.objects.boxes
  for _ = 1, 5 do
    world:update(DT)
  end
  return scene
end

local function newBox(name, value)
  local box = { x = 50, y = 50, width = 16, height = 16 }
  if name then
    box[name] = value
  end
  return box
end

local function show(value)
  local kind = type(value)
  return kind == "number" and ("%.17g"):format(value) or kind == "table" and kind or tostring(value)
end

--- All fields of all objects as one text, numbers to the bit.
local function snapshot(scene)
  local lines = {}
  for _, name in ipairs(NAMES) do
    for key, value in pairs(scene[name]) do
      lines[#lines + 1] = name .. "." .. tostring(key) .. "=" .. show(value)
    end
    for side, other in pairs(scene[name].touching or {}) do
      lines[#lines + 1] = name .. ".touching." .. side .. "=" .. show(other)
    end
  end
  table.sort(lines)
  return table.concat(lines, "\n")
end

--- Fails unless two scenes go on the same way, to the bit.
local function checkGoesOn(scene, twin)
  for i = 1, 21 do
    scene.world:update(DT)
    twin.world:update(DT)
    if i % 10 == 1 then
      assert.equal(snapshot(twin), snapshot(scene))
    end
  end
end

-- Refusals ----------------------------------------------------------------------------------------

--- Makes a call that must be refused: with exactly this message, and blaming a line of the call.
local function refuses(expected, call, ...)
  local ok, message = pcall(call, ...)
  assert.is_false(ok, "it was not refused: " .. expected)
  local line, text = message:match("bad_input_spec%.lua:(%d+): physics: (.*)$")
  assert.truthy(line, "blames another line: " .. tostring(message))
  assert.equal(expected, text)
  local info = debug.getinfo(call, "S")
  line = tonumber(line)
  assert.is_true(line >= info.linedefined and line <= info.lastlinedefined, "blames line " .. line)
end

local function update(scene)
  scene.world:update(DT)
end

--- Spoils a scene; the next step, or another act, must be refused and change nothing. Repairs it
--- with what `spoil` returns, and it must go on like a twin to which all that never happened.
local function refusesStep(expected, spoil, settings, act)
  local scene, twin = newScene(settings), newScene(settings)
  local repair = spoil(scene)
  local before = snapshot(scene)
  for _ = 1, 2 do
    refuses(expected, act or update, scene)
    assert.equal(before, snapshot(scene))
  end
  repair()
  checkGoesOn(scene, twin)
end

--- Returns what spoils a scene by one value: in a part of it, under a key.
local function put(part, key, value)
  return function(scene)
    local owner = scene[part]
    local old = owner[key]
    owner[key] = value
    return function()
      owner[key] = old
    end
  end
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
  return place .. name .. " must be " .. expected .. ", got " .. shown(value) .. hint
end

local LATER =
  { box = "objects.boxes[1].", sleeper = "objects.boxes[2].", lift = "objects.lifts[1]." }

-- A value is refused in a new object and in one that is there. (`static` is read once, and a
-- callback that has no column when it would be called.)
local function checkValue(row, value, expected)
  local name = row.name
  local function message(place)
    return messageFor(place, name, expected, value)
  end
  local scene, box = newScene(), newBox(name, value)
  for group, place in pairs({ boxes = "objects.boxes[3].", crates = "objects.crates[1]." }) do
    refuses(message(place), function()
      scene.world:add(group, box)
    end)
  end
  assert.same(
    { 2, false, false },
    { #scene.boxes, scene.objects.crates or false, box.touching or false }
  )
  refusesStep(message("objects.boxes[3]."), put("boxes", 3, newBox(name, value)))
  refusesStep(message("objects.player."), put("objects", "player", newBox(name, value)))
  refusesStep(message("objects.floors[1]."), put("floor", name, value), nil, function(its)
    its.world:refresh(its.floor)
  end)
  for part, place in pairs(LATER) do
    if name ~= "static" and (row.column or row.type ~= "function") then
      refusesStep(message(place), put(part, name, value))
    end
  end
end

describe("the field", function()
  for _, row in ipairs(fields.objects) do
    local values, expected = {}, nil
    if not row.written then
      values, expected = wrongOf(row)
    end
    for _, value in ipairs(values) do
      it(row.name .. " refuses " .. shown(value) .. ", at first and later", function()
        checkValue(row, value, expected)
      end)
    end
    if row.required then
      it(row.name .. " may not be missing, at first and later", function()
        checkValue(row, nil, expected)
      end)
    end
  end

  -- `update` makes a number of a velocity that is not there.
  for part, place in pairs({ box = "boxes", lift = "lifts" }) do
    for name, other in pairs({ vx = "vy", vy = "vx" }) do
      it(name .. " of a " .. part .. " is not false, also beside one that is missing", function()
        local expected = ("objects.%s[1].%s must be a number, got false"):format(place, name)
        refusesStep(expected, function(scene)
          local repair, repairOther = put(part, name, false)(scene), put(part, other, nil)(scene)
          return function()
            repair()
            repairOther()
          end
        end)
      end)
    end
  end

  it("slope is refused of what is dynamic, or becomes it", function()
    local expected = 'slope must be nil for a dynamic object, got "left"'
      .. " (set static = true or kinematic = true)"
    local scene = newScene()
    refuses("objects.boxes[3]." .. expected, function()
      scene.world:add("boxes", newBox("slope", "left"))
    end)
    refusesStep("objects.boxes[1]." .. expected, put("box", "slope", "left"))
    refusesStep("objects.boxes[2]." .. expected, put("sleeper", "slope", "left"))
    scene.lift.slope = "left"
    scene.world:update(DT)
    scene.lift.kinematic = nil
    refuses("objects.lifts[1]." .. expected, update, scene)
  end)

  for _, name in ipairs({ "onBegin", "onEnd" }) do
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
end)

describe("onBegin that another callback spoils", function()
  for which, row in pairs({
    player = { "objects.player", 2 },
    crate = { "objects.crates[1]", 1 },
    world = { "world", 0 },
  }) do
    it("is refused before it is called, and not lost: " .. which, function()
      local world = physics.newWorld({ gravity = 0 })
      local coin = { x = 0, y = 0, width = 8, height = 8, static = true, sensor = true }
      local crate = world:add("crates", { x = 40, y = 0, width = 16, height = 16, vx = 0.5 })
      local player = { x = 56, y = 0, width = 16, height = 16, vx = -0.5 }
      world.objects.player = player
      world:add("coins", coin)
      local guest = world:add("aGuest", { x = 2, y = 2, width = 4, height = 4 })
      local owner, told = ({ player = player, crate = crate, world = world })[which], 0
      local function count()
        told = told + 1
      end
      crate.onBegin, player.onBegin, world.onBegin = count, count, count
      guest.onBegin = function()
        owner.onBegin = "boom"
      end
      refuses(row[1] .. '.onBegin must be a function, got "boom"', function()
        world:update(DT)
      end)
      -- By then the world has heard, of the guest's event, and the crate, if it comes first.
      assert.equal(row[2], told)
      owner.onBegin = count
      world:update(DT)
      assert.equal(4, told)
    end)
  end
end)

-- Places and settings -----------------------------------------------------------------------------

-- Twice in the world: the first place, the second one.
local function twice(second, first)
  return second
    .. " is the same object as "
    .. first
    .. ": an object must be in one place only, got table in two"
end

describe("a step refuses", function()
  local key = " has a key that is neither a number nor a string, got "
  -- what is said, what spoils the scene, settings
  for _, row in ipairs({
    { "objects must be a table of groups, got 7", put("world", "objects", 7) },
    {
      "objects.coins must be a group (a table of objects) or an object, got 5",
      put("objects", "coins", 5),
    },
    { "objects" .. key .. "true", put("objects", true, {}) },
    { "objects" .. key .. "table", put("objects", NAMES, {}) },
    { "objects.boxes" .. key .. "table", put("boxes", NAMES, newBox()) },
    { "objects.boxes" .. key .. "false", put("boxes", false, newBox()) },
    { 'objects.boxes[3] must be an object (a table), got "crate"', put("boxes", 3, "crate") },
    { "objects.boxes.hit must be an object (a table), got function", put("boxes", "hit", print) },
    {
      twice("objects.boxes[3]", "objects.boxes[1]"),
      function(scene)
        return put("boxes", 3, scene.box)(scene)
      end,
    },
    {
      twice("objects.coins[1]", "objects.boxes[2]"),
      function(scene)
        return put("objects", "coins", { scene.sleeper })(scene)
      end,
    },
    {
      twice("objects.player", "objects.lifts[1]"),
      function(scene)
        return put("objects", "player", scene.lift)(scene)
      end,
    },
    {
      "objects.boxes[1].mask.lifts must be true or false, got 0",
      put("box", "mask", { lifts = 0 }),
    },
    { "world.gravity must be a number, got nil", put("world", "gravity", nil) },
    {
      "world.maxStep must be a number in 1e-05..0.25, got nil",
      put("world", "maxStep", nil),
    },
    {
      "world.masks.boxes.gates must be true or false, got 0",
      function(scene)
        scene.masks = scene.world.masks.boxes
        return put("masks", "gates", 0)(scene)
      end,
      { gravity = 800, masks = { boxes = { gates = false } } },
    },
  }) do
    it(row[1], function()
      refusesStep(row[1], row[2], row[3])
    end)
  end

  it("the first that is wrong, and nothing new enters before all is right", function()
    local scene = newScene()
    local good, bad = newBox(), newBox("mass", 0)
    scene.boxes[3], scene.boxes[4] = good, bad
    refuses("objects.boxes[4].mass must be a number > 0, got 0", update, scene)
    assert.is_nil(good.touching)
    bad.mass = 2
    scene.world:update(DT)
    assert.is_table(good.touching)
    assert.equal(7, scene.world.stats.objects)
  end)
end)

describe("the setting", function()
  for _, row in ipairs(fields.settings) do
    local values, expected = wrongOf(row)
    for _, value in ipairs(values) do
      it(row.name .. " refuses " .. shown(value) .. ", at first and later", function()
        local text = messageFor("", row.name, expected, value)
        refuses("newWorld(settings): " .. text, function()
          physics.newWorld({ [row.name] = value })
        end)
        refuses("load(settings): " .. text, function()
          physics.load({ [row.name] = value })
        end)
        refusesStep("world." .. text, put("world", row.name, value))
      end)
    end
  end

  it("that load refuses leaves the default world as it was", function()
    physics.load({ gravity = 5 })
    local objects = physics.objects
    pcall(physics.load, { gravity = "x" })
    assert.equal(objects, physics.objects)
    assert.equal(5, physics.gravity)
    physics.load()
  end)
end)

-- Calls -------------------------------------------------------------------------------------------

describe("world:update(dt)", function()
  for _, row in ipairs({
    { nil, "a number >= 0, got nil" },
    { "0.1", 'a number >= 0, got "0.1"' },
    { {}, "a number >= 0, got table" },
    { NAN, "a number >= 0, got nan" },
    { -1, "a number >= 0, got -1" },
    { INF, "a finite number >= 0, got inf" },
  }) do
    it("refuses " .. row[2], function()
      local scene = newScene()
      local before = snapshot(scene)
      refuses("world:update(dt): dt must be " .. row[2], function()
        scene.world:update(row[1])
      end)
      refuses("world:update(dt): dt must be " .. row[2], function()
        physics.update(row[1])
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
        assert.equal(snapshot(twin), snapshot(scene))
      end
    end
  end)
end)

local ADD = "world:add(group, object): "
local NO_WORLD = "the object is not in the world (removed, or never added)"

-- What is said, the method, its arguments; there are a box, a player and a bad crate.
local function newCalls(box, player, crate)
  local group = "group must be a string or a number, got "
  return {
    { ADD .. group .. "nil", "add", nil, newBox() },
    { ADD .. group .. "table (the group comes first, then the object)", "add", {}, newBox() },
    { ADD .. group .. "nan", "add", NAN, newBox() },
    {
      ADD
        .. "the place is a part of the object, as in"
        .. ' world:add("boxes", { x = 0, y = 0, width = 16, height = 16 })',
      "add",
      newBox(),
      1,
      2,
    },
    { ADD .. "object must be a table, got nil", "add", "boxes" },
    { ADD .. "the object already stands at objects.boxes[1]", "add", "crates", box },
    { ADD .. "the object already stands at objects.player", "add", "crates", player },
    { ADD .. "objects.player is not a group, got an object", "add", "player", newBox() },
    { ADD .. "objects.coins is not a group, got 5", "add", "coins", newBox() },
    { "world:remove(object): object must be a table, got nil", "remove" },
    { "world:refresh(object): object must be a table, got 1", "refresh", 1 },
    { "world:interpolate(object): object must be a table, got nil", "interpolate" },
    { "world:refresh(object): " .. NO_WORLD, "refresh", newBox() },
    { "objects.crate.mass must be a number > 0, got 0", "refresh", crate },
  }
end

describe("a call refuses", function()
  for n, title in ipairs(newCalls()) do
    it(title[1], function()
      local world = physics.newWorld()
      local box, objects = world:add("boxes", newBox()), world.objects
      objects.player = newBox()
      world:update(DT)
      objects.crate, objects.coins = newBox("mass", 0), 5
      local row = newCalls(box, objects.player, objects.crate)[n]
      refuses(row[1], function()
        world[row[2]](world, unpackList(row, 3, 6))
      end)
      assert.same({ 1, false }, { #objects.boxes, objects.crates or false })
    end)
  end

  it("to be made where there is no table of objects", function()
    local world = physics.newWorld()
    world.objects = 3
    for _, call in ipairs({ { "add", "boxes" }, { "impulse", nil, 1, 0 }, { "dropThrough" } }) do
      refuses("objects must be a table of groups, got 3", function()
        world[call[1]](world, call[2] or newBox(), call[3] or newBox(), call[4])
      end)
    end
  end)

  it("an object that is not in the world any more, but not in another place", function()
    local world = physics.newWorld()
    local box, tile = world:add("boxes", newBox()), newBox("static", true)
    world.objects.tile = tile
    for n = 1, 3 do
      world:update(n > 1 and DT or 0)
      world:remove(box)
      world.objects.tile, world.objects.others = nil, nil
      for _, object in ipairs({ box, tile }) do
        refuses("world:refresh(object): " .. NO_WORLD, function()
          world:refresh(object)
        end)
        refuses("world:dropThrough(object): " .. NO_WORLD, function()
          world:dropThrough(object)
        end)
      end
      world.objects.others, world.objects.tile = { tile }, box
      world:refresh(box)
      world:refresh(tile)
      assert.is_false(world:dropThrough(box))
    end
  end)
end)

-- The names of the functions of a table, sorted.
local function functionsOf(methods)
  local names = {}
  for name, method in pairs(methods) do
    if type(method) == "function" and name ~= "globals" then -- which takes nothing
      names[#names + 1] = name
    end
  end
  table.sort(names)
  assert.is_true(#names > 25)
  return names
end

-- Makes a call that must be refused with these words in the message.
local function refusesWith(words, call)
  local ok, message = pcall(call)
  assert.is_false(ok, words)
  assert.truthy(message:find(words, 1, true), message)
  assert.truthy(message:find("bad_input_spec.lua:", 1, true), message)
end

describe("every", function()
  it("method of a world says so when it is called with a dot instead of a colon", function()
    local world = physics.newWorld()
    for _, name in ipairs(functionsOf(getmetatable(world).__index)) do
      for _, wrong in ipairs({ DT, "boxes", {} }) do
        local words = "must be called with a colon on a world, got " .. shown(wrong)
        for _, part in ipairs({ words, "physics: world:" .. name .. "(" }) do
          refusesWith(part, function()
            world[name](wrong, newBox())
          end)
        end
      end
    end
  end)

  it("function says so when it is called with a colon, and does nothing", function()
    physics.load({ gravity = 800 })
    local coin = physics.add("coins", newBox())
    local hash = physics.hash()
    for _, name in ipairs(functionsOf(physics)) do
      local words = "physics: physics." .. name .. " must be called with a dot, not with a colon"
      for _, argument in ipairs({ DT, "coins", coin, {} }) do
        refusesWith(words, function()
          local result = physics[name](physics, argument, coin)
          return result
        end)
      end
      assert.is_false((pcall(physics[name], physics)), name)
    end
    assert.equal(hash, physics.hash())
    assert.equal(coin, physics.objects.coins[1])
    physics.load()
  end)
end)

describe("canCollide", function()
  for _, row in ipairs({
    { "update(dt)", "update", DT },
    { "add(group, object)", "add", "boxes", newBox() },
    { "remove(object)", "remove", "lift" },
    { "refresh(object)", "refresh", "floor" },
  }) do
    it("may not call " .. row[1], function()
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
        twin[which].canCollide = works
        twin.world:refresh(twin.floor)
        scene[which].canCollide = function()
          scene.world[row[2]](scene.world, scene[row[3]] or row[3], row[4])
        end
        scene.world:refresh(scene.floor)
        local before = snapshot(scene)
        refusesWith(
          "physics: world:" .. row[1] .. " cannot be called from inside canCollide",
          function()
            scene.world:update(DT)
          end
        )
        assert.equal(before, snapshot(scene))
        scene[which].canCollide = works
        scene.world:refresh(scene.floor)
        checkGoesOn(scene, twin)
      end
    end)
  end
end)
