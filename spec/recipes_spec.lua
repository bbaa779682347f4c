--- Each recipe of docs/recipes.md does what it says, played by keys as in a game.

local kit = require("spec.support.kit")
local physics = require("physics")
local snippets = require("spec.support.snippets")
local states = require("spec.support.states")

local RECIPES = snippets.read("docs/recipes.md")
local DT = 1 / 60

--- A recipe at work: its environment, keys to press, and time to pass, which may follow a key at
--- once: `press(key, seconds, each)`.
local function play(snippet, peek)
  local held = {}
  local game = snippets.newEnvironment({}, held)
  local text = snippet .. "\n" .. (peek and "return function() return " .. peek .. " end" or "")
  local look = snippets.compile(text, "=recipe", game)()
  local controls = { look = look, env = game, player = game.player, world = game.world }
  local function turn(isHeld, callback)
    return function(key, ...)
      held[key] = isHeld or nil
      if game.love[callback] then
        game.love[callback](key)
      end
      controls.run(...)
    end
  end
  controls.press, controls.release = turn(true, "keypressed"), turn(false, "keyreleased")
  function controls.run(seconds, each)
    for _ = 1, math.floor((seconds or 0) / DT + 0.5) do
      if game.love.update then
        game.love.update(DT)
      else
        game.world:update(DT)
      end
      if each then
        each()
      end
    end
  end
  return controls
end

-- Rows ------------------------------------------------------------------------------------------

-- A row: what is done to the keys, "+right -space"; for how many seconds; what is expected then;
-- fields of the player that are written before, and of the floor. What is expected: fields of the
-- player, the sides that it touches, `least` and `far`, its least y and largest x since the keys,
-- `rise`, how far it rose, and by the name of a group, `boxes` or `boxes2`, fields of its first or
-- second object, or NIL: there is none. A number is exact, a list of two numbers holds it between
-- them, NIL stands for nil. Last: a group, and what is added to it before, or taken out.
local check, NIL = kit.check, kit.NIL

local function playRow(game, row, what)
  local player = game.player
  for name, value in pairs(row[4] or {}) do
    if name == "floor" then
      game.env.floor.ice = value.ice
    elseif value == NIL then
      player[name] = nil
    else
      player[name] = value
    end
  end
  if row[5] then
    local name, object = row[5][1], row[5][2]
    if object then
      game.world:add(name, object)
    else
      game.world:remove(game.world.objects[name][1])
    end
  end
  local seen = { least = player.y, far = player.x }
  local from = player.y
  for sign, key in row[1]:gmatch("([+-])(%a+)") do
    game[sign == "+" and "press" or "release"](key)
  end
  game.run(row[2], function()
    seen.least, seen.far = math.min(seen.least, player.y), math.max(seen.far, player.x)
  end)
  seen.rise = from - seen.least
  for name, value in pairs(player.touching) do
    seen[name] = value
  end
  for name, expected in pairs(row[3] or {}) do
    local group, n = name:match("^(%a+)(%d*)$")
    group = game.world.objects[group]
    local its = group and group[tonumber(n) or 1]
    if group and expected == NIL then
      check(NIL, its, what .. name)
    elseif group then
      for field, value in pairs(expected) do
        check(value, its[field], what .. name .. "." .. field)
      end
    else
      local found = seen[name]
      check(expected, found == nil and player[name] or found, what .. name)
    end
  end
end

local rows = {}

rows["Knock-back"] = {
  { "+right", 0.25, { far = 76 } },
  { "", 0.1, { vx = -200, y = { 0, 368 } } },
}
rows["Running"] = {
  { "+right", 0.1, { vx = 120 } },
  { "", 0.1, { vx = 160 } },
  { "-right", 0.1, { vx = 40 } },
  { "", 0.1, { vx = 140 }, { vx = 160, floor = { ice = true } } },
}
rows["Springs"] = { { "", 3, { least = { 126.9, 127.1 } }, { x = 100, y = 300 } } }
rows["Doors"] = {
  { "+e", 1, { doors = { y = 200 } } },
  { "-e +e", 1, { doors = { y = 200 }, y = 368 }, { x = 96 } }, -- stopped by its head
  { "", 0.1, nil, { x = 40 } },
  { "-e +e", 1, { doors = { y = 300 } } },
}
rows["Portals"] = { { "+right", 1.1, { x = { 600, 650 }, vx = 150 } }, { "", 1, { y = 368 } } }
rows["Checkpoints"] = {
  { "+s", 0 },
  { "", 0.1, nil, { x = 300, health = 1, coins = 7 } },
  { "+l", 0, { x = 40, health = 3, coins = 0 } },
}
rows["Ice and conveyors"] = {
  { "", 2, { x = { 200, 204 } }, { x = 110, vx = 200 } }, -- over the ice, to its end
  { "", 1, { x = 330, crates = { x = { 425, 435 }, vx = { 59, 61 } } }, { x = 270 } },
  { "+right", 0.1, { x = 351 } },
}
rows["Launching"] = {
  { "", 1, { balls = { y = 368 } } },
  { "+space", 0.81, { balls = { y = { 100, 106 } }, plungers = { y = 384 } } }, -- 225 px
}
rows["Chutes"] = {
  { "", 0.1, nil, { x = 700 } },
  { "", 0.4, { crates = { x = { 125, 150 }, y = { 296, 330 } } } },
  { "", 0.5, { crates = { x = { 170, 190 } } } },
}
rows["Pits and pockets"] = {
  { "", 0.45, { balls = { x = 290 } } }, -- its rim is over it from 284 on, its centre from 292
  { "", 0.02, { balls = NIL } },
}
rows["A paddle"] = { { "", 0.5, { paddles = { x = 376, y = 276 } }, { x = 700 } } }
rows["Pause and slow motion"] = {
  { "+p", 0.5, { y = 268 }, { y = 268 } },
  { "-p +p +x", 0.4, { y = 268 + 0.5 * 800 * 0.1 ^ 2 } },
}

