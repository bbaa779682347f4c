--- How large is the library, and how much memory does it take? Beside it stands bump.lua, where it
--- is found:
---
---   luajit bench/size.lua [--path DIR] [--rounds 15]
---
--- Each number is measured in a process of its own. Memory is what the collector counts after two
--- full collections: LuaJIT's machine code is not in it.

package.path = "./?.lua;" .. package.path

local files = require("spec.support.files")

local INTERPRETERS = { "luajit", "lua5.1" }
local FOLDER, SINGLE = "build/size", "build/size/single/physics.lua"
local WORLDS, TILES, OBJECTS = 20, 2000, 40

-- In a process of its own -------------------------------------------------------------------------

local function used()
  local jit = rawget(_G, "jit")
  if jit then
    jit.flush()
  end
  collectgarbage()
  collectgarbage()
  return collectgarbage("count") * 1024
end

local function tileOf(i)
  local x, y = 16 * (i % 100), 16 * math.floor(i / 100)
  return { x = x, y = y, width = 16, height = 16, static = true }
end

-- Boxes in four rows above a floor; the floor is the last one.
local function objectsOf(count)
  local list = {}
  for i = 1, count - 1 do
    list[i] =
      { x = 20 * (i % 10), y = 20 * math.floor(i / 10), width = 16, height = 16, vx = 0, vy = 0 }
  end
  list[count] = { x = -100, y = 200, width = 600, height = 20, static = true }
  return list
end

local engines = {}

engines.physics = {
  new = function(physics)
    return physics.newWorld({ gravity = 800 })
  end,
  add = function(world, object)
    world:add(object.static and "tiles" or "boxes", object)
  end,
  step = function(world)
    world:update(1 / 60)
  end,
}

engines.bump = {
  new = function(bump)
    return bump.newWorld(32)
  end,
  add = function(world, object)
    world:add(object, object.x, object.y, object.width, object.height)
  end,
  step = function(world)
    local items = world:getItems()
    for i = 1, #items do
      local object = items[i]
      if not object.static then
        object.vy = object.vy + 800 / 60
        world:move(object, object.x, object.y + object.vy / 60)
      end
    end
  end,
}

local measures = {}

-- ms that `require` takes.
function measures.require(name)
  local started = os.clock()
  require(name)
  return 1000 * (os.clock() - started)
end

-- Bytes of the loaded library.
function measures.heap(name)
  local before = used()
  require(name)
  return used() - before
end

-- Bytes of a world in which there is nothing.
function measures.empty(name)
  local engine, module, worlds = engines[name], require(name), {}
  worlds[1] = engine.new(module)
  local before = used()
  for i = 2, WORLDS + 1 do
    worlds[i] = engine.new(module)
  end
  return (used() - before) / WORLDS, #worlds
end

-- Bytes of a world of 40 objects that has played a second; the game's own tables are not counted.
function measures.world(name)
  local engine, module, worlds, lists = engines[name], require(name), {}, {}
  local function play(i)
    worlds[i] = engine.new(module)
    for _, object in ipairs(lists[i]) do
      engine.add(worlds[i], object)
    end
    for _ = 1, 60 do
      engine.step(worlds[i])
    end
  end
  for i = 1, WORLDS + 1 do
    lists[i] = objectsOf(OBJECTS)
  end
  play(1)
  local before = used()
  for i = 2, WORLDS + 1 do
    play(i)
  end
  return (used() - before) / WORLDS, #worlds
end

-- Bytes of one static tile among 2000.
function measures.tile(name)
  local engine, list = engines[name], {}
  local world = engine.new(require(name))
  for i = 1, TILES do
    list[i] = tileOf(i)
  end
  engine.step(world)
  local before = used()
  for i = 1, TILES do
    engine.add(world, list[i])
  end
  engine.step(world)
  return (used() - before) / TILES
end

-- All of them -------------------------------------------------------------------------------------

