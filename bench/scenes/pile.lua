--- Boxes of 10 to 20 px, with small sideways speeds, dropped into a container 800 px wide.
---
---   |  +-+  +-+  +--+ |
---   |  +-+  +-+  +--+ |
---   +-----------------+

local newRandom = require("spec.support.random").new

local WIDTH, SPACING = 800, 25 -- px

local function build(count, friction)
  local random = newRandom(17)
  local tall = 30 * count
  local objects = {
    { x = -100, y = 0, width = WIDTH + 200, height = 100 },
    { x = -100, y = -tall, width = 100, height = tall },
    { x = WIDTH, y = -tall, width = 100, height = tall },
  }
  for _, wall in ipairs(objects) do
    wall.group, wall.static, wall.friction = "walls", true, friction
  end
  local columns = WIDTH / SPACING
  for i = 0, count - 1 do
    local row = math.floor(i / columns)
    objects[#objects + 1] = {
      group = "boxes",
      x = SPACING * (i - row * columns) + random:between(0, 5),
      y = -SPACING * (row + 1),
      width = random:between(10, 20),
      height = random:between(10, 20),
      vx = random:between(-20, 20),
      friction = 0.3,
    }
  end
  return objects
end

local sizes = { 500, 1000, 2000, 5000, 10000 }

-- High piles need longer until the last box has landed: 10 000 boxes fall 4.5 s.
local function steps(count)
  return count >= 5000 and 900 or 600
end

return {
  {
    name = "pile",
    title = "pile, as a game would write it",
    sizes = sizes,
    quick = 60,
    build = function(count)
      return { gravity = 800, rest = true, objects = build(count, 0.3), steps = steps(count) }
    end,
  },
  {
    -- On a smooth floor the heap slides about for a long time, and nothing may be skipped: this
    -- is the bare cost of a step.
    name = "pile-awake",
    title = "pile, smooth floor, without rest",
    sizes = sizes,
    quick = 60,
    build = function(count)
      return { gravity = 800, rest = false, objects = build(count, 0), steps = steps(count) }
    end,
  },
}