local foe, far =
  { x = 74, y = 368, width = 24, height = 32 }, { x = 200, y = 368, width = 9, height = 9 }
rows["Sword"] = {
  { "", 0, nil, nil, { "enemies", foe } },
  { "", 0.1, { enemies = { health = NIL } }, nil, { "enemies", far } },
  { "+x", 0.3, { enemies = { health = 2, x = { 74, 200 } }, enemies2 = { health = NIL } } }, -- once
}
rows["Sokoban"] = {
  { "+left -left", 0, { x = 64, crates = { x = 32 } } }, -- pushes a crate to the wall
  { "+left -left", 0, { x = 64, crates = { x = 32 } } },
  { "+right -right", 0, { x = 96 } },
  { "+right -right", 0, { x = 128, crates2 = { x = 160 } } },
  { "+right -right", 0, { x = 160, crates2 = { x = 192 } } },
  { "+right -right", 0, { x = 160, crates2 = { x = 192 } } },
}

-- What is more than keys and the player ----------------------------------------------------------

local recipes = {}

recipes["Trains"] = function(snippet)
  local g = play(snippet)
  local train = g.world.objects.trains[1]
  g.player.x, g.player.y = 100, 300
  g.run(0.5)
  assert.equal(train, g.player.touching.bottom)
  for _, key in ipairs({ "space", "right" }) do
    local along = g.player.x - train.x
    g.press(key) -- a jump, and one with the key held
    g.press("space", 1.1)
    g.release("right")
    assert.equal(train, g.player.touching.bottom)
    local walked = key == "right" and 1.1 * 150 or 0
    assert.near(along + walked, g.player.x - train.x, 6)
  end
end

recipes["Camera"] = function(snippet)
  local g = play(snippet, "cameraX")
  local translated
  g.env.love.graphics.translate = function(x)
    translated = x
  end
  g.player.gravity, g.player.x = 0, 1500
  g.run(2)
  assert.near(1512 - 400, g.look(), 0.1)
  g.env.love.draw()
  assert.equal(-math.floor(g.look()), translated)
  local drawn = 0
  function g.env.love.graphics.rectangle()
    drawn = drawn + 1
  end
  g.world:add("boxes", { x = 0, y = 300, width = 8, height = 8, static = true }) -- out of view
  g.env.love.draw()
  assert.equal(1, drawn) -- the player; the floor ends at 800, out of view
  g.player.x = 2990
  g.run(2)
  assert.near(2200, g.look(), 0.1)
end

recipes["Carry and throw"] = function(snippet)
  local g = play(snippet, "held")
  local crate = g.world.objects.crates[1]
  g.press("x", 0.1)
  assert.equal(crate, g.look())
  assert.is_false(crate.active)
  assert.same({ 352, 48 }, { g.player.y, g.player.height })
  assert.truthy(g.player.touching.bottom)
  g.player.x = 300
  g.run(0.1)
  assert.same({ 304, 352 }, { crate.x, crate.y })
  -- On a lift it comes along in the same step.
  g.world:add("lifts", { x = 290, y = 400, width = 60, height = 8, kinematic = true, vy = -90 })
  g.run(1, function()
    assert.same({ g.player.x + 4, g.player.y }, { crate.x, crate.y })
  end)
  g.world:remove(g.world.objects.lifts[1])
  g.run(0.5)
  g.press("x")
  assert.equal(32, g.player.height)
  g.run(1.5)
  assert.is_nil(g.look())
  assert.equal(384, crate.y)
  assert.is_true(crate.x > 380)
  assert.same({ 300, 368 }, { g.player.x, g.player.y })
  -- There is no room to lift it.
  local low = play(snippet, "held")
  low.world:add("tiles", { x = 0, y = 356, width = 200, height = 8, static = true })
  low.press("x", 0.1)
  assert.is_nil(low.look())
  assert.same({ true, 32 }, { low.world.objects.crates[1].active, low.player.height })
