--- The memory of a world: one array ("column") per property, one index ("slot") per object.
--
-- Every step of the simulation reads and writes these columns and nothing else; the game's tables
-- are read in `collect` and written in `publish`. Columns that hold a value for each axis are
-- interleaved: `column[2 * slot]` is x and `column[2 * slot + 1]` is y, so that one function serves
-- both axes. Pairs of neighbours have columns of their own; each pair hangs in the lists of both of
-- its objects by two half-edges (`2 * pair - 1` and `2 * pair`).
--
-- No column is ever shared between worlds: callbacks may step another world.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local bank = require(root .. ".memory.columnStore")
local interpreted = require(root .. ".memory.jit")

local columns = {}

columns.STATIC, columns.KINEMATIC, columns.DYNAMIC = 1, 2, 3

--- By kind: 1 for who is dynamic, a number for what has no branches. (0: nobody is there.)
columns.GIVES = { [0] = 0, [columns.STATIC] = 0, [columns.KINEMATIC] = 0, [columns.DYNAMIC] = 1 }

--- Returns the kind that an object's fields say, which is read again in each step but for `static`.
---@param object physics.Object
---@param isStatic boolean? what is known of that; nil: as the field says
---@return integer
function columns.kindOf(object, isStatic)
  if isStatic == nil then
    isStatic = object.static or false
  end
  return isStatic and columns.STATIC or object.kinematic and columns.KINEMATIC or columns.DYNAMIC
end

--- How far apart two edges may be and still count as touching, px.
columns.EPSILON = 1e-6

--- Makes any difference of two numbers around EPSILON more than 1, so that
--- `min(max(d * VAST, 0), 1)` is 1 for d > 0 and 0 for d <= 0, and `min(max(d * VAST + 1, 0), 1)`
--- is 1 for d >= 0 and 0 for d < 0. What would have branches is worked out with these: any way but
--- the one compiled first takes 40 ns more.
columns.VAST = 1e300

--- Keeps 0 / 0 out of what has no length: no more than that is added to what has one.
columns.TINY = 1e-300

--- More than the ranks of all objects there may be.
columns.RANKS = 2 ^ 40

--- What stands in `touchTold` at the first side of an object whose `touching` must be told anew.
columns.UNTOLD = -1

local HUGE = math.huge
local floor, max, min = math.floor, math.max, math.min
-- Of so many slots in use, one more is made ready with each new one.
local AHEAD = 8

-- Values of a fresh slot: numbers and booleans.
local SLOT = {
  -- who it is
  rank = 0, -- place in the order of the world
  kind = 0,
  plain = false, -- bumps whoever it meets
  even = false, -- and does so on all sides, and is not told of contacts that go on
  bare = false, -- dynamic, and had none of the fields that few have when it was last read, but for
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
  maxSpeed = HUGE,
  carry = true,
  surfaceSpeed = 0,
  nudge = 0,
  -- rest
  awake = false,
  awakeAt = 0, -- place in the list of who is awake
  quiet = false, -- its last step changed nothing
  heard = false, -- somebody is told of its contacts, or asked about them, at every step
  visited = 0,
  flying = false, -- near nothing: moves like a point (see flight)
  -- the step
  moved = false, -- placed, resized or filtered anew by the game: its overlaps must be parted
  inside = false, -- the last step left it inside another
  grown = false, -- the game has made it larger: then it was at wasAt, and wasSize large
  jumped = false, -- a carrier that the game has put elsewhere by `refresh`
  buried = false, -- inside something immovable, with no way out
  fresh = false, -- in its first step
  news = false, -- something else than its motion has changed in this step
  time = 0, -- fraction of the step at which its present path begins
  support = 0, -- slot of what it stands on, 0: nothing
  carrier = 0, -- slot of what carries it, through all that it stands on, 0: nothing
  carrierNow = 0, -- scratch of carrier
  carrierSeen = 0,
  -- the solver
  crowd = 0, -- what leads the crowd that it is in, 0: none (see crowd)
  dirty = 0, -- 1: its path is new since it was last swept
  deepAt = 0, -- solve in which it was inside another dynamic body
  impactsOf = 0, -- impacts in this step
  inRound = 0, -- round in which it was last in an impact
  -- broad phase
  placed = 0, -- 0: not in the broad phase, 1: its neighbours must be looked up, 2: they are known
  head = 0, -- first half-edge
  mark = 0,
  strayAt = HUGE, -- place among those whose neighbours are looked up now
}

