--- Bad input, all of it: every public function, every argument, every kind of wrong value. Whatever
--- is given, the answer is a documented result, or an error that names the call and blames this
--- file; and a refused call has changed nothing. What is refused in which words stands, by hand, in
--- bad_input_spec.lua.

local effort = require("spec.support.effort")
local physics = require("physics")
local fields = require("physics.fields.fields")

local NAN, INF = 0 / 0, math.huge
local DT = 1 / 60
local SIDES = { left = true, right = true, top = true, bottom = true }

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

local function fill(world)
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

local function newScene()
  return fill(physics.newWorld({ gravity = 800 }))
end

-- The same in the world that the functions of the module mean.
local function newDefaultScene()
  physics.load({ gravity = 800 })
  local world = {}
  setmetatable(world, {
    __index = function(_, name)
      local value = physics[name]
      if type(value) ~= "function" then
        return value
      end
      return function(_, ...)
        return value(...)
      end
    end,
  })
  return fill(world)
end

-- Functions ---------------------------------------------------------------------------------------

local function isFinite(value)
  return type(value) == "number" and value - value == 0
end

local function isObject(value)
  return type(value) == "table" and isFinite(value.x) and isFinite(value.width)
end

-- Checks of results: true if they are what the function is documented to return.

local function nothing(...)
  return select("#", ...) == 0
end

local function aBoolean(value)
  return type(value) == "boolean"
end

local function listAndCount(list, count)
  if type(list) ~= "table" or not isFinite(count) then
    return false
  end
  for n = 1, count do
    if not isObject(list[n]) then
      return false
    end
  end
  return true
end

local function aHit(other, x, y, nx, ny, fraction)
  if other == nil then
    return x == nil
  end
  return isObject(other)
    and isFinite(x)
    and isFinite(y)
    and math.abs(nx) + math.abs(ny) <= 1
    and fraction >= 0
    and fraction <= 1
end

local function aSide(side)
  return side == nil or SIDES[side] ~= nil
end

local function sideOrFalse(side)
  return side == false or SIDES[side] ~= nil
end

local function aTable(value)
  return type(value) == "table"
end

local function finites(...)
  for n = 1, select("#", ...) do
    if not isFinite((select(n, ...))) then
      return false
    end
  end
  return true
end

local function aJourney(x, y, hits, count)
  return isFinite(x) and isFinite(y) and type(hits) == "table" and isFinite(count)
end

local function withoutOther(isFree, other)
  return type(isFree) == "boolean" and isFree == (other == nil)
end

local function aGround(object, gradient)
  return (object == nil or isObject(object)) and isFinite(gradient)
end

local function aGroup(group)
  return group == nil or type(group) == "string"
end

local function nearestOne(object, distance)
  return object == nil and distance == nil or isObject(object) and distance >= 0
end

local function aState(state)
  return type(state) == "table" and isFinite(state.version)
end

local function aWorld(world)
  return type(world) == "table" and isFinite(world.gravity)
end

local function aSentence(sentence)
  return type(sentence) == "string" and sentence:sub(-1) == "."
end

-- Of a table that is in no world `interpolate` returns x and y, whatever they are.
local function two(...)
  return select("#", ...) == 2
end

-- The methods: name, arguments that are fine, what it returns.
local function newMethods(scene)
  local box, floor, all = scene.box, scene.floor, { "boxes", "floors" }
  return {
    { "update", { DT }, nothing },
    { "add", { "boxes", newStranger() }, isObject },
    { "remove", { box }, aBoolean },
    { "refresh", { box }, nothing },
    { "ground", { box }, aGround },
    { "groupOf", { box }, aGroup },
    { "dropThrough", { scene.other }, aBoolean },
    { "save", { {} }, aState },
    { "restore", { scene.world:save() }, nothing },
    { "hash", {}, finites },
    { "interpolate", { box }, two },
    { "queryPoint", { 25, 90, "boxes", {} }, listAndCount },
    { "queryRect", { 10, 80, 50, 50, all, {} }, listAndCount },
    { "queryCircle", { 25, 90, 40, all, {} }, listAndCount },
    { "querySegment", { 0, 90, 400, 95, "boxes", {} }, listAndCount },
    { "raycast", { 0, 90, 400, 95, "boxes" }, aHit },
    { "sweep", { box, 100, 50, "floors" }, aHit },
    { "fits", { 20, 90, 40, 30, "boxes" }, withoutOther },
    { "velocity", { box }, finites },
    { "shift", { 10, 20 }, nothing },
    { "nearest", { 10, 10, 300, "boxes" }, nearestOne },
    { "overlapping", { scene.gate, "boxes", {} }, listAndCount },
    { "touching", { box, floor }, aSide },
    { "explain", { box, floor }, aSentence },
    { "move", { box, 60, 50, "slide", {} }, aJourney },
    { "impulse", { box, 10, 10 }, nothing },
    { "explode", { 20, 90, 200, 300, "boxes", { "floors" } }, listAndCount },
    { "setBounds", { 0, 0, 300, 200 }, nothing },
  }
end

