--- What small scenes are made of: objects, tables for `world:add`, and steps.

local physics = require("physics")

local small = {}

small.unpack = rawget(_G, "unpack") or rawget(table, "unpack")

--- Returns an object that has these fields, too.
---@param fields? table
function small.set(object, fields)
  for name, value in pairs(fields or {}) do
    object[name] = value
  end
  return object
end

--- Returns a value, of a table a copy with copies of what is in it.
function small.copy(value)
  if type(value) ~= "table" then
    return value
  end
  local copied = {}
  for key, inner in pairs(value) do
    copied[key] = small.copy(inner)
  end
  return copied
end

--- Returns an object at x, y with more fields, or other ones.
---@param fields? table
---@return table
function small.put(x, y, width, height, fields)
  return small.set({ x = x, y = y, width = width, height = height }, fields)
end

--- The same of 16 px.
function small.box(x, y, fields)
  return small.put(x, y, 16, 16, fields)
end

--- The same that is static.
function small.tile(x, y, width, height, fields)
  local object = small.put(x, y, width, height, fields)
  object.static = true
  return object
end

--- The same that is a circle around x, y.
function small.ball(x, y, radius, fields)
  local object = small.put(x - radius, y - radius, 2 * radius, 2 * radius, fields)
  object.radius = radius
  return object
end

--- A floor of 800 px, on which a box of 16 px stands at y = 84.
function small.floor()
  return small.tile(-200, 100, 800, 16)
end

--- A world without gravity, if the settings name none.
function small.still(settings)
  local world = physics.newWorld(settings)
  world.gravity = settings and settings.gravity or 0
  return world
end

--- Fails unless a call is refused with these words, blaming a line of spec/.
function small.refuses(words, call, ...)
  local isTaken, message = pcall(call, ...)
  local text = not isTaken and message:match("spec[/\\].-%.lua:%d+: physics: (.*)$")
  assert(text and text:find(words, 1, true), isTaken and "not refused: " .. words or message)
end

--- Makes `count` steps of 1 / rate s, and calls `each(n)` after the n-th.
---@param count? number default 60
---@param rate? number default 60
---@param each? fun(n: integer)
function small.run(world, count, rate, each)
  for n = 1, (count or 60) + 1e-6 do
    world:update(1 / (rate or 60))
    if each then
      each(n)
    end
  end
end

--- Plays some seconds in steps of 1 / rate s.
---@param rate? number default 60
function small.play(world, seconds, rate)
  small.run(world, math.floor(seconds * (rate or 60) + 0.5), rate)
end

--- Defines a spec for each row of a list: f gets its values, `{2}` in the title is the second one.
---@param title string
---@param rows any[] lists of values, or values
---@param f function
function small.rows(title, rows, f)
  -- busted gives its words to spec files, not to what they require
  local define = rawget(_G, "it") or require("busted").it
  for _, row in ipairs(rows) do
    local values = type(row) == "table" and row or { row }
    local name = title:gsub("{(%d)}", function(n)
      local value = values[tonumber(n)]
      return type(value) == "number" and ("%.6g"):format(value) or tostring(value)
    end)
    define(name, function()
      f(small.unpack(values, 1, 10))
    end)
  end
end

--- The same for values by name: f gets the name, `{1}`, and the value.
---@param values table
function small.each(title, values, f)
  local rows = {}
  for name, value in pairs(values) do
    rows[#rows + 1] = { name, value }
  end
  small.rows(title, rows, f)
end

--- Returns rows for `small.rows`: each of a list with each of another one; rows lose a level.
function small.cross(list, other)
  local rows = {}
  for _, a in ipairs(list) do
    for _, b in ipairs(other) do
      local row = type(a) == "table" and { small.unpack(a, 1, 10) } or { a }
      row[#row + 1] = b
      rows[#rows + 1] = row
    end
  end
  return rows
end

return small
