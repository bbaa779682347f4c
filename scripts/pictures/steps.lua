--- Plays a program of docs/steps/ with scripted keys, for its picture.

local DT = 1 / 60
local SHOTS = { 100, 112, 124, 136, 148, 160, 172, 184, 196 }
-- Of each page: how many frames, and which keys are held or pressed when.
local SCRIPTS = {
  platformer = { frames = 118, right = { 20, 200 }, space = { 52, 100 } },
  topdown = { frames = 158, down = { 10, 72 }, right = { 60, 150 }, space = SHOTS },
}
-- Steps that play otherwise.
local OTHERS = {
  platformer1 = { frames = 30 },
  platformer2 = { frames = 80, right = { 20, 200 }, space = { 52 } },
  platformer3 = { frames = 72, right = { 20, 200 }, space = { 52 } },
  platformer4 = { frames = 72, right = { 20, 200 }, space = { 52 } },
  topdown3 = { frames = 90, right = { 10, 90 } },
  topdown6 = { frames = 190, down = { 10, 72 }, right = { 60, 150 }, space = SHOTS },
  topdown7 = { frames = 200, down = { 10, 72 }, right = { 60, 150 }, space = SHOTS },
}

local steps = {}

--- Plays the program until the frame of its picture. Returns what draws it.
function steps.play(name)
  local script, held = OTHERS[name] or SCRIPTS[name:match("^%a+")], {}
  love.keypressed = nil
  love.keyboard.isDown = function(key)
    return held[key] or false
  end
  assert(loadfile(("%s/../../docs/steps/%s.lua"):format(love.filesystem.getSource(), name)))()
  love.load()
  for frame = 1, script.frames do
    for _, key in ipairs({ "right", "down" }) do
      local span = script[key]
      held[key] = span and frame >= span[1] and frame <= span[2]
    end
    for _, at in ipairs(script.space or {}) do
      if at == frame and love.keypressed then
        love.keypressed("space")
      end
    end
    love.update(DT)
  end
  love.draw() -- a background that it sets is that of the next frame
  love.graphics.origin()
  return love.draw
end

return steps
