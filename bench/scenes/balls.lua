--- Balls that bounce off each other and off four walls for ever: without gravity, and under it.

local newRandom = require("spec.support.random").new
local newRoom = require("bench.room")

local SPACING = 29 -- px: balls of 4 to 10 px fill a sixth of the room

local function build(count)
  local random = newRandom(31)
  local columns = math.ceil(math.sqrt(count))
  local size = columns * SPACING
  local objects = newRoom(size)
  for i = 0, count - 1 do
    local row, radius = math.floor(i / columns), random:between(4, 10)
    objects[#objects + 1] = {
      group = "balls",
      x = SPACING * (i - row * columns) + random:between(0, 8),
      y = SPACING * row + random:between(0, 8),
      width = 2 * radius,
      height = 2 * radius,
      radius = radius,
      vx = random:between(-200, 200),
      vy = random:between(-200, 200),
      restitution = 1,
    }
  end
  return objects
end

return {
  {
    name = "balls",
    title = "balls: circles that bounce for ever, no gravity",
    sizes = { 200, 1000 },
    quick = 40,
    build = function(count)
      return { gravity = 0, rest = false, objects = build(count), needs = { "circles" } }
    end,
  },
}
