--- Crushed: pressed between two that cannot give way, on one axis.
--
-- The object stays where it overlaps its neighbours the least (see settle), and is free again as
-- soon as there is room. How it came there is remembered with the pair (`wedged`), so that it leaves
-- along the same axis and is never squeezed out sideways.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local events = require(root .. ".contacts.events")

local crush = {}

--- Notes what is squeezed along an axis, and between which two.
function crush.note(b, axis)
  local list, squeezed, crushed = b.contacts[axis], b.squeezed, b.crushed
  local crushLow, crushHigh = b.crushLow, b.crushHigh
  for c = 1, list.count do
    local kl, kh = list.low[c], list.high[c]
    if squeezed[kl] ~= 0 and b.pressed[list.pair[c]] == 1 then
      crushHigh[kl] = (kh - axis) * 0.5
    end
    if squeezed[kh] ~= 0 and b.pressed[list.pair[c]] == 1 then
      crushLow[kh] = (kl - axis) * 0.5
    end
  end
  for n = 1, b.awakeCount do
    local k = 2 * b.awakeList[n] + axis
    if squeezed[k] ~= 0 then
      crushed[k], b.hasCrushed = true, true
    end
  end
end

--- Tells that an object has begun to be crushed in this step.
function crush.tell(b, i)
  for axis = 0, 1 do
    local k = 2 * i + axis
    if b.crushed[k] and not b.wasCrushed[k] then
      events.crush(b, i, b.crushLow[k], b.crushHigh[k], axis == 0 and "x" or "y")
    end
    b.wasCrushed[k] = b.crushed[k]
  end
end

return crush
