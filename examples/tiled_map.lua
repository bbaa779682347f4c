-- Draws the tile layers and tile objects of a map from Tiled. STI does that and more for a game;
-- this is as much as one level needs. The pictures of the tiles are made in tiled_tiles.lua.

local look = require("look")
local tiles = require("tiled_tiles")

local tiledMap = {}

-- The upper bits of a gid: flipped left to right, top to bottom, along the diagonal.
local FLIP_X, FLIP_Y, TRANSPOSE = 2 ^ 31, 2 ^ 30, 2 ^ 29

local map, image, quads, layers ---@type table, any, table, table

local function take(gid, bit)
  if gid >= bit then
    return gid - bit, true
  end
  return gid, false
end

local function decode(gid)
  local isFlippedX, isFlippedY, isTransposed
  gid, isFlippedX = take(gid, FLIP_X)
  gid, isFlippedY = take(gid, FLIP_Y)
  gid, isTransposed = take(gid, TRANSPOSE)
  return gid, isFlippedX, isFlippedY, isTransposed
end

-- Adds a tile with its top-left corner at x, y: turned around its middle.
local function addTile(batch, value, x, y)
  local gid, isFlippedX, isFlippedY, isTransposed = decode(value)
  local scaleX, scaleY = isFlippedX and -1 or 1, isFlippedY and -1 or 1
  local angle = 0.0
  if isTransposed then
    angle, scaleX, scaleY = math.pi / 2, scaleY, -scaleX
  end
  local halfWidth, halfHeight = map.tilewidth / 2, map.tileheight / 2
  x, y = x + halfWidth, y + halfHeight
  return batch:add(quads[gid], x, y, angle, scaleX, scaleY, halfWidth, halfHeight)
end

local function addLayer(layer)
  local batch, sprites = love.graphics.newSpriteBatch(image, #layer.data), {}
  for i, gid in ipairs(layer.data) do
    if gid ~= 0 then
      local column = (i - 1) % layer.width
      local row = (i - 1 - column) / layer.width
      sprites[i] = addTile(batch, gid, column * map.tilewidth, row * map.tileheight)
    end
  end
  layers[layer.name] = { batch = batch, parallax = layer.parallaxx, sprites = sprites }
  layers[layer.name].columns = layer.width
end

local function addLayers(list)
  for _, layer in ipairs(list) do
    if layer.type == "group" then
      addLayers(layer.layers)
    elseif layer.type == "tilelayer" then
      addLayer(layer)
    end
  end
end

--- Makes ready to draw a map.
function tiledMap.load(given)
  map, layers = given, {}
  image, quads = tiles.load(map.tilesets)
  addLayers(map.layers)
end

--- Draws a tile layer. `x`: of the world at the left edge of the picture, px.
function tiledMap.drawLayer(name, x)
  local layer = layers[name]
  love.graphics.setColor(1, 1, 1, 1)
  -- Whole pixels: between two of them, gaps would show between the tiles.
  love.graphics.draw(layer.batch, math.floor(x * (1 - layer.parallax)), 0)
end

--- Does not draw a tile any more; columns and rows from 0.
function tiledMap.clear(name, column, row)
  local layer = layers[name] ---@type table
  local sprite = layer.sprites[row * layer.columns + column + 1]
  if sprite then
    layer.batch:set(sprite, 0, 0, 0, 0, 0)
  end
end

--- Draws a tile object where its box is: the box is a part of the tile, as the tileset says.
function tiledMap.drawObject(object)
  local shape = tiles.shapeOf(map.tilesets, object.tiled.gid)
  love.graphics.setColor(1, 1, 1, 1)
  love.graphics.draw(image, quads[object.tiled.gid], object.x - shape.x, object.y - shape.y)
end

--- Draws arrows that run as the belts do.
function tiledMap.drawBelts(belts, time)
  look.color("yellow")
  for _, belt in ipairs(belts) do
    local speed = belt.surfaceSpeed
    for x = belt.x + time * speed % 32, belt.x + belt.width - 12, 32 do
      love.graphics.polygon("fill", x, belt.y + 7, x + 10, belt.y + 2, x + 10, belt.y + 12)
    end
  end
end

return tiledMap
