--- Top-down games: the game that docs/topdown.md builds in seven steps does what the page says.

local snippets = require("spec.support.snippets")

local wait = snippets.wait

describe("docs/topdown.md: its game", function()
  snippets.steps("docs/topdown.md", "topdown", 0)

  it("walks at its speed, shoots, goes through the door, takes gems", function()
    local game, player, world, held = snippets.start("topdown", 7)
    held.right, held.down = true, true
    wait(game, 1)
    assert.near(160, math.sqrt(player.vx * player.vx + player.vy * player.vy), 1e-9)
    held.down = nil
    wait(game, 1) -- it looks to the right
    held.right = nil
    for _, enemy in ipairs(world.objects.enemies) do
      enemy.active = false
    end
    world.objects.crates[1].active = false
    local enemy = world.objects.enemies[1]
    enemy.active, enemy.x, enemy.y = true, player.x + 100, player.y
    for _ = 1, 3 do
      game.keypressed("space")
      wait(game, 20)
    end
    assert.same({ 9, 0 }, { #world.objects.enemies, #world.objects.bullets })
    wait(game, 120)
    assert.equal(0, #world.objects.gems)
    player.x, player.y, held.right = 260, 256, true -- the door is at 260
    wait(game, 60)
    assert.is_true(player.x > 324)
  end)
end)
