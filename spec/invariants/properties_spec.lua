--- What changes no bit of a game, tried on random ones (spec/fuzz/case.lua). Failures name a seed.

local case = require("spec.fuzz.case")
local effort = require("spec.support.effort")
local physics = require("physics")
local player = require("spec.fuzz.player")
local small = require("spec.support.small")

effort.interpret(setup, teardown)

-- Plays a game in a world that keeps these settings. Returns all that was told, and each hash.
local function trackOf(seed, settings)
  local game = case.new(seed, 40)
  local one = player.new(game, settings)
  for _, act in ipairs(game.acts) do
    one:act(act)
    if act[1] == "update" then
      one:tell("hash", one.world:hash())
    end
  end
  return one.told
end

local tracks = {}
small.rows("broadphase, rest and order: the same game goes the same way, to the bit, {1}", {
  { "in the grid", { broadphase = "grid" } },
  { "in the automatic broad phase", {} },
  { "in the grid, nothing skipped", { broadphase = "grid", rest = false } },
  { "in cells of 8 px", { broadphase = "grid", cellSize = 8 } },
  { "in cells of 37.5 px", { broadphase = "grid", cellSize = 37.5 } },
  { "in cells of 1000 px", { broadphase = "grid", cellSize = 1000 } },
  { "where others have been before", { guests = true } },
}, function(_, settings)
  for seed = 1, effort.share(30, 6) do
    tracks[seed] = tracks[seed] or trackOf(seed, { broadphase = "pairs", rest = false })
    assert.same(tracks[seed], trackOf(seed, settings), "seed " .. seed)
  end
end)

it("width: denormal ones tell thin boxes at the same place apart", function()
  local world = physics.newWorld({ gravity = 100 })
  local thin = world:add("a", { x = 1e-310, y = 0, width = 1e-7, height = 10 })
  world:add("a", { x = 0, y = 0, width = 10, height = 10 })
  world:update(1 / 60)
  assert.is_true(thin.y > 0)
end)
