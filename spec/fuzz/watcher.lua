--- What a player would notice in any game: something inside a wall or another thing, lost, further
--- on than its speed takes it, or thrown; a crush with no machine near; a stop that nothing
--- explains; a hero that is stuck; contacts that begin twice or end without a beginning. It looks
--- at the game's own tables only, with the geometry of spec/support/overlap.lua, so it proves
--- nothing by what it should prove.

local overlap = require("spec.support.overlap")

local watcher = {}

local abs, max, min, sqrt = math.abs, math.max, math.min, math.sqrt

local SEEN = 0.02 -- px of a wall that a player may see
-- Px and s that two things may be in each other (balls that bounce in a knot come apart in the next
-- frames), and share of the smaller one that they may not be in each other in any frame.
local DEEP, BRIEF, SHARE = 0.3, 0.07, 0.25
local NEAR = 16 -- px from what is crushed to a machine that may do it
local PRESSED = 1 -- px from a ball to a machine that may squeeze it out, much faster than itself
-- Px/s: a stop from more to less is seen; but not if it moved by less than a share of its size in a
-- frame, as a ball that comes to rest in a heap. (That stops if it is to move by less than 0.03 of
-- its size, and it was faster in the frame before.)
local FAST, STILL, SLOW = 20, 1e-9, 0.04
-- Times what energy was before; and the factor of its mass with which a stronger object pushes
-- others that run against it (they count as a fifth, and their own speed gives it none).
local GAINED, STRONG = 1.001, 11
-- Times the fastest speed of all, and its own way: a speed that comes from nothing is more.
local SUDDEN = 3

--- Begins to watch a game (spec/fuzz/games.lua); returns what the other functions take.
---@param game table with `world`, `room` (x, y, width, height, px), lists of `movers`, `solids`,
--- `machines` (what may crush others) and `carriers`, `pull` in px/s2, `carry` in px/s, and perhaps
--- `soft` in px/s and `vice`
function watcher.new(game)
  local self = { game = game, open = {}, was = {}, deep = {}, hit = {}, wrong = nil }
  self.held = {} -- what a machine has crushed, until it is free again
  self.vices = {} -- machines that nothing stops
  for _, machine in ipairs(game.machines) do
    table.insert(self.vices, machine.kinematic and machine or nil)
  end
  local world = game.world
  function world.onBegin(a, b)
    local row = self.open[a] or {}
    self.open[a] = row
    self.wrong = self.wrong or row[b] and "a contact begins twice"
    row[b], self.hit[a], self.hit[b] = true, true, true
  end
  function world.onEnd(a, b)
    local row = self.open[a] or {}
    self.wrong = self.wrong or not row[b] and "a contact ends that has not begun"
    row[b] = nil
  end
  function world.onCrush(object, a, b)
    for _, machine in ipairs(game.machines) do
      self.held[object] = self.held[object] or overlap.depth(object, machine) > -NEAR
    end
    if not self.held[object] then
      local text = "a crush at %g, %g by %s and %s"
      local one, other = tostring(world:groupOf(a)), tostring(world:groupOf(b))
      self.wrong = self.wrong or text:format(object.x, object.y, one, other)
    end
  end
  return self
end

-- Whether an object is in one of a list, or nearer to it than `gap` px.
local function isIn(object, list, gap)
  for _, other in ipairs(list) do
    if other ~= object and overlap.depth(object, other) > -gap then
      return true
    end
  end
  return false
end

local function isSlope(object)
  return object and object.slope
end

-- Returns how fast the n-th object drifts out of others to which it is soft, at most, px/s.
local function driftOf(game, n)
  local object, sum = game.movers[n], 0
  for m, other in ipairs(game.soft and n > 1 and game.movers or {}) do
    if m > 1 and m ~= n then
      local x = abs(object.x + object.width / 2 - other.x - other.width / 2)
      local y = abs(object.y + object.height / 2 - other.y - other.height / 2)
      local far = max(2 * x / (object.width + other.width), 2 * y / (object.height + other.height))
      sum = sum + game.soft * max(1 / far - 1, 0)
    end
  end
  return min(sum, game.soft or 0)
end

-- Returns whether an object touches a slope, which need not be its widest neighbour on a side.
local function isOnSlope(object, solids)
  if isSlope(object.touching.top) or isSlope(object.touching.bottom) then
    return true
  end
  for _, solid in ipairs(solids) do
    if solid.slope and overlap.depth(object, solid) > -SEEN then
      return true
    end
  end
  return false
end

