--- Filters of queries, and the lists that queries return.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local interpreted = require(root .. ".memory.jit")
local sort = require(root .. ".memory.sort")

local results = {}

--- Returns a list to work with. Filters may make queries of their own, so each query takes a list
--- and gives it back. A query that fails leaves its list to the garbage collector.
function results.take(v)
  local n = v.pooled
  if n == 0 then
    return {}
  end
  v.pooled = n - 1
  return v.pool[n]
end

--- Takes a list back.
function results.give(v, found)
  v.pooled = v.pooled + 1
  v.pool[v.pooled] = found
end

--- Returns whether a filter that is no function accepts a group of that name.
function results.isNamed(filter, name)
  if type(filter) ~= "table" then
    return filter == name
  end
  local at = 1
  while filter[at] ~= nil and filter[at] ~= name do
    at = at + 1
  end
  return filter[at] ~= nil
end

--- Keeps the objects that a filter accepts if it is no function; a function is called later.
function results.keepNamed(v, found, count, filter)
  if filter == nil or type(filter) == "function" then
    return count
  end
  local groupName, n = v.groupName, 0
  for m = 1, count do
    local i = found[m]
    if results.isNamed(filter, groupName[i]) then
      n = n + 1
      found[n] = i
    end
  end
  return n
end

local function accepts(v, i, filter)
  local object = v.object[i]
  -- A filter function may have found that the object has left.
  return object and filter(object)
end

local function writeAll(v, found, count, out)
  local objects = v.object
  for n = 1, count do
    out[n] = objects[found[n]]
  end
  return count
end

-- Writes the objects that a filter function accepts; returns how many.
local function writeAccepted(v, found, count, filter, out)
  local n = 0
  for m = 1, count do
    if accepts(v, found[m], filter) then
      n = n + 1
      out[n] = v.object[found[m]]
    end
  end
  return n
end

-- Removes the entries of a list behind place n.
local function shorten(out, n)
  for m = #out, n + 1, -1 do
    out[m] = nil
  end
end

--- Writes the objects in `found` that the filter accepts into `out`, in the order of `found`.
function results.publish(v, found, count, filter, out)
  out = out or {}
  local n
  if type(filter) == "function" then
    n = writeAccepted(v, found, count, filter, out)
  else
    n = writeAll(v, found, count, out)
  end
  if #out > n then
    shorten(out, n)
  end
  results.give(v, found)
  return out, n
end

-- Returns the first of `found`, by `entry`, then in the order of the world.
local function first(v, found, count)
  local entry, rank, best = v.entry, v.rank, found[1]
  for n = 2, count do
    local i = found[n]
    if entry[i] < entry[best] or (entry[i] == entry[best] and rank[i] < rank[best]) then
      best = i
    end
  end
  return best
end

--- Returns the first slot that the filter accepts; nil: none.
function results.pick(v, found, count, filter)
  if type(filter) ~= "function" then
    return count > 0 and first(v, found, count) or nil
  end
  sort.by(found, count, v.entry, v.rank, v.rank)
  for n = 1, count do
    if accepts(v, found[n], filter) then
      return found[n]
    end
  end
end

interpreted.functions(
  accepts,
  shorten, -- mostly by one or two entries: unrolled, all that follows is compiled each time
  writeAccepted,
  results.pick
)

return results
