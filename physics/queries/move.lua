--- Moves one object with collisions, without a step: nothing is pushed, no time passes.
--
-- The way is walked in legs. A leg is a straight line. The first solid on it ends the leg, and the
-- response gives the next leg. What the object passes on a leg (sensors, and what the response lets
-- pass) is reported in the order in which it is met.
--
-- The responses are those of bump.lua (E. García Cota, 2012): slide, touch, cross, bounce. The
-- swept AABB is that of `sweep`, so tiles have no seams here either.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local aabb = require(root .. ".memory.aabb")
local check = require(root .. ".world.check")
local columns = require(root .. ".memory.columns")
local interpreted = require(root .. ".memory.jit")
local obstacle = require(root .. ".queries.obstacle")
local view = require(root .. ".queries.index")

interpreted.file()

local slide = {}

local max = math.max
-- A way that bounces between two walls ends after so many hits.
local MOST_HITS = 64

local RESPONSES = { "slide", "touch", "cross", "bounce" }
local AXIS_OF = { left = 0, right = 0, top = 1, bottom = 1 }

--- Errors: a response that is neither a name nor a function.
function slide.check(response, where)
  if response ~= nil and type(response) ~= "function" then
    check.choice(response, "response", where, RESPONSES)
  end
end

-- Returns what happens when two objects meet: the name of a response, or false.
local function respond(journey, object, other, isSolid)
  local response = journey.response
  if type(response) == "function" then
    response = response(object, other)
    if response == nil then
      response = "slide"
    elseif response ~= false then
      check.choice(response, "what response(object, other) returns", journey.where, RESPONSES)
    end
  end
  if response and not isSolid then
    return "cross"
  end
  return response
end

-- Hits --------------------------------------------------------------------------------------------

-- Returns whether an entry of the list is a hit of an earlier call. A game may use one list for
-- moves and queries: the objects in there must not be written to.
local function isHit(value)
  return type(value) == "table"
    and rawget(value, "response") ~= nil
    and rawget(value, "fraction") ~= nil
    and rawget(value, "width") == nil
end

-- Returns the table for the next hit: one that is in the list, or a spare one of an earlier call.
local function nextHit(journey)
  local hits, n = journey.hits, journey.count + 1
  journey.count = n
  local hit = hits[n]
  if not isHit(hit) then
    local spare = hits.spare
    hit = type(spare) == "table" and table.remove(spare) or {}
    hits[n] = hit
  end
  return hit
end

