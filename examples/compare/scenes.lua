-- What is compared: scenes of few objects, played at 60 steps a second with the same inputs in each
-- engine, and a number for each. A scene has
--
--   name, title, unit     what it is, and what its number counts
--   seconds               how long it is played
--   gravity, objects      as for the engines of bench/ (see bench/engines.lua)
--   push                  what a game writes in each frame: push(play, frame)
--   look                  notes something after each step: look(play, frame)
--   number                the result, from what was noted; a text is shown as it is
--   isTimed               the number is a time: the table shows it beside that of love.physics
--   soft                  groups that may overlap, for physics.lua
--   cures                 how users play it: { engine = { title =, and what differs } }
--   prepare               changes love.physics' world before the first step: prepare(play)
--
-- A play is { world =, engine =, objects =, notes = }.

local scenes = {}

local DT = 1 / 60 -- s

local function tiles(list, y, count, size)
  for i = 0, count - 1 do
    list[#list + 1] =
      { group = "tiles", x = size * i, y = y, width = size, height = size, static = true }
  end
  return list
end

local function box(x, y, size, more)
  local object = { group = "boxes", x = x, y = y, width = size, height = size }
  for key, value in pairs(more or {}) do
    object[key] = value
  end
  return object
end

-- Puts a single line in the place of the tiles of love.physics, from the first to the last.
local function layChain(play)
  local bodies, objects = play.world.bodies, play.objects
  local first, last = objects[2], objects[#objects]
  for i = 2, #objects do
    bodies[i]:setActive(false)
  end
  local body = love.physics.newBody(play.world.world, 0, 0, "static")
  local right = last.x + last.width
  local shape = love.physics.newChainShape(false, first.x, first.y, right, first.y)
  love.physics.newFixture(body, shape):setFriction(0)
end

local function seams()
  local objects = tiles({ box(4, 182, 14) }, 200, 40, 12)
  return {
    name = "seams",
    title = "a box runs over a row of tiles at 170 px/s",
    unit = "frames at less than half speed, of 150",
    cures = {
      love = {
        { title = "one chain shape", prepare = layChain },
        { title = "round feet", objects = tiles({ box(4, 182, 14, { radius = 7 }) }, 200, 40, 12) },
      },
    },
    seconds = 2.5,
    gravity = 1200,
    objects = objects,
    push = function(play)
      play.world:setVelocity(1, 170)
    end,
    look = function(play, frame)
      local x = play.world:read(1)
      if frame > 12 and x - play.notes.x < 0.5 * 170 * DT then
        play.notes.snags = (play.notes.snags or 0) + 1
      end
      play.notes.x = x
    end,
    number = function(play)
      return play.notes.snags or 0
    end,
  }
end

local function stack()
  local objects = tiles({}, 200, 20, 24)
  local first = #objects
  for i = 1, 8 do
    objects[#objects + 1] = box(220, 200 - 22 * i, 22, { friction = 0.5 })
  end
  return {
    name = "stack",
    title = "eight boxes stand for ten seconds",
    unit = "px that the highest one is off its place",
    seconds = 10,
    gravity = 1200,
    objects = objects,
    number = function(play)
      local _, y = play.world:read(first + 8)
      local off = math.abs(y - (200 - 22 * 8))
      return off < 1e-9 and 0 or off
    end,
  }
end

local FAST = 300 -- px/s

local function lift()
  return {
    name = "lift",
    title = "a lift starts down at 300 px/s",
    unit = "px of air between lift and rider (held by design)",
    seconds = 1,
    gravity = 600,
    objects = {
      { group = "lifts", x = 180, y = 60, width = 120, height = 12, kinematic = true },
      box(228, 36, 24),
    },
    push = function(play, frame)
      local speed = frame > 20 and FAST or 0
      if play.place then
        play.place(play, 1, 180, 60 + math.max(0, frame - 20) * speed * DT)
      else
        play.world:setVelocity(1, 0, speed)
      end
    end,
    look = function(play)
      local _, top = play.world:read(1)
      local _, y = play.world:read(2)
      play.notes.gap = math.max(play.notes.gap or 0, top - y - 24)
    end,
    number = function(play)
      return play.notes.gap < 1e-6 and 0 or play.notes.gap
    end,
  }
end

local function bullet()
  return {
    name = "bullet",
    title = "a bullet of 9000 px/s at a wall of 4 px",
    unit = "stopped, or through",
    seconds = 1,
    gravity = 0,
    objects = {
      box(20, 100, 8, { vx = 9000, gravity = 0 }),
      { group = "walls", x = 400, y = 20, width = 4, height = 180, static = true },
    },
    push = function(play, frame)
      play.world:setVelocity(1, frame > 30 and 9000 or 0, 0)
    end,
    number = function(play)
      return play.world:read(1) > 404 and "through" or "stopped"
    end,
  }
end

local function doorway()
  local objects = {
    { group = "walls", x = 300, y = 0, width = 16, height = 88, static = true },
    { group = "walls", x = 300, y = 128, width = 16, height = 100, static = true },
  }
  for i = 0, 29 do
    objects[#objects + 1] = box(40 + 24 * (i % 6), 20 + 36 * math.floor(i / 6), 16)
  end
  return {
    name = "doorway",
    title = "thirty enemies press through a door",
    unit = "px of the deepest overlap",
    seconds = 8,
    gravity = 0,
    objects = objects,
    push = function(play)
      for i = 3, 32 do
        local x, y = play.world:read(i)
        local dx, dy = 420 - x, 100 - y
        local length = math.max(1, math.sqrt(dx * dx + dy * dy))
        play.world:setVelocity(i, 90 * dx / length, 90 * dy / length)
      end
    end,
    look = function(play)
      local deepest = play.notes.deepest or 0
      for i = 3, 32 do
        local x, y = play.world:read(i)
        for j = i + 1, 32 do
          local u, v = play.world:read(j)
          deepest = math.max(deepest, math.min(16 - math.abs(x - u), 16 - math.abs(y - v)))
        end
      end
      play.notes.deepest = deepest
    end,
    number = function(play)
      return play.notes.deepest < 1e-6 and 0 or play.notes.deepest
    end,
  }
end

local function bounce()
  local objects = tiles({}, 200, 20, 24)
  objects[#objects + 1] = box(228, 40, 24, { restitution = 1 })
  local ball = #objects
  return {
    name = "bounce",
    title = "a box bounces for twenty seconds",
    unit = "px that its height changes by",
    seconds = 20,
    gravity = 1200,
    objects = objects,
    look = function(play, frame)
      local _, y = play.world:read(ball)
      if frame > 60 * 18 then
        play.notes.top = math.min(play.notes.top or 200, y)
      end
    end,
    number = function(play)
      local lost = math.abs(play.notes.top - 40)
      return lost < 0.05 and 0 or lost
    end,
  }
end

-- The same jump with steps of another length: `rate` is that of the second run.
local function jump()
  local objects = tiles({ box(228, 176, 24) }, 200, 20, 24)
  return {
    name = "jump",
    title = "the same jump at 30 and at 144 Hz",
    unit = "px between them after half a second",
    seconds = 0.5,
    rates = { 30, 144 },
    gravity = 1200,
    objects = objects,
    push = function(play, frame)
      if frame == 1 then
        play.world:setVelocity(1, 0, -500)
      end
    end,
    number = function(play)
      return (select(2, play.world:read(1)))
    end,
  }
end

local function pyramid()
  local objects = tiles({}, 200, 20, 24)
  for row = 0, 7 do
    for i = 0, 7 - row do
      objects[#objects + 1] = box(140 + 12 * row + 24 * i, 176 - 24 * row, 24, { friction = 0.6 })
    end
  end
  local last = #objects
  return {
    name = "pyramid",
    title = "a pyramid of 36 boxes stands for ten seconds",
    unit = "px that the highest one moves",
    seconds = 10,
    gravity = 1200,
    objects = objects,
    number = function(play)
      local x, y = play.world:read(last)
      local dx, dy = x - objects[last].x, y - objects[last].y
      local way = math.sqrt(dx * dx + dy * dy)
      return way < 1e-9 and 0 or way
    end,
  }
end

local CROWD, ENEMY = 200, 8 -- enemies; px

local function crowd()
  local objects = {}
  for i = 0, CROWD - 1 do
    objects[#objects + 1] = box(20 + 22 * (i % 20), 10 + 22 * math.floor(i / 20), ENEMY)
  end
  return {
    name = "crowd",
    title = "200 enemies press to one place",
    unit = "time of a step; that of love.physics is 1",
    seconds = 10,
    gravity = 0,
    objects = objects,
    isTimed = true,
    cures = { ours = { { title = "`soft`", soft = { boxes = { boxes = 200 } } } } },
    push = function(play, frame)
      for i = 1, CROWD do
        local x, y = play.world:read(i)
        local dx, dy = 236 - x, 111 - y
        local length = math.max(1, math.sqrt(dx * dx + dy * dy))
        play.world:setVelocity(i, 60 * dx / length, 60 * dy / length)
      end
      play.notes.times = frame > 300 and play.notes.times or {} -- the crowd is there
      play.notes.from = os.clock()
    end,
    look = function(play)
      local times = play.notes.times
      times[#times + 1] = 1000 * (os.clock() - play.notes.from)
    end,
    number = function(play) -- ms, the median
      local times = {}
      for i, time in ipairs(play.notes.times) do
        times[i] = time
      end
      table.sort(times)
      return times[math.ceil(#times / 2)] or 0
    end,
  }
end

scenes.list =
  { seams(), stack(), lift(), bullet(), doorway(), pyramid(), bounce(), jump(), crowd() }

return scenes
