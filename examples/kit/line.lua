-- A line to one other player over the network that LÖVE brings (enet). It can be as bad as you
-- like, so that you can try your game on one machine: `ping` and `loss` are made by the sender.
--
--   local line = line.host("*:22122")        or line.join("192.168.1.5:22122")
--   line:send(text, isReliable)
--   line:update(dt, on)                      on.connect(), on.receive(text), on.disconnect()
--   line.ping, line.loss = 0.15, 0.1         s there and back; share of what gets lost
--
-- `line.to(receive)` ends in a function of the same process: for demonstrations and specs.

---@class kit.Line
---@field [string] any
local line = {}
line.__index = line

local JITTER = 0.1 -- share of the ping by which messages are faster or slower
local GONE = 3000 -- ms without an answer after which the other side is gone
local AGAIN = 1 -- s until it is called again

local function new(deliver)
  local self = { ping = 0, loss = 0, time = 0, waiting = {}, last = 0, deliver = deliver }
  return setmetatable(self, line)
end

-- What is sent reliably is not lost, but sent again: it comes later, and what follows it, too.
local function delayOf(self, isReliable)
  local delay = self.ping / 2 * (1 - JITTER + 2 * JITTER * math.random())
  while math.random() < self.loss do
    if not isReliable then
      return nil
    end
    delay = delay + self.ping + 0.05
  end
  return delay
end

--- Sends a message to the other side, if there is one.
function line:send(text, isReliable)
  local delay = delayOf(self, isReliable)
  if delay then
    local due = self.time + delay
    if isReliable then
      due = math.max(due, self.last)
      self.last = due
    end
    table.insert(self.waiting, { due = due, text = text, isReliable = isReliable })
  end
end

-- Sends off what is due, in order.
local function flush(self)
  local i = 1
  while i <= #self.waiting do
    local message = self.waiting[i]
    if message.due <= self.time then
      table.remove(self.waiting, i)
      self.deliver(message.text, message.isReliable)
    else
      i = i + 1
    end
  end
end

-- Takes in what has come.
local function serve(self, on)
  local event = self.enet:service()
  while event do
    if event.type == "connect" then
      self.peer, self.called = event.peer, nil
      event.peer:timeout(32, GONE, GONE)
      event.peer:throttle_configure(5000, 2, 0) -- else enet drops packets when the ping changes
      on.connect()
    elseif event.type == "receive" then
      on.receive(event.data)
    elseif event.peer == self.peer then
      self.peer, self.waiting = nil, {}
      on.disconnect()
    else
      self.called = nil -- there was no answer
    end
    event = self.enet:service()
  end
end

local function call(self)
  if self.address and not self.peer and not self.called and self.time >= self.callAt then
    self.called = self.enet:connect(self.address)
    self.called:timeout(32, GONE, GONE)
    self.callAt = self.time + AGAIN
  end
end

--- To be called in every frame, before the game is played.
function line:update(dt, on)
  self.time = self.time + dt
  if self.enet then
    call(self)
    serve(self, on)
  end
  flush(self)
end

--- Ends it at once; the other side is told.
function line:close()
  if self.peer then
    self.peer:disconnect_now()
  end
  self.enet:destroy()
end

local function open(address)
  local self ---@type table
  self = new(function(text, isReliable)
    if self.peer then
      self.peer:send(text, 0, isReliable and "reliable" or "unreliable")
      self.enet:flush() -- now, not in the next frame
    end
  end)
  ---@diagnostic disable-next-line: unresolved-require
  self.enet = require("enet").host_create(address, 1)
  return self.enet and self or error("cannot open " .. tostring(address))
end

--- Returns a line to the player that joins. `address`: of this machine, "*:22122" for all networks
--- that it is in. Errors: the port is taken.
function line.host(address)
  return open(address)
end

--- Returns a line to the player that hosts. It calls until there is an answer.
function line.join(address)
  local self = open(nil)
  self.address, self.callAt = address, 0
  return self
end

--- Returns a line to a function of this process.
function line.to(receive)
  return new(receive)
end

return line
