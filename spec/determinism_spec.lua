--- One scene with everything in it (spec/support/everything.lua) gives one number: on every Lua, in
--- every process, however the objects got into their tables and whatever was there before.

local case = require("spec.fuzz.case")
local effort = require("spec.support.effort")
local everything = require("spec.support.everything")
local fold = require("spec.support.fold")
local player = require("spec.fuzz.player")
local newRandom = require("spec.support.random").new

-- Changes whenever the behaviour does. The new one is what `luajit spec/support/everything.lua`
-- prints; before it is written here, `lua5.1` and `lua5.4` must print the same. A change of it is a
-- **Behaviour** entry in the changelog.
local FOLD = "90918863525159"

-- All of them from LuaJIT; on the slower ones one other process is enough.
local INTERPRETERS = { "luajit" }
if rawget(_G, "jit") then
  INTERPRETERS = { "luajit", "luajit -joff", "lua5.1", "lua5.2", "lua5.3", "lua5.4" }
end

-- What a command prints, without the end of the line.
local function run(command)
  local pipe = assert(io.popen(command .. " 2>&1"))
  local text = pipe:read("*a")
  pipe:close()
  return (text:gsub("%s+$", ""))
end

local function isInstalled(interpreter)
  return run(interpreter .. [[ -e "io.write('yes')"]]) == "yes"
end

-- Everything in the world's tables and order stays the same; slots and pairs do not.
local function comeAndGo(world, seed)
  local random, guests = newRandom(seed), {}
  for i = 1, 40 do
    local guest = { x = 10 * i, y = 5 * i, width = 30, height = 30, static = i % 5 == 0 }
    guests[i] = world:add("guests", guest)
  end
  for i, guest in ipairs(random:shuffled(guests)) do
    if i % 7 == 0 then
      world:update(1 / 60)
    end
    world:remove(guest)
  end
  world:update(1 / 60)
  world.objects.guests = nil
  world:update(0)
end

