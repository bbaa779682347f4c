--- Everybody wants to the same place, from all sides, for ever: a crowd that presses itself. The
--- game gives each its velocity in every frame, as for enemies that chase a player.
---
---   @ > @ > @@@ < @ < @
---           @@@
---   @   >   @@@   < @

local SIZE, SPACING, SPEED = 14, 40, 60 -- px, px, px/s

local function build(count)
  local columns = math.ceil(math.sqrt(2 * count))
  local middleX, middleY = SPACING * columns / 2, SPACING * columns / 4
  local objects = {}
  for i = 0, count - 1 do
    local row = math.floor(i / columns)
    objects[i + 1] = {
      group = "enemies",
      x = SPACING * (i - columns * row),
      y = SPACING * row,
      width = SIZE,
      height = SIZE,
    }
  end
  local function frame(world)
    for i = 1, count do
      local x, y = world:read(i)
      local dx, dy = middleX - x, middleY - y
      local distance = math.sqrt(dx * dx + dy * dy) + 1
      world:setVelocity(i, dx / distance * SPEED, dy / distance * SPEED)
    end
    world:step(1 / 60)
  end
  return { gravity = 0, objects = objects, needs = { "upright" }, frame = frame }
end

return {
  {
    name = "swarm",
    title = "n enemies press to one place",
    sizes = { 50, 200 },
    quick = 20,
    build = build,
  },
}
