--- Errors: their words, and the line they name; debugging_bad_input_spec.lua has the wrong values,
--- and shows that nothing has changed. What loads physics/fields/check.lua itself is tagged #files:
--- there is no such file when the library is one.

local files = require("spec.support.files")
local physics = require("physics")
local small = require("spec.support.small")

local compile = require("spec.support.snippets").compile

local NAN, INF = 0 / 0, 1 / 0

--- Runs a call that must be refused. It must blame this file, and say exactly this.
local function refuses(expected, call)
  local ok, message = pcall(call)
  assert.is_false(ok, "it was not refused: " .. expected)
  assert.truthy(message:find("debugging_errors_spec.lua:", 1, true), message)
  assert.equal("physics: " .. expected, (message:gsub("^.-debugging_errors_spec%.lua:%d+: ", "")))
end

--- A complete object with some fields changed.
local function object(changes)
  return small.put(1, 2, 3, 4, changes)
end

-- The line ----------------------------------------------------------------------------------------

local CHECK, BACK = "physics/fields/check.lua", "\\physics\\fields\\check.lua"

--- What is said in a program of these files: each calls the next one on its second line, and the
--- last, of the library, fails. `place` is that of physics/fields/check.lua.
local function saidIn(place, chain, environment)
  local check = compile(files.read(CHECK), "@" .. place, environment or _G)("physics.fields.check")
  local text = "local call = ...\nreturn function() call('oops')\n end"
  local call = check.fail
  for n = #chain, 1, -1 do
    call = compile(text, "@" .. chain[n], {})(call)
  end
  return select(2, pcall(call))
end

describe("every function: the line that an error names", function()
  it("is the one that calls the library, also by pcall, and none where there is none", function()
    local world = physics.newWorld()
    local line = debug.getinfo(1, "l").currentline
    local _, message = pcall(function()
      world:update(-1)
      return nil
    end)
    assert.truthy(
      message:find("debugging_errors_spec.lua:" .. line + 2 .. ": physics: world:update", 1, true)
    )
    line = debug.getinfo(1, "l").currentline + 1
    local _, other = pcall(world.update, world, -1)
    assert.truthy(
      other:find("debugging_errors_spec.lua:" .. line .. ": physics: world:update", 1, true)
    )
    local resume = coroutine.wrap(function()
      return pcall(coroutine.wrap(world.update), world, -1)
    end)
    assert.matches("^physics: world:update", select(2, resume()))
  end)

  -- where check.lua is, which file of the library is called, which file of the game calls
  small.rows("is the game's in {1} #files", {
    { "the folder of the game", CHECK, "physics.lua", "main.lua" },
    { "a folder for libraries", "lib/" .. CHECK, "lib/physics.lua", "main.lua" },
    { "a folder with init.lua", "lib/" .. CHECK, "lib/physics/init.lua", "main.lua" },
    { "a search path with a dot", "./" .. CHECK, "./physics.lua", "./spec/a_spec.lua" },
    { "an installed rock", "/usr/lua/" .. CHECK, "/usr/lua/physics.lua", "main.lua" },
    { "Windows", ".\\lib" .. BACK, ".\\lib\\physics.lua", ".\\main.lua" },
    { "Program Files", "C:\\Program Files" .. BACK, "C:\\Program Files\\physics.lua", "main.lua" },
    { "a share", "\\\\server\\share" .. BACK, "\\\\server\\share\\physics.lua", "main.lua" },
    { "a path with both separators", "./physics\\fields\\check.lua", "./physics.lua", "main.lua" },
    { "one joined file", "lib/physics.lua", "lib/physics.lua", "lib/main.lua" },
    { "a folder like another", CHECK, "physics.lua", "physics-game/a.lua" },
    { "a folder like a file", CHECK, "physics.lua", "physics2.lua" },
  }, function(_, place, library, game)
    assert.equal(game .. ":2: physics: oops", saidIn(place, { game, library }))
  end)

  it("is that of a callback which misuses the library #files", function()
    local chain = { "main.lua", "physics/contacts/events.lua", "callback.lua", "physics.lua" }
    assert.equal("callback.lua:2: physics: oops", saidIn(CHECK, chain))
  end)

  it("is the third level's where there is no debug library #files", function()
    local environment = setmetatable({ debug = false }, { __index = _G })
    assert.equal(
      "main.lua:2: physics: oops",
      saidIn(CHECK, { "main.lua", "physics.lua" }, environment)
    )
  end)
end)

