--- The plain broad phase: everybody against everybody. It is the reference for all others, and the
--- fastest for a handful of objects.
--
-- A broad phase knows the fat boxes of the objects that were inserted (columns `fatLow`, `fatHigh`)
-- and answers one question: which of them meet a rectangle. All broad phases have this interface
-- and find the same objects, in an order of their own.

---@class physics.Everybody
---@field [string] any
local everybody = {}
everybody.__index = everybody

--- Returns an empty broad phase over the columns `b`.
function everybody.new(b)
  return setmetatable({ bodies = b, list = {}, count = 0, placeOf = {} }, everybody)
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

--- The fat box of an object has changed.
function everybody.update() end

--- Writes the slots of all objects whose fat boxes meet the rectangle into `out`; returns how many.
function everybody:query(left, top, right, bottom, out)
  local b, list = self.bodies, self.list
  local fatLow, fatHigh = b.fatLow, b.fatHigh
  local n = 0
  for place = 1, self.count do
    local i = list[place]
    local k = 2 * i
    if
      fatLow[k] <= right
      and fatHigh[k] >= left
      and fatLow[k + 1] <= bottom
      and fatHigh[k + 1] >= top
    then
      n = n + 1
      out[n] = i
    end
  end
  return n
end

return everybody
