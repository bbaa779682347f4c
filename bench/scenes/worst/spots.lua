--- Boxes that the game has put into each other: all at one spot, flung from one spot, or at random
--- into a strip that has hardly room for them.
---
---       open        corner       corridor       ceiling
---
---                   |            #########      #########
---        #          |                #              #
---                   |#           #########
---                   +------                     #########

local newRandom = require("spec.support.random").new
local shared = require("bench.scenes.worst.shared")

local FAR = shared.FAR
local SIZE = 8 -- px

local function addSpot(objects, count, x, y)
  for _ = 1, count do
    shared.addCrate(objects, x, y, SIZE)
  end
end

local function open(count)
  local objects = {}
  addSpot(objects, count, 0, 0)
  return shared.finish({
    gravity = 0,
    objects = objects,
    driven = 0,
    room = { -FAR, -FAR, FAR, FAR },
  })
end

-- Two walls of 2 px; what leaves through one of them is outside.
local function corner(count)
  local objects = {}
  shared.addWall(objects, -2, -2000, 2, 2002)
  shared.addWall(objects, 0, 0, 2000, 2)
  addSpot(objects, count, 0, -SIZE)
  return shared.finish({
    gravity = 0,
    objects = objects,
    driven = 0,
    room = { 0, -FAR, FAR, 0 },
  })
end

local CORRIDOR = 64 -- px high, open to both sides

local function corridor(count)
  local objects = {}
  shared.addWall(objects, -4000, 0, 8000, 16)
  shared.addWall(objects, -4000, -CORRIDOR - 16, 8000, 16)
  addSpot(objects, count, 0, -CORRIDOR / 2)
  return shared.finish({ objects = objects, driven = 0, room = { -FAR, -CORRIDOR, FAR, 0 } })
end

local HALL = 240 -- px high

local function ceiling(count)
  local objects = {}
  shared.addWall(objects, -2000, 0, 4000, 16)
  shared.addWall(objects, -400, -HALL - 8, 800, 8)
  addSpot(objects, count, 0, -HALL)
  return shared.finish({ objects = objects, driven = 0, room = { -FAR, -HALL, FAR, 0 } })
end

local FLINGS, PAUSE = 3, 60 -- how often, frames from one to the next
local HALL_WIDTH, HALL_HEIGHT = 400, 300 -- px

-- n pieces at once from the middle of a room, three times over.
local function debris(count)
  local objects, pieces, random = {}, {}, newRandom(5)
  shared.addRoom(objects, HALL_WIDTH, HALL_HEIGHT)
  for i = 1, FLINGS * count do
    local size = random:between(6, 8)
    pieces[i] = {
      group = "crates",
      x = (HALL_WIDTH - size) / 2,
      y = (HALL_HEIGHT - size) / 2,
      width = size,
      height = size,
      vx = random:between(-400, 400),
      vy = random:between(-500, 100),
      friction = shared.FRICTION,
    }
  end
  local function frame(world, step)
    local number = (step - 1) / PAUSE
    if number < FLINGS and number == math.floor(number) then
      for i = number * count + 1, (number + 1) * count do
        world:add(pieces[i])
      end
    end
    world:step(1 / 60)
  end
  return shared.finish({
    objects = objects,
    driven = (FLINGS - 1) * PAUSE + 1,
    room = { 0, 0, HALL_WIDTH, HALL_HEIGHT },
    frame = frame,
  })
end

local STRIP_HEIGHT, STRIP_EACH = 60, 2 -- px; length of the strip for each of the crowd

-- The crowd fills five sixths of the strip, so most of it stands in others; the ends are open.
local function strip(count)
  local objects, random = {}, newRandom(9)
  local length = STRIP_EACH * count
  shared.addWall(objects, -2000, -16, length + 4000, 16)
  shared.addWall(objects, -2000, STRIP_HEIGHT, length + 4000, 16)
  for _ = 1, count do
    local size = random:between(8, 12)
    local x, y = random:between(0, length - size), random:between(0, STRIP_HEIGHT - size)
    shared.addCrate(objects, x, y, size)
  end
  return shared.finish({
    gravity = 0,
    objects = objects,
    driven = 0,
    room = { -FAR, 0, FAR, STRIP_HEIGHT },
  })
end

local SIZES = { 20, 100, 200 }

local function definition(name, title, build, sizes)
  return {
    name = name,
    title = title,
    sizes = sizes or SIZES,
    growth = shared.GROWTH,
    quick = 10,
    startsInside = true,
    build = build,
  }
end

return {
  definition("spot-open", "n boxes at one spot", open),
  definition("spot-corner", "n boxes at one spot in a corner", corner),
  definition("spot-corridor", "n boxes at one spot in a corridor", corridor),
  definition("spot-ceiling", "n boxes at one spot under a ceiling", ceiling),
  definition("debris", "n pieces flung from one spot, three times", debris, { 100 }),
  definition("strip", "n boxes put at random into a strip", strip, { 300 }),
}
