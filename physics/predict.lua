--- Steps 3 to 5 for whoever is awake and has no path yet: forces, move, detect. Finding neighbours
--- can wake others, also in the middle of a step; they are then computed as if they had been awake
--- from its beginning.

local here = (...):match("^(.*)%.[^.]+$")
local begin = require(here .. ".begin")
local detect = require(here .. ".detect")
local forces = require(here .. ".forces")
local move = require(here .. ".move")

local predict = {}

--- Gives a path to everybody in awakeList behind place `b.predicted`.
function predict.run(b, dt)
  while b.predicted < b.awakeCount do
    local first, last = b.predicted + 1, b.awakeCount
    begin.run(b)
    forces.run(b, dt, first, last)
    move.run(b, dt, first, last)
    b.predicted = last
    detect.run(b, b.awakeList, first, last)
  end
end

return predict
