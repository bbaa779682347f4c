--- What holds for every scene, tried on random ones. Failures name the seed.

local everything = require("spec.support.everything")
local fold = require("spec.support.fold")
local effort = require("spec.support.effort")
local overlap = require("spec.support.overlap")
local golden = require("spec.support.golden")
local physics = require("physics")
local script = require("spec.support.script")
local small = require("spec.support.small")

local WILD = { steps = 100, boxes = 24, writes = 0.5, specials = true }
local CALM = { steps = 200, boxes = 40, writes = 0.04, specials = true }
local QUIET = { steps = 100, boxes = 24, writes = 0, specials = true }
-- Nothing that squeezes others where they have no room.
local PLAIN = { steps = 120, boxes = 40, writes = 0, specials = false, pushable = true }

local tracks = {}

--- The track of a script with the plainest settings: pair by pair, nothing skipped.
local function trackOf(seed, options, push)
  local settings = { broadphase = "pairs", rest = false, push = push }
  local key = ("%d %s %s"):format(seed, tostring(options), tostring(push))
  tracks[key] = tracks[key] or script.track(script.new(seed, options), settings)
  return tracks[key]
end

--- Plays a player to the end; fails with the first difference from a track.
local function checkSame(seed, track, player)
  while player:next() do
    local text = script.difference(track, player)
    if text then
      error(("seed %d, %s"):format(seed, text), 2)
    end
  end
end

describe("broadphase, rest and order: the same scene goes the same way, to the bit,", function()
  for _, row in ipairs({
    { "pair by pair", { broadphase = "pairs" } },
    { "in the grid", { broadphase = "grid" } },
    { "in the automatic broad phase", {} },
    { "in the grid, nothing skipped", { broadphase = "grid", rest = false } },
    { "in cells of 8 px", { broadphase = "grid", cellSize = 8 } },
    { "in cells of 37.5 px", { broadphase = "grid", cellSize = 37.5 } },
    { "in cells of 1000 px", { broadphase = "grid", cellSize = 1000 } },
    { "pair by pair, push first", { push = "first", broadphase = "pairs" } },
    { "in the grid, push first", { push = "first", broadphase = "grid" } },
  }) do
    local name, settings = row[1], row[2]

    it(name, function()
      for options, seeds in pairs({ [WILD] = 5, [CALM] = 2 }) do
        for seed = 1, effort.share(seeds) do
          local player = script.play(script.new(seed, options), settings)
          checkSame(seed, trackOf(seed, options, settings.push), player)
        end
      end
    end)
  end

  small.rows("put in by {1}", { "add", "insert", "assign" }, function(name)
    for seed = 1, effort.share(5) do
      local player = script.play(script.new(seed, QUIET), nil, script.inserts[name])
      checkSame(seed, trackOf(seed, QUIET), player)
    end
  end)

  it("under the same keys, whatever came and went before", function()
    for seed = 1, effort.share(5) do
      local function visit(world)
        everything.comeAndGo(world, seed)
      end
      local player = script.play(script.new(seed, WILD), nil, nil, visit)
      checkSame(seed, trackOf(seed, WILD), player)
    end
  end)

  it("under the same keys, in whatever order they were filled", function()
    for seed = 1, effort.share(5) do
      local quiet = script.new(seed, QUIET)
      local player = script.play(quiet, nil, function() end)
      local keys, last = {}, {}
      for i, entry in ipairs(quiet.objects) do
        last[entry[1]] = (last[entry[1]] or 0) + 1
        keys[i] = last[entry[1]]
      end
      for i = #quiet.objects, 1, -1 do
        local group = quiet.objects[i][1]
        player.world.objects[group] = player.world.objects[group] or {}
        player.world.objects[group][keys[i]] = player.list[i]
      end
      checkSame(seed, trackOf(seed, QUIET), player)
    end
  end)

  it("on every Lua", function()
    local sum = fold.START
    for seed = 1, 4 do -- not a share: the number is one for all
      local player = script.play(script.new(seed, WILD))
      while player:next() do
      end
      for i = 1, player.count do
        if player.list[i] then
          sum = fold.objects(sum, { player.list[i] })
        end
      end
    end
    golden.check("wild", ("%.0f"):format(sum))
  end)
end)

-- Nothing overlaps at the end of a step of a game, unless it is squeezed. A step has an end: what
-- still meets in its last round, as a box that rattles between two others, may overlap by up to a
-- px, and is apart after the next one.
local function expectApart(seed, push)
  local player = script.play(script.new(seed, PLAIN), { push = push })
  local deepest, before = overlap.checker(player.list), 0
  while player:next() do
    local depth, a, b = deepest()
    local isKnot = depth <= 1 and before <= 1e-6
    before = depth
    if depth > 1e-6 and not isKnot then
      local text = "seed %d, push %s, step %d: objects %d and %d overlap by %.3g px"
      local first, second = player.indexOf[a], player.indexOf[b]
      error(text:format(seed, push, player.step, first, second, depth))
    end
  end
end

describe("x and y: whatever happens,", function()
  local function expectAllApart(first, last)
    for _, push in ipairs({ "both", "first" }) do
      for seed = first, last do
        if effort.plays(seed, 10) then
          expectApart(seed, push)
        end
      end
    end
  end

  it("nothing sinks into anything, unless it is squeezed", function()
    expectAllApart(200, 211)
  end)

  it("nothing sinks, in more games #slow", function()
    expectAllApart(212, 219)
  end)
end)

describe("width: numbers that are hardly numbers any more", function()
  it("tell thin boxes at the same place apart", function()
    local world = physics.newWorld({ gravity = 100 })
    local thin = world:add("a", { x = 1e-310, y = 0, width = 1e-7, height = 10 })
    world:add("a", { x = 0, y = 0, width = 10, height = 10 })
    world:update(1 / 60)
    assert.is_true(thin.y > 0)
  end)
end)
