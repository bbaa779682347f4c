--- Bullets come and go: each lives for one second, and flies into a hall with stacks of boxes.
---
---   | -         - |
---   |  -     +-+  |
---   |   -    +-+  |
---   +-------------+

local WIDTH, HEIGHT = 1600, 400 -- px
local STACKS, HIGH, SIZE = 40, 5, 16 -- stacks, boxes in each, px

local function hall()
  local objects = {
    { x = -40, y = 0, width = WIDTH + 80, height = 40 },
    { x = -40, y = -HEIGHT, width = 40, height = HEIGHT },
    { x = WIDTH, y = -HEIGHT, width = 40, height = HEIGHT },
  }
  for _, wall in ipairs(objects) do
    wall.group, wall.static = "walls", true
  end
  for i = 0, STACKS * HIGH - 1 do
    local stack = math.floor(i / HIGH)
    objects[#objects + 1] = {
      group = "boxes",
      x = 300 + 30 * stack,
      y = -SIZE * (i - stack * HIGH + 1),
      width = SIZE,
      height = SIZE,
      friction = 0.3,
    }
  end
  return objects
end

-- The k-th bullet; their heights follow no order.
local function bullet(k)
  return {
    group = "bullets",
    x = 10,
    y = -10 - (k * 37) % (HEIGHT - 20),
    width = 6,
    height = 4,
    vx = 600,
    gravity = 0,
  }
end

local function build(rate)
  local objects = hall()
  local first = #objects
  local function frame(world, step)
    for k = math.floor((step - 1) * rate / 60) + 1, math.floor(step * rate / 60) do
      world:add(bullet(k))
      if k > rate then
        world:remove(first + k - rate)
      end
    end
    world:step(1 / 60)
  end
  return { gravity = 800, objects = objects, needs = { "upright" }, frame = frame }
end

return {
  {
    name = "spawn",
    title = "n bullets a second come and go",
    sizes = { 100 },
    quick = 100,
    build = build,
  },
}
