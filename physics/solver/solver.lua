---@diagnostic disable
--- The solver: computes where each body ends a step, and how fast, from its path of free flight and
-- from the bodies that it touches or meets.
--
-- The stages are in `solve`:
-- 1. Settle contacts that exist at the start, with their friction (`settleTouching`).
-- 2. Correct corners (`nudgeTouching`).
-- 3. Rounds: sweep, resolve the first impacts (`rounds`), settle again (`settleLate`). Boxes that
--    slopes squeeze are clipped (`clip`), with rounds again.
-- 4. Limit the motion of overlapping bodies (`bounds`), lower bodies with the ground (`snap`), note
--    which bodies are pressed and which are crushed (`notePressed`).
--
-- Where there are slopes, boxes follow the ground (`walk`) after 2. and after each round. Where
-- there are circles, their slanted contacts are solved (`press`) at the same places.
--
-- A stage only changes where paths end and how fast (`to`, `speed`, `accel`); impacts, nudges and
-- clips also change where and when they begin (`from`, `time`). Every later stage starts from that
-- state, so the last word is with the last stage: with walls in `bounds`.
--
-- A step is bounded. It has at most ROUNDS rounds, in each of which a body takes part in one
-- impact. Each round makes a fixed number of passes over the contacts. Work that cannot be finished
-- is left to the next step.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local bounds = require(root .. ".memory.lazy")(root .. ".solver.bounds")
local clip = require(root .. ".memory.lazy")(root .. ".solver.clip")
local contacts = require(root .. ".solver.contacts")
local flow = require(root .. ".solver.flow")
local friction = require(root .. ".memory.lazy")(root .. ".solver.friction")
local impact = require(root .. ".memory.lazy")(root .. ".solver.impact")
local islands = require(root .. ".sleep.islands")
local links = require(root .. ".memory.links")
local move = require(root .. ".motion.move")
local nudge = require(root .. ".memory.lazy")(root .. ".solver.nudge")
local pairFinder = require(root .. ".broadphase.pairFinder")
local rounds = require(root .. ".solver.rounds")
local press = require(root .. ".memory.lazy")(root .. ".solver.press")
local slant = require(root .. ".memory.lazy")(root .. ".solver.slant")
local settle = require(root .. ".solver.settle")
local snap = require(root .. ".memory.lazy")(root .. ".solver.snap")
local sweep = require(root .. ".solver.sweep")
local walk = require(root .. ".memory.lazy")(root .. ".solver.walk")

local solver = {}

local floor, max = math.floor, math.max

-- Maximum number of rounds (sweep, impacts, settle) in a step.
local ROUNDS = 36
-- Number of last rounds in which nothing bounces, so that the remaining contacts settle. (With 5,
-- the boxes of a column of 12 that bounce end in each other.)
local LATE = 12
-- Maximum number of restarts of a step because a path came near a sleeping body. After these, all
-- bodies are woken.
local RESTARTS = 8
-- How often boxes are clipped: one that was stopped is in the way of others.
local CLIPS = 8
-- How often slanted contacts are solved before the first round.
local PRESSES = 3

--- Creates the lists that the solver needs in the columns of a world.
function solver.adopt(b)
  b.contacts = { [0] = contacts.newList(0), contacts.newList(1) }
  b.violated = { [0] = contacts.newList(0, true), contacts.newList(1, true) }
  b.impacts = sweep.newImpacts()
  b.slants = { count = 0 }
end

-- Settles the bodies that touch at the start of the step: first along gravity, then across it, each
-- followed by its friction. (`friction.run` settles the axis that it rubs along.)
local function settleTouching(b, dt)
  contacts.find(b)
  local down, across = b.downAxis, 1 - b.downAxis
  settle.axis(b, b.contacts[down], dt, false)
  if not (b.hasFriction and friction.run(b, down, dt)) then
    settle.axis(b, b.contacts[across], dt, false)
  end
  if b.hasFriction then
    friction.run(b, across, dt)
  end
end

-- Nudges bodies that are pressed against a corner, and settles again from their new places.
local function nudgeTouching(b, dt)
  if nudge.run(b) then
    pairFinder.run(b, b.awakeList, b.awakeCount)
    flow.begin(b)
    flow.reset(b, 0, dt)
    flow.reset(b, 1, dt)
    settleTouching(b, dt)
  end
end

-- Settles the bodies that are connected with violated contacts, or all (`mustSettle`), follows the
-- ground, and looks up the neighbours of the new paths. `isFirst`: before the first round.
local function settleLate(b, dt, isFirst)
  local settleAxis = b.mustSettle and settle.axis or settle.again
  settleAxis(b, b.contacts[b.downAxis], dt, true)
  settleAxis(b, b.contacts[1 - b.downAxis], dt, true)
  b.mustSettle = false
  rounds.findChanged(b)
  if b.walks then
    walk.run(b, dt, isFirst)
    rounds.findChanged(b)
  end
end

-- Solves the slanted contacts of round bodies, and settles the bodies again that were pushed there.
-- `isFirst`: nothing was swept yet, so that pairs may be added.
local function pressRound(b, dt, isFirst)
  for n = 1, b.hasRound and (isFirst and PRESSES or 1) or 0 do
    if isFirst then
      slant.find(b, n == 1)
    end
    if press.run(b, isFirst) then
      b.mustSettle = true -- so that contacts are exactly flush again
      settleLate(b, dt, false)
    elseif n > 1 then
      return
    end
  end
