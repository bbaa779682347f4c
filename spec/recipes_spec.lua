--- Each recipe of docs/recipes.md does what it says.

local physics = require("physics")
local snippets = require("spec.support.snippets")

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
  function controls.press(key, ...)
    held[key] = true
    if game.love.keypressed then
      game.love.keypressed(key)
    end
    controls.run(...)
  end
  function controls.release(key, ...)
    held[key] = nil
    if game.love.keyreleased then
      game.love.keyreleased(key)
    end
    controls.run(...)
  end
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
  -- The height of the jump that has begun, px.
  function controls.jumpHeight(seconds)
    local from = game.player.y
    local top = from
    controls.run(seconds or 1.2, function()
      top = math.min(top, game.player.y)
    end)
    return from - top
  end
  return controls
end

local recipes = {}

recipes["Variable jump"] = function(snippet)
  local g = play(snippet)
  g.press("space")
  assert.near(100, g.jumpHeight(), 0.1)
  g.release("space")
  g.press("space", 0.1)
  g.release("space")
  assert.is_true(g.jumpHeight() < 20)
  assert.equal(368, g.player.y)
end

recipes["Double jump"] = function(snippet)
  local g = play(snippet)
  local function height(presses)
    local highest = 0
    for _ = 1, presses do
      local from = 368 - g.player.y
      g.press("space")
      highest = math.max(highest, from + g.jumpHeight(0.45))
    end
    return math.max(highest, 368 - g.player.y + g.jumpHeight(1.5))
  end
  assert.near(100, height(1), 0.5)
  local two = height(2)
  assert.is_true(two > 180)
  assert.equal(two, height(3))
  assert.equal(368, g.player.y)
  -- Off an edge only one is left.
  g.player.y = 100
  g.run(0.1)
  for _ = 1, 3 do
    g.press("space", 0.1)
  end
  assert.is_true(g.player.vy > -400 + 100)
end

recipes["Wall jump"] = function(snippet)
  local g = play(snippet)
  g.player.x, g.player.y = 70, 300
  g.press("right", 0.1)
  assert.truthy(g.player.touching.right)
  g.press("space", 0.1)
  assert.equal(-200, g.player.vx)
  assert.is_true(g.player.vy < 0 and g.player.x < 60)
  g.run(0.1) -- the keys steer again
  assert.equal(160, g.player.vx)
end

recipes["Ladders"] = function(snippet)
  local g = play(snippet)
  g.press("up", 1)
  assert.near(248, g.player.y, 2.1)
  g.release("up")
  local y = g.player.y
  g.run(1)
  assert.equal(y, g.player.y)
  g.press("down", 2)
  assert.equal(368, g.player.y)
  g.release("down")
  -- At the top it stands on the ledge, with up held, and goes down from there.
  g.press("up")
  local top = 368
  g.run(3, function()
    top = math.min(top, g.player.y)
  end)
  assert.equal(200 - 32, g.player.y)
  assert.is_true(top > 200 - 32 - 2.1) -- without a hop
  g.run(1, function()
    assert.equal(200 - 32, g.player.y)
  end)
  g.release("up")
  g.press("down", 0.5)
  assert.is_true(g.player.y > 200)
  g.run(2)
  assert.equal(368, g.player.y)
  g.release("down")
  g.player.x = 100
  g.player.y = 300
  g.run(2)
  assert.equal(368, g.player.y)
  assert.is_nil(g.player.gravity)
end

recipes["Knock-back"] = function(snippet)
  local g = play(snippet)
  g.press("right")
  local right = 0
  g.run(0.25, function()
    right = math.max(right, g.player.x)
  end)
  assert.equal(76, right)
  g.run(0.1)
  assert.equal(-200, g.player.vx)
  assert.is_true(g.player.y < 368)
end

