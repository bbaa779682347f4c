--- Tiles of plain arrays: what of them stands in the world, digging and building, coming and going.

local effort = require("spec.support.effort")
local garbage = require("spec.support.garbage")
local costOf = require("spec.support.instructions")
local physics = require("physics")
local random = require("spec.support.random")
local small = require("spec.support.small")
local tiled = require("spec.support.tiled")

local DT = 1 / 60

--- The objects of a group, "x y width height; …".
local function boxes(world, group)
  return table.concat(tiled.boxes(world, group or "tiles"), "; ")
end

local function newWorld()
  return physics.newWorld({ gravity = 800 })
end

--- Adds tiles of 10 px from a picture to a new world.
local function add(rows, options, columns, size)
  local world = newWorld()
  return world:addTiles("tiles", rows, columns, size or 10, options), world
end

local run = small.run

describe("world:addTiles", function()
  -- The same level in all forms; other sizes and places; what is solid; what merges.
  --     1 . . .
  --     1 . . 1
  --     1 1 1 1
  local LEVEL = "0 0 10 20; 30 10 10 10; 0 20 40 10"
  local TOP, LEFT = { fields = { oneWay = "top" } }, { fields = { oneWay = "left" } }
  local OTHER = { solid = { a = true, b = {}, c = { friction = 1 } } }
  local ZERO, NOT = { [0] = true, [2] = true }, { ["."] = true, ["#"] = false }
  local APART = "0 0 10 10; 10 0 10 10"
  for _, row in ipairs({
    { "one list, row by row", { 1, 0, 0, 0, 1, 0, 0, 1, 1, 1, 1, 1 }, LEVEL, columns = 4 },
    { "rows, which may be short", { { 1 }, { 1, false, nil, 1 }, { 1, 1, 1, 1 } }, LEVEL },
    { "rows of so many", { { 1 }, { 1, 0, 0, 1 }, { 1, 1, 1, 1 } }, LEVEL, columns = 4 },
    { "texts", { "#", "#. #", "####" }, LEVEL },
    { "any size and place", { "##" }, "-3 0.25 16 5", { x = -3, y = 0.25 }, size = { 8, 5 } },
    { "none at all", {}, "", columns = 4 },
    { "values that are solid", { "#~.", "#~." }, "20 0 10 20", { solid = NOT } },
    { "no value that is", { "#" }, "", { solid = {} } },
    { "zeros", { 1, 2, 0 }, "10 0 20 10", { solid = ZERO }, columns = 3 },
    { "those that merge in rows and columns", { "##", "##" }, "0 0 20 20" },
    { "not with merge = false", { "##" }, APART, { merge = false } },
    { "no sensors", { "##" }, APART, { fields = { sensor = true } } },
    { "sensors that say so", { "##" }, "0 0 20 10", { fields = { sensor = true, merge = true } } },
    { "nothing that moves", { "##" }, APART, { fields = { static = false } } },
    { "a one-way top only along it", { "##", "##" }, "0 0 20 10; 0 10 20 10", TOP },
    { "a one-way left only along it", { "##", "##" }, "0 0 10 20; 10 0 10 20", LEFT },
    { "equal values, not others", { "abc" }, "0 0 20 10; 20 0 10 10", OTHER },
  }) do
    it("takes " .. row[1], function()
      local tiles, world = add(row[2], row[4], row.columns, row.size)
      assert.equal(row[3], boxes(world))
      assert.truthy(world.objects.tiles)
      assert.equal(#world.objects.tiles, tiles.rectangles)
    end)
  end

  it("tells of the tiles and of each object where it is", function()
    local tiles, world = add({ "ab", "..", ".b" }, { x = -3, y = 0.25 }, nil, { 8, 5 })
    assert.same({ -3, 0.25, 8, 5 }, { tiles.x, tiles.y, tiles.tileWidth, tiles.tileHeight })
    assert.same({ 1, 1, 2, 3 }, { tiles.firstColumn, tiles.firstRow, tiles.columns, tiles.rows })
    assert.same({ world, 3, 2 }, { tiles.world, tiles.tiles, tiles.rectangles })
    local first, second = world.objects.tiles[1].tile, world.objects.tiles[2].tile
    assert.same({ 1, 1, 2, 1 }, { first.column, first.row, first.columns, first.rows })
    assert.same({ 2, 3, 1, 1 }, { second.column, second.row, second.columns, second.rows })
    assert.is_nil(first.value) -- two of them
    local _, other = add({ "aa" })
    assert.equal("a", other.objects.tiles[1].tile.value)
    assert.equal(tiles, first.tiles)
  end)

  it("gives values fields, and a group, shared with the game", function()
    local owner = { name = "the game's" }
    owner.itself = owner
    local _, world = add({ "#=~m" }, {
      fields = { friction = 0.5, owner = owner },
      solid = {
        ["#"] = true,
        ["="] = { oneWay = true, friction = 0.1 },
        ["~"] = { sensor = true, group = "water" },
        m = { kinematic = true, merge = true },
      },
    })
    local list, water = world.objects.tiles, world.objects.water[1]
    local ground, ledge, mover = list[1], list[2], list[3]
    assert.same({ 0.5, true, nil }, { ground.friction, ground.static, ground.oneWay })
    assert.same({ 0.1, "top" }, { ledge.friction, ledge.oneWay })
    assert.equal(owner, ground.owner) -- the very same table
    assert.same(
      { true, true, nil, nil },
      { water.sensor, mover.kinematic, mover.static, mover.merge }
    )
  end)

  -- Changing --------------------------------------------------------------------------------------

  it("digs one cell out of its rectangle, and leaves everything else untouched", function()
    --- x is dug out:     #####      #####
    ---                   #####  ->  ##x##
    ---                   #####      #####
    local tiles, world = add({ "#####", "#####", "#####" })
    assert.is_true(tiles:setTile(3, 2, 0))
    assert.equal("0 0 50 10; 0 20 50 10; 0 10 20 10; 30 10 20 10", boxes(world))
    assert.same({ 14, 4, 0 }, { tiles.tiles, tiles.rectangles, tiles:getTile(3, 2) })
    tiles, world = add({ "##.##", "##.##", "....." })
    local left = world.objects.tiles[1]
    tiles:setTile(1, 3, "#")
    tiles:setTile(1, 3, ".")
    tiles:setTile(5, 1, ".")
    assert.equal(left, world.objects.tiles[1])
    assert.equal("0 0 20 20; 30 10 20 10; 30 0 10 10", boxes(world))
  end)

  it("says whether anything has changed", function()
    local tiles, world = add({ "#a." })
    local before = world.objects.tiles[1]
    assert.same({ false, true }, { tiles:setTile(1, 1, "#"), tiles:setTile(1, 1, "a") })
    assert.equal("a", tiles:getTile(1, 1))
    assert.equal(before, world.objects.tiles[1]) -- equal tiles, whatever they are called
    assert.is_false(tiles:setTile(3, 1, "."))
  end)

  it("lets what stood there fall, also in a callback, and holds what comes then", function()
    local tiles, world = add({ "....", "....", "####", "####" })
    local box = world:add("boxes", { x = 12, y = 12, width = 6, height = 8 })
    run(world, 60)
    assert.same({ 12, 0 }, { box.y, box.vy })
    tiles:setTile(2, 3, 0)
    run(world, 60)
    assert.equal(22, box.y) -- in the hole
    tiles:setTile(2, 4, 0)
    run(world, 1)
    tiles:setTile(2, 4, "#")
    run(world, 10)
    assert.is_true(box.y + box.height <= 30 + 1e-6)
    function box.onBegin(self)
      local column, row = tiles:cellAt(self.x, self.y + self.height + 1)
      tiles:setTile(column, row, 0)
    end
    box.y = 5
    run(world, 60)
    assert.is_true(box.y > 60)
  end)

  it("knows the cell at a point", function()
    local tiles = add({ "##", "##" }, { x = 100, y = -5 })
    for _, row in ipairs({
      { 100, -5, 1, 1 },
      { 109.9, 4.9, 1, 1 },
      { 110, 5, 2, 2 },
      { 99.9, 0 },
      { 120, 0 },
      { 105, 15 },
      { 1e99, 0 },
    }) do
      assert.same({ row[3], row[4] }, { tiles:cellAt(row[1], row[2]) })
    end
  end)

  it("moves if all of it is kinematic, and is dug and built on where it is", function()
    local tiles, world = add({ "####", ".##." }, { fields = { kinematic = true, merge = true } })
    for _, part in ipairs(world.objects.tiles) do
      part.vx, part.vy = 60, -30
    end
    run(world, 60)
    assert.equal("60 -30 40 10; 70 -20 20 10", boxes(world))
    assert.same({ 2, 1 }, { tiles:cellAt(75, -25) })
    assert.is_nil(tiles:cellAt(5, 5))
    tiles:setTile(2, 1, 0)
    tiles:setTile(4, 2, "#")
    run(world, 60)
    assert.equal("140 -60 20 10; 120 -60 10 10; 130 -50 30 10", boxes(world))
    world:remove(world.objects.tiles[1])
    assert.same({ 1, 1 }, { tiles:cellAt(125, -55) })
    tiles:unload()
    assert.same({ 1, 1 }, { tiles:cellAt(125, -55) })
    tiles:load()
    assert.equal("120 -60 10 10; 130 -50 30 10", boxes(world))
  end)

  it("unload() keeps the places of crates, which move by themselves, and shifts them", function()
    local world = physics.newWorld()
    local solid = { c = { static = false } }
    local tiles = world:addTiles("crates", { "c.c" }, nil, 16, { solid = solid })
    local crates = world.objects.crates
    crates[1].vx = -60
    run(world, 60)
    tiles:unload()
    world:shift(100, 0)
    tiles:load()
    assert.is_true(math.abs(crates[1].x - 40) < 1e-9)
    assert.equal(132, crates[2].x)
  end)

  -- Returns what digging cells of one row costs in so many rows, before the first update and after
  -- it, what the update costs after that beyond an idle one, what it costs to unload a row of all,
  -- and to dig when all are loaded again.
  local function costsOf(rows)
    local picture = {}
    for row = 1, rows do
      picture[row] = ("##."):rep(20)
    end
    local tiles, world = add(picture, { fields = { oneWay = "top" } })
    local function update()
      world:update(DT)
    end
    local function digEarly()
      for column = 1, 59 do
        tiles:setTile(column, rows - 1, 0)
      end
    end
    local early = costOf(digEarly)
    run(world, 2)
    local function dig()
      for column = 1, 59 do
        tiles:setTile(column, rows / 2, 0)
        tiles:setTile(column, 3, "#")
      end
      for column = 1, 59 do -- of which some have taken the places of those before
        tiles:setTile(column, rows, 0)
      end
    end
    local idle, digging = costOf(update), costOf(dig)
    local updating = costOf(update) - idle
    local all = costOf(function()
      tiles:unload()
    end)
    for column = 1, 59 do
      tiles:setTile(column, rows - 1, "#")
    end
    tiles:load()
    return { digging, updating, all / rows, early, costOf(digEarly) }
  end

  it("digs and comes and goes at a cost that does not depend on the size of its group", function()
    local few, many = costsOf(20), costsOf(80)
    for n, cost in ipairs(few) do
      assert(many[n] < 1.25 * cost + 2, ("%d: %g, %g"):format(n, cost, many[n]))
    end
  end)

  -- Random digging --------------------------------------------------------------------------------

  -- Each cell of the picture is covered by one object of its own kind, an empty one by none.
  local function checkCover(tiles, world, picture)
    local covered, solid = {}, 0
    for _, object in ipairs(world.objects.tiles) do
      local place = object.tile
      local x, y = (place.column - 1) * 10, (place.row - 1) * 10
      assert.same({ x, y }, { object.x, object.y })
      assert.same({ place.columns * 10, place.rows * 10 }, { object.width, object.height })
      for row = place.row, place.row + place.rows - 1 do
        for column = place.column, place.column + place.columns - 1 do
          local cell = row * 1000 + column
          assert.is_nil(covered[cell])
          covered[cell] = object.oneWay and "=" or object.friction and "i" or "#"
        end
      end
    end
    for row, line in ipairs(picture) do
      for column, value in ipairs(line) do
        local isSolid, found = value ~= ".", tiles:getTile(column, row)
        assert.equal(isSolid and value or nil, covered[row * 1000 + column])
        assert.equal(isSolid and value or found, found)
        solid = solid + (isSolid and 1 or 0)
      end
    end
    assert.same({ solid, #world.objects.tiles }, { tiles.tiles, tiles.rectangles })
  end

  local SOLID = { ["#"] = true, i = { friction = 0 }, ["="] = { oneWay = "top" } }
  -- (Without friction of their own: a walker over two of different friction rubs on the one that is
  -- first in order, and what was dug out and built again is last.)
  local ALIKE = { ["#"] = true, i = true, ["="] = { oneWay = "top" } }

  local function newPicture(generator, columns, rows)
    local picture = {}
    for row = 1, rows do
      picture[row] = {}
      for column = 1, columns do
        picture[row][column] = generator:pick({ "#", "#", "#", "i", "=", "." })
      end
    end
    return picture
  end

  for seed = 1, effort.share(12, 4) do
    it("covers each cell once, however it is dug, seed " .. seed, function()
      local generator = random.new(seed * 13)
      local columns, rows = generator:integer(1, 14), generator:integer(1, 10)
      local picture = newPicture(generator, columns, rows)
      local tiles, world = add(picture, { solid = SOLID })
      local saved, savedPicture
      for turn = 1, 120 do
        local column, row = generator:integer(1, columns), generator:integer(1, rows)
        local value = generator:pick({ "#", "#", "i", "=", "." })
        assert.equal(picture[row][column] ~= value, tiles:setTile(column, row, value))
        picture[row][column] = value
        if generator:chance(0.05) then
          world:update(DT)
        end
        if turn == 50 then
          saved, savedPicture = world:save(), small.copy(picture)
        elseif turn == 75 then
          tiles:unload() -- it is dug meanwhile
        elseif turn == 79 then
          tiles:load()
        elseif turn == 80 then
          world:restore(saved)
          picture = savedPicture
        end
        if turn % 10 == 0 or turn == 81 then
          checkCover(tiles, world, picture)
        end
      end
    end)

    it("what walks there cannot tell how it was dug, seed " .. seed, function()
      local generator = random.new(seed * 17)
      local picture = newPicture(generator, 30, 12)
      local tiles, world = add(picture, { solid = ALIKE })
      for _ = 1, 150 do
        local column, row = generator:integer(1, 30), generator:integer(1, 12)
        local value = generator:pick({ "#", ".", ".", "=" })
        picture[row][column] = value
        tiles:setTile(column, row, value)
      end
      local _, whole = add(picture, { solid = ALIKE, merge = false })
      local walkers, twins = {}, {}
      local function newWalker(i)
        return { x = i * 31, y = -20, width = 5 + i, height = 6, friction = 0.2, nudge = i % 3 }
      end
      for i = 1, 8 do
        walkers[i] = world:add("walkers", newWalker(i))
        twins[i] = whole:add("walkers", newWalker(i))
      end
      for _ = 1, effort.share(300, 120) do
        for i = 1, 8 do
          if generator:chance(0.1) then
            local vx = generator:integer(-1, 1) * 90
            walkers[i].vx, twins[i].vx = vx, vx
          end
          assert.equal(not twins[i].touching.bottom, not walkers[i].touching.bottom)
        end
        world:update(DT)
        whole:update(DT)
        for i = 1, 8 do
          assert.same({ twins[i].x, twins[i].y }, { walkers[i].x, walkers[i].y })
        end
      end
    end)
  end

  -- Coming and going ------------------------------------------------------------------------------

  it("comes and goes, in order, without what is not its own or was removed", function()
    local tiles, world = add({ "#.#.#" })
    tiles:unload()
    assert.equal("", boxes(world))
    tiles:load()
    tiles:load()
    assert.equal("0 0 10 10; 20 0 10 10; 40 0 10 10", boxes(world))
    local other = world:add("tiles", { x = 99, y = 0, width = 5, height = 5, static = true })
    world:update(DT)
    local state = world:save()
    tiles:unload()
    tiles:unload()
    assert.same({ { other }, 3 }, { world.objects.tiles, tiles.rectangles })
    world:restore(state)
    assert.equal("0 0 10 10; 20 0 10 10; 40 0 10 10; 99 0 5 5", boxes(world))
    world:remove(world.objects.tiles[2])
    tiles:unload()
    assert.same({ other, 2 }, { world.objects.tiles[1], tiles.rectangles })
    tiles:load()
    assert.equal("99 0 5 5; 0 0 10 10; 40 0 10 10", boxes(world))
    world:update(DT)
    assert.equal(3, world.stats.objects)
    world:restore(state)
    tiles:unload()
    tiles:load()
    assert.same({ 4, 3 }, { #world.objects.tiles, tiles.rectangles })
  end)

  it("can be changed while it waits, and moves with its world", function()
    local tiles, world = add({ "#.#.#", ".#.#." })
    tiles:unload()
    tiles:setTile(5, 1, 0)
    tiles:setTile(1, 1, 0)
    tiles:setTile(2, 1, "#")
    assert.equal("", boxes(world))
    tiles:load()
    assert.equal("10 0 20 10; 10 10 10 10; 30 10 10 10", boxes(world))
    world.objects.tiles[1].x = 500 -- (it goes back to its cells)
    tiles:unload()
    tiles:setTile(4, 2, 0)
    world:shift(100, -50)
    tiles:load()
    assert.equal("110 -50 20 10; 110 -40 10 10", boxes(world))
    assert.same({ 2, 1 }, { tiles:cellAt(110, -50) })
  end)

  it("keeps no memory of what was dug and built a thousand times", function()
    local tiles, world = add({ "##########", "##########", "##########" })
    world:update(DT)
    local kept = garbage.kept(function(i)
      tiles:setTile(i % 10 + 1, i % 3 + 1, i % 2 == 0 and "#" or 0)
      world:update(DT)
    end, 900, 1000)
    assert.is_true(kept < 1000, kept .. " bytes")
  end)
end)
