--- 100 questions a frame in a level of 2000 tiles: rectangles, points, rays, the nearest object.
--- The game has put a quarter of what moves elsewhere since the step, so that queries must find
--- these in the game's tables. Only the questions are measured.

local newRandom = require("spec.support.random").new

local TILES, WIDE, SIZE = 2000, 100, 32 -- px
local EACH = 4 -- one of so many movers is put elsewhere
local FAR = 60 -- px
local QUESTIONS = 100

local function newTiles()
  local tiles = {}
  for n = 0, TILES - 1 do
    local row = math.floor(n / WIDE)
    tiles[n + 1] = {
      group = "tiles",
      x = SIZE * (n - row * WIDE),
      y = 6 * SIZE * row + 5 * SIZE,
      width = SIZE,
      height = SIZE,
      static = true,
    }
  end
  return tiles
end

local function build(count)
  local random, objects, points = newRandom(41), newTiles(), {}
  local width, height = WIDE * SIZE, 6 * SIZE * TILES / WIDE
  for n = 1, count do
    objects[TILES + n] = {
      group = n % 2 == 0 and "enemies" or "lifts",
      x = random:between(0, width),
      y = 6 * SIZE * random:integer(0, TILES / WIDE - 1) + random:between(0, 4 * SIZE),
      width = 20,
      height = 24,
      kinematic = n % 2 == 1,
    }
  end
  for n = 1, 2 * QUESTIONS, 2 do
    points[n], points[n + 1] = random:between(0, width), random:between(0, height)
  end
  local function frame(world)
    for n = 1, 2 * QUESTIONS, 2 do
      world:ask(n, points[n], points[n + 1])
    end
  end
  local function between(world, step)
    world:step(1 / 60)
    for n = EACH, count, EACH do
      local way = step % 2 == 0 and FAR or -FAR
      world:moveBy(TILES + n, way)
    end
  end
  return {
    gravity = 800,
    objects = objects,
    needs = { "questions" },
    frame = frame,
    between = between,
  }
end

return {
  {
    name = "asking",
    title = "100 questions a frame among 2000 tiles and n movers, a quarter of them moved by hand",
    sizes = { 200, 1000 },
    quick = 20,
    build = build,
  },
}
