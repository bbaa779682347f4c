--- What must hold after every step, whatever the game did. Looks only at what the game can see.
--
--   local watch = checks.new(player)      before the first act
--   watch:before()                        before an update
--   local name, text = watch:after()      after it: nil, or what does not hold

-- Runs no slower without the trace compiler, which has too many loops to see here.
local jit = rawget(_G, "jit")
if jit then
  jit.off(true, true)
end

local overlap = require("spec.support.overlap")

local checks = {}

local Watch = {}
Watch.__index = Watch

--- px: two that press each other may overlap by this much; it is the promise of the README.
checks.TOLERANCE = 1e-6
--- px, and updates: what meets more often than the rounds of a step allow may overlap by so much,
--- or a tenth of the smaller one, and is apart again by then.
checks.KNOT, checks.KNOT_UPDATES = 16, 20
--- Share of the smaller one by which circles may overlap in a knot, and by which they may go on
--- overlapping in a heap.
checks.ROUND_KNOT, checks.ROUND_HEAP = 0.5, 0.125
--- px: in a row that fills its room to the pixel two may go on overlapping by this much.
checks.FULL = 0.2

local OPPOSITE = { left = "right", right = "left", top = "bottom", bottom = "top" }
local FAR = 1e15 -- beyond this, px or px/s, something has gone wild; the games stay far below
local max, min = math.max, math.min

-- Geometry ---------------------------------------------------------------------------------------

-- px by which two may overlap in a knot; `usual`: of two boxes.
local function most(a, b, share, usual)
  local size = min(a.width, a.height, b.width, b.height)
  return max(usual, (a.radius or b.radius) and share * size or 0)
end

-- px from which on a ball in a heap touches what is near it.
local IN_HEAP = 0.05

-- What rounding may add at these coordinates.
local function slack(a, b)
  local size = max(math.abs(a.x), math.abs(a.y), math.abs(b.x), math.abs(b.y), a.width, a.height)
  return checks.TOLERANCE + max(size, b.width, b.height) * 2 ^ -50
end

-- Filters ----------------------------------------------------------------------------------------

local function isDynamic(object)
  return not object.static and not object.kinematic
end

local function isListed(list, name)
  for _, listed in ipairs(list) do
    if listed == name then
      return true
    end
  end
  return false
end

local function refuses(a, groupA, groupB, masks)
  if a.hits and not isListed(a.hits, groupB) then
    return true
  end
  local row = masks and masks[groupA]
  return a.mask and a.mask[groupB] == false or row and row[groupB] == false
end

-- Whether two are soft to each other.
local function areSoft(a, b, groupA, groupB, soft)
  local row, other = soft and soft[groupA], soft and soft[groupB]
  return (row and row[groupB] or other and other[groupA])
    and not (a.static or b.static or a.sensor or b.sensor)
end

function Watch:canMeet(a, b)
  local groupA, groupB = self.groupOf[a], self.groupOf[b]
  local masks = self.player.world.masks
  if not groupA or not groupB or a.active == false or b.active == false then
    return false
  end
  return not (
    refuses(a, groupA, groupB, masks)
    or refuses(b, groupB, groupA, masks)
    or areSoft(a, b, groupA, groupB, self.player.world.soft)
  )
end

-- Whether two must not overlap: nothing lets one pass through the other.
function Watch:isBarred(a, b)
  return not (a.sensor or b.sensor or a.oneWay or b.oneWay)
    and not self.asked
    and self:canMeet(a, b)
end

-- The world --------------------------------------------------------------------------------------

