--- On a platform, a belt or a lift that goes at a constant speed everything happens as on a floor
--- that stands, seen from the carrier: pushing, riding, hitting, rubbing.
---
---       +-+ ->  +-+
---       |P|     | |
---   ------------------   -300, -46, -1, 1 or 100 px/s, either way or upwards and downwards

local effort = require("spec.support.effort")
local scene = require("spec.support.scene")

local SPEEDS = { -300, -46, -1, 1, 100 } -- px/s
local LEVELS = {
  shift = { 0, 1 / 3, 100000.3 },
  order = { "forward", "shuffled" },
  push = { "both" },
  rate = { 60, 30, 144 },
}
local SETTLE = 1 / 6 -- s, before the carrier starts
local FLOOR = 100 -- px, y of its upper side

local function box(name, x, y, fields)
  local object = { name = name, x = x, y = y, width = 16, height = 16 }
  for key, value in pairs(fields or {}) do
    object[key] = value
  end
  return { "boxes", object }
end

-- A wall that goes along with the carrier.
local function wall(name, x)
  local object = { name = name, x = x, y = FLOOR - 116, width = 16, height = 116 }
  return { "walls", object, isWall = true }
end

local P, B, C = box("P", 20, 84), box("B", 80, 84), box("C", 60, 68)