local function newFunctions()
  local lines = { 1, 1, 2, 2, 0, 0, 9, 9 }
  local near = { x = 503, y = 501, width = 5, height = 5 }
  return {
    { "inside", lines, aBoolean },
    { "side", { newStranger(), newStranger() }, aSide },
    { "checkCollision", { newStranger(), newStranger(), true }, sideOrFalse },
    { "checkCollision", { 1, 1, 2, 2, 0, 0, 9, 9, true }, sideOrFalse },
    { "bump", { newStranger(), near, "first" }, sideOrFalse },
    { "newWorld", { { gravity = 5 } }, aWorld },
    { "load", { { gravity = 5 } }, nothing },
  }
end

-- Not tried here: `draw` needs LÖVE (draw_spec.lua), `globals` takes nothing,
-- what reads maps has specs of its own.
local ELSEWHERE = { draw = true, globals = true }
for _, name in ipairs({ "loadTiled", "loadLDtk", "addTiles" }) do
  ELSEWHERE[name] = true
end

-- Trying ------------------------------------------------------------------------------------------

local unpackList = rawget(_G, "unpack") or rawget(table, "unpack")

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

local function show(list, count)
  local words = {}
  for n = 1, count do
    words[n] = tostring(list[n]):sub(1, 30)
  end
  return table.concat(words, ", ")
end

local function pack(...)
  return { ... }, select("#", ...)
end

-- Judges one call; `call` is a function that makes it.
local function judge(scene, call, isGood, what)
  scene.hash, scene.seen = scene.hash or scene.world:hash(), scene.seen or snapshot(scene)
  local results, count = pack(pcall(call))
  local ok, message = results[1], tostring(results[2])
  if ok then
    if not isGood(unpackList(results, 2, count)) then
      error(what .. ": returned " .. show(results, count), 0)
    end
    return "accepted"
  end
  local isBlamed = message:find("bad_matrix_spec.lua:%d+: physics: ")
  if not isBlamed and message ~= THROWN then
    error(what .. ": " .. message, 0)
  end
  assert.equal(scene.seen, snapshot(scene), what)
  assert.equal(scene.hash, scene.world:hash(), what)
  return "refused"
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

local counts = { accepted = 0, refused = 0 }

-- Tries all values at all places of a function, which is row n of `newRows(scene)`. `call(scene,
-- name, args, count)` makes the call. One scene is good for many refused calls, since those change
-- nothing.
local function tryAll(newRows, n, makeScene, call)
  local scene = makeScene()
  local row = newRows(scene)[n]
  local name, count = row[1], #row[2]
  for place = 1, count do
    for _, m in ipairs(someValues()) do
      local args, value = newRows(scene)[n][2], newValues(scene)[m]
      args[place] = value[2]
      local what = ("%s, argument %d is %s"):format(name, place, value[1])
      local answer = judge(scene, function()
        return call(scene, name, args, count)
      end, row[3], what)
      counts[answer] = counts[answer] + 1
      if answer == "accepted" then
        scene = makeScene()
      end
    end
    checkGoesOn(scene, name)
  end
end

local NAMES = newMethods(newScene())

