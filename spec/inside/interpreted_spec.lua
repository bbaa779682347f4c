--- What LuaJIT compiles (physics/memory/compiler.lua): nearly everything, but never what goes
--- through a table by `next` or `pairs`.

local files = require("spec.support.files")
local fresh = require("spec.support.fresh")

local jit = rawget(_G, "jit")

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
    local paths, found = files.list("find physics -name '*.lua'"), 0
    assert.is_true(#paths > 50)
    for _, path in ipairs(paths) do
      local text = files.read(path)
      local left = text:match("%.leave(%b())\n") or ""
      for name in pairs(walkersOf(text)) do
        found = found + 1
        local isLeft = left:find("[^%w_]" .. name .. "[^%w_]")
        assert(isLeft or path == "physics/types.lua", path .. ": leave(" .. name .. ")")
      end
    end
    assert.is_true(found > 15)
  end)

  -- Four players run to and fro among 16 crates and jump, for 100 s, and look around.
  local function playRoom(module)
    local world, players, out = module.newWorld({ gravity = 800 }), {}, {}
    world:add("tiles", { x = 0, y = 0, width = 256, height = 16, static = true })
    world:add("tiles", { x = 0, y = -48, width = 16, height = 48, static = true })
    world:add("tiles", { x = 240, y = -48, width = 16, height = 48, static = true })
    for i = 0, 15 do
      local x, y = 20 + 26 * (i % 8), i < 8 and -20 or -40
      world:add("crates", { x = x, y = y, width = 14, height = 14, friction = 0.3 })
    end
    for i = 1, 4 do
      players[i] = { x = 50 * i - 20, y = -100, width = 12, height = 24, friction = 0.3 }
      world:add("players", players[i])
    end
    for step = 1, 6000 do
      for i, player in ipairs(players) do
        local isLeft = math.floor((step + 40 * i) / 90) % 2 == 1
        player.vx = isLeft and -60 or 60
        if (step + 20 * i) % 100 == 0 then
          player.vy = -200
        end
        world:raycast(player.x, player.y, player.x + step % 300 - 150, 8)
        world:queryRect(player.x - 20, player.y, 60, 40, nil, out)
        world:queryCircle(player.x, player.y, 40, "crates", out)
        world:nearest(player.x, player.y, 100)
        world:sweep(player, step % 70 - 35, 20)
      end
      world:update(1 / 60)
    end
  end

  if jit and jit.status() then
    it("leaves room for a small world and its questions: no trace is thrown away", function()
      local count = 0
      local function note(what)
        count = count + (what == "flush" and 1 or 0)
      end
      fresh.during(function(module)
        jit.flush()
        jit.attach(note, "trace")
        playRoom(module)
        jit.attach(note)
      end)
      assert.equal(0, count)
    end)
  end
end)
