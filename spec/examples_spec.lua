--- The examples, without a window: what they do in LÖVE's own Lua, and in that of a browser, which
--- is plain Lua 5.1 without jit, bit and ffi. How they look is seen in scripts/examples.sh.

if _VERSION ~= "Lua 5.1" then -- LuaJIT is one, too
  return -- there is no LÖVE with any other
end

local effort = require("spec.support.effort")
local fakeLove = require("spec.support.fake_love")

local STEP = 1 / 60
local HIDDEN = { "jit", "bit" }

local mouse, texts, started, names, hidden, oldPath, recording

local function read(path)
  local file = assert(io.open(path, "rb"))
  local text = file:read("*a")
  file:close()
  return text
end

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

  describe("the menu", function()
    before_each(function()
      press("escape")
    end)

    it("is what one sees first", function()
      assert.equal("menu", started)
      assert.equal(1, value("chosen"))
    end)

    it("starts every example, and each leads back", function()
      assert.is_true(#names >= 7)
      for _, name in ipairs(names) do
        start(name)
        step(5)
        call("draw")
        press("escape")
        assert.equal("menu", started)
      end
    end)

    it("obeys the mouse: over an entry it is chosen, a click starts it", function()
      moveMouse(200, 136 + 3 * 37 + 16)
      assert.equal(4, value("chosen"))
      click(200, 136 + 2 * 37 + 16)
      assert.equal(names[3], started)
    end)

    it("starts the chosen one by a click on its picture", function()
      press("down")
      local chosen = names[value("chosen")]
      click(800, 300)
      assert.equal(chosen, started)
    end)
  end)

  describe("the frame", function()
    -- The buttons of the panel, by number from the top.
    local function clickButton(i)
      click(1080, 438 + (i - 1) * 33 + 10)
    end

    -- How far the player of the platformer runs in some frames.
    local function run(frames)
      local before = value("x")
      play(recording.read("right:1-" .. frames), frames)
      return value("x") - before
    end

    before_each(function()
      start("platformer")
    end)

    it("pauses, by key and by mouse", function()
      assert.is_true(run(20) > 30)
      press("p")
      assert.equal(0, run(20))
      press("p")
      assert.is_true(run(20) > 30)
      clickButton(1)
      assert.equal(0, run(20))
    end)

    it("makes single steps, the first of which pauses", function()
      run(30)
      press("n")
      local x = value("x")
      recording.play(recording.read("right:1"), 1, press, click)
      press("n")
      assert.is_true(value("x") > x and value("x") < x + 10)
    end)

    it("is five times as slow in slow motion", function()
      run(30) -- full speed
      local distance = run(15)
      press("m")
      local slow = run(15)
      press("m")
      assert.is_true(math.abs(distance - 5 * slow) < 8)
    end)

    it("draws what the physics sees, in every example", function()
      for _, name in ipairs(names) do
        start(name)
        for _ = 1, 3 do
          press("x")
          step(2)
          call("draw")
        end
      end
    end)

    it("says what is under the mouse while the physics is visible", function()
      start("lifts")
      step(30) -- the player has landed
      moveMouse(650, 470)
      assert.is_nil(written():find("belts 2, static", 1, true))
      press("x")
      assert.is_truthy(written():find("belts 2, static\nx 400.00   y 460.00", 1, true))
      moveMouse(310, 530)
      assert.is_truthy(written():find("players 1, dynamic", 1, true))
      assert.is_truthy(written():find("bottom: bounds bottom", 1, true))
      moveMouse(600, 60)
      assert.is_nil(written():find("dynamic", 1, true))
      press("x")
      press("x")
    end)

    it("shows the comment of the source, and the keys", function()
      start("breakout")
      local found = written()
      assert.is_truthy(found:find("Balls bounce without losing speed", 1, true))
      assert.is_truthy(found:find("shoot", 1, true))
      assert.is_truthy(found:find("slow motion", 1, true))
    end)
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

  it("marbles roll down, and the lift brings them up #slow", function()
    start("marbles")
    play(recording.read(""), 2400)
    assert.equal(24, value("marbles"))
    assert.equal(24, value("inside"))
    assert.is_true(value("laps") >= 10)
    assert.is_true(value("bumps") >= 20)
    press("up")
    click(300, 60)
    assert.equal(26, value("marbles"))
    press("down")
    press("space")
    play(recording.read(""), 600)
    assert.equal(25, value("inside"))
  end)
end)
