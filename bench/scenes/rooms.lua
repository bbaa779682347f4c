--- Many small worlds, as the server of a game plays them: a room with four players and 16 crates.
---
---   #           #
---   # @   @ + + #
---   #############

local TILE, TILES, PLAYERS, CRATES = 16, 20, 4, 16 -- px; 40 objects

-- Sixteen tiles as the floor, two at each end as walls.
local function addTiles(objects)
  for i = 0, TILES - 1 do
    local isWall = i >= 16
    objects[#objects + 1] = {
      group = "tiles",
      x = not isWall and i * TILE or i % 2 == 0 and 0 or 15 * TILE,
      y = not isWall and 0 or i < 18 and -TILE or -2 * TILE,
      width = TILE,
      height = TILE,
      static = true,
    }
  end
end

local function room()
  local objects = {}
  for i = 0, PLAYERS - 1 do
    objects[#objects + 1] =
      { group = "players", x = 30 + 50 * i, y = -100, width = 12, height = 24, friction = 0.3 }
  end
  for i = 0, CRATES - 1 do
    local row = math.floor(i / 8)
    objects[#objects + 1] = {
      group = "crates",
      x = 20 + 26 * (i - 8 * row),
      y = -20 - 20 * row,
      width = 14,
      height = 14,
      friction = 0.3,
    }
  end
  addTiles(objects)
  return objects
end

local function frame(world, step)
  for i = 1, PLAYERS do
    local isLeft = math.floor((step + 40 * i) / 90) % 2 == 1
    world:setVelocity(i, isLeft and -60 or 60, (step + 20 * i) % 100 == 0 and -200 or nil)
  end
  world:step(1 / 60)
end

return {
  {
    name = "rooms",
    title = "n worlds of 40 objects",
    sizes = { 500 },
    quick = 3,
    build = function(count)
      return {
        gravity = 800,
        objects = room(),
        worlds = count,
        needs = { "worlds", "upright" },
        frame = frame,
      }
    end,
  },
}
