--- The example Online: football for two, with rollback over a line that delays and loses messages,
--- both sides in one process. Two real processes play in `make test-online`.

-- (The examples require each other by their bare names.)
local path = package.path
package.path = path .. ";./examples/?.lua"
local football, line, netplay = require("football"), require("kit.line"), require("kit.netplay")
package.path = path

local FRAME = 1 / 60

-- Two sessions with a line between them. `match.play(frames)` plays with keys at random;
-- `match.keys[player]`, if there, are held instead.
local function newMatch(ping, loss, version)
  local match = { lines = {}, keys = {} }
  math.randomseed(7)
  for player = 1, 2 do
    match.lines[player] = line.to(function(text)
      if not match.isCut then
        match[3 - player]:receive(text)
      end
    end)
    match.lines[player].ping, match.lines[player].loss = ping, loss
    match[player] = netplay.new({
      game = football.new(),
      player = player,
      version = player == 2 and version or "1",
      send = function(text, isReliable)
        match.lines[player]:send(text, isReliable)
      end,
    })
  end
  local held = { 0, 0 }
  function match.play(frames, dt1, dt2)
    for _ = 1, frames do
      for player = 1, 2 do
        local dt = player == 1 and dt1 or dt2 or FRAME
        held[player] = math.random() < 0.1 and math.random(0, 7) or held[player]
        match.lines[player]:update(dt)
        match[player]:update(dt, match.keys[player] or held[player])
      end
    end
  end
  return match
end

-- The hash of a step that both have played with all keys of both.
local function settledHash(session, step)
  local now = session.game.world:save()
  session.game.world:restore(session.states[step % 128])
  local hash = session.game.world:hash()
  session.game.world:restore(now)
  return hash
end

describe("examples/online.lua: two that play", function()
  -- ping in s, loss, and what is expected: most steps back, longest wait in s
  local ROWS = {
    { 0, 0, 1, 0 },
    { 0.06, 0.02, 6, 0 },
    { 0.15, 0.1, 8, 0.15 },
    { 0.3, 0.2, 8, 0.3 },
  }
  for _, row in ipairs(ROWS) do
    local ping, loss, mostBack, longestWait = row[1], row[2], row[3], row[4]
    it(("over %d ms, %d %% lost, have the same game"):format(ping * 1000, loss * 100), function()
      local match = newMatch(ping, loss)
      match.play(70) -- the first one is alone
      match[2]:join()
      match.play(360)
      match.keys = { 0, 0 }
      match.play(60)
      local step = math.min(match[1].now, match[2].now) - 20
      assert.equal(settledHash(match[1], step), settledHash(match[2], step))
      for player = 1, 2 do
        local stats = match[player].stats
        assert.is_nil(stats.desync or stats.problem)
        assert.is_true(stats.equal >= 9, stats.equal)
        assert.is_true(stats.mostBack <= mostBack, stats.mostBack)
        assert.is_true(stats.longestWait <= longestWait, stats.longestWait)
        assert.is_true(stats.bytes < 4000 or ping > 0.15, stats.bytes)
      end
      assert.near(match[1].now, match[2].now, 2)
    end)
  end
end)

describe("examples/online.lua: a player", function()
  it("sees its own key after two steps, and the other's in the same step of the game", function()
    local match = newMatch(0.15, 0)
    match[2]:join()
    match.keys = { 0, 0 }
    match.play(60)
    local own, copy = match[1].game.players[1], match[2].game.players[1]
    match.keys[1] = 2
    local first
    for frame = 1, 12 do
      match.play(1)
      first = first or own.vx > 0 and frame
      assert.is_true(copy.vx == 0 or frame > 4)
    end
    assert.near(3, first, 1) -- (the clocks are being brought together)
    match.play(30)
    assert.equal(280, copy.vx)
    assert.near(own.x, copy.x, 280 * 0.1)
  end)

  it("waits after eight steps without the other one, and goes on alone when that leaves", function()
    local match = newMatch(0, 0)
    match[2]:join()
    match.play(60)
    match.isCut = true
    local now = match[1].now
    match.play(60)
    assert.near(now + 11, match[1].now, 2) -- two steps of delay, then eight on a guess
    match[1]:leave()
    match[2]:leave()
    now = match[1].now
    match.play(60)
    assert.near(now + 60, match[1].now, 1)
    assert.is_false(match[2].isPlaying)
  end)

  it("of another version is told so", function()
    local match = newMatch(0, 0, "2")
    match[2]:join()
    match.play(10)
    assert.same({ "here is 2, there is 1", false }, { match[2].stats.problem, match[2].isPlaying })
    assert.is_true(match[1].isAlone)
  end)
end)

