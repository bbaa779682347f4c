--- Bullets that fly straight from a middle outwards, and can hit only the player, which is near few
--- of them. Each that leaves the room begins anew in the middle.
---
---    \  |  /
---    -  o  -     P
---    /  |  \

local newRandom = require("spec.support.random").new

local ROOM = 900 -- px from the middle to a side
local SLOW, FAST = 80, 240 -- px/s
local HITS = { "players" }

local function build(count)
  local random = newRandom(5)
  local objects = {
    { group = "players", x = 500, y = 300, width = 16, height = 24, pushable = false },
  }
  for _ = 1, count do
    local vx, vy, speed = 0, 0, 0
    while speed < SLOW or speed > FAST do
      vx, vy = random:between(-FAST, FAST), random:between(-FAST, FAST)
      speed = math.sqrt(vx * vx + vy * vy)
    end
    local age = random:between(0, ROOM / speed)
    objects[#objects + 1] = {
      group = "bullets",
      x = vx * age,
      y = vy * age,
      width = 6,
      height = 6,
      vx = vx,
      vy = vy,
      sensor = true,
      hits = HITS,
    }
  end
  return {
    gravity = 0,
    objects = objects,
    still = 1,
    needs = { "upright", "sensors" },
    warmUp = 60,
    steps = 240,
  }
end

return {
  {
    name = "bullets",
    title = "n bullets fly straight and can hit one object",
    sizes = { 500, 2000 },
    quick = 20,
    build = build,
  },
}
