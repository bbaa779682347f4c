--- Scenes for the scenario specs. A scene is data:
---
---     local SCENE = {
---       gravity = 800,                                     -- any setting of newWorld
---       { "tiles", { x = 0, y = 100, width = 800, height = 16, static = true } },
---       { "players", { name = "body", x = 0, y = 76, width = 14, height = 24, vx = 200 } },
---     }
---
--- and a row plays it in every variant (see spec/support/variants.lua):
---
---     scene.each({ rate = variants.RATES }, function(run)
---       local body = run:build(SCENE).body
---       for time in run:steps(2) do run:near("x", body.x, 200 * time) end
---     end)
---
--- `body` is a *view* of the object in the world: it is read and written in the coordinates of the
--- scene, whatever the variant shifted and turned. `body.raw` is the object itself.

local physics = require("physics")
local newRandom = require("spec.support.random").new
local small = require("spec.support.small")
local turn = require("spec.support.turn")
local variants = require("spec.support.variants")

local scene = {}

local Run = {}
Run.__index = Run

local TOLERANCE = 1e-6
local SIDES = { "top", "bottom", "left", "right" }

-- Views ------------------------------------------------------------------------------------------

local View = {}

--- The box of an object as the scene has it.
local function boxOf(run, raw)
  local x, y = raw.x - run.shift, raw.y - run.shift
  return turn.box(turn.back(run.turn), x, y, raw.width, raw.height)
end

--- `touching` as the scene has it: views under the scene's sides.
local function touchingOf(run, raw)
  local result = {}
  for side, other in pairs(raw.touching) do
    result[turn.side(turn.back(run.turn), side)] = run.views[other] or other
  end
  return result
end

function View.__index(view, key)
  local run, raw = rawget(view, "run"), rawget(view, "raw")
  if key == "x" or key == "y" or key == "width" or key == "height" then
    local x, y, width, height = boxOf(run, raw)
    return key == "x" and x or key == "y" and y or key == "width" and width or height
  elseif key == "vx" or key == "vy" then
    local vx, vy = turn.vector(turn.back(run.turn), raw.vx or 0, raw.vy or 0)
    return key == "vx" and vx or vy
  elseif key == "touching" then
    return touchingOf(run, raw)
  end
  return raw[key]
end

--- Writes one number of a pair and leaves the bits of the other one alone.
local function writeOne(run, raw, isX, nameX, nameY, turnedX, turnedY)
  if isX == (run.turn % 2 == 0) then
    raw[nameX] = turnedX
  else
    raw[nameY] = turnedY
  end
end

function View.__newindex(view, key, value)
  local run, raw = rawget(view, "run"), rawget(view, "raw")
  if key == "x" or key == "y" then
    local x, y, width, height = boxOf(run, raw)
    if key == "x" then
      x = value
    else
      y = value
    end
    x, y = turn.box(run.turn, x, y, width, height)
    writeOne(run, raw, key == "x", "x", "y", x + run.shift, y + run.shift)
  elseif key == "vx" or key == "vy" then
    local vx, vy = turn.vector(run.turn, value, value)
    writeOne(run, raw, key == "vx", "vx", "vy", vx, vy)
  else
    raw[key] = value
  end
end

-- Building ---------------------------------------------------------------------------------------

--- Turns two fields that form a vector, if one of them is there.
local function turnPair(count, object, nameX, nameY)
  if object[nameX] or object[nameY] then
    object[nameX], object[nameY] = turn.vector(count, object[nameX] or 0, object[nameY] or 0)
  end
end

--- The object that a scene describes, shifted and turned.
local function place(run, description)
  local object = small.set({}, description)
  local x, y, width, height = turn.box(run.turn, object.x, object.y, object.width, object.height)
  object.x, object.y, object.width, object.height = x + run.shift, y + run.shift, width, height
  turnPair(run.turn, object, "vx", "vy")
  turnPair(run.turn, object, "ax", "ay")
  turnPair(run.turn, object, "gravityX", "gravity")
  if run.turn % 2 == 1 then
    object.maxSpeedX, object.maxSpeedY = object.maxSpeedY, object.maxSpeedX
  end
  if object.slope then
    object.slope = turn.slope(run.turn, object.slope)
  end
  if object.oneWay then
    object.oneWay = turn.side(run.turn, object.oneWay)
  end
  return object
end

