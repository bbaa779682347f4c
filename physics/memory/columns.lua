--- The memory of a world: one array ("column") per property, one index ("slot") per object.
--
-- Every stage of a step reads and writes these columns and nothing else. The game's tables are read
-- in objects/read.lua and written in objects/write.lua. Columns with a value for each axis are
-- interleaved: `column[2 * slot]` is x and `column[2 * slot + 1]` is y, so that one function serves
-- both axes. Pairs of neighbours have columns of their own. Each pair is in the lists of both of
-- its objects by two half-edges (`2 * pair - 1` and `2 * pair`).
--
-- No column is shared between worlds: a callback may step another world.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columnStore = require(root .. ".memory.columnStore")
local interpreted = require(root .. ".memory.jit")

local columns = {}

columns.STATIC, columns.KINEMATIC, columns.DYNAMIC = 1, 2, 3

--- Values of `shape`: a box; a circle that fills its box.
columns.SHAPE_BOX, columns.SHAPE_CIRCLE = 0, 1

--- By kind: 1 for a dynamic object, else 0, as a factor instead of a branch. (0 is an empty slot.)
columns.GIVES = { [0] = 0, [columns.STATIC] = 0, [columns.KINEMATIC] = 0, [columns.DYNAMIC] = 1 }

--- Returns the kind that an object's fields say. `kinematic` is read again in each step, `static`
--- is not.
---@param object physics.Object
---@param isStatic boolean? whether it is static; nil: as its field says
---@return integer
function columns.kindOf(object, isStatic)
  if isStatic == nil then
    isStatic = object.static or false
  end
  return isStatic and columns.STATIC or object.kinematic and columns.KINEMATIC or columns.DYNAMIC
end

--- Values of the column `shape`. Slopes are named after their high side, `TOP` those that hang.
columns.SHAPE_BOX, columns.SHAPE_CIRCLE = 0, 1
columns.SHAPE_SLOPE_LEFT, columns.SHAPE_SLOPE_RIGHT = 2, 3
columns.SHAPE_SLOPE_TOPLEFT, columns.SHAPE_SLOPE_TOPRIGHT = 4, 5

--- Shapes by the field `slope`, and that field by shape.
columns.SLOPES = { left = 2, right = 3, topleft = 4, topright = 5 }
columns.SLOPE_NAMES = { [2] = "left", [3] = "right", [4] = "topleft", [5] = "topright" }

--- How far apart two edges may be and still count as touching, px.
columns.EPSILON = 1e-6
--- Widths of common edges are rounded to 1 / WIDTHS px before they are compared: that two are equal
--- does not depend on which of them is looked at first.
columns.WIDTHS = 2 ^ 20

--- Makes any difference of two numbers around EPSILON more than 1. So `min(max(d * VAST, 0), 1)` is
--- 1 for d > 0 and 0 for d <= 0, and `min(max(d * VAST + 1, 0), 1)` is 1 for d >= 0 and 0 for d <
--- 0. These stand for branches in measured loops: each branch direction but the one compiled first
--- costs 40 ns more.
columns.VAST = 1e300

--- Is added to lengths before a division, so that 0 / 0 cannot arise. It changes no other length.
columns.TINY = 1e-300

--- A number larger than the rank of any object.
columns.RANKS = 2 ^ 40

--- Value of `touchTold` at the first side of an object with a `touching` that must be written
--- again.
columns.UNTOLD = -1

local HUGE = math.huge
local floor, max, min = math.floor, math.max, math.min
-- Slots are prepared ahead: one for each so many that are in use.
local AHEAD = 8
-- Slots are given back if there are more than FEW, and at most one of SHARE is needed.
local FEW, SHARE = 64, 4

