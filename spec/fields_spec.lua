--- The rows of fields, entries of areas and settings: well formed, and all that a new field needs.
--- What they accept is in debugging_bad_input_spec.lua.

local read = require("spec.support.files").read
local fields = require("scripts.meanings")
local fresh = require("spec.support.fresh")

for _, list in ipairs({ "objects", "area", "settings" }) do
  local names = {}
  for _, row in ipairs(fields[list]) do
    local name, type = row.name, row.type
    it(list .. ": the row of " .. name .. " is well formed", function()
      assert.is_nil(names[name])
      names[name] = true
      assert.matches("^[%u`].+%.$", row.meaning)
      assert.equal(type == "function", row.signature ~= nil)
      assert.equal(type == "string", row.values ~= nil)
      -- It says what nil stands for.
      assert.is_true(row.default ~= nil or row.absent ~= nil or row.required or row.written)
    end)
  end
end

-- A new field ------------------------------------------------------------------------------------

-- The example of CONTRIBUTING.md. By file: a line, and what is put in front of it.
local ADDED = {
  ["physics/fields/fields.lua"] = {
    "  --- Replaces the world's downward gravity for this object",
    "  --- An acceleration upwards, as of a balloon.\n"
      .. '  { name = "lift", type = "number", unit = "px/s²", default = 0, min = 0 },\n',
  },
  ["physics/objects/readFields.lua"] = {
    "  if b.kind[i] ~= DYNAMIC then\n    gx, gy = 0, 0",
    "  gy = gy - b.lift[i]\n",
  },
}

-- Calls f(physics) with a library that has the field `lift`.
local function withLift(f)
  local lines, changed = io.lines, {}
  for path, row in pairs(ADDED) do
    local text = read(path)
    local at = assert(text:find(row[1], 1, true), path)
    changed[path] = text:sub(1, at - 1) .. row[2] .. text:sub(at)
  end
  local scripts = { "meanings", "types", "manual", "typed_fields" }
  local loaded = {}
  for _, name in ipairs(scripts) do
    loaded[name], package.loaded["scripts." .. name] = package.loaded["scripts." .. name], nil
  end
  for path, text in pairs(changed) do
    local name = path:gsub("%.lua$", ""):gsub("/", ".")
    package.preload[name] = assert((rawget(_G, "loadstring") or load)(text, "@" .. path))
  end
  io.lines = function(path) -- luacheck: ignore
    return changed[path] and changed[path]:gmatch("([^\n]*)\n") or lines(path)
  end
  local isDone, problem = pcall(fresh.during, f)
  io.lines = lines -- luacheck: ignore
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

describe("a new field needs one row, and a line where it acts: it is", function()
  it("read, compared, and refused when it is wrong #files", function()
    withLift(function(physics)
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
      refuses("objects.b[1].lift must be a number >= 0, got table", world.add, world, "b", {
        x = 0,
        y = 0,
        width = 1,
        height = 1,
        lift = {},
      })
    end)
  end)

  it("saved, restored, hashed, and refused in a state #files", function()
    withLift(function(physics)
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
      state.fields.lift[2] = "up"
      refuses('objects.balloons[1].lift must be a number >= 0, got "up"', twin.restore, twin, state)
    end)
  end)

  it("in the manual, in the types, and known to `checked` #files", function()
    withLift(function(physics)
      local all = {}
      for _, page in pairs(require("scripts.manual").pages()) do
        all[#all + 1] = page
      end
      local line = "`lift` | px/s², >= 0 | `0` | An acceleration upwards, as of a balloon."
      assert.is_truthy(table.concat(all, "\n"):find(line, 1, true))
      local types = require("scripts.types").text()
      assert.is_truthy(types:find("---@field lift? number", 1, true))
      local world = physics.newWorld({ checked = true })
      local balloon = newBalloon(nil)
      balloon.Lift = 3
      world:add("balloons", balloon)
      refuses("lift", world.update, world, 1 / 60)
    end)
  end)
end)
