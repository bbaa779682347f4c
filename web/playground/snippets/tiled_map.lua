-- Tiled map: loadTiled reads what the editor Tiled exports as Lua, and merges its solid tiles into
-- few rectangles. Here the export stands in the program; a game calls loadTiled("maps/hills.lua").
-- Move with the arrow keys, jump with space.

local physics = require("physics")

-- A tile's number in the map is its id in the tileset + 1; 0 is empty.
local EARTH, SHELF, WATER = 1, 2, 3

-- stylua: ignore
local DATA = {
  0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,
  0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,
  0,0,0,0,0,0,0,2,2,2,0,0,0,0,0,0,0,0,0,0,
  0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,
  0,0,0,2,2,2,0,0,0,0,0,0,0,0,1,1,0,0,0,0,
  0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,1,0,0,0,0,
  0,0,0,0,0,0,0,0,1,1,1,0,0,1,1,1,0,0,0,0,
  1,1,0,0,0,1,1,1,1,1,1,3,3,1,1,1,1,0,0,1,
  1,1,1,1,1,1,1,1,1,1,1,3,3,1,1,1,1,1,1,1,
  1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,
}

local MAP = {
  version = "1.10",
  orientation = "orthogonal",
  width = 20,
  height = 10,
  tilewidth = 40,
  tileheight = 40,
  properties = {},
  tilesets = {
    {
      name = "terrain",
      firstgid = 1,
      tilewidth = 40,
      tileheight = 40,
      tilecount = 3,
      tiles = {
        { id = EARTH - 1, properties = { solid = true } },
        { id = SHELF - 1, properties = { solid = true, oneWay = "top" } },
        { id = WATER - 1, properties = { solid = true, sensor = true } },
      },
    },
  },
  layers = {
    {
      type = "tilelayer",
      name = "ground",
      x = 0,
      y = 0,
      width = 20,
      height = 10,
      properties = {},
      encoding = "lua",
      data = DATA,
    },
    {
      type = "objectgroup",
      name = "players",
      properties = {},
      objects = {
        {
          id = 1,
          name = "hero",
          shape = "rectangle",
          x = 90,
          y = 240,
          width = 28,
          height = 36,
          rotation = 0,
          visible = true,
          properties = { nudge = 6 },
        },
      },
    },
  },
}

local player, level

function love.load()
  physics.load({ gravity = 1000 })
  physics.setBounds(0, -200, 800, 600)
  level = physics.loadTiled(MAP)
  player = physics.objects.players[1]
end

function love.keypressed(key)
  if key == "space" and player.touching.bottom then
    player.vy = -460
  end
end

function love.update(dt)
  local _, isInWater = physics.overlapping(player, "ground")
  player.airFriction = isInWater > 0 and 4 or 0
  player.vx = 0
  if love.keyboard.isDown("right") then
    player.vx = 200
  elseif love.keyboard.isDown("left") then
    player.vx = -200
  end
  physics.update(dt)
end

function love.draw()
  love.graphics.translate(0, 120)
  physics.draw()
  local text = ("%d rectangles for %d solid tiles"):format(level.rectangles, level.tiles)
  love.graphics.print(text, 16, -100)
end
