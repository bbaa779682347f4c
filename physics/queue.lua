--- The events of a step in the order of time: a binary heap without garbage.
--
-- An event is "this pair meets at this moment". It is dropped when its pair has been given another
-- one (column `event` of the pair), so nothing is ever searched for in the heap.
-- Source of the heap: J. W. J. Williams, "Algorithm 232: Heapsort" (1964).
--
-- All fields of an event stand side by side in one array: a trace that touches one array stays
-- short, and seven of them would not (LuaJIT has a limit for the code of all traces).

local here = (...):match("^(.*)%.[^.]+$")
require(here .. ".interpreted").file()

local queue = {}

-- Fields of an event, by offset. The first four decide, in this order.
queue.KEY = 1 -- moment, kind, how often resolved, axis: one whole number
local SUPPORT = 2 -- larger first
local RANK_A, RANK_B = 3, 4
local PAIR, CODE, TIME = 5, 6, 7
local FIELDS = 8
local KEY = queue.KEY

--- Returns an empty queue.
function queue.new()
  return {
    size = 0,
    heap = {}, -- event ids, smallest first; an id is where its fields begin
    last = 0, -- highest id in use
    data = {},
    free = {},
    freeCount = 0,
  }
end

-- Two of the same moment and kind: the rest decides.
local function isTiedBefore(data, x, y)
  if data[x + SUPPORT] ~= data[y + SUPPORT] then
    return data[x + SUPPORT] > data[y + SUPPORT]
  end
  if data[x + RANK_A] ~= data[y + RANK_A] then
    return data[x + RANK_A] < data[y + RANK_A]
  end
  return data[x + RANK_B] < data[y + RANK_B]
end

local function isBefore(data, x, y)
  local keyX, keyY = data[x + KEY], data[y + KEY]
  return keyX < keyY or (keyX == keyY and isTiedBefore(data, x, y))
end

local function claim(q)
  if q.freeCount > 0 then
    local id = q.free[q.freeCount]
    q.freeCount = q.freeCount - 1
    return id
  end
  local id = q.last
  q.last = id + FIELDS
  q.data[id + FIELDS] = 0
  return id
end

local function rise(data, heap, at, id)
  while at > 1 do
    local parent = (at - at % 2) / 2
    if not isBefore(data, id, heap[parent]) then
      break
    end
    heap[at] = heap[parent]
    at = parent
  end
  heap[at] = id
end

--- Puts an event in and returns its id.
function queue.push(q, key, support, rankA, rankB, pair, code, time)
  local id, data = claim(q), q.data
  data[id + KEY], data[id + SUPPORT] = key, support
  data[id + RANK_A], data[id + RANK_B] = rankA, rankB
  data[id + PAIR], data[id + CODE], data[id + TIME] = pair, code, time
  q.size = q.size + 1
  rise(data, q.heap, q.size, id)
  return id
end

local function sink(data, heap, size, id)
  local at, child = 1, 2
  while child <= size do
    if child < size and isBefore(data, heap[child + 1], heap[child]) then
      child = child + 1
    end
    if not isBefore(data, heap[child], id) then
      break
    end
    heap[at] = heap[child]
    at, child = child, 2 * child
  end
  heap[at] = id
end

--- Takes the first event out and returns its id, which stays readable until the next push; nil if
--- there is none.
function queue.pop(q)
  local size, heap = q.size, q.heap
  if size == 0 then
    return nil
  end
  local top = heap[1]
  q.size = size - 1
  sink(q.data, heap, size - 1, heap[size])
  q.freeCount = q.freeCount + 1
  q.free[q.freeCount] = top
  return top
end

--- Returns whether the first event comes before one with the same key and these fields.
function queue.leads(q, support, rankA, rankB)
  local data, x = q.data, q.heap[1]
  if data[x + SUPPORT] ~= support then
    return data[x + SUPPORT] > support
  elseif data[x + RANK_A] ~= rankA then
    return data[x + RANK_A] < rankA
  end
  return data[x + RANK_B] < rankB
end

--- Returns pair, code and time of an event.
function queue.read(q, id)
  local data = q.data
  return data[id + PAIR], data[id + CODE], data[id + TIME]
end

--- Empties the queue.
function queue.clear(q)
  q.size, q.last, q.freeCount = 0, 0, 0
end

return queue
