--- On a platform, a belt or a lift that goes at a constant speed everything happens as on a floor
--- that stands, seen from the carrier: pushing, riding, hitting, rubbing.
---
---       +-+ ->  +-+
---       |P|     | |
---   ------------------   -300, -46, -1, 1 or 100 px/s, either way or upwards and downwards

local effort = require("spec.support.effort")
local scene = require("spec.support.scene")

-- LuaJIT of 2022 may lose entries of a table when it compiles a loop over `pairs`, as in `start`.
local jit = rawget(_G, "jit")
if jit then
  jit.off(true, true)
end

local SPEEDS = { -300, -46, -1, 1, 100 } -- px/s
local LEVELS = {
  shift = { 0, 1 / 3, 100000.3 },
  order = { "forward", "shuffled" },
  push = { "both" },
  rate = { 60, 30, 144 },
}
local SETTLE = 1 / 6 -- s, before the carrier starts
local FLOOR = 100 -- px, y of its upper side

local function box(name, x, fields, y)
  return scene.maker("boxes", fields or {})(name, x, y or 84, 16, 16)
end

-- A wall that goes along with the carrier.
local WALL = scene.maker("walls", {})("W", 200, FLOOR - 116, 16, 116)
WALL.isWall = true

local P, B, FIRM = box("P", 20), box("B", 80), { pushable = false }
local RUNS, JUMP_BACK, JUMP = { P = { vx = 100 } }, { vx = -30, vy = -120 }, { vx = 30, vy = -120 }
local BOUNCY, HEAVY = { restitution = 1 }, { mass = 2, restitution = 1 }
local FLUSH = { P = 136, B = 152, C = 168, D = 184 }
local STANDS = { P = 0, B = 0, C = 0, D = 0 }

-- What happens on the carrier: its objects; fields that the game writes before the first step
-- (`first`) or speeds before each (`keep`), by name; for how long; and where objects are at the end
-- (px) and how fast (px/s) on a floor that stands.
local PLAYS = {
  { name = "one pushes another", P, B, keep = { P = 100 }, seconds = 2 },
  { name = "one pushes three", P, box("B", 60), box("C", 80), box("D", 100), keep = { P = 100 } },
  {
    name = "two that touch are pushed, written once",
    box("P", 0),
    box("B", 16),
    box("C", 32),
    first = { P = { vx = 90 } },
    ends = { P = 30, B = 46, C = 62 },
  },
  {
    name = "one pushes three against a wall",
    P,
    B,
    box("C", 100),
    box("D", 120),
    WALL,
    keep = { P = 100 },
    seconds = 4,
    ends = FLUSH,
  },
  { name = "one pushes a stack", P, box("B", 60), box("C", 60, {}, 68), keep = { P = 100 } },
  {
    name = "one runs into what cannot be pushed",
    P,
    box("B", 80, FIRM),
    keep = { P = 100 },
    seconds = 2,
    ends = { P = 64, B = 80 },
  },
  {
    name = "an engine pushes",
    box("P", 20, { maxSpeedX = 90 }),
    box("B", 36),
    first = { P = { ax = 900 } },
    seconds = 2,
  },
  {
    name = "a man walks on a crate and steps down",
    P,
    box("B", 22, {}, 68),
    first = { B = { vx = 30 } },
    without = { lift = "it falls: the lift comes to meet it" },
    late = 5,
  },
  {
    name = "one jumps forwards, one backwards",
    P,
    B,
    first = { P = JUMP_BACK, B = JUMP },
    ends = { P = -10, B = 110 },
    without = { lift = "the lift gives the jump its speed" },
  },
  {
    name = "mass 2 hits mass 1, restitution 1",
    box("P", 0, HEAVY),
    box("B", 60, BOUNCY),
    first = RUNS,
    speeds = { P = 100 / 3, B = 400 / 3 },
  },
  {
    name = "mass 2 hits mass 1, restitution 0",
    box("P", 0, { mass = 2 }),
    box("B", 60),
    first = RUNS,
    speeds = { P = 200 / 3, B = 200 / 3 },
  },
  {
    name = "one slides and rubs until it stands",
    box("P", 0, { friction = 0.5 }),
    friction = 0.5,
    first = { P = { vx = 200 } },
    ends = { P = 50 },
    speeds = { P = 0 },
  },
  {
    name = "one is pushed against friction",
    box("P", 0),
    box("B", 40, { friction = 0.4 }),
    friction = 0.4,
    keep = { P = 100 },
    late = 0.5,
  },
  {
    name = "a tower stands",
    box("P", 0),
    box("B", 0, {}, 68),
    box("C", 0, {}, 52),
    box("D", 16),
    ends = { P = 0, B = 0, C = 0, D = 16 },
    speeds = STANDS,
  },
}

