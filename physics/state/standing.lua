--- What static objects have in their fields, for `save`.
--
-- They are read once, so that is noted once, too (`b.fixed`), until one of them comes, goes or is
-- read again. A save looks at all others.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")

local standing = {}

local STATIC = columns.STATIC

--- Returns whether static objects were read since the last step.
function standing.hasMoved(b)
  for n = 1, b.movedCount do
    if b.kind[b.movedList[n]] == STATIC then
      return true
    end
  end
  return false
end

-- Whether what was noted of the static objects is right: `slots` in their order, `has[name]`: slot,
-- value of each one that has the field.
local function isFixedRight(b, fixed, numbers)
  if not fixed or fixed.version ~= b.staticVersion or b.newcomers then
    return false
  end
  if standing.hasMoved(b) then
    return false
  end
  local slots = fixed.slots
  for n = 2, #slots do
    if numbers[slots[n]] < numbers[slots[n - 1]] then
      return false
    end
  end
  return true
end

--- Lists in work.visit the objects to look at, by number.
function standing.listVisits(b, out, work)
  work.visit = work.visit or {}
  local visit, count, numbers = work.visit, 0, work.numbers
  work.fixed, work.isClean = isFixedRight(b, b.fixed, numbers) and b.fixed or false, true
  if work.fixed then
    for n = 1, b.moverCount do
      visit[n] = numbers[b.movers[n]]
    end
    count = b.moverCount
  end
  for n = work.fixed and out.known + 1 or 1, out.count do
    count = count + 1
    visit[count] = n
  end
  for n = #visit, count + 1, -1 do
    visit[n] = nil
  end
  work.visitKnown = count - (out.count - out.known)
end

--- Adds what is noted of static objects before number n behind place `at` of a sparse list, from
--- place i of `has` on; returns both.
function standing.put(list, at, has, i, n, numbers)
  local slot = has[i]
  while slot and numbers[slot] < n do
    list[at + 1], list[at + 2] = numbers[slot], has[i + 1]
    at, i = at + 2, i + 2
    slot = has[i]
  end
  return at, i
end

--- Notes what the static objects have, of which a full save has found nothing that was written
--- since it was read. `dense` and `sparse` are the lists of fields of a state.
function standing.note(b, out, work, dense, sparse)
  local fixed = { version = b.staticVersion, slots = {}, has = {}, dense = {} }
  local slots, kind = work.slots, b.kind
  for n = 1, out.known do
    if kind[slots[n]] == STATIC then
      fixed.slots[#fixed.slots + 1] = slots[n]
    end
  end
  for m = 1, #sparse do
    local name, has = sparse[m][1], {}
    local list = out.fields[name]
    for at = 1, #list, 2 do
      local slot = list[at] <= out.known and slots[list[at]]
      if slot and kind[slot] == STATIC then
        has[#has + 1], has[#has + 2] = slot, list[at + 1]
      end
    end
    fixed.has[name] = has
  end
  for m = 1, #dense do
    local list, values = out[dense[m][1]], {}
    for n = 1, #fixed.slots do
      values[n] = list[work.numbers[fixed.slots[n]]]
    end
    fixed.dense[m] = values
  end
  b.fixed = fixed
end

return standing
