--- What a world keeps besides its columns: counts, skip hints, lists and scratch memory.

-- Adds the counts and free lists of slots and pairs.
local function addObjects(b)
  b.slots = 0 -- highest slot ever used
  b.blankTo = 0 -- highest slot that is in use or prepared
  b.free = {} -- slots to use again
  b.freeCount = 0
  b.freeSeen = 0 -- freeCount when `shrink` last looked
  b.count = 0 -- objects in the world
  b.slotOf = {} -- object -> slot
  b.pairSlots = 0
  b.freePairs = {}
  b.freePairCount = 0
  b.endedPairs = {} -- not free yet
  b.endedPairCount = 0
  b.pairCount = 0
  b.links = 0 -- how often the pairs have changed
  b.staticVersion = 0 -- how often static objects have come, gone, or been read again
  b.contactCount = 0
  b.linkOne = {} -- objects that are about to be linked
  b.linkOther = {}
  b.linked = {} -- their pairs
  b.parted = {} -- pairs that are about to be unlinked
end

-- Adds skip hints: true once an object of the world has had the feature. They change no result.
local function addFlags(b)
  b.hasCarriers = false -- an object has been a carrier
  b.hasFriction = false -- or had friction
  b.hasNudges = false -- or had `nudge`
  b.hasSnaps = false -- or had `snap`
  b.hasHinders = false -- or had drag or a maxSpeed
  b.hasLimits = false -- or had a limit of any kind
  b.hasBounces = false -- or had restitution
  b.hasAskers = false -- or had a canCollide
  b.hasOneWays = false -- or was one-way
  b.hasSensors = false -- or was a sensor
  b.hasCircles = false -- or was a circle
  b.hasZones = false -- or had an area
  b.hasTurns = false -- or one with a gravity of its own
  b.hasFirm = false -- or was not pushable
  b.hasCrushed = false -- or was crushed
  b.hasInside = false -- or was left inside another one
  b.hasBuried = false -- or was buried
  b.hasKnots = false -- or was in a knot
  b.knot = {} -- by slot: a slot of the same knot, nearer to the one that leads it
  b.knotSum = {} -- by leader: sum of the overlaps, px
  b.knotStates = {} -- by leader: what is known of the knot in this step
  b.knotList = {}
  b.looseList = {} -- scratch of knots
  b.hasCrowds = false -- or was in a crowd
end

-- Adds the state of reading: the game's changes, carriers, queries.
local function addReading(b)
  b.isRemasked = false -- masks have changed: objects may overlap that could not meet before
  b.zoneList = {} -- slots with an area, in order when a step has begun
  b.nearBody = {} -- scratch of zones
  b.nearZone = {}
  b.hitLists = {} -- the different lists of `hits` (see filter)
  b.soft = false -- px/s, by two group names: how fast two that overlap drift apart
  b.drifts = { driftedCount = 0 } -- what is soft (see softDrift)
  b.maskCopy = false -- the last copy made of a static object's mask (see filter)
  b.halfRead = {} -- objects that are being read anew (see read)
  b.lost = {} -- slots that have lost their carrier since the last step
  b.lostCount = 0
  b.movedList = {}
  b.movedCount = 0
  b.stack = {} -- scratch of carriers
  b.view = false -- the columns of the queries (see queries/index.lua)
  b.fixed = false -- what static objects have in their fields (see state/save)
  b.snaps = false -- scratch of snap
  b.unasked = { pairs = {}, sides = {}, first = {}, second = {}, order = {} } -- of contactState
end

-- Adds the state of the broad phase and of sleep: which bodies and pairs take part in a step.
local function addAwake(b)
  b.moverCount = 0
  b.awakeCount = 0
  b.flyerCount = 0
  b.island = {} -- scratch of islands
  b.awakenings = 0 -- how often the set of awake objects has changed
  b.liveCount = 0
  b.liveLinks = -1 -- `links` and `awakenings` when `live` was last listed
  b.liveAwakenings = -1
  b.stained = {} -- pairs with more to reset than others (see activePairs)
  b.stainCount = 0
  b.askers = {}
  b.present = {}
  b.strays = {}
  b.aimed = {}
  b.found = {} -- scratch of pairFinder, crowd, nudge and separate
  b.stamp = 0
  b.remaining = 1 -- steps that are left in this update
  b.begun = 0 -- places of awakeList that have begun this step
  b.predicted = 0 -- places of awakeList that have a path
