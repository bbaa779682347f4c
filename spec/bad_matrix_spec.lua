--- Bad input, all of it: every method, every argument, every kind of wrong value. Whatever is
--- given, the answer has no number that is none, or is an error that names the call and blames this
--- file; and a refused call has changed nothing. In which words, stands in bad_input_spec.lua.

local effort = require("spec.support.effort")
local physics = require("physics")
local fields = require("physics.fields.fields")

local NAN, INF = 0 / 0, math.huge
local DT = 1 / 60
local unpackList = rawget(_G, "unpack") or rawget(table, "unpack")

effort.interpret(setup, teardown)

-- Bad values --------------------------------------------------------------------------------------

local THROWN = "thrown by a metamethod"

local function throw()
  error(THROWN, 0)
end

local METAMETHODS =
  { "__index", "__newindex", "__len", "__eq", "__lt", "__le", "__call", "__pairs" }

-- A table that fails whenever it is looked at, however that is done.
local function newThrower(value)
  local meta = {}
  for _, name in ipairs(METAMETHODS) do
    meta[name] = throw
  end
  return setmetatable(value or {}, meta)
end

local function newCycle()
  local cycle = { x = 1, y = 2 }
  cycle.self, cycle[1], cycle.width = cycle, cycle, cycle
  return cycle
end

-- An object that is fine, but in no world.
local function newStranger()
  return { x = 500, y = 500, width = 5, height = 5 }
end

local function longList()
  local list = {}
  for n = 1, 2000 do
    list[n] = n % 3 == 0 and "boxes" or n
  end
  return list
end

-- The values, each made anew for a scene: name, value.
local function newValues(scene)
  return {
    { "nil", nil },
    { "true", true },
    { "false", false },
    { "a text", "text" },
    { "a number as text", "12" },
    { "no text", "" },
    { "a long text", ("\0\255long"):rep(10000) },
    { "nan", NAN },
    { "inf", INF },
    { "-inf", -INF },
    { "-0", -0.0 },
    { "-1", -1 },
    { "0.5", 0.5 },
    { "1e308", 1e308 },
    { "-1e308", -1e308 },
    { "5e-324", 2 ^ -1074 },
    { "an empty table", {} },
    { "a list with a hole", { "boxes", nil, "lifts" } },
    { "a long list", longList() },
    { "a cycle", newCycle() },
    { "a table that throws", newThrower() },
    { "an object that throws", newThrower(newStranger()) },
    { "a stranger", newStranger() },
    { "an object of the world", scene.box },
    { "a static object of the world", scene.floor },
    { "a removed object", scene.removed },
    { "the world", scene.world },
    { "its groups", scene.world.objects },
    { "a function", function() end },
    { "a function that throws", throw },
    { "a coroutine", coroutine.create(throw) },
    { "a file", io.stdout },
  }
end
local COUNT = 32

-- The numbers of all values where there is a trace compiler; others take each fourth in turn.
local turn = 0

