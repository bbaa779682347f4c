--- 200 walkers on ten floors of tiles, or on a hundred: they run to and fro and jump, and now and
--- then run into each other. The game writes their velocity, as games do.
---
---   #   @    @       @   #
---   ######################
---   #  @        @     @  #
---   ######################

local TILE, COLUMNS, STOREY = 16, 200, 128 -- px, tiles in a storey (floor and ends), px
local WALKERS = 200
local SPEED, JUMP = 80, -300 -- px/s

local function addTile(objects, x, y)
  objects[#objects + 1] =
    { group = "tiles", x = x, y = y, width = TILE, height = TILE, static = true }
end

-- A floor, and a wall two tiles high at each end.
local function addStorey(objects, y)
  local last = COLUMNS - 5
  for i = 0, last do
    addTile(objects, i * TILE, y)
  end
  for i = 1, 2 do
    addTile(objects, 0, y - i * TILE)
    addTile(objects, last * TILE, y - i * TILE)
  end
end

local function build(tiles)
  local objects = {}
  local storeys = math.max(1, math.floor(tiles / COLUMNS))
  local each = WALKERS / storeys -- walkers on one storey
  for i = 0, WALKERS - 1 do
    local storey = math.floor(i / each)
    objects[#objects + 1] = {
      group = "walkers",
      x = 100 + (i - storey * each) * (2900 / each),
      y = storey * STOREY - 24,
      width = 14,
      height = 24,
    }
  end
  for storey = 0, storeys - 1 do
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
    name = "level",
    title = "level: 200 walkers, n tiles",
    sizes = { 2000, 20000 },
    quick = 2000,
    build = function(tiles)
      return { gravity = 800, objects = build(tiles), needs = { "upright" }, frame = frame }
    end,
  },
}
