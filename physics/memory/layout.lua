--- Which columns there are, with their meaning and their first values.
--
-- A column has a value for each slot; or one for each axis or side of a slot, each pair, each
-- half-edge. Lists are columns, too: they grow together with what they hold.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local interpreted = require(root .. ".memory.jit")

local layout = {}

local HUGE = math.huge

-- Values of a fresh slot, in columns of numbers and booleans.
layout.SLOT = {
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
  deflectedAt = 0, -- solve in which it met something slanted (see ball)
  nudgedAt = 0, -- solve in which it was nudged
  inRound = 0, -- round in which it was last in an impact
  lowered = 0, -- px by which it was lowered in this step (see snap)
  -- broad phase
  placed = 0, -- 0: not in the broad phase, 1: its neighbours must be looked up, 2: they are known
  head = 0, -- first half-edge
  mark = 0,
  strayAt = HUGE, -- place in the list of slots to look up neighbours for
}

-- The same, in columns that may hold anything; `false`: the field is not set.
layout.ANY = {
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
  hitsGiven = false, -- the game's list of them
  oneWay = false,
  slope = false, -- `shape` says the same
  radius = false,
  area = false, -- a copy of the game's table (see zones)
  canCollide = false,
  hears = false, -- its onStay
}

layout.AXIS = {
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
  holderLow = 0, -- index (2 * slot + axis) of what holds it there
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
  jam = 0, -- x: s for which it has been caught in a heap (see jam)
  jamWay = 0, -- px by which it has moved since then
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
  "wedged", -- side of pairA (see SIDES) on which the two came into each other and part; 0: none
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
  "touches", -- how the solver treats it in this solve (see contacts.APART)
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
  "heapPairs", -- left to the heap in this step
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
layout.SIDE = {
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
layout.STEP_SLOT = {
  "buried",
  "crowd",
  "inside",
  "stuck",
  "exiting",
  "support",
  "carrier",
  "carrierNow",
}
layout.STEP_AXIS = {
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
  "jam",
  "jamWay",
  "crowdAge",
  "crushed",
  "wasCrushed",
  "pressedLow",
  "pressedHigh",
}

local function namesOf(map)
  local names = {}
  for name in pairs(map) do
    names[#names + 1] = name
  end
  return names
end

interpreted.always(namesOf)

-- The names of these columns.
layout.SLOT_NAMES, layout.ANY_NAMES = namesOf(layout.SLOT), namesOf(layout.ANY)
layout.AXIS_NAMES = namesOf(layout.AXIS)

-- Adds columns to a list of parts, as `columnStore` takes it. Those of whole numbers are a part of
-- their own.
local function describe(parts, names, kind, width)
  local plain, whole = {}, {}
  for n = 1, #names do
    local list = WHOLE[names[n]] and whole or plain
    list[#list + 1] = names[n]
  end
  parts[#parts + 1] = { kind = kind, width = width, names = plain }
  parts[#parts + 1] = { kind = "integer", width = width, names = whole }
end

-- The same for columns with values of a fresh slot; their type tells the kind.
local function describeByValue(parts, names, values, width)
  for _, kind in ipairs({ "number", "boolean" }) do
    local list = {}
    for n = 1, #names do
      if type(values[names[n]]) == kind then
        list[#list + 1] = names[n]
      end
    end
    describe(parts, list, kind, width)
  end
end

--- What `columnStore` makes: the columns of slots, lists of slots, and the columns of pairs.
local slots, lists, pairsAndHalves = {}, {}, {}
layout.SLOTS, layout.LISTS, layout.PAIRS = slots, lists, pairsAndHalves
describeByValue(slots, layout.SLOT_NAMES, layout.SLOT, 1)
describe(slots, layout.ANY_NAMES, "any", 1)
describeByValue(slots, layout.AXIS_NAMES, layout.AXIS, 2)
describe(slots, layout.SIDE, "number", 5)
describe(lists, SLOT_LIST, "number", 1)
describe(pairsAndHalves, PAIR, "number", 1)
describe(pairsAndHalves, PAIR_FLAG, "boolean", 1)
describe(pairsAndHalves, PAIR_LIST, "number", 1)
describe(pairsAndHalves, HALF, "number", 2)
describe(pairsAndHalves, HALF_LIST, "number", 2)

return layout
