--- A box that friction with a lift lifts, if that is more than its weight.

local play = require("spec.support.play")
local scene = require("spec.support.scene")

describe("friction: a box that leans on a lift that rises", function()
  --    +--+----+ ^ 50
  --  > |  |    |      friction lifts with half of what it leans with,
  --    +--+    |      its weight is 600
  --   ====|    |
  local FLOOR = scene.maker("floors", { static = true, friction = 0 })("floor", -100, 100, 120, 4)
  local LIFT = scene.maker("lifts", { kinematic = true, vy = -50 })("lift", 20, 60, 20, 400)
  local LEVELS = { rate = { 30, 144 }, shift = { 0 } }
  play.row("with {ax} px/s² {what}", LEVELS, function(v)
    local box = scene.maker("boxes", { friction = 0.5, ax = v.ax })("box", 0, 80, 20, 20)
    return { gravity = 600, FLOOR, LIFT, box }
  end, { 1, "box.x == 0; box.y ~ 80 - way, 1e-9" }, {
    "ax, what, way",
    { 300, "stays on the floor", 0 },
    { 1100, "stays on the floor", 0 },
    { 1300, "is lifted by the difference, 50 px/s²", 25 },
    { 3000, "is as fast as the lift after 50 / 900 s", 50 - 50 * 50 / 900 / 2 },
  })
end)
