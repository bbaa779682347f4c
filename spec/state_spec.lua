--- save, restore, hash: going back and going on as if nothing had happened, to the bit.

local effort = require("spec.support.effort")
local physics = require("physics")
local everything = require("spec.support.everything")

effort.interpretQuickly(setup, teardown)

local LAST = 72

-- A serializer as a game may have one: text of numbers, strings, booleans and tables, no more.
local function write(value)
  local kind = type(value)
  if kind == "number" then
    assert(value - value == 0, "nan or inf in a state")
    return ("%.17g"):format(value)
  elseif kind == "string" then
    return ("%q"):format(value)
  elseif kind == "boolean" then
    return tostring(value)
  end
  assert(kind == "table" and getmetatable(value) == nil, "a " .. kind .. " in a state")
  local parts, count = {}, 0
  for _ in pairs(value) do
    count = count + 1
  end
  if count == #value then
    for i = 1, count do
      parts[i] = write(value[i])
    end
  else
    assert(#value == 0, "a list with holes, or with names, in a state")
    for key, entry in pairs(value) do
      assert(type(key) == "string", "a key that is no string in a state")
      parts[#parts + 1] = ("[%q]=%s"):format(key, write(entry))
    end
  end
  return "{" .. table.concat(parts, ",") .. "}"
end

local function read(text)
  return assert((loadstring or load)("return " .. text))() -- luacheck: ignore
end

-- Hash after each step of a straight run.
local tracks = {}

local function trackOf(push)
  if not tracks[push] then
    local world, track = everything.new({ push = push }), {}
    for n = 1, LAST + 1 do
      everything.step(world, n)
      track[n] = world:hash()
    end
    tracks[push] = track
  end
  return tracks[push]
end

local function checkStep(world, track, n, what)
  local text = "%s: step %d is not as in the straight run"
  if world:hash() ~= track[n] then
    error(text:format(what, n), 2)
  end
end

local VARIANTS = {
  { "with the default settings", {} },
  { "pair by pair #slow", { broadphase = "pairs" } },
  { "in cells of 20 px #slow", { broadphase = "grid", cellSize = 20 } },
  { "nothing skipped #slow", { rest = false } },
  { "nothing skipped, pair by pair #slow", { rest = false, broadphase = "pairs" } },
  { "push first #slow", { push = "first" } },
}

describe("a rollback of 8 steps", function()
  for _, variant in ipairs(VARIANTS) do
    it("and a replay are as the straight run, " .. variant[1], function()
      local track, ring = trackOf(variant[2].push or "both"), {}
      local world = everything.new(variant[2])
      for n = 1, LAST do
        ring[n % 8] = ring[n % 8] or {}
        local oldest = ring[(n + 1) % 8]
        world:save(ring[n % 8])
        if n > 8 and n % 4 == 0 then
          for m = n - 7, n do
            everything.step(world, m, 29)
          end -- another input
          world:restore(oldest)
          for m = n - 7, n - 1 do
            everything.step(world, m)
            checkStep(world, track, m, "replay from " .. n - 7)
          end
        end
        everything.step(world, n)
        checkStep(world, track, n, "run")
      end
    end)
  end
end)

describe("a state from elsewhere", function()
  -- Saved between what the game writes and the update: all is still to be collected.
  it("goes on in a world of the same scene, and in an empty one", function()
    local track, world = trackOf("both"), everything.new()
    for n = 1, LAST do
      everything.write(world, n)
      if n % 9 == 0 then
        local text, hash = write(world:save()), world:hash()
        local other = n % 2 == 0 and everything.new() or everything.newWorld()
        other:restore(read(text))
        assert.are.equal(hash, other:hash())
        other:update(everything.dt(n))
        checkStep(other, track, n, "other world")
        for m = n + 1, math.min(n + 12, LAST) do
          everything.step(other, m)
          checkStep(other, track, m, "other world from " .. n)
        end
      end
      world:update(everything.dt(n))
      checkStep(world, track, n, "run")
    end
  end)

  it("does not depend on broad phase and rest, neither does the hash", function()
    local a = everything.new({ broadphase = "pairs", rest = false })
    local b = everything.new({ broadphase = "grid", cellSize = 50 })
    for n = 1, 60 do
      everything.step(a, n)
      everything.step(b, n)
    end
    local state = read(write(a:save()))
    assert.are.equal(a:hash(), b:hash())
    b:restore(state)
    for n = 61, 80 do
      everything.step(a, n)
      everything.step(b, n)
      assert.are.equal(a:hash(), b:hash())
    end
  end)

  -- What a world does not look for if it never happened there. The columns: what happened; the step
  -- before which the state is saved, after the game has written; how often a box is crushed before
  -- and after; objects; what the game writes before step n.
  local HISTORIES = {
    {
      "one was crushed",
      50,
      { 1, 1 },
      {
        walls = { { x = 0, y = 0, width = 10, height = 100, static = true } },
        lifts = { { x = 60, y = 0, width = 20, height = 100, kinematic = true, vx = -60 } },
        boxes = { { x = 30, y = 40, width = 20, height = 20, gravity = 0 } },
      },
      function(objects, n)
        if n == 50 then
          objects.lifts[1] = nil
        elseif n == 80 then
          objects.lifts[1] = { x = 60, y = 0, width = 20, height = 100, kinematic = true, vx = -60 }
        end
      end,
    },
    {
      "one is inside of walls",
      20,
      { 1, 0 },
      {
        walls = {
          { x = 0, y = 0, width = 30, height = 90, static = true },
          { x = 30, y = 0, width = 30, height = 30, static = true },
          { x = 30, y = 30, width = 30, height = 30, static = true },
          { x = 30, y = 60, width = 30, height = 30, static = true },
          { x = 60, y = 0, width = 30, height = 90, static = true },
        },
        boxes = { { x = 40, y = 40, width = 10, height = 10 } },
      },
      function(objects, n)
        if n == 20 then
          table.remove(objects.walls, 5)
        end
      end,
    },
    {
      "one has just landed on a belt that has stopped",
      5,
      { 0, 0 },
      {
        belts = { { x = 0, y = 100, width = 400, height = 10, static = true, surfaceSpeed = 60 } },
        boxes = { { x = 40, y = 79, width = 20, height = 20 } },
      },
      function(objects, n, world)
        if n == 5 or n == 6 then
          objects.belts[1].surfaceSpeed = n == 6 and 60 or nil
          world:refresh(objects.belts[1])
        end
      end,
    },
    {
      "one has lost its lift",
      30,
      { 0, 0 },
      {
        lifts = { { x = 0, y = 100, width = 100, height = 10, kinematic = true, vx = 60 } },
        boxes = { { x = 40, y = 80, width = 20, height = 20 } },
      },
      function(objects, n)
        if n == 30 then
          objects.lifts[1] = nil
        end
      end,
    },
  }
  for _, row in ipairs(HISTORIES) do
    it("goes on in an empty world as in the old one, with one " .. row[1], function()
      local what, saved, crushes, objects, drive = row[1], row[2], row[3], row[4], row[5]
      local world, copy, counts = physics.newWorld({ gravity = 600 }), physics.newWorld(), { 0, 0 }
      world.objects = objects
      for at, each in ipairs({ world, copy }) do
        each.onCrush = function()
          counts[at] = counts[at] + 1
        end
      end
      for n = 1, saved + 100 do
        drive(world.objects, n, world)
        if n == saved then
          assert.same({ crushes[1], 0 }, counts)
          copy:restore(world:save())
        elseif n > saved then
          drive(copy.objects, n, copy)
        end
        world:update(1 / 60)
        if n >= saved then
          copy:update(1 / 60)
          assert.equal(world:hash(), copy:hash(), what .. ", step " .. n)
        end
      end
      assert.same({ crushes[1] + crushes[2], crushes[2] }, counts)
    end)
  end

  it(
    "goes on as the world does, after an update that was refused with a rider put elsewhere",
    function()
      local world, copy = physics.newWorld({ gravity = 800 }), physics.newWorld()
      world:add("lifts", { x = 0, y = 500, width = 100, height = 10, kinematic = true, vx = 200 })
      local rider = world:add("boxes", { x = 20, y = 480, width = 20, height = 20 })
      local other = world:add("crates", { x = 450, y = 580, width = 20, height = 20 })
      for _ = 1, 30 do
        world:update(1 / 60)
      end
      rider.x, rider.y, other.mass = 450, 300, -1
      assert.has_error(function()
        world:update(1 / 60)
      end)
      other.mass = nil
      copy:restore(world:save())
      for _ = 1, 5 do
        world:update(1 / 60)
        copy:update(1 / 60)
        assert.equal(world:hash(), copy:hash())
        assert.equal(450, rider.x)
      end
    end
  )

  it("is the same state after it was restored", function()
    local world = everything.new()
    for n = 1, 50 do
      everything.step(world, n)
    end
    local state, other = world:save(), everything.newWorld()
    other:restore(read(write(state)))
    assert.are.same(state, other:save())
    world:restore(state)
    assert.are.same(state, world:save())
  end)
end)

-- A floor, a box on it, another one in the air.
local function smallWorld(settings)
  local world = physics.newWorld(settings or { gravity = 600 })
  world:add("floor", { x = 0, y = 100, width = 400, height = 20, static = true })
  local box = world:add("boxes", { x = 10, y = 84, width = 16, height = 16 })
  local other = world:add("boxes", { x = 60, y = 20, width = 16, height = 16 })
  world:update(1 / 60)
  return world, box, other
end

describe("world:save", function()
  it("changes nothing", function()
    local track, world = trackOf("both"), everything.new()
    for n = 1, 60 do
      everything.write(world, n)
      world:save()
      world:hash()
      world:update(everything.dt(n))
      checkStep(world, track, n, "run")
    end
  end)

  it("fills a table again, and leaves no garbage then", function()
    local world = smallWorld()
    world:add("boxes", { x = 90, y = 20, width = 16, height = 16, mask = nil, mass = 3 })
    world:update(1 / 60)
    local state = world:save()
    world:remove(world.objects.boxes[3])
    world:update(1 / 60)
    assert.are.equal(state, world:save(state))
    assert.are.same(world:save(), state)
    -- The trace compiler allocates for itself, so it is kept out.
    local jit = rawget(_G, "jit")
    local wasOn = jit and jit.status()
    if wasOn then
      jit.off()
      jit.flush() -- traces that are compiled already would go on running
    end
    for _ = 1, 200 do
      world:save(state)
    end
    collectgarbage()
    collectgarbage("stop")
    world:save(state)
    local before = collectgarbage("count")
    for _ = 1, 100 do
      world:save(state)
    end
    local grown = collectgarbage("count") - before
    collectgarbage("restart")
    if wasOn then
      jit.on()
    end
    assert.is_true(grown < 16, ("%.1f KB"):format(grown))
  end)

  it("holds no limit that is infinite", function()
    local world = smallWorld()
    world.objects.boxes[1].maxSpeed = 100
    world:update(1 / 60)
    world.objects.boxes[1].maxSpeed = nil -- was read as 100, and is none now
    local state = read(write(world:save()))
    world:update(1 / 60)
    local other = smallWorld()
    other:restore(state)
    assert.is_nil(other.objects.boxes[1].maxSpeed)
    other:update(1 / 60)
    assert.are.equal(world:hash(), other:hash())
  end)

  it("refuses what an update would refuse", function()
    for _, row in ipairs({
      { "x", 0 / 0, "physics: objects.boxes[1].x must be a number, got nan" },
      { "mass", -1, "physics: objects.boxes[1].mass must be a number > 0, got -1" },
      { "oneWay", "up", 'must be true, false, "top", "bottom", "left" or "right", got "up"' },
      { "maxSpeed", 1 / 0, "must be a finite number >= 0, got inf" },
      { "mask", { [true] = 1 }, "mask" },
    }) do
      local world, box = smallWorld()
      box[row[1]] = row[2]
      for _, call in ipairs({ "save", "hash" }) do
        local ok, message = pcall(function()
          world[call](world)
        end)
        assert.is_false(ok)
        assert.is_truthy(message:find(row[3], 1, true), message)
        assert.is_truthy(message:find("state_spec.lua", 1, true), message)
      end
    end
  end)
end)

describe("world:restore", function()
  it("keeps the tables of the objects, also of those that were removed", function()
    local world, box, other = smallWorld()
    local told = 0
    other.onBegin = function()
      told = told + 1
    end
    other.name = "other"
    local state = world:save()
    world:remove(other)
    world:update(1 / 60)
    local bullet = world:add("bullets", { x = 0, y = 0, width = 2, height = 2 })
    world:update(1 / 60)
    world:restore(state)
    assert.are.equal(box, world.objects.boxes[1])
    assert.are.equal(other, world.objects.boxes[2])
    assert.is_nil(world.objects.bullets[1])
    assert.is_false(world:remove(bullet))
    assert.are.equal("other", other.name)
    for _ = 1, 60 do
      world:update(1 / 60)
    end
    assert.are.equal(1, told)
  end)

  it("gives a state from elsewhere to the object at the same place", function()
    local world, box = smallWorld()
    local state = read(write(world:save()))
    local x, y = world.objects.boxes[2].x, world.objects.boxes[2].y
    local group = world.objects.boxes
    world:remove(world.objects.boxes[2])
    box.name, box.x, box.restitution = "box", 300, 1
    world:update(1 / 60)
    world:restore(state)
    assert.are.equal(group, world.objects.boxes)
    assert.are.equal(box, world.objects.boxes[1])
    assert.are.same({ "box", 10 }, { box.name, box.x })
    assert.is_nil(box.restitution)
    assert.are.same({ x, y }, { world.objects.boxes[2].x, world.objects.boxes[2].y })
  end)

  it("shows at once what touches what", function()
    local world, box = smallWorld()
    local floor = world.objects.floor[1]
    local hung = world:add("boxes", { x = 384, y = 50, width = 16, height = 16, gravity = 0 })
    hung.vx = 20
    local wall = world:add("walls", { x = 400, y = 0, width = 9, height = 90, static = true })
    world:update(1 / 60)
    local state = world:save()
    local function checkTouching()
      local stands = { left = false, right = false, top = false, bottom = floor }
      assert.are.same(stands, box.touching)
      assert.are.same({ left = false, right = wall, top = false, bottom = false }, hung.touching)
    end
    checkTouching()
    box.y, hung.x = 0, 200
    world:update(1 / 60)
    assert.is_false(box.touching.bottom)
    world:restore(state)
    checkTouching()
    local other = physics.newWorld()
    other:restore(read(write(state)))
    assert.are.equal(other.objects.floor[1], other.objects.boxes[1].touching.bottom)
    assert.are.equal("bottom", other:touching(other.objects.boxes[1], other.objects.floor[1]))
  end)

  it("tells no event for the jump", function()
    local world, box = smallWorld()
    local told = {}
    for _, name in ipairs({ "onBegin", "onEnd" }) do
      world[name] = function()
        told[#told + 1] = name
      end
    end
    local state = world:save()
    box.y = 0
    world:update(1 / 60)
    assert.are.same({ "onEnd" }, told)
    world:restore(state)
    world:update(1 / 60)
    world:update(1 / 60)
    assert.are.same({ "onEnd" }, told)
  end)

  it("brings back groups, single objects, odd keys, masks and settings", function()
    local world = smallWorld()
    local mask = { boxes = false, [3] = true }
    world.objects.player = { x = 200, y = 50, width = 8, height = 8, mask = mask }
    world.objects[7] = { left = { x = 250, y = 0, width = 9, height = 9 } }
    world.masks = { boxes = { [7] = false } }
    world.order = { "player", 7 }
    world:update(1 / 60)
    local state, hash, player = world:save(), world:hash(), world.objects.player
    local text = write(state)
    world.objects.player, world.objects[7] = nil, nil
    world.masks, world.order, world.gravity = nil, nil, 5
    mask.boxes = true
    world:update(1 / 60)
    world:restore(state)
    assert.are.equal(hash, world:hash())
    assert.are.equal(player, world.objects.player)
    assert.are.equal(mask, player.mask)
    assert.is_false(mask.boxes)
    assert.are.same({ { boxes = { [7] = false } }, 600 }, { world.masks, world.gravity })
    local other = physics.newWorld()
    other:restore(read(text))
    assert.are.equal(hash, other:hash())
    assert.are.equal(250, other.objects[7].left.x)
    assert.are.same(mask, other.objects.player.mask)
  end)

  -- The game may change `masks` in place, so the table that it holds must stay the world's.
  it("leaves the masks of the world the same tables, rows that say nothing included", function()
    local masks = { bullets = { players = true }, boxes = {} }
    local row, boxes = masks.bullets, masks.boxes
    local world = physics.newWorld({ gravity = 0, masks = masks })
    world:add("players", { x = 100, y = 0, width = 10, height = 10, static = true })
    local bullet = world:add("bullets", { x = 0, y = 0, width = 4, height = 4, vx = 600 })
    world:update(1 / 60)
    local state = world:save()
    local text = write(state)
    world:restore(read(text))
    assert.is_true(rawequal(masks, world.masks) and rawequal(boxes, masks.boxes))
    -- What has changed in them is written back into them.
    local function spoil(n)
      if n == 1 then
        row.players, boxes.bullets, masks.others = false, false, { boxes = false }
      elseif n == 2 then
        masks.boxes, masks.bullets = row, boxes
        row.players = nil
      elseif n == 3 then
        masks.bullets, masks[1], masks.boxes = 5, true, nil
      else
        world.masks = n == 4 and { players = {} } or nil
      end
    end
    for n = 1, 5 do
      spoil(n)
      world:restore(state)
      assert.is_true(rawequal(masks, world.masks))
      assert.is_true(rawequal(row, masks.bullets) and rawequal(boxes, masks.boxes))
      masks.others = nil
      assert.are.same({ bullets = { players = true }, boxes = {} }, masks)
    end
    -- From elsewhere there is a new table, with the rows that the world has.
    world.masks = { boxes = {}, others = { bullets = false } }
    world:restore(read(text))
    assert.are.same({ bullets = { players = true }, boxes = {}, others = {} }, world.masks)
    world:restore(state)
    masks.bullets.players = false
    for _ = 1, 30 do
      world:update(1 / 60)
    end
    assert.is_near(310, bullet.x, 1e-9)
  end)

  it("finds an object that was read again and not stepped yet", function()
    local world = physics.newWorld({ gravity = 0 })
    local wall = world:add("walls", { x = 0, y = 0, width = 20, height = 100, static = true })
    local box = world:add("boxes", { x = 30, y = 40, width = 20, height = 20 })
    world:update(1 / 60)
    wall.width = 36 -- into the box
    world:refresh(wall)
    local copy = physics.newWorld()
    copy:restore(read(write(world:save())))
    local begins = 0
    for _, each in ipairs({ world, copy }) do
      each.onBegin = function()
        begins = begins + 1
      end
      each:update(1 / 60)
    end
    local its = copy.objects.boxes[1]
    assert.are.same({ 36, 40, 36, 40 }, { box.x, box.y, its.x, its.y })
    assert.are.equal(0, begins) -- the wall came to it
    assert.are.equal(world:hash(), copy:hash())
  end)

  -- A box with `drag` on another one on the floor: what stands is held by it, what falls is braked.
  local function newTower()
    local world = physics.newWorld({ gravity = 800 })
    world:add("floors", { x = -100, y = 40, width = 300, height = 10, static = true })
    local low = world:add("boxes", { x = 0, y = 20, width = 20, height = 20 })
    local high = world:add("crates", { x = 0, y = 0, width = 20, height = 20, drag = 500 })
    for _ = 1, 10 do
      world:update(1 / 60)
    end
    assert.are.equal(low, high.touching.bottom)
    return world, low, high
  end

  -- 300 px/s² are left of the pull.
  local FALLEN = 300 / 60 / 60 / 2

  for _, row in ipairs({
    {
      "one that has lost what it stood on falls as in the straight run",
      function(world, low)
        world:remove(low)
      end,
    },
    {
      "the same if another object has come since, in any place of the memory",
      function(world, low)
        world:remove(low)
        world:update(0)
        for n = 1, 3 do
          world:add("others", { x = 300 * n, y = 0, width = 20, height = 20 })
        end
      end,
    },
    {
      "the same if a mask parts them before it goes",
      function(world, low, high)
        high.mask = { boxes = false }
        world:update(0)
        world:remove(low)
      end,
    },
    {
      "the same if it was off when that went",
      function(world, low, high)
        high.active = false
        world:update(0)
        world:remove(low)
        world:update(0)
        high.active = nil
      end,
    },
    {
      "the same if masks of the world part them before it goes",
      function(world, low)
        world.masks = { boxes = { crates = false } }
        world:update(0)
        world:remove(low)
      end,
    },
  }) do
    it(row[1], function()
      local world, low, high = newTower()
      row[2](world, low, high)
      world:update(0)
      local state, copy = world:save(), physics.newWorld()
      copy:restore(read(write(state)))
      world:update(1 / 60)
      local y, hash = high.y, world:hash()
      world:restore(state)
      world:update(1 / 60)
      copy:update(1 / 60)
      assert.is_near(FALLEN, y, 1e-9)
      assert.are.same({ y, hash, hash }, { high.y, world:hash(), copy:hash() })
    end)
  end

  -- The group `players` is there at once, or comes only after the mask was read and saved.
  for _, row in ipairs({ { "of a group that is there", true }, { "of one that comes", false } }) do
    for _, collides in ipairs({ false, true }) do
      local name = ("keeps what was read of the mask of a static object, %s (%s)"):format(
        row[1],
        tostring(collides)
      )
      it(name, function()
        local world = physics.newWorld({ gravity = 0 })
        local mask = { players = collides }
        local wall = { x = 40, y = 0, width = 10, height = 10, static = true, mask = mask }
        world:add("walls", wall)
        local player = { x = 0, y = 0, width = 10, height = 10, vx = 600 }
        if row[2] then
          world:add("players", player)
        end
        world:update(1 / 600)
        mask.players = not collides
        local state, copy, ends = world:save(), physics.newWorld(), {}
        copy:restore(read(write(state)))
        for n = 1, 3 do
          local each = n == 3 and copy or world
          if n == 2 then
            world:restore(state)
          end
          assert.are.same({ players = not collides }, each.objects.walls[1].mask)
          if not row[2] then
            each:add("players", { x = 1, y = 0, width = 10, height = 10, vx = 600 })
          end
          for _ = 1, 30 do
            each:update(1 / 60)
          end
          ends[n] = each.objects.players[1].x
        end
        assert.are.equal(mask, wall.mask)
        assert.is_near(collides and 30 or 301, ends[1], 1e-9)
        assert.are.same({ ends[1], ends[1], ends[1] }, ends)
      end)
    end
  end

  it("leaves an object that was added just before its `touching`", function()
    local world = physics.newWorld({ gravity = 0 })
    world:update(1 / 60)
    local box = world:add("boxes", { x = 30, y = 40, width = 20, height = 20 })
    local touching = box.touching
    world:restore(world:save())
    assert.are.equal(touching, box.touching)
    world:add("walls", { x = 15, y = 0, width = 20, height = 100, static = true })
    world:update(1 / 60)
    assert.are.equal(touching, box.touching)
  end)

  it("may happen inside a callback", function()
    local world, _, other = smallWorld()
    local state, count = world:save(), 0
    other.onBegin = function()
      count = count + 1
      if count == 1 then
        world:restore(state)
      end
    end
    for _ = 1, 120 do
      world:update(1 / 60)
    end
    assert.are.equal(2, count)
    assert.are.equal(84, other.y)
  end)

  it("keeps events that wait because a callback has failed, one of them half told", function()
    local world, box, other = smallWorld()
    box.y, other.y, box.name, other.name = 80, 80, "box", "other"
    world:update(1 / 60)
    other.onBegin = function()
      error("no")
    end
    while pcall(world.update, world, 1 / 60) do
    end
    other.onBegin = nil
    local state = world:save()
    local function listen(to)
      local told = {}
      for _, name in ipairs({ "onBegin", "onEnd", "onCrush" }) do
        to[name] = function(a, b, side)
          told[#told + 1] = ("%s %d %d %s"):format(name, a.width, b.width, side)
        end
      end
      to:update(0)
      to.onBegin, to.onEnd, to.onCrush = nil, nil, nil
      return told
    end
    local hash = world:hash()
    local first = listen(world)
    assert.is_true(#first > 0)
    assert.are_not.equal(hash, world:hash())
    world:restore(state)
    assert.are.equal(hash, world:hash())
    assert.are.same(first, listen(world))
    local twin = physics.newWorld()
    twin:restore(read(write(state)))
    assert.are.equal(hash, twin:hash())
    assert.are.same(first, listen(twin))
  end)

  -- Three boxes on a floor, and a callback that fails at the first end of a contact, which is that
  -- of the second box; so the end of the third is still to be told. Both have left.
  local function leaveBehind()
    local world = physics.newWorld({ gravity = 800 })
    world:add("floor", { x = 0, y = 100, width = 200, height = 20, static = true })
    local boxes = {}
    for n = 1, 3 do
      local mask = n == 3 and { ghosts = false } or nil
      boxes[n] =
        world:add("boxes", { x = 50 * n, y = 90, width = 10, height = 10, mass = n, mask = mask })
    end
    for _ = 1, 3 do
      world:update(1 / 60)
    end
    world.onEnd = function()
      error("no")
    end
    world:remove(boxes[2])
    world:remove(boxes[3])
    assert.is_false((pcall(world.update, world, 0)))
    world.onEnd = nil
    return world, boxes
  end

  -- What is told of the boxes, and the objects that it is told of.
  local function hearEnds(world)
    local told, heard = {}, {}
    world.onEnd = function(a, b)
      told[#told + 1], heard[#heard + 1] = ("%d %d"):format(a.x, b.x), a
    end
    world:update(1 / 60)
    return told, heard
  end

  it("keeps events of objects that have left the world", function()
    local world, boxes = leaveBehind()
    local state, hash = world:save(), world:hash()
    assert.are.same({ "150 0" }, (hearEnds(world)))
    local last = world:hash()
    boxes[3].x, boxes[3].mass, boxes[3].sensor = 7, nil, true
    world:restore(state)
    assert.are.equal(hash, world:hash())
    assert.are.same({ 150, 3 }, { boxes[3].x, boxes[3].mass })
    assert.is_nil(boxes[3].sensor)
    local told, heard = hearEnds(world)
    assert.are.same({ "150 0" }, told)
    assert.are.equal(boxes[3], heard[1])

    local twin = physics.newWorld()
    twin:restore(read(write(state)))
    assert.are.equal(hash, twin:hash())
    assert.are.equal(1, #twin.objects.boxes)
    told, heard = hearEnds(twin)
    assert.are.same({ "150 0" }, told)
    assert.are.same({
      x = 150,
      y = 90,
      width = 10,
      height = 10,
      vx = 0,
      vy = 0,
      mass = 3,
      mask = { ghosts = false },
      touching = { left = false, right = false, top = false, bottom = false },
    }, heard[1])
    assert.are.equal(last, twin:hash())
  end)

  it("drops what a world could not use of objects that have left", function()
    local world, boxes = leaveBehind()
    boxes[3].width, boxes[3].mask, boxes[3].vx = -1, "no", 0 / 0
    local twin = physics.newWorld()
    twin:restore(read(write(world:save())))
    local _, heard = hearEnds(twin)
    assert.are.same({ 150, 10 }, { heard[1].x, heard[1].height })
    assert.is_nil(heard[1].width or heard[1].mask or heard[1].vx)
  end)

  it("keeps the order in which all stand until the next step, if another one is set", function()
    for _, orders in ipairs({ { false, { "boxes", 1 } }, { { "boxes", 1 }, false } }) do
      local world = physics.newWorld({ order = orders[1] or nil })
      world:add("boxes", { x = 0, y = 0, width = 10, height = 10 })
      world:add(1, { x = 20, y = 0, width = 10, height = 10 })
      world:update(1 / 64)
      world.order = orders[2] or nil
      local hash, twin = world:hash(), physics.newWorld()
      twin:restore(world:save())
      assert.are.equal(hash, twin:hash())
      world:update(1 / 64)
      twin:update(1 / 64)
      assert.are.equal(world:hash(), twin:hash())
    end
  end)

  it("looks at an object with a new canCollide as the world itself would", function()
    local hashes = {}
    for n = 1, 2 do
      local world = physics.newWorld()
      local box = world:add("boxes", { x = 0, y = 0, width = 10, height = 10 })
      world:update(1 / 60)
      box.canCollide = function()
        return true
      end
      if n == 2 then
        world:restore(world:save())
      end
      world:update(0)
      hashes[n] = world:hash()
    end
    assert.equal(hashes[1], hashes[2])
  end)

  it("keeps the order of events if one was noted after others had been told", function()
    local world, boxes = leaveBehind()
    world.onEnd = function() end -- an event without a callback is not noted
    boxes[1].static, boxes[1].active = true, false
    world:refresh(boxes[1])
    local state = world:save()
    local twin = physics.newWorld()
    twin:restore(read(write(state)))
    assert.are.equal(world:hash(), twin:hash())
    assert.are.same({ "150 0", "50 0" }, (hearEnds(world)))
    assert.are.same({ "150 0", "50 0" }, (hearEnds(twin)))
    world:restore(state)
    assert.are.same({ "150 0", "50 0" }, (hearEnds(world)))
  end)

  it("says that an object touches one that has left since the last step", function()
    local world = physics.newWorld({ gravity = 800 })
    local floor = world:add("floor", { x = 0, y = 100, width = 200, height = 20, static = true })
    local box = world:add("boxes", { x = 50, y = 90, width = 10, height = 10 })
    world:update(1 / 60)
    world:remove(floor)
    world:update(0) -- nothing moves: what a step has found is still true
    assert.are.equal(floor, box.touching.bottom)
    local state = world:save()
    world:update(1 / 60)
    assert.is_false(box.touching.bottom)
    world:restore(state)
    assert.are.equal(floor, box.touching.bottom)
    local twin = physics.newWorld()
    twin:restore(read(write(state)))
    assert.are.same({ 0, 100, true }, {
      twin.objects.boxes[1].touching.bottom.x,
      twin.objects.boxes[1].touching.bottom.y,
      twin.objects.boxes[1].touching.bottom.static,
    })
    assert.are.equal(world:hash(), twin:hash())
  end)

  it("tells the events that were still to come when it was saved, by whomever", function()
    for _, where in ipairs({ "box", "floor", "world" }) do
      local world, box, other = smallWorld()
      local told, state = {}, nil
      local function listen(owner, name)
        owner.onBegin = function(_, hit)
          told[#told + 1] = ("%s %d"):format(name, hit.x)
          state = state or (name == where and world:save() or nil)
        end
      end
      box.y, other.y = 60, 60
      world:update(1 / 60)
      listen(box, "box")
      listen(world.objects.floor[1], "floor")
      listen(world, "world")
      while not state do
        world:update(1 / 60)
      end
      assert.are.same({ "box 0", "floor 10", "world 0", "floor 60", "world 0" }, told)
      local rest = {}
      for n = where == "box" and 2 or where == "floor" and 3 or 4, #told do
        rest[#rest + 1] = told[n]
      end
      told = {}
      world:restore(state)
      world:update(0)
      assert.are.same(rest, told)
    end
  end)

  it("brings back the walls of setBounds", function()
    local world = smallWorld()
    world:setBounds(0, 0, 400, 300)
    world:update(1 / 60)
    local state = world:save()
    world:setBounds()
    world:update(1 / 60)
    world:restore(state)
    assert.is_truthy(world.objects.bounds.left)
    world:setBounds(0, 0, 500, 300)
    assert.are.equal(500, world.objects.bounds.right.x)
  end)
end)

describe("world:hash", function()
  it("is a whole number that every Lua writes in full", function()
    local world = smallWorld()
    local hash = world:hash()
    assert.are.equal(hash, math.floor(hash))
    assert.is_true(hash >= 0 and hash < 1e14)
    assert.are.equal(("%.0f"):format(hash), tostring(hash))
  end)

  for _, row in ipairs({
    { "x", 11 },
    { "x", 10.000000000000002 },
    { "y", 84.5 },
    { "width", 17 },
    { "height", 17 },
    { "vx", 1e-300 },
    { "vx", -1 },
    { "vy", 1e99 },
    { "ax", 1 },
    { "ay", 1 },
    { "kinematic", true },
    { "active", false },
    { "sensor", true },
    { "pushable", false },
    { "mass", 2 },
    { "gravity", 0 },
    { "gravityX", 1 },
    { "friction", 0.5 },
    { "restitution", 0.5 },
    { "airFriction", 0.1 },
    { "drag", 1 },
    { "maxSpeed", 1e4 },
    { "maxSpeedX", 1e4 },
    { "maxSpeedY", 1e4 },
    { "mask", { floor = false } },
    { "oneWay", "top" },
    { "carry", false },
    { "surfaceSpeed", 5 },
    { "nudge", 2 },
    { "snap", 2 },
    { "maxFallSpeed", 1e4 },
  }) do
    it(("changes with %s = %s"):format(row[1], tostring(row[2])), function()
      local world, box = smallWorld()
      local before = world:hash()
      box[row[1]] = row[2]
      local written = world:hash()
      assert.are_not.equal(before, written)
      world:update(0)
      assert.are_not.equal(before, world:hash())
    end)
  end

  it("changes with settings, groups, keys, order and saved-up time", function()
    for what, change in pairs({
      gravity = function(world)
        world.gravity = 601
      end,
      push = function(world)
        world.push = "first"
      end,
      masks = function(world)
        world.masks = { boxes = { boxes = false } }
      end,
      group = function(world)
        world.objects.crates, world.objects.boxes = world.objects.boxes, nil
      end,
      key = function(world)
        world.objects.boxes[3], world.objects.boxes[2] = world.objects.boxes[2], nil
      end,
      order = function(world)
        local boxes = world.objects.boxes
        boxes[1], boxes[2] = boxes[2], boxes[1]
      end,
      removed = function(world)
        world.objects.boxes[2] = nil
      end,
      added = function(world)
        world:add("boxes", { x = 0, y = 0, width = 1, height = 1 })
      end,
    }) do
      local world = smallWorld()
      local before = world:hash()
      change(world)
      assert.are_not.equal(before, world:hash(), what)
    end
    local world = physics.newWorld({ timestep = 1 / 60 })
    local before = world:hash()
    world:update(1 / 100)
    assert.are_not.equal(before, world:hash())
  end)

  it("takes -0 for 0, integers for floats, and a default for what is not set", function()
    local world, box = smallWorld()
    local before = world:hash()
    box.vx, box.mass, box.pushable = -0.0, 1, true
    box.x, box.width = 10.0, 16.0
    assert.are.equal(before, world:hash())
  end)
end)

describe("a damaged state", function()
  for _, row in ipairs({
    {
      "nothing",
      function()
        return nil
      end,
      "state must be a table, got nil",
    },
    {
      "a text",
      function()
        return "state"
      end,
      'state must be a table, got "state"',
    },
    {
      "an empty one",
      function()
        return {}
      end,
      "state must be what world:save() returns, got table",
    },
    {
      "another version",
      function(state)
        state.version = 1
      end,
      "state.version must be 2 (it was saved by another version of the library), got 1",
    },
    {
      "a setting",
      function(state)
        state.settings.gravity = "much"
      end,
      'state.settings.gravity must be a number, got "much"',
    },
    {
      "saved",
      function(state)
        state.saved = -1
      end,
      "state.saved must be a number in 0..0.25, got -1",
    },
    {
      "count",
      function(state)
        state.count = 2
      end,
      "state.known must be an integer in 0..2, got 3",
    },
    {
      "a group",
      function(state)
        state.groups[1].count = 1
      end,
      "state.known must be 2, as many as the groups have, got 3",
    },
    {
      "a name",
      function(state)
        state.groups[1].name = true
      end,
      "state.groups[1].name must be",
    },
    {
      "a place",
      function(state)
        table.remove(state.x)
      end,
      "#state.x must be 3, got 2",
    },
    {
      "a position",
      function(state)
        state.x[1] = false
      end,
      "objects.boxes[1].x must be a number, got false",
    },
    {
      "a size",
      function(state)
        state.width[2] = 0
      end,
      "objects.boxes[2].width must be a number > 0, got 0",
    },
    {
      "a field",
      function(state)
        state.fields.mass = { 1, -1 }
      end,
      "objects.boxes[1].mass must be a number > 0, got -1",
    },
    {
      "the object of a field",
      function(state)
        state.fields.mass = { 9, 1 }
      end,
      "state.fields.mass[1] must be an integer in 1..3, got 9",
    },
    {
      "fields in disorder",
      function(state)
        state.fields.mass = { 2, 1, 1, 1 }
      end,
      "state.fields.mass[3] must be > 2, got 1",
    },
    {
      "a contact",
      function(state)
        state.contacts[3] = 7
      end,
      "state.contacts[3] must be a contact of a pair, got 7",
    },
    {
      "a support",
      function(state)
        state.memory.support[2] = 0
      end,
      "state.memory.support[2] must be an integer in 1..3, got 0",
    },
    {
      "touching",
      function(state)
        state.touching[5] = 99
      end,
      "state.touching[5] must be",
    },
    {
      "half an event",
      function(state)
        state.events = { 1 }
      end,
      "#state.events must be",
    },
  }) do
    it("is refused, and nothing has changed: " .. row[1], function()
      local world, box = smallWorld()
      local state = read(write(world:save()))
      box.x = 40
      world:update(1 / 60)
      local hash = world:hash()
      local damaged = row[2](state)
      if damaged == nil and row[1] ~= "nothing" then
        damaged = state
      end
      local ok, message = pcall(function()
        world:restore(damaged)
      end)
      assert.is_false(ok)
      local text = "physics: world:restore(state): " .. row[3]
      assert.is_truthy(message:find(text, 1, true), message)
      assert.is_truthy(message:find("state_spec.lua", 1, true), message)
      assert.are.equal(hash, world:hash())
      assert.are.equal(40, box.x)
    end)
  end

  it("and calls at the wrong moment or on no world are refused", function()
    local world, box = smallWorld()
    local state, messages = world:save(), {}
    box.canCollide = function()
      for _, call in ipairs({ "save", "restore", "hash" }) do
        local _, message = pcall(function()
          world[call](world, state)
        end)
        messages[#messages + 1] = message
      end
    end
    box.y = 80
    for _ = 1, 30 do
      world:update(1 / 60)
    end
    assert.is_truthy(
      messages[1]:find("world:save() cannot be called from inside canCollide", 1, true)
    )
    assert.is_truthy(messages[2]:find("world:restore(state) cannot be called", 1, true))
    assert.is_truthy(messages[3]:find("world:hash() cannot be called", 1, true))
    local _, message = pcall(function()
      world.save()
    end)
    assert.is_truthy(message:find("world:save() must be called with a colon", 1, true))
    _, message = pcall(function()
      world:save(3)
    end)
    assert.is_truthy(message:find("world:save(out): out must be a table, got 3", 1, true))
  end)
end)
