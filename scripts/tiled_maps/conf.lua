function love.conf(t)
  t.identity = "physics-tiled-maps"
  t.modules.window, t.modules.graphics = false, false
  t.modules.audio, t.modules.sound, t.modules.joystick = false, false, false
end

function love.errorhandler(message)
  io.stderr:write(debug.traceback(tostring(message), 2), "\n")
  os.exit(1)
end
