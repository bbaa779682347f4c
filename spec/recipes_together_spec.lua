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
