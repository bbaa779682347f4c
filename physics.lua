---@diagnostic disable
--- physics.lua: boxes that move and bump, for LÖVE and every Lua.
--
-- The game's own tables are the objects. The library reads `x, y, width, height, vx, vy, …` from
-- the tables in `objects` and writes `x, y, vx, vy, touching` back. Coordinates are LÖVE's: x to
-- the right, y down, x and y the top-left corner, pixels and seconds.
--
--   local physics = require "physics"
--   physics.load { gravity = 800 }
--   physics.add("tiles", { x = 0, y = 560, width = 800, height = 40, static = true })
--   local player = physics.add("players", { x = 40, y = 40, width = 24, height = 32 })
--   physics.update(dt)
--
-- This file holds the constructors, the default world, the pure functions and the version.

local path = ...
local compiler = require(path .. ".memory.compiler")
local world = compiler.load(path .. ".world.world")
local check = require(path .. ".fields.check")
local keyOrder = require(path .. ".memory.keyOrder")
local lazy = require(path .. ".memory.lazy")

-- Loaded when it is first used.
local pure = lazy(path .. ".world.tutorial")

---@class physics.Module: physics.DefaultWorld
local physics = {
  _VERSION = "1.0.0-dev",
  _DESCRIPTION = "2D physics for boxes: exact contact, no seams, no tunnelling, pure Lua",
  _LICENSE = "MIT",
}

-- The default world is made when it is first used: many games use only worlds of their own.
local made = nil ---@type any

local function default()
  made = made or world.new(nil, "physics")
  return made
end

-- Refuses a call with a colon, which would give the module as the first argument.
local function checkDot(first, name)
  if rawequal(first, physics) then
    check.fail("physics." .. name .. " must be called with a dot, not with a colon")
  end
end

--- Returns a new world, independent of all others.
---
--- Errors: a setting is unknown or has a value that cannot be used.
---@param settings physics.Settings? default: see "Settings"
---@return physics.World
function physics.newWorld(settings)
  checkDot(settings, "newWorld")
  return (world.new(settings, "newWorld(settings)"))
end

--- Replaces the default world by a new, empty one with these settings. Callbacks of the old world
--- are gone: set `physics.onBegin` and the like afterwards.
---
--- Errors: a setting is unknown or has a value that cannot be used.
---@param settings physics.Settings? default: see "Settings"
function physics.load(settings)
  checkDot(settings, "load")
  made = world.new(settings, "load(settings)")
end

-- Makes every method of a world a function of the default world, too, but `load`.
for _, name in ipairs(keyOrder.sorted(world.methods)) do
  local method = world.methods[name]
  if type(method) == "function" and name:sub(1, 1) ~= "_" and not physics[name] then
    physics[name] = function(first, ...)
      checkDot(first, name)
      return method(made or default(), first, ...)
    end
  end
end

-- Without `sideBySide` it takes the setting of the default world.
function physics.checkCollision(a, b, c, d, e, f, g, h, sideBySide)
  checkDot(a, "checkCollision")
  local isFlush = default().sideBySide
  if type(a) == "number" then
    return pure.checkCollision(a, b, c, d, e, f, g, h, sideBySide == nil and isFlush or sideBySide)
  end
  return pure.checkCollision(a, b, c == nil and isFlush or c)
end

-- Another function of the tutorial.
local function dotted(name)
  return function(first, ...)
    checkDot(first, name)
    return pure[name](first, ...)
  end
end

physics.inside, physics.side, physics.bump = dotted("inside"), dotted("side"), dotted("bump")

--- Defines the global names of the tutorial: `objects`, `physics_load`, `physics_update`,
--- `checkCollision`, `inside` and `bump`. Each `physics_update` uses the table that the global
--- `objects` holds at that moment. Without this call the library sets no global.
function physics.globals()
  local globals = _G
  globals.objects = default().objects
  globals.physics_load = function(settings)
    physics.load(settings)
    made.objects = type(globals.objects) == "table" and globals.objects or made.objects
    globals.objects = made.objects
  end
  globals.physics_update = function(dt)
    default().objects = globals.objects
    default():update(dt)
  end
  globals.checkCollision = physics.checkCollision
  globals.inside = pure.inside
  globals.bump = pure.bump
end

-- `physics.objects`, `physics.gravity`, `physics.stats`, `physics.onBegin`, … are fields of the
-- default world.
setmetatable(physics, {
  __index = function(_, name)
    return default()[name]
  end,
  __newindex = function(_, name, value)
    default()[name] = value
  end,
})

return physics
