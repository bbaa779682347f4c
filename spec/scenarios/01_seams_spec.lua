--- A row of tiles behaves like one long box: floor, wall or shaft.

local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE = variants.EVERYWHERE

local thing = scene.thing("players", { name = "body", x = 0, y = 76, width = 14, height = 24 })

--- Row 1a's floor: 60 tiles from x = 0 to 960, top at y = 100; with a body.
local function floorAnd(fields)
  return scene.tiles({ thing(fields) }, 60, 0, 100, 16, 16, 16, 0)
end

--- Row 1b's wall: 40 tiles from y = 0 to 640, left face at x = 100; with a body.
local function wallAnd(fields)
  return scene.tiles({ thing(fields) }, 40, 100, 0, 16, 16, 0, 16)
end

describe("vx and vy: seams", function()
  --   v = 200 ->
  --   +--+
  --   |  |
  --   +--+---+---+---+---+
  --   |  |   |   |   |   |   60 tiles
  describe("of a floor", function()
    scene.it("(1a) do not slow, lift or stop what walks over them", EVERYWHERE, function(run)
      local body = run:build(floorAnd({ vx = 200 })).body
      local log = run:listen(body)
      for time in run:steps(2) do
        run:at(body, 200 * time, 76)
        run:same("vx", body.vx, 200)
        run:same("vy", body.vy, 0)
        run:touches(body, "bottom")
      end
      -- 0 .. 414 lies on the tiles 0 to 25; the tiles 0 to 23 are left behind, the 24th
      -- (384 .. 400) ends exactly where the body begins
      run:same("begins", log.begins, 26)
      run:same("begins at the bottom", log.sides.bottom, 26)
      run:check(log.ends == 24 or log.ends == 25, "ends should be 24 or 25, is %d", log.ends)
    end)
  end)

  --            +---+
  --   vx = 100 |   |
  --     +--+-> +---+
  --     |  |   |   |   40 tiles
  --     +--+   +---+
  --      g     |   |
  describe("of a wall", function()
    scene.it("(1b) do not hold what slides down along them", EVERYWHERE, function(run)
      local body = run:build(wallAnd({ x = 86, y = 0 })).body
      for time in run:steps(1, run:keep(body, 100)) do
        run:at(body, 86, 400 * time * time)
        run:same("vx", body.vx, 0)
        run:near("vy", body.vy, 800 * time)
        run:touches(body, "right")
      end
    end)

    for _, start in ipairs({ 80, 79.3, 70 }) do
      local title = ("(1c) do not stop what jumps up along them, from x = %g"):format(start)
      scene.it(title, EVERYWHERE, function(run)
        local body = run:build(wallAnd({ x = start, y = 500, vy = -600 })).body
        local log = run:listen(body)
        for _ in run:steps(2 / 3, run:keep(body, 200)) do
          run:check(not body.touching.top, "touches a tile with its head")
          run:check(not body.touching.bottom, "stands on a tile")
        end
        run:at(body, 86, 500 - 600 * 2 / 3 + 400 * 4 / 9) -- y = 277.778
        run:same("begins on the right", log.sides.right, log.begins)
      end)
    end
  end)

  --    o        k = 1 … 100, each with its own speed
  --     \    ->
  --   +---+---+---+---+
  local LEVELS = { rate = { 60, "irregular" }, turn = { 0, 3 } }
  scene.it("(1d) take no speed from 100 that land", LEVELS, function(run)
    local description = floorAnd({ x = -500 })
    description.masks = { players = { players = false } }
    for k = 1, 100 do
      description[#description + 1] =
        thing({ name = "lander" .. k, x = 0.13 * k, y = 70, vx = 100 + 4 * k })
    end
    local named = run:build(description)
    run:play(1)
    for k = 1, 100 do
      local body = named["lander" .. k]
      run:same(("k = %d: vx"):format(k), body.vx, 100 + 4 * k)
      run:same(("k = %d: vy"):format(k), body.vy, 0)
      run:at(body, 0.13 * k + (100 + 4 * k), 76)
    end
  end)

  --   +---+  +---+
  --   |   |  |   |
  --   +---++-++---+
  --   |   || ||   |     the shaft is exactly as wide as the body
  --   +---++-++---+
  describe("of a shaft", function()
    local function shaftAnd(fields, top)
      fields.x = 100
      local list = scene.tiles({ thing(fields) }, 50, 84, top, 16, 16, 0, 16)
      return scene.tiles(list, 50, 100 + list[1][2].width, top, 16, 16, 0, 16)
    end

    for _, vx in ipairs({ 0, -100 }) do -- pressed against a side of it, or not
      local title = ("(1e) do not brake what falls through it, at vx = %g"):format(vx)
      scene.it(title, EVERYWHERE, function(run)
        local body = run:build(shaftAnd({ y = 0 }, 0)).body
        for time in run:steps(1, run:keep(body, vx)) do
          run:at(body, 100, 400 * time * time)
          run:same("vx", body.vx, 0)
          run:near("vy", body.vy, 800 * time)
        end
      end)
    end

    scene.it("let a 16 px box into a 16 px shaft", EVERYWHERE, function(run)
      local body = run:build(shaftAnd({ y = 20, width = 16, height = 16 }, 100)).body
      local log = run:listen(body)
      for time in run:steps(1) do
        run:at(body, 100, 20 + 400 * time * time)
      end
      run:same("begins", log.begins, 0)
    end)

    --   +---+---+---+---+---+
    --      v ->  the ceiling of a tunnel that begins here
    --   +-+    +---+---+---+
    --   +-+      exactly as high as the body
    --   +---+---+---+---+---+
    scene.it("let a 16 px box into a 16 px tunnel", EVERYWHERE, function(run)
      local description = floorAnd({ y = 84, width = 16, height = 16, vx = 150 })
      local body = run:build(scene.tiles(description, 20, 64, 68, 16, 16, 16, 0)).body
      for time in run:steps(2) do
        run:at(body, 150 * time, 84)
        run:same("vx", body.vx, 150)
        run:touches(body, "bottom")
      end
    end)
  end)
end)
