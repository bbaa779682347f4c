-- Without a window: the game is played, not seen.
function love.conf(t)
  t.identity = "physics-lua-online"
  for _, name in ipairs({ "audio", "graphics", "joystick", "sound", "video", "window" }) do
    t.modules[name] = false
  end
  t.modules.image, t.modules.font, t.modules.touch, t.modules.physics = false, false, false, false
end
