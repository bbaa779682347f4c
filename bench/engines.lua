--- The engines that can be measured. Each is a file in bench/engines/ with
---
---   module            what must be found on package.path
---   needsLove         plays only in LÖVE
---   isTurning         its boxes turn: how deep they stand in each other is not looked at
---   lacks             feature -> why scenes that need it are not played
---   plays             name -> true: it plays only these scenes
---   new(scene)        -> a world, with the methods
---     step(dt)          moves the world on
---     read(i)           -> x, y of the i-th object, its left and top edge
---     setVelocity(i, vx, vy), either may be nil: stays
---     accelerate(i, ax, ay), up to the `maxSpeed` of its description
---     setSize(i, width, height), about its middle
---     setGravity(x, y)
---     add(description)  -> i, as in the scene;  remove(i)
---     raycast(x1, y1, x2, y2) -> fraction of the line to the first hit, or nil
---     ask(n, x, y)      the n-th question of a frame: of a kind that depends on n
---     moveBy(i, way)    puts the i-th object elsewhere by hand
---     save(out), restore(state), hash()
---     free()
---
--- A world without one of these methods does not play the scenes that need it.

local engines = {}

---@type table<string, string>
local TITLES = {
  ours = "physics.lua",
  love = "love.physics",
  turning = "love, turning",
  tutorial = "tutorial's loop",
  bump = "bump.lua",
  fizzx = "FizzX",
  hash = "plain hash",
  reading = "reading alone",
}

--- The names, ours first, in the order in which they are measured and printed.
engines.names = { "ours", "love", "turning", "tutorial", "bump", "fizzx", "hash", "reading" }

--- What an engine is called in tables.
---@param name string one of `engines.names`
---@return string
function engines.title(name)
  return TITLES[name]
end

local function isFound(module)
  if package.searchpath then
    return package.searchpath(module, package.path) ~= nil
  end
  for template in package.path:gmatch("[^;]+") do
    local file = io.open((template:gsub("%?", (module:gsub("%.", "/")))))
    if file then
      file:close()
      return true
    end
  end
  return false
end

--- An engine, or nil and why it cannot be measured here.
---@param name string one of `engines.names`
---@param isLove boolean
---@return table? engine
---@return string? reason
function engines.get(name, isLove)
  local engine = require("bench.engines." .. name)
  if engine.needsLove and not isLove then
    return nil, "needs LÖVE"
  elseif engine.module and not isFound(engine.module) then
    return nil, "not found on package.path"
  end
  return engine
end

--- Why an engine cannot play a scene, or nil when it can.
---@param engine table
---@param scene table
---@return string?
function engines.refusal(engine, scene)
  if engine.plays and not engine.plays[scene.name] then
    return "is no engine"
  end
  for _, feature in ipairs(scene.needs or {}) do
    if engine.lacks and engine.lacks[feature] then
      return engine.lacks[feature]
    end
  end
  return nil
end

return engines
