--- For specs of states: small worlds, a serializer as a game may have one, and damage.

local physics = require("physics")

local states = {}

local DT = 1 / 60

--- A serializer as a game may have one: text of numbers, strings, booleans and tables, no more.
function states.write(value)
  local kind = type(value)
  if kind == "number" then
    assert(value - value == 0, "nan or inf in a state")
    local short = ("%.14g"):format(value)
    return tonumber(short) == value and short or ("%.17g"):format(value)
  elseif kind == "string" then
    return ("%q"):format(value)
  elseif kind == "boolean" then
    return tostring(value)
  end
  assert(kind == "table" and getmetatable(value) == nil, "a " .. kind .. " in a state")
  local parts, count = {}, 0
  for _ in pairs(value) do
    count = count + 1
  end
  if count == #value then
    for i = 1, count do
      parts[i] = states.write(value[i])
    end
  else
    for key, entry in pairs(value) do
      assert(type(key) ~= "boolean" and type(key) ~= "table", "a key that is no name in a state")
      parts[#parts + 1] = ("[%s]=%s"):format(states.write(key), states.write(entry))
    end
  end
  return "{" .. table.concat(parts, ",") .. "}"
end

function states.read(text)
  return assert((loadstring or load)("return " .. text))() -- luacheck: ignore
end

--- A floor, a box on it, another one in the air.
function states.smallWorld(settings)
  local world = physics.newWorld(settings or { gravity = 600 })
  world:add("floor", { x = 0, y = 100, width = 400, height = 20, static = true })
  local box = world:add("boxes", { x = 10, y = 84, width = 16, height = 16 })
  local other = world:add("boxes", { x = 60, y = 20, width = 16, height = 16 })
  world:update(DT)
  return world, box, other
end

--- Sets what a path like "groups[2].name" leads to.
function states.put(state, path, value)
  local keys = {}
  for key in path:gmatch("[^%.%[%]]+") do
    keys[#keys + 1] = tonumber(key) or key
  end
  local place = state
  for n = 1, #keys - 1 do
    place = assert(place[keys[n]] ~= nil and place[keys[n]], path)
  end
  place[keys[#keys]] = value
end

return states
