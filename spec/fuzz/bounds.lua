--- The bounds of a step, as checks that can be switched on:
---
---   motion   nothing ends a step farther from its start than the fastest speed of the step and the
---            stated parting explain (spec/support/motion.lua)
---   past     no middle goes into or past an immovable object
---   rest     two seconds after the last act of a crowded game nothing moves by more than ROUNDING

local crowded = require("spec.fuzz.crowded")
local motion = require("spec.support.motion")

-- Runs no slower without the trace compiler, which has too many loops to see here.
local jit = rawget(_G, "jit")
if jit then
  jit.off(true, true)
end

local bounds = {}

local abs = math.abs
-- px: a box that is squeezed in a row may be moved by its last bits.
local ROUNDING = 1e-12

--- The names of all checks.
bounds.NAMES = { "motion", "past", "rest" }

local Bounds = {}
Bounds.__index = Bounds

-- How many steps an update of dt seconds makes, and how many seconds they are.
local function stepsOf(world, dt, saved)
  local timestep = world.timestep
  if timestep then
    local count = math.floor((saved + dt) / timestep + 1e-9)
    return math.max(count, 1), math.max(count, 1) * timestep
  end
  return math.max(1, math.ceil(dt / world.maxStep - 1e-9)), dt
end

--- To be called before an update.
---@param objects table[] all objects in the world
function Bounds:before(objects)
  self.objects = objects
  self.watch.objects = objects
  self.watch:before()
  self.saved = self.player.world._saved
end

-- Objects upon which a callback acted, or which have left, are not where the step has put them.
function Bounds:isOwn(object, groupOf)
  local id = self.player.idOf[object]
  return groupOf[object] ~= nil and not (id and self.player.touched[id])
end

function Bounds:checkMotion(dt, steps)
  local excess, object, moved = self.watch:farthest(dt, steps)
  if self.chosen.motion and object and (excess > 1e-6 or excess ~= excess) then
    local text = "object %s moved %.9g px in %d steps, %.9g px more than it may"
    return "motion", text:format(tostring(self.player.idOf[object]), moved, steps, excess), excess
  end
end

function Bounds:checkPast()
  local how, object, wall = self.watch:trespass()
  if how then
    local text = "the middle of object %s went %s %s"
    local idOf = self.player.idOf
    return "past", text:format(tostring(idOf[object]), how, tostring(idOf[wall] or "a wall"))
  end
end

-- The game is calm: nothing in it is driven, and all is where it belongs.
local function isCalm(self, act)
  for _, object in ipairs(self.objects) do
    if object.kinematic and ((object.vx or 0) ~= 0 or (object.vy or 0) ~= 0) then
      return false
    elseif not object.static and not object.kinematic then
      local x, y = object.x + object.width / 2, object.y + object.height / 2
      local isInside = x >= act[2] and y >= act[3] and x <= act[4] and y <= act[5]
      if not (isInside and object.drag and not (object.ax or object.ay or object.restitution)) then
        return false
      end
    end
  end
  return true
end

--- Notes that from now on nothing drives the game; the act says where everything has to be.
function Bounds:calm(act)
  self.calmed, self.calmTime = act, 0
end

function Bounds:checkRest(dt)
  if not self.calmed then
    return
  end
  local wasLong = self.calmTime >= crowded.CALM
  self.calmTime = self.calmTime + dt
  if not wasLong or not isCalm(self, self.calmed) then
    return
  end
  for i, object in ipairs(self.objects) do
    local x, y = self.watch:placeOf(i)
    if abs(object.x - x) > ROUNDING or abs(object.y - y) > ROUNDING then
      local text = "object %s moved by %.9g, %.9g px after %.3g s of rest"
      local id = tostring(self.player.idOf[object])
      return "rest", text:format(id, object.x - x, object.y - y, self.calmTime)
    end
  end
end

--- To be called after an update of dt seconds that has made a step.
---@param groupOf table object -> its group, of those that are in the world now
---@return string? name of the check that failed
---@return string? text
function Bounds:after(dt, groupOf)
  local steps, seconds = stepsOf(self.player.world, dt, self.saved)
  local isAll = true
  for _, object in ipairs(self.objects) do
    isAll = isAll and self:isOwn(object, groupOf)
  end
  local name, text
  if isAll then
    name, text = self:checkMotion(seconds, steps)
  end
  if not name and isAll and self.chosen.past and not next(self.player.refusals) then
    name, text = self:checkPast()
  end
  if not name and self.chosen.rest then
    name, text = self:checkRest(seconds)
  end
  return name, text
end

--- Watches a player's world.
---@param player table spec/fuzz/player.lua
---@param chosen table name of a check -> true
---@param canMeet fun(a: table, b: table): boolean whether nothing lets one pass through the other
function bounds.new(player, chosen, canMeet)
  local self = setmetatable({ player = player, chosen = chosen }, Bounds)
  self.watch = motion.new(player.world, {}, canMeet)
  return self
end

return bounds