-- The same, of columns that may hold anything; `false`: the field is not set.
local ANY = {
  object = false,
  group = false, -- the record of its group (see roster)
  groupName = false,
  key = false,
  touching = false, -- the table published as object.touching
  ownGravity = false,
  ownGravityX = false,
  mask = false, -- the game's table; of a static object a copy that is never changed
  maskSeen = false, -- what the mask of a mover said of each group when it was last read
  only = false, -- the only groups that it can meet (see filter), false: all
  hitsGiven = false, -- the game's list of them,
  hitsRead = false, -- and what was read of it
  oneWay = false,
  canCollide = false,
  hears = false, -- its onStay
}

local AXIS = {
  position = 0, -- where the game sees it
  velocity = 0,
  size = 0,
  push = 0, -- ax, ay
  limit = HUGE, -- maxSpeedX, maxSpeedY
  pull = 0, -- gravity that acts on it
  down = 0, -- -1, 0, 1: where its gravity points, on its stronger axis only
  last = 0, -- position before the last fixed step, for drawing
  written = 0, -- x, y as the game has last written them; kinematic: where it shall go
  behind = 0, -- kinematic: part of that way which is left for the next steps of an update
  way = 0, -- how far it goes in this step by itself, px
  from = 0, -- start of the present path
  to = 0, -- where it will be at the end of the step
  drift = 0, -- velocity apart from what it overlaps and is soft to, px/s (see drift)
  undrifted = 0, -- velocity at the end of the step without that
  speed = 0, -- velocity at the end of the step, absolute
  accel = 0, -- acceleration during the step, drag and limits included
  carried = 0, -- velocity of its carrier in this step
  reserve = 0, -- how much faster it could get, px/s, but for its limit
  pace = 0, -- up to which speed, without its carrier
  heldLow = 1, -- > 0: cannot give way towards smaller coordinates
  heldHigh = 1,
  holderLow = 0, -- slot of who holds it there
  holderHigh = 0,
  crushed = false, -- in this step, between crushLow and crushHigh
  wasCrushed = false, -- in the step before
  crushLow = 0,
  crushHigh = 0,
  pressedLow = false, -- something rested against this side in this step
  pressedHigh = false,
  widest = 0, -- contact that is hit, of several at once
  wasAt = 0,
  wasSize = 0,
  give = 0, -- inverse mass in this step, 0: cannot be moved
  freeSpeed = 0, -- velocity at the end of the step without contacts, px/s
  start = 0, -- velocity at its start
  origin = 0, -- where it is then
  swept = 0, -- end of the path that was swept last
  crowdAge = 0, -- on the first axis: steps for which it has been in its crowd
  jam = 0, -- steps for which it had no room (see contacts)
  squeezed = 0, -- px by which it is pressed between two that cannot give way
  base = 0, -- velocity of immovable ground that it rubs on,
  grip = 0, -- and how strongly, N at most,
  rough = 0, -- with this coefficient
  tug = 0, -- impulse of bonds that slip
  bondUnder = 0, -- bond with what it stands on (see friction)
  bondOn = 0, -- first one with what stands on it
  least = -HUGE, -- its speed limits, carrier included
  most = HUGE,
  onset = 0, -- velocity at the start of the step, after what acts at once,
  outset = 0, -- and that of the block it is in
  lead = 0, -- px by which it has slipped on before it stuck
  ownSpeed = 0, -- velocity at the end with all these, but without contacts
  bearer = 0, -- contact that bears its load
  load = 0, -- impulse of what stands on it
  weight = 0, -- of that, what is no impact
  burden = 0, -- kg that stand on it
  isPressed = false,
  bondMark = 0, -- it is in a tower that friction holds together
  parent = 0, -- blocks (see pool): the next one on the way to the root
  offset = 0, -- px from that
  blockMass = 0, -- at the root: sums over the block
  blockMomentum = 0,
  blockSpeed = 0,
  blockForce = 0,
  blockKinks = 0,
  blockShift = 0, -- px that its mass is off from where it would be with the members where they were
  blockLeast = 0,
  blockMost = 0,
  blockStand = 0, -- velocity of ground on which a member stands
  isFirm = false, -- is not pushable
  blockPower = 0, -- of its strongest member
  fatLow = 0, -- box with margin for which the neighbours are known
  fatHigh = 0,
}

