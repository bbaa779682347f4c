---@diagnostic disable
--- Islands: computes from the last step which bodies may sleep. A sleeping body is not computed.
--
-- Objects with fat boxes that meet, directly or through others, form an island:
--
--      [a][b]   [c]            {a, b} and {c} are islands. They have a static ground in common, but
--      ////////////            it joins no islands, as it passes nothing on.
--
-- A step computes the new state of an island from its old state and from its surroundings, and from
-- nothing else. So if the last step changed no bit of an island, nothing in it has any speed, and
-- its surroundings stay as they are, the next step would change no bit either, nor would any step
-- after it: the state is a fixed point. Then its movers fall asleep together, and are obstacles
-- that do not move.
--
-- Notes that keep a body awake: `tellMotion` in objects/write.lua calls a body *quiet* if the step
-- has changed no bit of its place and velocity, its speed is 0 (of a dynamic body: at the end or at
-- the start), `wayLeft` is 0, and `hasNews` there finds none of these notes. At the end of the step
-- `mustStayAwake` says whether it is not quiet.
--
--     mustStayAwake  a contact that begins, ends or bounces (`contactState.update`), any slanted
--                    impact (`ball.impact`, `together.run`); another support or carrier, a hit of
--                    this update (write); a nudge (`nudge`), a bounded step (`putBefore` in
--                    bounds); a way out of an overlap (`bury` in overlap, `crowd.run`, `count` in
--                    patience); an impulse of a slanted pair that falls below a quarter
--                    (`slant.tell`). A body that was put back to its place (`stillAt`, by
--                    `path.putBack`) sleeps all the same, unless it is buried and not stuck yet;
--                    `slant.tell` and `count` take that back.
--     moved          the game has changed any of its fields but velocity, `ax` and `ay` (by
--                    `reread` in read: `pairFinder.markMoved`), or called `refresh`
--                    (`carriers.noteJump`), or `put` in overlap has parted it from others
--     isPolled       it meets something, if only to pass through it, for which one of the two or
--                    the world has a `canCollide` (rules), or is in a contact that has `onStay`
--     crowd          its crowd was laid out and it is apart now: the next step forgets the crowd
--
-- `islands.settle` puts an island to sleep if all its bodies are quiet, its awake kinematic
-- neighbours, too (`gather`), and the step is not below `islands.SHORTEST`. (`step.lua` asks for
-- that where the setting `rest` allows it.)
--
-- Waking: everything that could end the fixed point wakes the whole island first
-- (`islands.wake`), before it has an effect:
--
-- - velocities and accelerations that the game wrote (objects/readFields), other fields, objects
--   that come, go or change their order or group (objects/read), settings and masks
--   (objects/settings), `shift`, `refresh`, a restored state, `dropThrough` (world/world.lua);
-- - a new or lost neighbour, a body that overlaps others (broadphase/, overlaps/), soft crowds
--   (motion/drift);
-- - a kinematic object that starts or comes near, and steps below SHORTEST;
-- - a path that comes near (`wakeLinked` in pairFinder). In the middle of a step: the step begins
--   anew, after some times with all bodies awake (`solver.run`).
--
-- So sleeping changes no result, bit for bit. A kinematic object is an island of its own: as long
-- as it stands, it is only a wall. One search visits each body and each pair of an island once.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local boxes = require(root .. ".space.boxes")
local constants = require(root .. ".memory.constants")
local links = require(root .. ".memory.links")

local islands = {}

local STATIC, DYNAMIC, neighbours = constants.STATIC, constants.DYNAMIC, links.neighbours

--- The shortest step in which bodies fall asleep, s: in a shorter step a change may be too small to
--- alter any bit. In a shorter step no sleeping body is skipped either: changes that cancel in a
--- long step may not cancel in a short one.
islands.SHORTEST = 1 / 2000

local function rouse(b, i)
  local n = b.awakeCount + 1
  b.awakeCount, b.awakeList[n], b.awakeAt[i], b.awakenings = n, i, n, b.awakenings + 1
end

--- Wakes an object and, if it slept, its island: the sleeping dynamic neighbours of all that wake.
--- The list of awake bodies is the queue of this flood fill.
function islands.wake(b, i)
  local list, kind, awakeAt = b.awakeList, b.kind, b.awakeAt
  if kind[i] == STATIC or awakeAt[i] > 0 or not b.active[i] then
    return
  end
  local n = b.awakeCount + 1
  rouse(b, i)
  while n <= b.awakeCount do
    for _, j in neighbours(b, list[n]) do
      if kind[j] == DYNAMIC and awakeAt[j] == 0 then
        rouse(b, j)
      end
    end
    n = n + 1
  end
end

--- Wakes all neighbours of an object, which may be static.
function islands.wakeNeighbours(b, i)
  for _, j in neighbours(b, i) do
    islands.wake(b, j)
  end
end

--- Wakes all bodies, for example because a setting has changed.
function islands.wakeAll(b)
  for n = 1, b.moverCount do
    islands.wake(b, b.movers[n])
  end
end

--- Takes an object out of the list of awake bodies.
function islands.drop(b, i)
  if b.awakeAt[i] > 0 then
    local at, last = b.awakeAt[i], b.awakeList[b.awakeCount]
    b.awakeList[at], b.awakeAt[last] = last, at
    b.awakeAt[i], b.awakeCount, b.awakenings = 0, b.awakeCount - 1, b.awakenings + 1
  end
end

-- Lists the island of an awake object in `b.stack`. Returns its size, and whether all of its
-- bodies are quiet. A kinematic neighbour, which is an island of its own, must be quiet, too.
local function gather(b, i, stamp)
  local island, kind, awakeAt, mark = b.stack, b.kind, b.awakeAt, b.mark
  local count, n, isQuiet, isBusy = 1, 1, true, b.mustStayAwake
  island[1], mark[i] = i, stamp
  if kind[i] ~= DYNAMIC then
    return 1, true
  end
  while n <= count do
    local member = island[n]
    isQuiet = isQuiet and not isBusy[member]
    for _, j in neighbours(b, member) do
      if kind[j] == DYNAMIC and awakeAt[j] > 0 and mark[j] ~= stamp then
        count, mark[j] = count + 1, stamp
        island[count] = j
      elseif kind[j] ~= DYNAMIC and awakeAt[j] > 0 then
        isQuiet = isQuiet and not isBusy[j]
      end
    end
    n = n + 1
  end
  return count, isQuiet
end

--- Puts every island to sleep that is quiet after a step of dt s, with the setting `rest`. Its
--- bodies are obstacles for others until they wake.
function islands.settle(b, dt)
  b.stamp = b.stamp + 1
  local stamp, list, isBusy, mark = b.stamp, b.awakeList, b.mustStayAwake, b.mark
  for n = b.rest and dt >= islands.SHORTEST and b.awakeCount or 0, 1, -1 do
    local i = list[n]
    -- Sleeping bodies are dropped from the list, which may bring others to this place.
    if i and n <= b.awakeCount and not isBusy[i] and mark[i] ~= stamp then
      local count, isQuiet = gather(b, i, stamp)
      for m = 1, isQuiet and count or 0 do
        boxes.stand(b, b.stack[m])
        islands.drop(b, b.stack[m])
      end
    end
  end
end

return islands
