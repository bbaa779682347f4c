--- Ordinary calls of a game, timed beside the library of another commit, by turns:
---
---   luajit bench/ordinary.lua COMMIT [ROUNDS] [FILTER]    (FILTER: a part of their names)
---   luajit -joff bench/ordinary.lua COMMIT                 (as an interpreter)
---
--- Prints for each call ms with that library and with this one, processor time, the least of all
--- rounds, and the second as a share of the first. What takes more than LIMIT of that is marked.

local OLD, NEW = "build/ordinary", "." -- folders with the two libraries
local LIMIT, LEAST = 1.25, 0.002 -- what counts as slower: this share, and ms
local TRIES = 5 -- of which the best counts, in one round
local DT = 1 / 60

local filter -- of the names
local physics -- the library that is timed

-- Calls `call(n)` so many times; prints ms of one call. `before(n)` is not timed.
local function time(name, count, call, before)
  local clock, best, n = os.clock, math.huge, 0
  if not name:find(filter, 1, true) then
    return
  end
  for _ = 1, TRIES do
    local used = 0
    for _ = 1, count do
      n = n + 1
      if before then
        before(n)
      end
      local start = clock()
      call(n)
      used = used + clock() - start
    end
    best = math.min(best, used / count * 1000)
  end
  print(("%s\t%.6f"):format(name, best))
end

-- Levels ------------------------------------------------------------------------------------------

local function newTile(i)
  return {
    x = i % 200 * 16,
    y = 100 + 96 * math.floor(i / 200),
    width = 16,
    height = 16,
    static = true,
  }
end

-- Returns a world of floors, and those that stand on them.
local function build(tiles, movers)
  local world, list = physics.newWorld({ gravity = 800 }), {}
  for i = 0, tiles - 1 do
    world:add("tiles", newTile(i))
  end
  for i = 1, movers do
    local x, y = i * 37 % 3000, 80 + 96 * (i % 9)
    list[i] = world:add("movers", { x = x, y = y, width = 12, height = 20 })
  end
  return world, list
end

local function run(world, count)
  for _ = 1, count do
    world:update(DT)
  end
end

local function timeSteps()
  local world, list = build(2000, 40)
  local one = list[1]
  local function step()
    world:update(DT)
  end
  local function drive(field)
    return function(n)
      for _, object in ipairs(list) do
        object[field] = n % 2 == 0 and 60 or -60
      end
      world:update(DT)
    end
  end
  run(world, 60)
  time("a level at rest", 60, step)
  time("one walker", 60, function()
    one.vx = 60
    world:update(DT)
  end)
  time("40 walkers by vx", 60, drive("vx"))
  time("40 walkers by ax", 60, drive("ax"))
  for _, object in ipairs(list) do
    object.ax = nil
  end
  time("teleport", 20, function(n)
    one.x, one.y = 100 + n % 50, 40
    world:update(DT)
  end)
  time("another size", 20, function(n)
    one.height = 18 + n % 4
    world:update(DT)
  end)
  time("another mask", 20, function(n)
    one.mask = n % 2 == 0 and { tiles = false } or nil
    world:update(DT)
  end)
  one.mask = nil
  time("add, ask, step, remove", 20, function()
    local shot = { x = 50, y = -200, width = 4, height = 4, gravity = 0 }
    world:add("shots", shot)
    world:raycast(0, 50, 300, 60)
    world:update(DT)
    world:remove(shot)
  end)
  time("a tile goes and comes", 20, function()
    local tile = world.objects.tiles[500]
    world:remove(tile)
    world:add("tiles", tile)
    world:update(DT)
  end)
  time("explode", 10, function()
    world:explode(400, 60, 100, 5)
    world:update(DT)
  end)
end

local function timeQuestions()
  local world, list = build(2000, 40)
  local one = list[1]
  run(world, 60)
  time("raycast", 200, function()
    world:raycast(0, 50, 900, 90)
  end)
  time("querySegment", 200, function()
    world:querySegment(0, 50, 900, 110)
  end)
  time("queryRect", 200, function()
    world:queryRect(100, 50, 200, 100)
  end)
  time("queryPoint", 200, function()
    world:queryPoint(100, 105)
  end)
  time("overlapping", 200, function()
    world:overlapping(one)
  end)
  time("nearest", 200, function()
    world:nearest(one.x, one.y, 200)
  end)
  time("fits", 200, function()
    world:fits(one.x, one.y - 10, 12, 20)
  end)
  time("sweep", 200, function()
    world:sweep(one, 30, 0)
  end)
  time("ground", 200, function()
    world:ground(one)
  end)
  time("move", 200, function(n)
    world:move(one, 100 + n % 2, one.y)
  end)
end

-- What is asked in a world that has just changed.
local function timeChanges()
  local world, list = build(10000, 40)
  local coins = {}
  local function step()
    world:update(DT)
  end
  local function cast()
    for i = 1, 20 do
      world:raycast(i * 40, 50, i * 40 + 300, 120)
    end
  end
  for i = 1, 300 do
    coins[i] = { x = i * 9, y = -90, width = 6, height = 6, static = true, sensor = true }
    world:add("coins", coins[i])
  end
  run(world, 60)
  time("20 rays in a frame", 20, cast, step)
  time("20 rays after an add", 20, cast, function(n)
    step()
    world:add("shots", { x = -n * 9, y = -900, width = 4, height = 4, gravity = 0 })
  end)
  time("a coin goes, overlapping", 20, function()
    world:overlapping(list[1])
  end, function(n)
    step()
    world:remove(coins[n] or {})
  end)
  time("a tile goes, raycast", 10, cast, function(n)
    step()
    world:remove(world.objects.tiles[5000 + n])
  end)
  time("a tile of 10 000 goes, step", 10, step, function(n)
    world:remove(world.objects.tiles[4000 + n])
  end)
