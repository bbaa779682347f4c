--- Runs the snippets of the pages: a world to play in, and a LÖVE that does nothing by itself.

local ldtk = require("spec.support.ldtk")
local physics = require("physics")
local small = require("spec.support.small")
local states = require("spec.support.states")

local snippets = {}

-- The network of LÖVE, without another player.
package.preload.enet = function()
  local function nothing() end
  local host = { service = nothing, flush = nothing }
  function host.connect()
    return { timeout = nothing }
  end
  return {
    host_create = function()
      return host
    end,
  }
end

snippets.read = require("spec.support.files").read

--- Compiles a text with an environment of its own.
function snippets.compile(text, name, environment)
  local setEnvironment = rawget(_G, "setfenv")
  if setEnvironment then
    return setEnvironment(assert(rawget(_G, "loadstring")(text, name)), environment)
  end
  return assert(load(text, name, "t", environment))
end

--- Stands in for LÖVE: `held[key]` says which keys are down, drawing does nothing, and files come
--- from spec/, where the maps are.
function snippets.newLove(held)
  local function always(a, b, c, d)
    return function()
      return a, b, c, d
    end
  end
  local size = always(800)
  local font = { getWidth = size, getHeight = size }
  local graphics = { getWidth = size, getDimensions = always(800, 600), newFont = always(font) }
  graphics.newCanvas = always({ setFilter = size })
  local love = { graphics = setmetatable(graphics, { __index = always(always(1, 1, 1, 1)) }) }
  local written = {} -- by name, what was written into the save folder
  love.keyboard, love.filesystem = {}, { getInfo = always({}) }
  love.mouse = { getPosition = always(400, 300) }
  function love.keyboard.isDown(key)
    return held[key] or false
  end
  function love.filesystem.load(path)
    return loadfile("spec/" .. path)
  end
  function love.filesystem.read(path)
    local text = written[path] or assert(path == "maps/cave.ldtk" and "its text")
    return text, #text
  end
  function love.filesystem.write(path, text)
    written[path] = text
    return true
  end
  return love
end

local function show(value)
  return type(value) == "number" and ("%.14g"):format(value) or tostring(value)
end

--- What the snippets find: a world at rest with a floor and a player, and a `print` that fills a
--- list.
function snippets.newEnvironment(printed, held)
  local world = physics.newWorld({ gravity = 800 })
  local box = { x = 0, y = 400, width = 800, height = 40, static = true }
  local environment = {
    love = snippets.newLove(held),
    physics = physics,
    world = world,
    floor = world:add("tiles", box),
    player = world:add("players", { x = 40, y = 368, width = 24, height = 32 }),
  }
  function environment.print(...)
    local texts = { ... }
    for i = 1, select("#", ...) do
      texts[i] = show((select(i, ...)))
    end
    printed[#printed + 1] = table.concat(texts, " ")
  end
  -- As dkjson: its second argument is where the value begins.
  local function decode(_, first)
    if (first or 1) > 1 then
      return nil, first, "no valid JSON value at line 1, column " .. first
    end
    return ldtk.cave()
  end
  local libraries = {
    binser = { serialize = states.write, deserializeN = states.read },
    dkjson = { decode = decode },
  }
  function environment.require(name)
    local path = name:find("^kit%.") and "examples." .. name or name
    return libraries[name] or require(path)
  end
  world:update(1 / 60)
  return setmetatable(environment, { __index = _G })
end

--- Runs a snippet; its `love` is the global one from then on. `extra`: more names that it finds.
--- Returns its environment, what its `-->` comments say that it prints, and what it printed.
function snippets.run(snippet, extra)
  local printed, said = {}, {}
  local environment = snippets.newEnvironment(printed, { right = true })
  small.set(environment, extra)
  rawset(_G, "love", environment.love)
  snippets.compile(snippet, "=snippet", environment)()
  for line in snippet:gmatch("%-%-> ([^\n]*)") do
    said[#said + 1] = line
  end
  environment.world:update(1 / 60)
  return environment, said, printed
end

--- After each spec of a block `love` is what it was before, and the default world is empty.
function snippets.keepLove(beforeEach, afterEach)
  local before
  beforeEach(function()
    before = rawget(_G, "love")
    physics.load()
  end)
  afterEach(function()
    rawset(_G, "love", before)
    physics.load()
  end)
end

--- Starts a step of a page, docs/steps/`name`1.lua to 7. Returns its `love`, its locals `player`
--- and `world`, and the keys that are held.
function snippets.start(name, step)
  local held = {}
  local text = snippets.read("docs/steps/" .. name .. step .. ".lua")
  local environment = snippets.newEnvironment({}, held)
  rawset(_G, "love", environment.love)
  text = text .. "\nreturn function() return player, world end"
  local look = snippets.compile(text, "=step", environment)()
  environment.love.load()
  local player, world = look()
  return environment.love, player, world, held
end

--- Plays a step for a second, with the key "right". Returns whether the player has walked.
function snippets.walks(name, step)
  local game, player, _, held = snippets.start(name, step)
  local x = player.x
  held.right = true
  for _ = 1, 60 do
    game.update(1 / 60)
    game.draw()
  end
  return player.x > x + 40
end

--- Makes `count` steps of a game, and calls `each` after each.
function snippets.wait(game, count, each)
  for _ = 1, count do
    game.update(1 / 60)
    if each then
      each()
    end
  end
end

--- Rows for the seven steps of a page, docs/steps/`name`1.lua to 7: each plays, and the page links
--- it. In the first `standing` ones the player does not walk. After each row of the `describe`
--- around them `love` is what it was.
function snippets.steps(page, name, standing)
  -- busted gives its words to spec files, not to what they require
  local words = rawget(_G, "it") and _G or require("busted")
  snippets.keepLove(words.before_each, words.after_each)
  for step = 1, 7 do
    words.it("step " .. step .. " plays, and the page links it", function()
      assert(snippets.walks(name, step) == (step > standing))
      local link = "](steps/" .. name .. step .. ".lua)"
      assert(snippets.read(page):find(link, 1, true))
    end)
  end
end

return snippets
