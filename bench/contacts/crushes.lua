--- Which objects `onCrush` names among slopes and movers, also after `restore`; and what is put
--- elsewhere when it has been crushed.

local overlap = require("spec.support.overlap")
local scenes = require("bench.contacts.scene")
local shapes = require("physics.space.shapes")
local small = require("spec.support.small")

local put, tile = small.put, small.tile

local WIDTH, HEIGHT = 240, 180 -- px, of the room
local SLOPES = { false, "left", "right", "topleft", "topright" }

local function gapOf(a, b)
  local shape, other = shapes.of(a), shapes.of(b)
  local gap = shapes.gap(shape, a.x, a.y, a.width, a.height, other, b.x, b.y, b.width, b.height)
  return gap
end

-- A rectangle somewhere in the room.
local function place(random, leastWidth, mostWidth, leastHeight, mostHeight)
  local width, height =
    random:integer(leastWidth, mostWidth), random:integer(leastHeight, mostHeight)
  return put(random:integer(0, WIDTH - width), random:integer(0, HEIGHT - height), width, height)
end

-- Builds a room of slopes, movers and things, some of them in something, and returns the movers.
local function build(scene)
  local random = scene.random
  scene:start({ 900, 900, 0 })
  scene.world:setBounds(0, 0, WIDTH, HEIGHT)
  for _ = 1, random:integer(4, 12) do
    local wall = scene:vary(place(random, 16, 80, 12, 60), "static", { true }, "slope", SLOPES)
    scene:add("walls", wall)
  end
  local movers = {}
  for n = 1, random:integer(1, 3) do
    local mover = scene:vary(place(random, 20, 70, 10, 40), "kinematic", { true }, "slope", SLOPES)
    scene:vary(mover, "vx", { 0, 40, -40 }, "vy", { 0, 50, -50 })
    movers[n] = scene:add("movers", mover)
  end
  local solid, things = small.set({}, scene.objects), {}
  for _ = 1, random:integer(2, 7) do
    local size = random:integer(8, 22)
    local thing = place(random, size, size, size, size)
    thing.radius = random:chance(0.35) and size / 2 or nil
    if scene:isFree(thing, solid) or random:chance(0.03) then
      scene:addFree("things", thing, things)
    end
  end
  return movers
end

local function playNames(scene)
  local movers, names, log = build(scene), {}, {}
  local world = scene.world
  for group, objects in pairs(world.objects) do
    for n, object in pairs(objects) do
      names[object] = group .. " " .. n
    end
  end
  function world.onCrush(object, a, b, axis)
    local words = { names[object], tostring(names[a]), tostring(names[b]), axis }
    log[#log + 1] = table.concat(words, ", ")
    scene:show("      crushed: %s", log[#log])
    for _, other in ipairs({ a or false, b or false }) do
      local isWrong = not (other and world:groupOf(other)) or other == object
      scene:measure("names nothing, or itself", isWrong)
      scene:measure("names one that is away, px", not isWrong and gapOf(object, other))
    end
  end
  local function drive()
    for _, mover in ipairs(movers) do
      scene:turn(mover, -10, WIDTH + 10 - mover.width, -10, HEIGHT + 10 - mover.height)
    end
  end
  scene:play(1.5 + scene.seed % 5 / 2, drive)
  local state, logs, hashes = world:save(), {}, {}
  for n = 1, 2 do
    log = {}
    scene:play(2.5, drive)
    logs[n], hashes[n] = table.concat(log, "; "), world:hash()
    world:restore(state)
  end
  scene:measure("differs after restore", logs[1] ~= logs[2] or hashes[1] ~= hashes[2])
end

-- Put elsewhere -----------------------------------------------------------------------------------

local function playElsewhere(scene)
  local random = scene.random
  local hz = scene:start()
  scene:add("floors", tile(-1000, 300, 2000, 20))
  local press = put(0, 100, 120, random:pick({ 20, 60 }), { kinematic = true, vy = 60 })
  scene:add("presses", scene:vary(press, "slope", { false, "topleft", "topright" }))
  local isRound = random:chance(0.3)
  local thing = isRound and small.ball(60, 290, 10) or put(random:between(20, 80), 276, 14, 24)
  if random:chance(0.3) then
    scene:add("walls", tile(thing.x + thing.width, 200, 10, 100))
    scene:add("walls", tile(thing.x - 10, 200, 10, 100))
  end
  scene:add("things", thing)
  while scene.crushes == 0 and scene.frame < 5 * hz do
    scene:step()
  end
  if scene.crushes == 0 then
    return
  end
  scene:play(random:integer(0, 6) / hz)
  press.vy = random:pick({ 0, 60, -60 })
  local isFree = random:chance(0.75)
  thing.vx, thing.vy, scene.crushes = 0, 0, 0
  if isFree then
    thing.x, thing.y = random:pick({ 140, 400 }), 260
  else
    thing.x, thing.y = press.x + 100 - thing.width, press.y + 4
  end
  local x = thing.x
  scene:play(0.5, nil, function()
    thing.vx = isFree and 60 or thing.vx
  end)
  scene:measure("not free, px", isFree and math.abs(thing.x - x - 30) - 60 / hz)
  scene:measure("crushed where it is free", isFree and scene.crushes)
  local isUntold = not isFree and scene.crushes == 0
  scene:measure("put into the press, not told, px", isUntold and overlap.depth(thing, press))
end

return {
  scenes.subject("crushes", 400, playNames, {
    { "names nothing, or itself", 0 },
    { "names one that is away, px", 1 },
    { "differs after restore", 0 },
  }),
  scenes.subject("elsewhere", 300, playElsewhere, {
    { "not free, px", 1e-6 },
    { "crushed where it is free", 0 },
    { "put into the press, not told, px", 0.01 },
  }),
}
