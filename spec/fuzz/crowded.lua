--- Makes games in which there is too little room: boxes put into each other, lifts that squeeze
--- them, boxes that grow or appear where others are. In the end nothing drives them any more, and
--- they have two seconds to come to rest; QUIET updates follow.

local newNumbers = require("spec.fuzz.numbers").new

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
  local id = self:add("boxes", {
    x = x or random:between(0, self.width - width),
    y = y or random:between(0, self.height - height),
    width = width,
    height = height,
    mass = random:chance(0.3) and n:mass() or nil,
    friction = random:chance(0.5) and random:between(0, 1) or nil,
    pushable = random:chance(0.03) and false or nil,
    drag = 30 * unit,
  })
  self.boxes[#self.boxes + 1] = id
end

local function addWalls(self)
  local unit, width, height = self.n.unit, self.width, self.height
  local thick = self.n.random:pick({ 0.125, 1, 4 }) * unit
  for _, wall in ipairs({
    { -thick, -thick, thick, height + 2 * thick },
    { width, -thick, thick, height + 2 * thick },
    { 0, -thick, width, thick },
    { 0, height, width, thick },
  }) do
    local object = { x = wall[1], y = wall[2], width = wall[3], height = wall[4], static = true }
    self:add("walls", object)
  end
end

-- A lift that comes out of a wall, a part of the way or nearly all of it.
local function addLift(self, seconds)
  local random, width, height = self.n.random, self.width, self.height
  local share = random:between(0.2, 0.95) / seconds
  local lift = { kinematic = true, width = width, height = height }
  local side = random:integer(1, 4)
  lift.x, lift.y = side == 1 and -width or side == 2 and width or 0, 0
  lift.vx = side == 1 and share * width or side == 2 and -share * width or nil
  if side > 2 then
    lift.y = side == 3 and -height or height
    lift.vy = side == 3 and share * height or -share * height
  end
  self.lifts[#self.lifts + 1] = self:add("lifts", lift)
end

local function grow(self)
  local random, unit = self.n.random, self.n.unit
  local size = random:between(0.5, 2.5) * unit
  self:put({ "write", random:pick(self.boxes), { width = size, height = size } })
end

local function turnOff(self)
  for _, id in ipairs(self.lifts) do
    self:put({ "write", id, { vx = 0, vy = 0 } })
  end
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
    if random:chance(busy) then
      if random:chance(0.5) then
        grow(self)
      else
        addBox(self)
      end
    end
    self:put({ "update", dt })
  end
  turnOff(self)
  for _ = 1, math.ceil(CALM / dt) + QUIET do
    self:put({ "update", dt })
  end
  local settings = { gravity = random:pick({ 0, 40 }) * unit }
  settings.broadphase = random:pick({ "auto", "pairs", "grid" })
  return { seed = seed, settings = settings, acts = self.acts }
end

crowded.QUIET = QUIET

return crowded
