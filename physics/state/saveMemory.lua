--- Saves what the library remembers from step to step (see format.lua): columns that outlive a
--- step, contacts, events that wait.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local events = require(root .. ".contacts.events")
local format = require(root .. ".state.format")
local interpreted = require(root .. ".memory.jit")

local STATIC, DYNAMIC = columns.STATIC, columns.DYNAMIC
local listIn, cut = format.listIn, format.cut

-- Returns whether the game has given an object another `canCollide` than the one that was read. The
-- state does not hold functions, but an update would treat the object as moved.
local function asksAnew(b, i)
  return b.kind[i] ~= STATIC and (b.object[i].canCollide or false) ~= b.canCollide[i]
end

local function saveFlags(b, out, work)
  local slots = work.slots
  for m = 1, #format.FLAGS do
    local name = format.FLAGS[m]
    local list, column, at = listIn(out.memory, name), b[name], 0
    for v = 1, work.visitKnown do
      local n = work.visit[v]
      if column[slots[n]] or (name == "moved" and asksAnew(b, slots[n])) then
        at = at + 1
        list[at] = n
      end
    end
    cut(list, at)
  end
end

local function saveLinks(b, out, work)
  local slots, numbers = work.slots, work.numbers
  for m = 1, #format.LINKS do
    local name = format.LINKS[m]
    local list, column, at = listIn(out.memory, name), b[name], 0
    for v = 1, work.visitKnown do
      local n = work.visit[v]
      local other = column[slots[n]]
      if other ~= 0 and b.kind[other] ~= 0 then
        list[at + 1], list[at + 2] = n, numbers[other]
        at = at + 2
      end
    end
    cut(list, at)
  end
end

local function savePoints(b, out, work)
  local slots = work.slots
  for m = 1, #format.POINTS do
    local name, usual = format.POINTS[m][1], format.POINTS[m][2]
    local list, column, model, at = listIn(out.memory, name), b[name], b[usual], 0
    local isWanted = name ~= "last" or b.world.timestep
    for v = 1, isWanted and work.visitKnown or 0 do
      local n = work.visit[v]
      local k = 2 * slots[n]
      local x, y = usual, usual
      if model then
        x, y = model[k], model[k + 1]
      end
      if column[k] ~= x or column[k + 1] ~= y then
        list[at + 1], list[at + 2], list[at + 3] = n, column[k], column[k + 1]
        at = at + 3
      end
    end
    cut(list, at)
  end
end

-- Saves the riders that have lost their carrier since the last step.
local function saveLost(b, out, work)
  local list = listIn(out.memory, "lost")
  local count = 0
  for n = 1, b.lostCount do
    local i = b.lost[n]
    if b.kind[i] == DYNAMIC then
      count = count + 1
      list[count] = work.numbers[i]
    end
  end
  cut(list, count)
  table.sort(list)
end

-- Saves the walls of `setBounds`.
local function saveWalls(world, out, work)
  local walls = listIn(out, "walls")
  for side in next, walls, nil do
    walls[side] = nil
  end
  if next(world._walls) ~= nil then
    for n = 1, out.count do
      for side, wall in next, world._walls, nil do
        if work.objects[n] == wall then
          walls[side] = n
        end
      end
    end
  end
end

-- Returns the number of an object that the library remembers, 0 for none. An object that has left
-- the world gets a number behind all others.
local function numberOf(b, out, work, object)
  if not object then
    return 0
  end
  local slot, objects = b.slotOf[object], work.objects
  local number = slot and work.numbers[slot]
  if number and rawequal(objects[number], object) then
    return number
  end
  local last = out.count + work.goneCount
  for n = out.known + 1, last do
    if rawequal(objects[n], object) then
      return n
    end
  end
  work.goneCount = work.goneCount + 1
  objects[last + 1] = object
  return last + 1
end

