--- 200 walkers on ten floors of tiles, or on a hundred, or over hills: they run to and fro and
--- jump, and now and then run into each other. The game writes their velocity, as games do.
---
---   #   @    @       @   #           @        @
---   ######################          /##\    @/#\   @
---   #  @        @     @  #         /####\__/####\____
---   ######################

local TILE, COLUMNS, STOREY = 16, 200, 128 -- px, tiles in a storey (floor and ends), px
local WALKERS, HILLY = 200, 10 -- walkers; storeys of hills
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

-- A floor up to a column, and a wall some tiles high at each end.
local function addStorey(objects, y, last, high)
  for column = 0, last do
    addTile(objects, column, y)
  end
  for row = 1, high do
    addTile(objects, 0, y - row * TILE)
    addTile(objects, last, y - row * TILE)
  end
end

-- Hills of two tiles' height on a floor.
local function addHills(objects, y)
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

-- Walkers side by side on each storey, from x = `left` on, `above` px above its floor.
local function newWalkers(storeys, left, wide, above)
  local objects, each = {}, WALKERS / storeys
  for i = 0, WALKERS - 1 do
    local storey = math.floor(i / each)
    objects[#objects + 1] = {
      group = "walkers",
      x = left + (i - storey * each) * (wide / each),
      y = storey * STOREY - above,
      width = 14,
      height = 24,
    }
  end
  return objects
end

local function newLevel(tiles)
  local storeys = math.max(1, math.floor(tiles / COLUMNS))
  local objects = newWalkers(storeys, 100, 2900, 24)
  for storey = 0, storeys - 1 do
    addStorey(objects, storey * STOREY, COLUMNS - 5, 2)
  end
  return objects
end

local function newHills()
  local objects = newWalkers(HILLY, 40, 3000, 80)
  for storey = 0, HILLY - 1 do
    addStorey(objects, storey * STOREY, COLUMNS - 1, 4)
    addHills(objects, storey * STOREY)
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
    name = "level",
    title = "level: 200 walkers, n tiles",
    sizes = { 2000, 20000 },
    quick = 2000,
    build = function(tiles)
      return { gravity = 800, objects = newLevel(tiles), needs = { "upright" }, frame = frame }
    end,
  },
  {
    name = "hills",
    title = "hills: n walkers on slopes",
    sizes = { WALKERS },
    quick = WALKERS,
    build = function()
      local needs = { "upright", "slopes" }
      return { gravity = 800, objects = newHills(), needs = needs, frame = frame }
    end,
  },
}
