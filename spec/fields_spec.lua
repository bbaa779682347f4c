--- The list of all fields and settings: complete, well formed, and true to its own checks.

local check = require("physics.fields.check")
local fields = require("scripts.meanings")

-- Every field of an object: name, default, unit.
local OBJECTS = {
  { "x", nil, "px" },
  { "y", nil, "px" },
  { "width", nil, "px" },
  { "height", nil, "px" },
  { "radius", nil, "px" },
  { "vx", 0, "px/s" },
  { "vy", 0, "px/s" },
  { "ax", 0, "px/s²" },
  { "ay", 0, "px/s²" },
  { "static", false },
  { "kinematic", false },
  { "active", true },
  { "sensor", false },
  { "area", nil },
  { "pushable", true },
  { "strength", 0 },
  { "mass", 1 },
  { "gravity", nil, "px/s²" },
  { "gravityX", nil, "px/s²" },
  { "friction", 0 },
  { "restitution", 0 },
  { "airFriction", 0, "1/s" },
  { "drag", 0, "px/s²" },
  { "maxSpeed", nil, "px/s" },
  { "maxSpeedX", nil, "px/s" },
  { "maxSpeedY", nil, "px/s" },
  { "maxFallSpeed", nil, "px/s" },
  { "mask", nil },
  { "hits", nil },
  { "oneWay", nil },
  { "slope", nil },
  { "carry", true },
  { "surfaceSpeed", 0, "px/s" },
  { "nudge", 0, "px" },
  { "snap", 0, "px" },
  { "constantSpeed", false },
  { "touching", nil },
  { "onBegin", nil },
  { "onStay", nil },
  { "onEnd", nil },
  { "onCrush", nil },
  { "canCollide", nil },
}

-- Every setting: name, default, unit.
local SETTINGS = {
  { "gravity", 627.84, "px/s²" },
  { "gravityX", 0, "px/s²" },
  { "push", "both" },
  { "masks", nil },
  { "soft", nil, "px/s" },
  { "sideBySide", false },
  { "broadphase", "auto" },
  { "cellSize", nil, "px" },
  { "timestep", nil, "s" },
  { "maxStep", 1 / 30, "s" },
  { "order", nil },
  { "ownFields", nil },
  { "rest", true },
  { "checked", false },
  { "profile", nil },
  { "onStep", nil },
  { "onBegin", nil },
  { "onStay", nil },
  { "onEnd", nil },
  { "onCrush", nil },
  { "canCollide", nil },
}

local TYPES = {
  number = true,
  boolean = true,
  string = true,
  ["function"] = true,
  mask = true,
  masks = true,
  soft = true,
  names = true,
  ownFields = true,
  sides = true,
  area = true,
}

--- Whether a value passes the check of a field of an object.
local function isObjectValue(field, value)
  return (pcall(check.fields, { [field.name] = value }, "object", { field.name }))
end

--- Whether a value passes the check of a setting.
local function isSettingValue(field, value)
  return (pcall(check.settings, { [field.name] = value }, "newWorld(settings)"))
end

for _, kind in ipairs({
  { "objects", fields.objects, fields.objectByName, OBJECTS, isObjectValue },
  { "settings", fields.settings, fields.settingByName, SETTINGS, isSettingValue },
}) do
  local title, list, byName, expected, isValue = kind[1], kind[2], kind[3], kind[4], kind[5]

  describe("fields." .. title, function()
    it("lists each name once, in the documented order", function()
      local names, listed = {}, {}
      for i, row in ipairs(expected) do
        names[i] = row[1]
      end
      for i, field in ipairs(list) do
        listed[i] = field.name
      end
      assert.same(names, listed)
    end)

    it("can be found by name", function()
      for _, field in ipairs(list) do
        assert.equal(field, byName[field.name])
      end
    end)

    for i, row in ipairs(expected) do
      local name, default, unit = row[1], row[2], row[3]
      local field = list[i]

      describe("." .. name, function()
        it("has its default and unit", function()
          if type(default) == "number" then
            assert.near(default, field.default, 1e-12)
          else
            assert.equal(default, field.default)
          end
          assert.equal(unit, field.unit)
        end)

        it("has a known type and says in a sentence what it means", function()
          assert.is_true(TYPES[field.type])
          assert.truthy(field.meaning:find("^[%u`].+%.$"))
          assert.equal(field.type == "function", field.signature ~= nil)
          assert.equal(field.type == "string", field.values ~= nil)
        end)

        it("says what nil stands for", function()
          local says = field.default ~= nil or field.absent ~= nil
          assert.is_true(says or field.required == true or field.written == true)
        end)

        it("accepts its own default, and nothing but numbers as numbers", function()
          assert.is_true(field.default == nil or isValue(field, field.default))
          if field.type == "number" then
            for _, wrong in ipairs({ "1", false, true, {}, 0 / 0, 1 / 0, -1 / 0 }) do
              assert.is_false(isValue(field, wrong))
            end
          end
        end)

        if field.type == "number" then
          it("accepts its whole range and not more", function()
            local low = field.min or field.above
            assert.equal(field.above == nil, not low or isValue(field, low))
            assert.equal(low == nil, isValue(field, -1e-9))
            assert.is_true(not field.max or isValue(field, field.max))
            assert.equal(field.max == nil, isValue(field, 1e9))
          end)
        end
      end)
    end
  end)
end