local CARRIERS = {
  platform = function(floor, speed)
    floor.vx = speed
    return speed, 0
  end,
  lift = function(floor, speed)
    floor.vy = speed
    return 0, speed
  end,
  belt = function(floor, speed, world)
    floor.raw.surfaceSpeed = speed
    world:refresh(floor.raw)
    return speed, 0
  end,
}

-- The scene: the floor and what is on it.
local function entriesOf(play, isBelt)
  local floor = { static = isBelt, kinematic = not isBelt, friction = play.friction }
  local description = { scene.maker("floors", floor)("floor", -2000, FLOOR, 4000, 16) }
  for n, entry in ipairs(play) do
    description[n + 1] = scene.thing(entry[1], entry[2])({ kinematic = entry.isWall })
  end
  return description
end

-- Starts the carrier, and one step later what happens on it: a belt takes hold in its second step.
local function start(run, play, kind, speed, named)
  run:play(SETTLE)
  local speedX, speedY = CARRIERS[kind](named.floor, speed, run.world)
  if named.W then
    named.W.vx, named.W.vy = speedX, speedY
  end
  run:step(1 / run.rate)
  for name, fields in pairs(play.first or {}) do
    for field, value in pairs(fields) do
      named[name][field] = value
    end
  end
  return speedX, speedY
end

-- Plays one of PLAYS on a carrier. Returns the places of all movers after each step, as if the
-- carrier stood: lists of x, y, x, y …, in their order.
local function travel(run, play, kind, speed)
  local named, log, views, from = run:build(entriesOf(play, kind == "belt")), {}, {}, {}
  local speedX, speedY = start(run, play, kind, speed, named)
  for _, entry in ipairs(play) do
    if not entry.isWall then
      local view = named[entry[2].name]
      views[#views + 1] = view
      from[view] = { view.x - entry[2].x, view.y - entry[2].y }
    end
  end
  local function write()
    for name, vx in pairs(play.keep or {}) do
      named[name].vx = vx
    end
  end
  for time in run:steps(play.seconds or 1, write) do
    local row = {}
    for i, view in ipairs(views) do
      row[2 * i - 1] = view.x - from[view][1] - speedX * time
      row[2 * i] = view.y - from[view][2] - speedY * time
    end
    log[#log + 1] = row
  end
  for i, view in ipairs(views) do
    if play.ends then
      run:near("the end of " .. view.name, log[#log][2 * i - 1], play.ends[view.name])
    end
    if play.speeds then
      run:near("the speed of " .. view.name, view.vx, play.speeds[view.name])
    end
  end
  return log
end

-- `late`: friction of what is pushed counts the belt from the next step on; px by which that
-- differs from a floor.
local function compare(run, play, log, standing)
  for step, row in ipairs(log) do
    for i, value in ipairs(row) do
      local late = i % 2 == 1 and play.late or nil
      run:near(("step %d: number %d"):format(step, i), value, standing[step][i], late)
    end
  end
end

local row = 0 -- of kind, play and speed
for _, kind in ipairs({ "platform", "belt", "lift" }) do
  describe("kinematic and surfaceSpeed: on a " .. kind, function()
    for _, play in ipairs(PLAYS) do
      -- The walls beside a belt stand: that is another thing than a wall beside a floor.
      local isLeftOut = play[5] and kind == "belt" or play.without and play.without[kind]
      for _, speed in ipairs(isLeftOut and {} or SPEEDS) do
        row = row + 1
        local define = it
        if not effort.plays(row, 2) then
          define = function() end
        end
        define(("of %g px/s it is as on a floor: %s"):format(speed, play.name), function()
          scene.each(LEVELS, function(run)
            local standing = travel(run, play, kind, 0)
            compare(run, play, travel(run, play, kind, speed), standing)
          end)
        end)
      end
    end
  end)
end
