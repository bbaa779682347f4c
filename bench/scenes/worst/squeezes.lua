--- Walls that come nearer, boxes that grow, and more boxes than there is room for.
---
---   |-> + + + <-|    |-> + + + |    |   + +   |    |-> + + +
---   |-> + + + <-|    |-> + + + |    |+ + + + +|    |-> + + +
---   +-----------+    +---------+    +---------+    +------------
---    shrink           piston        overfull        bulldozer

local newRandom = require("spec.support.random").new
local shared = require("bench.scenes.worst.shared")

local FAR = shared.FAR
local CELL = 15 -- px, of the largest crate
local SIZE = 12.2 -- px, of a crate in the mean: the square has the mean area

-- Adds something that the game moves; returns its number.
local function addMachine(objects, x, y, width, height)
  objects[#objects + 1] = {
    group = "machines",
    x = x,
    y = y,
    width = width,
    height = height,
    kinematic = true,
    friction = shared.FRICTION,
  }
  return #objects
end

local BIN_WIDTH = 200 -- px

-- Two thirds of the crates are there; the others come one a frame, at a place in the full heap.
local function overfull(count)
  local objects, random = {}, newRandom(3)
  local width, first = BIN_WIDTH, math.floor(count * 2 / 3)
  local tall = SIZE * SIZE * first / width
  shared.addWall(objects, -16, -4000, 16, 4016)
  shared.addWall(objects, width, -4000, 16, 4016)
  shared.addWall(objects, 0, 0, width, 16)
  shared.addHeap(objects, first, width, 0, CELL)
  local added = {}
  for _ = first + 1, count do
    local x, y = random:between(0, width - SIZE), random:between(-tall, -SIZE)
    shared.addCrate(added, x, y, SIZE)
  end
  local function frame(world, step)
    if added[step] then
      world:add(added[step])
    end
    world:step(1 / 60)
  end
  return shared.finish({
    objects = objects,
    driven = count - first,
    room = { 0, -FAR, width, 0 },
    frame = frame,
  })
end

-- The height of a room for n crates, and the width that they would fill without a gap.
local function roomFor(count)
  local height = SIZE * math.ceil(math.sqrt(count))
  return height, SIZE * SIZE * count / height
end

local WIDE, NARROW = 2.2, 0.8 -- of the width that the crates need: before, and at the end

-- Two walls come nearer until a fifth of the crates has no room.
local function shrink(count)
  local objects, speed = {}, 45 -- px/s, each wall
  local height, need = roomFor(count)
  local width = WIDE * need
  local closing = math.floor((WIDE - NARROW) * need / (2 * speed / 60))
  shared.addWall(objects, -500, height, width + 1000, 16)
  shared.addWall(objects, -500, -16, width + 1000, 16)
  local left = addMachine(objects, -200, 0, 200, height)
  local right = addMachine(objects, width, 0, 200, height)
  shared.addHeap(objects, count, width, height, CELL)
  local function frame(world, step)
    local isClosing = step <= closing
    world:setVelocity(left, isClosing and speed or 0, 0)
    world:setVelocity(right, isClosing and -speed or 0, 0)
    world:step(1 / 60)
  end
  return shared.finish({
    objects = objects,
    driven = closing + 1,
    needs = { "upright", "kinematic" },
    room = function(world)
      return world:read(left) + 200, 0, (world:read(right)), height
    end,
    frame = frame,
  })
end

local SPACE, SMALL, LARGE, SWELL = 24, 8, 26, 0.125 -- px; the last a frame

-- Balloons in a room that holds them until they are 24 px wide; they grow to 26.
local function balloons(count)
  local objects = {}
  local columns = math.ceil(math.sqrt(count))
  local width, height = SPACE * columns, SPACE * math.ceil(count / columns)
  local growing = (LARGE - SMALL) / SWELL
  shared.addRoom(objects, width, height)
  local first = #objects + 1
  for i = 0, count - 1 do
    local row = math.floor(i / columns)
    local x, y = SPACE * (i - row * columns) + SPACE / 3, SPACE * row + SPACE / 3
    shared.addCrate(objects, x, y, SMALL)
  end
  local function frame(world, step)
    if step <= growing then
      local size = SMALL + SWELL * step
      for i = first, #objects do
        world:setSize(i, size, size)
      end
    end
    world:step(1 / 60)
  end
  return shared.finish({
    gravity = 0,
    objects = objects,
    driven = growing,
    needs = { "upright", "sizes" },
    room = { 0, 0, width, height },
    frame = frame,
  })
end

