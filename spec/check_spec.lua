--- Errors: their words, and the line they name; bad_input_spec.lua has the wrong values. What loads
--- physics/fields/check.lua itself is tagged #files: there is no such file when the library is one.

local check = require("physics.fields.check")
local physics = require("physics")

local NAN, INF = 0 / 0, 1 / 0

--- Runs a call that must be refused. It must blame this file, and say exactly this.
local function refuses(expected, call)
  local ok, message = pcall(call)
  assert.is_false(ok, "it was not refused: " .. expected)
  assert.truthy(message:find("check_spec.lua:", 1, true), message)
  assert.equal("physics: " .. expected, (message:gsub("^.-check_spec%.lua:%d+: ", "")))
end

--- A complete object with some fields changed.
local function object(changes)
  local result = { x = 1, y = 2, width = 3, height = 4 }
  for name, value in pairs(changes or {}) do
    result[name] = value
  end
  return result
end

-- The line ----------------------------------------------------------------------------------------

--- Compiles a text under a chunk name, in an environment of its own.
local function compile(text, chunkName, environment)
  local setEnvironment = rawget(_G, "setfenv")
  if setEnvironment then
    return setEnvironment(assert(rawget(_G, "loadstring")(text, chunkName)), environment)
  end
  return assert(load(text, chunkName, "t", environment))
end

--- Loads physics/fields/check.lua as if its file had another name.
local function loadCheck(chunkName, environment)
  local file = assert(io.open((debug.getinfo(check.fail, "S").source:gsub("^@", ""))))
  local text = file:read("*a")
  file:close()
  return compile(text, chunkName, environment or _G)("physics.fields.check")
end

--- A function of the library in a chunk of this name, which fails.
local function libraryFunction(loaded, chunkName)
  local text = 'local check = ... return function() check.fail("oops") end'
  return compile(text, chunkName, {})(loaded)
end

--- What is said when a chunk of the game calls a function on its second line.
local function gameFunction(chunkName, call)
  return compile("local call = ...\nreturn function() call()\n end", chunkName, {})(call)
end

local function messageOf(call)
  return select(2, pcall(call))
end

local CHECK, BACK = "physics/fields/check.lua", "\\physics\\fields\\check.lua"

describe("the line that an error names", function()
  it("is the one that calls the library, also by pcall, and none where there is none", function()
    local world = physics.newWorld()
    local line = debug.getinfo(1, "l").currentline
    local message = messageOf(function()
      world:update(-1)
      return nil
    end)
    assert.truthy(message:find("check_spec.lua:" .. line + 2 .. ": physics: world:update", 1, true))
    line = debug.getinfo(1, "l").currentline + 1
    local _, other = pcall(world.update, world, -1)
    assert.truthy(other:find("check_spec.lua:" .. line .. ": physics: world:update", 1, true))
    local resume = coroutine.wrap(function()
      return pcall(coroutine.wrap(world.update), world, -1)
    end)
    assert.matches("^physics: world:update", select(2, resume()))
  end)

  -- where check.lua is, which file of the library is called, which file of the game calls
  for _, row in ipairs({
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
  }) do
    it("is the game's in " .. row[1] .. " #files", function()
      local call = libraryFunction(loadCheck("@" .. row[2]), "@" .. row[3])
      assert.equal(row[4] .. ":2: physics: oops", messageOf(gameFunction("@" .. row[4], call)))
    end)
  end

  it("is that of a callback which misuses the library, also behind a tail call #files", function()
    local update = libraryFunction(loadCheck("@" .. CHECK), "@physics/world/world.lua")
    local callback = gameFunction("@callback.lua", update)
    local step = gameFunction("@physics/contacts/events.lua", callback)
    assert.equal("callback.lua:2: physics: oops", messageOf(gameFunction("@main.lua", step)))
    local text = "local call = ... return function() return call() end"
    local door = compile(text, "@physics.lua", {})(update)
    assert.equal("main.lua:2: physics: oops", messageOf(gameFunction("@main.lua", door)))
  end)

  it("is the third level's where there is no debug library #files", function()
    local environment = setmetatable({ debug = false }, { __index = _G })
    local call = libraryFunction(loadCheck("@" .. CHECK, environment), "@physics.lua")
    assert.equal("main.lua:2: physics: oops", messageOf(gameFunction("@main.lua", call)))
  end)
end)

-- The words ---------------------------------------------------------------------------------------

