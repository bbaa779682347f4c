--- Pressed contacts: notes at the end of a step which sides of bodies are pressed, and the hits of
-- contacts in which two bodies begin to lean on each other.
--
-- Reads contacts, pressed, contact, start; writes pressedHigh, pressedLow, hit and resolved.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local impact = require(root .. ".solver.impact")

local pressed = {}

local EPSILON = columns.EPSILON
local max = math.max

-- Notes the hits of new contacts that are flush, at sides that are pressed: all of them, if a body
-- comes onto several at once.
local function noteHits(b, list)
  local pressedHigh, pressedLow, give, start = b.pressedHigh, b.pressedLow, b.give, b.start
  for c = 1, list.count do
    local p, kl, kh = list.pair[c], list.low[c], list.high[c]
    if b.hit[p] == 0 and b.contact[p] == 0 then
      local over = b.to[kl] + list.separation[c] - b.to[kh]
      local isBorne = (give[kl] > 0 and pressedHigh[kl]) or (give[kh] > 0 and pressedLow[kh])
      if b.pressed[p] == 1 or (isBorne and over <= EPSILON and over >= -EPSILON) then
        local low, axis = (kl - list.axis) * 0.5, list.axis
        impact.note(b, p, low, axis, max(start[kl] - start[kh], 0.0), 0)
      end
    end
  end
end

--- Notes the sides on which bodies lean on each other, and the hits of contacts that begin so.
function pressed.note(b, axis)
  local list, isPressed, hit, contact = b.contacts[axis], b.pressed, b.hit, b.contact
  local pressedHigh, pressedLow, hasNew = b.pressedHigh, b.pressedLow, false
  for c = 1, list.count do
    local p = list.pair[c]
    if isPressed[p] == 1 then
      pressedHigh[list.low[c]], pressedLow[list.high[c]] = true, true
      if hit[p] == 0 then
        b.resolved = b.resolved + 1
        hasNew = hasNew or contact[p] == 0
      end
    end
  end
  if hasNew then
    noteHits(b, list)
  end
end

return pressed
