--- Wrong values, all of them: every field, setting and argument, and every kind of value. Whatever
--- is given is taken, or it is refused, blaming this file. A refused call has changed nothing:
--- repair the value, and the game goes on as if it never was. The words are in
--- debugging_errors_spec.lua.

local effort = require("spec.support.effort")
local fields = require("physics.fields.fields")
local physics = require("physics")
local small = require("spec.support.small")

local NAN, INF = 0 / 0, math.huge
local DT = 1 / 60

-- The objects of a scene, by their names in it.
local PARTS = { "floor", "box", "sleeper", "lift", "gate", "removed" }

-- Scenes ------------------------------------------------------------------------------------------

local function newStranger()
  return { x = 500, y = 500, width = 5, height = 5 }
end

local function newBox(name, value)
  local box = small.box(50, 50)
  if name then
    box[name] = value
  end
  return box
end

-- One object of each kind, after a few steps.
--
--                 box      lift ->
--      sleeper     |        ====       gate (sensor)
--     ====== floor v =======================
local function newScene(settings)
  local world = physics.newWorld(settings or { gravity = 800 })
  local scene = { world = world, objects = world.objects }
  scene.floor = world:add("floors", small.tile(0, 200, 400, 16))
  scene.box = world:add("boxes", small.box(100, 150, { vx = 30, restitution = 0.5 }))
  scene.sleeper = world:add("boxes", small.box(20, 184))
  scene.lift = world:add("lifts", small.put(160, 140, 64, 8, { kinematic = true, vx = 20 }))
  scene.gate = world:add("gates", small.tile(300, 150, 8, 50, { sensor = true }))
  scene.removed = world:add("others", newStranger())
  scene.boxes = world.objects.boxes
  small.run(world, 4)
  world:remove(scene.removed)
  world:update(DT)
  return scene
end

local function show(value)
  return type(value) == "number" and ("%.17g"):format(value) or tostring(value)
end

