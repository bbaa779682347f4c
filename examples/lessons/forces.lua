-- Step 8: gravity, friction, air friction and speed limits.

local look = require("look")
local physics = require("physics")

local lesson = {
  title = "Forces",
  text = [[
Objects keep their speed until something changes it.

Gravity pulls everything down. Each object may have its own; with 0 it floats. Friction brakes
a box that slides on a floor, until it stops. Air friction takes a share of the speed every
second, also in the air. A speed limit cuts the speed.

Space starts the four boxes again. All numbers are per second, not per frame: at 30 and at 144
frames a second the boxes get equally far.]],
  code = [[
world.gravity = 800  -- px/s², for all boxes
box.gravity = 0  -- its own
box.friction = 0.35  -- of its weight, on a floor
box.airFriction = 1.2  -- e^(-1.2) is left after 1 s
box.maxSpeedX = 120  -- px/s]],
  keys = { { "space", "start again" } },
}

local LANES = {
  { name = "nothing", color = "silver", fields = {} },
  { name = "friction = 0.35", color = "orange", fields = { friction = 0.35 } },
  { name = "airFriction = 1.2", color = "sky", fields = { airFriction = 1.2 } },
  { name = "maxSpeedX = 120", color = "lime", fields = { maxSpeedX = 120 } },
}
local LANE_HEIGHT = 124
local START_X, START_SPEED, JUMP_SPEED = 20, 300, 240
local TRAIL_TIME = 0.05 -- s between two dots

local world, boxes, trails, untilDot ---@type physics.World, physics.Object[], table, number

function lesson.load()
  world = physics.newWorld({ gravity = 800 })
  lesson.world = world
  boxes, trails, untilDot = {}, {}, 0
  for i, lane in ipairs(LANES) do
    local bottom = i * LANE_HEIGHT
    world:add("floors", { x = 0, y = bottom - 8, width = 484, height = 8, static = true })
    world:add("walls", { x = 474, y = bottom - 60, width = 10, height = 52, static = true })
    local box = { x = START_X, y = bottom - 36, width = 28, height = 28 }
    box.vx, box.vy = START_SPEED, -JUMP_SPEED
    for field, value in pairs(lane.fields) do
      box[field] = value
    end
    boxes[i], trails[i] = world:add("boxes", box), {}
  end
end

function lesson.keypressed(key)
  if key == "space" then
    lesson.load()
  end
end

function lesson.update(dt)
  world:update(dt)
  untilDot = untilDot - dt
  if untilDot <= 0 then
    untilDot = untilDot + TRAIL_TIME
    for i, box in ipairs(boxes) do
      if box.vx ~= 0 then
        table.insert(trails[i], { box.x + 14, box.y + 14 })
      end
    end
  end
end

function lesson.draw()
  look.color("slate")
  for _, group in ipairs({ "floors", "walls" }) do
    for _, object in ipairs(world.objects[group]) do
      love.graphics.rectangle("fill", object.x, object.y, object.width, object.height)
    end
  end
  for i, lane in ipairs(LANES) do
    local box, top = boxes[i], (i - 1) * LANE_HEIGHT
    look.color("white")
    look.text(lane.name, 14, top + 8, 15)
    look.color("silver")
    look.text(("vx = %.0f"):format(box.vx), 380, top + 8, 15)
    look.color(lane.color, 0.45)
    for _, dot in ipairs(trails[i]) do
      love.graphics.circle("fill", dot[1], dot[2], 3)
    end
    look.box(box.x, box.y, box.width, box.height, lane.color)
  end
end

return lesson