-- Values of a fresh slot, in columns of numbers and booleans.
local SLOT = {
  -- identity
  rank = 0, -- place in the order of the world
  kind = 0,
  plain = false, -- is not a sensor
  even = false, -- is neither a sensor nor one-way, and has no onStay
  bare = false, -- is dynamic, and had none of the rare fields when it was last read, but for
  -- `sensor` and `hits`
  -- fields of the object, defaults filled in
  active = true,
  sensor = false,
  pushable = true,
  strength = 0,
  power = 0, -- that, or infinite if it is not pushable
  mass = 1,
  inverseMass = 0,
  friction = -1, -- -1: not set
  restitution = 0,
  airFriction = 0,
  drag = 0,
  zoneAir = 0, -- the same two with what zones add to them (see zones)
  zoneDrag = 0,
  maxSpeed = HUGE,
  carry = true,
  surfaceSpeed = 0,
  nudge = 0,
  snap = 0,
  maxFallSpeed = HUGE,
  isFree = true, -- has neither air friction nor limits along an axis
  constantSpeed = false,
  shape = 0, -- SHAPE_BOX and so on
  -- sleep
  awake = false,
  awakeAt = 0, -- place in awakeList
  quiet = false, -- its last step changed nothing
  heard = false, -- onStay or canCollide must be called for its contacts at every step
  visited = 0,
  flying = false, -- near nothing: moves like a point (see flight)
  -- the step
  moved = false, -- placed, resized or filtered anew by the game: its overlaps must be separated
  inside = false, -- the last step left it inside another
  grown = false, -- the game has made it larger: before, it was at wasAt with the size wasSize
  jumped = false, -- a carrier that the game has moved and called `refresh` for
  buried = false, -- inside something immovable, with no way out
  fresh = false, -- in its first step
  news = false, -- something other than its motion has changed in this step
  time = 0, -- fraction of the step at which its present path begins
  support = 0, -- slot of what it stands on, 0: nothing
  carrier = 0, -- slot of the carrier at the end of the chain of supports, 0: nothing
  carrierNow = 0, -- scratch of carriers
  carrierSeen = 0,
  -- the solver
  crowd = 0, -- slot that leads its crowd, 0: it is in none (see crowd)
  dirty = 0, -- 1: its path has changed since it was last swept
  stuck = false, -- keeps its place: its knot has no room, or it exits (see knots)
  exiting = false, -- on its way out of a knot
  deepAt = 0, -- solve in which it was last inside another dynamic body
  limitedAt = 0, -- solve in which its motion is limited, as overlaps may push it
  impactsOf = 0, -- number of impacts in this step
  pieceFirst = 0, -- pieces of its way along the ground (see walk),
  pieceLast = 0, -- 0: none
  frozenAt = 0, -- solve in which it was stopped where it met a circle
  deflectedAt = 0, -- solve in which it met something slanted (see ball)
  inRound = 0, -- round in which it was last in an impact
  lowered = 0, -- px by which it was lowered in this step (see snap)
  -- broad phase
  placed = 0, -- 0: not in the broad phase, 1: its neighbours must be looked up, 2: they are known
  head = 0, -- first half-edge
  mark = 0,
  strayAt = HUGE, -- place in the list of slots to look up neighbours for
}

-- The same, in columns that may hold anything; `false`: the field is not set.
local ANY = {
  object = false,
  group = false, -- the record of its group (see registry)
  groupName = false,
  key = false,
  touching = false, -- the table that is object.touching
  ownGravity = false,
  ownGravityX = false,
  mask = false, -- the game's table; of a static object a copy that is never changed
  maskSeen = false, -- which groups the mask of a mover refused when it was last read
  only = false, -- the only groups that it can meet (see filter), false: all
  hitsGiven = false, -- the game's list of them,
  hitsRead = false, -- and what was read of it
  oneWay = false,
  slope = false, -- `shape` says the same
  radius = false,
  area = false, -- a copy of the game's table (see zones)
  canCollide = false,
  hears = false, -- its onStay
}

