local draw = require("physics.world.draw").draw

local unpack = table.unpack or unpack -- luacheck: ignore (Lua 5.1 has it as a global)

-- Stands in for love.graphics: keeps the state that has to be restored and writes every call down.
local function newRecorder()
  local color, lineWidth, font, depth = { 0.1, 0.2, 0.3, 0.4 }, 5, "the caller's", 0
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
  function graphics.getFont()
    return font
  end
  function graphics.setFont(other)
    font = other
  end
  function graphics.newFont(size)
    return {
      getWidth = function(_, text)
        return #text * size / 2
      end,
      getHeight = function()
        return size
      end,
    }
  end
  function graphics.push()
    depth = depth + 1
  end
  function graphics.pop()
    depth = depth - 1
  end
  for _, name in ipairs({ "rectangle", "circle", "polygon", "print", "origin" }) do
    graphics[name] = function(...)
      calls[#calls + 1] = { name = name, color = color, depth = depth, font = font, ... }
    end
  end
  function graphics.depth()
    return depth
  end
  return graphics, calls
end

-- The rectangles that were drawn, as "x y width height", in order.
local function rectangles(calls)
  local found = {}
  for _, call in ipairs(calls) do
    if call.name == "rectangle" then
      found[#found + 1] = ("%g %g %g %g"):format(unpack(call, 2, 5))
    end
  end
  return found
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

  it("draws circles as circles", function()
    local found = {}
    drawn({ coins = { box({ x = 10, y = 20, radius = 8, sensor = true }) } })
    drawn({ balls = { box({ x = 30, y = 20, radius = 8 }) } }, { touching = false })
    for n, call in ipairs(calls) do
      found[n] = ("%s %s %g %g %g"):format(call.name, unpack(call, 1, 4))
    end
    assert.are.same({ "circle line 18 28 8", "circle fill 38 28 8", "circle fill 38 28 7" }, found)
  end)

  local function colorOf(object, options)
    drawn({ boxes = { object } }, options)
    return calls[1].color
  end

  it("draws every object at its place, in its size, with a border", function()
    drawn({ boxes = { { x = 3, y = 4, width = 20, height = 10 } } })
    assert.same({ "3 4 20 10", "4 5 18 8" }, rectangles(calls))
    assert.is_true(calls[1].color[1] < calls[2].color[1])
  end)

  it("leaves of a thin object more than its border", function()
    drawn({ boxes = { { x = 3, y = 4, width = 20, height = 2 } } })
    assert.same({ "3 4 20 2", "3.5 4.5 19 1" }, rectangles(calls))
  end)

  it("draws objects that stand directly in objects", function()
    drawn({ player = { x = 3, y = 4, width = 20, height = 10 } })
    assert.equal("3 4 20 10", rectangles(calls)[1])
  end)

  it("draws numbers before strings, each in order, groups and members alike", function()
    local b = { [2] = box({ x = 4 }), [1] = box({ x = 3 }), a = box({ x = 5 }) }
    drawn({ zoo = { box({ x = 7 }) }, b = b, hero = box({ x = 6 }), [2] = { box({ x = 2 }) } })
    local order = {}
    for i = 1, #calls, 2 do
      order[#order + 1] = calls[i][2]
    end
    assert.same({ 2, 3, 4, 5, 6, 7 }, order)
  end)

  it("draws a list with a hole in order", function()
    drawn({
      b = { [0] = box({ x = 1 }), box({ x = 2 }), nil, box({ x = 3 }), [9] = box({ x = 4 }) },
    })
    local order = {}
    for i = 1, #calls, 2 do
      order[#order + 1] = calls[i][2]
    end
    assert.same({ 1, 2, 3, 4 }, order)
  end)

  local KINDS = {
    { static = true },
    { kinematic = true },
    { vx = 1 },
    { vx = 0, vy = 0 },
    { sensor = true },
    { static = true, oneWay = "top" },
  }

  local function fillOf(fields)
    graphics, calls = newRecorder()
    rawset(_G, "love", { graphics = graphics })
    drawn({ boxes = { box(fields) } })
    return calls[#calls].color
  end

  it("gives each kind a colour of its own", function()
    local seen = {}
    for _, fields in ipairs(KINDS) do
      local text = table.concat(fillOf(fields), " ")
      assert.is_nil(seen[text])
      seen[text] = true
    end
  end)

  -- Source: WCAG 2.1, relative luminance and contrast ratio; 3 is what it asks of graphics.
  it("has a contrast of 3 to both black and white", function()
    local function light(share)
      return share <= 0.03928 and share / 12.92 or ((share + 0.055) / 1.055) ^ 2.4
    end
    for _, fields in ipairs(KINDS) do
      local color = fillOf(fields)
      local luminance = 0.2126 * light(color[1])
        + 0.7152 * light(color[2])
        + 0.0722 * light(color[3])
      assert.is_true(1.05 / (luminance + 0.05) >= 3, "on white: " .. table.concat(color, " "))
      assert.is_true((luminance + 0.05) / 0.05 >= 3, "on black: " .. table.concat(color, " "))
    end
  end)

  it("outlines sensors inside of their box", function()
    drawn({ coins = { box({ x = 10, y = 20, sensor = true, static = true }) } })
    assert.same({ "10 20 16 1", "10 35 16 1", "10 21 1 14", "25 21 1 14" }, rectangles(calls))
  end)

  it("outlines everything with fill = false", function()
    drawn({ boxes = { box({ x = 10, y = 20 }) } }, { fill = false })
    assert.same({ "10 20 16 1", "10 35 16 1", "10 21 1 14", "25 21 1 14" }, rectangles(calls))
  end)

  it("draws inactive objects faintly, and without their sides and velocity", function()
    local touching = { top = false, bottom = {}, left = false, right = false }
    local object = box({ active = false, touching = touching, vx = 9 })
    local color = colorOf(object, { velocity = true })
    assert.equal(0.3, color[4])
    assert.equal(2, #calls)
  end)

  it("marks each side that touches at its edge", function()
    for _, row in ipairs({
      { "top", "10 20 16 2" },
      { "bottom", "10 34 16 2" },
      { "left", "10 20 2 16" },
      { "right", "24 20 2 16" },
    }) do
      graphics, calls = newRecorder()
      rawset(_G, "love", { graphics = graphics })
      local touching = { top = false, bottom = false, left = false, right = false }
      touching[row[1]] = {}
      drawn({ boxes = { box({ x = 10, y = 20, touching = touching }) } })
      assert.equal(3, #calls)
      assert.equal(row[2], rectangles(calls)[3])
    end
  end)

  it("marks no side with touching = false", function()
    local touching = { top = false, bottom = {}, left = false, right = false }
    drawn({ boxes = { box({ touching = touching }) } }, { touching = false })
    assert.equal(2, #calls)
  end)

  it("marks the solid side of one-way objects, the rest is faint", function()
    for _, row in ipairs({
      { "top", "10 20 16 4" },
      { "bottom", "10 32 16 4" },
      { "left", "10 20 4 16" },
      { "right", "22 20 4 16" },
    }) do
      graphics, calls = newRecorder()
      rawset(_G, "love", { graphics = graphics })
      drawn({ shelves = { box({ x = 10, y = 20, static = true, oneWay = row[1] }) } })
      assert.equal(row[2], rectangles(calls)[3])
      assert.equal(1, calls[3].color[4])
      assert.equal(0.4, calls[2].color[4])
    end
  end)

  it("draws slopes as triangles, filled, and sensors as outlines", function()
    for _, row in ipairs({
      { "right", "10 36 26 20 26 36" },
      { "left", "26 36 10 20 10 36" },
      { "topright", "10 20 26 36 26 20" },
      { "topleft", "26 20 10 36 10 20" },
    }) do
      for _, isSensor in ipairs({ false, true }) do
        graphics, calls = newRecorder()
        local mode, points
        function graphics.polygon(...)
          mode, points = ..., table.concat({ select(2, ...) }, " ")
        end
        rawset(_G, "love", { graphics = graphics })
        local fields = { x = 10, y = 20, static = true, slope = row[1], sensor = isSensor }
        drawn({ hills = { box(fields) } })
        assert.equal(row[2], points)
        assert.equal(isSensor and "line" or "fill", mode)
      end
    end
  end)

  it("draws one-way objects like others with oneWay = false", function()
    drawn({ shelves = { box({ static = true, oneWay = "top" }) } }, { oneWay = false })
    assert.equal(2, #calls)
    assert.equal(1, calls[2].color[4])
  end)

  -- 2 px thick, and a square of 4 px at its end
  it("draws velocities when asked, from the middle to where the object is in 0.1 s", function()
    local objects = { boxes = { box({ vx = 100 }), box({ static = true }), box({}) } }
    drawn(objects, { velocity = true })
    assert.equal(8, #calls)
    assert.equal("polygon", calls[3].name)
    assert.same({ 8, 9, 18, 9, 18, 7, 8, 7 }, { unpack(calls[3], 2, 9) })
    assert.equal("16 6 4 4", rectangles(calls)[3])
  end)

  it("writes group and key when asked, with a shadow", function()
    drawn({ boxes = { box({}) }, hero = box({}) }, { names = true })
    local words = {}
    for _, call in ipairs(calls) do
      if call.name == "print" then
        words[#words + 1] = call[1] .. " " .. call.color[1]
        assert.not_equal("the caller's", call.font)
      end
    end
    assert.same({ "boxes 1 0", "boxes 1 1", "hero 0", "hero 1" }, words)
  end)

  it("writes the counters into the corner of the window when asked", function()
    local physics = require("physics")
    local world = physics.newWorld()
    world:add("boxes", box({}))
    world:add("tiles", box({ y = 16, static = true }))
    world:update(1 / 60)
    world:draw({ counters = true })
    local last = calls[#calls]
    assert.equal("print", last.name)
    assert.equal(1, last.depth)
    assert.truthy(last[1]:find("^objects 2   movers 1   resting %d   pairs 1   contacts 1"))
    local isInWindow = false
    for _, call in ipairs(calls) do
      isInWindow = isInWindow or call.name == "origin" and call.depth == 1
    end
    assert.is_true(isInWindow)
  end)

  it("draws the cells of the grid that are in use when asked", function()
    local physics = require("physics")
    local world = physics.newWorld({ cellSize = 64, broadphase = "grid" })
    world:add("tiles", box({ x = 70, y = 130, static = true }))
    world:update(1 / 60)
    world:draw({ grid = true })
    local found = rectangles(calls)
    assert.same({ "64 128 64 1", "64 191 64 1" }, { found[1], found[2] })
  end)

  it("draws as opaque as asked", function()
    assert.equal(0.5, colorOf(box({}), { alpha = 0.5 })[4])
  end)

  it("leaves the caller's colour, line width, font and transform as they were", function()
    local world = require("physics").newWorld()
    world:add("boxes", box({ vx = 1, oneWay = "left" }))
    world:update(1 / 60)
    world:draw({ velocity = true, names = true, counters = true, grid = true })
    assert.is_true(#calls > 8)
    assert.same({ 0.1, 0.2, 0.3, 0.4 }, { graphics.getColor() })
    assert.equal(5, graphics.getLineWidth())
    assert.equal("the caller's", graphics.getFont())
    assert.equal(0, graphics.depth())
  end)

  it("leaves nothing to the garbage collector while it draws plain lists", function()
    local objects = { boxes = {} }
    for i = 1, 2000 do
      objects.boxes[i] = box({ x = i })
    end
    local function garbage()
      collectgarbage()
      collectgarbage("stop")
      local before = collectgarbage("count")
      for i = #calls, 1, -1 do
        calls[i] = nil
      end
      draw({ objects = objects })
      local used = collectgarbage("count") - before
      collectgarbage("restart")
      return used
    end
    for _, name in ipairs({ "rectangle", "setColor" }) do
      graphics[name] = function() end
    end
    local least = garbage()
    for _ = 1, 4 do -- the trace compiler may have made something of its own meanwhile
      least = math.min(least, garbage())
    end
    assert.is_true(least < 4, least .. " KB")
  end)

  it("changes no object", function()
    local object = { x = 3, y = 4, width = 20, height = 10 }
    drawn({ boxes = { object } }, { velocity = true, names = true })
    assert.same({ x = 3, y = 4, width = 20, height = 10 }, object)
  end)

  describe("refuses, blaming the caller:", function()
    local ALL = "the options are alpha, counters, fill, grid, names, oneWay, touching, velocity"
    for _, row in ipairs({
      {
        "an unknown option",
        { filll = true },
        'unknown option "filll" (did you mean "fill"?); ' .. ALL,
      },
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