-- Returns the energy of all that moves, if each were faster by `gain` px/s and its drift; nil: of
-- what has moved, but for balls that a vice shoots out, or a strong hero as fast as `vice` allows.
-- (A box that walks on a slope, or below one, keeps its velocity on x, and has one on y besides.)
local function energyOf(self, gain)
  local energy = 0
  for n, object in ipairs(self.game.movers) do
    local vx, vy, was = object.vx or 0, object.vy or 0, self.was[object]
    if not (gain or object.radius) and isOnSlope(object, self.game.solids) then
      vy = 0
    end
    local speed = sqrt(vx * vx + vy * vy) + (gain and gain + driftOf(self.game, n) or 0)
    local isShot = was.isSqueezed or was.isPressed and speed <= (self.game.vice or 0) * self.fastest
    local mass = (object.mass or 1) * (object.strength and STRONG or 1)
    energy = energy + (not gain and isShot and 0 or mass / 2 * speed * speed)
  end
  return energy
end

--- Notes where everything is, before an update of dt s.
function watcher.note(self, dt)
  local game, isCarried = self.game, false
  self.hit, self.fastest = {}, 0
  for _, object in ipairs(game.movers) do
    local was, t = self.was[object] or {}, object.touching
    self.was[object] = was
    was.wayX, was.wayY = abs(object.x - (was.x or 1e9)), abs(object.y - (was.y or 1e9))
    was.x, was.y = object.x, object.y
    was.vx, was.vy = object.vx or 0, object.vy or 0
    was.isAcross, was.isAlong = t.left or t.right, t.top or t.bottom
    was.isPressed = object.radius and isIn(object, game.machines, PRESSED)
    was.isSqueezed = object.radius and isIn(object, self.vices, PRESSED)
    isCarried = isCarried or isIn(object, game.carriers, NEAR)
    self.fastest = max(self.fastest, abs(was.vx), abs(was.vy))
  end
  -- What a machine pushes, and what that pushes, gets its speed.
  local gain = game.pull * dt + (isCarried and game.carry or 0)
  self.energy = energyOf(self, gain)
end

local function isLost(object, room)
  return not (
    object.x >= room[1] - SEEN
    and object.y >= room[2] - SEEN
    and object.x + object.width <= room[1] + room[3] + SEEN
    and object.y + object.height <= room[2] + room[4] + SEEN
    and object.vx == object.vx
    and object.vy == object.vy
  )
end

-- How much farther an object has gone than it may: by the fastest speed of all (a ball in a crowd
-- is squeezed out at up to `vice` times that, see docs/reliability.md), what it gains in the step
-- before something slows it, its carrier's way, `snap` and `nudge`, and a sixteenth of its size.
local function jumped(self, object, dt)
  local was, game = self.was[object], self.game
  local speed = max(self.fastest, abs(object.vx or 0), abs(object.vy or 0))
  speed = speed * (object.radius and game.vice or 1)
  local more = (object.snap or 0) + (object.nudge or 0) + min(object.width, object.height) / 16
  local own = (speed + game.pull * dt / 2 + game.carry + (game.soft or 0)) * dt + more + SEEN
  return max(abs(object.x - was.x), abs(object.y - was.y)) - own
end

-- Whether an object ends an update at a speed that nothing had, and at which it has not moved.
local function isSudden(self, object, dt)
  local was, vx, vy = self.was[object], object.vx or 0, object.vy or 0
  local x, y = (object.x - was.x) / dt, (object.y - was.y) / dt
  local most = max(self.fastest + self.game.pull * dt + self.game.carry, sqrt(x * x + y * y))
  return sqrt(vx * vx + vy * vy) > SUDDEN * most
end

-- Whether a box or circle has its middle beside another one, along an axis.
local function isBeside(object, other, at, size)
  local middle = object[at] + object[size] / 2
  return middle < other[at] or middle > other[at] + other[size]
end

-- Whether the contact of an object with a neighbour above or below (left or right of it: along "y",
-- "height") is slanted: with a slope, of two circles, or of a circle with a corner.
local function isSlanted(object, other, at, size)
  if not other or other.slope or object.radius and other.radius then
    return other
  end
  return object.radius and isBeside(object, other, at, size)
    or other.radius and isBeside(other, object, at, size)
end

