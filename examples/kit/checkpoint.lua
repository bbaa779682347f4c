-- Death and coming back: at the last checkpoint, at a place that is free, with everything reset
-- that an ability may have changed. And saved games: all of the world, in a file.
--
--   player.checkpoint = checkpoint.new(player)            -- where it is now
--   function flag.onBegin(self, other)
--     if other == player then checkpoint.reach(player, self.x, self.y) end
--   end
--   function player.onCrush() checkpoint.die(player) end  -- spikes, lava, enemies, too
--
--   if checkpoint.update(world, player, dt) then hero.reset(player) end   -- it is back
--
--   checkpoint.save(world, "game.sav")                    -- and checkpoint.load(world, "game.sav")
--
-- With `world.ownFields = { "checkpoint" }` it is part of each saved state.

local checkpoint = {}

local PAUSE = 0.8 -- s from death until it is back
local REACH = 200 -- px: how far from the checkpoint a free place may be
local RESET = { "width", "height", "gravity", "maxFallSpeed", "mask" }

--- Returns what goes into player.checkpoint: its place, and the fields that it will have again.
function checkpoint.new(player)
  local me = { x = player.x, y = player.y, deaths = 0, deadFor = false, fields = {} }
  for _, name in ipairs(RESET) do
    me.fields[name] = player[name]
  end
  return me
end

--- From now on the player comes back at x, y.
function checkpoint.reach(player, x, y)
  player.checkpoint.x, player.checkpoint.y = x, y
end

--- The player dies, unless it is dead already; returns whether it did.
function checkpoint.die(player)
  local me = player.checkpoint
  if me.deadFor then
    return false
  end
  me.deadFor, me.deaths, player.active = 0, me.deaths + 1, false
  return true
end

--- To be called in each frame; returns true in that in which the player is back.
function checkpoint.update(world, player, dt)
  local me = player.checkpoint
  if not me.deadFor then
    return false
  end
  me.deadFor = me.deadFor + dt
  if me.deadFor < PAUSE then
    return false
  end
  for _, name in ipairs(RESET) do
    player[name] = me.fields[name]
  end
  local x, y = world:freePlace(me.x, me.y, player.width, player.height, REACH, player)
  player.x, player.y = x or me.x, y or me.y
  player.vx, player.vy, player.active, me.deadFor = 0, 0, true, false
  return true
end

-- Files ------------------------------------------------------------------------------------------

local function write(parts, value)
  if type(value) == "number" then
    parts[#parts + 1] = ("%.17g"):format(value):gsub("inf", "1e999") -- 17 digits are exact
  elseif type(value) == "table" then
    parts[#parts + 1] = "{"
    for key, inner in pairs(value) do
      parts[#parts + 1] = "["
      write(parts, key)
      parts[#parts + 1] = "]="
      write(parts, inner)
      parts[#parts + 1] = ","
    end
    parts[#parts + 1] = "}"
  else
    parts[#parts + 1] = type(value) == "string" and ("%q"):format(value) or tostring(value)
  end
end

--- Returns the whole world as a text.
function checkpoint.write(world)
  local parts = { "return " }
  write(parts, world:save())
  return table.concat(parts)
end

--- Makes a world what a text says; the level must have been built before. Returns what
--- `world:restore` returns. Errors: the text is none. (It is run as code, without any function to
--- call.)
function checkpoint.read(world, text)
  local setEnvironment = rawget(_G, "setfenv")
  local run
  if setEnvironment then
    run = setEnvironment(assert(rawget(_G, "loadstring")(text, "=saved game")), {})
  else
    run = assert(load(text, "=saved game", "t", {}))
  end
  return world:restore(run())
end

--- Saves the world in a file of LÖVE's folder of the game.
function checkpoint.save(world, file)
  assert(love.filesystem.write(file, checkpoint.write(world)))
end

--- Loads it again; returns false if there is no such file.
function checkpoint.load(world, file)
  local text = love.filesystem.read(file)
  return text ~= nil, text and checkpoint.read(world, text)
end

return checkpoint