-- The source without comments, indents and empty lines.
local function stripped(text)
  local parts, before = {}, nil
  for _, token in ipairs(require("scripts.mutations").tokens(text)) do
    if before and token.line > before.line then
      parts[#parts + 1] = "\n"
    elseif before and token.at > before.at + #before.text then
      parts[#parts + 1] = " "
    end
    parts[#parts + 1], before = token.text, token
  end
  local result = table.concat(parts) .. "\n"
  local function compiled(source)
    return string.dump(assert(loadstring(source)), true)
  end
  assert(compiled(result) == compiled(text), "without its comments it is another program")
  return result
end

local function median(list)
  table.sort(list)
  return list[math.floor(#list / 2) + 1]
end

-- Of several processes the median.
local function measured(interpreter, path, what, name, rounds)
  local list = {}
  for i = 1, rounds do
    local command = "LUA_PATH='%s/?.lua;./?.lua' %s bench/size.lua --measure %s %s"
    list[i] = assert(tonumber(files.output(command:format(path, interpreter, what, name))), what)
  end
  return median(list)
end

local function sourceBytes()
  local total = 0
  for path in files.output("find physics.lua physics -name '*.lua'"):gmatch("[^\n]+") do
    local text = files.read(path)
    if not text:find("^%-%-%-@meta") then -- types for editors, never loaded
      total = total + #text
    end
  end
  return total
end

-- Heading, measure, unit in which it is shown, how many processes, and the aim.
local ROWS = {
  { "`require`", "require", "ms", 1, true },
  { "heap after `require`", "heap", "kB", 1000 },
  { "an empty world", "empty", "kB", 1000 },
  { "a world of 40 objects, after a second", "world", "kB", 1000 },
  { "a static tile, among 2000", "tile", "bytes", 1 },
}

local function report(options)
  os.execute("mkdir -p " .. FOLDER .. "/single " .. FOLDER .. "/small")
  assert(os.execute("luajit scripts/single.lua " .. SINGLE))
  local single = files.read(SINGLE)
  local small = stripped(single)
  files.write(FOLDER .. "/small/physics.lua", small)

  local places = {
    { "physics.lua", ".", "physics", sourceBytes() },
    { "one file", FOLDER .. "/single", "physics", #single },
    { "without comments", FOLDER .. "/small", "physics", #small },
  }
  local bump = io.open(options.path .. "/bump.lua", "rb")
  if bump then
    places[#places + 1] = { "bump.lua", options.path, "bump", #bump:read("*a") }
    bump:close()
  end

  local heads, line, bytes = { "" }, { "---" }, { "source, kB" }
  for i, place in ipairs(places) do
    heads[i + 1], line[i + 1], bytes[i + 1] = place[1], "---:", ("%.1f"):format(place[4] / 1000)
  end
  local lines = { heads, line, bytes }
  for _, interpreter in ipairs(INTERPRETERS) do
    for _, row in ipairs(ROWS) do
      local cells = { ("%s, %s, %s"):format(row[1], row[3], interpreter) }
      for i, place in ipairs(places) do
        local rounds = row[5] and options.rounds or 1
        local value = measured(interpreter, place[2], row[2], place[3], rounds) / row[4]
        cells[i + 1] = row[3] == "bytes" and ("%.0f"):format(value) or ("%.1f"):format(value)
      end
      lines[#lines + 1] = cells
    end
  end
  for _, cells in ipairs(lines) do
    print("| " .. table.concat(cells, " | ") .. " |")
  end
end

local options, i = { path = ".", rounds = 15 }, 1
if arg[1] == "--measure" then
  package.path = os.getenv("LUA_PATH")
  io.write(("%.3f"):format((measures[arg[2]](arg[3]))))
  return
end
while arg[i] do
  local name = arg[i]:match("^%-%-(.+)$")
  assert(name and options[name], "bench-size: unknown option " .. arg[i])
  options[name] = type(options[name]) == "number" and assert(tonumber(arg[i + 1]), arg[i])
    or assert(arg[i + 1], arg[i])
  i = i + 2
end
report(options)
