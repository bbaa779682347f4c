--- What a player would notice in any game: something inside a wall, lost, or further on than its
--- speed takes it; a crush with no machine near; a stop that nothing explains; contacts that begin
--- twice or end without a beginning. It looks at the game's own tables only, with the geometry of
--- spec/support/overlap.lua, so it proves nothing by what it should prove.

local overlap = require("spec.support.overlap")

local watcher = {}

local abs, max, min = math.abs, math.max, math.min

local SEEN = 0.02 -- px that a player may see
local NEAR = 16 -- px from what is crushed to a machine that may do it
local FAST, STILL = 20, 1e-9 -- px/s: a stop from more to less is seen

--- Begins to watch a world; returns what `watcher.check` takes.
---@param world physics.World
---@param room number[] x, y, width, height, px: nothing that moves may leave it
---@param machines? table[] what may crush others
function watcher.new(world, room, machines)
  local self = { world = world, room = room, machines = machines or {} }
  self.open, self.limit, self.wrong = {}, {}, nil
  self.held = {} -- what a machine has crushed, until it is free again
  local function pairOf(a, b)
    self.open[a] = self.open[a] or {}
    return self.open[a], b
  end
  function world.onBegin(a, b)
    local row, key = pairOf(a, b)
    self.wrong = self.wrong or row[key] and "a contact begins twice"
    row[key] = true
  end
  function world.onEnd(a, b)
    local row, key = pairOf(a, b)
    self.wrong = self.wrong or not row[key] and "a contact ends that has not begun"
    row[key] = nil
  end
  function world.onCrush(object, a, b)
    for _, machine in ipairs(self.machines) do
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

--- Notes where everything is, before an update.
function watcher.note(self, movers)
  for _, object in ipairs(movers) do
    self.limit[object] = self.limit[object] or {}
    local was = self.limit[object]
    was.x, was.y = object.x, object.y
    was.vx, was.vy = object.vx or 0, object.vy or 0
    was.speed = max(abs(was.vx), abs(was.vy))
  end
end

local function isLost(object, room)
  return object.x < room[1] - SEEN
    or object.y < room[2] - SEEN
    or object.x + object.width > room[1] + room[3] + SEEN
    or object.y + object.height > room[2] + room[4] + SEEN
    or object.x ~= object.x
    or object.y ~= object.y
    or object.vx ~= object.vx
    or object.vy ~= object.vy
end

-- How far an object may have gone: by the faster of its speeds, its carrier's way, and a sixteenth
-- of its size.
local function jumped(self, object, dt, carried)
  local was = self.limit[object]
  local speed = max(was.speed, abs(object.vx or 0), abs(object.vy or 0))
  local own = speed * dt + min(object.width, object.height) / 16 + carried
  local way = max(abs(object.x - was.x), abs(object.y - was.y))
  return way > own + SEEN and way - own
end

-- Whether an object was stopped dead twice, with nothing at its side. (Once: it has just left what
-- it touched when the step began.)
local function isStopped(self, object)
  local was, t = self.limit[object], object.touching
  local isX = abs(was.vx) > FAST and abs(object.vx) < STILL and not (t.left or t.right)
  local isY = abs(was.vy) > FAST and abs(object.vy) < STILL and not (t.top or t.bottom)
  local isDead = isX and was.isX or isY and was.isY
  was.isX, was.isY = isX, isY
  return isDead
end

-- Whether an object is in one of some lists.
local function isIn(object, ...)
  for _, list in ipairs({ ... }) do
    for _, other in ipairs(list) do
      if other ~= object and overlap.depth(object, other) > -SEEN then
        return true
      end
    end
  end
  return false
end

--- Looks at everything after an update of dt s. Returns what is wrong, or nil.
---@param self table
---@param movers table[] what the library moves
---@param solids table[] what it may not go into
---@param dt number s
---@param carried number px that carriers, nudges and snaps may add in that time
function watcher.check(self, movers, solids, dt, carried)
  if self.wrong then
    return "pairs", self.wrong
  end
  for n, object in ipairs(movers) do
    -- It may be pressed into something, and is sent elsewhere; a ball shoots out of a vice.
    local isHeld = self.held[object] or object.radius and isIn(object, self.machines)
    if not isHeld and isLost(object, self.room) then
      return "lost", ("%d is at %g, %g"):format(n, object.x, object.y)
    end
    for m, solid in ipairs(solids) do
      local depth = overlap.depth(object, solid)
      if depth > SEEN and not isHeld then
        return "inside", ("%d is %g px in solid %d"):format(n, depth, m)
      end
    end
    local far = jumped(self, object, dt, carried)
    self.held[object] = isHeld and isIn(object, solids, self.machines)
    if far and not isHeld then
      return "jump", ("%d goes %g px too far"):format(n, far)
    elseif isStopped(self, object) and not isHeld then
      return "stop", ("%d stops dead at %g, %g"):format(n, object.x, object.y)
    end
  end
end

return watcher
