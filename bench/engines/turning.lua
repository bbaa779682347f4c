--- love.physics as it comes: its boxes turn, and fall over. What a game pays that wants crates to
--- lie about and has not read on.

local lovePhysics = require("bench.engines.love")

local turning = {
  needsLove = true,
  isTurning = true,
  lacks = {
    questions = lovePhysics.lacks.questions,
    state = lovePhysics.lacks.state,
    sizes = lovePhysics.lacks.sizes,
    zones = lovePhysics.lacks.zones,
    upright = "its boxes fall over",
  },
}

function turning.new(scene)
  return lovePhysics.new(scene, true)
end

return turning
