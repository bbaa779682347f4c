--- The events of a step in the order of time: a binary heap in arrays, without garbage.
--
-- An event is "this pair meets at this moment". It is dropped when its pair has been given another
-- one (column `event` of the pair), so nothing is ever searched for in the heap.
-- Source of the heap: J. W. J. Williams, "Algorithm 232: Heapsort" (1964).

local queue = {}

--- Returns an empty queue.
function queue.new()
  return {
    size = 0,
    heap = {}, -- event ids, smallest first
    ids = 0,
    free = {},
    freeCount = 0,
    -- what decides, in this order
    key = {}, -- moment, kind, how often resolved, axis: one whole number
    support = {}, -- larger first
    rankA = {},
    rankB = {},
    -- what it says
    pair = {},
    code = {},
    time = {},
  }
end

local function isBefore(q, x, y)
  local key, support = q.key, q.support
  if key[x] ~= key[y] then
    return key[x] < key[y]
  end
  if support[x] ~= support[y] then
    return support[x] > support[y]
  end
  local rankA, rankB = q.rankA, q.rankB
  if rankA[x] ~= rankA[y] then
    return rankA[x] < rankA[y]
  end
  return rankB[x] < rankB[y]
end

--- Puts an event in and returns its id.
function queue.push(q, key, support, rankA, rankB, pair, code, time)
  local id
  if q.freeCount > 0 then
    id = q.free[q.freeCount]
    q.freeCount = q.freeCount - 1
  else
    id = q.ids + 1
    q.ids = id
  end
  q.key[id], q.support[id], q.rankA[id], q.rankB[id] = key, support, rankA, rankB
  q.pair[id], q.code[id], q.time[id] = pair, code, time
  local heap, at = q.heap, q.size + 1
  q.size = at
  while at > 1 do
    local parent = (at - at % 2) / 2
    if not isBefore(q, id, heap[parent]) then
      break
    end
    heap[at] = heap[parent]
    at = parent
  end
  heap[at] = id
  return id
end

--- Takes the first event out and returns its id, which stays readable until the next push; nil if
--- there is none.
function queue.pop(q)
  local size = q.size
  if size == 0 then
    return nil
  end
  local heap = q.heap
  local top, last = heap[1], heap[size]
  size = size - 1
  q.size = size
  local at, child = 1, 2
  while child <= size do
    if child < size and isBefore(q, heap[child + 1], heap[child]) then
      child = child + 1
    end
    if not isBefore(q, heap[child], last) then
      break
    end
    heap[at] = heap[child]
    at, child = child, 2 * child
  end
  heap[at] = last
  q.freeCount = q.freeCount + 1
  q.free[q.freeCount] = top
  return top
end

--- Empties the queue.
function queue.clear(q)
  for at = 1, q.size do
    q.freeCount = q.freeCount + 1
    q.free[q.freeCount] = q.heap[at]
  end
  q.size = 0
end

return queue
