-- The pictures of the tiles of maps/hills.lua, painted here: one image for both tilesets.

local look = require("look")

local tiles = {}

local PIXEL = 2 -- px of the world in one of a picture, so that they look a little like old times
local SIZE = 16 -- of those in a tile

local function paint(color, x, y, width, height, alpha)
  look.color(color, alpha)
  love.graphics.rectangle("fill", x, y, width, height)
end

-- Spots in the same places each time.
local function spots(color, count, seed, top, alpha)
  for i = 1, count do
    local x = math.floor(love.math.noise(i * 1.37, seed) * (SIZE - 2))
    local y = math.floor(top + love.math.noise(i * 2.71, seed + 9) * (SIZE - top - 2))
    paint(color, x, y, 2, 1, alpha)
  end
end

local function earth()
  paint("plum", 0, 0, 16, 16)
  spots("night", 9, 3, 0, 0.5)
  spots("red", 6, 5, 0, 0.6)
end

local function water()
  paint("blue", 0, 0, 16, 16, 0.55)
end

local function stem(color, x, height)
  paint(color, x, 16 - height, 1, height)
end

-- By the number of the tile in its tileset.
local LAND = {
  [0] = function()
    earth()
    paint("green", 0, 0, 16, 4)
    paint("lime", 0, 0, 16, 1)
    for x = 0, 15, 4 do
      paint("green", x, 4, 2, 1 + x / 4 % 2)
    end
  end,
  earth,
  function()
    paint("slate", 0, 0, 16, 16)
    paint("silver", 0, 0, 16, 1)
    paint("dusk", 0, 7, 16, 1)
    paint("dusk", 0, 15, 16, 1)
    paint("dusk", 4, 1, 1, 6)
    paint("dusk", 11, 8, 1, 7)
  end,
  function()
    paint("orange", 0, 0, 16, 5)
    paint("yellow", 0, 0, 16, 1)
    paint("red", 0, 4, 16, 1)
    paint("red", 7, 1, 1, 3)
  end,
  function()
    paint("slate", 0, 8, 16, 8)
    paint("silver", 0, 8, 16, 1)
    paint("dusk", 0, 15, 16, 1)
    paint("dusk", 8, 9, 1, 6)
  end,
  function()
    for x = 1, 13, 5 do
      look.color("silver")
      love.graphics.polygon("fill", x, 16, x + 2, 8, x + 4, 16)
      look.color("white")
      love.graphics.polygon("fill", x + 1, 14, x + 2, 8, x + 2, 14)
    end
  end,
  function()
    paint("blue", 0, 3, 16, 13, 0.55)
    paint("cyan", 0, 3, 16, 1)
    paint("white", 3, 4, 5, 1, 0.6)
  end,
  water,
  function()
    paint("night", 0, 0, 16, 16)
    paint("dusk", 0, 8, 16, 8)
    paint("slate", 0, 0, 16, 1)
    paint("slate", 0, 7, 16, 1)
    paint("slate", 3, 11, 3, 3)
    paint("slate", 11, 11, 3, 3)
  end,
  function()
    stem("green", 8, 6)
    paint("red", 6, 7, 5, 4)
    paint("yellow", 8, 8, 1, 2)
  end,
  function()
    for x = 1, 13, 3 do
      stem("green", x, 2 + x % 4)
      stem("lime", x + 1, 1 + x % 3)
    end
  end,
  function()
    stem("white", 7, 5)
    stem("white", 8, 5)
    paint("red", 4, 8, 8, 3)
    paint("red", 5, 7, 6, 1)
    paint("white", 6, 8, 1, 1)
    paint("white", 9, 9, 1, 1)
  end,
  function()
    stem("red", 7, 9)
    stem("red", 8, 9)
    paint("yellow", 2, 4, 10, 5)
    look.color("yellow")
    love.graphics.polygon("fill", 12, 3, 15, 6.5, 12, 10)
  end,
  function() end,
  function()
    paint("teal", 0, 4, 16, 12, 0.5)
    paint("teal", 2, 2, 5, 2, 0.5)
    paint("teal", 9, 1, 5, 3, 0.5)
  end,
  function()
    paint("teal", 0, 0, 16, 16, 0.5)
  end,
}
local THINGS = {
  [0] = function()
    paint("orange", 0, 0, 16, 16)
    paint("red", 1, 1, 14, 14)
    paint("orange", 3, 3, 10, 10)
    for i = 3, 12 do
      paint("red", i, i, 1, 1)
      paint("red", 15 - i, i, 1, 1)
    end
    paint("yellow", 0, 0, 16, 1)
  end,
  function()
    look.color("orange")
    love.graphics.circle("fill", 8, 8, 4.5)
    look.color("yellow")
    love.graphics.circle("fill", 8, 7.5, 4)
    paint("white", 6, 5, 1, 3, 0.8)
  end,
  function()
    paint("white", 6, 0, 1, 16)
    look.color("lime")
    love.graphics.polygon("fill", 7, 1, 15, 4, 7, 8)
  end,
  function() end,
}
---@type table<string, table<integer, function>>
local PICTURES = { land = LAND, things = THINGS }

local image, quads ---@type any, table

local function paintAll(tilesets)
  local step = SIZE * PIXEL
  quads = {}
  for row, set in ipairs(tilesets) do
    for id = 0, set.tilecount - 1 do
      love.graphics.push()
      love.graphics.origin()
      love.graphics.translate(id * step, (row - 1) * step)
      love.graphics.scale(PIXEL)
      PICTURES[set.name][id]()
      love.graphics.pop()
      local x, y = id * step, (row - 1) * step
      quads[set.firstgid + id] =
        love.graphics.newQuad(x, y, step, step, 16 * step, #tilesets * step)
    end
  end
end

--- Returns the image of all tiles, and the part of each gid in it.
function tiles.load(tilesets)
  if not image then
    local canvas = love.graphics.newCanvas(16 * SIZE * PIXEL, #tilesets * SIZE * PIXEL)
    love.graphics.setCanvas(canvas)
    paintAll(tilesets)
    love.graphics.setCanvas()
    -- A canvas would be empty after a change of the window.
    image = love.graphics.newImage(canvas:newImageData())
    image:setFilter("nearest", "nearest")
  end
  return image, quads
end

--- Returns the collision rectangle of a tile; without one, the whole tile.
function tiles.shapeOf(tilesets, gid)
  for _, set in ipairs(tilesets) do
    for _, tile in ipairs(set.tiles) do
      if set.firstgid + tile.id == gid and tile.objectGroup then
        return tile.objectGroup.objects[1]
      end
    end
  end
  return { x = 0, y = 0 }
end

return tiles