-- What happens on the carrier: its objects; fields that the game writes before the first step
-- (`first`) or speeds before each (`keep`), by name; for how long; and where objects are at the end
-- (px) and how fast (px/s) on a floor that stands.
local PLAYS = {
  { name = "one pushes another", P, B, keep = { P = 100 }, seconds = 2 },
  {
    name = "one pushes three",
    P,
    box("B", 60, 84),
    box("C", 80, 84),
    box("D", 100, 84),
    keep = { P = 100 },
    seconds = 2,
  },
  {
    name = "two that touch are pushed, written once",
    box("P", 0, 84),
    box("B", 16, 84),
    box("C", 32, 84),
    first = { P = { vx = 90 } },
    ends = { P = 30, B = 46, C = 62 },
  },
  {
    name = "one pushes three against a wall",
    P,
    B,
    box("C", 100, 84),
    box("D", 120, 84),
    wall("W", 200),
    keep = { P = 100 },
    seconds = 4,
    ends = { P = 136, B = 152, C = 168, D = 184 },
  },
  { name = "one pushes a stack", P, box("B", 60, 84), C, keep = { P = 100 }, seconds = 2 },
  {
    name = "one runs into what cannot be pushed",
    P,
    box("B", 80, 84, { pushable = false }),
    keep = { P = 100 },
    seconds = 2,
    ends = { P = 64, B = 80 },
  },
  {
    name = "an engine pushes",
    box("P", 20, 84, { maxSpeedX = 90 }),
    box("B", 36, 84),
    first = { P = { ax = 900 } },
    seconds = 2,
  },
  {
    name = "a man walks on a crate and steps down",
    P,
    box("B", 22, 68),
    first = { B = { vx = 30 } },
    without = { lift = "it falls: the lift comes to meet it" },
    late = 5,
  },
  {
    name = "one jumps forwards, one backwards",
    P,
    B,
    first = { P = { vx = -30, vy = -120 }, B = { vx = 30, vy = -120 } },
    ends = { P = -10, B = 110 },
    without = { lift = "the lift gives the jump its speed" },
  },
  {
    name = "mass 2 hits mass 1, restitution 1",
    box("P", 0, 84, { mass = 2, restitution = 1 }),
    box("B", 60, 84, { restitution = 1 }),
    first = { P = { vx = 100 } },
    speeds = { P = 100 / 3, B = 400 / 3 },
  },
  {
    name = "mass 2 hits mass 1, restitution 0",
    box("P", 0, 84, { mass = 2 }),
    box("B", 60, 84),
    first = { P = { vx = 100 } },
    speeds = { P = 200 / 3, B = 200 / 3 },
  },
  {
    name = "one slides and rubs until it stands",
    box("P", 0, 84, { friction = 0.5 }),
    friction = 0.5,
    first = { P = { vx = 200 } },
    ends = { P = 50 },
    speeds = { P = 0 },
  },
  {
    name = "one is pushed against friction",
    box("P", 0, 84),
    box("B", 40, 84, { friction = 0.4 }),
    friction = 0.4,
    keep = { P = 100 },
    late = 0.5,
  },
  {
    name = "a tower stands",
    box("P", 0, 84),
    box("B", 0, 68),
    box("C", 0, 52),
    box("D", 16, 84),
    ends = { P = 0, B = 0, C = 0, D = 16 },
    speeds = { P = 0, B = 0, C = 0, D = 0 },
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

-- The floor and what is on it, as entries of a scene; and the names of all that moves by itself.
local function entriesOf(play, isBelt)
  local floor = { name = "floor", x = -2000, y = FLOOR, width = 4000, height = 16 }
  floor.static, floor.kinematic, floor.friction = isBelt, not isBelt, play.friction
  local description, movers = { { "floors", floor } }, {}
  for _, entry in ipairs(play) do
    local object = {}
    for field, value in pairs(entry[2]) do
      object[field] = value
    end
    object.kinematic = entry.isWall
    description[#description + 1] = { entry[1], object }
    if not entry.isWall then
      movers[#movers + 1] = object
    end
  end
  return description, movers
end

-- Starts the carrier, and one step later what happens on it: a belt takes hold in its second step.
local function start(run, play, kind, speed, named)
  run:play(SETTLE)
  local speedX, speedY = CARRIERS[kind](named.floor, speed, run.world)
  for _, entry in ipairs(play) do
    if entry.isWall then
      named[entry[2].name].vx, named[entry[2].name].vy = speedX, speedY
    end
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
-- carrier stood; the views by name; and the movers.
local function travel(run, play, kind, speed)
  local description, movers = entriesOf(play, kind == "belt")
  local named = run:build(description)
  local speedX, speedY = start(run, play, kind, speed, named)
  local log, from = {}, {}
  for i, object in ipairs(movers) do
    local view = named[object.name]
    from[i] = { x = view.x - object.x, y = view.y - object.y }
  end
  local function write()
    for name, vx in pairs(play.keep or {}) do
      named[name].vx = vx
    end
  end
  for time in run:steps(play.seconds or 1, write) do
    local row = {}
    for i, object in ipairs(movers) do
      local view = named[object.name]
      row[i] = { x = view.x - from[i].x - speedX * time, y = view.y - from[i].y - speedY * time }
    end
    log[#log + 1] = row
  end
  return log, named, movers
end

local function expectEnd(run, play, log, named, movers)
  local last = log[#log]
  for i, object in ipairs(movers) do
    local name = object.name
    if play.ends and play.ends[name] then
      run:near("the end of " .. name, last[i].x, play.ends[name])
    end
    if play.speeds and play.speeds[name] then
      run:near("the speed of " .. name, named[name].vx, play.speeds[name])
    end
  end
end

-- `late`: friction of what is pushed counts the belt from the next step on; px by which that
-- differs from a floor.
local function compare(run, play, log, standing, movers)
  for step, row in ipairs(log) do
    for i, object in ipairs(movers) do
      run:near(
        ("step %d: %s.x"):format(step, object.name),
        row[i].x,
        standing[step][i].x,
        play.late
      )
      run:near(("step %d: %s.y"):format(step, object.name), row[i].y, standing[step][i].y)
    end
  end
end

local row = 0 -- of kind, play and speed
for _, kind in ipairs({ "platform", "belt", "lift" }) do
  describe("kinematic and surfaceSpeed: on a " .. kind, function()
    for _, play in ipairs(PLAYS) do
      local hasWall = false
      for _, entry in ipairs(play) do
        hasWall = hasWall or entry.isWall
      end
      -- The walls beside a belt stand: that is another thing than a wall beside a floor.
      local isLeftOut = hasWall and kind == "belt" or play.without and play.without[kind]
      for _, speed in ipairs(isLeftOut and {} or SPEEDS) do
        row = row + 1
        local define = it
        if not effort.plays(row, 2) then
          define = function() end
        end
        define(("of %g px/s it is as on a floor: %s"):format(speed, play.name), function()
          scene.each(LEVELS, function(run)
            local standing, floored, movers = travel(run, play, kind, 0)
            expectEnd(run, play, standing, floored, movers)
            local log, named = travel(run, play, kind, speed)
            compare(run, play, log, standing, movers)
            expectEnd(run, play, log, named, movers)
          end)
        end)
      end
    end
  end)
end
