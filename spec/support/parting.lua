--- How far a step may move an object along an axis to part it from others that it overlaps, beyond
--- what its speed explains: the object's own size. (Out of what is immovable it goes at once, as
--- scenario 11 has it: that way comes on top, in spec/support/motion.lua.)

local SHARE = 1 -- of the larger side

--- Returns the largest motion in px that parting may add to one step, along each axis.
---@param width number px
---@param height number px
---@return number
return function(width, height)
  return SHARE * math.max(width, height)
end
