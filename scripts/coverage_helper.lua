-- Loaded by busted before the specs: marks the lines of the core that they run, and writes them
-- when the specs are over (scripts/coverage_marks.lua).

dofile("scripts/interpreter.lua")
local marks = require("scripts.coverage_marks")
require("busted").subscribe({ "exit" }, function()
  marks.write()
  return nil, true
end)