local AXIS = {
  position = 0, -- as the game sees it
  velocity = 0,
  size = 0,
  push = 0, -- ax, ay
  limit = HUGE, -- maxSpeedX, maxSpeedY
  slowest = -HUGE, -- limits of the velocity by these and maxFallSpeed, without its carrier
  fastest = HUGE,
  pull = 0, -- gravity that acts on it, px/s²
  zonePull = 0, -- the same with what zones do
  zoneLeft = 0, -- share of it of which no zone has the gravity
  down = 0, -- -1, 0, 1: where its gravity points, on its stronger axis only
  last = 0, -- position before the last fixed step, for drawing
  written = 0, -- x, y as the game has last written them; kinematic: its target
  behind = 0, -- kinematic: what is left of the way to its target, for the next steps of an update
  way = 0, -- displacement by its own motion in this step, px
  from = 0, -- start of the present path
  to = 0, -- end of the path: its position at the end of the step
  softSpeed = 0, -- velocity apart from what it overlaps and is soft to, px/s (see drift)
  undrifted = 0, -- velocity at the end of the step without that
  speed = 0, -- velocity at the end of the step, absolute
  accel = 0, -- acceleration during the step, drag and limits included
  carried = 0, -- velocity of its carrier in this step
  drift = 0, -- kinematic: velocity of the way that the game has written, in the last step
  kept = 0, -- in the air: the part of its velocity that its last carrier gave it
  reserve = 0, -- px/s that its speed limit has taken off
  pace = 0, -- speed limit without the carrier, px/s
  heldLow = 1, -- > 0: cannot move towards smaller coordinates
  heldHigh = 1,
  holderLow = 0, -- slot of what blocks it there
  holderHigh = 0,
  crushed = false, -- in this step, between crushLow and crushHigh
  wasCrushed = false, -- in the step before
  crushLow = 0,
  crushHigh = 0,
  pressedLow = false, -- something rested against this side in this step
  pressedHigh = false,
  widest = 0, -- the contact that is hit, of several at once
  wasAt = 0,
  wasSize = 0,
  give = 0, -- inverse mass in this step, 1/kg; 0: cannot be moved
  freeSpeed = 0, -- velocity at the end of the step without contacts, px/s
  start = 0, -- velocity at the start of the step
  origin = 0, -- position then
  swept = 0, -- end of the path that was swept last
  crowdAge = 0, -- on the first axis: number of steps that it has been in its crowd
  knotted = 0, -- x: s for which its knot has not come apart; y: how often that was too long
  knotWas = 0, -- x: sum of the overlaps of the knot then, px; y: walls beside it when it got stuck
  squeezed = 0, -- px by which it is pressed between two bodies that cannot move
  base = 0, -- velocity of the immovable ground that it rubs on,
  grip = 0, -- the friction limit there, N,
  rough = 0, -- and the coefficient of friction
  tug = 0, -- impulse of slipping bonds
  bondUnder = 0, -- bond with its support (see friction)
  bondOn = 0, -- first bond with a body that it supports
  least = -HUGE, -- its speed limits, carrier included
  most = HUGE,
  onset = 0, -- velocity at the start of the step, after impulses that act at once,
  outset = 0, -- and that of its block
  lead = 0, -- px by which it has slipped on before it stuck
  ownSpeed = 0, -- velocity at the end of the step with all these, but without contacts
  bearer = 0, -- contact that bears its load
  load = 0, -- impulse of what it supports
  weight = 0, -- the part of that which is no impact
  burden = 0, -- kg that it supports
  isPressed = false,
  bondMark = 0, -- it is in a stack that friction holds together
  parent = 0, -- next body on the way to the root of its block (see pool)
  offset = 0, -- px from that body
  blockMass = 0, -- at the root: sums over the block
  blockMomentum = 0,
  blockSpeed = 0,
  blockForce = 0,
  blockKinks = 0,
  blockShift = 0, -- px between the block's centre of mass and where its members alone would have it
  blockLeast = 0,
  blockMost = 0,
  blockStand = 0, -- velocity of ground on which a member stands
  isFirm = false, -- is not pushable
  blockPower = 0, -- of its strongest member
  fatLow = 0, -- box with a margin for which the neighbours are known
  fatHigh = 0,
}

