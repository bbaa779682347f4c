--- The rows of fields, entries of areas and settings: well formed, and all that a new field needs.
--- What they accept is in debugging_bad_input_spec.lua.

local fields = require("scripts.meanings")
local files = require("spec.support.files")
local fresh = require("spec.support.fresh")
local small = require("spec.support.small")

local read = files.read

for _, list in ipairs({ "objects", "area", "settings" }) do
  local names = {}
  for _, row in ipairs(fields[list]) do
    local name, type = row.name, row.type
    local title = (list == "area" and "area." or "") .. name
    it(title .. ": its row of " .. list .. " is well formed", function()
      assert.is_nil(names[name])
      names[name] = true
      assert.matches("^[%u`].+%.$", row.meaning)
      assert.equal(type == "function", row.signature ~= nil)
      assert.equal(type == "string", row.values ~= nil)
    end)
  end
end

-- A new field ------------------------------------------------------------------------------------

-- The examples of CONTRIBUTING.md. By file: a line, and what is put in front of it.
local LIFT = {
  ["physics/fields/fields.lua"] = {
    "  --- Replaces the world's downward gravity for this object",
    "  --- An acceleration upwards, as of a balloon.\n  --- Unit: px/s²\n"
      .. '  { name = "lift", type = "number", default = 0, min = 0, moves = true },\n',
  },
  ["physics/objects/readFields.lua"] = {
    "  if b.kind[i] ~= DYNAMIC then\n    gx, gy = 0, 0",
    "  gy = gy - b.lift[i]\n",
  },
}

local ON_LAND = {
  ["physics/fields/fields.lua"] = {
    "  --- Called before a contact: `false` lets",
    "  --- Called when it has come to stand on something.\n"
      .. "  --- Absent: none\n  --- Parameters: (self)\n"
      .. '  { name = "onLand", type = "function", event = "alone" },\n',
  },
  ["physics/memory/layout.lua"] = {
    "  carrier = WHOLE, -- slot of its carrier",
    "  stood = false, -- it stood on something at the end of its last step\n",
    '  { "carrier", 1, 0, isLink = true',
    '  { "stood", 1, false },\n',
  },
  ["physics/objects/write.lua"] = {
    "    if now ~= support[i] then",
    "    if now ~= 0 and not b.stood[i] then\n"
      .. '      events.add(b, "onLand", i, i, false, 0)\n'
      .. "    end\n"
      .. "    b.stood[i] = now ~= 0\n",
  },
}

local CAPSULE = {
  ["physics/fields/fields.lua"] = {
    "  --- The velocity along x. For a rider",
    "  --- A capsule in its rectangle: the two short sides are half circles.\n"
      .. '  { name = "capsule", type = "boolean", default = false },\n',
  },
  ["physics/space/shapes.lua"] = {
    "  -- Slopes are named after",
    '  { field = "capsule", round = 0.5 },\n',
  },
}

-- Calls f(physics) with a library to which that is added.
local function with(added, f)
  local changed = {}
  for path, row in pairs(added) do
    local text = read(path)
    for n = 1, #row, 2 do
      local at = assert(text:find(row[n], 1, true), path)
      text = text:sub(1, at - 1) .. row[n + 1] .. text:sub(at)
    end
    changed[path] = text
  end
  local scripts = { "meanings", "types", "manual" }
  local loaded = {}
  for _, name in ipairs(scripts) do
    loaded[name], package.loaded["scripts." .. name] = package.loaded["scripts." .. name], nil
  end
  for path, text in pairs(changed) do
    local name = path:gsub("%.lua$", ""):gsub("/", ".")
    package.preload[name] = assert((rawget(_G, "loadstring") or load)(text, "@" .. path))
  end
  files.read = function(path)
    return changed[path] or read(path)
  end
  local isDone, problem = pcall(fresh.during, f)
  files.read = read
  for path in pairs(changed) do
    package.preload[path:gsub("%.lua$", ""):gsub("/", ".")] = nil
  end
  for _, name in ipairs(scripts) do
    package.loaded["scripts." .. name] = loaded[name]
  end
  assert(isDone, problem)
end

local function newBalloon(lift)
  return { x = 0, y = 0, width = 10, height = 10, lift = lift }
end

local function refuses(text, f, ...)
  local isDone, message = pcall(f, ...)
  assert.is_false(isDone)
  assert.matches(text, message, 1, true)
end

