--- Proves that games at random keep every promise after every update, in three worlds that agree
--- (spec/fuzz/checks.lua lists what), and that these checks notice what is broken on purpose. A
--- short part: `make fuzz SECONDS=600` plays more.

local case = require("spec.fuzz.case")
local checks = require("spec.fuzz.checks")
local crowded = require("spec.fuzz.crowded")
local effort = require("spec.support.effort")
local games = require("spec.fuzz.games")
local motion = require("spec.support.motion")
local overlap = require("spec.support.overlap")
local physics = require("physics")
local player = require("spec.fuzz.player")
local small = require("spec.support.small")
local states = require("spec.support.states")
local trial = require("spec.fuzz.trial")
local watcher = require("spec.fuzz.watcher")

local put = small.put

local function reread(one)
  return states.read(states.write(one))
end

-- Returns how many steps a case has, of which none fails.
local function passes(seed, one)
  local failure, steps = trial.run(one)
  assert(not failure, failure and ("seed %d: %s: %s"):format(seed, failure.check, failure.text))
  return steps
end

describe("broadphase, cellSize, rest and order: random games", function()
  it("keep what is promised after every step, and are the same in other worlds", function()
    local updates = 0
    for seed = 1, effort.share(30) do
      updates = updates + passes(seed, case.new(seed, 40))
    end
    assert.equal(40 * effort.share(30), updates)
  end)

  it("are the same each time, and written down they are the same again", function()
    local one, other = case.new(3, 20), case.new(3, 20)
    assert.same(one, other)
    local read = reread(one)
    assert.same({ one.acts, one.settings }, { read.acts, read.settings })
  end)
end)

-- A box that lies between two others on the floor, and a wall at some distance.
local SCENE = {
  settings = { gravity = 800 },
  acts = {
    { "add", 1, "floors", { x = 0, y = 100, width = 100, height = 10, static = true } },
    { "add", 2, "boxes", { x = 20, y = 90, width = 10, height = 10 } },
    { "add", 3, "boxes", { x = 50, y = 80, width = 10, height = 10, vx = 5 } },
    { "add", 4, "sensors", put(70, 50, 10, 10, { sensor = true, gravity = 0 }) },
  },
}

