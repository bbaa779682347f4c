--- 200 walkers on ten storeys of hills: they run to and fro over slopes and jump. The game writes
--- their velocity, as games do.
---
---     @        @
---    /##\    @/#\   @
---   /####\__/####\____

local TILE, COLUMNS, STOREY, STOREYS = 16, 200, 128, 10 -- px, tiles wide, px, storeys
local WALKERS = 200
local SPEED, JUMP = 80, -300 -- px/s
local HILL = 10 -- tiles from one hill to the next; a hill is up, flat and down, each two tiles

local function addTile(objects, column, y, slope)
  objects[#objects + 1] = {
    group = "tiles",
    x = column * TILE,
    y = y,
    width = TILE,
    height = TILE,
    static = true,
    slope = slope,
  }
end

-- A floor, a wall at each end, and hills of two tiles' height on it.
local function addStorey(objects, y)
  for column = 0, COLUMNS - 1 do
    addTile(objects, column, y)
  end
  for row = 1, 4 do
    addTile(objects, 0, y - row * TILE)
    addTile(objects, COLUMNS - 1, y - row * TILE)
  end
  for first = 4, COLUMNS - 10, HILL do
    addTile(objects, first, y - TILE, "right")
    for column = first + 1, first + 4 do
      addTile(objects, column, y - TILE)
    end
    addTile(objects, first + 5, y - TILE, "left")
    addTile(objects, first + 1, y - 2 * TILE, "right")
    addTile(objects, first + 2, y - 2 * TILE)
    addTile(objects, first + 3, y - 2 * TILE)
    addTile(objects, first + 4, y - 2 * TILE, "left")
  end
end

local function build()
  local objects, each = {}, WALKERS / STOREYS
  for i = 0, WALKERS - 1 do
    local storey = math.floor(i / each)
    objects[#objects + 1] = {
      group = "walkers",
      x = 40 + (i - storey * each) * (3000 / each),
      y = storey * STOREY - 80,
      width = 14,
      height = 24,
    }
  end
  for storey = 0, STOREYS - 1 do
    addStorey(objects, storey * STOREY)
  end
  return objects
end

-- Each walker turns every 2 s and jumps every 1.5 s, at times of its own.
local function frame(world, step)
  for i = 1, WALKERS do
    local isLeft = math.floor((step + 7 * i) / 120) % 2 == 1
    local isJumping = (step + 11 * i) % 90 == 0
    world:setVelocity(i, isLeft and -SPEED or SPEED, isJumping and JUMP or nil)
  end
  world:step(1 / 60)
end

return {
  {
    name = "hills",
    title = "hills: n walkers on slopes",
    sizes = { WALKERS },
    quick = WALKERS,
    build = function()
      return { gravity = 800, objects = build(), needs = { "upright", "slopes" }, frame = frame }
    end,
  },
}
