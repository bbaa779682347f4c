--- Pushing boxes along a floor, against a wall.

local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE = variants.EVERYWHERE
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

describe("vx and touching: pushing", function()
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

    scene.it(("(5) %d against a wall ends flush"):format(count), case[4], function(run)
      local named = run:build(row(count))
      local P, world = named.P, run:listenToWorld()
      for _ in run:steps(4, run:keep(P, 100)) do
        for _, view in pairs(named) do
          if not view.static then
            run:near(view.name .. ".y", view.y, 100)
          end
        end
      end
      checkEnd(run, named)
      run:same("contacts left: floor, each other, wall", world.begins - world.ends, 2 * count + 2)
      run:flush(named["box" .. count], named.wall, "right")
      for i = 1, count do
        run:flush(i == 1 and P or named["box" .. i - 1], named["box" .. i], "right")
      end
      for _ in run:steps(1, run:keep(P, 100)) do
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
  end

  --   +-+        +-+ -> <- +-+
  --   a row thrown together comes to rest without a gap
  scene.it("from both sides leaves the row flush", FEW, function(run)
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
