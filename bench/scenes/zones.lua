--- Boxes in a pond, in wind and around magnets: ten zones that act on all that is in them.

local newRandom = require("spec.support.random").new
local newRoom = require("bench.room")

local SIZE = 1000 -- px, width and height of the room

local function addZone(objects, x, y, size, area)
  objects[#objects + 1] = {
    group = "zones",
    x = x,
    y = y,
    width = size,
    height = size,
    static = true,
    sensor = true,
    area = area,
  }
end

local function build(count)
  local random = newRandom(37)
  local objects = newRoom(SIZE)
  for i = 0, 4 do
    addZone(objects, 200 * i, 800, 200, { gravity = -400, airFriction = 3 })
  end
  addZone(objects, 0, 0, 250, { ax = 300 })
  addZone(objects, 750, 0, 250, { ax = -300, drag = 20 })
  addZone(objects, 300, 100, 200, { attract = 900, law = "inverse" })
  addZone(objects, 550, 300, 200, { attract = 900, law = "linear" })
  addZone(objects, 100, 400, 300, { gravity = 50 })
  local columns = math.ceil(math.sqrt(count))
  local spacing = SIZE / columns
  for i = 0, count - 1 do
    local row = math.floor(i / columns)
    objects[#objects + 1] = {
      group = "boxes",
      x = spacing * (i - row * columns) + random:between(0, spacing - 12),
      y = spacing * row + random:between(0, spacing - 12),
      width = 10,
      height = 10,
      restitution = 0.4,
    }
  end
  return objects
end

return {
  {
    name = "zones",
    title = "zones: boxes in water, wind and around magnets",
    sizes = { 100, 200, 500, 1000 },
    quick = 40,
    build = function(count)
      return { gravity = 800, objects = build(count), needs = { "zones" } }
    end,
  },
}
