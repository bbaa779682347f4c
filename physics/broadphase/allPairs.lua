--- The plain broad phase: everybody against everybody. It is the reference for all others.
--
-- A broad phase knows the fat boxes of the objects that were inserted (columns `fatLow`, `fatHigh`)
-- and answers one question, for many at once (`overlaps`) or for a rectangle (`query`): which of
-- them meet it. All broad phases have this interface and find the same, in an order of their own.

---@class physics.Everybody
---@field [string] any
local everybody = {}
everybody.__index = everybody

--- Returns an empty broad phase over the columns `b`.
function everybody.new(b)
  return setmetatable({ bodies = b, list = {}, count = 0, placeOf = {}, answers = {} }, everybody)
end

function everybody:insert(i)
  self.count = self.count + 1
  self.list[self.count] = i
  self.placeOf[i] = self.count
end

function everybody:remove(i)
  local place, last = self.placeOf[i], self.list[self.count]
  self.list[place] = last
  self.placeOf[last] = place
  self.list[self.count] = nil
  self.count = self.count - 1
end

--- The fat boxes of those in `list[1..count]` have changed, each of whom stands there once.
function everybody.update() end

-- Lists everybody whose fat box meets that of `asker` behind place n.
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

--- Finds all whose fat boxes meet those of `list[1..count]`: writes who asks into `askers` and whom
--- it meets, itself included, into `found`; returns how many.
function everybody:overlaps(list, count, askers, found)
  local n = 0
  for m = 1, count do
    n = add(self, list[m], askers, found, n)
  end
  return n
end

--- Writes the slots of all objects whose fat boxes meet the rectangle into `out`; returns how many.
function everybody:query(left, top, right, bottom, out)
  -- Asked in the name of slot 0, which nobody has.
  local fatLow, fatHigh = self.bodies.fatLow, self.bodies.fatHigh
  fatLow[0], fatLow[1], fatHigh[0], fatHigh[1] = left, top, right, bottom
  return add(self, 0, self.answers, out, 0)
end

return everybody
