--- How far a step may move an object along an axis to part it from others that it overlaps, beyond
--- what its speed explains: half the object's size, or 8 px if that is more. (Out of what is
--- immovable it goes at once, as scenario 11 has it: that way comes on top, in
--- spec/support/motion.lua.)

local LEAST = 8 -- px
local SHARE = 0.5 -- of the larger side

--- Returns the largest motion in px that parting may add to one step, along each axis.
---@param width number px
---@param height number px
---@return number
return function(width, height)
  return math.max(SHARE * math.max(width, height), LEAST)
end
