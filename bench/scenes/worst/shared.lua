--- What the scenes of the worst case have in common. They are no games: each asks for a step that
--- is as expensive as a step can be, with at most 300 movers, or leaves no room for what is in it.
---
--- Beside the fields of every scene (bench/scenes.lua) each has
---
---   driven    frame after which nothing drives it any more; it has to come to rest
---   room      x1, y1, x2, y2: what must not be left by the middle of a mover; or function(world),
---             which returns these four

local newRandom = require("spec.support.random").new

local shared = {}

local WALL = 16 -- px
local AFTERWARDS = 240 -- frames, after the last one that is driven

shared.FRICTION = 0.3
shared.FAR = 1e9 -- px, where there is no wall
shared.GROWTH = { 50, 100, 200, 400 } -- values of n for the growth of the time with n

--- Adds a static box that does not give way.
function shared.addWall(objects, x, y, width, height)
  objects[#objects + 1] = {
    group = "walls",
    x = x,
    y = y,
    width = width,
    height = height,
    static = true,
    friction = shared.FRICTION,
  }
end

--- Adds a square crate.
function shared.addCrate(objects, x, y, size)
  objects[#objects + 1] = {
    group = "crates",
    x = x,
    y = y,
    width = size,
    height = size,
    friction = shared.FRICTION,
  }
end

--- Adds `count` crates of different sizes, each in a cell of its own: rows from the floor up, as
--- many in each as fit into `width` px. The crates stand on the bottom of their cells.
---@param bottom number px, of the lowest row
---@param cell number px, the size of the largest; the smallest is three fifths of it
function shared.addHeap(objects, count, width, bottom, cell)
  local random, columns = newRandom(11), math.floor(width / cell)
  for i = 0, count - 1 do
    local row = math.floor(i / columns)
    local size = random:between(0.6 * cell, cell)
    local x = cell * (i - row * columns) + random:between(0, cell - size)
    shared.addCrate(objects, x, bottom - cell * row - size, size)
  end
end

--- Adds the four walls of a closed room from 0, 0 to width, height.
function shared.addRoom(objects, width, height)
  local tall = height + 2 * WALL
  shared.addWall(objects, -WALL, -WALL, WALL, tall)
  shared.addWall(objects, width, -WALL, WALL, tall)
  shared.addWall(objects, 0, -WALL, width, WALL)
  shared.addWall(objects, 0, height, width, WALL)
end

--- Fills in what all of these scenes share.
---@param scene table with `objects`, `driven` and `room`
---@return table scene
function shared.finish(scene)
  scene.gravity = scene.gravity or 800
  scene.warmUp, scene.steps = 0, scene.driven + AFTERWARDS
  scene.needs = scene.needs or { "upright" }
  return scene
end

return shared