-- The words ---------------------------------------------------------------------------------------

describe("every function: an error", function()
  local forty = ("0123456789"):rep(4)
  local tagged = setmetatable({}, { __tostring = type })
  it("shows values in a way that is the same on every Lua", function()
    for _, row in ipairs({
      { 3.0, "3" },
      { -0.5, "-0.5" },
      { 0.1, "0.1" },
      { 1e300, "1e+300" },
      { -NAN, "nan" },
      { -INF, "-inf" },
      { 'a "b"\\\n\t\r\1', [["a \"b\"\\\n\t\r\001"]] },
      { forty, '"' .. forty .. '"' },
      { forty .. "x", '"' .. forty .. '..."' },
      { ("a"):rep(39) .. "éé", '"' .. ("a"):rep(39) .. '..."' },
      { ("\128"):rep(50), '"..."' },
      { tagged, "table" },
      { io.stdout, "userdata" },
      { coroutine.create(function() end), "thread" },
    }) do
      refuses("newWorld(settings): rest must be true or false, got " .. row[2], function()
        physics.newWorld({ rest = row[1] })
      end)
    end
  end)

  small.rows("names the place {3}", {
    { "boxes", 3.0, "objects.boxes[3]" },
    { "boxes", 1.5, "objects.boxes[1.5]" },
    { "enemies", "spike", "objects.enemies.spike" },
    { "player", nil, "objects.player" },
    { "my group", 1, 'objects["my group"][1]' },
    { "end", "2nd", 'objects["end"]["2nd"]' },
    { -1, "a", "objects[-1].a" },
  }, function(group, key, place)
    local world, bad = physics.newWorld(), object({ mass = 0 })
    world.objects[group] = key == nil and bad or { [key] = bad }
    refuses(place .. ".mass must be a number > 0, got 0", function()
      world:update(0)
    end)
  end)

  -- what is wrong, and what the message says behind the place
  small.rows("of an object says: {2}", {
    { { x = 1e101 }, ".x must be a number in -1e+100..1e+100, got 1e+101" },
    { { drag = 1e101 }, ".drag must be a number in 0..1e+100, got 1e+101" },
    { { width = 1e101 }, ".width must be a number > 0 and <= 1e+100, got 1e+101" },
    { { mass = 1e-101 }, ".mass must be a number >= 1e-100, got 1e-101" },
    { { sensor = 1 }, ".sensor must be true or false, got 1" },
    { { onEnd = "x" }, '.onEnd must be a function, got "x"' },
    { { hits = 5 }, ".hits must be a list of group names, got 5" },
    { { mask = 5 }, ".mask must be a table { [group] = false }, got 5" },
    { { mask = { "enemies" } }, '.mask[1] must be true or false, got "enemies"' },
    { { mask = { b = 2, a = 1, c = 3 } }, ".mask.a must be true or false, got 1" },
    { { mask = { [true] = false } }, ".mask must have group names as keys, got true" },
    { { y = NAN, width = -1, friction = "x" }, ".y must be a number, got nan" }, -- the first one
    {
      { width = 8, height = 8, radius = 4, slope = "left" },
      '.slope must be nil where there is a radius, got "left"',
    },
    {
      { slope = "left" },
      '.slope must be nil for a dynamic object (set static = true or kinematic = true), got "left"',
    },
  }, function(fields, words)
    refuses("objects.boxes[1]" .. words, function()
      physics.newWorld():add("boxes", object(fields))
    end)
  end)

  it("is raised for what is inherited from a class, not for fields of the game", function()
    local Box = { width = 10, height = 10, friction = 0.5 }
    Box.__index = Box
    local world = physics.newWorld()
    world:add("boxes", setmetatable({ x = 0, y = 0 }, Box))
    world:add("boxes", object({ image = "box.png", health = NAN, touching = 5 }))
    Box.friction = "rough"
    refuses('objects.boxes[3].friction must be a number >= 0, got "rough"', function()
      world:add("boxes", setmetatable({ x = 0, y = 0 }, Box))
    end)
  end)
end)