describe("an error", function()
  local forty = ("0123456789"):rep(4)
  local tagged = setmetatable({}, {
    __tostring = function()
      return "me"
    end,
  })
  for _, row in ipairs({
    { 3.0, "3" },
    { -0.5, "-0.5" },
    { 0.1, "0.1" },
    { 1e300, "1e+300" },
    { -NAN, "nan" },
    { -INF, "-inf" },
    { "my group", '"my group"' },
    { 'a "b"\\\n\t\r\1', [["a \"b\"\\\n\t\r\001"]] },
    { forty, '"' .. forty .. '"' },
    { forty .. "x", '"' .. forty .. '..."' },
    { ("a"):rep(39) .. "éé", '"' .. ("a"):rep(39) .. '..."' },
    { ("\128"):rep(50), '"' .. ("\128"):rep(37) .. '..."' },
    { tagged, "table" },
    { print, "function" },
    { io.stdout, "userdata" },
    { coroutine.create(function() end), "thread" },
  }) do
    it("shows a value as " .. row[2], function()
      refuses("newWorld(settings): rest must be true or false, got " .. row[2], function()
        physics.newWorld({ rest = row[1] })
      end)
    end)
  end

  for _, row in ipairs({
    { "boxes", 3.0, "objects.boxes[3]" },
    { "boxes", 1.5, "objects.boxes[1.5]" },
    { "enemies", "spike", "objects.enemies.spike" },
    { "player", nil, "objects.player" },
    { "my group", 1, 'objects["my group"][1]' },
    { "boxes", "the big one", 'objects.boxes["the big one"]' },
    { "end", "2nd", 'objects["end"]["2nd"]' },
    { 1, 2, "objects[1][2]" },
    { -1, "a", "objects[-1].a" },
  }) do
    it("names the place " .. row[3], function()
      local world, bad = physics.newWorld(), object({ mass = 0 })
      world.objects[row[1]] = row[2] == nil and bad or { [row[2]] = bad }
      refuses(row[3] .. ".mass must be a number > 0, got 0", function()
        world:update(0)
      end)
    end)
  end

  -- what is wrong, and what the message says behind the place
  for _, row in ipairs({
    { { x = 1e101 }, ".x must be a number in -1e+100..1e+100, got 1e+101" },
    { { drag = 1e101 }, ".drag must be a number in 0..1e+100, got 1e+101" },
    { { width = 1e101 }, ".width must be a number > 0 and <= 1e+100, got 1e+101" },
    { { mass = 1e-101 }, ".mass must be a number >= 1e-100, got 1e-101" },
    { { mask = { "enemies" } }, '.mask[1] must be true or false, got "enemies"' },
    { { mask = { b = 2, a = 1, c = 3 } }, ".mask.a must be true or false, got 1" },
    { { mask = { [true] = false } }, ".mask must have group names as keys, got true" },
    { { y = NAN, width = -1, friction = "x" }, ".y must be a number, got nan" }, -- the first one
  }) do
    it("of an object says: " .. row[2], function()
      refuses("objects.boxes[1]" .. row[2], function()
        physics.newWorld():add("boxes", object(row[1]))
      end)
    end)
  end

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
  for _, row in ipairs({
    {
      { order = { "boxes", "lifts", "boxes" } },
      'order must name each group once, got "boxes" at [1] and [3]',
    },
    { 800, "settings must be a table, got 800" },
    { { soft = { a = { b = -1 } } }, "soft.a.b must be a number in 0..1000000, got -1" },
    { { order = { 1, NAN } }, "order[2] must be a group name, got nan" },
    { { masks = { a = { b = "no" } } }, 'masks.a.b must be true or false, got "no"' },
    { { masks = { [1] = { ["my b"] = 0 } } }, 'masks[1]["my b"] must be true or false, got 0' },
    { { masks = { [print] = {} } }, "masks must have group names as keys, got function" },
  }) do
    it("refuses: " .. row[2], function()
      refuses("newWorld(settings): " .. row[2], function()
        physics.newWorld(row[1])
      end)
    end)
  end

  local ALL = "; the settings are gravity, gravityX, push, masks, soft, sideBySide, broadphase,"
    .. " cellSize, timestep, maxStep, order, ownFields, rest, checked, profile, onStep, onBegin,"
    .. " onStay, onEnd, onCrush, canCollide"

  for _, row in ipairs({
    { "wind", '"wind"' },
    { "gravty", '"gravty" (did you mean "gravity"?)' },
    { "gravtiy", '"gravtiy" (did you mean "gravity"?)' },
    { "gravityx", '"gravityx" (did you mean "gravityX"?)' },
    { "cellsize", '"cellsize" (did you mean "cellSize"?)' },
    { 1, "1" },
    { true, "true" },
  }) do
    it("refuses the unknown setting " .. row[2], function()
      refuses("load(settings): unknown setting " .. row[2] .. ALL, function()
        physics.load({ [row[1]] = 1, gravity = 0 })
      end)
    end)
  end

  it("names the first unknown setting in order, whatever the order of the table", function()
    local settings = { zebra = 1, apple = 2, [2] = 3, [1] = 4, [true] = 5 }
    for _, key in ipairs({ true, 1, 2, "apple", "zebra" }) do
      local shown = type(key) == "string" and '"' .. key .. '"' or tostring(key)
      refuses("load(settings): unknown setting " .. shown .. ALL, function()
        physics.load(settings)
      end)
      settings[key] = nil
    end
  end)
end)

-- Groups and filters ------------------------------------------------------------------------------

describe("a group", function()
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

  for _, row in ipairs({
    { true, " must be a group name, a list of them or a function, got true" },
    { NAN, " must be a group name, a list of them or a function, got nan" },
    {
      { "boxes", {} },
      "[2] must be a group name, got table (the name of a group, not its table)",
    },
  }) do
    it("filter refuses: " .. row[2], function()
      local world = physics.newWorld()
      refuses("world:queryPoint(x, y): filter" .. row[2], function()
        world:queryPoint(0, 0, row[1])
      end)
    end)
  end
end)
