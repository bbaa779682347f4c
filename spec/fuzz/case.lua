--- Makes random games. A case is data: settings, and a list of acts in order, among them the
--- updates. So it can be played in several worlds, made shorter, and written down:
---
---     { "add", id, group, fields }          fields of a new object
---     { "insert", id, group, fields }       the same by the game's own hand
---     { "write", id, fields }               a field `false` of those that may be nil is erased
---     { "erase", id, field }
---     { "remove", id }  { "take", id }      by the world, by the game's own hand
---     { "regroup", id, group }
---     { "refresh", id }  { "drop", id }  { "impulse", id, ix, iy }  { "move", id, x, y, response }
---     { "set", setting, value }  { "unset", setting }  { "bounds", x, y, w, h }
---     { "ask", x, y, w, h }                 all questions at a place
---     { "listen", id, event, acts }         does one of the acts at each event; id 0: the world
---     { "refuse", id, modulus }             canCollide: false for some ids
---     { "fail" }                            only inside a callback
---     { "reload" }                          restores what it saves, only in the tried world
---     { "twin" }                            from here on a restored copy goes along
---     { "update", dt }

local newNumbers = require("spec.fuzz.numbers").new
local tile = require("spec.support.small").tile

local case = {}

local GROUPS = { "boxes", "crates", "players", 1, 2.5 }
local SIDES = { "top", "bottom", "left", "right" }
local RESPONSES = { "slide", "touch", "cross", "bounce" }
local EVENTS = { "onBegin", "onStay", "onEnd", "onCrush" }
local ROOM = 20 -- units, width and height of the room

-- Fields -----------------------------------------------------------------------------------------

-- Ways to make a value, besides those of numbers.lua and random.lua.
local WAYS = {}

function WAYS.units(n, low, high)
  return n.random:between(low, high) * n.unit
end
function WAYS.zero(n, share)
  return n.random:chance(share) and 0 or n:acceleration()
end
function WAYS.rarely(n, high, low, usual) -- `high`, or a number in low..usual
  return n.random:chance(0.1) and high or n.random:between(low, usual)
end
function WAYS.is(_, value)
  return value
end
function WAYS.mask(n)
  local random = n.random
  return { [random:pick(GROUPS)] = false, [random:pick(GROUPS)] = random:chance(0.5) }