recipes["Bullets"] = function(snippet)
  local g = play(snippet)
  local thin = { x = 700, y = 300, width = 1, height = 100, static = true }
  g.world:add("enemies", thin)
  for _ = 1, 2 do
    g.press("x", 0.2)
  end
  assert.equal(1, thin.health)
  assert.equal(0, #g.world.objects.bullets)
  assert.equal(40, g.player.x)
  -- A sensor does not stop it; what hits nothing is removed after 2 s.
  g = play(snippet)
  local water = { x = 200, y = 300, width = 50, height = 100, static = true, sensor = true }
  g.world:add("water", water)
  g.press("x", 1)
  assert.is_nil(water.health)
  assert.equal(1, #g.world.objects.bullets)
  g.run(1.1)
  assert.equal(0, #g.world.objects.bullets)
end

recipes["Doors"] = function(snippet)
  local g = play(snippet)
  g.press("e", 1)
  assert.equal(200, g.env.world.objects.doors[1].y)
  g.player.x = 96
  g.press("e")
  local lowest = 0
  g.run(1, function()
    lowest = math.max(lowest, g.world.objects.doors[1].y)
  end)
  assert.is_true(lowest > 260 and lowest < 275) -- stopped by the player's head
  assert.equal(200, g.world.objects.doors[1].y)
  assert.equal(368, g.player.y)
  g.player.x = 40
  g.run(0.1)
  g.press("e", 1)
  assert.equal(300, g.world.objects.doors[1].y)
end

recipes["Ice and conveyors"] = function(snippet)
  -- Where it comes to rest that begins at x with 200 px/s, and how far it is moved while it stands.
  local function slide(x)
    local g = play(snippet)
    g.player.x, g.player.vx = x, 200
    g.run(2)
    return g.player.x - x
  end
  assert.near(200 * 200 / 1800, slide(400), 0.5)
  assert.is_true(slide(110) > 90) -- over the ice
  local g = play(snippet)
  g.player.x = 270
  g.run(1)
  assert.near(330, g.player.x, 1e-6)
end

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

recipes["Network rollback"] = function(snippet)
  local keys = { [10] = { right = true, jump = true }, [11] = { right = true } }
  -- steps by which the input is late, 0: it comes in time
  local function playedWith(late)
    local g = play(snippet, "receive")
    local receive = g.look()
    for step = 0, 59 do
      if keys[step - late] then
        receive(step - late, keys[step - late])
      end
      g.run(DT)
    end
    return g
  end
  local inTime = playedWith(0)
  assert.is_true(inTime.player.y < 368)
  for _, late in ipairs({ 1, 7, 30 }) do
    local g = playedWith(late)
    assert.equal(inTime.player.x, g.player.x)
    assert.equal(inTime.world:hash(), g.world:hash())
  end
end

recipes["Running"] = function(snippet)
  local g = play(snippet)
  g.press("right", 0.1)
  assert.near(120, g.player.vx, 1e-9)
  g.run(0.1)
  assert.equal(160, g.player.vx)
  g.env.floor.ice = true
  g.release("right", 0.1)
  assert.near(140, g.player.vx, 1e-9)
end

recipes["Wall slide"] = function(snippet)
  local g = play(snippet)
  g.player.x, g.player.y = 60, 100
  g.press("right", 0.5)
  assert.truthy(g.player.touching.right)
  local from = g.player.y
  g.run(0.5)
  assert.near(from + 30, g.player.y, 1e-6)
  g.release("right", 0.2)
  assert.near(60 + 0.2 * 800, g.player.vy, 1)
end

recipes["Dash"] = function(snippet)
  local g = play(snippet)
  local enemy = { x = 100, y = 360, width = 40, height = 40, pushable = false }
  g.world:add("enemies", enemy)
  g.run(0.1)
  g.press("x", 0.2)
  assert.is_true(g.player.x > 100 and g.player.x < 140) -- it ends inside the enemy
  g.press("right", 0.1)
  assert.same({ 100, 360, 368 }, { enemy.x, enemy.y, g.player.y })
  assert.truthy(g.player.mask)
  g.run(0.5)
  assert.is_nil(g.player.mask)
  assert.is_nil(g.player.gravity)
  assert.is_true(g.player.x > 140)
end

recipes["Crouch"] = function(snippet)
  local g = play(snippet)
  g.press("down", 0.5, function()
    assert.truthy(g.player.touching.bottom)
  end)
  assert.same({ 382, 18 }, { g.player.y, g.player.height })
  local low = { x = 0, y = 350, width = 100, height = 30, static = true }
  g.world:add("tiles", low)
  g.release("down", 0.5)
  assert.equal(18, g.player.height) -- there is no room
  g.world:remove(low)
  g.run(DT)
  assert.same({ 368, 32 }, { g.player.y, g.player.height })
  assert.truthy(g.player.touching.bottom)
end

recipes["A path for a lift"] = function(snippet)
  local g = play(snippet)
  local lift = g.world.objects.lifts[1]
  g.player.y = 330
  g.run(0.2)
  local along = g.player.x - lift.x
  local seen, highest = {}, 400
  g.run(9, function()
    assert.equal(lift, g.player.touching.bottom)
    assert.near(lift.y - 32, g.player.y, 1e-9)
    seen[("%.0f %.0f"):format(lift.x, lift.y)] = true
    highest = math.min(highest, lift.y)
  end)
  for _, corner in ipairs({ "30 370", "230 370", "230 220", "30 220" }) do
    assert.is_true(seen[corner], corner)
  end
  assert.equal(220, highest)
  assert.near(lift.x + along, g.player.x, 1e-9) -- it rides without slipping
end

recipes["Springs"] = function(snippet)
  local g = play(snippet)
  g.player.x, g.player.y = 100, 300
  local top = 400
  g.run(3, function()
    top = math.min(top, g.player.vy < 0 and g.player.y or top)
  end)
  assert.near(384 - 32 - 225, top, 0.1)
end

recipes["Crumbling floor"] = function(snippet)
  local g = play(snippet)
  local tile = g.world.objects.crumbling[1]
  g.player.y = 268
  g.run(0.4)
  assert.equal(268, g.player.y)
  g.run(0.3)
  assert.is_false(tile.active)
  assert.is_true(g.player.y > 268)
  g.player.y = 290 -- in its place: it waits
  g.player.gravity = 0
  g.player.vy = 0
  g.run(4)
  assert.is_false(tile.active)
  g.player.y = 200
  g.run(0.1)
  assert.is_true(tile.active)
  g.player.gravity = nil
  g.run(0.5)
  assert.equal(268, g.player.y)
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

recipes["Sword"] = function(snippet)
  local g = play(snippet)
  local enemy = g.world:add("enemies", { x = 74, y = 368, width = 24, height = 32, mass = 2 })
  local far = g.world:add("enemies", { x = 200, y = 368, width = 24, height = 32 })
  g.run(0.1)
  assert.is_nil(enemy.health)
  g.press("x", 0.3)
  assert.equal(2, enemy.health) -- once
  assert.is_true(enemy.x > 74)
  assert.is_nil(far.health)
  enemy.x, enemy.vx = 74, 0
  g.press("x", 0.3)
  assert.equal(1, enemy.health)
end

recipes["Sokoban"] = function(snippet)
  local g = play(snippet)
  local first, second = g.world.objects.crates[1], g.world.objects.crates[2]
  local function places()
    return ("%d %d %d"):format(g.player.x / 32, first.x / 32, second.x / 32)
  end
  -- the key, the columns of player and crates then
  for _, row in ipairs({
    { "left", "2 1 5" }, -- pushes a crate to the wall
    { "left", "2 1 5" },
    { "right", "3 1 5" },
    { "right", "4 1 5" },
    { "right", "5 1 6" },
    { "right", "5 1 6" },
  }) do
    g.press(row[1])
    g.release(row[1])
    assert.equal(row[2], places())
  end
end

recipes["Portals"] = function(snippet)
  local g = play(snippet)
  g.press("right", 1.1)
  assert.is_true(g.player.x > 600 and g.player.x < 650)
  assert.near(150, g.player.vx, 1e-9)
  g.run(1)
  assert.equal(368, g.player.y)
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

recipes["Checkpoints"] = function(snippet)
  local g = play(snippet)
  g.press("s")
  g.player.x, g.player.health, g.player.coins = 300, 1, 7
  g.run(0.1)
  g.press("l")
  assert.same({ 40, 3, 0 }, { g.player.x, g.player.health, g.player.coins })
end

recipes["Chunks"] = function(snippet)
  local g = play(snippet, "chunks, changes, dig, updateChunks")
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
end

describe("the recipe", function()
  local loveBefore

  before_each(function()
    loveBefore = rawget(_G, "love")
    rawset(_G, "love", snippets.newLove({}))
    physics.load()
  end)

  after_each(function()
    rawset(_G, "love", loveBefore)
  end)

  local seen = {}
  for title, last in RECIPES:gmatch("\n## ([^\n]+)\n()") do
    local body = RECIPES:sub(last, RECIPES:find("\n## ", last, true))
    for snippet in body:gmatch("```lua\n(.-)\n```") do
      it(title .. " works", function()
        assert.is_function(recipes[title], "nothing says what it should do")
        recipes[title](snippet)
      end)
      seen[title] = true
    end
  end

  it("is there for all that is looked at here, and in the list on top", function()
    for title in pairs(recipes) do
      assert.is_true(seen[title], title)
      local anchor = title:lower():gsub(" ", "-")
      assert.truthy(RECIPES:gsub("\n", " "):find("[" .. title .. "](#" .. anchor .. ")", 1, true))
    end
  end)
end)
