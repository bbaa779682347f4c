-- Lets the reader move the boxes of a scene, with the mouse or with the keys w a s d.

local input = require("input")
local look = require("look")
local physics = require("physics")

local hand = {}

local KEY_SPEED = 140 -- px/s
local PULL = 14 -- 1/s, how fast a box that obeys the physics follows the mouse

local boxes, chosen = {}, 1
-- where in the box the mouse holds it, nil: it does not
local grabbedX, grabbedY ---@type number?, number?
-- move by velocity, so that the world can say no
local isPulling ---@type boolean

--- Takes boxes to move. `byVelocity`: they are pulled and obey the world, else they are put.
function hand.take(list, byVelocity)
  boxes, chosen, isPulling, grabbedX = list, 1, byVelocity, nil
end

function hand.release()
  boxes, grabbedX = {}, nil
end

--- Chooses the next box for the keys.
function hand.choose()
  chosen = chosen % math.max(1, #boxes) + 1
end

function hand.isBusy()
  return #boxes > 0
end

local function grab(mouseX, mouseY)
  for i = #boxes, 1, -1 do
    local box = boxes[i]
    if physics.inside(mouseX, mouseY, 0, 0, box.x, box.y, box.width, box.height) then
      chosen = i
      grabbedX, grabbedY = mouseX - box.x, mouseY - box.y
      return
    end
  end
end

local function moveByMouse(box, mouseX, mouseY)
  local x, y = mouseX - grabbedX, mouseY - grabbedY
  if isPulling then
    box.vx, box.vy = (x - box.x) * PULL, (y - box.y) * PULL
  else
    box.x, box.y = x, y
  end
end

local function moveByKeys(box, dt)
  local dx, dy = input.axis("a", "a", "d", "d"), input.axis("w", "w", "s", "s")
  if dx == 0 and dy == 0 then
    return
  elseif isPulling then
    box.vx = dx ~= 0 and dx * KEY_SPEED or box.vx
    box.vy = dy ~= 0 and dy * KEY_SPEED or box.vy
  else
    box.x, box.y = box.x + dx * KEY_SPEED * dt, box.y + dy * KEY_SPEED * dt
  end
end

--- Moves what is held. The scene begins at (sceneX, sceneY) in the window.
function hand.update(dt, sceneX, sceneY)
  local mouseX, mouseY, isHeld = input.mouse()
  mouseX, mouseY = mouseX - sceneX, mouseY - sceneY
  if not isHeld then
    grabbedX = nil
  elseif not grabbedX then
    grab(mouseX, mouseY)
  end
  local box = boxes[chosen]
  if box and grabbedX then
    moveByMouse(box, mouseX, mouseY)
  elseif box then
    moveByKeys(box, dt)
  end
end

--- Marks the box that the keys move.
function hand.draw()
  local box = boxes[chosen]
  if box then
    look.color("white", 0.8)
    love.graphics.setLineWidth(2)
    love.graphics.rectangle("line", box.x - 3, box.y - 3, box.width + 6, box.height + 6, 5)
  end
end

--- Writes a name into the corner of a box.
function hand.label(box, name)
  look.color("night")
  look.text(name, box.x + 12, box.y + 9, 18)
end

return hand
