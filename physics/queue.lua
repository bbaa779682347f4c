--- The events of a step in the order of time: a binary heap without garbage.
--
-- An event is "this pair meets at this moment". A pair has one place in the heap at most: when it
-- is given another event, it moves from where it is, which is rarely far. An event that is not
-- wanted any more stays there until it is its turn (column `event` of the pair), or until the pair
-- has another one, so nothing is ever searched for.
-- Source of the heap: J. W. J. Williams, "Algorithm 232: Heapsort" (1964); that the last one goes
-- through the leaf: R. W. Floyd, "Algorithm 245: Treesort 3" (1964).
--
-- All fields of an event stand side by side in one array: a trace that touches one array stays
-- short, and seven of them would not (LuaJIT has a limit for the code of all traces).

local here = (...):match("^(.*)%.[^.]+$")
require(here .. ".interpreted").file()

local queue = {}

-- Fields of an event, by offset. The first four decide, in this order.
queue.KEY = 1 -- moment, kind, round, axis (see `keyOf` in meet): one whole number
local SUPPORT = 2 -- larger first
local RANK_A, RANK_B = 3, 4
local CODE, TIME = 5, 6
local AT = 7 -- place in the heap; 0: not in there
local FIELDS = 8
local KEY = queue.KEY

--- Returns an empty queue.
function queue.new()
  return {
    size = 0,
    heap = {}, -- event ids, smallest first; an id is where its fields begin
    last = -FIELDS, -- highest id that there is room for
    data = {},
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

-- Makes room for the events of pairs up to the one with this id.
local function reserve(q, id)
  local data = q.data
  for x = q.last + FIELDS, id, FIELDS do
    for field = x, x + FIELDS - 1 do
      data[field] = 0
    end
    q.last = x
  end
end

-- Puts an event into place `at`, or above it.
local function rise(data, heap, at, id)
  local key = data[id + KEY]
  while at > 1 do
    local above = (at - at % 2) / 2
    local other = heap[above]
    local itsKey = data[other + KEY]
    if itsKey < key or (itsKey == key and not isTiedBefore(data, id, other)) then
      break
    end
    heap[at], data[other + AT] = other, at
    at = above
  end
  heap[at], data[id + AT] = id, at
end

-- The smaller one of the two below a place.
local function childOf(data, heap, size, at)
  local child = 2 * at
  if child < size then
    local left, right = heap[child], heap[child + 1]
    local keyLeft, keyRight = data[left + KEY], data[right + KEY]
    if keyRight < keyLeft or (keyRight == keyLeft and isTiedBefore(data, right, left)) then
      return child + 1
    end
  end
  return child
end

-- Puts an event into place `at`, or below it: those that are smaller go up to the leaf, from where
-- the event rises.
local function sink(data, heap, size, at, id)
  local child = childOf(data, heap, size, at)
  while child <= size do
    local other = heap[child]
    heap[at], data[other + AT] = other, at
    at, child = child, childOf(data, heap, size, child)
  end
  rise(data, heap, at, id)
end

-- An event in the heap has changed.
local function move(q, id)
  local data, heap, at = q.data, q.heap, q.data[id + AT]
  rise(data, heap, at, id)
  if data[id + AT] == at then
    sink(data, heap, q.size, at, id)
  end
end

--- Gives a pair its event, in the place of the one it had, and returns the event's id.
function queue.push(q, key, support, rankA, rankB, pair, code, time)
  local id, data = FIELDS * pair, q.data
  if id > q.last then
    reserve(q, id)
  end
  data[id + CODE], data[id + TIME] = code, time
  if data[id + AT] == 0 then
    data[id + KEY], data[id + SUPPORT], data[id + RANK_A], data[id + RANK_B] =
      key, support, rankA, rankB
    q.size = q.size + 1
    rise(data, q.heap, q.size, id)
  elseif
    data[id + KEY] ~= key
    or data[id + SUPPORT] ~= support
    or data[id + RANK_A] ~= rankA
    or data[id + RANK_B] ~= rankB
  then
    data[id + KEY], data[id + SUPPORT], data[id + RANK_A], data[id + RANK_B] =
      key, support, rankA, rankB
    move(q, id)
  end
  return id
end

--- Takes the first event out and returns its id, which stays readable until the pair has another;
--- nil if there is none.
function queue.pop(q)
  local size, heap, data = q.size, q.heap, q.data
  if size == 0 then
    return nil
  end
  local top = heap[1]
  data[top + AT], q.size = 0, size - 1
  if size > 1 then
    sink(data, heap, size - 1, 1, heap[size])
  end
  return top
end

--- Returns whether the first event comes before one with these fields.
function queue.leads(q, key, support, rankA, rankB)
  local data, x = q.data, q.heap[1]
  if data[x + KEY] ~= key then
    return data[x + KEY] < key
  elseif data[x + SUPPORT] ~= support then
    return data[x + SUPPORT] > support
  elseif data[x + RANK_A] ~= rankA then
    return data[x + RANK_A] < rankA
  end
  return data[x + RANK_B] < rankB
end

--- Returns pair, code and time of an event.
function queue.read(q, id)
  local data = q.data
  return id / FIELDS, data[id + CODE], data[id + TIME]
end

--- Returns what decides the order of an event: key, support and both ranks.
function queue.order(q, id)
  local data = q.data
  return data[id + KEY], data[id + SUPPORT], data[id + RANK_A], data[id + RANK_B]
end

--- Empties the queue.
function queue.clear(q)
  local data, heap = q.data, q.heap
  for at = 1, q.size do
    data[heap[at] + AT] = 0
  end
  q.size = 0
end

return queue
