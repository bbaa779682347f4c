--- Boxes that bounce off each other and off four walls for ever, without gravity.

local newRandom = require("spec.support.random").new
local newRoom = require("bench.room")

local SPACING = 25 -- px: boxes of 8 to 12 px fill a sixth of the room

local function build(count)
  local random = newRandom(29)
  local columns = math.ceil(math.sqrt(count))
  local size = columns * SPACING
  local objects = newRoom(size)
  for i = 0, count - 1 do
    local row = math.floor(i / columns)
    objects[#objects + 1] = {
      group = "boxes",
      x = SPACING * (i - row * columns) + random:between(0, 12),
      y = SPACING * row + random:between(0, 12),
      width = random:between(8, 12),
      height = random:between(8, 12),
      vx = random:between(-100, 100),
      vy = random:between(-100, 100),
      restitution = 1,
    }
  end
  return objects
end

return {
  {
    name = "gas",
    title = "gas: boxes that bounce for ever, no gravity",
    sizes = { 2000 },
    quick = 60,
    build = function(count)
      return { gravity = 0, rest = false, objects = build(count) }
    end,
  },
}
