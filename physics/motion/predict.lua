--- Steps 3 and 4 for whatever is awake and has no path yet: zones, forces, move. Step 5, detect,
--- follows in `meet`, when paths are known better; it can wake others, which are computed then as
--- if they had been awake from the beginning of the step.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local begin = require(root .. ".motion.begin")
local forces = require(root .. ".motion.forces")
local move = require(root .. ".motion.move")
local zones = require(root .. ".motion.zones")

local predict = {}

--- Gives a path to everybody in awakeList behind place `b.predicted`.
function predict.run(b, dt)
  local first, last = b.predicted + 1, b.awakeCount
  begin.run(b)
  zones.run(b, dt, first, last)
  forces.run(b, dt, first, last)
  move.run(b, dt, first, last)
  b.predicted = last
end

return predict
