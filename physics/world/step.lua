--- The stages of a step, in their order, and how many steps an update makes.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local begin = require(root .. ".motion.begin")
local carrier = require(root .. ".objects.carriers")
local columns = require(root .. ".memory.columns")
local crowd = require(root .. ".solver.crowd")
local crowdLayout = require(root .. ".solver.crowdLayout")
local crush = require(root .. ".solver.crush")
local detect = require(root .. ".broadphase.pairFinder")
local drift = require(root .. ".motion.drift")
local events = require(root .. ".contacts.events")
local flight = require(root .. ".motion.flight")
local knots = require(root .. ".solver.knots")
local lazy = require(root .. ".memory.lazy")
local notice = require(root .. ".queries.notice")
local predict = require(root .. ".motion.predict")
local read = require(root .. ".objects.read")
local rest = require(root .. ".sleep.islands")
local separate = require(root .. ".solver.separate")
local settings = require(root .. ".world.settings")
local solver = require(root .. ".solver.solver")
local write = require(root .. ".objects.write")
local zones = require(root .. ".motion.zones")

local guard = lazy(root .. ".world.strictMode") -- loaded when it is first used

local steps = {}

local ceil, floor, max, min = math.ceil, math.floor, math.max, math.min

-- Longest time that one update simulates, s.
local LONGEST = 0.25
-- Fraction of a fixed step that may be missing through rounding.
local ROUNDING = 1e-9

-- Notes how long a stage has taken, if there is a clock. Returns the time now.
local function time(self, name, since)
  local times = self.stats.times
  if not times then
    return 0
  end
  local now = self.profile()
  now = type(now) == "number" and now or since
  times[name] = now - since
  return now
end

-- Calls `onStep`, which may do anything but make a step.
local function tellStep(self, dt)
  local b = self._bodies
  settings.apply(self) -- a callback may have put a value into `onStep` that cannot be called
  b.isTold = true
  local ok, result = pcall(self.onStep, dt)
  b.isTold = false
  if not ok then
    error(result, 0)
  end
end

-- Reads the game's tables before a step of dt s. Returns the time now.
local function look(self, dt)
  if self.onStep then
    tellStep(self, dt)
  end
  local b = self._bodies
  settings.apply(self)
  local now = time(self, "write", 0)
  read.run(b, self.objects)
  if self.checked then
    guard.run(self)
  end
  carrier.dismount(b)
  if dt < rest.SHORTEST then
    rest.wakeAll(b)
  end
  return time(self, "read", now)
end

-- Makes one step of dt seconds, stage by stage. The caller calls the callbacks afterwards, once
-- the step's time is subtracted.
local function step(self, dt)
  local b, now = self._bodies, look(self, dt)
  b.begun, b.predicted, b.rubs, b.dt = 0, 0, 0, dt
  begin.run(b)
  crowd.mark(b)
  detect.runMoved(b)
  knots.run(b)
  zones.begin(b, b.awakeList, b.awakeCount)
  crowdLayout.run(b)
  crush.wedgeGrown(b)
  separate.run(b)
  drift.run(b, dt)
  flight.begin(b, dt)
  now = time(self, "separate", now)
  predict.run(b, dt) -- forces, move
  now = time(self, "move", now)
  solver.run(b, dt) -- contacts, settle, friction, then sweep and hit
  drift.takeOff(b)
  now = time(self, "solve", now)
  write.run(b)
  flight.finish(b, dt)
  if b.rest then
    rest.settle(b, dt)
  end
  columns.shrink(b)
  notice.outdate(b)
  time(self, "write", now)

  local stats = self.stats
  stats.objects, stats.movers = b.count, b.moverCount
  stats.resting = b.moverCount - b.awakeCount - b.flyerCount
  stats.pairs, stats.contacts, stats.events = b.pairCount, b.contactCount, b.resolved
end

-- Makes steps of equal length, at most `maxStep` long.
local function split(self, dt)
  local count = max(1, ceil(dt / self.maxStep - ROUNDING))
  write.forgetHits(self._bodies)
  for remaining = count, 1, -1 do
    self._bodies.remaining = remaining
    step(self, dt / count)
    events.tell(self._bodies)
  end
end

-- Makes as many fixed steps as fit into the saved time. A refused step uses up no time, and none of
-- a refused dt is saved. Time that an update with an error has left counts in this one.
local function stepFixed(self, dt)
  local timestep = self.timestep
  if self._saved >= timestep * (1 - ROUNDING) then
    dt = max(0, min(dt, LONGEST - self._saved))
  end
  self._bodies.remaining = max(1, floor((self._saved + dt) / timestep + ROUNDING))
  if self._saved + dt >= timestep * (1 - ROUNDING) then
    write.forgetHits(self._bodies)
  end
  while self._saved + dt >= timestep * (1 - ROUNDING) do
    begin.keepPlaces(self._bodies)
    step(self, timestep)
    self._saved, dt = self._saved + dt - timestep, 0
    self._bodies.remaining = max(1, self._bodies.remaining - 1)
    events.tell(self._bodies)
  end
  self._saved = self._saved + dt
  local alpha = self._saved / timestep
  self.alpha = alpha > 0 and alpha or 0
end

--- Makes the steps of an update of dt s.
function steps.run(self, dt)
  dt = dt < LONGEST and dt or LONGEST
  settings.apply(self)
  if self.timestep then
    stepFixed(self, dt)
  else
    split(self, dt)
  end
end

return steps
