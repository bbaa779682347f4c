--- Keys, gamepad and touch: the code of docs/guide/input.md makes one direction and one jump of it.

local small = require("spec.support.small")
local snippets = require("spec.support.snippets")

local CODE = snippets.read("docs/guide/input.md"):match("\n```lua\n(.-)\n```\n")

describe("vx and vy: by the devices of docs/guide/input.md", function()
  local held, game, player, stick

  before_each(function()
    held, stick = {}, 0
    game = snippets.newEnvironment({}, held)
    player = game.player
    snippets.compile(CODE, "=input", game)()
    local pad = {}
    function pad.isGamepad()
      return true
    end
    function pad.getGamepadAxis(_, axis)
      return axis == "leftx" and stick
    end
    game.love.joystickadded(pad)
  end)

  small.rows("it walks: keys [{1}], stick {2}", {
    -- keys that are held, the stick; vx
    { "", 0, 0 },
    { "right", 0, 200 },
    { "left", 0, -200 },
    { "left right", 0, 0 },
    { "", 0.5, 100 },
    { "", -1, -200 },
    { "", 0.19, 0 }, -- the dead zone
    { "right", -0.5, -100 },
    { "left", 0.19, -200 },
  }, function(keys, axis, vx)
    for key in keys:gmatch("%a+") do
      held[key] = true
    end
    stick = axis
    game.love.update(1 / 60)
    assert.equal(vx, player.vx)
  end)

  for _, row in ipairs({
    -- the callback, what is pressed; whether it jumps
    { "keypressed", { "space" }, true },
    { "keypressed", { "x" }, false },
    { "gamepadpressed", { nil, "a" }, true },
    { "gamepadpressed", { nil, "b" }, false },
    { "touchpressed", { nil, 700 }, true },
    { "touchpressed", { nil, 100 }, false },
  }) do
    local name = row[1] .. " " .. tostring(row[2][2] or row[2][1])
    it((row[3] and "it jumps: " or "it stays: ") .. name, function()
      local y = player.y
      game.love[row[1]](row[2][1], row[2][2])
      game.love.update(1 / 60)
      assert.equal(row[3], player.y < y)
      game.love[row[1]](row[2][1], row[2][2]) -- in the air: that is forgotten
      for _ = 1, 90 do
        game.love.update(1 / 60)
      end
      assert.equal(y, player.y)
    end)
  end
end)
