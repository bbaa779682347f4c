--- The order of contacts: sorts the contacts of an axis by the coordinate of their high body, then
-- by the ranks of the two. So it does not depend on the order in which pairs were found.
--
-- Reads contactKey, contactLow, contactHigh, rank; writes the order of a list (see contacts.lua).

local contactOrder = {}

-- Returns whether contact p comes before contact q in a list.
local function before(b, p, q)
  local key = b.contactKey
  if key[p] ~= key[q] then
    return key[p] < key[q]
  end
  local rank, low, high = b.rank, b.contactLow, b.contactHigh
  local axis = high[p] % 2
  local one, other = rank[(high[p] - axis) * 0.5], rank[(high[q] - axis) * 0.5]
  if one ~= other then
    return one < other
  end
  return rank[(low[p] - axis) * 0.5] < rank[(low[q] - axis) * 0.5]
end

-- Merges the sorted runs [first, middle) and [middle, last] of `source` into `target`.
local function mergeRuns(b, source, target, first, middle, last)
  local i, j = first, middle
  for n = first, last do
    if j > last or (i < middle and not before(b, source[j], source[i])) then
      target[n] = source[i]
      i = i + 1
    else
      target[n] = source[j]
      j = j + 1
    end
  end
end

-- Sorts list[1..count]: by insertion while little is out of place, else by bottom-up merging.
local function sortOrder(b, list, count)
  local patience = 4 * count + 64
  for n = 2, count do
    local p, at = list[n], n
    while at > 1 and before(b, p, list[at - 1]) do
      list[at] = list[at - 1]
      at = at - 1
    end
    list[at] = p
    patience = patience - (n - at)
    if patience < 0 then
      break
    end
  end
  if patience >= 0 then
    return
  end
  local source, target, width = list, b.sortScratch, 1
  while width < count do
    for first = 1, count, 2 * width do
      local middle, last = first + width, first + 2 * width - 1
      if middle > count + 1 then
        middle = count + 1
      end
      mergeRuns(b, source, target, first, middle, last < count and last or count)
    end
    local sorted = target
    target = source
    source, width = sorted, 2 * width
  end
  if source ~= list then
    for n = 1, count do
      list[n] = source[n]
    end
  end
end

--- Puts the pairs of a list in order. It starts from the order of the last step, appends new pairs,
--- and sorts.
function contactOrder.arrange(b, list)
  local order, pair, place, count = list.order, list.pair, b.place, list.count
  for n = 1, count do
    place[pair[n]] = 1
  end
  local kept = 0
  for n = 1, list.recalled do
    local p = order[n]
    if place[p] == 1 then
      kept = kept + 1
      order[kept], place[p] = p, 2
    end
  end
  for n = 1, count do
    local p = pair[n]
    if place[p] == 1 then
      kept = kept + 1
      order[kept] = p
    end
    place[p] = 0
  end
  list.recalled = kept
  sortOrder(b, order, kept)
end

return contactOrder