end

local function timeMoves()
  for _, isRead in ipairs({ false, true }) do
    local world, list = build(2000, 1)
    if isRead then
      world:update(0)
    end
    world:overlapping(list[1])
    time(isRead and "move after update(0)" or "move without an update", 300, function(n)
      world:move(list[1], 22 + n % 2, 60 + n % 20)
    end)
  end
end

local function timeStates()
  for _, tiles in ipairs({ 2000, 10000 }) do
    local world, state = build(tiles, 22), nil
    run(world, 60)
    local function name(text)
      return ("%s, %d tiles"):format(text, tiles)
    end
    state = world:save()
    time(name("save"), 10, function()
      world:save(state)
    end)
    time(name("restore"), 10, function()
      world:restore(state)
    end)
    time(name("hash"), 10, function()
      world:hash()
    end)
    time(name("back by 8 frames"), 3, function()
      world:restore(state)
      for _ = 1, 8 do
        world:update(DT)
        world:save()
      end
    end)
  end
end

local function timeStarts()
  time("a new world of 10 boxes", 20, function()
    local world = physics.newWorld({ gravity = 800 })
    for i = 1, 10 do
      world:add("boxes", { x = i * 20, y = 0, width = 10, height = 10 })
    end
    world:update(DT)
  end)
  time("a new world of 2000 tiles", 1, function()
    run(build(2000, 0), 60)
  end)
  local rows, world, tiles = {}, nil, nil
  for y = 1, 60 do
    rows[y] = (y % 6 == 0 and "#" or "."):rep(120)
  end
  local function load()
    world = physics.newWorld({ gravity = 800 })
    tiles = world:addTiles("earth", rows, nil, 16)
    world:update(DT)
  end
  time("addTiles of 120 x 60", 2, load)
  load()
  time("setTile", 20, function(n)
    tiles:setTile(1 + n % 100, 6, n % 2)
    world:update(DT)
  end)
end

-- Boxes, or circles, that land in a room, and such that press to its middle.
local function timeCrowds()
  for _, kind in ipairs({ "boxes", "circles" }) do
    local radius = kind == "circles" and 7 or nil
    time("80 " .. kind .. " land, 200 steps", 1, function()
      local world = physics.newWorld({ gravity = 800 })
      world:setBounds(0, 0, 600, 600)
      for i = 0, 79 do
        local x, y = 40 + i % 10 * 50, 20 + math.floor(i / 10) * 50
        local object = { x = x, y = y, width = 14, height = 14, radius = radius, vx = i % 7 * 20 }
        world:add("things", object)
      end
      run(world, 200)
    end)
    time("80 " .. kind .. " crowd, 200 steps", 1, function()
      local world, list = physics.newWorld({ gravity = 0 }), {}
      for i = 1, 80 do
        local object = { x = i * 71 % 900, y = i * 37 % 700, width = 14, height = 14 }
        object.radius = radius
        list[i] = world:add("things", object)
      end
      for _ = 1, 200 do
        for _, object in ipairs(list) do
          local x, y = 450 - object.x, 350 - object.y
          local far = math.max(1, math.sqrt(x * x + y * y))
          object.vx, object.vy = 80 * x / far, 80 * y / far
        end
        world:update(DT)
      end
    end)
  end
end

local function play(folder)
  package.path = folder .. "/?.lua;" .. package.path
  physics = require("physics")
  timeSteps()
  timeQuestions()
  timeChanges()
  timeMoves()
  timeStates()
  timeStarts()
  timeCrowds()
end

-- Comparing ---------------------------------------------------------------------------------------

-- Notes the least times of a library, by name; the names are listed in `names`.
local function measure(folder, least, names)
  local command = ('%s bench/ordinary.lua --play %s "%s"'):format(arg[-1], folder, filter)
  if arg[-2] then
    command = ("%s %s"):format(arg[-2], command)
  end
  local pipe = assert(io.popen(command))
  for line in pipe:lines() do
    local name, ms = line:match("^(.-)\t(.*)$")
    names[#names + 1] = not least[name] and name or nil
    least[name] = math.min(least[name] or math.huge, tonumber(ms))
  end
  pipe:close()
end

local function compare(commit, rounds)
  local text = "rm -rf %s && mkdir -p %s && git archive '%s' physics.lua physics | tar -x -C %s"
  os.execute(text:format(OLD, OLD, commit, OLD))
  local old, new, names = {}, {}, {}
  for _ = 1, rounds do
    measure(OLD, old, {})
    measure(NEW, new, names)
  end
  for _, name in ipairs(names) do
    local before, now = old[name] or 0 / 0, new[name]
    local isSlower = now > before * LIMIT and now > LEAST
    print(
      ("%-32s %9.4f -> %9.4f ms %6.2f%s"):format(
        name,
        before,
        now,
        now / before,
        isSlower and "  slower" or ""
      )
    )
  end
end

if arg[1] == "--play" then
  filter = arg[3]
  play(arg[2])
else
  filter = arg[3] or ""
  compare(arg[1] or "HEAD", tonumber(arg[2]) or 3)
end
