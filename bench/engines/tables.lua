--- What engines share that move tables with x, y, vx and vy: `objects`, by number.

local tables = {}

--- Returns where an object is.
function tables.read(self, index)
  local object = self.objects[index]
  return object.x, object.y
end

--- Gives an object another velocity; nil leaves it.
function tables.setVelocity(self, index, vx, vy)
  local object = self.objects[index]
  object.vx = vx or object.vx
  object.vy = vy or object.vy
end

return tables