it("examples/online.lua: both name the first field that differs; one state mends", function()
  local match = newMatch(0.06, 0.02)
  match[2]:join()
  match.play(100)
  match[2].game.players[1].goals = 5
  match.play(60)
  local pattern = "^step 120: players%[1%]%.goals is (%d+) here and (%d+) there$"
  local mine, theirs = match[1].stats.desync:match(pattern)
  assert.equal("0 5", mine .. " " .. theirs)
  mine, theirs = match[2].stats.desync:match(pattern)
  assert.same({ "5 0", 0 }, { mine .. " " .. theirs, match[2].game.players[1].goals })
  local equal = match[2].stats.equal
  match.play(200)
  assert.is_true(match[2].stats.equal >= equal + 4)
end)

it("examples/kit/netplay.lua: a difference is found in tables of the game's own, too", function()
  local world = football.new().world
  world.ownFields = { "hero" }
  world.objects.players[2].hero = { mood = "air", timers = { dash = 1 } }
  local mine = world:save()
  world.objects.players[2].hero.timers.dash = 2
  local theirs = world:save()
  local sentence = netplay.difference(world, mine, theirs)
  assert.equal("players[2].hero.timers.dash is 1 here and 2 there", sentence)
  assert.equal(2, world.objects.players[2].hero.timers.dash)
  sentence = netplay.difference(world, mine, mine)
  assert.equal("the fields are equal, but contacts or settings differ", sentence)
end)

describe("examples/kit/netplay.lua: a message", function()
  it("holds every value exactly", function()
    local value = { 0.1, 1 / 3, -1e300, math.huge, "a;}", "", true, { [2.5] = false, x = { {} } } }
    assert.same(value, netplay.unpack(netplay.pack(value)))
    assert.has_error(function()
      netplay.unpack("{s-4;ttt}")
    end)
  end)

  it("that is reliable comes once, and in order; another one may get lost", function()
    local got = {}
    local wire = line.to(function(text)
      got[#got + 1] = text
    end)
    wire.ping, wire.loss = 0.2, 0.3
    for i = 1, 200 do
      wire:send(("%03d"):format(i), true)
      wire:send("x", false)
      wire:update(FRAME)
    end
    wire:update(9)
    local reliable = table.concat(got):gsub("x", "")
    assert.equal(600, #reliable)
    for i = 1, 200 do
      assert.equal(("%03d"):format(i), reliable:sub(3 * i - 2, 3 * i))
    end
    assert.near(340, #got, 40)
  end)

  it("that is damaged changes nothing, and stops nothing", function()
    local match = newMatch(0, 0)
    match[2]:join()
    match.play(60)
    local texts = {}
    for player = 1, 2 do
      match[player].send = function(text)
        texts[#texts + 1] = text
      end
    end
    match.play(40)
    texts[#texts + 1] = "S\1\0\0\0" .. netplay.pack(match[1].game.world:save())
    local hashes = { match[1].game.world:hash(), match[2].game.world:hash() }
    for i = 1, 300 do
      local text = texts[i % #texts + 1]
      local at = math.random(1, math.min(#text, 40))
      local cut = text:sub(1, at - 1) .. (i % 3 > 0 and string.char(math.random(0, 255)) or "")
      if cut:sub(1, 1) ~= "K" then -- (with other keys it is a message, too)
        match[1]:receive(cut)
        match[2]:receive(i % 2 == 0 and cut or cut .. text:sub(at + 1, -2))
      end
    end
    assert.same(hashes, { match[1].game.world:hash(), match[2].game.world:hash() })
  end)
end)
