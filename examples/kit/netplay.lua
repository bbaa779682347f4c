-- Plays a game for two over a network, with rollback: only keys are sent. Each side plays on at
-- once and guesses that the other player's keys stay as they were. If a key that arrives differs,
-- the game goes back to its step and plays the steps since then again, unseen.
--
--   local session = netplay.new({ game = game, player = 1, send = send, version = "my game 3" })
--   session:join()               player 2, when it is connected: asks player 1 for the game
--   session:receive(text)        for each message of the other side
--   session:update(dt, keys)     in love.update; keys of the own player: a whole number, 0 to 255
--   session:leave()              when the other side is gone
--
-- `game.world` is the world. `game:step(keys1, keys2)` plays one step of 1/60 s, with what the
-- world saves, both keys and nothing else. `send(text, isReliable)` sends a message, of any bytes.
-- One that is not reliable may get lost, come twice or too late. Needs nothing else, and no LÖVE.
--
-- Player 1 plays alone until the other one joins, and also when that is gone. To join is to get the
-- state: so one may join at any time, and again after the line was cut.

local netplay = {}

local STEP = 1 / 60 -- s
local DELAY = 2 -- steps from a key to what it does: hides a ping of 30 ms without any rollback
local MOST_BACK = 8 -- steps that are played on a guess; then it waits
local CHECK = 30 -- steps from one comparison of hashes to the next
local KEPT = 128 -- steps of which states and keys are kept
local PULL, MOST_PULL = 0.02, 0.1 -- of the clock, for a step that it is ahead; at most
local HEADERS = 40 -- bytes that a message costs beside its own: IP, UDP, enet

local session = {}
session.__index = session

-- Messages ---------------------------------------------------------------------------------------

