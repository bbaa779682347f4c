--- After `world:restore` the objects are those of an earlier time: brings the books of a layer of
--- tiles back to that time, too.

local root = (...):match("^(.*)%.maps%.")
local cells = require(root .. ".maps.cells")
local digging = require(root .. ".maps.digging")
local interpreted = require(root .. ".memory.jit")

local floor = math.floor
local find, has, indexOf, register = cells.find, digging.has, cells.indexOf, cells.register

local rewind = {}

local function forget(self)
  self.rectangles, self.tiles = 0, 0
  for _, boxes in ipairs(self._list) do
    boxes.owner, boxes.widest = {}, 0
  end
end

local function registerAgain(self, object)
  local place = object[self._record]
  register(self, place._boxes, object)
  self.tiles = self.tiles + place.columns * place.rows
end

-- Whether any cell of an object is covered by another one of its kind.
local function isCovered(self, object)
  local place = object[self._record]
  for row = place.row, place.row + place.rows - 1 do
    for column = place.column, place.column + place.columns - 1 do
      if find(self, place._boxes, column, row) then
        return true
      end
    end
  end
  return false
end

local function isOurs(self, object)
  local place = type(object) == "table" and rawget(object, self._record)
  return type(place) == "table" and place.tiles == self
end

--- Calls f(self, object) with each object of these tiles that stands in the world.
---@param self table the tiles
---@param f fun(self: table, object: physics.Object)
function rewind.eachInWorld(self, f)
  local isSeen = {}
  for _, boxes in ipairs(self._list) do
    local members = self.world.objects[boxes.group]
    if not isSeen[boxes.group] and type(members) == "table" then
      isSeen[boxes.group] = true
      for i = 1, #members do
        if isOurs(self, members[i]) then
          f(self, members[i])
        end
      end
    end
  end
end

-- A cell that is not covered any more is empty.
local function clearValues(self)
  local stride = self.columns + 1
  for index, value in pairs(self._values) do
    local row = floor((index - 1) / stride)
    local column = index - 1 - row * stride + self.firstColumn
    for _, boxes in ipairs(self._piecesOf(value)) do
      if not find(self, boxes, column, row + self.firstRow) then
        self._values[index] = nil
        break
      end
    end
  end
end

-- And one that is covered again has a value that makes it so.
local function setValues(self, object)
  local place = object[self._record]
  local boxes = place._boxes
  for row = place.row, place.row + place.rows - 1 do
    for column = place.column, place.column + place.columns - 1 do
      local index = indexOf(self, column, row)
      local value = self._values[index]
      if value == nil or not has(self._piecesOf(value), boxes) then
        self._values[index] = boxes.first
      end
    end
  end
end

--- Brings the books up to date if the world was put back to an earlier state since.
---@param self table the tiles
function rewind.follow(self)
  if self._restores == self.world._restores then
    return
  end
  self._restores = self.world._restores
  forget(self)
  rewind.eachInWorld(self, function(_, object)
    self._isWaiting[object] = nil
    registerAgain(self, object)
  end)
  for _, object in ipairs(self._waiting) do
    if self._isWaiting[object] and isCovered(self, object) then
      self._isWaiting[object] = nil -- it was made of what stands in the world again
    elseif self._isWaiting[object] then
      registerAgain(self, object)
    end
  end
  clearValues(self)
  rewind.eachInWorld(self, setValues)
end

interpreted.always(clearValues)

return rewind
