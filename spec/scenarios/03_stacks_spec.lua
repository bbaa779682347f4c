--- What is piled up with care stays as it is, to the bit.

local overlap = require("spec.support.overlap")
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local TURNED = { turn = variants.TURNS }
local EVERYWHERE = variants.EVERYWHERE
local FLOOR = scene.maker("tiles", { static = true })("floor", 0, 200, 400, 32)
local MASSES = { 0.001, 1000, 1, 1e6, 0.5, 0.001, 3, 1e4, 0.01, 1e6 }

local function box(name, x, y, mass)
  return scene.maker("boxes", { mass = mass })(name, x, y, 16, 16)
end

--- A floor and `count` boxes over it, `pitch` (16) from top to top; masses bottom to top.
local function tower(v)
  local description = { FLOOR }
  for i = 1, v.count do
    local mass = v.masses and v.masses[i]
    description[i + 1] = box("box" .. i, 100, 200 - (v.pitch or 16) * i, mass)
  end
  return description
end

--- A pyramid of 4, 3, 2 and 1 boxes, `pitch` from left to left.
local function pyramid(v)
  local description = { FLOOR }
  for level = 1, 4 do
    for i = 1, 5 - level do
      local x = 100 + v.pitch * (i - 1) + v.pitch / 2 * (level - 1)
      description[#description + 1] = box("box" .. level .. i, x, 200 - 16 * level)
    end
  end
  return description
end

--- Nothing moves: at the places described from the first step on, no bit changes after it,
--- velocity 0, nothing overlaps.
local function stays(run, it, seconds)
  local deepest, places = overlap.checker(run.all), {}
  for name, view in pairs(run.named) do
    places[name] = { view.x, view.y }
  end
  for _ in run:steps(seconds) do
    for name, view in pairs(run.named) do
      local place = places[name]
      run:at(view, place[1], place[2])
      place[3], place[4] = place[3] or view.raw.x, place[4] or view.raw.y
      run:same("raw.x", view.raw.x, place[3])
      run:same("raw.y", view.raw.y, place[4])
      run:check(view == it.floor or view.vx == 0 and view.vy == 0, "%s moves", name)
    end
    local depth = deepest()
    run:check(depth <= 1e-9, "boxes overlap by %.3g", depth)
  end
end

--- Every box from the `first` on is exactly on the one below, the first on the floor.
local function flush(run, it, first)
  for i = first, it.count do
    local view = it["box" .. i]
    run:at(view, 100, 200 - 16 * (i + 1 - first))
    run:flush(view, i == first and it.floor or it["box" .. i - 1], "bottom")
    run:still(view)
  end
end

describe("mass and gravity: stacks", function()
  --   +--+
  --   +--+
  --   +--+   ten boxes, or twenty
  --   +--+
  --  ------
  local function stayTen(run, it)
    stays(run, it, it.seconds)
  end
  play.row("(3) of {count}, {what}, stay for {seconds} s", TURNED, tower, { stayTen }, {
    "count, what, seconds, masses, levels",
    { 10, "at every rate", 1, nil, EVERYWHERE },
    { 20, "all alike", 10 },
    { 10, "of very different mass", 10, MASSES },
  })
  play.row("(3) as a pyramid, {pitch} px from box to box, stay as drawn", TURNED, pyramid, {
    stayTen,
  }, { "pitch, seconds", { 16, 10 }, { 20, 10 }, { 17.3, 10 } })

  local LEVELS = { turn = variants.TURNS, shift = { 0, 1 / 3 } }
  play.row("(3) of twenty boxes begin twenty contacts and end none", LEVELS, tower, {
    "log = run:listenToWorld(); listen box1; listen box20",
    { 10, "log.ends == 0" },
    "log.begins == 20; box1 heard 2, 0; box20 heard 1, 0",
    "heard.box1.sides.bottom == 1; heard.box1.sides.top == 1; heard.box20.sides.bottom == 1",
    function(run, it)
      flush(run, it, 1)
    end,
  }, { "count", { 20 } })

  play.row("(3) of {count}, {what}, dropped, settle flush within 3 s", EVERYWHERE, tower, {
    function(run, it)
      local deepest = overlap.checker(run.all)
      for time in run:steps(4) do
        local depth = deepest()
        run:check(depth <= 1e-6, "boxes overlap by %.3g", depth)
        if time > 3 then
          flush(run, it, 1)
        end
      end
    end,
  }, {
    "count, what, pitch, masses, levels",
    { 10, "all alike", 24 },
    { 20, "all alike", 24 },
    { 10, "of very different mass", 24, MASSES, TURNED },
  })

  -- box 1 leaves the floor and box 2; box 2 meets the floor; the others stay on each other
  play.row("(3) of {count} without their lowest box land one box lower", EVERYWHERE, tower, {
    { 0.5 },
    { "log = run:listenToWorld(); listen box2; listen floor; world:remove(box1.raw)", 2 },
    function(run, it)
      flush(run, it, 2)
    end,
    "log.ends == 2; log.begins == 1; box2 heard 1, 1; floor heard 1, 1",
  }, { "count", { 10 }, { 20 } })
end)
