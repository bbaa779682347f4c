--- What is piled up with care stays as it is, to the bit.

local overlap = require("spec.support.overlap")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local TURNED = { turn = variants.TURNS }
local EVERYWHERE = { rate = variants.RATES, turn = variants.TURNS }

local FLOOR = { name = "floor", x = 0, y = 200, width = 400, height = 32, static = true }

--- A floor and `count` boxes over it, `pitch` from top to top.
---@param masses number[]? masses, bottom to top
local function tower(count, pitch, masses)
  local description = { { "tiles", FLOOR } }
  for i = 1, count do
    local box = { name = "box" .. i, x = 100, y = 200 - pitch * i, width = 16, height = 16 }
    box.mass = masses and masses[i]
    description[i + 1] = { "boxes", box }
  end
  return description
end

--- A pyramid of 4, 3, 2 and 1 boxes, `pitch` from left to left.
local function pyramid(pitch)
  local description = { { "tiles", FLOOR } }
  for row = 1, 4 do
    for i = 1, 5 - row do
      local x = 100 + pitch * (i - 1) + pitch / 2 * (row - 1)
      local name = "box" .. row .. i
      local box = { name = name, x = x, y = 200 - 16 * row, width = 16, height = 16 }
      description[#description + 1] = { "boxes", box }
    end
  end
  return description
end

--- Places of all boxes, to the bit.
local function placesOf(named)
  local places = {}
  for name, view in pairs(named) do
    places[name] = { view.raw.x, view.raw.y }
  end
  return places
end

local function checkPlaces(run, named, places)
  for name, view in pairs(named) do
    run:same(name .. ".raw.x", view.raw.x, places[name][1])
    run:same(name .. ".raw.y", view.raw.y, places[name][2])
  end
end

--- Nothing moves for `seconds`: at the places described from the first step on, no bit changes
--- after it, velocity 0, nothing overlaps.
local function checkStays(run, description, seconds)
  local named = run:build(description)
  local deepest = overlap.checker(run.all)
  local places
  for _ in run:steps(seconds) do
    for _, entry in ipairs(description) do
      if not places then
        run:at(named[entry[2].name], entry[2].x, entry[2].y)
      end
      if not entry[2].static then
        run:still(named[entry[2].name])
      end
    end
    places = places or placesOf(named)
    checkPlaces(run, named, places)
    local depth = deepest()
    run:check(depth <= 1e-9, "boxes overlap by %.3g", depth)
  end
end

--- Every box is exactly on the one below.
local function checkFlush(run, named, first, last)
  for i = first, last do
    local below = i == first and named.floor or named["box" .. i - 1]
    run:flush(named["box" .. i], below, "bottom")
    run:still(named["box" .. i])
  end
end

describe("stacks", function()
  --   +--+
  --   +--+
  --   +--+   ten boxes
  --   +--+
  --  ------
  it("(3) of ten boxes stand still for 10 s", function()
    scene.each(TURNED, function(run)
      checkStays(run, tower(10, 16), 10)
    end)
  end)

  it("(3) of ten boxes stand still at any frame rate", function()
    scene.each(EVERYWHERE, function(run)
      checkStays(run, tower(10, 16), 1)
    end)
  end)

  for _, count in ipairs({ 10, 20 }) do
    it(("(3) of %d boxes begin %d contacts and end none"):format(count, count), function()
      scene.each({ turn = variants.TURNS, shift = { 0, 1 / 3 } }, function(run)
        local named = run:build(tower(count, 16))
        local world = run:listenToWorld()
        local logs = {}
        for i = 1, count do
          logs[i] = run:listen(named["box" .. i])
        end
        run:play(10)
        run:same("begins", world.begins, count)
        run:same("ends", world.ends, 0)
        for i = 1, count do
          run:same("begins at the bottom", logs[i].sides.bottom, 1)
          run:same("begins at the top", logs[i].sides.top, i < count and 1 or 0)
          run:same("begins", logs[i].begins, i < count and 2 or 1)
          run:same("ends", logs[i].ends, 0)
        end
        checkFlush(run, named, 1, count)
      end)
    end)
  end

  it("(3) of twenty boxes stand still for 10 s", function()
    scene.each(TURNED, function(run)
      checkStays(run, tower(20, 16), 10)
    end)
  end)

  --      +--+
  --    +--++--+
  --   +--++--++--+
  --  +--++--++--++--+
  for _, pitch in ipairs({ 16, 20, 17.3 }) do
    it(("(3) as a pyramid, %g px from box to box, stay as drawn"):format(pitch), function()
      scene.each(TURNED, function(run)
        checkStays(run, pyramid(pitch), 10)
      end)
    end)
  end

  it("of boxes of very different mass stand still", function()
    local masses = { 0.001, 1000, 1, 1e6, 0.5, 0.001, 3, 1e4, 0.01, 1e6 }
    scene.each(TURNED, function(run)
      checkStays(run, tower(10, 16, masses), 10)
    end)
  end)

  for _, count in ipairs({ 10, 20 }) do
    it(("(3) of %d dropped with gaps of 8 px settle within 3 s, flush"):format(count), function()
      scene.each(EVERYWHERE, function(run)
        local named = run:build(tower(count, 24))
        local deepest = overlap.checker(run.all)
        for _ in run:steps(3) do
          local depth = deepest()
          run:check(depth <= 1e-6, "boxes overlap by %.3g", depth)
        end
        for _ in run:steps(1) do
          for i = 1, count do
            run:at(named["box" .. i], 100, 200 - 16 * i)
          end
          checkFlush(run, named, 1, count)
        end
      end)
    end)
  end

  it("of boxes of very different mass, dropped, settle exactly flush", function()
    local masses = { 0.001, 1000, 1, 1e6, 0.5, 0.001, 3, 1e4, 0.01, 1e6 }
    scene.each(TURNED, function(run)
      local named = run:build(tower(10, 24, masses))
      run:play(3)
      for _ in run:steps(1) do
        for i = 1, 10 do
          run:at(named["box" .. i], 100, 200 - 16 * i)
        end
        checkFlush(run, named, 1, 10)
      end
    end)
  end)

  for _, count in ipairs({ 10, 20 }) do
    it(("(3) of %d without their lowest box land one box lower"):format(count), function()
      scene.each(EVERYWHERE, function(run)
        local named = run:build(tower(count, 16))
        run:play(0.5)
        local world = run:listenToWorld()
        local second = run:listen(named.box2)
        local floor = run:listen(named.floor)
        run.world:remove(named.box1.raw)
        run:play(2)
        for i = 2, count do
          run:at(named["box" .. i], 100, 200 - 16 * (i - 1))
        end
        for i = 2, count do
          run:flush(named["box" .. i], i == 2 and named.floor or named["box" .. i - 1], "bottom")
          run:still(named["box" .. i])
        end
        -- box 1 leaves the floor and box 2; box 2 meets the floor; the others stay on each other
        run:same("ends", world.ends, 2)
        run:same("begins", world.begins, 1)
        run:same("ends of the second box", second.ends, 1)
        run:same("begins of the floor", floor.begins, 1)
      end)
    end)
  end
end)
