--- Crushed: pressed between two that cannot give way, on one axis.
--
-- The object stays where it overlaps its neighbours the least (see settle), and is free again as
-- soon as there is room. How it came there is remembered with the pair (`wedged`), so that it
-- leaves along the same axis and is never squeezed out sideways.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local contacts = require(root .. ".solver.contacts")
local events = require(root .. ".contacts.events")

local crush = {}

local KINEMATIC = columns.KINEMATIC

local floor, max, min = math.floor, math.max, math.min

-- Whether one of the two that press body k in the end is a machine.
local function isPressedByMachine(b, k)
  local low, high = floor(b.holderLow[k] * 0.5), floor(b.holderHigh[k] * 0.5)
  return b.kind[low] == KINEMATIC or b.kind[high] == KINEMATIC
end

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
  local jam, patience, turn = b.jam, contacts.PATIENCE, contacts.TURN
  for n = 1, b.awakeCount do
    local i = b.awakeList[n]
    local k = 2 * i + axis
    if squeezed[k] ~= 0 then
      crushed[k], b.hasCrushed = true, true
    end
    if b.deepAt[i] ~= b.solveStamp then
      jam[k] = 0
    elseif squeezed[k] ~= 0 or jam[k] == turn then
      jam[k] = min(jam[k] + 1, patience)
      if jam[k] == turn and isPressedByMachine(b, k) then
        jam[k] = turn + 1 -- it is never squeezed out sideways
      end
    elseif jam[k] < patience then
      jam[k] = max(jam[k] - 1, jam[k] > turn and turn + 1 or 0)
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
