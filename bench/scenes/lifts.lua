--- Riders on lifts that go up and down, and on ferries that go to and fro; four on each.
---
---   +--+
---   +--++--++--+
---   ============  <-->

local EACH, SIZE = 4, 16 -- riders on one platform, px
local COLUMNS, SPACING = 10, 300 -- platforms in a row, px from one to the next
local SPEED, PERIOD = 90, 60 -- px/s, frames until a platform turns

-- Every other platform is a lift. They turn at different times.
local function velocity(platform, step)
  local speed = math.floor((step + 7 * platform) / PERIOD) % 2 == 0 and SPEED or -SPEED
  if platform % 2 == 0 then
    return 0, speed
  end
  return speed, 0
end

local function addRiders(objects, x, y)
  for seat = 1, EACH do
    local isOnTop = seat == EACH
    objects[#objects + 1] = {
      group = "riders",
      x = isOnTop and x or x + (SIZE + 2) * (seat - 1),
      y = y - (isOnTop and 2 * SIZE or SIZE),
      width = SIZE,
      height = SIZE,
      friction = 0.8,
    }
  end
end

local function build(riders)
  local objects = {}
  local platforms = math.ceil(riders / EACH)
  for i = 1, platforms do
    local row = math.floor((i - 1) / COLUMNS)
    local x, y = SPACING * (i - 1 - row * COLUMNS), SPACING * row
    local vx, vy = velocity(i, 0)
    objects[i] = { group = "lifts", x = x, y = y, width = 80, height = 8, vx = vx, vy = vy }
    objects[i].kinematic, objects[i].friction = true, 0.8
  end
  for i = 1, platforms do
    addRiders(objects, objects[i].x + 10, objects[i].y)
  end
  local function frame(world, step)
    for i = 1, platforms do
      world:setVelocity(i, velocity(i, step))
    end
    world:step(1 / 60)
  end
  return { gravity = 800, objects = objects, needs = { "kinematic", "upright" }, frame = frame }
end

return {
  {
    name = "lifts",
    title = "lifts and ferries with n riders",
    sizes = { 200 },
    quick = 20,
    build = build,
  },
}
