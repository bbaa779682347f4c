-- Plays the scene of spec/support/everything.lua in the browser and prints its number, for
-- web/test.mjs. What it plays lies beside this file when it is packed (scripts/web.sh).
local everything = require("spec.support.everything")

function love.load()
  print("fold " .. everything.fold())
end
