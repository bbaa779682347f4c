--- Recipes of docs/recipes.md in one game, as a player of a whole level meets them: on slopes, on
--- stairs, on what moves, and with each other.
--
-- A game has one loop. So `join` calls the `love.update` of all its recipes, and the world goes on
-- once, in the last of them: what follows `world:update` in a recipe needs the last place. One of
-- them may write `player.vx`, that called `runs`; from the others such a line is left out, as it
-- would be in a game.

local snippets = require("spec.support.snippets")

local RECIPES = snippets.read("docs/recipes.md")
local RATES = { 30, 60, 144 }

local function snippetOf(title)
  local first = assert(select(2, RECIPES:find("\n## " .. title .. "\n", 1, true)), title)
  local from, last = RECIPES:find("```lua\n", first, true)
  return RECIPES:sub(last + 1, RECIPES:find("\n```", from + 1, true))
end

-- The calls of all recipes at a key.
local function callAll(list, key)
  for _, call in ipairs(list) do
    call(key)
  end
end

local function nothing() end

-- Puts recipes together. Returns a game: `player`, `world`, `press(key)`, `release(key)`,
-- `run(seconds, each)` at `rate` Hz, which may follow a key at once: `press(key, seconds, each)`.
local function join(rate, titles, runs)
  local held = {}
  local env = snippets.newEnvironment({}, held)
  local updates, pressed, released = {}, {}, {}
  for n, title in ipairs(titles) do
    local text = snippetOf(title)
    if runs and title ~= runs then
      text = text:gsub("\n +player%.vx = [^\n]*", "")
    end
    env.love.update, env.love.keypressed, env.love.keyreleased = nil, nil, nil
    snippets.compile(text, "=" .. title, env)()
    updates[n] = env.love.update
    pressed[#pressed + 1] = env.love.keypressed
    released[#released + 1] = env.love.keyreleased
  end
  local game = { env = env, player = env.player, world = env.world }
  function game.press(key, ...)
    held[key] = true
    callAll(pressed, key)
    game.run(...)
  end
  function game.release(key, ...)
    held[key] = nil
    callAll(released, key)
    game.run(...)
  end
  function game.run(seconds, each)
    for _ = 1, math.floor((seconds or 0) * rate + 0.5) do
      rawset(game.world, "update", nothing)
      for n = 1, #updates do
        if n == #updates then
          rawset(game.world, "update", nil)
        end
        updates[n](1 / rate)
      end
      if each then
        each()
      end
    end
  end
  return game
end

-- Adds a hill: up from x = 150 to 214, flat to 374, down to 438; 32 px high.
local function addHill(world)
  world:add("tiles", { x = 150, y = 368, width = 64, height = 32, static = true, slope = "right" })
  world:add("tiles", { x = 214, y = 368, width = 160, height = 32, static = true })
  world:add("tiles", { x = 374, y = 368, width = 64, height = 32, static = true, slope = "left" })
end

local function standsIn(game)
  return function()
    assert.truthy(game.player.touching.bottom)
  end
end

local TOGETHER = {}

TOGETHER["Running and Crouch: over a hill, under a low ceiling, always on the ground"] = function(
  rate
)
  local game = join(rate, { "Running", "Crouch" })
  addHill(game.world)
  game.world:add("tiles", { x = 250, y = 300, width = 80, height = 48, static = true })
  game.press("right", 0.95, standsIn(game))
  assert.is_true(game.player.y < 368) -- on the slope
  game.press("down", 0.05, standsIn(game))
  game.release("down", 0.05, standsIn(game))
  assert.equal(32, game.player.height)
  game.press("down", 0.6, standsIn(game))
  game.release("down", 0.1, standsIn(game))
  assert.equal(18, game.player.height) -- under the ceiling
  game.run(1.5, standsIn(game))
  assert.equal(32, game.player.height)
  assert.equal(368, game.player.y)
  assert.is_true(game.player.x > 438)
end

TOGETHER["Stairs and Crouch: up and down, always on the ground"] = function(rate)
  local game = join(rate, { "Crouch", "Stairs" })
  local top = 400
  game.press("down")
  game.press("right", 3, function()
    standsIn(game)()
    top = math.min(top, game.player.y + game.player.height)
  end)
  assert.equal(370, top)
  assert.equal(382, game.player.y)
  game.release("down", 0.1, standsIn(game))
  assert.equal(368, game.player.y)
end

TOGETHER["Stairs and Dash: up, over the top, and back on the ground"] = function(rate)
  local game = join(rate, { "Stairs", "Dash" }, "Dash")
  game.press("right", 0.2)
  local from = game.player.x
  game.press("x", 0.12)
  assert.near(72, game.player.x - from, 20.1) -- a dash lasts whole updates
  assert.equal(370, game.player.y + game.player.height)
  game.run(0.1)
  assert.truthy(game.player.touching.bottom)
  game.run(1.5, standsIn(game))
  assert.equal(368, game.player.y)
end

TOGETHER["Dash and a slope: it goes up, and stays on the ground"] = function(rate)
  local game = join(rate, { "Dash" })
  addHill(game.world)
  game.player.x = 110
  game.press("right")
  game.press("x", 0.2)
  assert.truthy(game.player.touching.bottom)
  assert.is_true(game.player.x > 170 and game.player.y < 348)
  game.run(1.6, standsIn(game))
  assert.equal(368, game.player.y)
end

TOGETHER["Jumping off a lift and a slope: as high from a slope that rises"] = function(rate)
  local game = join(rate, { "Jumping off a lift" })
  game.world:add("lifts", {
    x = 300,
    y = 360,
    width = 100,
    height = 40,
    kinematic = true,
    slope = "right",
    vx = 30,
    vy = -60,
  })
  game.player.x, game.player.y = 330, 368 - 23
  game.run(0.3)
  assert.equal("right", game.player.touching.bottom.slope)
  local from, top = game.player.y, game.player.y
  game.press("space", 0.9, function()
    top = math.min(top, game.player.y)
  end)
  assert.near(100, from - top, 0.6)
end

TOGETHER["Falling through ledges and Carry and throw: up and down with a crate"] = function(rate)
  local game = join(rate, { "Falling through ledges", "Carry and throw" })
  game.run(0.1)
  game.press("x", 0.1)
  assert.equal(48, game.player.height)
  game.press("space")
  game.release("space", 1.5)
  assert.equal(300, game.player.y + game.player.height) -- on the ledge
  game.press("down")
  game.press("space", 1)
  assert.equal(400, game.player.y + game.player.height)
  game.press("x", 2)
  local crate = game.world.objects.crates[1]
  assert.equal(32, game.player.height)
  assert.equal(384, crate.y)
  assert.is_true(crate.x > 100)
end

TOGETHER["Portals and Carry and throw: the crate comes along"] = function(rate)
  local game = join(rate, { "Portals", "Carry and throw" })
  game.run(0.1)
  game.press("x")
  game.press("right", 1.2)
  game.release("right", 1)
  local crate = game.world.objects.crates[1]
  assert.is_true(game.player.x >= 600)
  assert.equal(400, game.player.y + game.player.height)
  assert.equal(game.player.y, crate.y)
  game.press("x", 2)
  assert.is_true(crate.x > game.player.x + 24)
end

TOGETHER["Variable jump and Springs: letting go of the key does not cut the spring"] = function(
  rate
)
  local game = join(rate, { "Variable jump", "Springs" })
  game.player.x = 60
  game.press("space")
  local top = 400
  game.run(2, function()
    game.player.vx = game.player.x < 98 and 60 or 0
    if game.player.y < 300 then
      game.release("space")
    end
    top = math.min(top, game.player.y)
  end)
  assert.near(384 - 32 - 225, top, 0.12) -- the apex is between two updates
end

TOGETHER["Coyote time and Springs: a key in the air is no second jump"] = function(rate)
  local game = join(rate, { "Springs", "Coyote time" })
  game.player.x, game.player.y = 100, 300
  local top, wasPressed = 400, false
  game.run(2, function()
    if game.player.vy < -500 and not wasPressed then
      game.press("space")
      wasPressed = true
    end
    top = math.min(top, game.player.y)
  end)
  assert.is_true(wasPressed)
  assert.near(384 - 32 - 225, top, 0.12) -- the apex is between two updates
end

TOGETHER["Wall slide and Wall jump: slow down the wall, then away from it"] = function(rate)
  local game = join(rate, { "Wall slide", "Wall jump" }, "Wall jump")
  game.player.x, game.player.y = 70, 100
  game.press("right", 1)
  assert.near(60, game.player.vy, 1e-9)
  local from, top = game.player.y, game.player.y
  game.press("space", 0.1)
  assert.is_true(game.player.x < 76 - 15)
  game.run(0.5, function()
    top = math.min(top, game.player.y)
  end)
  assert.near(100, from - top, 1e-6)
end

TOGETHER["Checkpoints and Crumbling floor: it is whole again, and crumbles again"] = function(rate)
  local game = join(rate, { "Checkpoints", "Crumbling floor" })
  game.world.ownFields = { "health", "coins", "left" }
  local tile = game.world.objects.crumbling[1]
  game.player.x, game.player.y = 40, 200
  game.press("s")
  for _ = 1, 2 do
    game.run(0.45)
    assert.equal(268, game.player.y)
    assert.truthy(tile.left)
    game.run(1)
    assert.is_false(tile.active)
    game.press("l")
    assert.equal(200, game.player.y)
    assert.is_nil(tile.left)
    assert.is_true(tile.active ~= false)
  end
end

TOGETHER["Wrap-around and Crouch: the rider stays on the lift"] = function(rate)
  local game = join(rate, { "Crouch", "Wrap-around" })
  game.player.x, game.player.y = 660, 268
  game.press("down", 0.1)
  game.run(3, standsIn(game))
  assert.is_true(game.player.x < 400)
  game.release("down", 0.5, standsIn(game))
  assert.equal(300 - 32, game.player.y)
end

TOGETHER["Trains and Crouch: no slip, and no step in the air"] = function(rate)
  local game = join(rate, { "Crouch", "Trains" })
  game.player.x, game.player.y = 80, 376 - 32
  game.run(0.1)
  local train = game.world.objects.trains[1]
  local place = game.player.x - train.x
  for _ = 1, 3 do
    game.press("down", 0.2, standsIn(game))
    game.release("down", 0.2, standsIn(game))
  end
  assert.near(place, game.player.x - train.x, 1e-6)
end

TOGETHER["Enemies and slopes: it walks over a hill, and turns at edges"] = function(rate)
  local game = join(rate, { "Enemies" })
  addHill(game.world)
  game.world:add("tiles", { x = 0, y = 336, width = 16, height = 64, static = true })
  local enemy = game.world:add("enemies", {
    x = 100,
    y = 384,
    width = 16,
    height = 16,
    direction = 1,
  })
  game.player.x, game.player.y = 700, 368
  local first = game.world.objects.enemies[1]
  local least, most = 800, 0
  game.run(8, function()
    assert.truthy(enemy.touching.bottom)
    least, most = math.min(least, first.x), math.max(most, first.x)
  end)
  assert.is_true(enemy.x > 438)
  assert.is_true(least > 190 and most < 320) -- the one of the recipe, on its ledge
end

TOGETHER["A boss that pushes and a slope: up to the wall, and it hurts once a second"] = function(
  rate
)
  local game = join(rate, { "A boss that pushes" })
  game.world:add(
    "tiles",
    { x = 0, y = 384, width = 80, height = 16, static = true, slope = "left" }
  )
  game.player.x, game.player.y = 100, 368
  game.run(7)
  assert.is_true(game.player.health < 3)
  assert.near(0, game.player.x, 1e-6)
  assert.near(384 - 32, game.player.y, 1e-6)
end

describe("recipes together:", function()
  local loveBefore

  before_each(function()
    loveBefore = rawget(_G, "love")
    rawset(_G, "love", snippets.newLove({}))
  end)

  after_each(function()
    rawset(_G, "love", loveBefore)
  end)

  for title, play in pairs(TOGETHER) do
    it(title, function()
      for _, rate in ipairs(RATES) do
        play(rate)
      end
    end)
  end
end)
