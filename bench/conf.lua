-- LÖVE reads this first: no window, nothing that needs a display or a sound card.

function love.errorhandler(message)
  io.stderr:write(debug.traceback(tostring(message), 2), "\n")
  os.exit(1)
end

function love.conf(t)
  t.identity = "physics-lua-bench"
  t.version = "11.4"
  for _, name in ipairs({ "audio", "graphics", "joystick", "sound", "touch", "video", "window" }) do
    t.modules[name] = false
  end
  t.modules.physics = true -- the peer to measure against
end
