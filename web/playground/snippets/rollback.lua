-- Rollback slider: every step is saved. Hold left to go back in time, right to go forward, or drag
-- the bar with the mouse. Let go, and the world goes on from there: the same way, to the bit.

local physics = require("physics")

local KEPT = 600 -- steps
local BAR_X, BAR_Y, BAR_WIDTH = 100, 60, 600

local states, now, last

function love.load()
  physics.load({ gravity = 900 })
  physics.setBounds(0, 0, 800, 600)
  local sizes = { 28, 40, 22, 34, 46 }
  for i = 0, 24 do
    local size = sizes[i % #sizes + 1]
    physics.add("boxes", {
      x = 60 + 140 * (i % 5) + 7 * math.floor(i / 5),
      y = 100 + 60 * math.floor(i / 5),
      width = size,
      height = size,
      vx = (i * 37) % 100 - 50,
      friction = 0.4,
      restitution = 0.4,
    })
  end
  states, now, last = { [0] = physics.save() }, 0, 0
end

local function goTo(step)
  now = math.max(0, math.min(last, step))
  physics.restore(states[now])
end

function love.update(dt)
  local x, y = love.mouse.getPosition()
  if love.mouse.isDown(1) and y < BAR_Y + 40 then
    goTo(math.floor((x - BAR_X) / BAR_WIDTH * KEPT))
  elseif love.keyboard.isDown("left") then
    goTo(now - 2)
  elseif love.keyboard.isDown("right") and now < last then
    goTo(now + 2)
  elseif now < KEPT then
    physics.update(dt)
    now = now + 1
    states[now] = physics.save(states[now])
    last = now -- what was ahead has not happened
  end
end

function love.draw()
  physics.draw({ velocity = true })
  love.graphics.setColor(1, 1, 1, 0.25)
  love.graphics.rectangle("fill", BAR_X, BAR_Y, BAR_WIDTH, 12, 6)
  love.graphics.setColor(1, 1, 1, 0.5)
  love.graphics.rectangle("fill", BAR_X, BAR_Y, BAR_WIDTH * last / KEPT, 12, 6)
  love.graphics.setColor(1, 1, 1)
  love.graphics.circle("fill", BAR_X + BAR_WIDTH * now / KEPT, BAR_Y + 6, 10)
  love.graphics.print(("step %d, hash %.0f"):format(now, physics.hash()), 16, 16)
end
