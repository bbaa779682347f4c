--- Sprites: where `world:interpolate` puts them, and the functions of docs/guide/sprites.md.

local physics = require("physics")
local small = require("spec.support.small")
local snippets = require("spec.support.snippets")

-- A step of 0.25 s: what moves at 40 px/s is 10 px further after it, and 20 px higher at -80.
describe("world:interpolate", function()
  local NOW = { 0.25 }
  local HALF, LATER = { 0.25, 0.125 }, { 0.25, 0.125, 0.25 }
  local STILL = { kinematic = true, vx = 0, vy = 0 }
  -- what: fields; updates; fields that are written then; more updates; where it is drawn
  small.rows("is {1}", {
    { "the last place after a step", {}, NOW, {}, {}, 0, 0 },
    { "between the last and the present place", {}, HALF, {}, {}, 5, -10 },
    { "at the next step again between", {}, LATER, {}, {}, 15, -30 },
    { "that of what is kinematic, too", { kinematic = true }, HALF, {}, {}, 5, -10 },
    { "x, y of what is static", { static = true }, HALF, {}, {}, 0, 0 },
    { "x, y of what is new", {}, {}, {}, {}, 0, 0 },
    { "x, y of what is not active", {}, NOW, { active = false }, { 0.25 }, 10, -20 },
    { "where the game has put it", {}, HALF, { x = 300, y = 100 }, {}, 300, 100 },
    { "from there on", {}, HALF, { x = 300, y = 100 }, { 0.25 }, 305, 90 },
    { "on the way to where it was put, kinematic", STILL, HALF, { x = 16 }, { 0.25 }, 8, 0 },
    { "at last there", STILL, HALF, { x = 16 }, { 0.25, 0.25 }, 16, 0 },
  }, function(_, fields, before, written, after, x, y)
    local world = physics.newWorld({ gravity = 0, timestep = 0.25 })
    local object = small.set(small.put(0, 0, 8, 8, { vx = 40, vy = -80 }), fields)
    world:add("boxes", object)
    for _, dt in ipairs(before) do
      world:update(dt)
    end
    small.set(object, written)
    for _, dt in ipairs(after) do
      world:update(dt)
    end
    assert.same({ x, y }, { world:interpolate(object) })
  end)

  it("is x, y of what is in no world", function()
    local world = physics.newWorld({ timestep = 0.25 })
    assert.same({ 3, 4 }, { world:interpolate({ x = 3, y = 4, width = 1, height = 1 }) })
  end)

  it("keeps a rider on its lift", function()
    local world = physics.newWorld({ gravity = 640, timestep = 0.03125 })
    local lift = { x = 0, y = 100, width = 40, height = 8, kinematic = true, vx = 70, vy = -50 }
    world:add("lifts", lift)
    local rider = world:add("boxes", { x = 10, y = 84, width = 16, height = 16 })
    for i = 1, 60 do
      world:update(0.01 + i % 3 * 0.004)
      local _, liftY = world:interpolate(lift)
      local _, riderY = world:interpolate(rider)
      assert.is_true(math.abs(riderY + 16 - liftY) < 1e-9, ("frame %d"):format(i))
    end
  end)
end)

-- The functions of the page, which it prints once each.
describe("x, y and touching: a sprite of docs/guide/sprites.md", function()
  local game, look

  before_each(function()
    local code = {}
    for block in snippets.read("docs/guide/sprites.md"):gmatch("\n```lua\n(.-)\n```\n") do
      code[#code + 1] = block
    end
    game = snippets.newEnvironment({}, {})
    local text = code[1] .. "\n" .. code[2] .. "\nreturn function(way)\n  facing = way or facing\n"
    look = snippets.compile(text .. "  return place, stateOf\nend", "=sprites", game)()
  end)

  it("stands with its feet in the middle, in whole pixels, and looks both ways", function()
    for _, row in ipairs({
      -- x, y, width, height, which way; where it is drawn
      { 40, 368, 24, 32, 1, 52, 400 },
      { 40.4, 368.4, 24, 32, 1, 52, 400 },
      { 40.5, 367.6, 24, 32, -1, 53, 400 },
      { -10.25, 0, 7, 9.25, -1, -7, 9 },
    }) do
      local object = { x = row[1], y = row[2], width = row[3], height = row[4] }
      assert.same({ row[6], row[7], 0, row[5], 1, 16, 32 }, { look(row[5])(object) })
    end
  end)

  it("stands, runs, jumps and falls", function()
    local _, stateOf = look()
    local player, seen = game.player, {}
    for n, write in ipairs({ { 0, 0 }, { 60, 0 }, { 60, -300 } }) do
      player.vx, player.vy = write[1], write[2]
      game.world:update(1 / 60)
      seen[n] = stateOf(player)
    end
    small.run(game.world, 24)
    seen[4] = stateOf(player)
    assert.same({ "stand", "run", "jump", "fall" }, seen)
  end)
end)
