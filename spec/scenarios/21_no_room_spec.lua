--- More boxes than there is room for, or all at one spot. Whatever the game does to them: no step
--- moves one farther than its speed and the stated parting explain, none gets past what does not
--- give way, what has room is apart within a second, and what nothing drives is at rest within two.

local effort = require("spec.support.effort")
local motion = require("spec.support.motion")
local newRandom = require("spec.support.random").new
local overlap = require("spec.support.overlap")
local scene = require("spec.support.scene")
local small = require("spec.support.small")

local APART, REST, REST_OF_MANY = 1, 2, 3 -- s
local STILL = 0.5 -- s, how long nothing may move

local LEVELS = {
  shift = { 0, 1 / 3 },
  order = { "forward", "shuffled" },
  push = { "both" },
  rate = { 60, 30, 144 },
  turn = { 0, 1 },
}

local function wall(x, y, width, height)
  return { "walls", small.tile(x, y, width, height) }
end

local function machine(name, x, y, width, height)
  return { "machines", small.put(x, y, width, height, { name = name, kinematic = true }) }
end

local function box(x, y, width, height)
  return { "boxes", small.put(x, y, width, height, { friction = 0.3 }) }
end

-- Adds the entries of a list to another.
local function join(list, more)
  for _, entry in ipairs(more) do
    list[#list + 1] = entry
  end
  return list
end

local function spot(count, x, y, width, height)
  local list = {}
  for i = 1, count do
    list[i] = box(x, y, width, height or width)
  end
  return list
end

-- Boxes of half to one and a half of a size at random places in a room.
local function scatter(count, seed, size, width, height)
  local random, list = newRandom(seed), {}
  for i = 1, count do
    local w, h = size * random:between(0.5, 1.5), size * random:between(0.5, 1.5)
    local x, y = random:between(0, width - w), random:between(0, height - h)
    list[i] = box(x, y, w, h)
  end
  return list
end

-- Boxes in cells of one size, from the floor up, clear of each other.
local function heap(count, seed, cell, width, bottom, isEqual)
  local random, list, columns = newRandom(seed), {}, math.floor(width / cell)
  for i = 0, count - 1 do
    local size = isEqual and 0.8 * cell or random:between(0.6, 1) * cell
    local row = math.floor(i / columns)
    local x, y = cell * (i - row * columns), bottom - cell * row - size
    list[i + 1] = box(x, y, size, size)
  end
  return list
end

local function walls(width, height)
  return {
    wall(-20, -20, 20, height + 40),
    wall(width, -20, 20, height + 40),
    wall(0, -20, width, 20),
    wall(0, height, width, 20),
  }
end

local function build(run, description)
  local named = run:build(description)
  return named, motion.new(run.world, run.all)
end

-- Fails unless nothing moves by a bit for half a second.
local function expectRest(run, watch)
  local before = {}
  for i, object in ipairs(run.all) do
    before[i] = { object.x, object.y }
    local isStill = object.static or object.kinematic or object.vx == 0 and object.vy == 0
    run:check(isStill, "an object goes on at %.9g, %.9g px/s", object.vx or 0, object.vy or 0)
  end
  scene.watch(run, watch, STILL)
  for i, object in ipairs(run.all) do
    local isSame = object.x == before[i][1] and object.y == before[i][2]
    local text = "an object at rest went from %.17g, %.17g to %.17g, %.17g"
    run:check(isSame, text, before[i][1], before[i][2], object.x, object.y)
  end
end

-- Boxes at one spot -------------------------------------------------------------------------------

local FLOOR = wall(-600, 100, 1200, 16)

local SPOTS = {
  { "20 in the open", { gravity = 0 }, spot(20, 0, 0, 8) },
  {
    "40 in a corner",
    { gravity = 0, wall(-2, -400, 2, 402), wall(0, 0, 400, 2) },
    spot(40, 0, -8, 8),
  },
  { "40 in a corner of a floor", { FLOOR, wall(-20, -300, 20, 400) }, spot(40, 0, 92, 8) },
  { "16 in a corridor of 64 px", { FLOOR, wall(-600, 20, 1200, 16) }, spot(16, 0, 60, 16) },
  { "16 in a corridor, on its floor", { FLOOR, wall(-600, 20, 1200, 16) }, spot(16, 0, 84, 16) },
  { "30 in a corridor of 20 px", { FLOOR, wall(-600, 64, 1200, 16) }, spot(30, 0, 85, 8) },
  { "30 under a ceiling of 4 px", { FLOOR, wall(-300, -104, 600, 4) }, spot(30, 0, -100, 8) },
  { "20 in a niche", { FLOOR, wall(-20, 0, 20, 100), wall(0, 40, 100, 8) }, spot(20, 0, 48, 8) },
  { "20 on a thin shelf", { FLOOR, wall(-100, 40, 200, 1) }, spot(20, 0, 32, 8) },
}

-- Closed rooms ------------------------------------------------------------------------------------

-- From so many on they may take longer at 30 Hz (docs/reliability.md).
local MANY = 30

-- Width, height, boxes, their size in px: less than the area of the room, or more. (Some are higher
-- than that of 14 px: they begin inside two walls at once.)
local ROOMS = {
  { 120, 120, 40, 12, 800 },
  { 120, 120, 40, 12, 0 },
  { 60, 60, 40, 12, 800 },
  { 60, 60, 40, 12, 0 },
  { 200, 14, 20, 14, 800 },
}

local MACHINES = {
  { "a piston", 6, "equal" },
  { "a piston", 20, "equal" },
  { "a piston", 20, "different" },
  { "a piston", 40, "different" },
  { "two walls", 30, "different" },
  { "a press from above", 20, "different" },
  { "a lift under a ceiling", 20, "equal" },
  { "a lift under a ceiling", 20, "different" },
}

-- Where each machine starts in a room of 120 x 120 px, and how far it goes for each px of the way.
local WAYS = {
  ["a piston"] = { { 0, 0, 1, 0 } },
  ["a press from above"] = { { 0, 0, 0, 1 } },
  ["a lift under a ceiling"] = { { 0, 0, 0, -1 } },
  ["two walls"] = { { 0, 0, 0.5, 0 }, { 0, 0, -0.5, 0 } },
}

local ROOM, SPEED = 120, 60 -- px, px/s

-- A machine of 200 px that closes the side from which it comes.
local function machineFor(name, i, way)
  local dx, dy = way[3], way[4]
  if dx ~= 0 then
    return machine(name .. i, dx > 0 and -200 or ROOM, 0, 200, ROOM)
  end
  return machine(name .. i, 0, dy > 0 and -200 or ROOM, ROOM, 200)
end

local function wallsFor(name)
  local list = { wall(-300, -20, ROOM + 600, 20), wall(-300, ROOM, ROOM + 600, 20) }
  if name ~= "a piston" and name ~= "two walls" then
    list = { wall(-20, -300, 20, ROOM + 600), wall(ROOM, -300, 20, ROOM + 600) }
  end
  if name == "a piston" then
    list[#list + 1] = wall(ROOM, 0, 20, ROOM)
  elseif name == "a press from above" then
    list[#list + 1] = wall(0, ROOM, ROOM, 20)
  elseif name == "a lift under a ceiling" then
    list[#list + 1] = wall(0, -20, ROOM, 20)
  end
  return list
end

describe("x and y: boxes at one spot", function()
  local title = "come apart within a second and rest within two: {1}"
  small.rows(title, effort.rows(SPOTS, 2), function(_, there, boxes)
    scene.each(LEVELS, function(run)
      local description = join({ gravity = there.gravity }, there)
      local _, watch = build(run, join(description, boxes))
      scene.watch(run, watch, APART)
      overlap.expectApart(run)
      scene.watch(run, watch, REST)
      overlap.expectApart(run)
      expectRest(run, watch)
    end)
  end)

  it("come apart when they are flung, three times over", function()
    scene.each(LEVELS, function(run)
      local _, watch = build(run, walls(300, 200))
      local random = newRandom(8)
      for fling = 1, 3 do
        for _ = 1, 20 do
          local vx, vy = random:between(-400, 400), random:between(-400, 100)
          local piece = { x = 146, y = 96, width = 8, height = 8, vx = vx, vy = vy, friction = 0.4 }
          run.all[#run.all + 1] = run:add("boxes", piece).raw
        end
        scene.watch(run, watch, fling < 3 and 0.5 or 3.5)
      end
      overlap.expectApart(run)
      expectRest(run, watch)
    end)
  end)
end)

describe("x, y and width: a closed room", function()
  local title = "of {1} x {2} px with {3} boxes of about {4} px, gravity {5}, keeps them in"
  small.rows(title, effort.rows(ROOMS, 2), function(width, height, count, size, gravity)
    scene.each(LEVELS, function(run)
      local description = join({ gravity = gravity }, walls(width, height))
      local _, watch = build(run, join(description, scatter(count, 3, size, width, height)))
      scene.watch(run, watch, count < MANY and REST or REST_OF_MANY)
      expectRest(run, watch)
    end)
  end)
end)

it("add: a heap takes a crate a step into its middle, and rests 1.5 s later, all apart", function()
  scene.each(LEVELS, function(run)
    local description =
      { wall(-20, -600, 20, 800), wall(120, -600, 20, 800), wall(0, 200, 120, 16) }
    local _, watch = build(run, join(description, heap(70, 4, 12, 120, 200)))
    local random, added = newRandom(6), 0
    scene.watch(run, watch, 0.5, function()
      if added < 15 then
        added = added + 1
        local crate = box(random:between(0, 108), random:between(120, 188), 12, 12)
        run.all[#run.all + 1] = run:add("boxes", crate[2]).raw
      end
    end)
    scene.watch(run, watch, 1.5)
    overlap.expectApart(run, 0.2) -- ten of 12 px fill a row exactly
    scene.watch(run, watch, 1)
    expectRest(run, watch)
  end)
end)

small.rows("kinematic: a machine keeps in: {1}, {2} #slow", MACHINES, function(name, count, sizes)
  scene.each(LEVELS, function(run)
    local cell = math.floor(ROOM / math.ceil(math.sqrt(count)))
    local description = join({}, wallsFor(name))
    for i, way in ipairs(WAYS[name]) do
      description[#description + 1] = machineFor("machine", i, way)
    end
    local boxes = heap(count, 5, cell, ROOM, ROOM, sizes == "equal")
    local named, watch = build(run, join(description, boxes))
    local crushed = 0
    run.world.onCrush = function()
      crushed = crushed + 1
    end
    local function drive(speed)
      for i, way in ipairs(WAYS[name]) do
        named["machine" .. i].vx, named["machine" .. i].vy = speed * way[3], speed * way[4]
      end
    end
    drive(SPEED)
    scene.watch(run, watch, 1.5) -- 30 px are left of 120
    drive(0)
    run:check(crushed > 0, "nothing was crushed")
    scene.watch(run, watch, count < MANY and REST or REST_OF_MANY)
    expectRest(run, watch)
    drive(-SPEED)
    scene.watch(run, watch, 1.5)
    drive(0)
    scene.watch(run, watch, 3 * APART)
    overlap.expectApart(run)
    scene.watch(run, watch, 1)
    expectRest(run, watch)
  end)
end)
