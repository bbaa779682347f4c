--- What LuaJIT compiles (physics/memory/compiler.lua): nearly everything, but never what goes
--- through a table by `next` or `pairs`.

local compiler = require("physics.memory.compiler")
local fresh = require("spec.support.fresh")
local newRandom = require("spec.support.random").new

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

describe("what LuaJIT compiles", function()
  it("#files are no functions that go through a table by next or pairs", function()
    local files, found = listFiles(), 0
    assert.is_true(#files > 50)
    for _, path in ipairs(files) do
      local row = compiler.rows[1][path:gsub("^physics/", ""):gsub("%.lua$", ""):gsub("/", ".")]
        or ""
      local text = read(path)
      for name in pairs(walkersOf(text)) do
        found = found + 1
        local isKept = (" " .. row .. " "):find(" " .. name:match("%w+$") .. " ", 1, true)
        local isOff = isKept or text:find("jit.off(" .. name .. ")", 1, true)
        assert(isOff or path == "physics/types.lua", path .. ": compiler.lua must name " .. name)
      end
    end
    assert.is_true(found > 15)
  end)

  if rawget(_G, "debug") and debug.getupvalue then
    it("#files leaves out the functions that are named, which are all there", function()
      for _, rows in ipairs(compiler.rows) do
        for module, names in pairs(rows) do
          local _, missing = compiler.find(require("physics." .. module), names)
          assert(not missing, ("physics.%s has no function %s"):format(module, tostring(missing)))
        end
      end
    end)
  end

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

  if jit and jit.status() then
    for name, play in pairs({
      ["in a small world"] = playRoom,
      ["for all kinds of questions"] = ask,
    }) do
      it("leaves room " .. name, function()
        fresh.during(function(module)
          assert.equal(
            0,
            flushesIn(function()
              play(module)
            end)
          )
        end)
      end)
    end
  end
end)