describe("the scene with everything in it", function()
  it("gives the number that stands here", function()
    assert.are.equal(FOLD, everything.fold())
  end)

  -- Where all interpreters play this file, one of them starts the others.
  local all = effort.isFirst and it or pending
  all("gives it on every Lua that is installed, in a process of its own #posix #slow", function()
    local count = 0
    for _, interpreter in ipairs(INTERPRETERS) do
      if isInstalled(interpreter) then
        count = count + 1
        assert.are.equal(FOLD, run(interpreter .. " spec/support/everything.lua"), interpreter)
      end
    end
    assert.is_true(count > 0, "no interpreter was found")
  end)

  for _, row in ipairs({
    { "pair by pair", { broadphase = "pairs" } },
    { "in cells of 24 px", { broadphase = "grid", cellSize = 24 } },
    { "nothing skipped", { rest = false } },
  }) do
    it("gives it " .. row[1], function()
      assert.are.equal(FOLD, everything.fold(everything.new(row[2])))
    end)
  end

  it("gives it with objects put in by table.insert #slow", function()
    local world = everything.new(nil, function(world, group, object)
      world.objects[group] = world.objects[group] or {}
      table.insert(world.objects[group], object)
    end)
    assert.are.equal(FOLD, everything.fold(world))
  end)

  it("gives it whatever came and went before #slow", function()
    for seed = 1, 3 do
      local world = everything.newWorld()
      comeAndGo(world, seed)
      assert.are.equal(FOLD, everything.fold(everything.fill(world)))
    end
  end)

  it("gives it with groups filled in another order #slow", function()
    local list, world = {}, everything.newWorld()
    everything.fill(world, function(_, group, object)
      list[#list + 1] = { group, object }
    end)
    local keys, last = {}, {}
    for i, entry in ipairs(list) do
      last[entry[1]] = (last[entry[1]] or 0) + 1
      keys[i] = last[entry[1]]
    end
    for i = #list, 1, -1 do
      local group, object = list[i][1], list[i][2]
      world.objects[group] = world.objects[group] or {}
      world.objects[group][keys[i]] = object
    end
    assert.are.equal(FOLD, everything.fold(world))
  end)

  it("gives it whatever the garbage collector does #slow", function()
    local pause, multiplier = collectgarbage("setpause", 100), collectgarbage("setstepmul", 400)
    local eager = everything.fold(nil, function(_, n)
      if n % 10 == 0 then
        collectgarbage()
      end
    end)
    collectgarbage("stop")
    local never = everything.fold()
    collectgarbage("restart")
    collectgarbage("setpause", pause)
    collectgarbage("setstepmul", multiplier)
    assert.are.same({ FOLD, FOLD }, { eager, never })
  end)

  it("gives it when saved and restored before every tenth step", function()
    assert.are.equal(
      FOLD,
      everything.fold(nil, function(world, n)
        if n % 10 == 0 then
          world:restore(world:save())
        end
      end)
    )
  end)

  it("gives it beside another world that runs in between #slow", function()
    local other = everything.new({ push = "first" })
    assert.are.equal(
      FOLD,
      everything.fold(nil, function(_, n)
        everything.step(other, n, 3)
      end)
    )
  end)
end)

-- Two of the same size in the same place: no side is nearer. The order of the world decides, also
-- after the two have become neighbours in another way, or in another world.
describe("a tie", function()
  local physics = require("physics")

  local function sideOf(which, isRestored)
    local world, told = physics.newWorld({ gravity = 0 }), nil
    local function listen(_, _, side)
      told = side
    end
    local sensor =
      world:add("a", { x = which == "sensor" and 500 or 0, y = 0, width = 10, height = 10 })
    sensor.sensor = true
    local box = world:add("b", { x = which == "box" and 500 or 12, y = 0, width = 10, height = 10 })
    world:update(1 / 60)
    sensor.x, box.x = 0, 12
    world:update(1 / 60)
    world:update(1 / 60)
    if isRestored then
      local state = world:save()
      world = physics.newWorld({ gravity = 0 })
      world:restore(state)
    end
    world.onBegin = listen
    world.objects.a[1].x = world.objects.b[1].x
    world:update(1 / 60)
    return told
  end

  it("is decided by the order of the world, not by which object came to which", function()
    for _, which in ipairs({ "sensor", "box" }) do
      assert.are.equal("bottom", sideOf(which, false), which)
      assert.are.equal("bottom", sideOf(which, true), which)
    end
  end)

  it("of two gravities is the same for integers and floats", function()
    for _, gravity in ipairs({ 4000000000, 4000000000.0 }) do
      local world = physics.newWorld({ gravity = gravity, gravityX = 1 })
      local box = world:add("boxes", { x = 0, y = 0, width = 8, height = 8 })
      world:add("floor", { x = 0, y = 8, width = 99, height = 8, static = true })
      world:update(1 / 60)
      assert.are.equal(0, box.vy)
    end
  end)
end)

-- As FOLD: the numbers of random games, which notice what no other spec does (how long a push at a
-- speed limit takes, once). Ten are of engines at their limits.
local GAMES = {
  { first = 5000001, count = 8, fold = "20506319" },
  { first = 5000009, count = 8, fold = "1978249483", tag = " #slow" },
  { first = 5000004, count = 10, step = 10, fold = "288267281", tag = " #slow" },
}

describe("random games", function()
  for _, games in ipairs(GAMES) do
    local text = "from seed %d on give the number that stands here"
    it(text:format(games.first) .. (games.tag or ""), function()
      local sum, updates = fold.START, 0
      for n = 0, games.count - 1 do
        local one = case.new(games.first + n * (games.step or 1), 60)
        local its = player.new(one)
        for _, act in ipairs(one.acts) do
          if act[1] ~= "twin" then
            its:act(act)
          end
          if act[1] == "update" then
            sum, updates = fold.number(sum, its.world:hash()), updates + 1
          end
        end
      end
      assert.are.equal(60 * games.count, updates)
      assert.are.equal(games.fold, ("%.0f"):format(sum))
    end)
  end
end)
