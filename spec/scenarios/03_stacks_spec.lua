--- What is piled up with care stays as it is, to the bit.

local overlap = require("spec.support.overlap")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local TURNED = { turn = variants.TURNS }
local EVERYWHERE = variants.EVERYWHERE

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

--- Nothing moves for `seconds`: at the places described from the first step on, no bit changes
--- after it, velocity 0, nothing overlaps.
local function checkStays(run, description, seconds)
  local named = run:build(description)
  local deepest, places = overlap.checker(run.all), {}
  for _ in run:steps(seconds) do
    for _, entry in ipairs(description) do
      local view = named[entry[2].name]
      local place = places[view] or { view.raw.x, view.raw.y }
      places[view] = place
      run:at(view, entry[2].x, entry[2].y)
      run:same("raw.x", view.raw.x, place[1])
      run:same("raw.y", view.raw.y, place[2])
      if not entry[2].static then
        run:still(view)
      end
    end
    local depth = deepest()
    run:check(depth <= 1e-9, "boxes overlap by %.3g", depth)
  end
end

--- Every box from the `first` on is exactly on the one below, the first on the floor.
local function checkFlush(run, named, first, last)
  for i = first, last do
    local view = named["box" .. i]
    run:at(view, 100, 200 - 16 * (i + 1 - first))
    run:flush(view, i == first and named.floor or named["box" .. i - 1], "bottom")
    run:still(view)
  end
end

local MASSES = { 0.001, 1000, 1, 1e6, 0.5, 0.001, 3, 1e4, 0.01, 1e6 }

describe("mass and gravity: stacks", function()
  --   +--+
  --   +--+
  --   +--+   ten boxes, or twenty
  --   +--+
  --  ------
  for name, row in pairs({
    ["of ten boxes"] = { tower(10, 16), EVERYWHERE, 1 },
    ["of twenty boxes"] = { tower(20, 16), TURNED, 10 },
    ["of ten of very different mass"] = { tower(10, 16, MASSES), TURNED, 10 },
    ["as a pyramid, side by side"] = { pyramid(16), TURNED, 10 },
    ["as a pyramid, 20 px from box to box"] = { pyramid(20), TURNED, 10 },
    ["as a pyramid, 17.3 px from box to box"] = { pyramid(17.3), TURNED, 10 },
  }) do
    scene.it(("(3) %s stay as drawn for %d s"):format(name, row[3]), row[2], function(run)
      checkStays(run, row[1], row[3])
    end)
  end

  local LEVELS = { turn = variants.TURNS, shift = { 0, 1 / 3 } }
  scene.it("(3) of twenty boxes begin twenty contacts and end none", LEVELS, function(run)
    local named = run:build(tower(20, 16))
    local world, logs = run:listenToWorld(), {}
    for i = 1, 20 do
      logs[i] = run:listen(named["box" .. i])
    end
    run:play(10)
    run:same("begins", world.begins, 20)
    run:same("ends", world.ends, 0)
    for i = 1, 20 do
      run:same("begins at the bottom", logs[i].sides.bottom, 1)
      run:same("begins at the top", logs[i].sides.top, i < 20 and 1 or 0)
      run:same("begins", logs[i].begins, i < 20 and 2 or 1)
    end
    checkFlush(run, named, 1, 20)
  end)

  for _, row in ipairs({ { 10, EVERYWHERE }, { 20, EVERYWHERE }, { 10, TURNED, MASSES } }) do
    local count, masses = row[1], row[3]
    local title = ("(3) of %d%s, dropped with gaps of 8 px, settle within 3 s, flush"):format(
      count,
      masses and " of very different mass" or ""
    )
    scene.it(title, row[2], function(run)
      local named = run:build(tower(count, 24, masses))
      local deepest = overlap.checker(run.all)
      for time in run:steps(4) do
        local depth = deepest()
        run:check(depth <= 1e-6, "boxes overlap by %.3g", depth)
        if time > 3 then
          checkFlush(run, named, 1, count)
        end
      end
    end)
  end

  for _, count in ipairs({ 10, 20 }) do
    local title = ("(3) of %d without their lowest box land one box lower"):format(count)
    scene.it(title, EVERYWHERE, function(run)
      local named = run:build(tower(count, 16))
      run:play(0.5)
      local world = run:listenToWorld()
      local second, floor = run:listen(named.box2), run:listen(named.floor)
      run.world:remove(named.box1.raw)
      run:play(2)
      checkFlush(run, named, 2, count)
      -- box 1 leaves the floor and box 2; box 2 meets the floor; the others stay on each other
      run:same("ends", world.ends, 2)
      run:same("begins", world.begins, 1)
      run:same("ends of the second box", second.ends, 1)
      run:same("begins of the floor", floor.begins, 1)
    end)
  end
end)