-- Columns of pairs; `linkAll` writes their initial values. First numbers …
local PAIR = {
  "pairA",
  "pairB",
  "contact", -- side of pairA that is in contact (see SIDES), 0: none
  "hit", -- side of pairA that was first hit in this step, 0: none
  "hitSpeed",
  "hitAt", -- place of that: coordinate on its axis, px,
  "hitLow", -- and ends of the common edge on the other axis
  "hitHigh",
  "nudged", -- number of corner corrections in this step
  "wedged", -- 1 + code of the direction in which an overlapping pair may separate
  "deepIn", -- solve in which the two overlapped
  "deepWay", -- the value of `wedged` after that
  "contactLow", -- index of the contact's low body on its axis
  "contactHigh",
  "contactKey", -- sort key of the contact
  "separation", -- distance in px that the two must keep
  "place", -- scratch of contacts
  "pressed", -- 1: the two press each other
  "sweptAt", -- sweep in which it was last listed
  "asked", -- solve in which canCollide was last called for it
  "touches", -- 1: may meet at the very beginning of the step
}

-- … and booleans.
local PAIR_FLAG = {
  "passing", -- may pass through each other in this step (canCollide, dropThrough)
  "dropping", -- fall through each other (dropThrough) until they are apart
  "overlapping", -- overlapped at the end of the last step
  "leaving", -- is about to be unlinked
}

-- Lists, from 1 on, that hold each pair at most once.
local PAIR_LIST = {
  "live", -- pairs of which one body is awake
  "near", -- scratch of sweep
  "roundPairs", -- scratch of contacts
  "apart", -- pairs to be swept (see contacts)
  "overlaps",
  "sortScratch",
  "touchPairs", -- scratch of write
  "closePairs",
  "otherPairs",
}

local HALF = { "other", "next", "previous" }

-- Lists, from 1 on, that hold each pair at most twice.
local HALF_LIST = {
  "offerAt", -- scratch of write
  "offerOther",
  "offerWidth",
  "rivals",
}

-- Lists, from 1 on, that hold each object at most once.
local SLOT_LIST = {
  "movers", -- slots of everything that is not static
  "awakeList", -- slots that take part in this step
  "flyers", -- slots that fly (see motion/flight.lua)
  "rich", -- scratch of read
  "outdated", -- scratch of write
}

-- By 4 * slot + side; sides are 1 to 4.
local SIDE = {
  "touchBest", -- slot of the object that it touches there at the end of this step
  "touchTold", -- what `touching` of the game's object says; UNTOLD at its first side: unknown
  "touchWidth", -- scratch of write
}

-- Columns of these that hold small whole numbers: slots, pairs, places, sides, counts of one step.
-- (Columns that count steps, stamps or changes grow as long as the game runs, and are not here.)
local WHOLE = {}
for _, names in ipairs({
  { "kind", "shape", "awakeAt" },
  { "support" },
  { "carrier", "carrierNow", "placed", "head", "holderLow", "holderHigh", "crushLow" },
  { "crushHigh", "touchBest", "touchTold", "pairA", "pairB", "contact", "hit" },
  { "nudged", "wedged", "touches" },
  { "live" },
  { "near", "touchPairs", "roundPairs" },
  { "closePairs", "otherPairs", "other", "next", "previous", "movers", "awakeList", "rich" },
  { "flyers" },
  { "outdated", "offerAt", "offerOther", "rivals" },
}) do
  for _, name in ipairs(names) do
    WHOLE[name] = true
  end
end

