--- Pushing boxes along a floor, against a wall.

local play = require("spec.support.play")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE = variants.EVERYWHERE
local FEW = { rate = { 60, 144 }, turn = { 0, 1 }, shift = { 0, 1 / 3 } }
local row = play.row
local solid, box = scene.maker("tiles", { static = true }), scene.maker("boxes", {})

describe("vx and touching: pushing", function()
  --                                 |wall
  --   +-+  ->   +-+ +-+ +-+         |    the boxes from x = 80 on, the face of the wall at 200
  --   |P|       | | | | | |         |
  --   -------------------------------
  local function toWall(v)
    local floor, wall = solid("floor", -200, 116, 800, 32), solid("wall", 200, 0, 16, 116)
    local list = { floor, box("P", 20, 100, 16, 16), not v.isOpen and wall or nil }
    for i = 1, v.count do
      list[#list + 1] = box("box" .. i, 60 + 20 * i, 100, 16, 16)
    end
    return list
  end
  -- Fails unless P and the boxes stand flush at the wall.
  local function isFlush(run, count)
    local last = run.named.wall
    for i = count, 0, -1 do
      local view = i == 0 and run.named.P or run.named["box" .. i]
      run:at(view, 200 - 16 * (count - i + 1), 100)
      run:flush(view, last, "right")
      last = view
    end
    return true
  end
  local STILL = { "P still", "box1 still", "isFlush(run, count) == true", "P touches bottom right" }
  local function ends(keep)
    return { 1, keep = keep, STILL[1], STILL[2], STILL[3], STILL[4] }
  end
  play.row("(5) {count} against a wall ends flush", EVERYWHERE, toWall, {
    "log = run:listenToWorld()",
    { 4, keep = "P.vx = 100", "P.y ~ 100", "box1.y ~ 100" },
    "log.begins - log.ends == 2 * count + 2", -- floor, each other, wall
    ends("P.vx = 100"),
    ends(), -- released
  }, { "count, levels", { 1 }, { 2, FEW }, { 3 }, { 5, FEW } }, { isFlush = isFlush })

  --   +-+        +-+ -> <- +-+
  --   a row thrown together comes to rest without a gap
  row("from both sides leaves the row flush", FEW, function(v)
    local list = toWall(v)
    list[#list + 1] = box("Q", 200, 100, 16, 16)
    return list
  end, {
    { 5, keep = "P.vx, Q.vx = 100, -100" },
    "box1.x - P.x ~ 16; box2.x - box1.x ~ 16; box3.x - box2.x ~ 16; Q.x - box3.x ~ 16",
    "P.vx ~ 0; box1.vx ~ 0; box2.vx ~ 0; box3.vx ~ 0",
  }, { "count, isOpen", { 3, true } })
end)
