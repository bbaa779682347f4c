-- The command line, and playing an example without a player, for tests and pictures:
--
--   love examples --example=platformer --frames=300 --shot=/tmp/shot.png
--                 --keys="right:10-200,space:40-60,return:70,click@480x300:90"
--
-- `--example` alone starts there, to be played by hand; `--say` says what goes on (main.lua).
-- `--bare` leaves the panel at the side away; `--width=700` does so, too, and draws 700 px of an
-- example with a camera; `--touch` leaves the bar with the keys away. With any of the others the
-- script plays: every frame lasts exactly 1/60 s, so that a run can be repeated. At the end the
-- picture is written, the example's report is printed, and LÖVE quits with 0; an error quits with
-- 1. `--film=FOLDER` writes a picture 15 times a second, 0001.png and on.

local recording = require("recording")
local say = require("say")
local view = require("view")

local STEP = 1 / 60
local STEPS_PER_PICTURE = 10 -- drawing takes longest: not every frame is drawn
local STEPS_PER_FILM_PICTURE = 4

---@type table
local script = { isOn = false, frame = 0, frames = 60, keys = {} }

local BY_HAND = { example = true, width = true } -- options that leave the game to a player

local OPTIONS = {
  example = function(value)
    script.example = value
  end,
  width = function(value)
    local width = tonumber(value) or error("--width: expected a number, got " .. value)
    view.gameWidth = math.floor(width)
    view.width = view.gameWidth
  end,
  frames = function(value)
    script.frames = tonumber(value) or error("--frames: expected a number, got " .. value)
  end,
  shot = function(value)
    script.shot = value
  end,
  film = function(value)
    script.film = value
  end,
  keys = function(value)
    script.keys = recording.read(value)
  end,
}

--- Reads the command line. Without an option the examples are played by hand, from the menu on.
function script.read(arguments)
  for _, argument in ipairs(arguments) do
    local name, value = argument:match("^%-%-(%w+)=(.*)$")
    if argument == "--say" then
      say.isOn = true
    elseif argument == "--bare" then
      view.width = view.gameWidth
    elseif argument == "--touch" then
      view.hasKeys = false
    elseif name then
      script.isOn = script.isOn or not BY_HAND[name]
      local set = OPTIONS[name] or error("unknown option " .. argument)
      set(value)
    end
  end
end

--- Returns the words of the command line that are no options, of which the first one names an
--- example: `love examples online host`.
function script.readWords(arguments)
  local words = {}
  for _, argument in ipairs(arguments) do
    if argument:find("^[%w.:*][%w.:*%-]*$") and (words[1] or argument:find("^%l+$")) then
      words[#words + 1] = argument
    end
  end
  if script.example then
    return script.example, words[1], words[2]
  end
  return words[1], words[2], words[3]
end

-- How many colours a picture has, from a grid of samples: an empty one would be no proof.
local function countColors(image)
  local seen, count = {}, 0
  for y = 0, image:getHeight() - 1, 3 do
    for x = 0, image:getWidth() - 1, 3 do
      local red, green, blue = image:getPixel(x, y)
      local color = ("%.2f %.2f %.2f"):format(red, green, blue)
      if not seen[color] then
        seen[color], count = true, count + 1
      end
    end
  end
  return count
end

local function write(image, path)
  local file = assert(io.open(path, "wb"))
  file:write(image:encode("png"):getString())
  file:close()
end

local function finish(report)
  love.graphics.captureScreenshot(function(image)
    print(report .. " colors=" .. countColors(image))
    if script.shot then
      write(image, script.shot)
    end
    love.event.quit(0)
  end)
end

local function film(number)
  love.graphics.captureScreenshot(function(image)
    write(image, ("%s/%04d.png"):format(script.film, number))
  end)
end

--- Runs some frames of the script. `update(dt)` advances the example, `report()` returns a line
--- that says how far it got.
function script.update(update, report)
  if script.frame >= script.frames then
    return -- the picture is taken at the end of this frame
  end
  local steps = script.film and STEPS_PER_FILM_PICTURE or STEPS_PER_PICTURE
  local last = math.min(script.frame + steps, script.frames)
  while script.frame < last do
    script.frame = script.frame + 1
    recording.play(script.keys, script.frame, love.keypressed, love.mousepressed)
    update(STEP)
  end
  if script.film then
    film(math.ceil(last / steps))
  end
  if last == script.frames then
    finish(report())
  end
end

return script
