local draw = require("physics.draw").draw

local unpack = table.unpack or unpack -- luacheck: ignore (Lua 5.1 has it as a global)

-- Stands in for love.graphics: keeps the state that has to be restored and writes every call down.
local function newRecorder()
  local color, lineWidth = { 0.1, 0.2, 0.3, 0.4 }, 5
  local calls = {}
  local graphics = {}

  function graphics.getColor()
    return color[1], color[2], color[3], color[4]
  end
  function graphics.setColor(...)
    color = { ... }
  end
  function graphics.getLineWidth()
    return lineWidth
  end
  function graphics.setLineWidth(width)
    lineWidth = width
  end
  for _, name in ipairs({ "rectangle", "line", "print" }) do
    graphics[name] = function(...)
      calls[#calls + 1] = { name = name, color = color, lineWidth = lineWidth, ... }
    end
  end
  return graphics, calls
end

local function box(fields)
  fields.x, fields.y = fields.x or 0, fields.y or 0
  fields.width, fields.height = fields.width or 16, fields.height or 16
  return fields
end

describe("draw", function()
  local graphics, calls
  local loveBefore

  before_each(function()
    loveBefore = rawget(_G, "love")
    graphics, calls = newRecorder()
    rawset(_G, "love", { graphics = graphics })
  end)

  after_each(function()
    rawset(_G, "love", loveBefore)
  end)

  local function drawn(objects, options)
    draw({ objects = objects }, options)
    return calls
  end

  local function colorOf(object, options)
    drawn({ boxes = { object } }, options)
    return calls[1].color
  end

  it("draws every object at its place, in its size", function()
    drawn({ boxes = { { x = 3, y = 4, width = 20, height = 10 } } })
    assert.equal(1, #calls)
    assert.same({ "fill", 3, 4, 20, 10 }, { unpack(calls[1], 1, 5) })
  end)

  it("draws objects that stand directly in objects", function()
    drawn({ player = { x = 3, y = 4, width = 20, height = 10 } })
    assert.same({ "fill", 3, 4, 20, 10 }, { unpack(calls[1], 1, 5) })
  end)

  it("draws numbers before strings, each in order, groups and members alike", function()
    local b = { [2] = box({ x = 4 }), [1] = box({ x = 3 }), a = box({ x = 5 }) }
    drawn({ zoo = { box({ x = 7 }) }, b = b, hero = box({ x = 6 }), [2] = { box({ x = 2 }) } })
    local order = {}
    for i, call in ipairs(calls) do
      order[i] = call[2]
    end
    assert.same({ 2, 3, 4, 5, 6, 7 }, order)
  end)

  it("gives each kind a colour of its own", function()
    local seen = {}
    for _, fields in ipairs({
      { static = true },
      { kinematic = true },
      { vx = 1 },
      { vx = 0, vy = 0 },
      { sensor = true },
    }) do
      graphics, calls = newRecorder()
      rawset(_G, "love", { graphics = graphics })
      local text = table.concat(colorOf(box(fields)), " ")
      assert.is_nil(seen[text])
      seen[text] = true
    end
  end)

  it("outlines sensors inside of their box", function()
    drawn({ coins = { box({ x = 10, y = 20, sensor = true, static = true }) } })
    assert.same({ "line", 10.5, 20.5, 15, 15 }, { unpack(calls[1], 1, 5) })
    assert.equal(1, calls[1].lineWidth)
  end)

  it("outlines everything with fill = false", function()
    drawn({ boxes = { box({}) } }, { fill = false })
    assert.equal("line", calls[1][1])
  end)

  it("draws inactive objects faintly, and without their sides", function()
    local touching = { top = false, bottom = {}, left = false, right = false }
    local color = colorOf(box({ active = false, touching = touching }))
    assert.equal(0.3, color[4])
    assert.equal(1, #calls)
  end)

  it("marks each side that touches at its edge", function()
    for _, row in ipairs({
      { "top", 10, 20, 16, 2 },
      { "bottom", 10, 34, 16, 2 },
      { "left", 10, 20, 2, 16 },
      { "right", 24, 20, 2, 16 },
    }) do
      graphics, calls = newRecorder()
      rawset(_G, "love", { graphics = graphics })
      local touching = { top = false, bottom = false, left = false, right = false }
      touching[row[1]] = {}
      drawn({ boxes = { box({ x = 10, y = 20, touching = touching }) } })
      assert.equal(2, #calls)
      assert.same({ unpack(row, 2, 5) }, { unpack(calls[2], 2, 5) })
    end
  end)

  it("marks no side with touching = false", function()
    local touching = { top = false, bottom = {}, left = false, right = false }
    drawn({ boxes = { box({ touching = touching }) } }, { touching = false })
    assert.equal(1, #calls)
  end)

  it("draws velocities when asked, from the middle to where the object is in 0.1 s", function()
    local objects = { boxes = { box({ vx = 100, vy = -50 }), box({ static = true }) } }
    drawn(objects, { velocity = true })
    assert.equal(3, #calls)
    assert.equal("line", calls[2].name)
    assert.same({ 8, 8, 18, 3 }, { unpack(calls[2], 1, 4) })
  end)

  it("writes group and key when asked", function()
    drawn({ boxes = { box({}) }, hero = box({}) }, { names = true })
    assert.equal("boxes 1", calls[2][1])
    assert.equal("hero", calls[4][1])
  end)

  it("draws as opaque as asked", function()
    assert.equal(0.5, colorOf(box({}), { alpha = 0.5 })[4])
  end)

  it("leaves the caller's colour and line width as they were", function()
    drawn({ boxes = { box({ vx = 1 }) } }, { velocity = true, names = true })
    assert.same({ 0.1, 0.2, 0.3, 0.4 }, { graphics.getColor() })
    assert.equal(5, graphics.getLineWidth())
  end)

  it("changes no object", function()
    local object = { x = 3, y = 4, width = 20, height = 10 }
    drawn({ boxes = { object } }, { velocity = true, names = true })
    assert.same({ x = 3, y = 4, width = 20, height = 10 }, object)
  end)

  describe("refuses, blaming the caller:", function()
    local ALL = "the options are alpha, fill, names, touching, velocity"
    for _, row in ipairs({
      { "an unknown option", { filll = true }, 'unknown option "filll"; ' .. ALL },
      { "a numbered option", { "fill" }, "unknown option 1; " .. ALL },
      { "an option of the wrong type", { fill = 1 }, "fill must be true or false, got 1" },
      { "an alpha out of range", { alpha = 2 }, "alpha must be a number in 0..1, got 2" },
      { "options that are no table", 7, "options must be a table, got 7" },
    }) do
      it(row[1], function()
        local ok, message = pcall(function()
          draw({ objects = {} }, row[2])
        end)
        assert.is_false(ok)
        local place, text = message:match("^(.-):%d+: (.*)$")
        assert.equal("physics: draw(options): " .. row[3], text)
        assert.truthy(place:find("draw_spec.lua", 1, true))
      end)
    end

    it("being called outside of LÖVE", function()
      rawset(_G, "love", nil)
      local ok, message = pcall(function()
        draw({ objects = {} })
      end)
      assert.is_false(ok)
      assert.truthy(message:find("draw needs love.graphics", 1, true))
      assert.truthy(message:find("draw_spec.lua", 1, true))
    end)
  end)
end)