-- Settings ----------------------------------------------------------------------------------------

describe("newWorld(settings)", function()
  small.rows("refuses: {2}", {
    { 800, "settings must be a table, got 800" },
    { { push = "x" }, 'push must be "both" or "first", got "x"' },
    { { soft = 5 }, "soft must be a table { [group] = { [group] = px/s } }, got 5" },
    { { masks = 5 }, "masks must be a table { [group] = { [group] = false } }, got 5" },
    { { soft = { a = { b = -1 } } }, "soft.a.b must be a number in 0..1000000, got -1" },
    { { soft = { a = { b = true } } }, "soft.a.b must be a number in 0..1000000, got true" },
    { { soft = { a = 5 } }, "soft.a must be a table { [group] = px/s }, got 5" },
    { { soft = { [true] = {} } }, "soft must have group names as keys, got true" },
    { { soft = { a = { [true] = 1 } } }, "soft.a must have group names as keys, got true" },
    { { order = { 1, NAN } }, "order[2] must be a group name, got nan" },
    { { masks = { a = { b = "no" } } }, 'masks.a.b must be true or false, got "no"' },
    { { masks = { [1] = { ["my b"] = 0 } } }, 'masks[1]["my b"] must be true or false, got 0' },
    { { masks = { [print] = {} } }, "masks must have group names as keys, got function" },
  }, function(settings, words)
    refuses("newWorld(settings): " .. words, function()
      physics.newWorld(settings)
    end)
  end)

  local ALL = "; the settings are gravity, gravityX, push, masks, soft, sideBySide, broadphase,"
    .. " cellSize, timestep, maxStep, order, ownFields, rest, checked, profile, onStep, onBegin,"
    .. " onStay, onEnd, onCrush, canCollide"

  local UNKNOWN = "load(settings): unknown setting "

  it("names an unknown setting, what it may mean, and all that there are", function()
    for _, row in ipairs({
      { "wind", '"wind"' },
      { "gravty", '"gravty" (did you mean "gravity"?)' },
      { "gravtiy", '"gravtiy" (did you mean "gravity"?)' },
      { "gravityx", '"gravityx" (did you mean "gravityX"?)' },
      { 1, "1" },
      { true, "true" },
    }) do
      refuses(UNKNOWN .. row[2] .. ALL, function()
        physics.load({ [row[1]] = 1, gravity = 0 })
      end)
    end
  end)

  it("names the first unknown setting in order, whatever the order of the table", function()
    local settings = { zebra = 1, apple = 2, [2] = 3, [1] = 4, [true] = 5 }
    for _, key in ipairs({ true, 1, 2, "apple", "zebra" }) do
      local shown = type(key) == "string" and '"' .. key .. '"' or tostring(key)
      refuses(UNKNOWN .. shown .. ALL, function()
        physics.load(settings)
      end)
      settings[key] = nil
    end
  end)
end)

-- Groups and filters ------------------------------------------------------------------------------

describe("add: a group", function()
  it("may be any string or number, in filters also a list or a function", function()
    local world = physics.newWorld()
    for n, name in ipairs({ "boxes", "", 1, -1.5 }) do
      world:add(name, object({ x = 10 * n }))
    end
    for _, filter in ipairs({ "boxes", 1, { "boxes", 1 }, {}, print }) do
      world:queryPoint(-9, 0, filter)
    end
    refuses("world:add(group, object): group must be a string or a number, got inf", function()
      world:add(INF, object())
    end)
  end)

  small.rows("filter refuses: {2}", {
    { true, " must be a group name, a list of them or a function, got true" },
    { NAN, " must be a group name, a list of them or a function, got nan" },
    { { "boxes", {} }, "[2] must be a group name, got table" },
  }, function(filter, words)
    local world = physics.newWorld()
    refuses("world:queryPoint(x, y): filter" .. words, function()
      world:queryPoint(0, 0, filter)
    end)
  end)
end)

