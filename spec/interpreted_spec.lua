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

  -- How many traces that begin in the library's file `name` are finished while `f` runs.
  local function tracesIn(name, f)
    local util, count, isIn = require("jit.util"), 0, false
    local function note(what, _, func)
      if what == "start" then
        local source = util.funcinfo(func).source or ""
        isIn = source:find("physics/" .. name .. ".lua", 1, true) ~= nil
      elseif what == "stop" and isIn then
        count = count + 1
      end
    end
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

  if jit and jit.status() then
    -- Of few objects each loop goes round a few times. Unrolled into whatever leads to them, they
    -- filled the room every 1000 steps.
    it("leaves room in a small world", function()
      fresh.during(function(module)
        local count = flushesIn(function()
          playRoom(module)
        end)
        assert.is_true(count <= 3, count .. " times all was thrown away")
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

    it("is what happens to single objects only after compile()", function()
      fresh.during(function(module)
        jit.flush()
        local before = tracesIn("meet", function()
          play(module)
        end)
        module.compile()
        local after = tracesIn("meet", function()
          play(module)
        end)
        jit.opt.start("maxtrace=1000", "maxmcode=512")
        jit.flush()
        assert.equal(0, before)
        assert.is_true(after > 0)
      end)
    end)
  end
end)
