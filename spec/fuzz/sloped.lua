--- Makes games with slopes: those of case.lua, in which a part of what is static or kinematic, and
--- stays so, is a slope. Energy is not watched in them: what walks uphill keeps its velocity.

local case = require("spec.fuzz.case")
local newRandom = require("spec.support.random").new

local sloped = {}

local NAMES = { "left", "right", "topleft", "topright" }

-- Calls visit(act) for each act, also for those in callbacks.
local function eachAct(acts, visit)
  for _, act in ipairs(acts) do
    visit(act)
    if act[1] == "listen" then
      eachAct(act[4], visit)
    end
  end
end

--- Makes a game.
---@param seed integer
---@param steps integer
---@return table case as case.new
function sloped.new(seed, steps)
  local made, random, changing = case.new(seed, steps), newRandom(seed + 12345), {}
  local steep = newRandom(seed + 54321)
  eachAct(made.acts, function(act)
    if act[1] == "write" and (act[3].static ~= nil or act[3].kinematic ~= nil) then
      changing[act[2]] = true
    end
  end)
  eachAct(made.acts, function(act)
    local isNew = act[1] == "add" or act[1] == "insert"
    local object = isNew and act[4]
    if object and (object.static or object.kinematic) and not changing[act[2]] then
      local share = act[3] == "tiles" and 0.2 or act[3] == "walls" and 0.1 or 0.6
      object.slope = random:chance(share) and random:pick(NAMES) or nil
      if object.radius then
        object.slope = nil -- it is round
      end
    elseif object and not (object.static or object.kinematic) then
      object.constantSpeed = random:chance(0.2) or nil
      object.maxSlope = steep:chance(0.3) and steep:between(0, 3) or nil
    end
  end)
  made.closed = nil
  return made
end

return sloped
