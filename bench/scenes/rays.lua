--- 1000 rays a frame among boxes that float. Only the rays are measured, from the first one after
--- an update on.

local newRandom = require("spec.support.random").new

local RAYS, LENGTH = 1000, 200 -- px, along each axis at most
local SPACING = 28 -- px

local function newRays(random, size)
  local rays = {}
  for i = 1, 4 * RAYS, 4 do
    local x, y = random:between(0, size), random:between(0, size)
    rays[i], rays[i + 1] = x, y
    rays[i + 2] = x + random:between(-LENGTH, LENGTH)
    rays[i + 3] = y + random:between(-LENGTH, LENGTH)
  end
  return rays
end

local function build(count)
  local random = newRandom(31)
  local columns = math.ceil(math.sqrt(count))
  local objects = {}
  for i = 0, count - 1 do
    local row = math.floor(i / columns)
    objects[i + 1] = {
      group = "boxes",
      x = SPACING * (i - row * columns) + random:between(0, 8),
      y = SPACING * row + random:between(0, 8),
      width = random:between(10, 20),
      height = random:between(10, 20),
    }
  end
  local rays = newRays(random, columns * SPACING)
  local function frame(world)
    for i = 1, 4 * RAYS, 4 do
      world:raycast(rays[i], rays[i + 1], rays[i + 2], rays[i + 3])
    end
  end
  local function between(world)
    world:step(1 / 60)
  end
  local needs = { "raycast", "upright" }
  return { gravity = 0, objects = objects, needs = needs, frame = frame, between = between }
end

return {
  {
    name = "rays",
    title = "1000 rays a frame among n boxes",
    sizes = { 5000 },
    quick = 200,
    build = build,
  },
}