-- What a step leaves in an object's columns besides its position. An awake object begins each step
-- without most of it (see begin). An object that becomes static must be cleared here.
local STEP_SLOT = {
  "buried",
  "crowd",
  "inside",
  "stuck",
  "exiting",
  "support",
  "carrier",
  "carrierNow",
}
local STEP_AXIS = {
  "way",
  "carried",
  "reserve",
  "pace",
  "heldLow",
  "heldHigh",
  "holderLow",
  "holderHigh",
  "give",
  "start",
  "freeSpeed",
  "squeezed",
  "knotted",
  "knotWas",
  "crowdAge",
  "crushed",
  "wasCrushed",
  "pressedLow",
  "pressedHigh",
}

--- Sides are numbers inside: left, right, top, bottom are 1 to 4, so that the side on `axis` is
--- `2 * axis + 1` (low) or `2 * axis + 2` (high).
columns.SIDES = { "left", "right", "top", "bottom" }
columns.SIDE = { left = 1, right = 2, top = 3, bottom = 4 }
columns.OPPOSITE = { 2, 1, 4, 3 }
--- The axis of each side.
columns.AXIS = { 0, 0, 1, 1 }

--- Returns the side that a value of the field `oneWay` means: `true` is the top; false: none.
function columns.sideOf(value)
  return value == true and "top" or value or false
end

--- Returns the shape that the field `slope` means.
function columns.shapeOf(value)
  return value and columns.SLOPES[value] or columns.SHAPE_BOX
end

