--- Platformers: the game that docs/platformers.md builds in seven steps does what the page says.

local snippets = require("spec.support.snippets")

local wait = snippets.wait

describe("docs/platformers.md: its game", function()
  snippets.steps("docs/platformers.md", "platformer", 1)

  it("jumps, stomps, rides the lift and dies in the spikes as it says", function()
    local game, player, world = snippets.start("platformer", 7)
    local top
    local function jump()
      top = player.y
      game.keypressed("space")
      wait(game, 60, function()
        top = math.min(top, player.y)
      end)
    end
    wait(game, 60)
    local ground, enemy = player.y, world.objects.enemies[1]
    jump()
    assert.near(ground - 113, top, 0.5)
    player.x, player.y, player.vy = enemy.x, enemy.y - 80, 0
    repeat
      game.update(1 / 60)
    until player.vy < 0
    assert.equal(0, #world.objects.enemies)
    local y = player.y
    jump() -- not from an enemy: only the stomp lifts it
    assert.near(y - 300 * 300 / (2 * 1200), top, 0.5)
    local lift = world.objects.lifts[1]
    player.x, player.y = lift.x + 30, lift.y - 40
    wait(game, 60)
    assert.equal(lift, player.touching.bottom)
    player.x, player.y = 13.5 * 32, 180
    wait(game, 60)
    assert.equal(32, player.x)
  end)
end)
