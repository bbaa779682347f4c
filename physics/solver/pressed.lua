---@diagnostic disable
--- Pressed contacts: notes at the end of a step which sides of bodies are pressed, the hits of
-- contacts in which two bodies begin to lean on each other, and which bodies are crushed: pressed
-- between two that cannot give way, on one axis.
--
-- A crushed body stays where it overlaps its neighbours the least (see settle.lua), and is free
-- again as soon as there is room. How it came there is remembered with the pair (`wedged`). So it
-- leaves along the same axis and is never squeezed out sideways.
--
-- Reads contacts, pressed, contact, start, squeezed; writes pressedHigh, pressedLow, hit, resolved,
-- crushed, crushLow and crushHigh.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local impact = require(root .. ".solver.impact")

local pressed = {}

local max = math.max

--- Notes the sides on which bodies lean on each other, the hits of contacts that begin so, and
--- which bodies are squeezed along the axis, and between which two.
function pressed.note(b, axis)
  local list, isPressed, hit, contact = b.contacts[axis], b.pressed, b.hit, b.contact
  local pressedHigh, pressedLow, squeezed = b.pressedHigh, b.pressedLow, b.squeezed
  for c = 1, list.count do
    local p, kl, kh = list.pair[c], list.low[c], list.high[c]
    if isPressed[p] == 1 then
      pressedHigh[kl], pressedLow[kh] = true, true
      b.resolved = b.resolved + (hit[p] == 0 and 1 or 0)
      if contact[p] == 0 then
        impact.note(b, p, (kl - axis) * 0.5, axis, max(b.start[kl] - b.start[kh], 0.0), 0)
      end
      if squeezed[kl] ~= 0 then
        b.crushHigh[kl], b.crushed[kl], b.hasCrushed = (kh - axis) * 0.5, true, true
      end
      if squeezed[kh] ~= 0 then
        b.crushLow[kh], b.crushed[kh], b.hasCrushed = (kl - axis) * 0.5, true, true
      end
    end
  end
end

return pressed
