--- Wrong values of every kind, a scene to put them in, and whether the scene goes on as if nothing
--- had happened: for debugging_bad_input_spec.lua.

local effort = require("spec.support.effort")
local physics = require("physics")

local wrong = {}

local NAN, INF = 0 / 0, math.huge
local DT = 1 / 60

--- The objects of a scene, by their names in it.
wrong.PARTS = { "floor", "box", "sleeper", "lift", "gate", "removed" }

-- Scenes ------------------------------------------------------------------------------------------

function wrong.newStranger()
  return { x = 500, y = 500, width = 5, height = 5 }
end

function wrong.newBox(name, value)
  local box = { x = 50, y = 50, width = 16, height = 16 }
  if name then
    box[name] = value
  end
  return box
end

--- One object of each kind, after a few steps.
---
---                 box      lift ->
---      sleeper     |        ====       gate (sensor)
---     ====== floor v =======================
function wrong.newScene(settings)
  local world = physics.newWorld(settings or { gravity = 800 })
  local scene = {
    world = world,
    objects = world.objects,
    floor = { x = 0, y = 200, width = 400, height = 16, static = true },
    box = { x = 100, y = 150, width = 16, height = 16, vx = 30, restitution = 0.5 },
    sleeper = { x = 20, y = 184, width = 16, height = 16 },
    lift = { x = 160, y = 140, width = 64, height = 8, kinematic = true, vx = 20 },
    gate = { x = 300, y = 150, width = 8, height = 50, static = true, sensor = true },
    removed = wrong.newStranger(),
  }
  world:add("floors", scene.floor)
  world:add("boxes", scene.box)
  world:add("boxes", scene.sleeper)
  world:add("lifts", scene.lift)
  world:add("gates", scene.gate)
  world:add("others", scene.removed)
  scene.boxes = world.objects.boxes
  for _ = 1, 4 do
    world:update(DT)
  end
  world:remove(scene.removed)
  world:update(DT)
  return scene
end

local function show(value)
  return type(value) == "number" and ("%.17g"):format(value) or tostring(value)
end

--- What the game sees of a scene, by raw access, numbers to the bit, tables as kinds.
function wrong.snapshot(scene)
  local lines = {}
  for _, part in ipairs(wrong.PARTS) do
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
  for _ = 1, 3 do
    scene.world:update(DT)
  end
  return wrong.snapshot(scene)
end

local untouched

--- Fails unless a scene goes on like one to which nothing has happened, to the bit.
function wrong.checkGoesOn(scene)
  untouched = untouched or threeStepsLater(wrong.newScene())
  local found = threeStepsLater(scene)
  assert(found == untouched, found)
end

-- Values ------------------------------------------------------------------------------------------

wrong.THROWN = "thrown by a metamethod"

function wrong.throw()
  error(wrong.THROWN, 0)
end

-- A table that fails whenever it is looked at, however that is done.
local function newThrower(value)
  local meta = {}
  for name in ("index newindex len eq lt le call pairs"):gmatch("%a+") do
    meta["__" .. name] = wrong.throw
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

local PLAIN = { true, false, "text", "12", "", ("\0\255long"):rep(10000), wrong.throw, io.stdout }
local NUMBERS = { NAN, INF, -INF, -0.0, 1, -1, 0.5, 1e308, -1e308, 2 ^ -1074 }
local COUNT = 34

-- The values, the last of which is nil; tables are made anew for a scene.
function wrong.newValues(scene)
  local tables = { {}, { "boxes", nil, "lifts" }, longList(), { boxes = true }, newCycle() }
  local function nothing() end
  local own = {
    nothing,
    newThrower(),
    newThrower(wrong.newStranger()),
    wrong.newStranger(),
    coroutine.create(wrong.throw),
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

function wrong.nameOf(n, value)
  return ("%s (value %d)"):format(type(value) == "string" and value:sub(1, 9) or tostring(value), n)
end

-- The numbers of some values, others each time, or of all: in the whole of LuaJIT.
local turn = 0

function wrong.someValues()
  turn = turn + 1
  local some, step = {}, effort.isWhole and 1 or effort.isFirst and 3 or 4
  for n = 1 + turn % step, COUNT, step do
    some[#some + 1] = n
  end
  return some
end

return wrong