-- Keeps unused tables as spares, so that the length of the list is the number of hits.
local function tidy(journey)
  local hits = journey.hits
  for n = #hits, journey.count + 1, -1 do
    if isHit(hits[n]) then
      hits.spare = type(hits.spare) == "table" and hits.spare or {}
      hits.spare[#hits.spare + 1] = hits[n]
    end
    hits[n] = nil
  end
end

local function note(journey, other, side, x, y, share, response)
  local hit = nextHit(journey)
  local sign = (side == "left" or side == "top") and 1 or -1
  local isAcross = AXIS_OF[side] == 0
  hit.other, hit.side, hit.x, hit.y = other, side, x, y
  hit.nx, hit.ny = isAcross and sign or 0, isAcross and 0 or sign
  hit.fraction = journey.start + (1 - journey.start) * share
  hit.response = response
end

-- Legs --------------------------------------------------------------------------------------------

local function findNear(v, journey)
  local i, x, y, toX, toY = journey.slot, journey.x, journey.y, journey.toX, journey.toY
  journey.near = view.onWay(v, journey.world, i, x, y, toX, toY, journey.found)
end

-- Returns how long the common edge of the object and j would be, with the object at (x, y).
local function commonEdge(v, i, j, x, y)
  local position, size, k, m = v.position, v.size, 2 * i, 2 * j
  local width, height =
    aabb.overlap(x, y, size[k], size[k + 1], position[m], position[m + 1], size[m], size[m + 1])
  return max(width, height)
end

-- Returns whether j is met before the best so far: by time, then by the widest common edge, then in
-- the order of the world.
local function isBefore(v, journey, j, key, edge)
  if not journey.next or key ~= journey.nextKey then
    return not journey.next or key < journey.nextKey
  elseif edge ~= journey.nextEdge then
    return edge > journey.nextEdge
  end
  return v.rank[j] < v.rank[journey.next]
end

-- Finds the object that is met next on this leg.
local function findNext(v, journey)
  local i, passed = journey.slot, journey.passed
  local x, y, toX, toY = journey.x, journey.y, journey.toX, journey.toY
  journey.next = false
  for n = 1, journey.near do
    local j = journey.found[n]
    if not passed[j] and obstacle.isMet(v, i, j) then
      local key = obstacle.keyOf(v, i, j, x, y, toX, toY)
      if key and (not journey.next or key <= journey.nextKey) then
        local _, _, _, atX, atY = obstacle.meet(v, i, j, x, y, toX, toY)
        local edge = commonEdge(v, i, j, atX, atY)
        if isBefore(v, journey, j, key, edge) then
          journey.next, journey.nextKey, journey.nextEdge = j, key, edge
        end
      end
    end
  end
  return journey.next
end

-- Sets the next leg after a hit at (x, y), at fraction `share` of this one.
local function turn(journey, x, y, axis, share, response)
  journey.start = journey.start + (1 - journey.start) * share
  journey.x, journey.y = x, y
  if response == "touch" then
    journey.toX, journey.toY = x, y
  elseif axis == 0 then
    journey.toX = response == "bounce" and x - (journey.toX - x) or x
  else
    journey.toY = response == "bounce" and y - (journey.toY - y) or y
  end
end

-- Returns the side of an object that overlaps another, by the opposite-sides rule.
local function deepSide(v, i, j)
  local position, size, k, m = v.position, v.size, 2 * i, 2 * j
  return aabb.side(
    position[k],
    position[k + 1],
    size[k],
    size[k + 1],
    position[m],
    position[m + 1],
    size[m],
    size[m + 1]
  )
end

-- Handles the impact with slot j; returns whether it ends the leg.
local function meet(v, journey, j)
  local i = journey.slot
  local object, other = v.object[i], v.object[j]
  local share, axis, isLow, x, y =
    obstacle.meet(v, i, j, journey.x, journey.y, journey.toX, journey.toY)
  -- An object that is inside another one at the start is not held there.
  local isSolid = axis ~= nil and obstacle.isSolid(v, i, j)
  local side = axis and obstacle.sides(axis, isLow) or deepSide(v, i, j)
  local response = respond(journey, object, other, isSolid)
  if response then
    note(journey, other, side, x, y, share, response)
  end
  if not response or response == "cross" then
    journey.passed[j] = true
    return false
  end
  turn(journey, x, y, axis, share, response)
  return true
end

-- Walks to the end of a leg; returns whether another one follows.
local function walk(v, journey)
  findNear(v, journey)
  local j = findNext(v, journey)
  while j and journey.count < MOST_HITS do
    if meet(v, journey, j) then
      return journey.x ~= journey.toX or journey.y ~= journey.toY
    end
    j = findNext(v, journey)
  end
  if not j then
    journey.x, journey.y = journey.toX, journey.toY
  end
  return false
end

-- Journeys ----------------------------------------------------------------------------------------

-- Returns a journey that is not in use. One that fails on the way is left to the garbage collector.
local function takeJourney(v)
  local pool = v.journeys
  if not pool then
    pool = {}
    v.journeys = pool
  end
  local journey = pool[#pool] or { found = {}, passed = {} }
  pool[#pool] = nil
  return journey
end

local function giveJourney(v, journey)
  for j in next, journey.passed, nil do
    journey.passed[j] = nil
  end
  journey.hits, journey.response, journey.world = false, false, false
  v.journeys[#v.journeys + 1] = journey
end

--- Moves an object towards (x, y). Returns its final position, the hits and their number; nil: it
--- is not in the world; false: it is static.
function slide.run(world, object, x, y, response, hits, where)
  local v = view.of(world)
  local i = view.find(v, world, object)
  if not i then
    return nil
  end
  view.lookAtFilter(v, i)
  if v.kind[i] == columns.STATIC then
    return false
  end
  local journey, k = takeJourney(v), 2 * i
  journey.world, journey.slot, journey.where = world, i, where
  journey.response, journey.hits, journey.count = response or "slide", hits or {}, 0
  journey.x, journey.y, journey.start = v.position[k], v.position[k + 1], 0
  journey.toX, journey.toY = x + 0.0, y + 0.0
  if v.active[i] then
    while walk(v, journey) do
    end
  else
    journey.x, journey.y = journey.toX, journey.toY
  end
  tidy(journey)
  local atX, atY, list, count = journey.x, journey.y, journey.hits, journey.count
  giveJourney(v, journey)
  if object.x ~= atX then
    object.x = atX
  end
  if object.y ~= atY then
    object.y = atY
  end
  view.follow(v, i)
  return atX, atY, list, count
end

interpreted.always(giveJourney)

return slide