end

-- Adds the scratch memory of crowds and of separate.
local function addCrowds(b)
  b.crowdCount = 0 -- bodies in crowds in this step
  b.crowdList = {} -- scratch of crowd
  b.crowdKey = {}
  b.crowdStamp = 0
  b.crowdNew = {}
  b.stoodAt = {}
  b.crowdMark = {}
  b.isOverlapped = {}
  b.crowdColumn = {}
  b.columnWidth = {}
  b.shared = {}
  b.leader = {}
  b.leaderRank = {}
  b.heapCount = 0
  b.heapWork = {
    stamp = 0,
    joined = {}, -- by slot: the stamp when it joined
    pushed = {}, -- by slot: the stamp when it was last pushed
    members = {}, -- slots
    count = 0,
    listed = {}, -- by pair: the stamp when it was listed
    pairs = {},
    pairCount = 0,
    height = {}, -- by slot
    x = {}, -- where it was when its pairs were listed
    y = {},
    one = {}, -- by pair: its bodies, in the order of the world
    other = {},
    upper = {}, -- by pair: sort keys
    lower = {},
    first = {},
    second = {},
  }
  b.partWork = {
    round = 0,
    far = 1e18, -- larger than the depth of any overlap
    count = 0,
    movedCount = 0,
    stamp = {},
    seen = {},
    isCrowded = {},
    pairs = {},
    depth = {},
    first = {},
    second = {},
    moved = {},
    ways = {},
  }
end

-- Adds the state of the solver.
local function addSolver(b)
  b.step = 0 -- number of steps made
  b.dt = 0 -- length of the current step, s
  b.resolved = 0 -- impacts of the last step
  b.rubs = 0 -- 1: friction has carried or braked something in this step
  b.apartCount = 0
  b.sweptStamp = 0
  b.changed = {} -- bodies with new paths
  b.changedCount = 0
  b.bounced = {} -- bodies that may have bounced in this round
  b.bouncedCount = 0
  b.isChangeListed = false -- all new paths are in this list
  b.seenCount = 0
  b.overlapCount = 0
  b.roundCount = 0
  b.isViolated = false
  b.isTorn = false -- two members of one block overlap
  b.mayRestart = true -- the step may begin anew
  b.isJammed = false -- two bodies that cannot move have had an impact
  b.members = {} -- of blocks
  b.memberCount = 0
  b.kinkAt = {}
  b.kinkGrip = {}
  b.kinkNext = {}
  b.kinkCount = 0
  b.pulled = {} -- bodies on which friction and limits act
  b.pulledCount = 0
  b.forceStamp = 0
  b.roundStamp = 0
  b.solveStamp = 0
end

-- Adds what walking over slopes needs (see walk).
local function addSlopes(b)
  b.hasSlopes = false -- a slope was ever in the world
  b.steep = { [0] = 0, 0 } -- by axis: the most that any slope has ever risen along it, px for 1 px
  -- scratch
  b.ground = { slot = {}, turn = {}, count = 0, turns = 0, isLevel = true } -- see ground
  b.walkers, b.isFirstWalk, b.walkStamp = {}, false, 0
  b.hasWalked = false -- a slope has moved something in this pass of walk
  b.walkFrom = {} -- by slot: what it stood on where its way begins,
  b.walkTime = {} -- and when
  b.walkOn = {} -- by slot: what it has come to stand on
  b.walkAt = {} -- by index: when it walked
  b.pieceCount = 0
  b.piecePlace = {} -- across gravity,
  b.pieceHeight = {} -- and along it
  b.liftOf = {} -- by index: px that walk has moved it by,
  b.liftMark = {} -- and when
  b.room = {} -- by index: how far it can be moved against gravity
  b.roof = {} -- by index: a slope above it
  b.blocked = {} -- what a slope has pressed against a ceiling: side and slope, in turns
  b.blockedCount = 0
end

--- Adds all this to a new world.
return function(b)
  addObjects(b)
  addFlags(b)
  addReading(b)
  addAwake(b)
  addCrowds(b)
  addSolver(b)
  addSlopes(b)
end
