--- The ground is dug: in every frame one tile of it goes and the one before it comes back. No
--- object is where that happens: it measures what it costs to find out which objects there are.
---
---     # #   # #  #
---   ################
---   ####### ########
---   ################

local TILE, COLUMNS, DEEP = 16, 200, 2 -- px, tiles in a row, rows that stay
local CRATES = 40

local function tile(n)
  local row = math.floor(n / COLUMNS)
  return {
    group = "tiles",
    x = TILE * (n - COLUMNS * row),
    y = TILE * row,
    width = TILE,
    height = TILE,
    static = true,
  }
end

local function build(tiles)
  local objects = {}
  for i = 0, CRATES - 1 do
    objects[i + 1] = { group = "crates", x = 70 * i, y = -TILE, width = TILE, height = TILE }
  end
  for n = 0, tiles - 1 do
    objects[#objects + 1] = tile(n)
  end
  local numberOf, last, dug = {}, #objects, nil
  for n = 0, tiles - 1 do
    numberOf[n] = CRATES + 1 + n
  end
  local first = DEEP * COLUMNS
  local function frame(world, step)
    if dug then
      world:add(tile(dug))
      last = last + 1
      numberOf[dug] = last
    end
    local k = step * 7919
    dug = first + k - (tiles - first) * math.floor(k / (tiles - first))
    world:remove(numberOf[dug])
    world:step(1 / 60)
  end
  return { gravity = 800, objects = objects, needs = { "upright" }, frame = frame }
end

return {
  {
    name = "dig",
    title = "one of n tiles goes, one comes",
    sizes = { 2000, 20000 },
    quick = 600,
    build = build,
  },
}
