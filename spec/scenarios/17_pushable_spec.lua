--- `pushable = false`: others cannot push it, walls still stop it.

local newRandom = require("spec.support.random").new
local overlap = require("spec.support.overlap")
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE, SOME = variants.EVERYWHERE, variants.SOME
local SQUEEZED = { turn = variants.TURNS, shift = { 0 }, push = { "both" } }
local row = play.with({ expectApart = overlap.expectApart })
local solid = scene.maker("tiles", { static = true })
local machine = scene.maker("walls", { kinematic = true })
local FLOOR, WALL = solid("floor", -500, 116, 1500, 32), solid("wall", 200, 0, 16, 116)

--- A box of 16 px; U, V, and what has an f in its name, cannot be pushed.
local function box(name, x, y, fields)
  local entry = scene.maker("boxes", fields or {})(name, x, y, 16, 16)
  entry[2].pushable = not name:find("[UVf]")
  return entry
end

describe("pushable = false", function()
  --   +-+ ->  +-+         U and V cannot be pushed, P, Q and R can; K is kinematic
  --   +-+     |U|
  --   ------------
  -- `objects`: name, x, vx, mass.
  local function onFloor(v)
    local list = { FLOOR }
    for name, x, vx, mass in v.objects:gmatch("(%u) (%S+) (%S+) (%S+)") do
      local fields = { vx = tonumber(vx), mass = tonumber(mass), kinematic = name == "K" or nil }
      list[#list + 1] = box(name, tonumber(x), 100, fields)
    end
    list[#list + 1] = v.isWalled and WALL or nil
    return list
  end
  local NAMES = "what, objects, keep, seconds, ends"
  local PLAY = { { time = "seconds", keep = "{keep}" }, "{ends}" }

  row("{what}", EVERYWHERE, onFloor, PLAY, {
    NAMES,
    { "stops a box", "P 20 0 1 U 80 0 1", "P.vx = 100", 1, "P at 64, 100; U at 80, 100" },
    { "stops 1000 px/s", "P 20 0 1 U 80 0 1", "P.vx = 1000", 1, "P at 64, 100; U at 80, 100" },
    { "stops 50 kg", "P 20 0 50 U 80 0 1", "P.vx = 6000", 1, "P at 64, 100; U at 80, 100" },
    { "pushes 1 kg", "U 20 100 1 P 80 0 1", "", 2, "U at 220, 100; P at 236, 100; P.vx ~ 100" },
    { "pushes 99 kg", "U 20 100 1 P 80 0 99", "", 2, "U at 220, 100; P at 236, 100; U.vx ~ 100" },
    { "is moved by a kinematic one", "U 46 0 1 K 0 60 1", "", 1, "U at 76, 100; U.vx ~ 60" },
    { "meets another", "U 0 100 1 V 100 -100 10", "", 2, "U at 42, 100; V at 58, 100; U still" },
    { "meets a slow one", "U 0 100 1 V 100 -50 10", "", 2, "U at 56, 100; V at 72, 100; V still" },
    { "meets a fast one", "U 0 10 1 V 100 -200 10", "", 2, "U at 4, 100; V at 20, 100; U still" },
    { "presses to another", "U 0 100 1 P 50 0 1 V 100 0 1", "", 2, "U at 68, 100; P at 84, 100" },
    { "meets one that stands", "U 0 100 1 V 100 0 1", "", 2, "U at 84, 100; V at 100, 100" },
    { "stands, and is met", "U 0 0 1 V 100 -100 10", "", 2, "U at 0, 100; V at 16, 100; V still" },
    { "meets at 6000 px/s", "U 0 6000 1 V 100 -6000 9", "", 2, "U at 42, 100; V at 58, 100" },
    { "follows a slow one", "U 0 100 1 V 100 40 1", "", 2, "U at 164, 100; V.x ~ 180; U.vx ~ 40" },
    { "is followed", "V 0 -40 1 U 100 -100 1", "", 2, "V at -80, 100; U at -64, 100; U.vx ~ -40" },
  })

  row("{what}", EVERYWHERE, onFloor, PLAY, {
    NAMES .. ", isWalled",
    { "is stopped by a wall", "U 20 300 1", "", 1, "U at 184, 100; U still", true },
    {
      "is stopped by what it pushes to a wall",
      "U 20 0 1 P 70 0 1 Q 90 0 1 R 110 0 1",
      "U.vx = 100",
      2,
      "U at 136, 100; P at 152, 100; Q at 168, 100; R at 184, 100; U.vx ~ 0",
      true,
    },
  })

  local BALL = { FLOOR, box("P", 14, 100, { vx = 100, restitution = 1 }), box("U", 80, 100) }
  row("a box bounces off it", SOME, BALL, {
    { 1, "P at 14 + min(100 * t, 100 - 100 * t), 100", "U at 80, 100" },
  })

  local PRESS =
    { FLOOR, machine("L", 60, 52, 16, 64), machine("R", 124, 52, 16, 64), box("U", 92, 100) }
  row("is crushed between two walls that move, once", SOME, PRESS, {
    "listen U; L.vx, R.vx = 20, -20",
    { 1, "U at 92, 100" },
    "heard.U.crushes == 1",
  })

  --   +-+-+-+-+   +-+
  --   |U|P|Q|..   |V|
  --   +-+-+-+-+   +-+
  local function between(v)
    local list = { gravity = 0, box("U", 0, 0) }
    for i = 1, v.count do
      list[i + 1] = box("P" .. i, (16 + v.gap) * i, 0)
    end
    list[v.count + 2] = box("V", (16 + v.gap) * (v.count + 1), 0)
    return list
  end
  row("{count} boxes, {gap} px apart, stop {left} and {right} px/s #slow", SOME, between, {
    "u, v = U.x, V.x",
    {
      1,
      keep = "U.vx, V.vx = left, right",
      "P1.x - U.x >= 16 - 1e-6",
      "P2.x - P1.x >= 16 - 1e-6",
      "V.x - run.named['P' .. count].x >= 16 - 1e-6",
    },
    "V.x - U.x ~ 16 * (count + 1); (left == 0 and U.x or u) ~ u",
    "(right == 0 and V.x or v) ~ v",
  }, {
    "count, gap, left, right",
    { 2, 0, 150, 0 },
    { 2, 0, 0, -150 },
    { 2, 1, 150, 0 },
    { 3, 0.5, 60, 0 },
    { 4, 5, 600, 0 },
    { 2, 5, 100, -100 },
    { 3, 0, 60, -60 },
  })

  --     +-+
  --     |U|
  --    +-+-
  --    | |
  --   ------
  local stacks = { "stack" }
  for n, stack in ipairs({ "f", "bf", "fff", "bfb", "fbf", "bbf", "fbfbf" }) do -- from the floor up
    stacks[n + 1] = { stack }
  end
  row("a stack {stack} is dropped, and rests", EVERYWHERE, function(v)
    local description = { FLOOR }
    for i = 1, #v.stack do
      description[i + 1] = box(v.stack:sub(i, i) .. i, 90 + 2 * i, 112 - 20 * i)
    end
    return description
  end, {
    1,
    function(run, it)
      for _ in run:steps(0.5) do
        local lower = it.floor
        for i = 1, #it.stack do
          local view = it[it.stack:sub(i, i) .. i]
          run:at(view, 90 + 2 * i, 116 - 16 * i)
          run:still(view)
          run:flush(view, lower, "bottom")
          lower = view
        end
      end
    end,
  }, stacks)

  local UNDER = { FLOOR, box("P", 20, 100), box("low", 80, 100), box("U", 84, 84) }
  row("a box is pushed out from under one", SOME, UNDER, {
    { 1, keep = "P.vx = 100" }, -- P passes below it, too
    { 1, keep = "P.vx = 100", "U.x ~ 84" },
    "U at 84, 100; low.x ~ P.x + 16",
  })

  local LIFT = { machine("lift", 80, 100, 64, 8), box("U", 92, 84), box("V", 94, 68) }
  row("one is carried by a lift and jumps like any other", SOME, LIFT, {
    1 / 6,
    "lift.vx, lift.vy = 60, -90",
    { 1, "U at 92 + 60 * t, 84 - 90 * t", "V at 94 + 60 * t, 68 - 90 * t", "U still", "V still" },
    { "V.vy = -200", 1, "U at 212, -96; V at 214, -112; V still" },
  })

  --      |A| v
  --      |B| ^
  --   =========== ^  lift
  local function bounced()
    local lift = machine("lift", 60, 141, 60, 8, { vy = -60 })
    local a, b =
      box("fA", 80, 113, { vy = 266 }), box("fB", 81, 125, { vy = 157, restitution = 0.4 })
    a[2].height, b[2].height = 10, 15
    return { lift, a, b }
  end
  row("one that bounces off a lift against a falling one is not held in the lift", SOME, bounced, {
    { 1, "fB.y + 15 <= lift.y + 1e-6", "fA.y + 10 <= fB.y + 1e-6" },
    "run:support(fA) == fB; run:support(fB) == lift; fA still",
  })

  row("can be switched while it runs", SOME, { FLOOR, box("P", 20, 100), box("U", 80, 100) }, {
    { 1, keep = "P.vx = 100" },
    "U at 80, 100; U.pushable = nil",
    { 1, keep = "P.vx = 100" },
    { "U.x > 100; U.pushable, U.vx = false, 0", 1 / 6, "x = U.x" },
    { 1, keep = "P.vx = 100" },
    "U.x ~ x",
  })

  -- In a passage of 16 px, with 8 px of room for P between U and V.
  row("leaves no room to P, which passes the one of {width} px", SQUEEZED, function(v)
    local one, other = box("U", 24 - v.width, 100), box("V", 32, 100)
    one[2].width = v.width
    return { gravity = 0, FLOOR, solid("roof", -500, 84, 1500, 16), one, other, box("P", 20, 100) }
  end, { 1, "P at x, 100" }, { "width, x", { 28, 48 }, { 6, 2 } })
end)

--   +--------+
--   |  boss  |
--   |     +-+|
--   |     |P||     P: a player in its foot
--   ----------
-- The boss was lifted onto the player's head, or not: the first of the two groups decided.
describe("pushable = false: a boss and what is inside it", function()
  local FEW = { shift = { 0, 1 / 3 }, order = { "forward", "backward" }, rate = { 60, 30 } }
  local movable, player = scene.maker("bodies"), scene.maker("players")
  local GROUND = solid("floor", -500, 300, 1500, 16)
  local BOSS = movable("boss", 200, 236, 80, 64, { pushable = false, mass = 100 })

  local PARTED = { { 1, "boss at 200, 236" }, "expectApart(run)" }

  scene.it("part, and the player alone moves, wherever in its foot it is", FEW, function(run)
    for at = -13, 79 do
      local named = run:build({ GROUND, BOSS, player("player", 200 + at, 276, 14, 24) })
      for _ in run:steps(1) do
        run:at(named.boss, 200, 236)
      end
      overlap.expectApart(run)
      local it_ = named.player
      run:near("the player's y", it_.y, 276)
      run:check(it_.x <= 186.01 or it_.x >= 279.99, "from %d it came to x = %.9g", at, it_.x)
    end
  end)

  row(
    "part, and a player of {width} x {height}, mass {mass}, moves",
    FEW,
    function(v)
      return { GROUND, BOSS, player("player", v.x, v.y, v.width, v.height, { mass = v.mass }) }
    end,
    PARTED,
    {
      "x, y, width, height, mass",
      { 230, 280, 20, 20, 1 },
      { 230, 280, 20, 20, 1000 },
      { 190, 292, 8, 8, 1 },
      { 260, 200, 60, 100, 5 },
      { 210, 226, 14, 24, 1 }, -- at its head: upwards
      { 100, 260, 200, 40, 1 }, -- wider than the boss
    }
  )

  row("part, of ten that are all inside it, and each other", FEW, function()
    local random, list = newRandom(3), { GROUND, BOSS }
    for i = 1, 10 do
      list[i + 2] = player(nil, random:between(200, 266), 276, 14, 24)
    end
    return list
  end, PARTED)

  local OTHER = movable("other", 260, 236, 80, 64, { pushable = false, mass = 100 })
  row("part from a boss", FEW, { GROUND, BOSS, OTHER }, { 1, "expectApart(run); boss.x < other.x" })
end)