-- A piston presses the crates against the end of its cylinder, and stays.
local function piston(count)
  local objects, speed = {}, 90 -- px/s
  local height, need = roomFor(count)
  local width = WIDE * need
  local pressing = math.floor((WIDE - NARROW) * need / (speed / 60))
  shared.addWall(objects, -500, height, width + 516, 16)
  shared.addWall(objects, -500, -16, width + 516, 16)
  shared.addWall(objects, width, 0, 16, height)
  local plate = addMachine(objects, -200, 0, 200, height)
  shared.addHeap(objects, count, width, height, CELL)
  local function frame(world, step)
    world:setVelocity(plate, step <= pressing and speed or 0, 0)
    world:step(1 / 60)
  end
  return shared.finish({
    objects = objects,
    driven = pressing + 1,
    needs = { "upright", "kinematic" },
    room = function(world)
      return world:read(plate) + 200, 0, width, height
    end,
    frame = frame,
  })
end

local STAY, DOWN = 60, 120 -- frames

-- A lift presses them against a ceiling, stays for a second and goes down again.
local function lift(count)
  local objects, speed = {}, 90 -- px/s
  local width, need = roomFor(count)
  local height = WIDE * need
  local pressing = math.floor((WIDE - NARROW) * need / (speed / 60))
  shared.addWall(objects, -16, -16, 16, height + 500)
  shared.addWall(objects, width, -16, 16, height + 500)
  shared.addWall(objects, 0, -16, width, 16)
  local car = addMachine(objects, 0, height, width, 100)
  shared.addHeap(objects, count, width, height, CELL)
  local function speedAt(step)
    if step <= pressing then
      return -speed
    end
    local isDown = step > pressing + STAY and step <= pressing + STAY + DOWN
    return isDown and speed / 2 or 0
  end
  local function frame(world, step)
    world:setVelocity(car, 0, speedAt(step))
    world:step(1 / 60)
  end
  return shared.finish({
    objects = objects,
    driven = pressing + STAY + DOWN + 1,
    needs = { "upright", "kinematic" },
    room = function(world)
      local _, y = world:read(car)
      return 0, 0, width, y
    end,
    frame = frame,
  })
end

-- A blade pushes a heap of crates along a floor, for four seconds.
local function bulldozer(count)
  local objects, speed, pushing = {}, 100, 240 -- px/s, frames
  local rows = math.ceil(math.sqrt(count / 2))
  shared.addWall(objects, -1000, 0, 5000, 16)
  local blade = addMachine(objects, -60, -120, 16, 120)
  shared.addHeap(objects, count, CELL * math.ceil(count / rows), 0, CELL)
  local function frame(world, step)
    world:setVelocity(blade, step <= pushing and speed or 0, 0)
    world:step(1 / 60)
  end
  return shared.finish({
    objects = objects,
    driven = pushing + 1,
    needs = { "upright", "kinematic" },
    room = { -FAR, -FAR, FAR, 0 },
    frame = frame,
  })
end

local PULLS = { { 0, 800 }, { 800, 0 }, { 0, -800 }, { -800, 0 } } -- px/s²
local TURN, TURNS = 20, 16 -- frames; the last turn is down again

-- Gravity turns every 20 frames; the crates fall through the room in a block.
local function turning(count)
  local objects, cell = {}, 12 -- px
  local side = cell * math.ceil(1.4 * math.sqrt(count))
  shared.addRoom(objects, side, side)
  shared.addHeap(objects, count, side, side, cell)
  local function frame(world, step)
    local number = math.min(math.floor((step - 1) / TURN), TURNS)
    local pull = PULLS[number - 4 * math.floor(number / 4) + 1]
    world:setGravity(pull[1], pull[2])
    world:step(1 / 60)
  end
  return shared.finish({
    objects = objects,
    driven = TURN * TURNS + 1,
    needs = { "upright", "gravity" },
    room = { 0, 0, side, side },
    frame = frame,
  })
end

local SIZES = { 10, 80, 250 }

local function definition(name, title, build, sizes)
  return {
    name = name,
    title = title,
    sizes = sizes,
    growth = shared.GROWTH,
    quick = 10,
    build = build,
  }
end

return {
  definition("overfull", "one crate a frame into a full heap, n in the end", overfull, { 300 }),
  definition("shrink", "a room that shrinks around n crates", shrink, { 200 }),
  definition("balloons", "n balloons grow in a room", balloons, { 100 }),
  definition("piston", "a piston presses n crates", piston, SIZES),
  definition("lift", "a lift presses n crates, and goes down", lift, SIZES),
  definition("bulldozer", "a bulldozer before n crates", bulldozer, SIZES),
  definition("turning", "gravity turns every 20 frames, n crates", turning, { 250 }),
}
