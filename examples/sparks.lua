-- Sparks and flashes. They are not in the world: what touches nothing needs no physics.

local look = require("look")

local sparks = {}

local GRAVITY = 900 -- px/s²
local BURST, FLASH = 0.7, 0.25 -- s, how long they last

local flying, flashes, clock = {}, {}, 0

--- Takes all away.
function sparks.clear()
  flying, flashes = {}, {}
end

--- Throws sparks from the middle of an object. `color`: its own, when there is none.
function sparks.burst(object, count, color)
  for i = 1, count do
    local angle = i / count * 2 * math.pi
    local speed = 90 + love.math.noise(i * 1.7, clock) * 190
    flying[#flying + 1] = {
      x = object.x + object.width / 2,
      y = object.y + object.height / 2,
      vx = math.cos(angle) * speed,
      vy = math.sin(angle) * speed - 120,
      left = BURST,
      color = color or object.color,
    }
  end
end

--- Lets a rectangle light up.
function sparks.flash(x, y, width, height)
  flashes[#flashes + 1] = { x = x, y = y, width = width, height = height, left = FLASH }
end

local function age(list, dt)
  for i = #list, 1, -1 do
    list[i].left = list[i].left - dt
    if list[i].left <= 0 then
      table.remove(list, i)
    end
  end
end

function sparks.update(dt)
  clock = clock + dt
  age(flying, dt)
  age(flashes, dt)
  for _, spark in ipairs(flying) do
    spark.vy = spark.vy + GRAVITY * dt
    spark.x, spark.y = spark.x + spark.vx * dt, spark.y + spark.vy * dt
  end
end

function sparks.draw()
  for _, spark in ipairs(flying) do
    look.color(spark.color, spark.left / BURST)
    love.graphics.rectangle("fill", spark.x - 3, spark.y - 3, 6, 6, 2)
  end
  for _, flash in ipairs(flashes) do
    look.color("white", flash.left / FLASH)
    love.graphics.rectangle("fill", flash.x, flash.y, flash.width, flash.height, 3)
  end
end

return sparks