-- Lists the objects in the game's tables.
function Watch:look()
  self.all, self.groupOf = {}, {}
  for group, members in pairs(self.player.world.objects) do
    for _, object in pairs(members) do
      self.groupOf[object] = group
      self.all[#self.all + 1] = object
    end
  end
  self.asked = next(self.player.refusals) ~= nil
end

function Watch:isSettled(object)
  local id = self.player.idOf[object]
  return not (id and self.player.touched[id])
end

local function nameOf(self, object)
  local id = self.player.idOf[object]
  return id and "object " .. id or "a wall"
end

-- Finite -----------------------------------------------------------------------------------------

function Watch:checkFinite()
  for _, object in ipairs(self.all) do
    for _, field in ipairs({ "x", "y", "vx", "vy" }) do
      local value = object[field]
      if value and not (value > -FAR and value < FAR) then
        return "finite", ("%s: %s is %.17g"):format(nameOf(self, object), field, value)
      end
    end
  end
end

-- Static objects ---------------------------------------------------------------------------------

local KEPT = { "x", "y", "vx", "vy", "width", "height", "static", "touching" }

function Watch:noteStatics()
  self.statics = {}
  for _, object in ipairs(self.all) do
    if object.static then
      local copy = {}
      for _, field in ipairs(KEPT) do
        copy[field] = object[field]
      end
      self.statics[object] = copy
    end
  end
end

function Watch:checkStatics()
  for object, copy in pairs(self.statics) do
    for _, field in ipairs(self:isSettled(object) and KEPT or {}) do
      if object[field] ~= copy[field] then
        return "static", ("%s: %s has changed"):format(nameOf(self, object), field)
      end
    end
  end
end

-- How deep each dynamic object stands in each static one it must not be in.
function Watch:noteDepths()
  self.depths = {}
  for _, a in ipairs(self.all) do
    if isDynamic(a) then
      local row = {}
      self.depths[a] = row
      for object in pairs(self.statics) do
        row[object] = max(0, overlap.depth(a, object))
      end
    end
  end
end

-- It may come out of a wall, or stay where the game has put it, but never go in. A crushed object
-- may be pressed into one, until it is free again.
function Watch:checkDepths()
  for _, a in ipairs(self.all) do
    local row, id = self.depths[a], self.player.idOf[a]
    if row and isDynamic(a) and self:isSettled(a) and not self.crushed[id] then
      for object, before in pairs(row) do
        local now = overlap.depth(a, object)
        if
          now > before + most(a, object, checks.ROUND_KNOT, slack(a, object))
          and self:isSettled(object)
          and self:isBarred(a, object)
        then
          local text = "%s went %.9g px into %s, it was %.9g px before"
          return "static overlap",
            text:format(nameOf(self, a), now, nameOf(self, object), before),
            now - before
        end
      end
    end
  end
end

-- Calls visit(key, a, b, depth) for each pair that overlaps and must not.
function Watch:eachOverlap(visit)
  for n, a in ipairs(self.all) do
    for m = n + 1, #self.all do
      local b = self.all[m]
      if isDynamic(a) or isDynamic(b) then
        local deep = overlap.depth(a, b)
        if deep > slack(a, b) and self:isBarred(a, b) then
          visit(nameOf(self, a) .. " and " .. nameOf(self, b), a, b, deep)
        end
      end
    end
  end
end

-- Notes whether nothing overlaps before an update that was not left so by a step: what parts may
-- push others into each other.
function Watch:noteOverlaps()
  self.isClean = not next(self.crushed)
  self:eachOverlap(function(key)
    self.isClean = self.isClean and self.knots[key] ~= nil
  end)
end

-- Two that did not overlap come to do so only in a knot, which a step has to leave unsolved: not
-- deep, and not for long, unless something is crushed.
function Watch:checkOverlaps()
  local before, name, text, how = self.knots, nil, nil, nil
  self.knots = {}
  if not self.isClean or next(self.crushed) or next(self.player.touched) then
    return
  end
  self:eachOverlap(function(key, a, b, deep)
    self.knots[key] = (before[key] or 0) + 1
    local usual = max(checks.KNOT, 0.1 * min(a.width, a.height, b.width, b.height))
    local full = most(a, b, checks.ROUND_HEAP, checks.FULL)
    local isLong = deep > full and self.knots[key] > checks.KNOT_UPDATES
    if deep > most(a, b, checks.ROUND_KNOT, usual) or isLong then
      name, how = "overlap", deep
      text = ("%s overlap by %.9g px, for %d updates"):format(key, deep, self.knots[key])
    end
  end)
  return name, text, how
end

-- A crushed object stays so until it overlaps nothing that it could push, and the world no longer
-- holds it. Of a crushed row, one alone may be inside the wall for a step.
function Watch:updateCrushed()
  for id in pairs(self.crushed) do
    local a, bodies = self.player.list[id], self.player.world._bodies
    local k = 2 * (bodies.slotOf[a] or 0)
    local isFree = not (bodies.wasCrushed[k] or bodies.wasCrushed[k + 1])
    for _, b in ipairs(self.all) do
      if a ~= b and overlap.depth(a, b) > slack(a, b) and self:isBarred(a, b) then
        isFree = false
        break
      end
    end
    if isFree or not self.groupOf[a] then
      self.crushed[id] = nil
    end
  end
end

-- Returns a name for the pair, and whether its second object comes first in the name. Which one is
-- told first may change when one moves to another group.
local function keyOf(self, a, b)
  local first, second = self.player.idOf[a], self.player.idOf[b]
  if first and second then
    return min(first, second) .. " " .. max(first, second), second < first
  end
end

-- touching ---------------------------------------------------------------------------------------

-- Whether b may stand in a.touching[side]; else what is wrong.
function Watch:judgeNeighbour(a, side, b)
  if not b then
    return
  elseif not self.groupOf[b] then
    return "is an object that is not in the world"
  elseif a.sensor or b.sensor then
    return "is a sensor, or the object is one"
  elseif not self:canMeet(a, b) then
    return "is an object that it cannot meet"
  end
  local key = keyOf(self, a, b)
  if (not key or self.hits[key]) and self.player.world:touching(a, b) ~= side then
    return -- it was hit in this update, and left again
  end
  if b.slope and self.player.world:touching(a, b) ~= side then
    return -- it has stopped the object below a ceiling, beside which it is the ground, too
  end
  local x = min(a.x + a.width, b.x + b.width) - max(a.x, b.x)
  local y = min(a.y + a.height, b.y + b.height) - max(a.y, b.y)
  local limit = (a.radius or b.radius) and IN_HEAP or slack(a, b)
  if x < -limit or y < -limit then
    return ("is %.9g px away on x, %.9g px on y"):format(-x, -y)
  end
  local world = self.player.world
  local its, back = world:touching(a, b), world:touching(b, a)
  if its ~= side or back ~= OPPOSITE[side] then
    return ("is told to be at its %s, itself at the other's %s"):format(
      tostring(its),
      tostring(back)
    )
  elseif isDynamic(b) and not (b.touching and b.touching[OPPOSITE[side]]) then
    return "does not touch back"
  end
end

function Watch:checkTouching()
  for _, a in ipairs(self.all) do
    if isDynamic(a) and self:isSettled(a) then
      for _, side in ipairs({ "top", "bottom", "left", "right" }) do
        if not a.touching and a.active ~= false then
          return "touching", nameOf(self, a) .. " has no touching"
        end
        local b = a.touching and a.touching[side]
        if not b or self:isSettled(b) then
          local wrong = self:judgeNeighbour(a, side, b)
          if wrong then
            local text = "%s.touching.%s %s"
            return "touching", text:format(nameOf(self, a), side, wrong)
          end
        end
      end
    end
  end
end

-- Events -----------------------------------------------------------------------------------------

function Watch:complain(name, text)
  if not self.complaint then
    self.complaint = { name, text }
  end
end

function Watch:onBegin(key, a, b, side, speed)
  if self.open[key] then
    self:complain("pairing", ("onBegin of %s twice"):format(key))
  elseif speed ~= speed or speed < 0 or speed >= FAR then
    self:complain("pairing", ("onBegin of %s with speed %s"):format(key, tostring(speed)))
  elseif self.groupOf[a] and self.groupOf[b] then
    -- After a callback has failed, what is told now may have waited since then.
    local isNew = not self.player.failed and self:isSettled(a) and self:isSettled(b)
    if isNew and not self:canMeet(a, b) then
      self:complain("masks", ("onBegin of %s, which cannot meet"):format(key))
    end
  end
  self.open[key], self.hits[key] = { a, b, side }, true
end

function Watch:onEnd(key, _, _, side)
  local open = self.open[key]
  if not open then
    self:complain("pairing", ("onEnd of %s without onBegin"):format(key))
  elseif open[3] ~= side then
    self:complain("pairing", ("onEnd of %s at the %s, begun at the %s"):format(key, side, open[3]))
  end
  self.open[key] = nil
end

-- Called by the player for every event of the world.
local function hear(self, name, a, b, side, more)
  if name == "onCrush" then
    local id = self.player.idOf[a]
    if id then
      self.crushed[id] = true
    end
    for _, other in ipairs({ b, side }) do -- the two that hold it
      if type(other) ~= "table" or other == a then
        self:complain("crush", ("%s is crushed by %s"):format(nameOf(self, a), tostring(other)))
      end
    end
    return
  end
  local key, isSwapped = keyOf(self, a, b)
  if isSwapped then
    a, b, side = b, a, OPPOSITE[side]
  end
  if key then
    self[name](self, key, a, b, side, more)
  end
end

-- Contacts that were begun and not ended are there, and no others.
function Watch:checkContacts()
  local world = self.player.world
  for key, contact in pairs(self.open) do
    local a, b = contact[1], contact[2]
    if self:isSettled(a) and self:isSettled(b) then
      if not self.groupOf[a] or not self.groupOf[b] then
        return "pairing", ("contact %s goes on, but one has left"):format(key)
      elseif world:touching(a, b) ~= contact[3] then
        local text = "contact %s began at the %s, now it is %s"
        return "pairing", text:format(key, contact[3], tostring(world:touching(a, b)))
      end
    end
  end
end

function Watch:checkUntold()
  local world = self.player.world
  if world.sideBySide then
    return
  end
  for n, a in ipairs(self.all) do
    for m = n + 1, #self.all do
      local b = self.all[m]
      local key = keyOf(self, a, b)
      if key and not self.open[key] and overlap.depth(a, b) >= -checks.TOLERANCE then
        if self:isSettled(a) and self:isSettled(b) and world:touching(a, b) then
          return "pairing", ("contact %s was never told"):format(key)
        end
      end
    end
  end
end

-- Energy and momentum ----------------------------------------------------------------------------

-- Share of the whole that rounding may add in a step.
local ROUNDING = 1e-9
-- The same under gravity for each contact. A body that is pushed upwards out of another one gains
-- height for nothing, hardly any if both give way.
local LIFTED = 1e-6

-- What all that moves has together: energy, momentum on x and y; and the sizes of the latter two.
function Watch:sums()
  local world = self.player.world
  local kinetic, potential, x, y, sizeX, sizeY = 0, 0, 0, 0, 0, 0
  for _, object in ipairs(self.all) do
    if isDynamic(object) then
      local mass, vx, vy = object.mass or 1, object.vx or 0, object.vy or 0
      kinetic = kinetic + 0.5 * mass * (vx * vx + vy * vy)
      potential = potential - mass * world.gravity * (object.y - self.floor)
      x, y = x + mass * vx, y + mass * vy
      sizeX, sizeY = sizeX + mass * math.abs(vx), sizeY + mass * math.abs(vy)
    end
  end
  return kinetic, potential, x, y, sizeX, sizeY
end

function Watch:noteSums()
  if self.closed then
    self.floor = 0
    for object in pairs(self.statics) do
      self.floor = max(self.floor, object.y)
    end
    self.kinetic, self.potential, self.x, self.y, self.sizeX, self.sizeY = self:sums()
  end
end

-- What an update of dt s may add. With push = "first" one alone is put out of the way of the other
-- in each contact, so one of the two is up to the way on which they met too high.
function Watch:energyLimit(before, dt)
  local world = self.player.world
  if world.gravity == 0 then
    return ROUNDING * math.abs(before)
  end
  local contacts = self.contacts
  local limit, heaviest, fastest = LIFTED * max(1, contacts) * math.abs(before), 0, 0
  if world.push == "first" then
    for _, object in ipairs(self.all) do
      if isDynamic(object) then
        heaviest = max(heaviest, object.mass or 1)
        fastest = max(fastest, math.abs(object.vy or 0))
      end
    end
    fastest = fastest + world.gravity * dt
    limit = limit + contacts * heaviest * world.gravity * 2 * fastest * dt
  end
  return limit
end

function Watch:checkSums(dt)
  if not self.closed then
    return
  end
  local kinetic, potential, x, y = self:sums()
  local before = self.kinetic + self.potential
  local grown = kinetic + potential - before
  if grown > self:energyLimit(before, dt) + 1e-12 then
    local text = "energy grew by %.9g, it was %.9g (%.3g)"
    return "energy", text:format(grown, before, grown / before)
  end
  if next(self.statics) then
    return -- walls take up momentum
  end
  if
    math.abs(x - self.x) > ROUNDING * self.sizeX or math.abs(y - self.y) > ROUNDING * self.sizeY
  then
    local text = "momentum %.9g, %.9g was %.9g, %.9g before"
    return "momentum", text:format(x, y, self.x, self.y)
  end
end

-- Watching ---------------------------------------------------------------------------------------

-- Counts the contacts of all steps of an update: `world.stats` tells those of the last, and a
-- longer dt is split.
local function countContacts(self)
  local stats = self.player.world.stats
  self.player.world.stats = setmetatable({}, {
    __index = stats,
    __newindex = function(_, name, value)
      stats[name] = value
      self.contacts = self.contacts + (name == "events" and value or 0)
    end,
  })
end

--- Watches a player's world; in a `closed` one nothing adds energy.
function checks.new(player, closed)
  local self = setmetatable({
    player = player,
    closed = closed,
    open = {}, -- contacts that have begun and not ended
    hits = {}, -- pairs that have touched in this update
    crushed = {}, -- ids
    knots = {}, -- pairs that overlap -> for how many updates
    complaint = false,
    saved = 0,
    contacts = 0, -- of the update
  }, Watch)
  player.onEvent = function(_, name, a, b, side, more)
    hear(self, name, a, b, side, more)
  end
  if closed then
    countContacts(self)
  end
  self:look()
  return self
end

--- To be called before an update.
function Watch:before()
  self:look()
  self:noteStatics()
  self:noteDepths()
  self:noteOverlaps()
  self.hits = {}
  for key in pairs(self.open) do
    self.hits[key] = true
  end
  self:noteSums()
  self.contacts = 0
  self.saved = self.player.world._saved
end

-- Whether the update has made a step. Without one nothing is true yet of what the game has written.
function Watch:hasStepped(dt)
  local world = self.player.world
  return dt > 0 and not (world.timestep and world._saved == self.saved + dt)
end

-- What is checked where a step was made, in this order.
local LAST =
  { "checkDepths", "checkOverlaps", "checkTouching", "checkContacts", "checkUntold", "checkSums" }

--- To be called after an update of dt seconds.
---@return string? name of the check that failed
---@return string text
function Watch:after(dt)
  self:look()
  local name, text = self:checkFinite()
  if not name then
    name, text = self:checkStatics()
  end
  if not name and self.complaint then
    name, text = self.complaint[1], self.complaint[2]
  end
  if name or self.player.failed or not self:hasStepped(dt) then
    return name, text
  end
  for _, check in ipairs(LAST) do
    name, text = self[check](self, dt)
    if name then
      break
    end
  end
  self:updateCrushed()
  return name, text
end

return checks