end

recipes["A fixed step"] = function(snippet)
  for _, dt in ipairs({ 1 / 30, 1 / 60, 1 / 144, 0.013 }) do
    local g = play(snippet)
    local update, frames = g.env.love.update, math.floor(1 / dt + 0.5)
    g.press("right")
    for _ = 1, frames do
      update(dt)
      assert.is_true(g.world.alpha >= 0 and g.world.alpha < 1)
      local x = g.world:interpolate(g.player)
      assert.is_true(x <= g.player.x and x >= g.player.x - 150 / 60 - 1e-9)
    end
    local steps = math.floor(frames * dt * 60 + 1e-6)
    assert.near(40 + 2.5 * steps, g.player.x, 2.5 + 1e-9)
  end
end

recipes["Chunks"] = function(snippet)
  local g = play(snippet, "chunks, changes, dig, newChunk")
  g.world:remove(g.env.floor)
  g.player.y, g.player.gravity, g.player.x = 0, 0, 8000
  local function measure()
    local count = 0
    for _ in pairs((g.look())) do
      count = count + 1
    end
    return count
  end
  g.run(1)
  assert.equal(3, measure())
  local _, changes, dig = g.look()
  local objects = #g.world.objects.earth
  assert.is_true(objects > 3)
  local hit = g.world:raycast(8000, 300, 8000, 900)
  assert.equal(1, hit.tile.value)
  dig(8000, hit.y + 1)
  assert.truthy(next(changes))
  local deeper = select(3, g.world:raycast(8000, 300, 8000, 900))
  assert.equal(hit.y + 16, deeper)
  g.player.vx = 3000
  g.run(3)
  assert.equal(3, measure())
  assert.is_true(#g.world.objects.earth < 2 * objects)
  g.player.vx = -3000
  g.run(3)
  g.player.vx = 0
  g.run(0.5)
  assert.equal(3, measure())
  assert.equal(deeper, (select(3, g.world:raycast(8000, 300, 8000, 900)))) -- it is still dug
  local chunks, _, _, newChunk = g.look()
  dig(20000, deeper - 15)
  dig(-900, deeper + 1)
  dig(-900, -900)
  g.player.vx = -3000
  g.run(0.3)
  local text, hash = states.write(g.world:save()), g.world:hash()
  g.env.world = physics.newWorld()
  for index in pairs(chunks) do
    chunks[index] = newChunk(index)
  end
  g.env.world:restore(states.read(text))
  g.env.player = g.env.world.objects.players[1]
  assert.equal(hash, g.env.world:hash())
  g.env.player.x, g.env.player.vx = 20000, 0
  g.run(0.5)
  local _, y = select(2, g.env.world:raycast(20008, 300, 20008, 900))
  assert.equal(deeper, y)
  dig(20000, y + 1)
  assert.equal(deeper + 16, (select(3, g.env.world:raycast(20008, 300, 20008, 900))))
end

recipes["Scale and resolution"] = function(snippet)
  local view, mouseInWorld = play(snippet, "view, mouseInWorld").look()
  assert.same({ 2, 80, 120 }, { view() }) -- 320 × 180 in 800 × 600
  assert.same({ 160, 90 }, { mouseInWorld() })
end

describe("docs/recipes.md:", function()
  snippets.keepLove(before_each, after_each)
  before_each(function()
    rawset(_G, "love", snippets.newLove({}))
  end)

  local seen = {}
  for title, last in RECIPES:gmatch("\n## ([^\n]+)\n()") do
    local body = RECIPES:sub(last, RECIPES:find("\n## ", last, true))
    for snippet in body:gmatch("```lua\n(.-)\n```") do
      it(title .. " works", function()
        assert(recipes[title] or rows[title], "nothing says what it should do")
        if recipes[title] then
          return recipes[title](snippet)
        end
        local game = play(snippet)
        for n, row in ipairs(rows[title]) do
          playRow(game, row, ("row %d: "):format(n))
        end
      end)
      seen[title] = true
    end
  end

  it("is there for all that is looked at here, and in the list on top", function()
    for title in pairs(rows) do
      recipes[title] = rows[title]
    end
    for title in pairs(recipes) do
      assert.is_true(seen[title], title)
      local anchor = title:lower():gsub(" ", "-")
      assert.truthy(RECIPES:gsub("\n", " "):find("[" .. title .. "](#" .. anchor .. ")", 1, true))
    end
  end)
end)
