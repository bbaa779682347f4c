-- The same scenes in several engines, side by side, with a number below each:
--
--   love examples/compare                   physics.lua, love.physics and a plain loop
--   love examples/compare --path FOLDER     and bump.lua, which lies in FOLDER
--   love examples/compare --measure         prints the table of docs/compare.md
--   love examples/compare --record FOLDER   writes every fourth frame there as a PNG, and ends
--
-- The keys left and right change the scene, space starts it again.

-- The library and bench/ lie above this folder.
package.path = love.filesystem.getSource() .. "/../../?.lua;" .. package.path

local plays ---@type table
local scenes = require("scenes")

local DT = 1 / 60 -- s
local HOLD = 0.8 -- s, for which the end of a scene is shown
local SHOWN = 4 -- s of a scene that are recorded, at most
local COLORS = {
  static = { 0.34, 0.42, 0.53 },
  kinematic = { 0.25, 0.65, 0.96 },
  dynamic = { 0.94, 0.49, 0.34 },
}
local GOOD, BAD = { 0.22, 0.72, 0.39 }, { 1, 0.8, 0.46 }
local WIDTH, HEIGHT, TOP = 480, 230, 68 -- px: of a scene; where the pictures begin

local fonts = {}
local found, current, chosen, time = {}, {}, 1, 0.0
local folder, frames = nil, 0

local function start()
  current, time = {}, 0.0
  for i, each in ipairs(found) do
    current[i] = plays.new(scenes.list[chosen], each)
  end
end

function love.load(arguments)
  for i, argument in ipairs(arguments) do
    if argument == "--path" then
      package.path = arguments[i + 1] .. "/?.lua;" .. package.path
    end
  end
  plays = require("plays")
  for i, argument in ipairs(arguments) do
    if argument == "--measure" then
      io.write(plays.table(scenes.list))
      love.event.quit()
    elseif argument == "--record" then
      folder = arguments[i + 1]
    end
  end
  for _, size in ipairs({ 14, 22, 30 }) do
    fonts[size] = love.graphics.newFont(size)
  end
  found = plays.engines()
  love.graphics.setBackgroundColor(0.10, 0.11, 0.17)
  start()
end

local function choose(by)
  chosen = (chosen - 1 + by) % #scenes.list + 1
  start()
end

function love.keypressed(key)
  if key == "right" then
    choose(1)
  elseif key == "left" then
    choose(-1)
  elseif key == "space" then
    start()
  elseif key == "escape" then
    love.event.quit()
  end
end

local function length()
  local seconds = scenes.list[chosen].seconds
  return folder and math.min(seconds, SHOWN) or seconds
end

function love.update()
  time = time + DT
  if time < length() then
    for _, play in ipairs(current) do
      plays.step(play, DT)
    end
  elseif time > length() + HOLD then
    if folder and chosen == 5 then
      love.event.quit()
    end
    choose(1)
  end
end

local function write(text, x, y, size)
  love.graphics.setFont(fonts[size])
  love.graphics.print(text, x, y)
end

local function kindOf(object)
  return object.static and "static" or object.kinematic and "kinematic" or "dynamic"
end

local function drawPlay(play, i, width)
  local scale = width / WIDTH
  love.graphics.push()
  love.graphics.translate((i - 1) * (width + 8), TOP)
  love.graphics.setScissor((i - 1) * (width + 8), TOP, width, HEIGHT * scale)
  love.graphics.scale(scale)
  love.graphics.setColor(0.15, 0.17, 0.25)
  love.graphics.rectangle("fill", 0, 0, WIDTH, HEIGHT)
  for n, object in ipairs(play.scene.objects) do
    local x, y = play.world:read(n)
    love.graphics.setColor(COLORS[kindOf(object)])
    love.graphics.rectangle("fill", x, y, object.width - 1, object.height - 1)
  end
  love.graphics.setScissor()
  love.graphics.pop()
  love.graphics.push()
  love.graphics.translate((i - 1) * (width + 8), TOP + HEIGHT * scale)
  love.graphics.setColor(1, 1, 1)
  write(found[i].title, 6, 8, 14)
  if not play.scene.rates and play.frame > 2 then
    local number = play.scene.number(play)
    local isGood = number == 0 or number == "stopped"
    love.graphics.setColor(isGood and GOOD or BAD)
    write(play.scene.isTimed and ("%.2f ms"):format(number) or plays.show(number), 6, 26, 30)
  end
  love.graphics.pop()
end

function love.draw()
  local width = (love.graphics.getWidth() - 8 * (#found - 1)) / #found
  local scene = scenes.list[chosen]
  love.graphics.setColor(1, 1, 1)
  write(scene.title, 6, 8, 22)
  love.graphics.setColor(0.6, 0.66, 0.75)
  write(scene.unit, 6, 40, 14)
  for i, play in ipairs(current) do
    drawPlay(play, i, width)
  end
  frames = frames + 1
  if folder and frames % 4 == 0 then
    local path = ("%s/%04d.png"):format(folder, frames / 4)
    love.graphics.captureScreenshot(function(image)
      local file = assert(io.open(path, "wb"))
      file:write(image:encode("png"):getString())
      file:close()
    end)
  end
end