end
function WAYS.hits(n)
  local list = n.random:shuffled(GROUPS)
  list[#list + 1] = "statics"
  for _ = 1, n.random:integer(0, #list) do
    list[#list] = nil
  end
  return list
end
function WAYS.masks(n)
  return { [n.random:pick(GROUPS)] = WAYS.mask(n) }
end
function WAYS.soft(n)
  local row = { [n.random:pick(GROUPS)] = n:spread(0.1, 400) * n.unit }
  return { [n.random:pick(GROUPS)] = row, lifts = n.random:chance(0.2) and row or nil }
end
function WAYS.pull(n)
  return n.random:chance(0.5) and 40 * n.unit or n:acceleration()
end
function WAYS.cells(n)
  return n:spread(0.25, 40) * n.unit
end
function WAYS.group(n)
  return n.random:pick(GROUPS)
end

-- Returns a value for a row: what it is for, how often, the way to make it and its arguments.
local function make(n, row)
  local way, a, b, c = row[3], row[4], row[5], row[6]
  if WAYS[way] then
    return WAYS[way](n, a, b, c)
  elseif n[way] then
    return n[way](n, a, b)
  end
  return n.random[way](n.random, a, b)
end

-- Returns a table with a value for each row.
local function makeAll(n, rows)
  local made = {}
  for _, row in ipairs(rows) do
    made[row[1]] = make(n, row)
  end
  return made
end

-- Fields that may be there or not, in a fixed order: how often a new object has each, and its
-- value.
local SHARES = {
  { "friction", 0.4, "rarely", 10, 0, 1.2 },
  { "restitution", 0.3, "pick", { 0, 0.25, 0.5, 0.9, 1 } },
  { "mass", 0.3, "mass" },
  { "ax", 0.04, "acceleration" },
  { "ay", 0.04, "acceleration" },
  { "active", 0.03, "chance", 0.6 },
  { "sensor", 0.03, "chance", 0.6 },
  { "pushable", 0.1, "chance", 0.4 },
  { "gravity", 0.08, "zero", 0.4 },
  { "gravityX", 0.04, "zero", 0.4 },
  { "airFriction", 0.08, "rarely", 100, 0, 4 },
  { "drag", 0.08, "units", 0, 20 },
  { "maxSpeed", 0.06, "units", 0, 30 },
  { "maxSpeedX", 0.05, "units", 0, 20 },
  { "maxSpeedY", 0.05, "units", 0, 20 },
  { "mask", 0.06, "mask" },
  { "oneWay", 0.03, "pick", SIDES },
  { "carry", 0.04, "chance", 0.5 },
  { "surfaceSpeed", 0.05, "speed" },
  { "nudge", 0.08, "units", 0, 1 },
  { "hits", 0.05, "hits" },
  { "strength", 0.1, "integer", -1, 2 },
}

local OPTIONAL = {}
for _, row in ipairs(SHARES) do
  OPTIONAL[row[1]] = row
end

-- Gives it fields of a list, or any. A row that names no way to make a value is made as above.
local function addOptional(n, object, share, list)
  for _, row in ipairs(list or SHARES) do
    if n.random:chance(row[2] * share) then
      object[row[1]] = make(n, row[3] and row or OPTIONAL[row[1]])
    end
  end
  return object
end

-- Objects ----------------------------------------------------------------------------------------

-- An object between two heights of the room; it may be wider.
local function newAt(n, upper, lower, widths)
  local object = { x = n:place(0, ROOM), y = n:place(upper * ROOM, lower * ROOM) }
  object.width = n:size() * (widths and n.random:pick(widths) or 1)
  object.height = n:size()
  return object
end

local function newBox(n)
  local object =
    addOptional(n, newAt(n, 0, 0.8), 1, { { "vx", 0.6, "speed" }, { "vy", 0.5, "speed" } })
  return addOptional(n, object, 1)
end

local function newStatic(n)
  local object = addOptional(n, newAt(n, 0.4, 1, { 1, 1, 3 }), 0.4)
  object.static, object.oneWay = true, n.random:chance(0.2) and n.random:pick(SIDES) or nil
  return object
end

local DRIVEN = { { "vx", 0.6, "place", -5, 5 }, { "vy", 0.4, "place", -5, 5 } }

local function newPlatform(n)
  local object = addOptional(n, newAt(n, 0.4, 1, { 1, 3 }), 1, DRIVEN)
  object.kinematic = true
  return addOptional(n, object, 0.4)
end

-- The acts ---------------------------------------------------------------------------------------

local Maker = {}
Maker.__index = Maker

function Maker:put(act)
  self.acts[#self.acts + 1] = act
end

function Maker:add(group, object)
  self.count = self.count + 1
  local how = self.n.random:chance(0.7) and "add" or "insert"
  return { how, self.count, group, object }
end

function Maker:anybody()
  return self.n.random:integer(1, self.count)
end

-- A floor of tiles, walls, perhaps a ceiling.
local function makeRoom(self)
  local n = self.n
  local unit, random = n.unit, n.random
  local span = ROOM * unit
  for i = 0, ROOM - 1 do
    self:put(self:add("tiles", tile(unit * i, span, unit, unit)))
  end
  for _, x in ipairs({ -unit, span }) do
    self:put(self:add("walls", addOptional(n, tile(x, -span, unit, 2 * span + unit), 0.2)))
  end
  if random:chance(0.5) then
    self:put(self:add("walls", tile(0, -unit, span, unit)))
  end
end

-- Boxes on each other, flush: stacks, rows.
local function makeStack(self)
  local n = self.n
  local random, unit = n.random, n.unit
  local x, y, isRow = n:place(2, 16), ROOM * unit, random:chance(0.3)
  for _ = 1, random:integer(2, 6) do
    local box = newBox(n)
    box.width, box.height, box.vx, box.vy = unit, unit, nil, nil
    if isRow then
      box.x, box.y = x, ROOM * unit - unit
      x = x + unit
    else
      y = y - unit
      box.x, box.y = x, y
    end
    self:put(self:add(random:pick(GROUPS), box))
  end
end

local WRITES = {
  { { "vx", nil, "speed" }, { "vy", nil, "speed" } },
  { { "vy", nil, "units", -5, -30 } },
  { { "x", nil, "place", 0, ROOM }, { "y", nil, "place", 0, ROOM * 0.9 } },
  { { "width", nil, "size" }, { "height", nil, "size" } },
  { { "kinematic", nil, "chance", 0.3 } },
  { { "static", nil, "chance", 0.3 } },
}

local function newWrite(self)
  local n = self.n
  local random = n.random
  if random:chance(0.5) then
    return { "write", self:anybody(), makeAll(n, random:pick(WRITES)) }
  end
  local name = random:pick(SHARES)[1]
  if random:chance(0.3) then
    return { "erase", self:anybody(), name }
  end
  return { "write", self:anybody(), { [name] = make(n, OPTIONAL[name]) } }
end

-- Settings: their names, whether they may be nil, the way to make a value.
local SETTINGS = {
  { "gravity", false, "pull" },
  { "gravityX", false, "zero", 0.6 },
  { "push", false, "pick", { "both", "first" } },
  { "masks", true, "masks" },
  { "soft", true, "soft" },
  { "sideBySide", false, "chance", 0.5 },
  { "broadphase", false, "pick", { "auto", "pairs", "grid" } },
  { "cellSize", true, "cells" },
  { "maxStep", false, "pick", { 1 / 30, 1 / 60, 0.01, 0.1 } },
  { "order", true, "shuffled", { "boxes", "crates", 1 } },
  { "rest", false, "chance", 0.7 },
}

local function newSetting(self)
  local row = self.n.random:pick(SETTINGS)
  if row[2] and self.n.random:chance(0.5) then
    return { "unset", row[1] }
  end
  return { "set", row[1], make(self.n, row) }
end

local function newAdd(self)
  local n = self.n
  local kind = n.random:integer(1, 10)
  if kind == 1 then
    return self:add("statics", newStatic(n))
  elseif kind == 2 then
    return self:add("lifts", newPlatform(n))
  end
  return self:add(n.random:pick(GROUPS), newBox(n))
end

local function newMove(self)
  local n = self.n
  local response = n.random:pick(RESPONSES)
  return { "move", self:anybody(), n:place(0, ROOM), n:place(0, ROOM), response }
end

local function newBounds(self)
  local n = self.n
  local size = n.random:between(0.5, 1.2) * ROOM * n.unit
  return { "bounds", n:place(0, 2), n:place(0, 2), size, size }
end

local function newQuestion(self)
  local n = self.n
  local w, h = n.random:between(0.1, 8) * n.unit, n.random:between(0.1, 8) * n.unit
  return { "ask", n:place(-1, ROOM), n:place(-1, ROOM), w, h }
end

-- How often in 92 acts; what makes it, or of those with an object, which of these, and with what.
local ACTS = {
  { 45, newWrite },
  { 8, newAdd },
  { 5, newSetting },
  { 6, { "remove", "remove", "take" } },
  { 3, { "regroup" }, "group" },
  { 3, { "refresh" } },
  { 5, { "drop" } },
  { 6, { "impulse" }, "speed", "speed" },
  { 5, newMove },
  { 1, newBounds },
  { 5, newQuestion },
}

-- Something that a game may do between two updates or in a callback.
local function newAct(self)
  local roll = self.n.random:integer(1, 92)
  for _, row in ipairs(ACTS) do
    roll = roll - row[1]
    if roll <= 0 and type(row[2]) == "function" then
      return row[2](self)
    elseif roll <= 0 then
      local act = { #row[2] > 1 and self.n.random:pick(row[2]) or row[2][1], self:anybody() }
      for i = 3, #row do
        act[i] = make(self.n, { nil, nil, row[i] })
      end
      return act
    end
  end
end

local function newListener(self)
  local random, acts = self.n.random, {}
  for m = 1, random:integer(1, 5) do
    acts[m] = newAct(self)
  end
  local id = random:chance(0.2) and 0 or self:anybody()
  if id == 0 and random:chance(0.3) then
    acts[#acts + 1] = { "fail" }
  end
  return { "listen", id, random:pick(EVENTS), acts }
end

-- What happens before one update.
local function makeTurn(self)
  local random = self.n.random
  while random:chance(self.busy) do
    self:put(newAct(self))
  end
  if random:chance(self.busy * 0.1) then
    self:put(newListener(self))
  end
  if random:chance(self.busy * 0.01) then
    self:put({ "refuse", random:chance(0.2) and 0 or self:anybody(), random:integer(2, 4) })
  end
  if random:chance(0.02) then
    self:put({ "reload" })
  end
  if random:chance(0.02) then
    self:put({ "twin" })
  end
  self:put({ "update", self.n:dt() })
end

-- Closed games ------------------------------------------------------------------------------------

-- Nothing but boxes that bump: no way for energy to come in. Without walls and gravity all momentum
-- stays, too.

local CLOSED = { { "friction", 0.4 }, { "restitution", 0.5 }, { "mass", 0.5 } }

local function makeClosedBox(self, column, row)
  local n = self.n
  -- On a raster wide enough that no box stands in another at first.
  local box = { x = n:snap((2.5 * column + 1) * n.unit), y = n:snap((2.5 * row + 1) * n.unit) }
  box.width, box.height = n:place(0.5, 2), n:place(0.5, 2)
  box.vx, box.vy = n:place(-25, 25), n:place(-25, 25)
  addOptional(n, box, 1, CLOSED)
  self:put(self:add(n.random:pick(GROUPS), box))
end

-- Returns the settings.
local function makeClosed(self, steps)
  local n = self.n
  local hasWalls = n.random:chance(0.5)
  for column = 0, 6 do
    for row = 0, 5 do
      if n.random:chance(0.5) then
        makeClosedBox(self, column, row)
      end
    end
  end
  if hasWalls then
    makeRoom(self)
  end
  for _ = 1, steps do
    self:put({ "update", n:dt() })
  end
  return {
    gravity = hasWalls and n.random:chance(0.5) and 40 * n.unit or 0,
    push = n.random:pick({ "both", "first" }),
    broadphase = n.random:pick({ "auto", "pairs", "grid" }),
  }
end

-- Squeezed games ----------------------------------------------------------------------------------

-- A stack, or a row, between two ends that do not give way, one of which may come nearer, and more
-- and more boxes that appear in it and in the ends: all boxes are crushed, pushed out or pushed on.

local SQUEEZED = {
  { "vx", 0.3, "speed" },
  { "vy", 0.3, "speed" },
  { "pushable", 0.25 },
  { "mass", 0.3 },
  { "friction", 0.3 },
  { "restitution", 0.2 },
}

-- Adds an object that takes the place from `at` to `at + size` of the stack, px.
local function squeeze(self, group, at, size, object)
  local n = self.n
  local across = n.random:chance(0.6) and 4 * n.unit or n:place(3.5, 4.5)
  local width = n.random:chance(0.5) and n.unit or n:size()
  object.x, object.y, object.width, object.height = across, at, width, size
  if self.isRow then
    object.x, object.y, object.width, object.height = at, across, size, width
  end
  self:put(self:add(group, object))
end

local function squeezeBox(self, at, size)
  local n = self.n
  local box = addOptional(n, {}, 1, SQUEEZED)
  squeeze(self, n.random:pick(GROUPS), at, size, box)
end

-- Something at one end that pushes, or does not give way.
local function squeezeEnd(self, at, isMoving)
  local n = self.n
  local object = { static = not isMoving or nil, kinematic = isMoving or nil }
  object[self.isRow and "vx" or "vy"] = isMoving and n:place(-2, 10) or nil
  squeeze(self, isMoving and "lifts" or "statics", at, n.unit, object)
end

local function makeSqueezed(self, steps)
  local n = self.n
  local random, unit = n.random, n.unit
  local at = 10 * unit
  self.isRow = random:chance(0.3)
  for _ = 1, random:integer(2, 5) do
    local size = random:chance(0.5) and unit or n:place(0.5, 2)
    at = at - size
    squeezeBox(self, at, size)
  end
  if random:chance(0.5) then
    squeezeEnd(self, 10 * unit, random:chance(0.3))
  end
  squeezeEnd(self, at - unit + (random:chance(0.5) and 0 or n:place(-0.7, 0.7)), random:chance(0.4))
  for _ = 1, steps do
    if random:chance(0.1) then
      squeezeBox(self, at + n:place(-1, 0), random:chance(0.5) and unit or n:size())
    end
    self:put({ "update", n:dt() })
  end
end

-- Games ------------------------------------------------------------------------------------------

local function newSettings(n)
  local random = n.random
  local settings = { gravity = random:pick({ 0, 40, 40, 40 }) * n.unit }
  for _, row in ipairs(SETTINGS) do
    if row[1] ~= "gravity" and random:chance(0.15) then
      settings[row[1]] = make(n, row)
    end
  end
  if random:chance(0.1) then
    settings.timestep = random:pick({ 1 / 60, 1 / 50, 1 / 120 })
  end
  return settings
end

-- Where the fields of an act are that hold x and y, and where x and y themselves.
local FIELDS_AT, PLACE_AT = { add = 4, insert = 4, write = 3 }, { move = 3, bounds = 2, ask = 2 }

-- Plays the same elsewhere.
local function shift(acts, by)
  for _, act in ipairs(acts) do
    local place, x, y = act[FIELDS_AT[act[1]]], "x", "y"
    if PLACE_AT[act[1]] then
      place, x, y = act, PLACE_AT[act[1]], PLACE_AT[act[1]] + 1
    elseif act[1] == "listen" then
      shift(act[4], by)
    end
    if place and place[x] then
      place[x], place[y] = place[x] + by, place[y] + by
    end
  end
end

-- What makes an engine that is held back by a limit, and rubs.
local ENGINE = {
  { "ax", 0.5 },
  { "ay", 0.1 },
  { "friction", 0.6 },
  { "maxSpeed", 0.15 },
  { "maxSpeedX", 0.5 },
  { "maxSpeedY", 0.15 },
}

-- What makes a walker on stairs.
local WALKER = {
  { "snap", 0.7, "units", 0, 1 },
  { "nudge", 0.4 },
  { "maxFallSpeed", 0.3, "units", 0, 20 },
}

-- Gives fields of a list to many of the movers. (With numbers of its own: it makes no other
-- game of the rest.)
local function equip(acts, seed, list)
  local n = newNumbers(seed)
  for _, act in ipairs(acts) do
    local object = FIELDS_AT[act[1]] == 4 and act[4]
    if object and not (object.static or object.kinematic) then
      addOptional(n, object, 1, list)
    end
  end
end

local AREAS = {
  { { "gravity", nil, "acceleration" } },
  { { "ax", nil, "acceleration" }, { "airFriction", nil, "between", 0, 3 } },
  { { "attract", nil, "acceleration" }, { "law", nil, "is", "square" } },
  { { "drag", nil, "units", 0, 20 }, { "gravityX", nil, "acceleration" } },
}

-- Makes circles and zones of many that are added.
local function round(acts, seed)
  local n = newNumbers(seed)
  for _, act in ipairs(acts) do
    local object = FIELDS_AT[act[1]] == 4 and act[4]
    if object and n.random:chance(0.05) then
      object.sensor, object.area = true, makeAll(n, n.random:pick(AREAS))
      object.width, object.height = 6 * n.unit, 6 * n.unit
    end
    if object and not object.oneWay and object.width < 7 * n.unit and n.random:chance(0.5) then
      object.height, object.radius = object.width, object.width / 2
    end
  end
end

--- Makes the case of a seed. Every third is about the origin, where coordinates change their sign,
--- every tenth is about engines and their limits, every tenth about walkers with `snap`, every
--- seventh has circles and zones.
---@param seed integer
---@param steps integer updates
---@return table case `{ seed, settings, acts, closed }`
function case.new(seed, steps)
  local n = newNumbers(seed)
  local random = n.random
  local self = setmetatable({ n = n, acts = {}, count = 0 }, Maker)
  if random:chance(0.15) then
    local settings = makeClosed(self, steps)
    return { seed = seed, settings = settings, acts = self.acts, closed = true }
  end
  if random:chance(0.1) then
    local settings = newSettings(n)
    makeSqueezed(self, steps)
    return { seed = seed, settings = settings, acts = self.acts }
  end
  -- Calm games, in which things come to rest, and wild ones.
  self.busy = random:pick({ 0, 0.02, 0.1, 0.3, 0.6 })
  if random:chance(0.8) then
    makeRoom(self)
  end
  for _ = 1, random:integer(0, 3) do
    makeStack(self)
  end
  for _ = 1, random:integer(1, 20) do
    self:put(newAdd(self))
  end
  for _ = 1, random:integer(0, 4) do
    self:put(self:add("statics", newStatic(n)))
  end
  for _ = 1, random:integer(0, 3) do
    self:put(self:add("lifts", newPlatform(n)))
  end
  local settings = newSettings(n)
  for _ = 1, steps do
    makeTurn(self)
  end
  if seed % 10 == 4 then
    equip(self.acts, seed, ENGINE)
  elseif seed % 10 == 7 then
    equip(self.acts, seed, WALKER)
  end
  if seed % 7 == 5 then
    round(self.acts, seed)
  end
  if seed % 3 == 2 then
    shift(self.acts, -ROOM / 2 * n.unit)
  end
  return { seed = seed, settings = settings, acts = self.acts }
end

return case
