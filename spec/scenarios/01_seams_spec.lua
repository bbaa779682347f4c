--- A row of tiles behaves like one long box: floor, wall or shaft.

local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE = { rate = variants.RATES, turn = variants.TURNS }

--- Row 1a's floor: 60 tiles from x = 0 to 960, top at y = 100.
local function floorOfTiles()
  return scene.tiles({ gravity = 800 }, 60, 0, 100, 16, 16, 16, 0)
end

--- Row 1b's wall: 40 tiles from y = 0 to 640, left face at x = 100.
local function wallOfTiles()
  return scene.tiles({ gravity = 800 }, 40, 100, 0, 16, 16, 0, 16)
end

local function with(description, group, object)
  description[#description + 1] = { group, object }
  return description
end

describe("seams", function()
  --   v = 200 ->
  --   +--+
  --   |  |
  --   +--+---+---+---+---+
  --   |  |   |   |   |   |   60 tiles
  describe("of a floor", function()
    local function walker()
      return { name = "body", x = 0, y = 76, width = 14, height = 24, vx = 200 }
    end

    it("(1a) do not slow, lift or stop what walks over them", function()
      scene.each(EVERYWHERE, function(run)
        local body = run:build(with(floorOfTiles(), "players", walker())).body
        for time in run:steps(2) do
          run:at(body, 200 * time, 76)
          run:same("vx", body.vx, 200)
          run:same("vy", body.vy, 0)
          run:touches(body, "bottom")
        end
        run:near("x", body.x, 400)
      end)
    end)

    it("(1a) begin once for each tile, always at the bottom", function()
      scene.each(EVERYWHERE, function(run)
        local body = run:build(with(floorOfTiles(), "players", walker())).body
        local log = run:listen(body)
        run:play(2)
        -- 0 .. 414 lies on the tiles 0 to 25; the tiles 0 to 23 are left behind, the 24th
        -- (384 .. 400) ends exactly where the body begins
        run:same("begins", log.begins, 26)
        run:same("begins at the bottom", log.sides.bottom, 26)
        run:check(log.ends == 24 or log.ends == 25, "ends should be 24 or 25, is %d", log.ends)
      end)
    end)
  end)

  --            +---+
  --   vx = 100 |   |
  --     +--+-> +---+
  --     |  |   |   |   40 tiles
  --     +--+   +---+
  --      g     |   |
  describe("of a wall", function()
    it("(1b) do not hold what slides down along them", function()
      scene.each(EVERYWHERE, function(run)
        local body = { name = "body", x = 86, y = 0, width = 14, height = 24 }
        body = run:build(with(wallOfTiles(), "players", body)).body
        for time in
          run:steps(1, function()
            body.vx = 100
          end)
        do
          run:at(body, 86, 400 * time * time)
          run:same("vx", body.vx, 0)
          run:near("vy", body.vy, 800 * time)
          run:touches(body, "right")
        end
        run:at(body, 86, 400)
        run:near("vy", body.vy, 800)
      end)
    end)

    for _, start in ipairs({ 80, 79.3, 70 }) do
      it(("(1c) do not stop what jumps up along them, from x = %g"):format(start), function()
        scene.each(EVERYWHERE, function(run)
          local body = { name = "body", x = start, y = 500, width = 14, height = 24, vy = -600 }
          body = run:build(with(wallOfTiles(), "players", body)).body
          local log = run:listen(body)
          for _ in
            run:steps(2 / 3, function()
              body.vx = 200
            end)
          do
            run:check(not body.touching.top, "touches a tile with its head")
            run:check(not body.touching.bottom, "stands on a tile")
          end
          run:at(body, 86, 500 - 600 * 2 / 3 + 400 * 4 / 9) -- y = 277.778
          run:same("begins on the right", log.sides.right, log.begins)
        end)
      end)
    end
  end)

  --    o        k = 1 … 100, each with its own speed
  --     \    ->
  --   +---+---+---+---+
  describe("under a landing body", function()
    local function check(run, body, k)
      run:same(("k = %d: vx"):format(k), body.vx, 100 + 4 * k)
      run:same(("k = %d: vy"):format(k), body.vy, 0)
      run:near(("k = %d: y"):format(k), body.y, 76)
      run:near(("k = %d: x"):format(k), body.x, 0.13 * k + (100 + 4 * k))
    end

    local function lander(k)
      local name = "lander" .. k
      return { name = name, x = 0.13 * k, y = 70, width = 14, height = 24, vx = 100 + 4 * k }
    end

    it("(1d) take no speed from any of 100 landings #slow", function()
      -- one world for each landing is slow: fewer variants
      local levels = { shift = { 0, 0.1, 1 / 3, 100000.3 }, order = { "forward", "backward" } }
      scene.each(levels, function(run)
        for k = 1, 100 do
          local body = run:build(with(floorOfTiles(), "players", lander(k)))["lander" .. k]
          run:play(1)
          check(run, body, k)
        end
      end)
    end)

    it("(1d) take no speed from 100 that land together and pass through each other", function()
      local levels = { rate = { 60, "irregular" }, turn = { 0, 3 } }
      scene.each(levels, function(run)
        local description = floorOfTiles()
        description.masks = { players = { players = false } }
        for k = 1, 100 do
          with(description, "players", lander(k))
        end
        local named = run:build(description)
        run:play(1)
        for k = 1, 100 do
          check(run, named["lander" .. k], k)
        end
      end)
    end)
  end)

  --   +---+  +---+
  --   |   |  |   |
  --   +---++-++---+
  --   |   || ||   |     the shaft is exactly as wide as the body
  --   +---++-++---+
  describe("of a shaft", function()
    local function shaft(width, top)
      local list = scene.tiles({ gravity = 800 }, 50, 84, top, 16, 16, 0, 16)
      return scene.tiles(list, 50, 100 + width, top, 16, 16, 0, 16)
    end

    it("(1e) do not brake what falls through it", function()
      scene.each(EVERYWHERE, function(run)
        local body = { name = "body", x = 100, y = 0, width = 14, height = 24 }
        body = run:build(with(shaft(14, 0), "players", body)).body
        for time in run:steps(1) do
          run:at(body, 100, 400 * time * time)
          run:same("vx", body.vx, 0)
          run:near("vy", body.vy, 800 * time)
        end
        run:near("y", body.y, 400)
      end)
    end)

    it("(1e) do not brake what presses against a side of it", function()
      scene.each(EVERYWHERE, function(run)
        local body = { name = "body", x = 100, y = 0, width = 14, height = 24 }
        body = run:build(with(shaft(14, 0), "players", body)).body
        for time in
          run:steps(1, function()
            body.vx = -100
          end)
        do
          run:at(body, 100, 400 * time * time)
          run:near("vy", body.vy, 800 * time)
        end
      end)
    end)

    it("let a 16 px box into a 16 px shaft", function()
      scene.each(EVERYWHERE, function(run)
        local body = { name = "body", x = 100, y = 20, width = 16, height = 16 }
        local log = run:listen(run:build(with(shaft(16, 100), "players", body)).body)
        for time in run:steps(1) do
          run:at(run.named.body, 100, 20 + 400 * time * time)
        end
        run:same("begins", log.begins, 0)
      end)
    end)

    --   +---+---+---+---+---+
    --      v ->  the ceiling of a tunnel that begins here
    --   +-+    +---+---+---+
    --   +-+      exactly as high as the body
    --   +---+---+---+---+---+
    it("let a 16 px box into a 16 px tunnel", function()
      scene.each(EVERYWHERE, function(run)
        local description = scene.tiles({ gravity = 800 }, 30, 0, 100, 16, 16, 16, 0)
        scene.tiles(description, 20, 64, 68, 16, 16, 16, 0)
        local body = { name = "body", x = 0, y = 84, width = 16, height = 16, vx = 150 }
        body = run:build(with(description, "players", body)).body
        for time in run:steps(2) do
          run:at(body, 150 * time, 84)
          run:same("vx", body.vx, 150)
          run:touches(body, "bottom")
        end
      end)
    end)
  end)
end)
