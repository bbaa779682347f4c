--- Momentum is kept, energy never grows.

local effort = require("spec.support.effort")
local newRandom = require("spec.support.random").new
local overlap = require("spec.support.overlap")
local scene = require("spec.support.scene")
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

--- Four walls around a room, each 50 px thick.
local function room(description, width, height)
  local walls = {
    { -50, -50, 50, height + 100 },
    { width, -50, 50, height + 100 },
    { -50, -50, width + 100, 50 },
    { -50, height, width + 100, 50 },
  }
  for _, wall in ipairs(walls) do
    local x, y, w, h = wall[1], wall[2], wall[3], wall[4]
    local object = { x = x, y = y, width = w, height = h, static = true, restitution = 1 }
    description[#description + 1] = { "walls", object }
  end
  return description
end

--- `count` balls on a raster in a room of 800 × 600 px, with seeded speeds, sizes and masses.
local function balls(count, seed)
  local random = newRandom(seed)
  local description = room({ gravity = 0 }, 800, 600)
  for i = 0, count - 1 do
    local column, row = i % 20, math.floor(i / 20)
    description[#description + 1] = {
      "balls",
      {
        x = 10 + 39 * column + random:between(0, 10),
        y = 10 + 58 * row + random:between(0, 20),
        width = random:between(6, 16),
        height = random:between(6, 16),
        vx = random:between(-200, 200),
        vy = random:between(-200, 200),
        mass = random:between(0.5, 4.5),
        restitution = 1,
      },
    }
  end
  return description
end

describe("momentum", function()
  --   +---+        +-+
  --   | 2 | 100 -> |1|
  --   +---+        +-+
  for _, row in ipairs({
    -- restitution, masses, speeds before, speeds after
    { 1, 2, 1, 100, 0, 100 / 3, 400 / 3 },
    { 0, 2, 1, 100, 0, 200 / 3, 200 / 3 },
    { 0.5, 2, 1, 100, 0, 50, 100 },
    { 1, 1, 1, 100, 0, 0, 100 },
    { 1, 1, 1000, 100, 0, 100 * (1 - 1000) / 1001, 200 / 1001 },
    { 1, 1000, 1, 100, 0, 100 * 999 / 1001, 200 * 1000 / 1001 },
    { 0, 1, 3, 100, -20, 10, 10 },
    { 1, 1, 3, 100, 20, -20, 60 },
  }) do
    local restitution, massA, massB, beforeA, beforeB = row[1], row[2], row[3], row[4], row[5]
    local name = "(12) is kept, m %g at %g px/s into m %g at %g px/s, restitution %g"
    scene.it(name:format(massA, beforeA, massB, beforeB, restitution), EVERYWHERE, function(run)
      local a = { name = "a", x = 0, y = 0, width = 16, height = 16, vx = beforeA, mass = massA }
      local b = { name = "b", x = 40, y = 4, width = 16, height = 16, vx = beforeB, mass = massB }
      a.restitution = restitution
      local named = run:build({ gravity = 0, { "boxes", a }, { "boxes", b } })
      run:play(1)
      run:near("vx of a", named.a.vx, row[6])
      run:near("vx of b", named.b.vx, row[7])
      run:same("vy of a", named.a.vy, 0)
      run:same("vy of b", named.b.vy, 0)
      if run.push == "both" then
        -- both meet at their moment and go on from there
        local moment = 24 / (beforeA - beforeB)
        run:near("x of a", named.a.x, beforeA * moment + row[6] * (1 - moment))
        run:near("x of b", named.b.x, 40 + beforeB * moment + row[7] * (1 - moment))
      end
    end)
  end

  --   +-+ -> +-++-++-++-+
  --   +-+    +-++-++-++-+   Newton's cradle: only the last one leaves
  scene.it(
    "passes through a row of equal boxes",
    { push = { "both" }, rate = variants.RATES, turn = variants.TURNS },
    function(run)
      local description = { gravity = 0 }
      for i = 1, 5 do
        local x = i == 1 and -30 or 16 * i
        local box = { name = "box" .. i, x = x, y = 0, width = 16, height = 16, restitution = 1 }
        box.vx = i == 1 and 120 or 0
        description[i] = { "boxes", box }
      end
      local named = run:build(description)
      run:play(1)
      for i = 1, 4 do
        run:near("vx of box " .. i, named["box" .. i].vx, 0)
      end
      run:near("vx of box 5", named.box5.vx, 120)
      run:at(named.box1, 16, 0)
      run:at(named.box5, 80 + 120 * (1 - 46 / 120), 0)
    end
  )
end)

describe("a closed box of bouncing boxes", function()
  -- a minute is long: two variants, one of them on interpreters
  local PLAIN = { shift = { 0 }, order = { "forward" }, broadphase = { "grid" }, push = { "both" } }
  local OTHER = { shift = { 1 / 3 }, order = { "shuffled" } }
  OTHER.broadphase, OTHER.push = { "pairs" }, { "first" }
  for _, levels in ipairs(effort.isWhole and { PLAIN, OTHER } or { PLAIN }) do
    local name = "(12) keeps its energy for 60 s; momentum changes only at walls, push "
    scene.it(name .. levels.push[1] .. " #slow", levels, function(run)
      run:build(balls(200, 3))
      local walled
      run.world.onBegin = function(a, b)
        walled = walled or a.static or b.static
      end
      local px, py, before = sums(run.all)
      for _ in run:steps(60) do
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

  it("keeps its energy for 5 s however it is played", function()
    local levels = { rate = { 30, 60, "irregular" }, shift = { 0, 1 / 3, 100000.3 } }
    scene.each(levels, function(run)
      run:build(balls(60, 5))
      local _, _, before = sums(run.all)
      for _ in run:steps(5) do
        local _, _, energy = sums(run.all)
        run:near("energy", energy / before, 1, 1e-9)
      end
    end)
  end)

  it("loses energy, never gains any, with restitution below 1", function()
    local levels = { rate = { 30, 60, "irregular" }, shift = { 0, 1 / 3, 100000.3 } }
    scene.each(levels, function(run)
      local description = balls(60, 9)
      for i, entry in ipairs(description) do
        entry[2].restitution = entry[2].restitution and (i % 4) / 4
        entry[2].friction = (i % 3) / 4
      end
      run:build(description)
      local _, _, last = sums(run.all)
      for _ in run:steps(5) do
        local _, _, energy = sums(run.all)
        run:check(energy <= last * (1 + 1e-9), "energy rose from %.9g to %.9g", last, energy)
        last = energy
      end
    end)
  end)
end)

-- px. A step makes an end of what meets more often than its rounds allow, and such boxes go up to
-- 100 px in one: for a step they overlap, by less than the size of the smaller one (up to 20 px).
local KNOT = 16

describe("energy does not come out of nowhere", function()
  --   +--+ 76
  --  +-------+ 0.001
  --  +-------+
  --  =====   +--+
  --  ledge   |  | 267, comes up
  --          +--+
  scene.it(
    "when what stands on a ledge is struck from below: the ledge holds it no longer",
    EVERYWHERE,
    function(run)
      local plank = { name = "plank", x = 20, y = 84, width = 60, height = 16, mass = 0.001 }
      local weight = { name = "weight", x = 25, y = 68, width = 16, height = 16, mass = 76 }
      local hammer = { name = "hammer", x = 60, y = 110, width = 16, height = 16, mass = 267 }
      plank.restitution, hammer.restitution, hammer.vy = 0.4, 0.5, -147
      local named = run:build({
        { "tiles", { x = 0, y = 100, width = 50, height = 20, static = true } },
        { "boxes", plank },
        { "boxes", weight },
        { "boxes", hammer },
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
    end
  )

  --   -----------
  --     +--+ ^ 159         the small ones are caught between the ceiling and the heavy one
  --   +------+ v 51
  --     +--+
  --     |  | ^ 41, 400 kg
  scene.it(
    "when light ones are caught between a wall and a heavy one",
    { push = variants.PUSHES, turn = variants.TURNS },
    function(run)
      local small = { x = 167.826183, y = 0.217328199, width = 19.2367295, height = 7.71337164 }
      local wide = { x = 152.410369, y = 7.94959824, width = 16.986005, height = 19.7865252 }
      local heavy = { x = 157.990531, y = 28.4320278, width = 5.92333902, height = 9.55899454 }
      small.vy, wide.vy, heavy.vy = -158.709786, 51.285704, -40.6316575
      small.mass, wide.mass, heavy.mass = 0.00177732552, 0.00122605493, 399.777177
      small.restitution, wide.restitution, heavy.restitution = 0.639, 0.931066534, 0.625845893
      run:build({
        gravity = 0,
        { "walls", { x = -50, y = -50, width = 300, height = 50, static = true } },
        { "boxes", small },
        { "boxes", wide },
        { "boxes", heavy },
      })
      local _, _, last = sums(run.all)
      for _ in run:steps(1) do
        local _, _, energy = sums(run.all)
        run:check(energy <= last * (1 + 1e-9), "energy rose from %.9g to %.9g", last, energy)
        last = energy
      end
    end
  )

  pending(
    "and no two overlap for more than 10 steps there: up to 16, one pair in a hundred rooms more"
  )

  it("in a room of 40 boxes of very different mass, at up to 3000 px/s", function()
    local levels = { push = variants.PUSHES, rate = { 30, 60, 144 }, order = { "forward" } }
    levels.shift = { 0, 0.1 }
    scene.each(levels, function(run)
      for seed = 1, 3 do
        local random, description = newRandom(seed), room({ gravity = 0 }, 200, 200)
        for i = 0, 39 do
          description[#description + 1] = {
            "balls",
            {
              x = 25 * (i % 8) + random:between(0, 4),
              y = 25 * math.floor(i / 8) + random:between(0, 4),
              width = random:between(4, 20),
              height = random:between(4, 20),
              vx = random:between(-3000, 3000),
              vy = random:between(-3000, 3000),
              mass = random:pick({ 0.001, 0.03, 1, 30, 1000 }),
              restitution = random:pick({ 0, 0.25, 0.5, 1 }),
              friction = random:pick({ 0, 0, 0.5 }),
            },
          }
        end
        run:build(description)
        local deepest = overlap.checker(run.all)
        local _, _, last = sums(run.all)
        for _ in run:steps(1) do
          local _, _, energy = sums(run.all)
          local rose = "seed %d: energy rose from %.9g to %.9g"
          run:check(energy <= last * (1 + 1e-9), rose, seed, last, energy)
          last = energy
          local depth = deepest()
          run:check(depth <= KNOT, "seed %d: overlap of %.3g px", seed, depth)
        end
      end
    end)
  end)

  for _, row in ipairs({ { "boxes", 60, 10 }, { "balls", 200, 10 } }) do
    it(
      ("nor goes anywhere among %d elastic %s in a room, in a minute"):format(row[2], row[1]),
      function()
        scene.each({ rate = { 60 }, order = { "forward" } }, function(run)
          local random, description = newRandom(1), room({ gravity = 0 }, 400, 400)
          local columns = math.ceil(math.sqrt(row[2]))
          local spacing = 400 / columns
          for i = 0, row[2] - 1 do
            description[#description + 1] = {
              "balls",
              {
                x = spacing * (i % columns) + random:between(0, spacing - row[3]),
                y = spacing * math.floor(i / columns) + random:between(0, spacing - row[3]),
                width = row[3],
                height = row[3],
                radius = row[1] == "balls" and row[3] / 2 or nil,
                vx = random:between(-200, 200),
                vy = random:between(-200, 200),
                restitution = 1,
              },
            }
          end
          run:build(description)
          local _, _, first = sums(run.all)
          for _ in run:steps(effort.isWhole and 60 or 6) do
            local _, _, energy = sums(run.all)
            local share = energy / first
            run:check(share < 1.001 and share > 0.999, "energy is %.9g of the first", share)
          end
        end)
      end
    )
  end
end)
