-- Bullets: with a life, an owner, and a number of enemies that they pierce.
--
--   bullet.shoot(world, "bullets", {
--     x = player.x, y = player.y + 12, width = 6, height = 4, vx = 900, owner = "players",
--   })
--   bullet.update(world, "bullets", dt)   -- before world:update
--
--   function bullet.onHit(world, shot, other) … end   -- if you like: sparks, sounds
--
-- What is hit and has a field `health` loses `damage` of it. With
-- `world.ownFields = { "bullet", "health" }` bullets in the air are part of each saved state; those
-- of a file get their callback again in `update`.

local bullet = {}

local SETTINGS = {
  life = 2, -- s
  damage = 1,
  pierce = 0, -- how many it passes through
  owner = false, -- the group that it does not hit
}

--- Called for each hit, if you set it: onHit(world, shot, other).
bullet.onHit = nil

local function isWall(other)
  return (other.static or other.kinematic) and not other.sensor
end

-- A bullet that pierces is a sensor, and may be told of what is behind a wall first.
local function isHidden(world, shot, other)
  local me = shot.bullet
  local x, y = other.x + other.width / 2, other.y + other.height / 2
  return shot.sensor and world:raycast(me.x, me.y, x, y, isWall) ~= nil
end

local function hit(world, shot, other)
  local me = shot.bullet
  if other.sensor or not isWall(other) and isHidden(world, shot, other) then
    return
  elseif (isWall(other) or me.pierce == 0) and not world:remove(shot) then
    return -- it has hit something else in this step
  end
  me.pierce = me.pierce - 1
  if other.health then
    other.health = other.health - me.damage
  end
  if bullet.onHit then
    bullet.onHit(world, shot, other)
  end
end

local function adopt(world, shot)
  function shot.onBegin(_, other)
    hit(world, shot, other)
  end
end

--- Adds a bullet to a group and returns it. `shot`: the fields of an object, and life, damage,
--- pierce and owner. Begin it inside of its owner: in front of it there may be a wall.
function bullet.shoot(world, group, shot)
  local me = { x = shot.x + shot.width / 2, y = shot.y + shot.height / 2 }
  for name, value in pairs(SETTINGS) do
    me[name] = shot[name] == nil and value or shot[name]
    shot[name] = nil
  end
  shot.bullet, shot.mask = me, { [group] = false }
  if me.owner then
    shot.mask[me.owner] = false
  end
  shot.gravity, shot.mass = shot.gravity or 0, shot.mass or 0.001 -- it pushes nothing
  shot.sensor = me.pierce > 0
  adopt(world, shot)
  return world:add(group, shot)
end

--- Lets the bullets of a group age, and takes away those that are too old.
function bullet.update(world, group, dt)
  local shots = world.objects[group] or {}
  for i = #shots, 1, -1 do -- backwards: `remove` moves the later ones up
    local shot = shots[i]
    local me = shot.bullet
    me.life, me.x, me.y = me.life - dt, shot.x + shot.width / 2, shot.y + shot.height / 2
    if me.life <= 0 then
      world:remove(shot)
    elseif not shot.onBegin then
      adopt(world, shot)
    end
  end
end

return bullet