-- What the game sees of a scene, by raw access, numbers to the bit, tables as kinds.
local function snapshot(scene)
  local lines = {}
  for _, part in ipairs(PARTS) do
    for key, value in next, scene[part] do
      local text = type(value) == "table" and "table" or show(value)
      lines[#lines + 1] = part .. "." .. tostring(key) .. "=" .. text
    end
    for side, other in next, rawget(scene[part], "touching") or {} do
      lines[#lines + 1] = part .. ".touching." .. side .. "=" .. tostring(not not other)
    end
  end
  table.sort(lines)
  return table.concat(lines, "\n")
end

local function threeStepsLater(scene)
  small.run(scene.world, 3)
  return snapshot(scene)
end

local untouched

-- Fails unless a scene goes on like one to which nothing has happened, to the bit.
local function checkGoesOn(scene)
  untouched = untouched or threeStepsLater(newScene())
  local found = threeStepsLater(scene)
  assert(found == untouched, found)
end

-- Values ------------------------------------------------------------------------------------------

local THROWN = "thrown by a metamethod"

local function throw()
  error(THROWN, 0)
end

-- A table that fails whenever it is looked at, however that is done.
local function newThrower(value)
  local meta = {}
  for name in ("index newindex len eq lt le call pairs"):gmatch("%a+") do
    meta["__" .. name] = throw
  end
  return setmetatable(value or {}, meta)
end

local function newCycle()
  local cycle = { x = 1, y = 2 }
  cycle.self, cycle[1], cycle.width = cycle, cycle, cycle
  return cycle
end

local function longList()
  local list = {}
  for n = 1, 2000 do
    list[n] = n % 3 == 0 and "boxes" or n
  end
  return list
end

local PLAIN = { true, false, "text", "12", "", ("\0\255long"):rep(10000), throw, io.stdout }
local NUMBERS = { NAN, INF, -INF, -0.0, 1, -1, 0.5, 1e308, -1e308, 2 ^ -1074 }
local COUNT = 34

-- The values, the last of which is nil; tables are made anew for a scene.
local function newValues(scene)
  local tables = { {}, { "boxes", nil, "lifts" }, longList(), { boxes = true }, newCycle() }
  local function nothing() end
  local own = {
    nothing,
    newThrower(),
    newThrower(newStranger()),
    newStranger(),
    coroutine.create(throw),
  }
  local its = { scene.box, scene.floor, scene.removed, scene.world, scene.objects }
  local values = {}
  for _, list in ipairs({ PLAIN, NUMBERS, tables, own, its }) do
    for _, value in ipairs(list) do
      values[#values + 1] = value
    end
  end
  assert(#values == COUNT - 1)
  return values
end

local function nameOf(n, value)
  return ("%s (value %d)"):format(type(value) == "string" and value:sub(1, 9) or tostring(value), n)
end

-- The numbers of some values, others each time, or of all: in the whole of LuaJIT.
local turn = 0

local function someValues()
  turn = turn + 1
  local some, step = {}, effort.isWhole and 1 or effort.isFirst and 3 or 4
  for n = 1 + turn % step, COUNT, step do
    some[#some + 1] = n
  end
  return some
end

-- Refusals ----------------------------------------------------------------------------------------

local counts = { taken = 0, refused = 0 }

local function pack(...)
  return { n = select("#", ...), ... }
end

-- Makes a call. Returns whether it was taken, and what it returned; else what was said, which must
-- blame this file.
local function try(what, call, ...)
  local list = pack(pcall(call, ...))
  local which = list[1] and "taken" or "refused"
  counts[which] = counts[which] + 1
  if list[1] then
    return true, list
  end
  local text = list[2] == THROWN and THROWN
    or tostring(list[2]):match("debugging_bad_input_spec%.lua:%d+: physics: (.*)$")
  assert(text, what .. ": " .. tostring(list[2]))
  return false, text
end

-- Makes a call that must be refused with these words in the message.
local function refusesWith(words, call, ...)
  local isTaken, text = try(words, call, ...)
  assert.is_false(isTaken, words)
  assert.truthy(text:find(words, 1, true), text)
end

-- Fields and settings -----------------------------------------------------------------------------

-- how a message writes the place; what puts a value there and meets it: a `new` object in a table,
-- under a key, and an update; `add`; what is there already, and `refresh` or an update; a function
local NEW = {
  { "objects.boxes[3].", "new", "boxes", 3 },
  { "objects.player.", "new", "objects", "player" },
  { "objects.boxes[3].", "add", "boxes" },
  { "objects.crates[1].", "add", "crates" },
  { "objects.floors[1].", "refresh", "floor" },
}
local LATER = {
  { "objects.boxes[1].", "update", "box" },
  { "objects.boxes[2].", "update", "sleeper" },
  { "objects.lifts[1].", "update", "lift" },
}
local GIVEN = { { "newWorld(settings): ", "newWorld" }, { "load(settings): ", "load" } }
local WRITTEN = { { "world.", "update", "world" } }

-- Puts a value to a place. Returns the call that meets it, and what takes it away again.
local function put(scene, place, name, value)
  local how, part = place[2], place[3]
  local world, owner, key, item = scene.world, scene[part], name, value
  if how == "new" or how == "add" then
    key, item = place[4], newBox(name, value)
  end
  local old = owner and owner[key]
  if how == "update" or how == "refresh" or how == "new" then
    owner[key] = item
  end
  local function call()
    if how == "add" then
      world:add(part, item)
    elseif how == "refresh" then
      world:refresh(owner)
    elseif part then
      world:update(DT)
    else
      physics[how]({ [name] = value })
    end
  end
  return call, function()
    if owner and key then
      owner[key] = old
    end
  end
end

local function isInRange(row, value)
  return type(value) == "number"
    and math.abs(value) <= 1e100
    and value >= (row.min or value)
    and value <= (row.max or value)
    and (not row.above or value - row.above >= 1e-100)
end

-- Whether a value fits a row; nil: it depends on the other fields, or on what the table holds.
local function fits(row, value, place)
  local kind = type(value)
  if value == nil then
    return not row.required and (place ~= "world." or row.default == nil)
  elseif row.type == "number" then
    return isInRange(row, value) and (row.name ~= "radius" or nil)
  elseif row.type == "string" then
    return kind == "boolean" and row.yes ~= nil
  elseif row.type == "boolean" or row.type == "function" then
    return kind == row.type
  end
  return kind ~= "table" and false or nil
end

-- Puts a value into a field or setting at a place. If it is refused, everything is as it was.
local function tryAt(place, row, value, what)
  local scene = newScene()
  local call, repair = put(scene, place, row.name, value)
  local before = snapshot(scene)
  local fit = fits(row, value, place[1])
  for _ = 1, 2 do
    local isTaken, text = try(what, call)
    assert(isTaken or not fit, what .. " is refused: " .. tostring(text))
    if isTaken then
      assert(fit ~= false, what .. " is taken")
      return
    end
    local expected = place[1] .. row.name .. (fit == false and " must be " or "")
    assert(text == THROWN or text:sub(1, #expected) == expected, what .. ": " .. text)
    assert.equal(before, snapshot(scene), what)
  end
  repair()
  checkGoesOn(scene)
end

-- All values, and those at the ends of its range, for a row: in a new object or world, and later.
local function tryRow(row, first, later)
  local values, list = newValues(newScene()), {}
  for n, m in ipairs(someValues()) do
    list[n] = { values[m] }
  end
  local low, high = row.min or row.above or 0, row.max or 0
  for _, edge in ipairs({ low - 0.1, row.above or 1, high + 0.1 }) do
    list[#list + 1] = { edge }
  end
  local isRead = row.name ~= "static" and (row.column or row.type ~= "function")
  for n, item in ipairs(list) do
    local value = item[1]
    -- A callback that fails is no bad input: its step is made (recovery_spec.lua).
    if value ~= throw then
      local what = row.name .. " is " .. nameOf(n, value)
      tryAt(first[1 + n % #first], row, value, what)
      if isRead or first == GIVEN then
        tryAt(later[1 + n % #later], row, value, what .. " later")
      end
    end
  end
end

describe("every field and setting: whatever is in it, it is taken or refused:", function()
  after_each(function()
    physics.load()
  end)

  for _, row in ipairs(fields.objects) do
    if not row.written then
      it("the field " .. row.name, function()
        tryRow(row, NEW, LATER)
      end)
    end
  end

  for _, row in ipairs(fields.settings) do
    it("the setting " .. row.name, function()
      tryRow(row, GIVEN, WRITTEN)
    end)
  end
end)

-- Functions ---------------------------------------------------------------------------------------

-- The methods: name, arguments that are fine.
local function newMethods(scene)
  local box, floor, all = scene.box, scene.floor, { "boxes", "floors" }
  return {
    { "update", DT },
    { "add", "boxes", newStranger() },
    { "remove", box },
    { "refresh", box },
    { "ground", box },
    { "groupOf", box },
    { "dropThrough", scene.sleeper },
    { "save", {} },
    { "restore", scene.world:save() },
    { "hash" },
    { "interpolate", box },
    { "queryPoint", 25, 190, "boxes", {} },
    { "queryRect", 10, 180, 50, 50, all, {} },
    { "queryCircle", 25, 190, 40, all, {} },
    { "querySegment", 0, 190, 400, 195, "boxes", {}, {} },
    { "raycast", 0, 190, 400, 195, "boxes" },
    { "sweep", box, 100, 50, "floors" },
    { "cast", 0, 180, 20, 20, 400, 5, "boxes" },
    { "castCircle", 0, 190, 10, 400, 5, "boxes" },
    { "fits", 20, 190, 40, 30, "boxes" },
    { "freePlace", 20, 190, 40, 30, 100, "boxes" },
    { "velocity", box },
    { "shift", 10, 20 },
    { "nearest", 10, 10, 300, "boxes" },
    { "overlapping", scene.gate, "boxes", {} },
    { "touching", scene.sleeper, floor },
    { "explain", box, floor },
    { "move", box, 60, 50, "slide", {} },
    { "impulse", box, 10, 10 },
    { "explode", 20, 190, 200, 300, "boxes", { "floors" } },
    { "setBounds", 0, 0, 300, 200 },
  }
end

-- The functions that are no methods.
local function newFunctions()
  return {
    { "inside", 1, 1, 2, 2, 0, 0, 9, 9 },
    { "side", newStranger(), newStranger() },
    { "checkCollision", newStranger(), newStranger(), true },
    { "checkCollision", 1, 1, 2, 2, 0, 0, 9, 9, true },
    { "bump", newStranger(), { x = 503, y = 501, width = 5, height = 5 }, "first" },
    { "newWorld", { gravity = 5 } },
    { "load", { gravity = 5 } },
  }
end

-- Not tried here: `draw` needs LÖVE (debugging_draw_spec.lua), `globals` takes nothing, and maps
-- have specs of their own.
local ELSEWHERE =
  { draw = true, globals = true, loadTiled = true, loadLDtk = true, addTiles = true }

local function isFinite(value)
  return value - value == 0
end

-- Of a table that is in no world `interpolate` returns x and y, whatever they are.
local function checkResults(what, list)
  for n = 2, what:find("^interpolate") and 0 or list.n do
    local value = list[n]
    assert(type(value) ~= "number" or isFinite(value), what .. ": returned " .. tostring(value))
  end
end

-- Makes a call, which returns numbers and others that a game can use, or is refused and has changed
-- nothing. Returns the scene for the next call: one is good for many that are refused.
local function judge(scene, what, call, ...)
  scene.hash, scene.seen = scene.hash or scene.world:hash(), scene.seen or snapshot(scene)
  local isTaken, list = try(what, call, ...)
  if isTaken then
    checkResults(what, list)
    return newScene()
  end
  assert.equal(scene.seen, snapshot(scene), what)
  assert.equal(scene.hash, scene.world:hash(), what)
  return scene
end

-- Whatever has happened, the world goes on.
local function checkAlive(scene, what)
  for _ = 1, 2 do
    local isDone, message = pcall(scene.world.update, scene.world, DT)
    assert(isDone or message == THROWN, what .. ": the next update fails: " .. tostring(message))
  end
  for _, part in ipairs(PARTS) do
    local its = scene[part]
    local sum = its.x + its.y + (its.vx or 0) + (its.vy or 0)
    assert(isFinite(sum), what .. ": " .. part .. " is lost")
  end
end

-- All values at all places of a function of `owner(scene)`, which is row n of `newRows(scene)`. Its
-- arguments begin with the world, or behind that.
local function tryAll(newRows, n, owner, first)
  local scene = newScene()
  local row = newRows(scene)[n]
  for place = 2, #row do
    for _, m in ipairs(someValues()) do
      local args, value = newRows(scene)[n], newValues(scene)[m]
      args[1], args[place] = scene.world, value
      local what = ("%s, argument %d is %s"):format(row[1], place - 1, nameOf(m, value))
      scene = judge(scene, what, function()
        return nil, owner(scene)[row[1]](small.unpack(args, first, #row))
      end)
    end
    checkAlive(scene, row[1])
    scene = newScene()
  end
end

local NAMES = newMethods(newScene())

describe("every function: whatever it is given,", function()
  for n, row in ipairs(NAMES) do
    it("world:" .. row[1] .. " answers or refuses it", function()
      tryAll(newMethods, n, function(scene)
        return scene.world
      end, 1)
    end)
  end

  for n, row in ipairs(newFunctions()) do
    it("physics." .. row[1] .. " answers or refuses it, row " .. n, function()
      tryAll(newFunctions, n, function()
        return physics
      end, 2)
      physics.load()
    end)
  end
end)

small.each("every callback: whatever it answers, {1} is taken or refused", {
  ["a filter"] = function(scene, answer)
    scene.world:queryRect(0, 0, 300, 300, answer)
  end,
  ["a response"] = function(scene, answer)
    scene.world:move(scene.box, 200, 190, answer)
  end,
  canCollide = function(scene, answer)
    scene.world.canCollide = answer
    scene.world:update(DT)
  end,
  onBegin = function(scene, answer)
    scene.world.onBegin, scene.sleeper.vy = answer, -100
    scene.world:update(DT)
  end,
}, function(name, call)
  for _, m in ipairs(someValues()) do
    local scene = newScene()
    local value = newValues(scene)[m]
    local what = name .. " returns " .. nameOf(m, value)
    try(what, call, scene, function()
      return value
    end)
    scene.world.canCollide = nil
    checkAlive(scene, what)
  end
end)

it("every function: the matrix has each public one in it, and thousands of calls", function()
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
    assert.is_true(counts.refused > 8000, "refused: " .. counts.refused)
    assert.is_true(counts.taken > 1000, "taken: " .. counts.taken)
  end
end)

-- Calls in the wrong way --------------------------------------------------------------------------

-- Calls `visit(name)` for the public functions of a table, but for that which takes nothing.
local function eachFunction(methods, visit)
  local count = 0
  for name, method in pairs(methods) do
    if type(method) == "function" and name ~= "globals" and not name:find("^_") then
      count = count + 1
      visit(name)
    end
  end
  assert.is_true(count > 25)
end

describe("every function:", function()
  it("method of a world says so when it is called with a dot instead of a colon", function()
    local world = physics.newWorld()
    eachFunction(getmetatable(world).__index, function(name)
      for _, owner in ipairs({ DT, "boxes", {} }) do
        local words = "must be called with a colon on a world, got "
        refusesWith(words, world[name], owner, newBox())
        refusesWith("world:" .. name .. "(", world[name], owner, newBox())
      end
    end)
  end)

  it("function says so when it is called with a colon, and does nothing", function()
    physics.load({ gravity = 800 })
    local coin = physics.add("coins", newBox())
    local hash = physics.hash()
    eachFunction(physics, function(name)
      local words = "physics." .. name .. " must be called with a dot, not with a colon"
      for _, argument in ipairs({ DT, "coins", coin, {} }) do
        refusesWith(words, physics[name], physics, argument, coin)
      end
      assert.is_false((pcall(physics[name], physics)), name)
    end)
    assert.equal(hash, physics.hash())
    assert.equal(coin, physics.objects.coins[1])
    physics.load()
  end)
end)

-- What changes a world, or needs one that stands still.
local CHANGING = " update add remove refresh restore save hash move impulse explode shift"
  .. " setBounds dropThrough "

describe("canCollide", function()
  for n, row in ipairs(NAMES) do
    it(("may call world:%s, or is refused, and nothing has changed"):format(row[1]), function()
      local scene = newScene()
      local args, isTaken, text = newMethods(scene)[n], nil, nil
      args[1] = scene.world
      function scene.world.canCollide()
        if isTaken == nil then
          isTaken, text = try(row[1], scene.world[row[1]], small.unpack(args, 1, #row))
        end
        return true
      end
      checkGoesOn(scene)
      assert.equal(CHANGING:find(" " .. row[1] .. " ", 1, true) == nil, isTaken)
      local words = "^world:" .. row[1] .. "%(.-%) cannot be called from inside canCollide"
      assert(isTaken or text:find(words), text)
    end)
  end
end)

it("width: denormal ones tell thin boxes at the same place apart", function()
  local world = physics.newWorld({ gravity = 100 })
  local thin = world:add("a", { x = 1e-310, y = 0, width = 1e-7, height = 10 })
  world:add("a", { x = 0, y = 0, width = 10, height = 10 })
  world:update(1 / 60)
  assert.is_true(thin.y > 0)
end)
