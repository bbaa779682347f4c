-- LÖVE reads this before it opens the window.

-- LÖVE shows errors on a blue screen and waits for a key that is never pressed here.
function love.errorhandler(message)
  io.stderr:write(debug.traceback(tostring(message), 2), "\n")
  os.exit(1)
end

function love.conf(t)
  t.identity = "physics-lua-pictures"
  t.version = "11.4"
  t.window.width, t.window.height = 720, 300
  t.window.vsync = 0
  t.modules.physics, t.modules.audio, t.modules.sound = false, false, false
  t.modules.joystick, t.modules.touch, t.modules.video = false, false, false
end
