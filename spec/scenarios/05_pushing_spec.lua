--- Pushing boxes along a floor, against a wall.

local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE = { rate = variants.RATES, turn = variants.TURNS }
local FEW = { rate = { 60, 144 }, turn = { 0, 1 }, shift = { 0, 1 / 3 } }

--- A pusher at x = 20, `count` boxes 20 px apart from x = 80 on, a wall with its face at x = 200.
local function row(count)
  local description = {
    { "tiles", { x = -200, y = 116, width = 800, height = 32, static = true } },
    { "tiles", { name = "wall", x = 200, y = 0, width = 16, height = 116, static = true } },
    { "players", { name = "P", x = 20, y = 100, width = 16, height = 16 } },
  }
  for i = 1, count do
    local box = { name = "box" .. i, x = 60 + 20 * i, y = 100, width = 16, height = 16 }
    description[3 + i] = { "boxes", box }
  end
  return description
end

describe("pushing", function()
  --                                 |wall
  --   +-+  ->   +-+ +-+ +-+         |
  --   |P|       | | | | | |         |
  --   -------------------------------
  for _, case in ipairs({
    -- boxes, where P ends, where the boxes end
    { 1, 168, { 184 }, EVERYWHERE },
    { 2, 152, { 168, 184 }, FEW },
    { 3, 136, { 152, 168, 184 }, EVERYWHERE },
    { 5, 104, { 120, 136, 152, 168, 184 }, FEW },
  }) do
    local count, atP, ends = case[1], case[2], case[3]

    local function checkEnd(run, named)
      run:at(named.P, atP, 100)
      for i = 1, count do
        run:at(named["box" .. i], ends[i], 100)
      end
    end

    it(("(5) %d against a wall ends flush"):format(count), function()
      scene.each(case[4], function(run)
        local named = run:build(row(count))
        local P = named.P
        for _ in
          run:steps(4, function()
            P.vx = 100
          end)
        do
          for _, view in pairs(named) do
            if not view.static then
              run:near(view.name .. ".y", view.y, 100)
            end
          end
        end
        checkEnd(run, named)
        run:flush(named["box" .. count], named.wall, "right")
        for i = 1, count do
          run:flush(i == 1 and P or named["box" .. i - 1], named["box" .. i], "right")
        end
        for _ in
          run:steps(1, function()
            P.vx = 100
          end)
        do
          checkEnd(run, named)
          run:still(P)
          run:touches(P, "bottom", "right")
          run:check(P.touching.right == named.box1, "P should touch the first box on the right")
        end
        for _ in run:steps(1) do -- released
          checkEnd(run, named)
          for _, view in pairs(named) do
            run:still(view)
          end
        end
      end)
    end)
  end

  it("(5) a box that cannot be pushed stops P", function()
    scene.each(EVERYWHERE, function(run)
      local description = row(1)
      description[4][2].pushable = false
      local named = run:build(description)
      local log = run:listen(named.P)
      run:play(4, function()
        named.P.vx = 100
      end)
      run:at(named.P, 64, 100)
      run:at(named.box1, 80, 100)
      run:still(named.P)
      run:still(named.box1)
      run:flush(named.P, named.box1, "right")
      run:same("begins on the right", log.sides.right, 1)
      run:same("begins at the bottom", log.sides.bottom, 1)
      run:same("begins", log.begins, 2)
      run:same("ends", log.ends, 0)
    end)
  end)

  it("a box that cannot be pushed is stopped by a wall", function()
    scene.each(EVERYWHERE, function(run)
      local description = row(1)
      description[4][2].pushable = false
      description[4][2].vx = 100
      description[4][2].x = 150
      local named = run:build(description)
      run:play(2)
      run:at(named.box1, 184, 100)
      run:still(named.box1)
    end)
  end)

  --     +--+
  --     |U |    cannot be pushed
  --   +-+--+
  --   |  |
  --  ---------
  for _, pushable in ipairs({ true, false }) do
    local name = pushable and "a box on the floor" or "another such box"
    it("a box that cannot be pushed comes to rest on " .. name, function()
      scene.each(EVERYWHERE, function(run)
        local floor = { name = "floor", x = -200, y = 116, width = 800, height = 32, static = true }
        local low = { name = "low", x = 0, y = 100, width = 16, height = 16, pushable = pushable }
        local upper = { name = "U", x = 4, y = 50, width = 16, height = 16, pushable = false }
        local named = run:build({ { "tiles", floor }, { "boxes", low }, { "boxes", upper } })
        for _ in run:steps(1) do
          run:at(named.low, 0, 100)
        end
        run:at(named.U, 4, 84)
        run:flush(named.U, named.low, "bottom")
        run:still(named.U)
      end)
    end)
  end

  it("begins one contact a pair and ends none", function()
    scene.each(FEW, function(run)
      local named = run:build(row(3))
      local world = run:listenToWorld()
      run:play(6, function()
        named.P.vx = 100
      end)
      -- on the floor: 4, P and three boxes: 3, the wall: 1
      run:check(world.begins >= 8, "begins should be at least 8, is %d", world.begins)
      run:same("contacts left", world.begins - world.ends, 8)
    end)
  end)

  --   +-+        +-+ -> <- +-+
  --   a row thrown together comes to rest without a gap
  it("from both sides leaves the row flush", function()
    scene.each(FEW, function(run)
      local description = row(3)
      table.remove(description, 2)
      local other = { name = "Q", x = 200, y = 100, width = 16, height = 16 }
      description[#description + 1] = { "players", other }
      local named = run:build(description)
      run:play(5, function()
        named.P.vx, named.Q.vx = 100, -100
      end)
      local chain = { named.P, named.box1, named.box2, named.box3, named.Q }
      for i = 1, 4 do
        run:near("gap", chain[i + 1].x - chain[i].x - 16, 0)
        run:near("vx", chain[i].vx, 0)
      end
    end)
  end)
end)