-- Steps and calls ---------------------------------------------------------------------------------

-- Says that an object stands in two places.
local function twice(second, first)
  return ("objects.%s is the same object as objects.%s"):format(second, first)
    .. ": an object must be in one place only, got table in two"
end

local key = " has a key that is no finite number or string, got "
local member = object()
-- what is said of these objects, beside a box
small.rows("world:update, save and hash refuses: {1}; nothing has entered", {
  { "objects must be a table of groups, got 7", 7 },
  { "objects must be a table of groups, got nil" },
  { "objects.coins must be a group (a table of objects) or an object, got 5", { coins = 5 } },
  { "objects" .. key .. "true", { [true] = {} } },
  { "objects.boxes" .. key .. "table", { boxes = { [{}] = object() } } },
  { "objects" .. key .. "inf", { [INF] = { object() } } },
  { "objects.boxes" .. key .. "-inf", { boxes = { [-INF] = object() } } },
  { 'objects.boxes[3] must be an object (a table), got "crate"', { boxes = { [3] = "crate" } } },
  { "objects.boxes.hit must be an object (a table), got function", { boxes = { hit = print } } },
  { twice("boxes[3]", "boxes[1]"), { boxes = { member, [3] = member } } },
  { twice("coins[1]", "boxes[1]"), { boxes = { member }, coins = { member } } },
  { twice("player", "boxes[1]"), { boxes = { member }, player = member } },
  {
    "objects.boxes[2].mass must be a number > 0, got 0",
    { boxes = { member, object({ mass = 0 }) } },
  },
}, function(words, objects)
  local world = physics.newWorld({ order = { "boxes" } })
  world.objects, member.touching = objects, nil
  for _, call in ipairs({ "update", "save", "hash" }) do
    refuses(words, function()
      world[call](world, call == "update" and 1 / 60 or nil)
    end)
  end
  assert.is_nil(member.touching)
end)

it("world:update refuses a group of objects that gets the fields of an object", function()
  local world = physics.newWorld()
  local boxes = { object() }
  world.objects = { boxes = boxes }
  world:update(1 / 60)
  small.set(boxes, object())
  refuses("objects.boxes.height must be an object (a table), got 4", function()
    world:update(1 / 60)
  end)
end)

describe("world:update", function()
  small.rows("refuses dt that is not {2}", {
    { "0.1", 'a number >= 0, got "0.1"' },
    { -1, "a number >= 0, got -1" },
    { INF, "a finite number >= 0, got inf" },
  }, function(dt, words)
    refuses("world:update(dt): dt must be " .. words, function()
      physics.update(dt)
    end)
  end)

  it("refuses masks that were spoiled in place", function()
    local world = physics.newWorld({ masks = { boxes = { gates = false } } })
    world.masks.boxes.gates = 0
    refuses("world.masks.boxes.gates must be true or false, got 0", function()
      world:update(0)
    end)
  end)

  small.rows("refuses a bad {1}, and loses no event", { "onBegin", "onEnd" }, function(name)
    local world, told = physics.newWorld({ gravity = 0 }), { count = 0 }
    local wall = world:add("walls", { x = 20, y = 0, width = 4, height = 16, static = true })
    local box = world:add("boxes", { x = 0, y = 0, width = 16, height = 16 })
    wall[name] = function()
      told.count = told.count + 1
    end
    world:update(1 / 60)
    box[name], box.vx = "bang", 960
    refuses("objects.boxes[1]." .. name .. ' must be a function, got "bang"', function()
      world:update(1 / 60)
      box.vx = -960
      world:update(1 / 60)
    end)
    assert.equal(0, told.count)
    box[name] = nil
    world:update(1 / 60)
    assert.equal(1, told.count)
  end)
end)