end

-- Makes the stages before the first round: settles the bodies that touch when the step begins,
-- corrects corners, follows the ground, and solves slanted contacts.
local function prepare(b, dt)
  b.solveStamp, b.mustSettle, b.isTight = b.solveStamp + 1, false, false
  b.blockedCount, b.changedCount, b.dirtyStamp = 0, 0, b.dirtyStamp + 1
  b.contacts[0].isFresh, b.contacts[1].isFresh = true, true
  flow.begin(b)
  pairFinder.listLive(b)
  if b.walks then
    walk.begin(b)
  end
  settleTouching(b, dt)
  if b.hasAids then
    nudgeTouching(b, dt)
  end
  settleLate(b, dt, true) -- friction, or crushed circles, may have violated other contacts
  pressRound(b, dt, true)
end

-- Makes the rounds, until nothing meets or bodies are woken. Returns whether bodies may have left
-- the ground since it was followed, or may end in each other.
local function runRounds(b, dt, awakenings)
  for n = 1, ROUNDS do
    if b.awakenings ~= awakenings or not rounds.run(b, dt, n == ROUNDS, n > ROUNDS - LATE) then
      break
    elseif n == ROUNDS then
      return true
    end
    settleLate(b, dt, false)
    pressRound(b, dt, false)
  end
  return b.overlapCount > 0 or b.isTight
end

-- Notes that body k is crushed if it is squeezed, and that body m presses it on a side. If none
-- presses the other side, it is crushed by the body that holds it there.
local function noteCrush(b, k, side, m)
  local crusher, low, high = b.crusher, 2 * k + 1, 2 * k + 2
  if b.squeezed[k] ~= 0 then
    if crusher[low] == 0 then
      crusher[low], crusher[high] = floor(b.holder[low] * 0.5), floor(b.holder[high] * 0.5)
    end
    crusher[2 * k + side], b.hasOverlaps = floor(m * 0.5), true
  end
end

-- Notes the sides on which bodies lean on each other along an axis at the end of a step, the hits
-- of contacts that begin so, and which bodies are crushed: squeezed between two that cannot give
-- way.
--
-- A crushed body stays where it overlaps its neighbours the least (see settle.lua), and is free
-- again as soon as there is room. How it came there is remembered with the pair (`wedged`). So it
-- leaves along the same axis and is never squeezed out sideways.
local function notePressed(b, axis)
  local list, pressed, hit, contact = b.contacts[axis], b.pressed, b.hit, b.contact
  local pressedAt, stamp = b.pressedAt, b.solveStamp
  for c = 1, list.count do
    local p, kl, kh = list.pair[c], list.low[c], list.high[c]
    if pressed[p] == 1 then
      pressedAt[2 * kl + 2], pressedAt[2 * kh + 1] = stamp, stamp
      b.resolved = b.resolved + (hit[p] == 0 and 1 or 0)
      if contact[p] == 0 then
        impact.note(b, p, floor(kl * 0.5), axis, max(b.start[kl] - b.start[kh], 0.0), 0)
      end
      noteCrush(b, kl, 2, kh)
      noteCrush(b, kh, 1, kl)
    end
  end
end

-- Notes a hit of each pair that overlapped and was parted before the solve.
local function noteParted(b)
  local work = b.partWork
  for n = 1, work.partedCount do
    local p = links.pairOf(b, work.low[n], work.high[n])
    if p and not b.passing[p] then
      impact.note(b, p, work.low[n], work.axis[n], 0.0, 0.0)
    end
  end
end

-- Solves a step for all awake bodies. Returns false if bodies were woken on the way; the result is
-- void then.
local function solve(b, dt)
  local awakenings = b.awakenings
  prepare(b, dt)
  local hasChanged = runRounds(b, dt, awakenings)
  for _ = 1, b.walks and CLIPS or 0 do
    -- (If bodies have woken, the step begins anew: their contacts are not known yet.)
    if b.awakenings ~= awakenings or not clip.run(b, dt) then
      break
    end
    hasChanged = runRounds(b, dt, awakenings) or hasChanged
  end
  if hasChanged or b.hasRound then
    bounds.run(b, dt, hasChanged)
  end
  if b.hasAids then
    snap.run(b)
  end
  if b.awakenings ~= awakenings then
    return false
  end
  notePressed(b, 0)
  notePressed(b, 1)
  noteParted(b)
  if b.hasRound then
    slant.tell(b)
  end
  return true
end

-- Puts everything back to the start of the step and computes the free flight again.
local function restart(b, dt)
  local list, from, origin, time = b.awakeList, b.from, b.origin, b.time
  for n = 1, b.begun do
    local i = list[n]
    from[2 * i], from[2 * i + 1] = origin[2 * i], origin[2 * i + 1]
    time[i] = 0
  end
  move.run(b, dt)
end

--- Resolves all contacts and impacts of a step of dt s.
function solver.run(b, dt)
  for _ = 1, RESTARTS do
    if solve(b, dt) then
      return
    end
    restart(b, dt)
  end
  -- With all bodies awake, no path can come near a sleeping one.
  islands.wakeAll(b)
  restart(b, dt)
  solve(b, dt)
end

return solver