-- Whether an object that went fast, in the update before, too, was stopped dead, with nothing at
-- its side before, during or after the step, and nothing below it that it rubs on.
local function isStopped(self, object, dt)
  local was, t = self.was[object], object.touching
  local fast = max(FAST, 1.01 * self.game.pull * dt, SLOW * object.width / dt)
  local isX = min(abs(was.vx), was.wayX / dt) > fast
    and abs(object.vx) < STILL
    and not (was.isAcross or t.left or t.right)
    and not (object.friction and (was.isAlong or t.top or t.bottom))
    and not (isSlanted(object, t.top, "x", "width") or isSlanted(object, t.bottom, "x", "width"))
  local isY = min(abs(was.vy), was.wayY / dt) > fast
    and abs(object.vy) < STILL
    and not (was.isAlong or t.top or t.bottom)
    and not (isSlanted(object, t.left, "y", "height") or isSlanted(object, t.right, "y", "height"))
  return (isX or isY) and not self.hit[object]
end

-- Returns which two things are in each other, or nil.
local function findDeep(self, dt)
  local movers, deep = self.game.movers, self.deep
  self.deep = {}
  for n, one in ipairs(movers) do
    for m = n + 1, #movers do
      local other = movers[m]
      local depth = overlap.depth(one, other)
      local isSoft = self.game.soft and n > 1
      if depth > DEEP and not (isSoft or self.held[one] or self.held[other]) then
        local key = 1000 * n + m
        self.deep[key] = (deep[key] or 0) + dt
        local most = SHARE * min(one.width, one.height, other.width, other.height)
        if depth > most or self.deep[key] > BRIEF then
          local text = "%d and %d by %g px, for %g s"
          return "overlap", text:format(n, m, depth, self.deep[key])
        end
      end
    end
  end
end

--- Looks at everything after an update of dt s. Returns what is wrong, or nil.
function watcher.check(self, dt)
  local game = self.game
  if self.wrong then
    return "pairs", self.wrong
  end
  for n, object in ipairs(game.movers) do
    -- It may be pressed into something, and is sent elsewhere; a ball shoots out of a vice.
    local isHeld = self.held[object]
      or self.was[object].isSqueezed
      or object.radius and isIn(object, game.machines, SEEN)
    if not isHeld and isLost(object, game.room) then
      return "lost", ("%d is at %g, %g"):format(n, object.x, object.y)
    end
    for m, solid in ipairs(game.solids) do
      local depth = overlap.depth(object, solid)
      if depth > SEEN and not isHeld then
        return "inside", ("%d is %g px in solid %d"):format(n, depth, m)
      end
      -- (What a machine has pressed into a pit of slopes is no crush, and leaves it in some steps.)
      self.held[object] = self.held[object] or depth > SEEN or nil
    end
    local far = jumped(self, object, dt)
    local isStill = self.held[object]
      and (isIn(object, game.solids, SEEN) or isIn(object, game.machines, SEEN))
    self.held[object] = isStill or nil
    if far > 0 and not (isHeld or self.was[object].isPressed) then
      return "jump", ("%d goes %g px too far"):format(n, far)
    elseif isStopped(self, object, dt) and not isHeld then
      return "stop", ("%d stops dead at %g, %g"):format(n, object.x, object.y)
    elseif isSudden(self, object, dt) and not (isHeld or self.was[object].isSqueezed) then
      return "speed", ("%d goes at %g, %g px/s"):format(n, object.vx, object.vy)
    end
  end
  local energy = energyOf(self)
  if energy > self.energy * GAINED and not next(self.held) then
    return "energy", ("%g of %g"):format(energy, self.energy)
  end
  return findDeep(self, dt)
end

--- Looks whether the hero of a game is stuck: no machine is near, and it can leave in no direction
--- though nothing else is driven or braked. (A crowd may press it to a wall with all its weight.)
--- Returns what is wrong, or nil. The game is as before.
function watcher.findStuck(self)
  local game, most = self.game, 0
  local hero, state = game.hero, game.world:save()
  if not hero or self.held[hero] or isIn(hero, game.machines, 2) then
    return
  end
  for n = 0, 3 do
    local x, y = hero.x, hero.y
    for _, object in ipairs(game.movers) do
      object.vx, object.vy, object.ax, object.ay, object.drag = 0, 0, 0, 0, object.drag and 0
    end
    for _ = 1, 10 do
      hero.gravity = 0
      hero.vx, hero.vy = 60 * ({ 1, -1, 0, 0 })[n + 1], 60 * ({ 0, 0, 1, -1 })[n + 1]
      game.world:update(1 / 60)
    end
    most = max(most, abs(hero.x - x), abs(hero.y - y))
    game.world:restore(state)
  end
  if most < 0.5 then
    return "stuck", ("the hero at %g, %g"):format(hero.x, hero.y)
  end
end

return watcher