local function write(parts, value)
  local kind = type(value)
  if kind == "table" then
    parts[#parts + 1] = "{"
    for key, inner in pairs(value) do
      write(parts, key)
      write(parts, inner)
    end
    parts[#parts + 1] = "}"
  elseif kind == "number" then
    local digits = ("n%.17g;"):format(value) -- 17 digits are exact
    parts[#parts + 1] = digits:gsub("inf", "1e999", 1)
  elseif kind == "string" then
    parts[#parts + 1] = ("s%d;%s"):format(#value, value)
  else
    parts[#parts + 1] = value and "t" or "f"
  end
end

--- Returns a text for a table of numbers, strings, booleans and such tables.
function netplay.pack(value)
  local parts = {}
  write(parts, value)
  return table.concat(parts)
end

local function read(text, at, depth)
  local tag = text:sub(at, at)
  if tag == "t" or tag == "f" then
    return tag == "t", at + 1
  elseif tag == "{" and depth < 32 then
    local value = {}
    at = at + 1
    while text:sub(at, at) ~= "}" do
      local key
      key, at = read(text, at, depth + 1)
      value[key], at = read(text, at, depth + 1)
    end
    return value, at + 1
  end
  local digits, after = text:match("^([^;]+);()", at + 1)
  local number = tonumber(digits)
  if tag == "n" and number then
    return number, after
  elseif tag == "s" and number and number >= 0 then
    return text:sub(after, after + number - 1), after + number
  end
  error("cannot be read")
end

--- Returns what a text of `pack` stands for. It runs nothing, so it may come from anywhere. Errors:
--- the text cannot be read.
function netplay.unpack(text)
  return (read(text, 1, 0))
end

local function bytesOf(step)
  return string.char(math.floor(step / 65536) % 256, math.floor(step / 256) % 256, step % 256)
end

local function stepOf(text, at)
  local high, middle, low = text:byte(at, at + 2)
  return (high * 256 + middle) * 256 + low
end

-- Near numbers as a byte.
local function near(number)
  return math.max(-128, math.min(127, math.floor(number + 0.5))) + 128
end

local function send(self, text, isReliable)
  self.bytes = self.bytes + #text + HEADERS
  self.send(text, isReliable)
end

-- A message of a round: between two times of joining. What belongs to an older one is left aside.
local function tell(self, kind, step, text)
  send(self, kind .. string.char(self.round) .. bytesOf(step) .. text, true)
end

-- The game ---------------------------------------------------------------------------------------

-- Step i of the player's keys stands at i % KEPT; up to step known[player] they are no guess.
local function begin(self, start)
  self.now, self.isPlaying, self.dirty, self.isSplit = start, true, nil, false
  self.keys, self.known = { {}, {} }, { start + DELAY - 1, start + DELAY - 1 }
  for i = 0, KEPT - 1 do
    self.keys[1][i], self.keys[2][i] = 0, 0
  end
  self.acknowledged, self.nextCheck = start + DELAY - 1, math.ceil(start / CHECK) * CHECK
  self.hashes, self.theirHashes = {}, {}
  self.left, self.lead, self.myLead, self.silent, self.waited = 0, 0, 0, 0, 0
  self.hasHeard = false
end

local function simulate(self)
  local now, keys, last = self.now, self.keys[self.other], self.known[self.other]
  local i = now % KEPT
  if now > last then
    keys[i] = self.isAlone and 0 or keys[last % KEPT] -- the guess
  end
  self.states[i] = self.game.world:save(self.states[i]) -- fills an old one again: no garbage
  if now % CHECK == 0 then
    self.hashes[now] = self.game.world:hash()
  end
  self.game:step(self.keys[1][i], self.keys[2][i])
  self.now = now + 1
end

-- Goes back to the first step with a wrong guess, and plays the steps since then again.
local function replay(self)
  local now = self.now
  local count = now - self.dirty
  self.game.world:restore(self.states[self.dirty % KEPT])
  self.now, self.dirty = self.dirty, nil
  while self.now < now do
    simulate(self)
  end
  self.replayed, self.counted = count, self.counted + count
  self.stats.mostBack = math.max(self.stats.mostBack, count)
end

-- Code is loaded and compiled when it is used for the first time, and the first rollback would be
-- slow. So some are played at once, with all kinds of keys.
local function rehearse(self)
  local state = self.game.world:save()
  for round = 1, 24 do
    for step = 0, MOST_BACK - 1 do
      self.keys[1][step], self.keys[2][step] = round, round * 3 % 256
      simulate(self)
    end
    self.game.world:hash()
    if round % 4 == 0 then
      self.game.world:restore(state)
    end
    self.now = 0
  end
end

-- One packet tells all keys that the other side has not acknowledged, so a lost one does no harm.
local function sendKeys(self)
  local mine, parts = self.keys[self.player], {}
  for step = self.acknowledged + 1, self.known[self.player] do
    parts[#parts + 1] = string.char(mine[step % KEPT])
  end
  local ack, first = self.now - self.known[self.other], self.now - self.acknowledged - 1
  local head = string.char(self.round) .. bytesOf(self.now)
  head = head .. string.char(near(self.myLead), near(ack), near(first))
  send(self, "K" .. head .. table.concat(parts), false)
  self.silent = 0
end

-- Clocks -----------------------------------------------------------------------------------------

-- Both see the other one as far behind as a message takes. So half of the difference is how far
-- this clock is ahead, in steps, whatever the ping.
local function compareClocks(self, theirNow, theirLead)
  self.myLead = self.now - theirNow
  self.lead = self.lead + ((self.myLead - theirLead) / 2 - self.lead) * 0.05
end

local function acknowledge(self, step)
  if step > self.acknowledged and step <= self.known[self.player] then
    local ping = self.time - self.sentAt[step % KEPT]
    local old = self.stats.ping
    self.stats.ping = old and old + (ping - old) * 0.05 or ping
    self.acknowledged = step
  end
end

-- Hashes -----------------------------------------------------------------------------------------

-- Adds a value, and those in it, to a list of names and a table of values.
local function addValue(name, value, names, values)
  if type(value) == "table" then
    for key, inner in pairs(value) do
      addValue(("%s.%s"):format(name, tostring(key)), inner, names, values)
    end
  elseif type(value) ~= "function" then
    names[#names + 1], values[name] = name, value
  end
end

-- Returns the fields of all objects in a state, "players[1].x" -> 30, and their names in order.
local function fieldsOf(world, state)
  local names, values, isOwn = {}, {}, {}
  for _, field in ipairs(world.ownFields or {}) do
    isOwn[field] = true
  end
  world:restore(state)
  for group, objects in pairs(world.objects) do
    for key, object in pairs(objects) do
      for field, value in pairs(object) do
        if isOwn[field] or type(value) ~= "table" then -- other tables are of the library
          addValue(("%s[%s].%s"):format(group, key, tostring(field)), value, names, values)
        end
      end
    end
  end
  table.sort(names)
  return values, names
end

local function exactly(value)
  return type(value) == "number" and ("%.17g"):format(value) or tostring(value)
end

--- Returns a sentence about the first field that two states of a world give different values.
function netplay.difference(world, mine, theirs)
  local now = world:save()
  local here, names = fieldsOf(world, mine)
  local there, others = fieldsOf(world, theirs)
  world:restore(now)
  for _, list in ipairs({ names, others }) do
    for _, name in ipairs(list) do
      local a, b = here[name], there[name]
      if a ~= b then
        return ("%s is %s here and %s there"):format(name, exactly(a), exactly(b))
      end
    end
  end
  return "the fields are equal, but contacts or settings differ"
end

-- Both hashes of a step are there: if they differ, each side sends its state, to be told apart.
local function compareHashes(self, step)
  local mine, theirs = self.hashes[step], self.theirHashes[step]
  if step >= self.nextCheck or not (mine and theirs) then
    return
  end
  self.hashes[step], self.theirHashes[step] = nil, nil
  if mine == theirs then
    self.stats.equal = self.stats.equal + 1
  elseif not self.isSplit then
    self.isSplit = true
    tell(self, "D", step, netplay.pack(self.states[step % KEPT]))
  end
  if self.onHash then
    self.onHash(step, mine, theirs)
  end
end

-- A hash counts when all keys before its step are known.
local function checkHash(self)
  local step = self.nextCheck
  if step < self.now and step <= self.known[self.other] + 1 then
    self.nextCheck = step + CHECK
    if self.isAlone then
      self.hashes[step] = nil
    else
      tell(self, "H", step, ("%.17g"):format(self.hashes[step]))
      compareHashes(self, step)
    end
  end
end

-- What comes in ----------------------------------------------------------------------------------

local readers = {}

function readers.K(self, text)
  if #text < 8 then
    return
  end
  self.hasHeard = true
  local now = stepOf(text, 3)
  local lead, ack, first = text:byte(6, 8)
  compareClocks(self, now, lead - 128)
  acknowledge(self, now - (ack - 128))
  first = now - (first - 128)
  local keys, known = self.keys[self.other], self.known
  for at = 9, #text do
    local step, key = first + at - 9, text:byte(at)
    if step == known[self.other] + 1 and step < self.now + KEPT / 2 then
      if step < self.now and keys[step % KEPT] ~= key and not self.dirty then
        self.dirty = step
      end
      keys[step % KEPT], known[self.other] = key, step
    end
  end
end

function readers.H(self, text)
  local step = stepOf(text, 3)
  self.theirHashes[step] = tonumber(text:sub(6))
  compareHashes(self, step)
end

function readers.D(self, text)
  local step = stepOf(text, 3)
  local mine = self.states[step % KEPT]
  local difference = netplay.difference(self.game.world, mine, netplay.unpack(text:sub(6)))
  self.stats.desync = ("step %d: %s"):format(step, difference)
  if self.player == 2 then
    self:join() -- the state of player 1 counts
  end
end

-- Player 2 wants to join.
function readers.J(self, text)
  if text:sub(2) ~= self.version then
    return send(self, "N" .. self.version, true)
  end
  self.round, self.isAlone = (self.round + 1) % 256, false
  begin(self, self.now)
  tell(self, "S", self.now, netplay.pack(self.game.world:save()))
end

-- The state to begin with.
function readers.S(self, text)
  local misfit = self.game.world:restore(netplay.unpack(text:sub(6)))
  self.stats.problem = misfit
  self.round = text:byte(2)
  begin(self, stepOf(text, 3))
end

function readers.N(self, text)
  self.stats.problem = ("here is %s, there is %s"):format(self.version, text:sub(2))
end

local OF_ROUND = { K = true, H = true, D = true }
local ONLY = { J = 1, S = 2, N = 2 } -- the player that may get it

--- Takes in a message of the other side. What is damaged, or of an older round, is left aside.
function session:receive(text)
  local kind = text:sub(1, 1)
  local isOurs = OF_ROUND[kind]
    and self.isPlaying
    and not self.isAlone
    and text:byte(2) == self.round
  if isOurs and #text >= 5 or ONLY[kind] == self.player then
    local isRead, problem = pcall(readers[kind], self, text)
    if not isRead then
      self.stats.problem = ("a message %s: %s"):format(kind, problem)
    end
  end
end

-- For the game -----------------------------------------------------------------------------------

--- Returns a session. `options`: game, player (1 or 2), send, and version: a text that must be the
--- same on both sides. In `session.stats` are ping (s), back (steps a second), mostBack (steps),
--- bytes (a second), longestWait (s), equal (hashes), desync and problem (sentences). If you set
--- session.onHash(step, mine, theirs), it is called for each comparison.
function netplay.new(options)
  local self = setmetatable({}, session)
  self.game, self.player, self.send = options.game, options.player, options.send
  self.other, self.version = 3 - options.player, options.version
  self.round, self.time, self.states, self.sentAt = 0, 0, {}, {}
  self.bytes, self.counted, self.since = 0, 0, 0
  self.stats = { back = 0, mostBack = 0, bytes = 0, longestWait = 0, equal = 0 }
  begin(self, 0)
  rehearse(self)
  begin(self, 0)
  self.isAlone, self.isPlaying = true, self.player == 1
  return self
end

--- Asks player 1 for the state. To be called when player 2 is connected.
function session:join()
  self.isPlaying, self.isAlone = false, false
  send(self, "J" .. self.version, true)
end

--- The other side is gone: player 1 plays on alone, player 2 waits until it has joined again.
function session:leave()
  self.isAlone, self.isPlaying, self.stats.ping = true, self.player == 1, nil
end

-- Once a second: what is a number a second.
local function count(self, dt)
  self.since = self.since + dt
  if self.since >= 1 then
    self.stats.bytes, self.stats.back = self.bytes / self.since, self.counted / self.since
    self.since, self.bytes, self.counted = 0, 0, 0
  end
end

-- Is the other side too far behind to go on? The time that passes meanwhile is lost.
local function mustWait(self, dt)
  if self.isAlone or self.now - self.known[self.other] <= MOST_BACK then
    return false
  end
  self.left, self.waited = STEP, self.waited + (self.hasHeard and dt or 0)
  self.stats.longestWait = math.max(self.stats.longestWait, self.waited)
  return true
end

--- Plays the steps that are due after `dt` s. `keys`: those of the own player, which count two
--- steps later. Returns how many new steps there were.
function session:update(dt, keys)
  self.time, self.replayed = self.time + dt, 0
  count(self, dt)
  if not self.isPlaying then
    return 0
  elseif self.dirty then
    replay(self)
  end
  local pull = self.isAlone and 0 or math.max(-MOST_PULL, math.min(MOST_PULL, self.lead * PULL))
  self.left = math.min(self.left + dt * (1 - pull), 4 * STEP)
  local steps = 0
  while self.left >= STEP and not mustWait(self, steps == 0 and dt or 0) do
    local step = self.now + DELAY
    self.keys[self.player][step % KEPT], self.known[self.player] = keys, step
    self.sentAt[step % KEPT] = self.time
    self.left, self.waited, steps = self.left - STEP, 0, steps + 1
    simulate(self)
    if self.isAlone then
      self.known[self.other] = self.now - 1
    end
  end
  self.silent = self.silent + dt
  if not self.isAlone and (steps > 0 or self.silent > 2 * STEP) then
    sendKeys(self)
  end
  checkHash(self)
  return steps
end

return netplay