-- (In seed 48 a box is added inside a lift, and leaves it behind a wall.)
it("random games with too little room: the same, no jumps, none past a wall, rest", function()
  for seed = 1, effort.isWhole and 24 or 2 do
    local one = crowded.new(seed, 30)
    passes(seed, one)
    local game, calmed = player.new(one), {}
    local watch = motion.new(game.world, game.list)
    for n, act in ipairs(one.acts) do
      watch:before()
      game:act(act)
      assert.is_nil(act[1] == "update" and watch:after(act[2]) or nil)
      for i, object in ipairs(n == #one.acts - crowded.QUIET and game.list or {}) do
        calmed[i] = { object.x, object.y }
      end
    end
    for i, object in ipairs(game.list) do -- (a squeezed row may go on by its last bits)
      assert.near(calmed[i][1], object.x, 1e-12)
      assert.near(calmed[i][2], object.y, 1e-12)
    end
  end
end)

describe("the checks notice", function()
  -- what; the check; the object, its field and its value at last; or a callback of the world that
  -- is called, with the numbers of two objects
  small.rows("{1}", {
    { "a number that is none", "finite", 3, "vx", 0 / 0 },
    { "a static object that has moved", "static", 1, "x", 1 },
    { "a box inside a wall", "static overlap", 3, "y", 90.01 },
    { "energy from nowhere", "energy", 3, "vx", 500 },
    { "a neighbour that is far away", "touching", 3, "left", 2 },
    { "a neighbour that is a sensor", "touching", 3, "left", 4 },
    { "a contact that begins twice", "pairing", "onBegin", 1, 2 },
    { "an end without a beginning", "pairing", "onEnd", 2, 3 },
    { "a beginning without an end", "pairing", "onBegin", 2, 3 },
    { "a crush by one object only", "crush", "onCrush", 2, 3 },
  }, function(_, check, first, second, third)
    local one = player.new(SCENE)
    local watch, list = checks.new(one, true), one.list
    for _, act in ipairs(SCENE.acts) do
      one:act(act)
    end
    for n = 1, 4 do
      watch:before()
      one:act({ "update", 1 / 60 })
      assert.is_true(n == 4 or watch:after(1 / 60) == nil)
    end
    if check == "pairing" or check == "crush" then
      one.world[first](list[second], list[third], "top", 0)
    elseif check == "touching" then
      list[first].touching[second] = list[third]
    else
      list[first][second] = third
    end
    assert.equal(check, (watch:after(1 / 60)))
  end)

  it("momentum that is gone", function()
    local one = player.new({ settings = { gravity = 0 }, acts = { SCENE.acts[3] } })
    local watch = checks.new(one, true)
    one:act(SCENE.acts[3])
    watch:before()
    one:act({ "update", 1 / 60 })
    one.list[3].vx = 4
    assert.equal("momentum", (watch:after(1 / 60)))
  end)
end)

-- 2000 of each: `make games GAMES=2000`.
describe("games of the kinds that are made show nothing that a player would notice:", function()
  small.rows("{1}", games.kinds, function(kind)
    for seed = 8, 7 + effort.share(4) do -- the eighth in three worlds
      local failure = games.play(kind, seed)
      local text = failure and ("seed %d, frame %d: %s"):format(seed, failure.at, failure.text)
      assert(not failure, text)
    end
  end)

  -- A ball that others press met the hero in vain in each round; walls pushed balls into others, as
  -- did the planes of those.
  local found = { { "survivors", 287 }, { "arena", 54 }, { "arena", 134 } }
  small.rows("{1}, {2}", found, function(kind, seed)
    assert.is_nil(games.play(kind, seed, true))
  end)
end)

-- What the games are watched with, against scenes worked out by hand.
describe("a watcher of games", function()
  local box, HILL = put(10, 10, 10, 10), put(0, 0, 10, 10, { slope = "right" })
  small.rows("knows {1}", {
    { "a box beside it", { x = 0, y = 10, width = 9, height = 9 }, box, -1 },
    { "a box in its corner", { x = 18, y = 17, width = 9, height = 9 }, box, 2 },
    { "a ball at its face", { x = 12, y = 3, width = 8, height = 8, radius = 4 }, box, 1 },
    { "a ball at its corner", put(18, 18, 10, 10, { radius = 5 }), box, 5 - math.sqrt(18) },
    { "two balls", put(0, 0, 10, 10, { radius = 5 }), put(3, 4, 10, 10, { radius = 5 }), 5 },
    { "a box on a slope", put(0, 0, 4, 8), put(0, 0, 10, 10, { slope = "right" }), 2 },
    { "a box under a slope", put(0, 2, 4, 8), put(0, 0, 10, 10, { slope = "topright" }), 2 },
    { "a ball on a slope", put(2, 2, 4, 4, { radius = 2 }), HILL, 2 - math.sqrt(2) },
  }, function(_, one, other, depth)
    assert.near(depth, overlap.depth(one, other), 1e-9)
  end)

  -- A game of one box, and of what more is given.
  local function newGame(more)
    local game = { world = physics.newWorld({ gravity = 0 }), room = { 0, 0, 100, 100 } }
    game.movers = { game.world:add("boxes", { x = 5, y = 5, width = 4, height = 4, vx = 60 }) }
    game.solids, game.machines, game.carriers, game.pull, game.carry = {}, {}, {}, 0, 0
    for name, value in pairs(more or {}) do
      game[name] = value
    end
    game.world:update(0)
    return game, game.movers[1], watcher.new(game)
  end

  local wall = { x = 8, y = 0, width = 9, height = 9 }
  -- what is done to the box; the check that notices it; what is different in the game, of the box
  for _, row in ipairs({
    { { x = 6.28 }, "jump" },
    { { x = 0 / 0 }, "lost" },
    { { x = -1 }, "lost" },
    { { vx = 0 / 0 }, "lost" },
    { { x = 5.6 }, "inside", { solids = { { x = 9.5, y = 0, width = 9, height = 9 } } } },
    { { vx = 61 }, "energy" },
    { { vx = 99 }, "energy", { carry = 40 } },
    { { vx = 0 }, "stop" },
    { { vx = 0 }, "stop", nil, { touching = { bottom = wall } } },
  }) do
    local does, check, more, has = row[1], row[2], row[3], row[4]
    local field, value = next(does)
    it(("notices %s where %s = %s"):format(check, field, value), function()
      local _, one, self = newGame(more)
      for name, its in pairs(has or {}) do
        one[name] = its
      end
      for n = 1, 2 do
        one.x, one.vx = 3 + n, 60
        watcher.note(self, 1 / 60)
        one[field] = n == 2 and value or one[field]
        assert.equal(n == 2 and check or nil, (watcher.check(self, 1 / 60)))
      end
    end)
  end
end)
