--- Makes games in which there is too little room: boxes put into each other, lifts that squeeze
--- them, boxes that grow or appear where others are. In the end nothing drives them any more, and
--- they have two seconds to come to rest; `{ "calm", x1, y1, x2, y2 }` says from when on, and where
--- they have to be.

local newNumbers = require("spec.fuzz.numbers").new
local small = require("spec.support.small")

local crowded = {}

local SIDE = 12 -- units, of the room at most
local CALM = 2 -- s
local QUIET = 10 -- updates at rest that are looked at

local Maker = {}
Maker.__index = Maker

function Maker:put(act)
  self.acts[#self.acts + 1] = act
end

function Maker:add(group, object)
  self.count = self.count + 1
  self:put({ "add", self.count, group, object })
  return self.count
end

-- A box somewhere in the room. All are braked by the air, so that none moves for ever.
local function addBox(self, x, y)
  local n = self.n
  local random, unit = n.random, n.unit
  local width, height = random:between(0.4, 1.6) * unit, random:between(0.4, 1.6) * unit
  if random:chance(0.5) then
    width, height = unit, unit
  end
  x = x or random:between(0, self.width - width)
  y = y or random:between(0, self.height - height)
  local box = small.put(x, y, width, height, { drag = 30 * unit })
  box.mass = random:chance(0.3) and n:mass() or nil
  box.friction = random:chance(0.5) and random:between(0, 1) or nil
  random:unit() -- (as when these seeds were chosen)
  self.boxes[#self.boxes + 1] = self:add("boxes", box)
end

local function addWalls(self)
  local unit, width, height = self.n.unit, self.width, self.height
  local thick = self.n.random:pick({ 0.125, 1, 4 }) * unit
  self:add("walls", small.tile(-thick, -thick, thick, height + 2 * thick))
  self:add("walls", small.tile(width, -thick, thick, height + 2 * thick))
  self:add("walls", small.tile(0, -thick, width, thick))
  self:add("walls", small.tile(0, height, width, thick))
end

-- A lift that comes out of a wall, a part of the way or nearly all of it.
local function addLift(self, seconds)
  local random, width, height = self.n.random, self.width, self.height
  local share, side = random:between(0.2, 0.95) / seconds, random:integer(1, 4)
  local way, isX = side % 2 == 1 and 1 or -1, side < 3
  local x, y = isX and -way * width or 0, not isX and -way * height or 0
  local lift = small.put(x, y, width, height, { kinematic = true })
  lift.vx, lift.vy = isX and way * share * width or nil, not isX and way * share * height or nil
  self.lifts[#self.lifts + 1] = self:add("lifts", lift)
end

--- Makes the crowded case of a seed.
---@param seed integer
---@param steps integer updates while something drives it
---@return table case `{ seed, settings, acts }`
function crowded.new(seed, steps)
  local n = newNumbers(seed)
  local random, unit = n.random, n.unit
  local self = setmetatable({ n = n, acts = {}, count = 0, boxes = {}, lifts = {} }, Maker)
  local dt = random:pick({ 1 / 60, 1 / 60, 1 / 30, 1 / 144 })
  self.width = random:integer(3, SIDE) * unit
  self.height = random:integer(3, SIDE) * unit
  addWalls(self)
  local isSpot, busy = random:chance(0.4), random:pick({ 0, 0, 0.05, 0.3 })
  local x, y = random:between(0, 0.8) * self.width, random:between(0, 0.8) * self.height
  for _ = 1, random:integer(2, 40) do
    addBox(self, isSpot and x or nil, isSpot and y or nil)
  end
  for _ = 1, random:integer(0, 2) do
    addLift(self, steps * dt)
  end
  for _ = 1, steps do
    local isBusy = random:chance(busy)
    if isBusy and random:chance(0.5) then
      local size = random:between(0.5, 2.5) * unit
      self:put({ "write", random:pick(self.boxes), { width = size, height = size } })
    elseif isBusy then
      addBox(self)
    end
    self:put({ "update", dt })
  end
  for _, id in ipairs(self.lifts) do
    self:put({ "write", id, { vx = 0, vy = 0 } })
  end
  self:put({ "calm", 0, 0, self.width, self.height })
  for _ = 1, math.ceil(CALM / dt) + QUIET do
    self:put({ "update", dt })
  end
  local settings = { gravity = random:pick({ 0, 40 }) * unit }
  settings.broadphase = random:pick({ "auto", "pairs", "grid" })
  return { seed = seed, settings = settings, acts = self.acts }
end

crowded.CALM = CALM

return crowded