local function someValues()
  turn = turn + 1
  local some, first, step = {}, 1 + turn % 4, 4
  if effort.isWhole then
    first, step = 1, 1
  end
  for n = first, COUNT, step do
    some[#some + 1] = n
  end
  return some
end

-- Scenes ------------------------------------------------------------------------------------------

local function newScene()
  local world = physics.newWorld({ gravity = 800 })
  local scene = { world = world }
  scene.floor = world:add("floors", { x = 0, y = 100, width = 300, height = 16, static = true })
  scene.shelf =
    world:add("shelves", { x = 100, y = 60, width = 50, height = 6, static = true, oneWay = "top" })
  scene.box = world:add("boxes", { x = 20, y = 84, width = 16, height = 16, vx = 20 })
  scene.other = world:add("boxes", { x = 110, y = 44, width = 16, height = 16, mass = 2 })
  scene.lift = world:add("lifts", { x = 200, y = 60, width = 40, height = 8, kinematic = true })
  scene.lift.vy = -10
  scene.gate = world:add("gates", { x = 60, y = 50, width = 8, height = 50, sensor = true })
  scene.gate.static = true
  scene.removed = world:add("boxes", newStranger())
  for _ = 1, 3 do
    world:update(DT)
  end
  world:remove(scene.removed)
  world:update(DT)
  return scene
end

-- What the game sees of a scene, by raw access.
local function snapshot(scene)
  local lines = {}
  for _, which in ipairs({ "floor", "shelf", "box", "other", "lift", "gate", "removed" }) do
    for key, value in next, scene[which] do
      if type(value) ~= "table" then
        lines[#lines + 1] = which .. "." .. tostring(key) .. "=" .. tostring(value)
      end
    end
  end
  table.sort(lines)
  return table.concat(lines, "\n")
end

-- Calls -------------------------------------------------------------------------------------------

-- The methods: name, arguments that are fine.
local function newMethods(scene)
  local box, floor, all = scene.box, scene.floor, { "boxes", "floors" }
  return {
    { "update", { DT } },
    { "add", { "boxes", newStranger() } },
    { "remove", { box } },
    { "refresh", { box } },
    { "ground", { box } },
    { "groupOf", { box } },
    { "dropThrough", { scene.other } },
    { "save", { {} } },
    { "restore", { scene.world:save() } },
    { "hash", {} },
    { "interpolate", { box } },
    { "queryPoint", { 25, 90, "boxes", {} } },
    { "queryRect", { 10, 80, 50, 50, all, {} } },
    { "queryCircle", { 25, 90, 40, all, {} } },
    { "querySegment", { 0, 90, 400, 95, "boxes", {} } },
    { "raycast", { 0, 90, 400, 95, "boxes" } },
    { "sweep", { box, 100, 50, "floors" } },
    { "fits", { 20, 90, 40, 30, "boxes" } },
    { "velocity", { box } },
    { "shift", { 10, 20 } },
    { "nearest", { 10, 10, 300, "boxes" } },
    { "overlapping", { scene.gate, "boxes", {} } },
    { "touching", { box, floor } },
    { "explain", { box, floor } },
    { "move", { box, 60, 50, "slide", {} } },
    { "impulse", { box, 10, 10 } },
    { "explode", { 20, 90, 200, 300, "boxes", { "floors" } } },
    { "setBounds", { 0, 0, 300, 200 } },
  }
end

-- The functions that are no methods.
local function newFunctions()
  local lines = { 1, 1, 2, 2, 0, 0, 9, 9 }
  local near = { x = 503, y = 501, width = 5, height = 5 }
  return {
    { "inside", lines },
    { "side", { newStranger(), newStranger() } },
    { "checkCollision", { newStranger(), newStranger(), true } },
    { "checkCollision", { 1, 1, 2, 2, 0, 0, 9, 9, true } },
    { "bump", { newStranger(), near, "first" } },
    { "newWorld", { { gravity = 5 } } },
    { "load", { { gravity = 5 } } },
  }
end

-- Not tried here: `draw` needs LÖVE (draw_spec.lua), `globals` takes nothing, and maps have specs
-- of their own.
local ELSEWHERE =
  { draw = true, globals = true, loadTiled = true, loadLDtk = true, addTiles = true }

-- Trying ------------------------------------------------------------------------------------------

local function isFinite(value)
  return value - value == 0
end

local counts = { accepted = 0, refused = 0 }

local function checkRefusal(message, what)
  local isBlamed = message == THROWN or message:find("bad_matrix_spec.lua:%d+: physics: ")
  assert(isBlamed, what .. ": " .. message)
end

-- Of a table that is in no world `interpolate` returns x and y, whatever they are.
local function checkResults(what, ...)
  for n = 1, what:find("^interpolate") and 0 or select("#", ...) do
    local value = (select(n, ...))
    assert(type(value) ~= "number" or isFinite(value), what .. ": returned " .. tostring(value))
  end
end

-- Makes a call: its results are numbers and others that a game can use, or it is refused and has
-- changed nothing. Returns whether it was refused.
local function judge(scene, call, what)
  scene.hash, scene.seen = scene.hash or scene.world:hash(), scene.seen or snapshot(scene)
  local list = { pcall(call) }
  counts[list[1] and "accepted" or "refused"] = counts[list[1] and "accepted" or "refused"] + 1
  if list[1] then
    checkResults(what, unpackList(list, 2))
    return false
  end
  checkRefusal(tostring(list[2]), what)
  assert.equal(scene.seen, snapshot(scene), what)
  assert.equal(scene.hash, scene.world:hash(), what)
  return true
end

-- Whatever has happened, the world goes on.
local function checkGoesOn(scene, what)
  scene.hash, scene.seen = nil, nil
  for _ = 1, 2 do
    local ok, message = pcall(scene.world.update, scene.world, DT)
    assert(ok or message == THROWN, what .. ": the next update fails: " .. tostring(message))
  end
  for _, which in ipairs({ "floor", "box", "other", "lift" }) do
    local object = scene[which]
    assert(isFinite(object.x) and isFinite(object.y), what .. ": " .. which .. " is lost")
    assert(isFinite(object.vx or 0) and isFinite(object.vy or 0), what .. ": " .. which)
  end
end

-- Tries all values at all places of a function, which is row n of `newRows(scene)`. One scene is
-- good for many refused calls, since those change nothing.
local function tryAll(newRows, n, call)
  local scene = newScene()
  local row = newRows(scene)[n]
  local name, count = row[1], #row[2]
  for place = 1, count do
    for _, m in ipairs(someValues()) do
      local args, value = newRows(scene)[n][2], newValues(scene)[m]
      args[place] = value[2]
      local isRefused = judge(scene, function()
        return call(scene, name, unpackList(args, 1, count))
      end, ("%s, argument %d is %s"):format(name, place, value[1]))
      scene = isRefused and scene or newScene()
    end
    checkGoesOn(scene, name)
  end
end

local NAMES = newMethods(newScene())

describe("whatever it is given,", function()
  for n, row in ipairs(NAMES) do
    local name = row[1]
    it("world:" .. name .. " answers or refuses it", function()
      tryAll(newMethods, n, function(scene, _, ...)
        return scene.world[name](scene.world, ...)
      end)
    end)
  end

  for n, row in ipairs(newFunctions()) do
    it("physics." .. row[1] .. " answers or refuses it, row " .. n, function()
      tryAll(newFunctions, n, function(_, name, ...)
        return physics[name](...)
      end)
      physics.load()
    end)
  end
end)

-- Fields and settings -----------------------------------------------------------------------------

-- Puts all values into a field of a box, or into a setting; a refused one is repaired, and the
-- world goes on. A callback that fails is no bad input: its step is made (recovery_spec.lua).
local function tryField(field, part)
  local scene = newScene()
  for _, m in ipairs(someValues()) do
    local value = newValues(scene)[m]
    if field.type ~= "function" or value[1] ~= "a function that throws" then
      local what, owner = field.name .. " is " .. value[1], scene[part]
      local old = owner[field.name]
      owner[field.name] = value[2]
      local seen = snapshot(scene)
      local ok, message = pcall(scene.world.update, scene.world, DT)
      counts[ok and "accepted" or "refused"] = counts[ok and "accepted" or "refused"] + 1
      if ok then
        scene = newScene()
      else
        checkRefusal(message, what)
        assert.equal(seen, snapshot(scene), what)
        owner[field.name] = old
        checkGoesOn(scene, what)
      end
    end
  end
end

describe("whatever is in it,", function()
  for part, list in pairs({ box = fields.objects, world = fields.settings }) do
    for _, field in ipairs(list) do
      it(("the field %s of a %s is taken or refused"):format(field.name, part), function()
        tryField(field, part)
      end)
    end
  end
end)

describe("whatever it answers,", function()
  local function updated(scene)
    return scene.world:update(DT)
  end
  for name, call in pairs({
    ["a filter"] = function(scene, answer)
      return scene.world:queryRect(0, 0, 300, 300, answer)
    end,
    ["a response"] = function(scene, answer)
      return scene.world:move(scene.box, 200, 90, answer)
    end,
    canCollide = function(scene, answer)
      scene.world.canCollide = answer
      return updated(scene)
    end,
    onBegin = function(scene, answer)
      scene.world.onBegin, scene.box.vy = answer, -100
      return updated(scene)
    end,
  }) do
    it(name .. " is taken or refused", function()
      for _, m in ipairs(someValues()) do
        local scene = newScene()
        local value = newValues(scene)[m]
        local what = name .. " returns " .. value[1]
        local ok, message = pcall(call, scene, function()
          return value[2]
        end)
        assert(ok or message == THROWN or message:find("physics: "), what .. tostring(message))
        scene.world.canCollide = nil
        checkGoesOn(scene, what)
      end
    end)
  end
end)

describe("the matrix of bad input", function()
  it("has every public function in it, and thousands of calls", function()
    local tried = {}
    for _, list in ipairs({ NAMES, newFunctions() }) do
      for _, row in ipairs(list) do
        tried[row[1]] = true
      end
    end
    for name, value in pairs(physics) do
      if type(value) == "function" and not ELSEWHERE[name] then
        assert(tried[name], name .. " is not tried")
      end
    end
    if effort.isWhole then
      assert.is_true(counts.refused > 4500, "refused: " .. counts.refused)
      assert.is_true(counts.accepted > 500, "accepted: " .. counts.accepted)
    end
  end)
end)
