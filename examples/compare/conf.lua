-- LÖVE reads this before it opens the window.

function love.conf(t)
  t.identity = "physics-lua-compare"
  t.version = "11.4"
  t.window.title = "physics.lua beside others"
  t.window.width, t.window.height = 960, 270
  t.modules.audio = false
  t.modules.sound = false
  t.modules.joystick = false
end
