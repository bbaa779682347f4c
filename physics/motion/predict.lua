--- Predict: computes free flight and path (forces.lua, move.lua) of each awake body that has no
-- path yet.
--
-- The solver may wake others. These are computed then as if they had been awake from the start of
-- the step.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local begin = require(root .. ".motion.begin")
local forces = require(root .. ".motion.forces")
local move = require(root .. ".motion.move")

local predict = {}

--- Gives a path to each body in awakeList behind place `b.predicted`.
function predict.run(b, dt)
  local first, last = b.predicted + 1, b.awakeCount
  begin.run(b)
  forces.run(b, dt, first, last)
  move.run(b, dt, first, last)
  b.predicted = last
end

return predict