describe("every field: a new one needs one row, and a line where it acts: it is", function()
  it("read, compared, and refused when it is wrong #files", function()
    with(LIFT, function(physics)
      local world = physics.newWorld({ gravity = 300 })
      local balloon = world:add("balloons", newBalloon(300))
      local stone = world:add("balloons", newBalloon(nil))
      stone.x = 50
      world:update(1 / 10)
      assert.same({ 0, 30 }, { balloon.vy, stone.vy })
      balloon.lift, stone.lift = 400, 300
      world:update(1 / 10)
      assert.same({ -10, 30 }, { balloon.vy, stone.vy })
      balloon.lift = nil
      world:update(1 / 10)
      assert.same({ 20, 30 }, { balloon.vy, stone.vy })
      stone.lift = -1
      refuses("objects.balloons[2].lift must be a number >= 0, got -1", world.update, world, 0)
      local text = "objects.b[1].lift must be a number >= 0, got table"
      refuses(text, world.add, world, "b", newBalloon({}))
    end)
  end)

  it("saved, restored, hashed, and refused in a state #files", function()
    with(LIFT, function(physics)
      local world = physics.newWorld({ gravity = 300 })
      local balloon = world:add("balloons", newBalloon(400))
      world:update(1 / 10)
      local state, hash = world:save(), world:hash()
      balloon.lift = 500
      assert.are_not.equal(hash, world:hash())
      world:restore(state)
      assert.same({ 400, hash }, { balloon.lift, world:hash() })
      local twin = physics.newWorld()
      twin:restore(state)
      twin:update(1 / 10)
      assert.same({ 400, -20 }, { twin.objects.balloons[1].lift, twin.objects.balloons[1].vy })
      state.fields[1].lift = "up"
      refuses('state.fields[1].lift must be a number >= 0, got "up"', twin.restore, twin, state)
    end)
  end)

  it("in the manual, in the types, and known to `checked` #files", function()
    with(LIFT, function(physics)
      local all = {}
      for _, page in pairs(require("scripts.manual").pages()) do
        all[#all + 1] = page
      end
      local line = "`lift` | px/s², >= 0 | `0` | An acceleration upwards, as of a balloon."
      assert.is_truthy(table.concat(all, "\n"):find(line, 1, true))
      local types = require("scripts.types").text()
      assert.is_truthy(types:find("---@field lift? number", 1, true))
      local world = physics.newWorld({ checked = true })
      local balloon = world:add("balloons", newBalloon(3)) -- so there is something like gravity:
      world:add("belts", { x = 0, y = -9, width = 9, height = 9, static = true, surfaceSpeed = 9 })
      world:update(1 / 60)
      balloon.Lift = 3
      refuses("lift", world.update, world, 1 / 60)
    end)
  end)
end)

describe("every callback: a new one needs one row, and a place that notices it: it is", function()
  -- A box falls on a floor, is lifted, and falls again.
  local function play(physics, settings, onLand)
    local world = physics.newWorld(settings)
    world:add("floor", { x = 0, y = 10, width = 50, height = 10, static = true })
    local box = world:add("boxes", { x = 0, y = -5, width = 10, height = 10, onLand = onLand })
    for n = 1, 60 do
      box.y = n == 30 and -5 or box.y
      world:update(1 / 60)
    end
    return world
  end

  it("told to the object and to the world #files", function()
    with(ON_LAND, function(physics)
      local told = {}
      local function tell(...)
        told[#told + 1] = ("%d %d"):format(select("#", ...), (...).height)
      end
      play(physics, { onLand = tell, rest = false }, tell)
      assert.same({ "1 10", "1 10", "1 10", "1 10" }, told)
      play(physics, { onLand = tell, rest = true }, tell)
      assert.equal(8, #told)
      local twin = play(physics, { checked = true })
      twin.objects.boxes[1].onland = tell
      refuses("onLand", twin.update, twin, 1 / 60)
      refuses("onLand must be a function, got 3", physics.newWorld, { onLand = 3 })
    end)
  end)
end)

describe("every field: that of a new shape needs a row that says what it is: it", function()
  local function newCapsule(more)
    local capsule = small.put(100, 340, 20, 60, more)
    capsule.capsule = true
    return capsule
  end

  local function newWorld(physics)
    local world = physics.newWorld({ gravity = 800 })
    world:add("floor", { x = -500, y = 400, width = 2000, height = 40, static = true })
    return world
  end

  it("stands, pushes, slides and rolls off #files", function()
    with(CAPSULE, function(physics)
      local world = newWorld(physics)
      local wall = world:add("walls", { x = 200, y = 300, width = 20, height = 100, static = true })
      local capsule = world:add("capsules", newCapsule({ y = 300, mass = 1e6 }))
      local box = world:add("boxes", { x = 113, y = 200, width = 10, height = 10 })
      small.run(world, 240)
      assert.same({ 340, 0, 390 }, { capsule.y, capsule.vy, box.y })
      assert.equal(world.objects.floor[1], capsule.touching.bottom)
      world:remove(box)
      for _ = 1, 60 do
        capsule.vx = 200
        world:update(1 / 60)
      end
      assert.same({ 180, 340 }, { capsule.x, capsule.y })
      assert.equal(wall, capsule.touching.right)
    end)
  end)

  -- Its upper half circle is around (110, 350), 10 px wide.
  it("is seen by queries where it is round #files", function()
    with(CAPSULE, function(physics)
      local world = newWorld(physics)
      local capsule = world:add("capsules", newCapsule({ static = true }))
      local found = {}
      for n, place in ipairs({ { 101, 341 }, { 101, 370 }, { 110, 341 }, { 104, 342.5 } }) do
        found[n] = #world:queryPoint(place[1], place[2], "capsules")
      end
      assert.same({ 0, 1, 1, 1 }, found)
      local _, far = world:nearest(98, 334, 50, "capsules")
      assert.equal(10, far)
      local hit, x, y, nx, ny = world:raycast(0, 342, 300, 342)
      assert.equal(capsule, hit)
      for n, value in ipairs({ 104, 342, -0.6, -0.8 }) do
        assert.near(value, ({ x, y, nx, ny })[n], 1e-9)
      end
      assert.is_nil((world:raycast(90, 350, 103, 337)))
      assert.same({ 100, 370, -1, 0, 0.25 }, { select(2, world:raycast(0, 370, 400, 370)) })
    end)
  end)
end)
