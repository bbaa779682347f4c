--- Slopes in worlds at random, and what knows of them beside the step. What a step does with them is
--- in spec/scenarios/18_slopes_spec.lua.

local effort = require("spec.support.effort")
local newRandom = require("spec.support.random").new
local physics = require("physics")

local GRADIENTS = { { 1, 1 }, { 1, 2 }, { 1, 3 }, { 2, 1 }, { 3, 1 } }
local OFFSETS = { 0, 0.1, 1 / 3, -1000.1, 100000.3, 1234567.8, 9000000.7 }
local HEIGHT = 24

--- Hilly ground from (x, y) on: flats and slopes of one size of tile, with solid tiles below them.
--- Returns the objects, and the pieces of the surface: left, right, height on the left and right.
local function buildHills(random, x, y)
  local size, list, pieces = random:pick({ 8, 16, 32 }), {}, {}
  local function add(fields)
    fields.static = true
    list[#list + 1] = fields
  end
  for n = 1, 18 do
    local kind, gradient = random:integer(0, 2), random:pick(GRADIENTS)
    local width, height = size * gradient[2], size * gradient[1]
    if n <= 3 or n > 15 then
      kind = 0
    end
    if n == 1 or n == 18 then
      width = 800
    end
    if kind == 0 then
      add({ x = x, y = y, width = width, height = size })
      pieces[n] = { x, x + width, y, y }
    elseif kind == 1 then
      add({ x = x, y = y - height, width = width, height = height, slope = "right" })
      add({ x = x, y = y, width = width, height = size })
      pieces[n] = { x, x + width, y, y - height }
      y = y - height
    else
      add({ x = x, y = y, width = width, height = height, slope = "left" })
      add({ x = x, y = y + height, width = width, height = size })
      pieces[n] = { x, x + width, y, y + height }
      y = y + height
    end
    x = x + width
  end
  return list, pieces
end

--- The highest place of the surface below a box.
local function topBelow(pieces, x, width)
  local best = math.huge
  for _, piece in ipairs(pieces) do
    local left, right = math.max(x, piece[1]), math.min(x + width, piece[2])
    if right > left + 1e-6 then
      local slant = (piece[4] - piece[3]) / (piece[2] - piece[1])
      best =
        math.min(best, piece[3] + (left - piece[1]) * slant, piece[3] + (right - piece[1]) * slant)
    end
  end
  return best
end

--- One walk over hills. Returns what went wrong, or nil.
local function walkOnce(seed)
  local random = newRandom(seed)
  local x, y = random:pick(OFFSETS), random:pick(OFFSETS)
  local list, pieces = buildHills(random, x, y)
  local width = random:integer(6, 40)
  local speed = random:chance(0.2) and random:between(600, 3600) or random:between(40, 600)
  local way, rate = random:chance(0.5) and 1 or -1, random:pick({ 30, 60, 144, 240, 0 })
  local world = physics.newWorld({ gravity = 800, broadphase = random:pick({ "grid", "pairs" }) })
  for _, object in ipairs(list) do
    world:add("ground", object)
  end
  local first, last = pieces[1][1] + 200, pieces[#pieces][2] - 200
  local start = way > 0 and first + 500 or last - 500
  local body = { x = start, width = width, height = HEIGHT }
  body.y = topBelow(pieces, start, width) - HEIGHT
  world:add("players", body)
  local hit
  function body.onBegin(_, _, side)
    hit = hit or side ~= "bottom" and side
  end
  local time, steps = 0, 0
  while body.x > first and body.x < last do
    local dt = rate == 0 and random:between(0.002, 1 / 30) or 1 / rate
    body.vx = way * speed
    world:update(dt)
    time, steps = time + dt, steps + 1
    local off = body.y - (topBelow(pieces, body.x, width) - HEIGHT)
    -- What is added up at 9 million px is rounded to 2e-9 px in every step, on a flat floor, too.
    local rounding = 1e-6 + steps * 2e-9 * math.abs(body.x) / 9e6
    if hit or body.vx ~= way * speed then
      return ("seed %d: hit on its %s, vx %g"):format(seed, tostring(hit), body.vx)
    elseif math.abs(off) > 1e-9 * (1 + math.abs(body.y)) or body.vy ~= 0 then
      return ("seed %d: %g px off the ground, vy %g"):format(seed, off, body.vy)
    elseif not body.touching.bottom then
      return ("seed %d: on nothing"):format(seed)
    elseif math.abs(body.x - start - way * speed * time) > rounding then
      return ("seed %d: %g px off its way"):format(seed, body.x - start - way * speed * time)
    end
  end
end

describe("slopes", function()
  local function walk(first, last)
    local failures = {}
    for seed = first, last do
      failures[#failures + 1] = walkOnce(seed)
    end
    assert.same({}, failures)
  end

  it("bear walks over hills: no hit, no hop, no loss", function()
    walk(1, effort.isWhole and 150 or 20)
  end)

  it("bear 1000 of them #slow", function()
    walk(151, 150 + effort.share(850))
  end)

  it("lead a walker to one place at all rates", function()
    for seed = 1, 40 do
      local places = {}
      for _, rate in ipairs({ 30, 60, 144, 240, 0 }) do
        local random = newRandom(seed)
        local list, pieces = buildHills(random, 0, 0)
        local world = physics.newWorld({ gravity = 800 })
        for _, object in ipairs(list) do
          world:add("ground", object)
        end
        local width, speed = random:integer(6, 40), random:between(20, 80)
        local body =
          { x = pieces[1][2] - 50, width = width, height = HEIGHT, constantSpeed = seed % 2 == 0 }
        body.y = topBelow(pieces, body.x, width) - HEIGHT
        world:add("players", body)
        local left = 1.5
        while left > 0 do
          local dt = rate == 0 and math.min(left, random:between(0.002, 1 / 30)) or 1 / rate
          dt = left < 1e-9 and left or dt
          body.vx = speed
          world:update(dt)
          left = left - dt
          left = left < 1e-9 and 0 or left
        end
        places[#places + 1] = body
      end
      for n = 2, #places do
        assert.near(places[1].x, places[n].x, 1e-6)
        assert.near(places[1].y, places[n].y, 1e-6)
      end
    end
  end)
end)
