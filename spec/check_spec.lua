--- Errors: their text, and the line they name. What loads physics/fields/check.lua itself is tagged
--- #files: there is no such file when the library is one (scripts/single.sh).

local check = require("physics.fields.check")
local fields = require("physics.fields.fields")

local NAN, INF = 0 / 0, 1 / 0

--- Runs a call that must be refused. It must blame this file, and say exactly this.
local function refuses(expected, call)
  local ok, message = pcall(call)
  assert.is_false(ok)
  assert.equal(expected, (message:gsub("^.-check_spec%.lua:%d+: ", "")))
  assert.truthy(message:find("check_spec.lua:", 1, true))
end

--- A complete object with some fields changed.
local function object(changes)
  local result = { x = 1, y = 2, width = 3, height = 4 }
  for name, value in pairs(changes) do
    result[name] = value
  end
  return result
end

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

--- A function of a game in a chunk of this name, which calls a function on its second line.
local function gameFunction(chunkName, call)
  return compile("local call = ...\nreturn function() call()\n end", chunkName, {})(call)
end

local function messageOf(call)
  return select(2, pcall(call))
end

describe("check", function()
  describe(".fail", function()
    it("names the line that called into the library", function()
      local line
      local message = messageOf(function()
        line = debug.getinfo(1, "l").currentline + 1
        check.number(-1, "dt", "update(dt)", 0)
      end)
      assert.truthy(message:find("check_spec.lua:" .. line .. ": physics: update(dt)", 1, true))
    end)

    it("goes past pcall to the line that calls it", function()
      local line = debug.getinfo(1, "l").currentline + 1
      local _, message = pcall(check.fail, "oops")
      assert.truthy(message:find("check_spec.lua:" .. line .. ": physics: oops", 1, true))
    end)

    it("names no line where there is no caller outside the library", function()
      local resume = coroutine.wrap(function()
        return pcall(coroutine.wrap(check.fail), "oops")
      end)
      assert.same({ false, "physics: oops" }, { resume() })
    end)

    -- where check.lua is, which file of the library is called, which file of the game calls
    for _, row in ipairs({
      { "the folder of the game", "@physics/fields/check.lua", "@physics.lua", "main.lua" },
      { "a folder for libraries", "@lib/physics/fields/check.lua", "@lib/physics.lua", "main.lua" },
      {
        "a subfolder",
        "@lib/physics/fields/check.lua",
        "@lib/physics/broadphase/grid.lua",
        "main.lua",
      },
      {
        "a folder with init.lua",
        "@lib/physics/fields/check.lua",
        "@lib/physics/init.lua",
        "main.lua",
      },
      {
        "a search path with a dot",
        "@./physics/fields/check.lua",
        "@./physics.lua",
        "./spec/a_spec.lua",
      },
      {
        "an installed rock",
        "@/usr/share/lua/5.1/physics/fields/check.lua",
        "@/usr/share/lua/5.1/physics.lua",
        "main.lua",
      },
      { "Windows", "@.\\lib\\physics\\fields\\check.lua", "@.\\lib\\physics.lua", ".\\main.lua" },
      { "one joined file", "@lib/physics.lua", "@lib/physics.lua", "lib/main.lua" },
      { "one joined file beside the game", "@physics.lua", "@physics.lua", "main.lua" },
      {
        "a folder beside other files",
        "@lib/physics/fields/check.lua",
        "@lib/physics.lua",
        "lib/game.lua",
      },
      {
        "a folder like another",
        "@physics/fields/check.lua",
        "@physics.lua",
        "physics-game/a.lua",
      },
      { "a folder like a file", "@physics/fields/check.lua", "@physics.lua", "physics2.lua" },
    }) do
      local name, checkChunk, libraryChunk, gameFile = row[1], row[2], row[3], row[4]
      it("blames the game in " .. name .. " #files", function()
        local call = libraryFunction(loadCheck(checkChunk), libraryChunk)
        assert.equal(
          gameFile .. ":2: physics: oops",
          messageOf(gameFunction("@" .. gameFile, call))
        )
      end)
    end

    it("blames a callback of the game that misuses the library #files", function()
      local loaded = loadCheck("@physics/fields/check.lua")
      local update = libraryFunction(loaded, "@physics/world/world.lua")
      local callback = gameFunction("@callback.lua", update)
      local step = gameFunction("@physics/contacts/events.lua", callback)
      assert.equal("callback.lua:2: physics: oops", messageOf(gameFunction("@main.lua", step)))
    end)

    it("finds the game behind a tail call in the library #files", function()
      local loaded = loadCheck("@physics/fields/check.lua")
      local inner = libraryFunction(loaded, "@physics/world/world.lua")
      local text = "local call = ... return function() return call() end"
      local door = compile(text, "@physics.lua", {})(inner)
      assert.equal("main.lua:2: physics: oops", messageOf(gameFunction("@main.lua", door)))
    end)

    it("blames the third level where there is no debug library #files", function()
      local environment = setmetatable({ debug = false }, { __index = _G })
      local loaded = loadCheck("@physics/fields/check.lua", environment)
      local call = libraryFunction(loaded, "@physics.lua")
      assert.equal("main.lua:2: physics: oops", messageOf(gameFunction("@main.lua", call)))
    end)
  end)

  describe(".show", function()
    local forty = ("0123456789"):rep(4)
    for _, row in ipairs({
      { nil, "nil" },
      { true, "true" },
      { false, "false" },
      { 3, "3" },
      { 3.0, "3" },
      { -0.5, "-0.5" },
      { 0.1, "0.1" },
      { 1e300, "1e+300" },
      { 627.84, "627.84" },
      { NAN, "nan" },
      { -NAN, "nan" },
      { INF, "inf" },
      { -INF, "-inf" },
      { "", '""' },
      { "boxes", '"boxes"' },
      { "my group", '"my group"' },
      { 'a "b"\\\n\t\r\1', [["a \"b\"\\\n\t\r\001"]] },
      { forty, '"' .. forty .. '"' },
      { forty .. "x", '"' .. forty .. '..."' },
      { ("a"):rep(39) .. "éé", '"' .. ("a"):rep(39) .. '..."' },
      { ("\128"):rep(50), '"' .. ("\128"):rep(37) .. '..."' },
      { {}, "table" },
      {
        setmetatable({}, {
          __tostring = function()
            return "me"
          end,
        }),
        "table",
      },
      { print, "function" },
      { io.stdout, "userdata" },
      { coroutine.create(function() end), "thread" },
    }) do
      local value, expected = row[1], row[2]
      it("gives " .. expected, function()
        assert.equal(expected, check.show(value))
      end)
    end
  end)

  describe(".place", function()
    for _, row in ipairs({
      { "boxes", 3, "objects.boxes[3]" },
      { "boxes", 3.0, "objects.boxes[3]" },
      { "boxes", 1.5, "objects.boxes[1.5]" },
      { "enemies", "spike", "objects.enemies.spike" },
      { "player", nil, "objects.player" },
      { "my group", 1, 'objects["my group"][1]' },
      { "boxes", "the big one", 'objects.boxes["the big one"]' },
      { "end", "2nd", 'objects["end"]["2nd"]' },
      { "", nil, 'objects[""]' },
      { 1, nil, "objects[1]" },
      { 1, 2, "objects[1][2]" },
      { -1, "a", "objects[-1].a" },
    }) do
      local group, key, expected = row[1], row[2], row[3]
      it("gives " .. expected, function()
        assert.equal(expected, check.place(group, key))
      end)
    end
  end)

  describe(".object", function()
    it("accepts x, y, width and height alone", function()
      check.object(object({}), "objects.boxes[1]")
    end)

    it("accepts fields of the game, whatever is in them", function()
      check.object(object({ image = "box.png", health = NAN, touching = 5 }), "objects.boxes[1]")
    end)

    it("reads what an instance inherits from its class", function()
      local Box = { width = 10, height = 10, friction = 0.5 }
      Box.__index = Box
      check.object(setmetatable({ x = 0, y = 0 }, Box), "objects.boxes[1]")
      Box.friction = "rough"
      refuses('physics: objects.boxes[1].friction must be a number >= 0, got "rough"', function()
        check.object(setmetatable({ x = 0, y = 0 }, Box), "objects.boxes[1]")
      end)
    end)

    -- what is wrong, and what the message says behind "physics: objects.boxes[3]"
    for _, row in ipairs({
      { { x = 1e101 }, ".x must be a number in -1e+100..1e+100, got 1e+101" },
      { { x = -1e101 }, ".x must be a number in -1e+100..1e+100, got -1e+101" },
      { { drag = 1e101 }, ".drag must be a number in 0..1e+100, got 1e+101" },
      { { width = 1e101 }, ".width must be a number > 0 and <= 1e+100, got 1e+101" },
      { { mass = 1e-101 }, ".mass must be a number >= 1e-100, got 1e-101" },
      { { restitution = INF }, ".restitution must be a finite number in 0..1, got inf" },
      { { mask = { "enemies" } }, '.mask[1] must be true or false, got "enemies"' },
      { { mask = { enemies = 0 } }, ".mask.enemies must be true or false, got 0" },
      { { mask = { b = 2, a = 1, c = 3 } }, ".mask.a must be true or false, got 1" },
      { { mask = { [true] = false } }, ".mask must have group names as keys, got true" },
    }) do
      local changes, expected = row[1], row[2]
      it("refuses: " .. expected, function()
        refuses("physics: objects.boxes[3]" .. expected, function()
          check.object(object(changes), "objects.boxes[3]")
        end)
      end)
    end

    it("names the first wrong field in the listed order", function()
      refuses("physics: objects.player.y must be a number, got nan", function()
        check.object(object({ y = NAN, width = -1, friction = "x" }), "objects.player")
      end)
    end)

    it("refuses what is no table", function()
      refuses("physics: world:add(group, object): object must be a table, got nil", function()
        check.object(nil, "world:add(group, object): object")
      end)
    end)
  end)

  describe(".badField", function()
    it("gives nil for a good object and the field of a bad one", function()
      assert.is_nil(check.badField(object({})))
      assert.equal(fields.objectByName.drag, check.badField(object({ drag = -1, nudge = -1 })))
    end)
  end)

  describe(".fields", function()
    it("checks the named fields only", function()
      check.fields({ mass = 2, x = "not asked" }, "a", { "mass", "static" })
      refuses("physics: bump(a, b): a.mass must be a number > 0, got 0", function()
        check.fields({ mass = 0 }, "bump(a, b): a", { "static", "mass" })
      end)
      refuses("physics: side(a, b): a must be a table, got 5", function()
        check.fields(5, "side(a, b): a", { "x" })
      end)
    end)
  end)

  describe(".settings", function()
    it("accepts nothing, no settings, and good ones", function()
      check.settings(nil, "newWorld(settings)")
      check.settings({}, "newWorld(settings)")
      local masks = { bullets = { players = false, [2] = true }, [1] = {} }
      check.settings({ masks = masks, order = { "tiles", 2, "2" } }, "newWorld(settings)")
    end)

    -- what is wrong, and what the message says behind "physics: newWorld(settings): "
    for _, row in ipairs({
      { 800, "settings must be a table, got 800" },
      { { order = "tiles" }, 'order must be a list of group names, got "tiles"' },
      { { order = { tiles = 1 } }, "order must be a list of group names, got table" },
      { { order = { "tiles", true } }, "order[2] must be a group name, got true" },
      { { order = { 1, NAN } }, "order[2] must be a group name, got nan" },
      { { order = { "a", "b", "a" } }, 'order must name each group once, got "a" at [1] and [3]' },
      { { masks = { a = "b" } }, 'masks.a must be a table { [group] = false }, got "b"' },
      { { masks = { a = { b = "no" } } }, 'masks.a.b must be true or false, got "no"' },
      { { masks = { [1] = { ["my b"] = 0 } } }, 'masks[1]["my b"] must be true or false, got 0' },
      {
        { masks = { a = { [print] = true } } },
        "masks.a must have group names as keys, got function",
      },
      { { masks = { [print] = {} } }, "masks must have group names as keys, got function" },
    }) do
      local settings, expected = row[1], row[2]
      it("refuses: " .. expected, function()
        refuses("physics: newWorld(settings): " .. expected, function()
          check.settings(settings, "newWorld(settings)")
        end)
      end)
    end

    local ALL = "the settings are gravity, gravityX, push, masks, soft, sideBySide, broadphase,"
      .. " cellSize, timestep, maxStep, order, ownFields, rest, checked, profile, onStep, onBegin,"
      .. " onStay, onEnd, onCrush, canCollide"

    for _, row in ipairs({
      { "wind", '"wind"' },
      { "gravty", '"gravty" (did you mean "gravity"?)' },
      { "gravityy", '"gravityy" (did you mean "gravity"?)' },
      { "gravitx", '"gravitx" (did you mean "gravity"?)' },
      { "gravtiy", '"gravtiy" (did you mean "gravity"?)' },
      { "gravityx", '"gravityx" (did you mean "gravityX"?)' },
      { "cellsize", '"cellsize" (did you mean "cellSize"?)' },
      { "mask", '"mask" (did you mean "masks"?)' },
      { "", '""' },
      { 1, "1" },
      { true, "true" },
    }) do
      local name, expected = row[1], row[2]
      it("refuses the unknown setting " .. expected, function()
        refuses("physics: load(settings): unknown setting " .. expected .. "; " .. ALL, function()
          check.settings({ [name] = 1, gravity = 0 }, "load(settings)")
        end)
      end)
    end

    it("names the first unknown setting in order, whatever the order of the table", function()
      local settings = { zebra = 1, apple = 2, [2] = 3, [1] = 4, [true] = 5 }
      for _, name in ipairs({ "true", "1", "2", '"apple"', '"zebra"' }) do
        refuses("physics: load(settings): unknown setting " .. name .. "; " .. ALL, function()
          check.settings(settings, "load(settings)")
        end)
        for key in pairs(settings) do
          if check.show(key) == name then
            settings[key] = nil
            break
          end
        end
      end
    end)
  end)

  describe(".setting", function()
    it("accepts a good value, and nil where there is no default", function()
      check.setting("gravity", 0)
      check.setting("onBegin", nil)
      check.setting("timestep", nil)
    end)

    it("names the field of the world, or the call", function()
      refuses('physics: world.gravity must be a number, got "low"', function()
        check.setting("gravity", "low")
      end)
      refuses('physics: load(settings): gravity must be a number, got "low"', function()
        check.setting("gravity", "low", "load(settings)")
      end)
    end)

    it("refuses nil where there is a default", function()
      refuses("physics: world.maxStep must be a number in 1e-05..0.25, got nil", function()
        check.setting("maxStep", nil)
      end)
    end)

    it("refuses an unknown name", function()
      assert.has_error(function()
        check.setting("wind", 1)
      end)
    end)
  end)

  describe("of an argument", function()
    local WHERE = "world:update(dt)"

    -- function, good values
    for _, row in ipairs({
      { "number", { 0, -5, 1.5 } },
      { "positive", { 1e-9, 5 } },
      { "boolean", { true, false } },
      { "table", { {} } },
    }) do
      local name, values = row[1], row[2]
      it("." .. name .. " accepts what fits", function()
        for _, value in ipairs(values) do
          check[name](value, "dt", WHERE)
        end
      end)
    end

    it("accepts the ends of a range", function()
      check.number(0, "dt", WHERE, 0, 1)
      check.number(1, "dt", WHERE, 0, 1)
      check.integer(1, "count", WHERE, 1, 3)
      check.integer(3.0, "count", WHERE, 1, 3)
      check.choice("slide", "response", WHERE, { "slide", "touch" })
    end)

    -- function, value, further arguments, and what the message says behind the call
    for _, row in ipairs({
      { "number", -1, { 0 }, "dt must be a number >= 0, got -1" },
      { "number", nil, { 0 }, "dt must be a number >= 0, got nil" },
      { "number", NAN, {}, "dt must be a number, got nan" },
      { "number", INF, {}, "dt must be a finite number, got inf" },
      { "number", -INF, { 0 }, "dt must be a finite number >= 0, got -inf" },
      { "number", "1", {}, 'dt must be a number, got "1"' },
      { "number", 2, { 0, 1 }, "dt must be a number in 0..1, got 2" },
      { "number", 2, { nil, 1 }, "dt must be a number <= 1, got 2" },
      { "positive", 0, {}, "dt must be a number > 0, got 0" },
      { "positive", NAN, {}, "dt must be a number > 0, got nan" },
      { "integer", 1.5, { 1, 3 }, "dt must be an integer in 1..3, got 1.5" },
      { "integer", 4, { 1, 3 }, "dt must be an integer in 1..3, got 4" },
      { "integer", INF, { 1, 3 }, "dt must be an integer in 1..3, got inf" },
      { "boolean", 1, {}, "dt must be true or false, got 1" },
      { "table", 1, {}, "dt must be a table, got 1" },
      { "choice", "jump", { { "slide", "touch" } }, 'dt must be "slide" or "touch", got "jump"' },
      { "choice", nil, { { "slide" } }, 'dt must be "slide", got nil' },
    }) do
      local name, value, rest, expected = row[1], row[2], row[3], row[4]
      it("." .. name .. " refuses: " .. expected, function()
        refuses("physics: world:update(dt): " .. expected, function()
          check[name](value, "dt", WHERE, rest[1], rest[2])
        end)
      end)
    end
  end)

  describe(".group", function()
    it("accepts strings and numbers", function()
      for _, name in ipairs({ "boxes", "", 1, -1.5 }) do
        check.group(name, "world:add(group, object)")
      end
    end)

    for _, row in ipairs({
      { nil, "nil" },
      { true, "true" },
      { {}, "table (the group comes first, then the object)" },
      { NAN, "nan" },
      { INF, "inf" },
    }) do
      local name, shown = row[1], row[2]
      it("refuses " .. shown, function()
        local call = "physics: world:add(group, object): "
        refuses(call .. "group must be a string or a number, got " .. shown, function()
          check.group(name, "world:add(group, object)")
        end)
      end)
    end
  end)

  describe(".filter", function()
    it("accepts nothing, a name, a list of names and a function", function()
      for _, filter in ipairs({ "boxes", 1, { "boxes", 1 }, {}, print }) do
        check.filter(filter, "world:queryPoint(x, y, filter)")
      end
      check.filter(nil, "world:queryPoint(x, y, filter)")
    end)

    for _, row in ipairs({
      { true, "filter must be a group name, a list of them or a function, got true" },
      { NAN, "filter must be a group name, a list of them or a function, got nan" },
      {
        { "boxes", {} },
        "filter[2] must be a group name, got table (the name of a group, not its table)",
      },
    }) do
      local filter, expected = row[1], row[2]
      it("refuses: " .. expected, function()
        refuses("physics: world:queryPoint(x, y, filter): " .. expected, function()
          check.filter(filter, "world:queryPoint(x, y, filter)")
        end)
      end)
    end
  end)
end)