local ADD = "world:add(group, object): "
local NO_WORLD = "the object is not in the world (removed, or never added)"

describe("every function: a call", function()
  local BOX, PLAYER, CRATE, NEW = "box", "player", "crate", "new" -- stand for objects of the world
  local group = "group must be a string or a number, got "
  -- what is said, the method, its arguments
  small.rows("says: {1}", {
    { ADD .. group .. "nil", "add", nil, object() },
    { ADD .. group .. "table", "add", {}, object() },
    { ADD .. group .. "nan", "add", NAN, object() },
    { ADD .. "object must be a table, got nil", "add", "boxes" },
    { ADD .. "the object already stands at objects.boxes[1]", "add", "crates", BOX },
    { ADD .. "the object already stands at objects.player", "add", "crates", PLAYER },
    { ADD .. "the object already stands at objects.new[1]", "add", "crates", NEW },
    { ADD .. "objects.player is not a group, got an object", "add", "player", object() },
    { ADD .. "objects.coins is not a group, got 5", "add", "coins", object() },
    { "world:remove(object): object must be a table, got nil", "remove" },
    { "world:refresh(object): object must be a table, got 1", "refresh", 1 },
    { "world:interpolate(object): object must be a table, got nil", "interpolate" },
    { "world:load(object): object must be a table, got nil", "load" },
    { "world:load(object): out must be a table, got 3", "load", BOX, 3 },
    { "world:load(object): " .. NO_WORLD, "load", object() },
    { "world:refresh(object): " .. NO_WORLD, "refresh", object() },
    { "objects.crate.mass must be a number > 0, got 0", "refresh", CRATE },
  }, function(words, method, given, second, third)
    local world = physics.newWorld()
    local objects = world.objects
    local named = { [BOX] = world:add("boxes", object()), [PLAYER] = object() }
    objects.player = named[PLAYER]
    world:update(1 / 60)
    named[CRATE], objects.coins = object({ mass = 0 }), 5
    named[NEW] = world:add("new", object()) -- no update has read it
    objects.crate = named[CRATE]
    refuses(words, function()
      local first = method ~= "add" and named[given] or given
      world[method](world, first, named[second] or second, third)
    end)
    assert.same({ 1, false }, { #objects.boxes, objects.crates or false })
  end)

  it("says which field is missing from an object in place of a group", function()
    local world = physics.newWorld()
    for missing, given in pairs({ y = { x = 5 }, x = { y = 5 } }) do
      world.objects.player = given
      refuses("objects.player." .. missing .. " must be a number, got nil", function()
        world:update(0)
      end)
    end
  end)

  it("says that objects is no table, whichever it is", function()
    local world = physics.newWorld()
    world.objects = 3
    for _, call in ipairs({ { "add", "boxes" }, { "impulse", nil, 1, 0 }, { "dropThrough" } }) do
      refuses("objects must be a table of groups, got 3", function()
        world[call[1]](world, call[2] or object(), call[3] or object(), call[4])
      end)
    end
  end)

  it("knows no object that has left, and one that has only got another place", function()
    local world = physics.newWorld()
    local box, tile = world:add("boxes", object()), object({ static = true })
    world.objects.tile = tile
    for n = 1, 3 do
      world:update(n > 1 and 1 / 60 or 0)
      world:remove(box)
      world.objects.tile, world.objects.others = nil, nil
      for _, name in ipairs({ "refresh", "dropThrough" }) do
        for _, its in ipairs({ box, tile }) do
          refuses("world:" .. name .. "(object): " .. NO_WORLD, function()
            world[name](world, its)
          end)
        end
      end
      world.objects.others, world.objects.tile = { tile }, box
      world:refresh(box)
      world:refresh(tile)
      assert.is_false(world:dropThrough(box))
    end
  end)

  it("of load that is refused leaves the default world as it was", function()
    physics.load({ gravity = 5 })
    local objects = physics.objects
    pcall(physics.load, { gravity = "x" })
    assert.same({ objects, 5 }, { physics.objects, physics.gravity })
    physics.load()
  end)
end)
