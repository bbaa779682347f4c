-- How a player runs and jumps, in the examples where that is not the point. The hero to copy is
-- kit/hero.lua.

local input = require("input")

local hero = {}

local SPEED, SPEED_UP, JUMP_SPEED = 230, 1800, 620 -- px/s, px/s², px/s

--- Changes the player's vx as far as it gets in dt s, and turns its eyes. `direction`: -1, 0 or 1;
--- nil: as the arrow keys say. `speed`: px/s, the highest one (230).
function hero.run(player, dt, direction, speed)
  direction = direction or input.axis("left", "a", "right", "d")
  local missing, step = direction * (speed or SPEED) - player.vx, SPEED_UP * dt
  player.vx = player.vx + math.max(-step, math.min(step, missing))
  player.lookX = direction ~= 0 and direction or player.lookX
end

--- Jumps, if there is something to jump from. `speed`: px/s (620).
function hero.jump(player, speed)
  if player.touching.bottom then
    player.vy = -(speed or JUMP_SPEED)
  end
end

return hero