describe("whatever it is given,", function()
  for n, row in ipairs(NAMES) do
    local name = row[1]

    it("world:" .. name .. " answers as documented or refuses it", function()
      tryAll(newMethods, n, newScene, function(scene, _, args, count)
        return scene.world[name](scene.world, unpackList(args, 1, count))
      end)
    end)

    it("physics." .. name .. " answers as documented or refuses it", function()
      tryAll(newMethods, n, newDefaultScene, function(_, _, args, count)
        return physics[name](unpackList(args, 1, count))
      end)
      physics.load()
    end)

    it("world:" .. name .. " refuses to be called on anything else", function()
      local scene = newScene()
      for _, m in ipairs(someValues()) do
        local value = newValues(scene)[m]
        if not rawequal(value[2], scene.world) then
          local args = newMethods(scene)[n][2]
          local answer = judge(scene, function()
            return scene.world[name](value[2], unpackList(args, 1, #args))
          end, nothing, name .. " on " .. value[1])
          assert.equal("refused", answer)
          counts.refused = counts.refused + 1
        end
      end
    end)
  end

  for n, row in ipairs(newFunctions()) do
    it("physics." .. row[1] .. " answers as documented or refuses it", function()
      tryAll(newFunctions, n, newScene, function(_, name, args, count)
        return physics[name](unpackList(args, 1, count))
      end)
      physics.load()
    end)
  end
end)

-- Fields ------------------------------------------------------------------------------------------

-- How a value gets into a field: what is called, and whether a refusal must leave the hash alone
-- (a field that the game has already written is in it).
local WAYS = {
  {
    "of a new object",
    function(scene, name, value)
      local object = newStranger()
      object[name] = value
      return function()
        scene.world:add("boxes", object)
      end
    end,
  },
  {
    "of an object put in by hand",
    function(scene, name, value)
      local object = newStranger()
      object[name] = value
      scene.world.objects.crates = { object }
      return function()
        scene.world:update(DT)
      end, function()
        scene.world.objects.crates = nil
      end
    end,
  },
  {
    "of a box",
    function(scene, name, value)
      local old = scene.box[name]
      scene.box[name] = value
      return function()
        scene.world:update(DT)
      end, function()
        scene.box[name] = old
      end
    end,
  },
  {
    "of a wall, refreshed",
    function(scene, name, value)
      local old = scene.floor[name]
      scene.floor[name] = value
      return function()
        scene.world:refresh(scene.floor)
      end, function()
        scene.floor[name] = old
      end
    end,
  },
}

-- Tries a value in a field; a refused one is repaired, and the world goes on as its twin. Returns
-- whether it was refused.
local function tryField(scene, twin, way, name, value)
  local what = ("%s %s is %s"):format(name, way[1], value[1])
  local call, repair = way[2](scene, name, value[2])
  local seen = snapshot(scene)
  local ok, message = pcall(call)
  if ok then
    counts.accepted = counts.accepted + 1
    checkGoesOn(scene, what)
    return false
  end
  counts.refused = counts.refused + 1
  message = tostring(message)
  assert(message == THROWN or message:find("bad_matrix_spec.lua:%d+: physics: "), what .. message)
  assert.equal(seen, snapshot(scene), what)
  if repair then
    repair()
  end
  checkGoesOn(scene, what)
  checkGoesOn(twin, what)
  assert.equal(snapshot(twin), snapshot(scene), what)
  return true
end

-- A callback that fails is no bad input: its step is made (recovery_spec.lua).
local function isCallback(field, value)
  return field.type == "function" and value[1] == "a function that throws"
end

describe("whatever is in it, the field", function()
  for _, field in ipairs(fields.objects) do
    it(field.name .. " is taken or refused", function()
      for _, way in ipairs(WAYS) do
        local scene, twin = newScene(), newScene()
        for _, m in ipairs(someValues()) do
          local value = newValues(scene)[m]
          if not isCallback(field, value) then
            if not tryField(scene, twin, way, field.name, value) then
              scene, twin = newScene(), newScene()
            end
          end
        end
      end
    end)
  end
end)

-- Tries a value in a setting; returns whether it was refused.
local function trySetting(scene, twin, name, value)
  local what, given = "setting " .. name .. " is " .. value[1], value[2]
  local answer = judge(scene, function()
    return physics.newWorld({ [name] = given })
  end, aTable, what)
  counts[answer] = counts[answer] + 1
  local old, seen = scene.world[name], snapshot(scene)
  scene.world[name] = given
  local ok, message = pcall(scene.world.update, scene.world, DT)
  counts[ok and "accepted" or "refused"] = counts[ok and "accepted" or "refused"] + 1
  if ok then
    return false
  end
  assert(message == THROWN or message:find("physics: "), what .. ": " .. tostring(message))
  assert.equal(seen, snapshot(scene), what)
  scene.world[name] = old
  checkGoesOn(scene, what)
  checkGoesOn(twin, what)
  assert.equal(snapshot(twin), snapshot(scene), what)
  return true
end

describe("whatever is in it, the setting", function()
  for _, setting in ipairs(fields.settings) do
    it(setting.name .. " is taken or refused", function()
      local scene, twin = newScene(), newScene()
      for _, m in ipairs(someValues()) do
        local value = newValues(scene)[m]
        if not isCallback(setting, value) then
          if not trySetting(scene, twin, setting.name, value) then
            scene, twin = newScene(), newScene()
          end
        end
      end
    end)
  end
end)

describe("whatever it answers,", function()
  -- name, setting or field, call
  for _, row in ipairs({
    {
      "a filter",
      function(scene, answer)
        return scene.world:queryRect(0, 0, 300, 300, answer)
      end,
      listAndCount,
    },
    {
      "a response",
      function(scene, answer)
        return scene.world:move(scene.box, 200, 90, answer)
      end,
      aJourney,
    },
    {
      "canCollide",
      function(scene, answer)
        scene.world.canCollide = answer
        return scene.world:update(DT)
      end,
      nothing,
    },
    {
      "onBegin",
      function(scene, answer)
        scene.world.onBegin = answer
        scene.box.vy = -100
        return scene.world:update(DT)
      end,
      nothing,
    },
  }) do
    it(row[1] .. " is taken or refused", function()
      for _, m in ipairs(someValues()) do
        local scene = newScene()
        local value = newValues(scene)[m]
        local what, given = row[1] .. " returns " .. value[1], value[2]
        local ok, message = pcall(function()
          assert(row[3](row[2](scene, function()
            return given
          end)))
        end)
        counts[ok and "accepted" or "refused"] = counts[ok and "accepted" or "refused"] + 1
        message = tostring(message)
        if not ok then
          assert(message == THROWN or message:find("physics: "), what .. ": " .. message)
        end
        scene.world.canCollide = nil
        checkGoesOn(scene, what)
      end
    end)
  end
end)

describe("the matrix of bad input", function()
  it("has every public function in it", function()
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
  end)

  it("has thousands of calls", function()
    if effort.isWhole then
      assert.is_true(counts.refused > 9000, "refused: " .. counts.refused)
      assert.is_true(counts.accepted > 500, "accepted: " .. counts.accepted)
    end
  end)
end)
