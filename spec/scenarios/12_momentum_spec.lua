--- Momentum is kept, energy never grows.

local effort = require("spec.support.effort")
local newRandom = require("spec.support.random").new
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local small = require("spec.support.small")
local variants = require("spec.support.variants")

local EVERYWHERE = variants.EVERYWHERE

--- Momentum along both axes and kinetic energy of the dynamic objects of a list.
local function sums(objects)
  local px, py, energy = 0, 0, 0
  for i = 1, #objects do
    local object = objects[i]
    if not object.static then
      local mass = object.mass or 1
      px, py = px + mass * object.vx, py + mass * object.vy
      energy = energy + mass * (object.vx * object.vx + object.vy * object.vy) / 2
    end
  end
  return px, py, energy
end

local wall = scene.maker("walls", { static = true, restitution = 1 })
local box = scene.maker("boxes", {})

--- Four walls around a room, each 50 px thick.
local function room(description, width, height)
  description[#description + 1] = wall(nil, -50, -50, 50, height + 100)
  description[#description + 1] = wall(nil, width, -50, 50, height + 100)
  description[#description + 1] = wall(nil, -50, -50, width + 100, 50)
  description[#description + 1] = wall(nil, -50, height, width + 100, 50)
  return description
end

--- `count` balls on a raster in a room of 800 × 600 px, with seeded speeds, sizes and masses.
local function balls(count, seed)
  local random = newRandom(seed)
  local description = room({ gravity = 0 }, 800, 600)
  for i = 0, count - 1 do
    local x, y = 39 * (i % 20) + random:between(10, 20), 58 * math.floor(i / 20)
    local fields = { vx = random:between(-200, 200), vy = random:between(-200, 200) }
    fields.mass, fields.restitution = random:between(0.5, 4.5), 1
    local width, height = random:between(6, 16), random:between(6, 16)
    description[#description + 1] = box(nil, x, y + random:between(10, 30), width, height, fields)
  end
  return description
end

describe("mass and restitution: momentum", function()
  --   +---+        +-+
  --   | 2 | 100 -> |1|
  --   +---+        +-+
  play.row("(12) is kept: {m} kg at {v}, {n} kg at {w}, restitution {e}", EVERYWHERE, function(v)
    local one = box("a", 0, 0, 16, 16, { vx = v.v, mass = v.m, restitution = v.e })
    return { gravity = 0, one, box("b", 40, 4, 16, 16, { vx = v.w, mass = v.n }) }
  end, {
    1,
    "a.vx ~ after; b.vx ~ otherAfter; a.vy == 0; b.vy == 0; m1 = 24 / (v - w)",
    -- with both, they meet at their moment and go on from there
    "a.x ~ run.push == 'both' and v * m1 + after * (1 - m1) or a.x",
    "b.x ~ run.push == 'both' and 40 + w * m1 + otherAfter * (1 - m1) or b.x",
  }, {
    "e, m, n, v, w, after, otherAfter",
    { 1, 2, 1, 100, 0, 100 / 3, 400 / 3 },
    { 0, 2, 1, 100, 0, 200 / 3, 200 / 3 },
    { 0.5, 2, 1, 100, 0, 50, 100 },
    { 1, 1, 1, 100, 0, 0, 100 },
    { 1, 1, 1000, 100, 0, 100 * (1 - 1000) / 1001, 200 / 1001 },
    { 1, 1000, 1, 100, 0, 100 * 999 / 1001, 200 * 1000 / 1001 },
    { 0, 1, 3, 100, -20, 10, 10 },
    { 1, 1, 3, 100, 20, -20, 60 },
  })

  --   +-+ -> +-++-++-++-+
  --   +-+    +-++-++-++-+   Newton's cradle: only the last one leaves
  local CRADLE = { gravity = 0, box("box1", -30, 0, 16, 16, { restitution = 1, vx = 120 }) }
  for i = 2, 5 do
    CRADLE[i] = box("box" .. i, 16 * i, 0, 16, 16, { restitution = 1 })
  end
  local BOTH = { push = { "both" }, rate = variants.RATES, turn = variants.TURNS }
  play.row("passes through a row of equal boxes", BOTH, CRADLE, {
    1,
    "box1.vx ~ 0; box2.vx ~ 0; box3.vx ~ 0; box4.vx ~ 0; box5.vx ~ 120",
    "box1 at 16, 0; box5 at 80 + 120 * (1 - 46 / 120), 0",
  })
end)

describe("restitution and push: a closed box of bouncing boxes", function()
  -- a minute is long: two variants, one of them on interpreters
  local PLAIN = { shift = { 0 }, order = { "forward" }, broadphase = { "grid" }, push = { "both" } }
  local OTHER = { shift = { 1 / 3 }, order = { "shuffled" } }
  OTHER.broadphase, OTHER.push = { "pairs" }, { "first" }
  for _, levels in ipairs(effort.isWhole and { PLAIN, OTHER } or { PLAIN }) do
    local name = "(12) keeps its energy for 20 s; momentum changes only at walls, push "
    scene.it(name .. levels.push[1] .. " #slow", levels, function(run)
      run:build(balls(200, 3))
      local walled
      run.world.onBegin = function(a, b)
        walled = walled or a.static or b.static
      end
      local px, py, before = sums(run.all)
      for _ in run:steps(20) do
        local nowX, nowY, energy = sums(run.all)
        if not walled then
          run:near("momentum along x", nowX, px, 1e-6)
          run:near("momentum along y", nowY, py, 1e-6)
        end
        px, py, walled = nowX, nowY, false
        run:near("energy", energy / before, 1, 0.01)
      end
      for _, object in ipairs(run.all) do
        if not object.static then
          local x, y = object.x - run.shift, object.y - run.shift
          run:check(x >= -1e-6 and x + object.width <= 800 + 1e-6, "left the room")
          run:check(y >= -1e-6 and y + object.height <= 600 + 1e-6, "left the room")
        end
      end
    end)
  end
end)

describe("restitution, friction and mass: energy does not come out of nowhere", function()
  --   +--+ 76
  --  +-------+ 0.001
  --  +-------+
  --  =====   +--+
  --  ledge   |  | 267, comes up
  --          +--+
  scene.it("when what is on a ledge is struck from below, and leaves it", EVERYWHERE, function(run)
    local named = run:build({
      scene.maker("tiles", { static = true })(nil, 0, 100, 50, 20),
      box("plank", 20, 84, 60, 16, { mass = 0.001, restitution = 0.4 }),
      box("weight", 25, 68, 16, 16, { mass = 76 }),
      box("hammer", 60, 110, 16, 16, { mass = 267, restitution = 0.5, vy = -147 }),
    })
    local function energy()
      local sum = 0
      for _, view in pairs({ named.plank, named.weight, named.hammer }) do
        sum = sum + (view.mass or 1) * (view.vy * view.vy / 2 + 800 * (200 - view.y))
      end
      return sum
    end
    local before = energy()
    for _ in run:steps(0.5) do
      local now = energy()
      run:check(now <= before * 1.001, "energy rose from %.9g to %.9g", before, now)
      run:check(named.weight.vy >= -147, "the weight flies up at %.6g px/s", named.weight.vy)
    end
  end)

  local gases = { boxes = 60, balls = 200 }
  small.each("nor goes anywhere among elastic {1} in a room", gases, function(name, count)
    local levels = { rate = { 60 }, order = { "forward" }, shift = { 0, 1 / 3 } }
    levels.rate = name == "boxes" and { 30, 60, "irregular" } or levels.rate
    scene.each(levels, function(run)
      local random, description = newRandom(1), room({ gravity = 0 }, 400, 400)
      local columns = math.ceil(math.sqrt(count))
      local spacing = 400 / columns
      for i = 0, count - 1 do
        local x = spacing * (i % columns) + random:between(0, spacing - 10)
        local y = spacing * math.floor(i / columns) + random:between(0, spacing - 10)
        local fields = { vx = random:between(-200, 200), vy = random:between(-200, 200) }
        fields.radius, fields.restitution = name == "balls" and 5 or nil, 1
        description[#description + 1] = box(nil, x, y, 10, 10, fields)
      end
      run:build(description)
      local _, _, first = sums(run.all)
      for _ in run:steps(effort.isWhole and 20 or 6) do
        local _, _, energy = sums(run.all)
        run:near("share of the energy", energy / first, 1, 1e-9)
      end
    end)
  end)
end)

-- Several reach a wall in one step, one behind the other.
local COLUMNS = { { 2, 0 }, { 5, 0 }, { 6, 0.4 }, { 12, 0.4 } }
small.rows("restitution: a column keeps its order: {1}, {2}", COLUMNS, function(count, restitution)
  local levels = { rate = { 30, 60, 144 }, shift = { 0 }, push = { "both" } }
  scene.each(levels, function(run)
    for height = 100, 500, effort.share(20, 100) do
      local description = { box("floor", -50, 0, 100, 20, { static = true }) }
      for i = 1, count do
        local y = -height - i * (8 + height % 3 + 1)
        local fields = { restitution = restitution }
        description[i + 1] = box("box" .. i, i % 2 * 2, y, 8, 8, fields)
      end
      local named = run:build(description)
      for _ in run:steps(1.5) do
        for i = 2, count do
          local gap = named["box" .. i - 1].y - named["box" .. i].y - 8
          run:check(gap > -0.05, "%d is %g px in the one below", i, -gap)
        end
      end
    end
  end)
end)

--   C ->>     B      A ->>>|    A hits the wall, B, and the wall again; B hits C before that
it("restitution: a box back from a wall meets in one step what comes its way", function()
  local levels = { rate = { 30 }, push = { "both" }, order = { "forward", "shuffled" } }
  scene.each(levels, function(run)
    local description = { gravity = 0, maxStep = 1 / 30, wall(nil, 100, 0, 20, 100) }
    local A, B, C = { vx = 3000, restitution = 1 }, { restitution = 1 }, { restitution = 1 }
    C.vx = 666
    description[#description + 1] = box("A", 80, 50, 10, 10, A)
    description[#description + 1] = box("B", 50, 50, 10, 10, B)
    description[#description + 1] = box("C", 20, 50, 10, 10, C)
    local named = run:build(description)
    run:step(1 / 30)
    run:near("x of A", named.A.x, 62.2, 1e-9)
    run:near("x of B", named.B.x, 50, 1e-9)
    run:near("x of C", named.C.x, -20, 1e-9)
  end)
end)

-- What settles in the last rounds of a step.
-- Steps a second, their speed, and px between them, the last up to the heavy one.
small.rows("restitution: ten of 0.9 that meet a heavier one stay apart: {2} px/s, {1} Hz", {
  { 30, 631, { 0, 0, 0, 0, 1.6, 0.1, 0, 0, 1.7, 11.1 } },
  { 60, 452, { 0, 0, 0.2, 0, 0, 0, 1.5, 0, 0.2, 6.9 } },
}, function(rate, speed, gaps)
  scene.each({ rate = { rate }, push = { "both" } }, function(run)
    local description, x = { gravity = 0 }, 0
    for i = 1, 10 do
      description[i] = box("box" .. i, x, 0, 20, 20, { vx = speed, restitution = 0.9 })
      x = x + 20 + gaps[i]
    end
    description[11] = box("box11", x, -10, 32, 40, { vx = -100, mass = 5 })
    local named = run:build(description)
    for _ in run:steps(1) do
      for i = 2, 11 do
        local gap = named["box" .. i].x - named["box" .. i - 1].x - 20
        run:check(gap > -0.05, "%d is %g px in the one before", i, -gap)
      end
    end
  end)
end)

it("restitution: a row of 20 of 0.4 that touch goes on as one when it is struck", function()
  scene.each({ rate = { 30, 60 }, push = { "both" } }, function(run)
    local description = { gravity = 0 }
    for i = 1, 21 do
      local fields = { vx = i == 1 and 1500 or 0, restitution = 0.4 }
      description[i] = box("box" .. i, i == 1 and -30 or 10 * i, 0, 10, 10, fields)
    end
    local named = run:build(description)
    run:step(1 / 30)
    run:step(1 / 30)
    for i = 1, 21 do
      run:near("vx", named["box" .. i].vx, 1500 / 21, 1e-9)
    end
  end)
end)

it("restitution and masks: shots that pass each other all bounce off a wall in one step", function()
  scene.each({ rate = { 30, 60 }, push = { "both" } }, function(run)
    local description = { gravity = 0, masks = { boxes = { boxes = false } } }
    description[1] = wall(nil, 1000, 0, 24, 800)
    for i = 1, 30 do
      local fields = { vx = 900, restitution = 1 }
      description[i + 1] = box("shot" .. i, 994 - i * 0.4, 12 * i, 6, 6, fields)
    end
    local named = run:build(description)
    run:step(1 / 30)
    for i = 1, 30 do
      run:near("vx", named["shot" .. i].vx, -900, 1e-9)
    end
  end)
end)