--- The names of the groups of a scene, last to first.
local function groupsBackward(description)
  local names, seen = {}, {}
  for _, entry in ipairs(description) do
    if not seen[entry[1]] then
      names[#names + 1] = entry[1]
    end
    seen[entry[1]] = true
  end
  table.sort(names, function(a, b)
    return a > b
  end)
  return names
end

--- The settings of a scene in this variant; a scene falls at 800 px/s² unless it says otherwise.
local function settingsOf(run, description)
  local settings = { broadphase = run.broadphase, push = run.push }
  if run.order == "backward" then
    settings.order = groupsBackward(description)
  end
  for key, value in pairs(description) do
    if type(key) == "string" then
      settings[key] = value
    end
  end
  settings.gravityX, settings.gravity =
    turn.vector(run.turn, settings.gravityX or 0, settings.gravity or 800)
  return settings
end

--- The entries of a scene in the variant's order of insertion.
local function inOrder(run, description)
  local entries, count = {}, #description
  for i, entry in ipairs(description) do
    entries[run.order == "backward" and count + 1 - i or i] = entry
  end
  if run.order == "shuffled" then
    return newRandom(7):shuffled(entries)
  end
  return entries
end

--- Adds one object to the world of the run.
---@return table view
function Run:add(group, description)
  local raw = place(self, description)
  local view = setmetatable({ raw = raw, run = self }, View)
  self.views[raw] = view
  if raw.name then
    self.named[raw.name] = view
  end
  self.world:add(group, raw)
  return view
end

--- Makes the world of a scene.
---@return table named views of the objects that have a name
function Run:build(description)
  self.time = 0
  self.views, self.named, self.all = {}, {}, {}
  self.world = physics.newWorld(settingsOf(self, description))
  for _, entry in ipairs(inOrder(self, description)) do
    self.all[#self.all + 1] = self:add(entry[1], entry[2]).raw
  end
  return self.named
end

-- Playing ----------------------------------------------------------------------------------------

--- The list of steps that fill some seconds at the rate of the variant.
--- Irregular: between 1/240 and 1/30 s, now and then a hitch of up to 0.1 s.
---@param seconds number
---@param rate number|"irregular" steps per second
---@return number[] list of dt
function scene.times(seconds, rate)
  local list = {}
  if rate ~= "irregular" then
    local count = math.floor(seconds * rate + 0.5)
    if math.abs(count - seconds * rate) > 1e-6 then
      error("not a whole number of steps", 3)
    end
    for i = 1, count do
      list[i] = 1 / rate
    end
    return list
  end
  local random, left = newRandom(11), seconds
  while left > 0 do
    local dt = random:between(1 / 240, 1 / 30)
    if random:chance(0.05) then
      dt = random:between(1 / 30, 0.1)
    end
    if left - dt < 1 / 240 then
      dt = left
    end
    list[#list + 1] = dt
    left = left - dt
  end
  return list
end

--- Plays some seconds of a run under watch (see motion.new): none of the steps may move anything
--- farther than it may. `before(time)` writes what the game does before a step.
function scene.watch(run, watch, seconds, before)
  for _, dt in ipairs(scene.times(seconds, run.rate)) do
    if before then
      before(run.time)
    end
    watch:before()
    run:step(dt)
    local problem = watch:after(dt)
    run:check(not problem, "%s", problem)
  end
end

--- Updates the world once.
function Run:step(dt)
  self.world:update(dt)
  self.time = self.time + dt
end

--- Updates the world for some seconds: `for time, dt in run:steps(2, before) do … end`, the body
--- runs after each step, `before(time, dt)` (optional) before it; `time` is that of its end.
function Run:steps(seconds, before)
  local list, i, time = scene.times(seconds, self.rate), 0, 0
  return function()
    i = i + 1
    local dt = list[i]
    if not dt then
      return nil
    end
    time = time + dt
    if before then
      before(time, dt)
    end
    self:step(dt)
    return time, dt
  end
end

--- The same without a look at each step.
function Run:play(seconds, before)
  for _ in self:steps(seconds, before) do
  end
end

-- Counts calls of callbacks from now on.
local function counting(owner, names)
  local log = {}
  for name, key in pairs(names) do
    log[key] = 0
    owner[name] = function()
      log[key] = log[key] + 1
    end
  end
  return log
end

--- Counts the events of an object from now on.
---@return table log begins, stays, ends, crushes: numbers; sides: begins by side; speed: the last
function Run:listen(view)
  local names = { onStay = "stays", onEnd = "ends", onCrush = "crushes" }
  local log = small.set(counting(view.raw, names), { begins = 0, sides = {} })
  for _, side in ipairs(SIDES) do
    log.sides[side] = 0
  end
  function view.raw.onBegin(_, _, side, speed)
    log.begins, log.speed = log.begins + 1, speed
    side = turn.side(turn.back(self.turn), side)
    log.sides[side] = log.sides[side] + 1
  end
  return log
end

--- Counts the events of the world from now on: each pair once.
---@return table log begins, ends: numbers
function Run:listenToWorld()
  return counting(self.world, { onBegin = "begins", onEnd = "ends" })
end

-- Checking ---------------------------------------------------------------------------------------

-- Fails unless a condition holds, blaming the caller of the function that calls this.
local function ensure(run, condition, message, ...)
  if not condition then
    error(("after %.6g s: %s"):format(run.time or 0, message:format(...)), 3)
  end
end

--- Fails unless a condition holds.
function Run:check(condition, message, ...)
  ensure(self, condition, message, ...)
end

--- Fails unless a number is the expected one, at most `tolerance` (1e-6) off.
function Run:near(what, actual, expected, tolerance)
  local isNear = math.abs(actual - expected) <= (tolerance or TOLERANCE) -- false for NaN
  local message = "%s should be %.17g, is %.17g (%.3g off)"
  ensure(self, isNear, message, what, expected, actual, actual - expected)
end

--- Fails unless two values are the same, numbers to the bit.
function Run:same(what, actual, expected)
  local message = type(actual) == "number" and "%s should be %s, is %.17g"
    or "%s should be %s, is %s"
  if actual ~= expected then
    local is = type(actual) == "number" and actual or tostring(actual)
    ensure(self, false, message, what, tostring(expected), is)
  end
end

--- Fails unless a view is at a place, at most `tolerance` (1e-6 px) off.
function Run:at(view, x, y, tolerance)
  local reach, isX, isY = tolerance or TOLERANCE, view.x, view.y
  local isThere = math.abs(isX - x) <= reach and math.abs(isY - y) <= reach
  local message = "%s should be at (%.9g, %.9g), is at (%.9g, %.9g)"
  ensure(self, isThere, message, view.name or "object", x, y, isX, isY)
end

--- Fails unless a view rests: velocity exactly 0.
function Run:still(view)
  local vx, vy = view.vx, view.vy
  local message = "%s should be still, moves at (%.9g, %.9g)"
  ensure(self, vx == 0 and vy == 0, message, view.name or "object", vx, vy)
end

--- Fails unless `view` touches something on the sides listed, and on no other.
function Run:touches(view, ...)
  local expected, touching = {}, view.touching
  for _, side in ipairs({ ... }) do
    expected[side] = true
  end
  for _, side in ipairs(SIDES) do
    local is = touching[side] ~= false
    local message = is and "%s touches something on the %s" or "%s should touch something on the %s"
    ensure(self, is == (expected[side] == true), message, view.name or "object", side)
  end
end

--- Fails unless `a` has its `side` exactly on `b`, to the bit.
function Run:flush(a, b, side)
  local me, other = a.raw, b.raw
  local pressed = turn.side(self.turn, side)
  local axis = (pressed == "left" or pressed == "right") and "x" or "y"
  local size = axis == "x" and "width" or "height"
  local isBefore = pressed == "bottom" or pressed == "right"
  local expected = other[axis] + (isBefore and -me[size] or other[size])
  local message = "%s should be flush with its %s: raw %s should be %.17g, is %.17g"
  ensure(self, me[axis] == expected, message, a.name or "object", side, axis, expected, me[axis])
end

--- What stands under a view, or nil.
function Run:support(view)
  return self.views[view.raw.touching[turn.side(self.turn, "bottom")]]
end

--- Fails unless `view` lies flush on `lower`, and does not move up or down.
function Run:standsOn(view, lower)
  self:same("touching.bottom", self:support(view), lower)
  self:flush(view, lower, "bottom")
  self:same("vy", view.vy, 0)
end

--- A run in one variant.
function scene.run(variant)
  return small.set(setmetatable({}, Run), variant)
end

--- Plays a row in every variant of a selection; the failure names the variants that failed.
---@param levels table? see variants.select
---@param play fun(run: table)
function scene.each(levels, play)
  local selection, failures, messages = variants.select(levels), 0, {}
  for _, variant in ipairs(selection) do
    local ok, message = pcall(play, scene.run(variant))
    if not ok then
      failures = failures + 1
      messages[failures] = ("[%s] %s"):format(variant.name, tostring(message))
    end
  end
  if failures > 0 then
    local head = ("%d of %d variants fail:\n"):format(failures, #selection)
    error(head .. table.concat(messages, "\n", 1, math.min(failures, 3)), 2)
  end
end

--- A row of a spec: `it`, played in every variant of a selection.
---@param title string
---@param levels table? see variants.select
---@param play fun(run: table)
function scene.it(title, levels, play)
  small.rows(title, { {} }, function()
    scene.each(levels, play)
  end)
end

--- Returns a function that makes entries of a scene: objects of a group with these fields, and with
--- those that it is given.
---@param group string
---@param defaults table
---@return fun(fields?: table): table
function scene.thing(group, defaults)
  return function(fields)
    return { group, small.set(small.set({}, defaults), fields) }
  end
end

--- Returns a function that makes such entries from a name, a box and other fields.
---@param group string
---@param defaults table
---@return function thing(name, x, y, width, height, fields)
function scene.maker(group, defaults)
  return function(name, x, y, width, height, fields)
    local object = small.set(small.set({}, defaults), fields)
    return { group, small.set(object, small.put(x, y, width, height, { name = name })) }
  end
end

--- Adds a row of static tiles to a list of entries: `count` boxes of one size, `dx, dy` apart.
function scene.tiles(list, count, x, y, width, height, dx, dy)
  for i = 0, count - 1 do
    list[#list + 1] = { "tiles", small.tile(x + dx * i, y + dy * i, width, height) }
  end
  return list
end

return scene
