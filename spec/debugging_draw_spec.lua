--- world:draw: what is drawn where, with each option, and that nothing else changes.

local physics = require("physics")
local small = require("spec.support.small")

local unpack = table.unpack or unpack -- luacheck: ignore (Lua 5.1 has it as a global)

-- Stands in for love.graphics: keeps the state that has to be restored and writes every call down.
local function newRecorder()
  local state = { Color = { 0.1, 0.2, 0.3, 0.4 }, LineWidth = { 5 }, Font = { "the caller's" } }
  local graphics, calls, depth = {}, {}, 0
  for what in pairs(state) do
    graphics["get" .. what] = function()
      return unpack(state[what])
    end
    graphics["set" .. what] = function(...)
      state[what] = { ... }
    end
  end
  local font = {
    getWidth = function()
      return 40
    end,
    getHeight = function()
      return 9
    end,
  }
  function graphics.newFont()
    return font
  end
  function graphics.push()
    depth = depth + 1
  end
  function graphics.pop()
    depth = depth - 1
  end
  function graphics.depth()
    return depth
  end
  for _, name in ipairs({ "rectangle", "circle", "polygon", "print", "origin" }) do
    graphics[name] = function(...)
      local now = { name = name, color = state.Color, depth = depth, font = state.Font[1], ... }
      calls[#calls + 1] = now
    end
  end
  return graphics, calls
end

-- What was drawn, in order: "x y width height" of rectangles, "fill x y width height radius" of
-- round ones, "polygon fill x y …" of others; " @0.4" behind what is not opaque.
local function shapes(calls)
  local found = {}
  for n, call in ipairs(calls) do
    local isRound, isPlain = call[6] ~= nil, call.name == "rectangle"
    local text = isPlain and { isRound and call[1] or nil } or { call.name, call[1] }
    for i = 2, #call do
      text[#text + 1] = ("%g"):format(call[i])
    end
    text[#text + 1] = (call.color[4] or 1) < 1 and "@" .. call.color[4] or nil
    found[n] = table.concat(text, " ")
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
    physics.load()
  end)

  local function drawn(objects, options)
    physics.objects = objects
    physics.draw(options)
    return calls
  end

  local SIDES = { top = false, bottom = false, left = false, right = false }
  local WHOLE, INNER = "10 20 16 16", "11 21 14 14"
  local BOTH, FAINT = WHOLE .. "|" .. INNER, WHOLE .. " @0.4|" .. INNER .. " @0.4"
  local RIM = "10 20 16 1|10 35 16 1|10 21 1 14|25 21 1 14"

  -- One object of 16 x 16 px at 10, 20 with these fields, options, and what is drawn.
  small.rows("draws {1}", {
    { "a box with a border", {}, nil, BOTH },
    { "more of a thin one than its border", { height = 2 }, nil, "10 20 16 2|10.5 20.5 15 1" },
    { "a circle", { radius = 8 }, nil, "fill 10 20 16 16 8|fill 11 21 14 14 7" },
    { "a round sensor", { radius = 8, sensor = true }, nil, "line 10 20 16 16 8" },
    { "a sensor as an outline", { sensor = true, static = true }, nil, RIM },
    { "outlines with fill = false", {}, { fill = false }, RIM },
    {
      "faintly and alone what is not active",
      { active = false, vx = 9, touching = { top = {} } },
      { velocity = true },
      WHOLE .. " @0.3|" .. INNER .. " @0.3",
    },
    { "as opaque as asked", {}, { alpha = 0.5 }, WHOLE .. " @0.5|" .. INNER .. " @0.5" },
    { "what touches at the top", { touching = "top" }, nil, BOTH .. "|10 20 16 2" },
    { "at the bottom", { touching = "bottom" }, nil, BOTH .. "|10 34 16 2" },
    { "on the left", { touching = "left" }, nil, BOTH .. "|10 20 2 16" },
    { "on the right", { touching = "right" }, nil, BOTH .. "|24 20 2 16" },
    { "no side if told so", { touching = "left" }, { touching = false }, BOTH },
    { "the solid side of a ledge", { oneWay = "top" }, nil, FAINT .. "|10 20 16 4" },
    { "of one that is so by true", { oneWay = true }, nil, FAINT .. "|10 20 16 4" },
    { "of a roof", { oneWay = "bottom" }, nil, FAINT .. "|10 32 16 4" },
    { "of a gate", { oneWay = "left" }, nil, FAINT .. "|10 20 4 16" },
    { "of another", { oneWay = "right" }, nil, FAINT .. "|22 20 4 16" },
    { "no such side if told so", { oneWay = "top" }, { oneWay = false }, BOTH },
    { "the slope right", { slope = "right" }, nil, "polygon fill 10 36 26 20 26 36" },
    { "the slope left", { slope = "left" }, nil, "polygon fill 26 36 10 20 10 36" },
    { "the slope topright", { slope = "topright" }, nil, "polygon fill 10 20 26 36 26 20" },
    { "the slope topleft", { slope = "topleft" }, nil, "polygon fill 26 20 10 36 10 20" },
    { "its outline", { slope = "left", sensor = true }, nil, "polygon line 26 36 10 20 10 36" },
    -- from the middle to where it is in 0.1 s: 2 px thick, and a square of 4 px at its end
    {
      "velocity if asked",
      { vx = 100 },
      { velocity = true },
      BOTH .. "|polygon fill 18 29 28 29 28 27 18 27|26 26 4 4",
    },
    { "none where there is none", {}, { velocity = true }, BOTH },
  }, function(_, fields, options, expected)
    local object = small.put(10, 20, 16, 16, fields)
    if SIDES[object.touching] == false then
      object.touching = { top = false, bottom = false, left = false, right = false }
      object.touching[fields.touching] = {}
    end
    object.static = fields.oneWay and true or object.static
    drawn({ boxes = { object } }, options)
    assert.equal(expected, table.concat(shapes(calls), "|"))
  end)

  it("draws the border darker, and what stands directly in objects", function()
    drawn({ player = box({ x = 10, y = 20 }) })
    assert.same({ WHOLE, INNER }, shapes(calls))
    assert.is_true(calls[1].color[1] < calls[2].color[1])
  end)

  it("draws numbers before strings, each in order, groups and members alike", function()
    local b = { [9] = box({ x = 4 }), [1] = box({ x = 3 }), a = box({ x = 5 }) }
    drawn({ zoo = { box({ x = 7 }) }, b = b, hero = box({ x = 6 }), [2] = { box({ x = 2 }) } })
    local order = {}
    for i = 1, #calls, 2 do
      order[#order + 1] = calls[i][2]
    end
    assert.same({ 2, 3, 4, 5, 6, 7 }, order)
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
    local world = physics.newWorld()
    world:add("boxes", box({}))
    world:add("tiles", box({ y = 16, static = true }))
    world:update(1 / 60)
    world:draw({ counters = true })
    local last = calls[#calls]
    assert.same({ "print", 1 }, { last.name, last.depth })
    assert.truthy(last[1]:find("^objects 2   movers 1   resting %d   pairs 1   contacts 1"))
    local isInWindow = false
    for _, call in ipairs(calls) do
      isInWindow = isInWindow or call.name == "origin" and call.depth == 1
    end
    assert.is_true(isInWindow)
  end)

  it("draws the cells of the grid that are in use when asked", function()
    local world = physics.newWorld({ cellSize = 64, broadphase = "grid" })
    world:add("tiles", box({ x = 70, y = 130, static = true }))
    world:update(1 / 60)
    world:draw({ grid = true })
    local found = shapes(calls)
    assert.same({ "64 128 64 1 @0.4", "64 191 64 1 @0.4" }, { found[1], found[2] })
  end)

  it("leaves the caller's colour, line width, font and transform as they were", function()
    local world = physics.newWorld()
    world:add("boxes", box({ vx = 1, oneWay = "left" }))
    world:update(1 / 60)
    world:draw({ velocity = true, names = true, counters = true, grid = true })
    assert.is_true(#calls > 8)
    assert.same({ 0.1, 0.2, 0.3, 0.4 }, { graphics.getColor() })
    assert.same({ 5, "the caller's" }, { graphics.getLineWidth(), graphics.getFont() })
    assert.equal(0, graphics.depth())
  end)

  local ALL = "the options are alpha, counters, fill, grid, names, oneWay, touching, velocity"
  small.rows("refuses: {2}", {
    { { filll = true }, 'unknown option "filll" (did you mean "fill"?); ' .. ALL },
    { { "fill" }, "unknown option 1; " .. ALL },
    { { fill = 1 }, "fill must be true or false, got 1" },
    { { alpha = 2 }, "alpha must be a number in 0..1, got 2" },
    { 7, "options must be a table, got 7" },
    { nil, "draw needs love.graphics" },
  }, function(options, words)
    if options == nil then
      rawset(_G, "love", nil)
    end
    small.refuses(words, physics.draw, options)
  end)
end)