local function namesOf(map)
  local names = {}
  for name in pairs(map) do
    names[#names + 1] = name
  end
  return names
end

interpreted.always(namesOf)

local SLOT_NAMES, ANY_NAMES, AXIS_NAMES = namesOf(SLOT), namesOf(ANY), namesOf(AXIS)

-- Adds columns to a layout. Those of whole numbers are a part of their own.
local function describe(layout, names, kind, width)
  local plain, whole = {}, {}
  for n = 1, #names do
    local list = WHOLE[names[n]] and whole or plain
    list[#list + 1] = names[n]
  end
  layout[#layout + 1] = { kind = kind, width = width, names = plain }
  layout[#layout + 1] = { kind = "integer", width = width, names = whole }
end

-- The same for columns with values of a fresh slot; their type tells the kind.
local function describeByValue(layout, names, values, width)
  for _, kind in ipairs({ "number", "boolean" }) do
    local list = {}
    for n = 1, #names do
      if type(values[names[n]]) == kind then
        list[#list + 1] = names[n]
      end
    end
    describe(layout, list, kind, width)
  end
end

local SLOT_LAYOUT, LIST_LAYOUT, PAIR_LAYOUT = {}, {}, {}
describeByValue(SLOT_LAYOUT, SLOT_NAMES, SLOT, 1)
describe(SLOT_LAYOUT, ANY_NAMES, "any", 1)
describeByValue(SLOT_LAYOUT, AXIS_NAMES, AXIS, 2)
describe(SLOT_LAYOUT, SIDE, "number", 5)
describe(LIST_LAYOUT, SLOT_LIST, "number", 1)
describe(PAIR_LAYOUT, PAIR, "number", 1)
describe(PAIR_LAYOUT, PAIR_FLAG, "boolean", 1)
describe(PAIR_LAYOUT, PAIR_LIST, "number", 1)
describe(PAIR_LAYOUT, HALF, "number", 2)
describe(PAIR_LAYOUT, HALF_LIST, "number", 2)

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

--- Returns the empty columns of a world.
function columns.new()
  local b = {}
  addObjects(b)
  addFlags(b)
  addReading(b)
  addAwake(b)
  addCrowds(b)
  addSolver(b)
  addSlopes(b)
  b.slotStore, b.pairStore = columnStore.new(b, SLOT_LAYOUT), columnStore.new(b, PAIR_LAYOUT)
  b.listStore = columnStore.new(b, LIST_LAYOUT)
  for n = 1, #AXIS_NAMES do
    b[AXIS_NAMES[n]][1] = AXIS[AXIS_NAMES[n]] -- belongs to slot 0
  end
  -- Slot 0 is the empty slot, that of unlinked pairs. Its size is negative, so it meets nothing.
  b.object[0], b.awake[0], b.rank[0], b.time[0] = false, false, 0, 0
  b.head[0], b.next[0], b.previous[0] = 0, 0, 0
  b.dirty[0], b.crowd[0], b.lowered[0], b.shape[0] = 0, 0, 0, 0
  for k = 0, 1 do
    b.from[k], b.to[k], b.speed[k], b.size[k] = 0, 0, 0, -1
  end
  return b
end

--- Moves the columns of an empty world, and those of its broad phase, to the current source (see
--- columnStore).
function columns.adopt(b)
  columnStore.adopt(b.slotStore, b.slots)
  columnStore.adopt(b.listStore, b.slots)
  columnStore.adopt(b.pairStore, b.pairSlots)
  b.blankTo = b.slots -- prepared slots were not copied
  if b.broadphase.adopt then
    b.broadphase:adopt()
  end
end

local function fill(column, first, last, value)
  for at = first, last do
    column[at] = value
  end
end

-- Gives slots their initial values, column by column. (Slot by slot, 20 000 tiles take twice as
-- long.)
local function blank(b, first, last)
  for n = 1, #SLOT_NAMES do
    fill(b[SLOT_NAMES[n]], first, last, SLOT[SLOT_NAMES[n]])
  end
  for n = 1, #ANY_NAMES do
    fill(b[ANY_NAMES[n]], first, last, ANY[ANY_NAMES[n]])
  end
  for n = 1, #AXIS_NAMES do
    fill(b[AXIS_NAMES[n]], 2 * first, 2 * last + 1, AXIS[AXIS_NAMES[n]])
  end
  for n = 1, #SIDE do
    fill(b[SIDE[n]], 4 * first + 1, 4 * last + 4, 0)
  end
end

interpreted.functions(blank) -- leads from loop to loop

-- Takes a slot that was never used. Prepares a few slots behind it, too: more objects will come.
local function takeNew(b)
  local i = b.slots + 1
  b.slots = i
  if i > b.slotStore.room then
    columnStore.grow(b.slotStore, i)
    columnStore.grow(b.listStore, i)
  end
  if i > b.blankTo then
    local room = 1 -- Lua makes room up to the next power of two
    while room <= i do
      room = room * 2
    end
    b.blankTo = min(i + floor(i / AHEAD), max(i, room - 1), b.slotStore.room)
    blank(b, i, b.blankTo)
  end
  return i
end

--- Takes a slot for a new object and returns it. All its columns have their initial values.
function columns.claim(b)
  local i = b.free[b.freeCount]
  if i then
    b.free[b.freeCount] = nil
    b.freeCount = b.freeCount - 1
    blank(b, i, i)
  else
    i = takeNew(b)
  end
  b.count = b.count + 1
  return i
end

--- Resets what the last step has left in a slot.
function columns.forgetStep(b, i)
  for n = 1, #STEP_SLOT do
    b[STEP_SLOT[n]][i] = SLOT[STEP_SLOT[n]]
  end
  for n = 1, #STEP_AXIS do
    local name, k = STEP_AXIS[n], 2 * i
    b[name][k], b[name][k + 1] = AXIS[name], AXIS[name]
  end
end

--- Gives an object a path of length 0 at its position, as an obstacle and for the broad phase. An
--- awake object gets its path when a step begins.
function columns.stand(b, i)
  local k = 2 * i
  b.from[k], b.from[k + 1] = b.position[k], b.position[k + 1]
  b.to[k], b.to[k + 1] = b.position[k], b.position[k + 1]
  b.speed[k], b.speed[k + 1], b.accel[k], b.accel[k + 1] = 0, 0, 0, 0
  b.time[i] = 0
end

--- Gives a slot back. Its pairs must have been unlinked.
function columns.release(b, i)
  b.object[i], b.group[i], b.touching[i], b.mask[i], b.canCollide[i] =
    false, false, false, false, false
  b.area[i] = false
  b.only[i], b.hitsGiven[i], b.hitsRead[i] = false, false, false
  b.kind[i] = 0
  b.awake[i] = false
  b.freeCount = b.freeCount + 1
  b.free[b.freeCount] = i
  b.count = b.count - 1
end

-- Returns the highest slot that is in use.
local function lastUsed(b)
  local last = b.slots
  while last > 0 and b.kind[last] == 0 do
    last = last - 1
  end
  return last
end

-- Keeps the first `last` slots only.
local function cut(b, last)
  local free, count = {}, 0
  for n = 1, b.freeCount do
    if b.free[n] <= last then
      count = count + 1
      free[count] = b.free[n]
    end
  end
  b.free, b.freeCount = free, count
  columnStore.shrink(b.slotStore, last)
  columnStore.shrink(b.listStore, last)
  b.slots, b.blankTo = last, last
end

--- Gives back the memory of free slots behind the last one in use, if most slots are free. Call it
--- between two steps only: lists of a step may hold such slots.
function columns.shrink(b)
  if
    b.slots > FEW
    and b.freeCount ~= b.freeSeen
    and b.freeCount * SHARE > b.slots * (SHARE - 1)
  then
    local last = lastUsed(b)
    if last * SHARE <= b.slots then
      cut(b, last)
    end
    b.freeSeen = b.freeCount
  end
end

interpreted.functions(columns.shrink, cut, lastUsed) -- rare

-- The lists of half-edges are changed without branches: a write that is not needed goes to place 0.

local function hang(b, half, i, j)
  local first = b.head[i]
  b.other[half], b.next[half], b.previous[half] = j, first, 0
  b.previous[first], b.head[i] = half, half
end

local function unhang(b, half, i)
  local before, after = b.previous[half], b.next[half]
  b.next[before], b.previous[after] = after, before
  b.head[i * (1 - min(before, 1))] = after -- only if it was the first
end

-- Makes sure that so many pairs are free.
local function reserve(b, count)
  local free, have = b.freePairs, b.freePairCount
  local p = b.pairSlots + count - have
  if p > b.pairStore.room then
    columnStore.grow(b.pairStore, p)
  end
  for n = have + 1, count do
    free[n] = p
    p = p - 1
  end
  b.pairSlots, b.freePairCount = b.pairSlots + max(0, count - have), max(count, have)
end

-- Takes `count` free pairs for b.linkOne[1..count] and b.linkOther[1..count] into b.linked.
local function takePairs(b, count)
  reserve(b, count)
  local free, top, linked = b.freePairs, b.freePairCount + 1, b.linked
  local ones, others, pairA, pairB = b.linkOne, b.linkOther, b.pairA, b.pairB
  for n = 1, count do
    local p = free[top - n]
    linked[n], pairA[p], pairB[p] = p, ones[n], others[n]
  end
  b.freePairCount = b.freePairCount - count
end

-- Gives new pairs their initial values.
local function resetPairs(b, count)
  local linked = b.linked
  local contact, hit, hitSpeed, nudged = b.contact, b.hit, b.hitSpeed, b.nudged
  for n = 1, count do
    local p = linked[n]
    contact[p], hit[p], hitSpeed[p], nudged[p] = 0, 0, 0, 0
  end
  local passing, overlapping, dropping, leaving = b.passing, b.overlapping, b.dropping, b.leaving
  for n = 1, count do
    local p = linked[n]
    passing[p], overlapping[p], dropping[p], leaving[p] = false, false, false, false
  end
  local wedged, touches, place, pressed, asked = b.wedged, b.touches, b.place, b.pressed, b.asked
  for n = 1, count do
    local p = linked[n]
    wedged[p], touches[p], place[p], pressed[p], asked[p] = 0, 0, 0, 0, 0
    b.sweptAt[p], b.deepIn[p] = 0, 0
  end
end

--- Makes neighbours of b.linkOne[n] and b.linkOther[n], for n from 1 to `count`. Their pairs are in
--- b.linked afterwards. They must not be neighbours yet, nor be listed twice.
function columns.linkAll(b, count)
  takePairs(b, count)
  resetPairs(b, count)
  local linked, ones, others = b.linked, b.linkOne, b.linkOther
  for n = 1, count do
    hang(b, 2 * linked[n] - 1, ones[n], others[n])
  end
  for n = 1, count do
    hang(b, 2 * linked[n], others[n], ones[n])
  end
  local live, liveCount = b.live, b.liveCount
  for n = 1, count do
    live[liveCount + n] = linked[n]
  end
  b.liveCount, b.links, b.pairCount = liveCount + count, b.links + count, b.pairCount + count
end

--- Makes two objects neighbours and returns the pair. They must not be neighbours yet.
function columns.link(b, i, j)
  b.linkOne[1], b.linkOther[1] = i, j
  columns.linkAll(b, 1)
  return b.linked[1]
end

--- Unlinks the pairs in list[1..count], each of which is listed once. Their contacts must have
--- ended. They are free again when the live pairs are listed anew: lists of this step hold them.
function columns.unlinkAll(b, list, count)
  local pairA, pairB = b.pairA, b.pairB
  for n = 1, count do
    unhang(b, 2 * list[n] - 1, pairA[list[n]])
  end
  for n = 1, count do
    unhang(b, 2 * list[n], pairB[list[n]])
  end
  local ended, endedCount = b.endedPairs, b.endedPairCount
  local told = b.touchTold
  for n = 1, count do
    local p = list[n]
    -- Either slot may soon belong to another object.
    told[4 * pairA[p] + 1], told[4 * pairB[p] + 1] = columns.UNTOLD, columns.UNTOLD
    pairA[p], pairB[p] = 0, 0
    ended[endedCount + n] = p
  end
  b.endedPairCount, b.pairCount, b.links = endedCount + count, b.pairCount - count, b.links + count
end

--- Makes the pairs free that have ended since this was last called.
function columns.freeEnded(b)
  local free, freeCount, ended, count = b.freePairs, b.freePairCount, b.endedPairs, b.endedPairCount
  for n = 1, count do
    free[freeCount + n] = ended[n]
  end
  b.freePairCount, b.endedPairCount = freeCount + count, 0
end

--- Returns the gap between slots i and j at the places in a column, px; below 0: they overlap.
function columns.gap(b, place, i, j)
  local size, k, m = b.size, 2 * i, 2 * j
  local x, y = place[m] - place[k], place[m + 1] - place[k + 1]
  return max(x - size[k], -x - size[m], y - size[k + 1], -y - size[m + 1])
end

--- Returns the two ranks that decide between simultaneous impacts of a pair. The first is the rank
--- of the dynamic object; of two dynamic ones, the lower rank. If one stands on the other, the
--- second rank is made lower than all ranks; if both are dynamic, the first one, too. So of several
--- objects below, the one that counts as the support and carrier bears the weight.
function columns.ranks(b, i, j)
  local one, other = b.rank[i], b.rank[j]
  local iDynamic, jDynamic = b.kind[i] == columns.DYNAMIC, b.kind[j] == columns.DYNAMIC
  local first = one
  if jDynamic and (not iDynamic or other < one) then
    first = other
  end
  local second = one + other - first
  if b.support[i] == j or b.support[j] == i then
    first = iDynamic and jDynamic and first - columns.RANKS or first
    second = second - columns.RANKS
  end
  return first, second
end

--- Returns the pair of two neighbours, or nil.
function columns.pairOf(b, i, j)
  local other, nextHalf = b.other, b.next
  local half = b.head[i]
  while half ~= 0 do
    if other[half] == j then
      return (half + half % 2) / 2
    end
    half = nextHalf[half]
  end
end

return columns
