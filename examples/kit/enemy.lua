-- An enemy that walks to and fro. It turns at walls and edges, also on slopes and lifts, and sees a
-- player that no wall hides.
--
--   local guard = world:add("enemies", { x = 300, y = 368, width = 24, height = 32 })
--   guard.enemy = enemy.new({ speed = 60, chase = 120 })
--
--   if enemy.update(world, guard, dt, player) then … end   -- it sees the player
--
-- All that it remembers is in guard.enemy, as plain values: with `world.ownFields = { "enemy" }` it
-- is part of each saved state.

local enemy = {}

local SETTINGS = {
  speed = 60, -- px/s
  direction = -1, -- -1: it starts to the left
  edges = true, -- false: it walks off edges
  sight = 250, -- px
  behind = false, -- true: it also sees what is behind it
  chase = false, -- px/s, towards a player that it sees
  memory = 1, -- s, for which it goes on after it has lost sight
}
local TURN_PAUSE = 0.2 -- s, at least between two turns: in a narrow pit it does not tremble

--- Returns what goes into guard.enemy. Errors: a setting that does not exist.
function enemy.new(settings)
  local me = { alarm = 0, sinceTurn = 1 } ---@type table
  for name, value in pairs(SETTINGS) do
    me[name] = value
  end
  for name, value in pairs(settings or {}) do
    if SETTINGS[name] == nil then
      error(("enemy: there is no setting %s"):format(tostring(name)), 2)
    end
    me[name] = value
  end
  return me
end

local function isSolid(other)
  return not other.sensor
end

local function hides(other)
  return (other.static or other.kinematic) and not other.sensor and not other.oneWay
end

-- Is there an edge in front? It looks as deep as it is wide, so that a slope is none.
local function isAtEdge(world, body, direction)
  local x = direction > 0 and body.x + body.width or body.x - 1
  local _, count = world:queryRect(x, body.y + body.height + 0.01, 1, body.width, isSolid)
  return count == 0
end

--- Returns whether it sees a player: near enough, in front of it, and no wall between them.
function enemy.sees(world, body, player)
  local me = body.enemy
  local x, y = body.x + body.width / 2, body.y + body.height / 2
  local toX, toY = player.x + player.width / 2, player.y + player.height / 2
  local dx, dy = toX - x, toY - y
  if dx * dx + dy * dy > me.sight * me.sight or dx * me.direction < 0 and not me.behind then
    return false
  end
  return player.active ~= false and not world:raycast(x, y, toX, toY, hides)
end

--- Steers an enemy for the next step of dt s; returns whether it sees the player, which may be nil.
--- To be called before `world:update`, or in `onStep`.
function enemy.update(world, body, dt, player)
  local me = body.enemy
  local isSeen = player and enemy.sees(world, body, player) or false
  me.alarm = isSeen and me.memory or math.max(0, me.alarm - dt)
  me.sinceTurn = me.sinceTurn + dt
  local isChasing = me.chase and me.alarm > 0
  if isSeen and isChasing then
    me.direction = player.x + player.width / 2 < body.x + body.width / 2 and -1 or 1
  end
  local wall = body.touching[me.direction > 0 and "right" or "left"]
  local isBlocked = wall and wall ~= player
    or me.edges and body.touching.bottom and isAtEdge(world, body, me.direction)
  if isBlocked and not isChasing and me.sinceTurn > TURN_PAUSE then
    me.direction, me.sinceTurn, isBlocked = -me.direction, 0, false
  end
  body.vx = isBlocked and 0 or me.direction * (isChasing and me.chase or me.speed)
  return isSeen
end

return enemy
