--- All pairs, the plain broad phase: compares every fat box with every other one. It is the
-- reference for the grid.
--
-- A broad phase knows the fat boxes of the objects that were inserted (columns `fatLow`,
-- `fatHigh`). It finds those that meet the fat boxes of a list of objects (`overlaps`), or a
-- rectangle (`query`). All broad phases have this interface and find the same, in an order of
-- their own.

---@class physics.AllPairs
---@field [string] any
local allPairs = {}
allPairs.__index = allPairs

--- Returns an empty broad phase over the columns `b`.
function allPairs.new(b)
  return setmetatable({ bodies = b, list = {}, count = 0, placeOf = {}, answers = {} }, allPairs)
end

function allPairs:insert(i)
  self.count = self.count + 1
  self.list[self.count] = i
  self.placeOf[i] = self.count
end

function allPairs:remove(i)
  local place, last = self.placeOf[i], self.list[self.count]
  self.list[place] = last
  self.placeOf[last] = place
  self.list[self.count] = nil
  self.count = self.count - 1
end

--- Notes that the fat boxes of the objects in `list[1..count]` have changed. Each is listed once.
function allPairs.update() end

-- Lists all objects with a fat box that meets that of slot `asker`, behind place n.
local function add(self, asker, askers, found, n)
  local b, list = self.bodies, self.list
  local fatLow, fatHigh, k = b.fatLow, b.fatHigh, 2 * asker
  for place = 1, self.count do
    local i = list[place]
    local m = 2 * i
    if
      fatLow[m] <= fatHigh[k]
      and fatHigh[m] >= fatLow[k]
      and fatLow[m + 1] <= fatHigh[k + 1]
      and fatHigh[m + 1] >= fatLow[k + 1]
    then
      n = n + 1
      askers[n], found[n] = asker, i
    end
  end
  return n
end

--- Finds for each object in `list[1..count]` all objects with a fat box that meets its own, itself
--- included. Writes the object of the list into `askers` and the one that it meets into `found`.
--- Returns how many there are.
function allPairs:overlaps(list, count, askers, found)
  local n = 0
  for m = 1, count do
    n = add(self, list[m], askers, found, n)
  end
  return n
end

--- Writes the slots of all objects with a fat box that meets the rectangle into `out`. Returns how
--- many there are.
function allPairs:query(left, top, right, bottom, out)
  -- Slot 0, which is no object, gets the rectangle as its fat box.
  local fatLow, fatHigh = self.bodies.fatLow, self.bodies.fatHigh
  fatLow[0], fatLow[1], fatHigh[0], fatHigh[1] = left, top, right, bottom
  return add(self, 0, self.answers, out, 0)
end

return allPairs
