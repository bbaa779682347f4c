--- The scenes, as data. Each file in bench/scenes/ returns a list of
---
---   name    what `--scene` calls it
---   title   for people
---   sizes   the values of n at which it is measured
---   quick   a small n, to see that it runs
---   growth  values of n at which bench/worst.lua looks how the time grows
---   startsInside  true: objects overlap at the start
---   build(n) -> a scene, which is told its name:
---     gravity   px/s²
---     hasMasses true: boxes have a `mass`, 1 where none is given, in every engine
---     objects   descriptions of boxes: group, x, y, width, height, vx, vy, static, kinematic,
---               friction, restitution, gravity, mass, pushable, maxSpeed, sensor, hits, radius,
---               slope, area; the same fields as those of physics.lua
---     soft      groups with objects that may overlap and drift apart, as in physics.lua; engines
---               that know nothing like it keep them solid
---     rest      true: engines may skip what rests, and those that cannot do not play; false:
---               no engine may; nil: as the engine likes
---     needs     features of which an engine may say that it lacks them (bench/engines.lua)
---     worlds    number of independent worlds made of it, default 1
---     steps, warmUp   numbers of frames that are measured, and that go before, default 600 and 60
---     frame(world, step)    what is measured, default: world:step(1 / 60)
---     between(world, step)  what happens before each frame and is not measured
---     driven, room          only of the worst cases, see bench/scenes/worst/shared.lua
---     still                 number of an object that must not move (bench/bounds.lua)
---
--- All of them are deterministic: every engine meets the same boxes and the same inputs.

local scenes = {}

local FILES = {
  "pile",
  "level",
  "gas",
  "balls",
  "zones",
  "swarm",
  "bullets",
  "lifts",
  "rays",
  "asking",
  "spawn",
  "dig",
  "rooms",
  "rest",
  "state",
  "worst.spots",
  "worst.squeezes",
}

local STEPS, WARM_UP, DT = 600, 60, 1 / 60

--- The definitions, in the order in which they are measured and printed.
scenes.list = {}

local byName = {}
for _, file in ipairs(FILES) do
  for _, definition in ipairs(require("bench.scenes." .. file)) do
    scenes.list[#scenes.list + 1] = definition
    byName[definition.name] = definition
  end
end

local function advance(world)
  world:step(DT)
end

--- Builds a scene, with the defaults filled in.
---
--- Errors: an unknown name.
---@param name string
---@param n integer
---@return table scene
function scenes.build(name, n)
  local definition = byName[name] or error("unknown scene " .. tostring(name), 2)
  local scene = definition.build(n)
  scene.name = name
  scene.frame = scene.frame or advance
  scene.steps = scene.steps or STEPS
  scene.warmUp = scene.warmUp or WARM_UP
  scene.worlds = scene.worlds or 1
  return scene
end

--- The definition of that name, or nil.
function scenes.get(name)
  return byName[name]
end

return scenes
