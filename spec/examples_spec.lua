--- The examples, without a window: what they do in LÖVE's own Lua, and in that of a browser, which
--- is plain Lua 5.1 without jit, bit and ffi. How they look, and what the menu and the keys of the
--- frame around them do, is seen in scripts/examples.sh.

if _VERSION ~= "Lua 5.1" then -- LuaJIT is one, too
  return -- there is no LÖVE with any other
end

local read = require("spec.support.files").read
local effort = require("spec.support.effort")
local fakeLove = require("spec.support.fake_love")

local STEP = 1 / 60
local HIDDEN = { "jit", "bit" }

local mouse, texts, started, names, hidden, oldPath, recording

-- The callbacks of LÖVE, as LÖVE calls them.
local function call(name, ...)
  rawget(_G, "love")[name](...)
end

local function step(count)
  for _ = 1, count do
    call("update", STEP)
  end
end

local function press(key)
  call("keypressed", key, key, false)
end

local function moveMouse(x, y)
  mouse.x, mouse.y = x, y
  step(1)
end

local function click(x, y)
  moveMouse(x, y)
  call("mousepressed", x, y, 1)
end

-- What the screen's report says after a name.
local function value(name)
  local screen = started == "menu" and "menu" or "frame"
  local found = require(screen).report():match("[ :]" .. name .. "=(%S+)")
  return tonumber(found) or found
end

local function play(spans, frames)
  for frame = 1, frames do
    recording.play(spans, frame, press, click)
    call("update", STEP)
  end
end

-- What is written in a picture, as lines.
local function written()
  for i = #texts, 1, -1 do
    texts[i] = nil
  end
  call("draw")
  return table.concat(texts, "\n")
end

-- Starts an example from the menu, by its keys.
local function start(name)
  press("escape")
  for _ = 1, #names do
    if names[value("chosen")] ~= name then
      press("down")
    end
  end
  press("return")
  assert.equal(name, started)
end

-- Plays what was recorded for an example, to its end.
local function playDemo(name)
  start(name)
  local spans, length = recording.read(read("examples/demos/" .. name .. ".keys"))
  play(spans, length + 60)
end

describe("the examples", function()
  -- What cannot see `jit` cannot say what must not be compiled (CONTRIBUTING.md, jit: 8).
  effort.interpret(setup, teardown)

  setup(function()
    oldPath, hidden, names = package.path, {}, {}
    package.path = "./examples/?.lua;./?.lua;" .. package.path
    for name in read("examples/menu.lua"):gmatch('{ name = "(%a+)"') do
      names[#names + 1] = name
    end
    local say = { update = function() end }
    function say.start(name)
      started = name
    end
    package.loaded.say = say
    local love
    love, mouse, texts = fakeLove.new("examples")
    rawset(_G, "love", love)
    for _, name in ipairs(HIDDEN) do
      hidden[name] = rawget(_G, name)
      rawset(_G, name, nil)
    end
    assert(loadfile("examples/main.lua"))()
    recording = require("recording")
    love.load()
  end)

  teardown(function()
    for name, library in pairs(hidden) do
      rawset(_G, name, library)
    end
    rawset(_G, "love", nil)
    package.path, package.loaded.say = oldPath, nil
  end)

  before_each(function()
    mouse.x, mouse.y, mouse.isHeld = 0, 0, false
  end)

  it("begin with a menu, which starts each by a key or a click, and each leads back", function()
    assert.equal("menu", started)
    assert.is_true(#names >= 7)
    for _, name in ipairs(names) do
      start(name)
      for _ = 1, 3 do -- plainly, and with what the physics sees
        step(5)
        call("draw")
        press("x")
      end
      press("escape")
      assert.equal("menu", started)
    end
    moveMouse(200, 136 + 3 * 37 + 16)
    assert.equal(4, value("chosen"))
    click(200, 136 + 2 * 37 + 16)
    assert.equal(names[3], started)
  end)

  it("say what is under the mouse while the physics is visible", function()
    start("lifts")
    step(30) -- the player has landed
    for n, row in ipairs({
      { 650, 470, "belts 2, static\nx 400.00   y 460.00" },
      { 310, 530, "players 1, dynamic", "bottom: bounds bottom" },
    }) do
      moveMouse(row[1], row[2])
      if n == 1 then
        assert.is_nil(written():find(row[3], 1, true))
        press("x")
      end
      assert.is_truthy(written():find(row[3], 1, true))
      assert.is_truthy(written():find(row[4] or row[3], 1, true))
    end
    press("x")
    press("x")
    start("breakout")
    assert.is_truthy(written():find("Balls bounce without losing speed", 1, true)) -- its comment
  end)

  -- What was recorded in LÖVE comes out the same here: what the report says at the end, a text, or
  -- the least of a number.
  for name, expected in pairs({
    platformer = { won = "true", deaths = "0" }, -- at the first try
    hills = { won = "true", deaths = "0", coins = 40 },
    lifts = { coins = 1, flattened = 3 }, -- crates are pressed flat
    topdown = { coins = 20, gate = "open" }, -- by the crate
    survivors = { enemies = 380, killed = 150, gems = 100, blasts = 3 },
    tiled = { won = "true", deaths = "0", coins = 8 },
    breakout = { broken = 15, shots = 10, lost = "0" }, -- no bullet goes through a wall
    rollback = { same = 60, different = "0" },
  }) do
    it("played by what was recorded come out the same: " .. name .. " #slow", function()
      playDemo(name)
      for what, least in pairs(expected) do
        local found = value(what)
        assert.is_true(tostring(found) == least or type(least) == "number" and found >= least, what)
      end
    end)
  end
end)