-- What a pair begins with is written in `linkAll`: numbers …
local PAIR = {
  "pairA",
  "pairB",
  "contact", -- side of pairA that is in contact (see SIDES), 0: none
  "hit", -- side of pairA that was first hit in this step, 0: none
  "hitSpeed",
  "nudged", -- how often a corner was corrected in this step
  "liveMark",
  "wedged", -- 1 + code of the meeting along which two that are left inside each other may part
  "deepIn", -- solve in which two were inside each other
  "deepWay", -- what `wedged` is after that
  "contactLow", -- index of the low one of a contact on its axis
  "contactHigh",
  "contactKey", -- by which contacts are sorted
  "separation", -- px that the two must be apart
  "place", -- scratch of contacts
  "pressed", -- 1: the two lean on each other
  "sweptAt", -- sweep in which it was last listed
  "asked", -- solve in which the game was last asked about it
  "touches", -- 1: may be met at the very beginning of the step
}

-- … and booleans.
local PAIR_FLAG = {
  "passing", -- lets pass for this step (canCollide, dropThrough)
  "dropping", -- falls through (dropThrough) until the two are apart
  "overlapping", -- was left inside each other at the end of the last step
  "leaving", -- is about to be taken apart
}

-- Lists, from 1 on, that hold each pair once at most.
local PAIR_LIST = {
  "live", -- pairs of those who take part in this step
  "near", -- scratch of meet
  "apart", -- pairs to be swept (see contacts)
  "overlaps",
  "sortScratch",
  "touchPairs", -- scratch of publish
  "closePairs",
  "otherPairs",
}

local HALF = { "other", "next", "previous" }

-- Lists, from 1 on, that hold each pair twice at most.
local HALF_LIST = {
  "offerAt", -- scratch of publish
  "offerWho",
  "offerWidth",
  "rivals",
}

-- Lists, from 1 on, that hold each object once at most.
local SLOT_LIST = {
  "movers", -- slots of everything that is not static
  "awakeList", -- of those who take part in this step
  "flyers", -- of those who fly (see flight)
  "rich", -- scratch of collect
  "outdated", -- scratch of publish
}

-- By 4 * slot + side; sides are 1 to 4.
local SIDE = {
  "touchBest", -- slot of whom it touches there at the end of this step
  "touchTold", -- what `touching` of the game's object says; UNTOLD at its first side: nobody knows
  "touchWidth", -- scratch of publish
}

-- Of all these, what holds whole numbers that stay small: slots, pairs, places, sides, counts of
-- one step. (Not what counts steps, stamps or changes, which grows as long as the game is played.)
local WHOLE = {}
for _, names in ipairs({
  { "kind", "awakeAt" },
  { "support" },
  { "carrier", "carrierNow", "placed", "head", "holderLow", "holderHigh", "crushLow" },
  { "crushHigh", "touchBest", "touchTold", "pairA", "pairB", "contact", "hit" },
  { "nudged", "wedged", "touches" },
  { "live" },
  { "near", "touchPairs" },
  { "closePairs", "otherPairs", "other", "next", "previous", "movers", "awakeList", "rich" },
  { "flyers" },
  { "outdated", "offerAt", "offerWho", "rivals" },
}) do
  for _, name in ipairs(names) do
    WHOLE[name] = true
  end
end