local function saveTouching(b, out, work)
  local list, slots, at = listIn(out, "touching"), work.slots, 0
  for n = 1, out.known do
    local t = b.touching[slots[n]]
    if t and (t.left or t.right or t.top or t.bottom) then
      list[at + 1] = n
      list[at + 2] = numberOf(b, out, work, t.left)
      list[at + 3] = numberOf(b, out, work, t.right)
      list[at + 4] = numberOf(b, out, work, t.top)
      list[at + 5] = numberOf(b, out, work, t.bottom)
      at = at + 5
    end
  end
  cut(list, at)
end

-- Contacts ---------------------------------------------------------------------------------------

local function remembers(b, p)
  for c = 1, #format.PAIRS do
    local entry = format.PAIRS[c]
    if b[entry[1]][p] ~= entry[2] then
      return true
    end
  end
  return false
end

-- Lists in work.pairs the pairs of object n (in `slot`) with later objects, if there is something
-- to remember, by the number of the other. Returns how many.
local function gatherPairs(b, work, n, slot)
  local other, nextHalf, numbers, found = b.other, b.next, work.numbers, work.pairs
  local count, half = 0, b.head[slot]
  while half ~= 0 do
    if remembers(b, (half + half % 2) / 2) then
      local number = numbers[other[half]]
      if number > n then
        count = count + 1
        local at = count
        while at > 1 and numbers[other[found[at - 1]]] > number do
          found[at] = found[at - 1]
          at = at - 1
        end
        found[at] = half
      end
    end
    half = nextHalf[half]
  end
  return count
end

local function saveContacts(b, out, work)
  work.pairs = work.pairs or {}
  local list, slots, numbers, at = listIn(out, "contacts"), work.slots, work.numbers, 0
  local PAIRS, found = format.PAIRS, work.pairs
  for n = 1, out.known do
    for m = 1, gatherPairs(b, work, n, slots[n]) do
      local half = found[m]
      local p = (half + half % 2) / 2
      list[at + 1], list[at + 2] = n, numbers[b.other[half]]
      at = at + 2
      for c = 1, #PAIRS do
        local entry = PAIRS[c]
        local value = b[entry[1]][p]
        if half % 2 == 0 and value ~= entry[2] then
          value = entry[3][value]
        end
        at = at + 1
        list[at] = value
      end
    end
  end
  cut(list, at)
end

-- Saves the waiting events. Events wait only after a callback has failed, or inside one. Some
-- objects may have heard of the first event already: `heardBy`.
local function saveEvents(b, out, work)
  local list, e, at = listIn(out, "events"), b.events, 0
  local isHalfTold = e.told > 0 and e.heardBy < 3
  local first = isHalfTold and e.told or e.told + 1
  out.heardBy = isHalfTold and e.heardBy or nil
  out.sorted = first <= e.sorted and e.sorted - first + 1 or nil
  -- Events that a callback noted before it failed are told in order, too.
  events.sortLate(e)
  for told = first, e.count do
    local n = told <= e.sorted and e.order[told] or e.late[told - e.sorted]
    list[at + 1] = numberOf(b, out, work, e.a[n])
    list[at + 2] = numberOf(b, out, work, e.b[n])
    list[at + 3] = numberOf(b, out, work, e.c[n])
    at = at + 3
    for m = 1, #format.EVENT do
      list[at + m] = e[format.EVENT[m]][n]
    end
    at = at + #format.EVENT
  end
  cut(list, at)
end

interpreted.always(saveWalls)

--- Saves all this. Counts the objects in `work.goneCount` that have left the world but are named.
return function(world, out, work)
  local b = world._bodies
  listIn(out, "memory")
  saveFlags(b, out, work)
  saveLinks(b, out, work)
  savePoints(b, out, work)
  saveLost(b, out, work)
  saveWalls(world, out, work)
  saveTouching(b, out, work)
  saveContacts(b, out, work)
  saveEvents(b, out, work)
end
