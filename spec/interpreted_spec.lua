--- What LuaJIT may compile: by default only what it is good at, after `physics.compile` nearly
--- everything, and never what goes through a table by `next` or `pairs`.

local fresh = require("spec.support.fresh")
local newRandom = require("spec.support.random").new
local physics = require("physics")

local jit = rawget(_G, "jit")

local function read(path)
  local file = assert(io.open(path, "rb"))
  local text = file:read("*a")
  file:close()
  return text
end

-- All files of the library, from the rockspec.
local function listFiles()
  local files = {}
  local spec = assert(io.popen("ls rockspec/*.rockspec")):read("*l")
  for path in read(spec):gmatch('"(physics[%w/]*%.lua)"') do
    files[#files + 1] = path
  end
  return files
end

-- The functions of a file that go through a table by `next` or `pairs`, as they are written at the
-- left margin.
local function walkersOf(text)
  local names, current = {}, "(the file itself)"
  for line in text:gmatch("[^\n]+") do
    current = line:match("^local function ([%w_]+)")
      or line:match("^function ([%w_.:]+)")
      or current
    local code = (" " .. line):gsub("%-%-.*", "")
    if code:find("[^%w_.]next[,(]") or code:find("[^%w_i]pairs%(") then
      names[(current:gsub(":", "."))] = true
    end
  end
  return names
end

local function keptIn(text)
  local kept = {}
  for list in text:gmatch("interpreted%.always(%b())") do
    for name in list:gmatch("[%w_.]+") do
      kept[name] = true
    end
  end
  return kept
end

describe("what LuaJIT compiles", function()
  it("#files are no functions that go through a table by next or pairs", function()
    local files, found = listFiles(), 0
    assert.is_true(#files > 50)
    for _, path in ipairs(files) do
      local text = read(path)
      local kept = keptIn(text)
      for name in pairs(walkersOf(text)) do
        found = found + 1
        if not kept[name] and path ~= "physics/types.lua" then
          error(path .. ": interpreted.always must keep " .. name)
        end
      end
    end
    assert.is_true(found > 15)
  end)

  -- A crowd and a heap; returns the hash after some time.
  local function play(module)
    local world = module.newWorld({ gravity = 300, rest = false })
    world:add(
      "walls",
      { x = -200, y = 200, width = 800, height = 20, static = true, friction = 0.4 }
    )
    for i = 0, 59 do
      local x, y = 17 * (i - 12 * math.floor(i / 12)), 30 * math.floor(i / 12)
      world:add(
        "boxes",
        { x = x, y = y, width = 16, height = 16, friction = 0.3, ax = 200 - 2 * x }
      )
    end
    for _ = 1, 150 do
      world:update(1 / 60)
    end
    return world:hash()
  end

  -- How many traces that begin in the file `name` of the library, or in `other`, are finished while
  -- `f` runs.
  local function tracesIn(name, f, other)
    local util, count, isIn = require("jit.util"), 0, false
    local function note(what, _, func)
      if what == "start" then
        local source = util.funcinfo(func).source or ""
        isIn = source:find(name, 1, true) ~= nil or source:find(other or name, 1, true) ~= nil
      elseif what == "stop" and isIn then
        count = count + 1
      end
    end
    name, other = "physics/" .. name .. ".lua", other and "physics/" .. other .. ".lua"
    jit.attach(note, "trace")
    f()
    jit.attach(note)
    return count
  end

  it("after compile() is everything, with the same result", function()
    local expected = play(physics)
    fresh.during(function(module)
      local hasCompiler = jit ~= nil and jit.status() == true
      assert.equal(hasCompiler, module.compile())
      assert.equal(hasCompiler, module.compile()) -- twice is no harm
      assert.equal(expected, play(module))
      if hasCompiler then
        jit.opt.start("maxtrace=1000", "maxmcode=512")
        jit.flush()
      end
    end)
  end)

  -- How often all traces were thrown away while `f` ran.
  local function flushesIn(f)
    local count = 0
    local function note(what)
      if what == "flush" then
        count = count + 1
      end
    end
    jit.flush()
    jit.attach(note, "trace")
    f()
    jit.attach(note)
    return count
  end

  -- 1000 boxes, and in every frame 500 questions of each kind.
  local function ask(module)
    local world, random, boxes = module.newWorld({ gravity = 0 }), newRandom(5), {}
    for i = 0, 999 do
      local x, y = 28 * (i % 32) + random:between(0, 8), 28 * math.floor(i / 32)
      local width, height = random:between(10, 20), random:between(10, 20)
      boxes[i + 1] = world:add("boxes", { x = x, y = y, width = width, height = height })
    end
    local out, hits = {}, {}
    for _ = 1, 4 do
      world:update(1 / 60)
      for n = 1, 500 do
        local x, y = random:between(0, 900), random:between(0, 900)
        local dx, dy = random:between(-150, 150), random:between(-150, 150)
        world:raycast(x, y, x + dx, y + dy)
        world:querySegment(x, y, x + dx, y + dy, "boxes", out)
        world:queryPoint(x, y, nil, out)
        world:queryRect(x, y, 60, 40, nil, out)
        world:queryCircle(x, y, 40, nil, out)
        world:nearest(x, y, 100)
        world:sweep(boxes[n], dx, dy)
        world:move(boxes[n], boxes[n].x + dx / 10, boxes[n].y + dy / 10, "slide", hits)
        world:overlapping(boxes[n], nil, out)
      end
    end
  end

  -- Four players run to and fro among 16 crates and jump, for 100 s.
  local function playRoom(module)
    local world, players = module.newWorld({ gravity = 800 }), {}
    for i = 0, 19 do
      local x, y = i < 16 and 16 * i or 240 * (i % 2), i < 16 and 0 or i < 18 and -16 or -32
      world:add("tiles", { x = x, y = y, width = 16, height = 16, static = true })
    end
    for i = 0, 15 do
      local x, y = 20 + 26 * (i % 8), i < 8 and -20 or -40
      world:add("crates", { x = x, y = y, width = 14, height = 14, friction = 0.3 })
    end
    for i = 1, 4 do
      players[i] = { x = 50 * i - 20, y = -100, width = 12, height = 24, friction = 0.3 }
      world:add("players", players[i])
    end
    for step = 1, 6000 do
      for i = 1, 4 do
        local isLeft = math.floor((step + 40 * i) / 90) % 2 == 1
        players[i].vx = isLeft and -60 or 60
        if (step + 20 * i) % 100 == 0 then
          players[i].vy = -200
        end
      end
      world:update(1 / 60)
    end
  end

  -- Files with loops over all objects, or over all contacts.
  local LOOPS = {}
  for _, name in ipairs({ "begin", "read", "contacts", "pairFinder", "sweep", "forces" }) do
    LOOPS[name] = true
  end
  for _, name in ipairs({ "grid", "activePairs", "move", "settle", "write", "islands", "pool" }) do
    LOOPS[name] = true
  end

  -- 150 boxes fall into a container.
  local function heap(module, friction)
    local world = module.newWorld({ gravity = 800, rest = false })
    local walls = { { -100, 0, 1000, 50 }, { -50, -900, 50, 900 }, { 800, -900, 50, 900 } }
    for _, wall in ipairs(walls) do
      local x, y, width, height = wall[1], wall[2], wall[3], wall[4]
      local object = { x = x, y = y, width = width, height = height, static = true }
      object.friction = friction
      world:add("walls", object)
    end
    for n = 0, 149 do
      local x, y = 25 * (n % 30) + n % 4, -25 * math.floor(n / 30) - 30
      local box = { x = x, y = y, width = 10 + n % 7, height = 10 + n % 5, friction = 0.3 }
      box.vx = (n % 5 - 2) * 20
      world:add("boxes", box)
    end
    for _ = 1, 200 do
      world:update(1 / 60)
    end
  end

  -- 100 walkers on a floor of tiles turn and jump.
  local function walk(module)
    local world, walkers = module.newWorld({ gravity = 800 }), {}
    for n = 0, 199 do
      world:add("tiles", { x = 16 * n, y = 0, width = 16, height = 16, static = true })
    end
    for n = 1, 100 do
      walkers[n] = world:add("walkers", { x = 30 * n, y = -24, width = 14, height = 24 })
    end
    for step = 1, 300 do
      for n = 1, 100 do
        local walker = walkers[n]
        walker.vx = math.floor((step + 7 * n) / 120) % 2 == 1 and -80 or 80
        if (step + 11 * n) % 90 == 0 then
          walker.vy = -300
        end
      end
      world:update(1 / 60)
    end
  end

  if jit and jit.status() then
    -- Of few objects each loop goes round a few times. Unrolled into whatever leads to them, they
    -- filled the room every 1000 steps. Now it is filled twice in most runs, and up to five times:
    -- which loops are compiled depends on chance.
    it("leaves room in a small world", function()
      fresh.during(function(module)
        local count = flushesIn(function()
          playRoom(module)
        end)
        assert.is_true(count <= 8, count .. " times all was thrown away")
      end)
    end)

    -- Each question goes another way through the code. Compiled as a whole they filled LuaJIT's
    -- room for traces again and again: 1000 sweeps took 180 ms instead of 15.
    it("leaves room for all kinds of questions", function()
      fresh.during(function(module)
        assert.equal(
          0,
          flushesIn(function()
            ask(module)
          end)
        )
      end)
    end)

    -- With all registers in use LuaJIT cannot go on with a way that leaves compiled code: it tries
    -- 246 times, then that way is interpreted for good. On floors without friction, after a game
    -- with friction had landed first, it was so for each box: 720 us a step instead of 350.
    it(
      "leaves no way of the loops to the interpreter after compile(), whatever came first",
      function()
        local util, texts = require("jit.util"), require("jit.vmdef").traceerr
        local tries = {}
        local function note(what, _, func, pc, reason)
          local text = what == "abort" and texts[reason]
          if text and text:find("register coalescing", 1, true) then
            local place = util.funcinfo(func, pc).loc or ""
            tries[place] = (tries[place] or 0) + 1
          end
        end
        fresh.during(function(module)
          jit.flush()
          jit.attach(note, "trace")
          module.compile()
          walk(module)
          heap(module, 0.3)
          heap(module, 0)
          jit.attach(note)
          jit.opt.start("maxtrace=1000", "maxmcode=512")
          jit.flush()
        end)
        for place, count in pairs(tries) do
          local file = place:match("^(%w+)%.lua")
          assert.is_true(not LOOPS[file] or count < 100, place .. ": " .. count)
        end
      end
    )

    it("is what happens to single objects only after compile()", function()
      fresh.during(function(module)
        jit.flush()
        local before = tracesIn("contacts/events", function()
          play(module)
        end)
        module.compile()
        local after = tracesIn("contacts/events", function()
          for _ = 1, 12 do -- which loops are compiled depends on chance
            play(module)
          end
        end, "solver/impact")
        jit.opt.start("maxtrace=1000", "maxmcode=512")
        jit.flush()
        assert.equal(0, before)
        assert.is_true(after > 0)
      end)
    end)
  end
end)