-- What a step leaves behind in an object, apart from where it is. Who is awake begins each step
-- without most of it (see begin); of who becomes a wall nobody else would clear it.
local STEP_SLOT = {
  "buried",
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
--- On which axis a side is.
columns.AXIS = { 0, 0, 1, 1 }

--- Returns the side that the field `oneWay` means: `true` is the top, false: none.
function columns.sideOf(value)
  return value == true and "top" or value or false
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

local function describe(layout, names, kind, width)
  for n = 1, #names do
    local its = WHOLE[names[n]] and "integer" or kind
    layout[#layout + 1] = { name = names[n], kind = its, width = width }
  end
end

-- The same for columns with values of a fresh slot, which tell their kind.
local function describeByValue(layout, names, values, width)
  for n = 1, #names do
    describe(layout, { names[n] }, type(values[names[n]]), width)
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

--- Returns the empty columns of a world.
function columns.new()
  local b = {
    slots = 0, -- highest slot ever used
    blankTo = 0, -- highest slot that is, or has what a fresh one has
    free = {}, -- slots to use again
    freeCount = 0,
    count = 0, -- objects in the world
    slotOf = {}, -- object -> slot
    pairSlots = 0,
    freePairs = {},
    freePairCount = 0,
    pairCount = 0,
    moverCount = 0,
    awakeCount = 0,
    flyerCount = 0,
    island = {}, -- scratch of rest
    stack = {}, -- scratch of crush and carrier
    liveCount = 0,
    liveStamp = 0,
    step = 0, -- counts the steps, for `watched`
    stained = {}, -- pairs of which more must be forgotten than of others (see live)
    stainCount = 0,
    links = 0, -- how often the pairs have changed
    awakenings = 0, -- how often it has changed who takes part
    liveLinks = -1, -- both, when `live` was listed
    liveAwakenings = -1,
    rubs = 0, -- 1: friction has borne or braked somebody in this step
    hasCarriers = false, -- anything in the world that ever carried others
    hasFriction = false, -- or rubs
    hasNudges = false, -- or could slide around corners
    hasHinders = false, -- or has drag or a maxSpeed
    hasLimits = false, -- or has a limit of any kind
    hasBounces = false, -- or bounced
    hasAskers = false, -- or has a canCollide
    hasCrushed = false, -- or was crushed
    hasInside = false, -- or was left inside another
    hasBuried = false, -- or had no way out
    isRemasked = false, -- anybody may be inside somebody whom it can meet only now
    maskCopy = false, -- the last one made of the mask of a static object (see filter)
    hitLists = {}, -- the different lists of `hits` (see filter)
    hasOneWays = false, -- or is one-way
    soft = false, -- px/s, by two group names: how fast what overlaps drifts apart
    hasSensors = false, -- or a sensor
    hasFirm = false, -- or not pushable
    hasCrowds = false, -- or was crowded
    crowdCount = 0, -- crowded bodies in this step
    crowdList = {}, -- scratch of crowd
    crowdKey = {},
    crowdStamp = 0,
    crowdNew = {},
    stoodAt = {},
    crowdMark = {},
    isOverlapped = {},
    crowdColumn = {},
    columnWidth = {},
    shared = {},
    leader = {},
    leaderRank = {},
    apartCount = 0,
    sweptStamp = 0,
    changed = {}, -- bodies with new paths
    changedCount = 0,
    bounced = {}, -- bodies that may have bounced in this round
    bouncedCount = 0,
    isChangeListed = false, -- these are all
    seenCount = 0,
    overlapCount = 0,
    isViolated = false,
    isTorn = false, -- two of one block overlap
    isJammed = false, -- an impact of two that cannot give way
    members = {}, -- of blocks
    memberCount = 0,
    kinkAt = {},
    kinkGrip = {},
    kinkNext = {},
    kinkCount = 0,
    pulled = {}, -- what friction and limits act on
    pulledCount = 0,
    forceStamp = 0,
    roundStamp = 0,
    solveStamp = 0,
    dt = 0, -- s, of the step that is made
    lost = {}, -- slots whose carrier went away since the last step
    lostCount = 0,
    unasked = { pairs = {}, sides = {}, first = {}, second = {}, order = {} }, -- scratch of contact
    halfRead = {}, -- objects that are being read anew (see collect)
    found = {}, -- scratch of detect and part
    stoppedAt = {},
    stoppedTo = {},
    ownFat = {},
    askers = {},
    present = {},
    strays = {},
    aimed = {},
    linkOne = {}, -- who is about to be linked
    linkOther = {},
    linked = {}, -- their pairs
    parted = {}, -- pairs that are about to be taken apart
    movedList = {},
    movedCount = 0,
    remaining = 1, -- steps that are left in this update
    begun = 0, -- places of awakeList that have begun this step
    predicted = 0, -- places of awakeList that have a path
    stamp = 0,
    view = false, -- what questions see (see view)
    contactCount = 0,
    resolved = 0, -- contacts resolved in the last step
    partWork = {
      round = 0,
      far = 1e18, -- more than any overlap is deep
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
    },
  }
  b.slotBank, b.pairBank = bank.new(b, SLOT_LAYOUT), bank.new(b, PAIR_LAYOUT)
  b.listBank = bank.new(b, LIST_LAYOUT)
  for n = 1, #AXIS_NAMES do
    b[AXIS_NAMES[n]][1] = AXIS[AXIS_NAMES[n]] -- belongs to slot 0
  end
  -- Slot 0 is nobody, that of pairs that were taken apart: less than nothing, so it meets nobody.
  b.object[0], b.awake[0], b.rank[0], b.time[0] = false, false, 0, 0
  b.head[0], b.next[0], b.previous[0] = 0, 0, 0
  b.dirty[0], b.crowd[0] = 0, 0
  for k = 0, 1 do
    b.from[k], b.to[k], b.speed[k], b.size[k] = 0, 0, 0, -1
  end
  return b
end

--- Gives the columns of a world with nobody in it, and those of its broad phase, the source that is
--- used now (see bank).
function columns.adopt(b)
  bank.adopt(b.slotBank, b.slots)
  bank.adopt(b.listBank, b.slots)
  bank.adopt(b.pairBank, b.pairSlots)
  b.blankTo = b.slots -- those behind were not taken over
  if b.broadphase.adopt then
    b.broadphase:adopt()
  end
end

local function fill(column, first, last, value)
  for at = first, last do
    column[at] = value
  end
end

-- Gives slots what fresh ones have, column by column: one by one 20 000 tiles take twice as long.
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

-- Takes a slot that was never used. A few behind it are made ready, too: more will come.
local function takeNew(b)
  local i = b.slots + 1
  b.slots = i
  if i > b.slotBank.room then
    bank.grow(b.slotBank, i)
    bank.grow(b.listBank, i)
  end
  if i > b.blankTo then
    b.blankTo = min(i + floor(i / AHEAD), b.slotBank.room)
    blank(b, i, b.blankTo)
  end
  return i
end

--- Takes a slot for a new object and returns it, all columns at their defaults.
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

--- Takes from a slot what the last step has left in it.
function columns.forgetStep(b, i)
  for n = 1, #STEP_SLOT do
    b[STEP_SLOT[n]][i] = SLOT[STEP_SLOT[n]]
  end
  for n = 1, #STEP_AXIS do
    local name, k = STEP_AXIS[n], 2 * i
    b[name][k], b[name][k + 1] = AXIS[name], AXIS[name]
  end
end

--- Lets an object stand where it is, as an obstacle and for the broad phase. Who is awake gets its
--- path when a step begins.
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
  b.only[i], b.hitsGiven[i], b.hitsRead[i] = false, false, false
  b.kind[i] = 0
  b.awake[i] = false
  b.freeCount = b.freeCount + 1
  b.free[b.freeCount] = i
  b.count = b.count - 1
end

-- The lists of half-edges are changed without branches: place 0 of each column takes what would be
-- written to nobody.

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

-- Sees to it that so many pairs are free.
local function reserve(b, count)
  local free, have = b.freePairs, b.freePairCount
  local p = b.pairSlots + count - have
  if p > b.pairBank.room then
    bank.grow(b.pairBank, p)
  end
  for n = have + 1, count do
    free[n], b.liveMark[p] = p, 0
    p = p - 1
  end
  b.pairSlots, b.freePairCount = b.pairSlots + max(0, count - have), max(count, have)
end

-- Takes pairs for b.linkOne[1..count] and b.linkOther[1..count] into b.linked.
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

-- Nothing has happened to new pairs.
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

--- Makes neighbours of b.linkOne[n] and b.linkOther[n], for n from 1 to `count`; their pairs are
--- in b.linked then. They must not be neighbours yet, nor stand there twice.
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
  local live, mark, stamp, liveCount = b.live, b.liveMark, b.liveStamp, b.liveCount
  for n = 1, count do
    local p = linked[n]
    if mark[p] ~= stamp then
      mark[p], liveCount = stamp, liveCount + 1
      live[liveCount] = p
    end
  end
  b.liveCount, b.links, b.pairCount = liveCount, b.links + count, b.pairCount + count
end

--- Makes two objects neighbours and returns the pair. They must not be neighbours yet.
function columns.link(b, i, j)
  b.linkOne[1], b.linkOther[1] = i, j
  columns.linkAll(b, 1)
  return b.linked[1]
end

--- Takes the neighbours of the pairs in list[1..count] apart, each of which stands there once.
--- Contacts of theirs must have been ended.
function columns.unlinkAll(b, list, count)
  local pairA, pairB = b.pairA, b.pairB
  for n = 1, count do
    unhang(b, 2 * list[n] - 1, pairA[list[n]])
  end
  for n = 1, count do
    unhang(b, 2 * list[n], pairB[list[n]])
  end
  local free, freeCount = b.freePairs, b.freePairCount
  local told = b.touchTold
  for n = 1, count do
    local p = list[n]
    -- Either slot may soon be somebody else's.
    told[4 * pairA[p] + 1], told[4 * pairB[p] + 1] = columns.UNTOLD, columns.UNTOLD
    pairA[p], pairB[p] = 0, 0
    free[freeCount + n] = p
  end
  b.freePairCount, b.pairCount, b.links = freeCount + count, b.pairCount - count, b.links + count
end

--- Returns the ranks that decide between simultaneous meetings of a pair: that of the dynamic one
--- first, of two the lower. If one stands on the other, the second, and if both are dynamic the
--- first, too, is made less than all ranks: of several that hold it up, the one that counts as its
--- support, and carries it, bears its weight.
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
