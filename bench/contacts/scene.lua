--- A random scene of bench/contacts.lua: worlds whose steps can be shown, and the worst figures of
--- the scene. A file of bench/contacts/ returns a list of subjects (`scenes.subject`).

local newRandom = require("spec.support.random").new
local overlap = require("spec.support.overlap")
local physics = require("physics")

local scenes = {}

scenes.RATES = { 30, 60, 144 }
scenes.SLOPES = { "left", "right", "topleft", "topright" }
scenes.EXACT = 1.001e-6 -- px, up to which two that touch may overlap

local Scene = {}
Scene.__index = Scene

--- Makes a subject.
---@param name string
---@param count integer scenes of a complete run
---@param play fun(scene: table) builds worlds, plays them, and measures
---@param rows table[] name of a figure, and its aim: the most that a scene may have
function scenes.subject(name, count, play, rows)
  return { name = name, count = count, play = play, rows = rows }
end

--- Makes a scene of a subject; `isShown`: it prints what happens.
function scenes.new(subject, seed, isShown)
  local scene = setmetatable({ seed = seed, isShown = isShown }, Scene)
  scene.values, scene.frames, scene.counts = {}, {}, {}
  scene:reseed(seed)
  for _, row in ipairs(subject.rows) do
    scene.values[row[1]] = 0
  end
  return scene
end

--- Begins the random numbers of a seed.
function Scene:reseed(seed)
  self.left, self.random = seed, newRandom(seed)
end

--- One of a list, so that consecutive seeds take all combinations of the lists of a scene, with the
--- same random numbers.
function Scene:each(list)
  local n = (self.left - 1) % #list
  self:reseed((self.left - 1 - n) / #list + 1)
  return list[n + 1]
end

--- Sets fields of an object, each to one of a list (false: to none), and returns it:
--- `scene:vary(crate, "mass", { 1, 5 }, "snap", { false, 6 })`.
function Scene:vary(object, ...)
  local fields = { ... }
  for n = 1, #fields, 2 do
    object[fields[n]] = self.random:pick(fields[n + 1]) or nil
  end
  return object
end

--- Begins a world.
---@param gravity? number|number[] or one of a list, default 900
---@param hz? number|number[] steps a second, default one of RATES
---@return number hz
function Scene:start(gravity, hz)
  gravity, hz = gravity or 900, hz or scenes.RATES
  self.hz = type(hz) == "table" and self.random:pick(hz) or hz
  self.gravity = type(gravity) == "table" and self.random:pick(gravity) or gravity
  self:again()
  return self.hz
end

--- Begins another world with the same gravity and rate. `told` counts the calls of `onCrush` by
--- object, `crushes` all of them.
function Scene:again()
  self.frame, self.objects, self.shown = 0, {}, {}
  self.told, self.crushes = {}, 0
  self.world = physics.newWorld({ gravity = self.gravity })
  self.findDeepest = overlap.checker(self.objects)
  self.world.onCrush = function(object)
    self.crushes = self.crushes + 1
    self.told[object] = (self.told[object] or 0) + 1
    self:show("crushed: %s", tostring(self.world:groupOf(object)))
  end
  self:show("a world with gravity %g, %d Hz", self.gravity, self.hz)
end

--- Prints a line, if the scene is shown.
function Scene:show(...)
  if self.isShown then
    print(string.format(...))
  end
end

-- The fields of an object that a game has set.
local function describe(object)
  local words = {}
  for name, value in pairs(object) do
    if type(value) ~= "function" and type(value) ~= "table" then
      words[#words + 1] = ("%s %s"):format(name, tostring(value))
    end
  end
  table.sort(words)
  return table.concat(words, ", ")
end

--- Adds an object to the world and to `objects`, and returns it.
function Scene:add(group, object)
  self:show("%d in %s: %s", #self.objects + 1, group, self.isShown and describe(object))
  self.objects[#self.objects + 1] = object
  return self.world:add(group, object)
end

--- Makes a step. If the scene is shown, prints the objects that have changed: the frame, their
--- number, place, size and velocity.
function Scene:step()
  self.frame = self.frame + 1
  self.world:update(1 / self.hz)
  for n, object in ipairs(self.isShown and self.objects or {}) do
    local x, y, width, height = object.x, object.y, object.width, object.height
    local text = ("x %.7g y %.7g  %g x %g"):format(x, y, width, height)
    text = text .. ("  vx %.5g vy %.5g"):format(object.vx or 0, object.vy or 0)
    if text ~= self.shown[n] and not object.static then
      self.shown[n] = text
      self:show("%4d  %2d  %s", self.frame, n, text)
    end
  end
end

--- Plays some seconds; `before(n)` is called before the n-th step, `after(n)` behind it.
function Scene:play(seconds, before, after)
  for n = 1, seconds * self.hz + 1e-6 do
    if before then
      before(n)
    end
    self:step()
    if after then
      after(n)
    end
  end
end

--- Px by which the objects of the scene overlap at most.
function Scene:deepest()
  return (self.findDeepest())
end

--- Whether an object is farther than `gap` px, default 0, from all of a list.
function Scene.isFree(_, object, others, gap)
  for _, other in ipairs(others) do
    if overlap.depth(object, other) > -(gap or 0) then
      return false
    end
  end
  return true
end

--- Adds an object to the world and to a list, if it is that far from all of the list.
function Scene:addFree(group, object, list, gap)
  if self:isFree(object, list, gap) then
    list[#list + 1] = self:add(group, object)
  end
end

--- Sends a mover back that has come to an end of its way.
function Scene.turn(_, mover, left, right, top, bottom)
  if mover.x < left or mover.x > right then
    mover.vx = mover.x < left and math.abs(mover.vx) or -math.abs(mover.vx)
  end
  if mover.y < top or mover.y > bottom then
    mover.vy = mover.y < top and math.abs(mover.vy) or -math.abs(mover.vy)
  end
end

--- Where the objects of a list are, for `moved`.
function Scene.places(_, list)
  local places = {}
  for n, object in ipairs(list) do
    places[n] = { x = object.x, y = object.y }
  end
  return places
end

--- Px by which one of a list has moved along an axis since then, at most.
function Scene.moved(_, list, places)
  local most = 0
  for n, place in ipairs(places) do
    most = math.max(most, math.abs(list[n].x - place.x), math.abs(list[n].y - place.y))
  end
  return most
end

--- Px by which an object is in one of a list at most, at right angles to a slope.
function Scene.depthIn(_, object, list)
  local deepest = 0
  for _, other in ipairs(list) do
    local depth = overlap.depth(object, other)
    if other.slope and depth > 0 and depth < 1 then
      local width, height = other.width, other.height
      depth = depth * width / math.sqrt(width * width + height * height)
      depth = depth / math.min(1, width / height)
    end
    deepest = math.max(deepest, depth)
  end
  return deepest
end

--- Notes a figure of a row, if it is the largest one so far; true counts as 1.
function Scene:measure(row, value)
  self.counts[row] = (self.counts[row] or 0) + 1
  value = value == true and 1 or value or 0
  if value > self.values[row] then
    self.values[row], self.frames[row] = value, self.frame
    self:show("      %s: %.4g", row, value)
  end
end

return scenes
