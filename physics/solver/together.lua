---@diagnostic disable
--- Together: makes round bodies that meet at one moment bounce off each other at once.
--
--            (b)      a meets b and c at one moment. One after the other, b would take more than c,
--      (a)->          and which of them is first would decide it. Together both leave alike, and a
--            (c)      stays behind, or comes back.
--
-- Let v be the velocities before, and w the nearest ones, weighed by mass, at which no pair closes.
-- Each pair gives an impulse >= 0 for w. With restitution e it gives (1 + e) times that, so the
-- velocities after are v + (1 + e) (w - v). For e = 1 that is v mirrored at w, which keeps the
-- energy: w - v is normal to w (else w would not be the nearest). Pairs that close then, behind the
-- first ones, meet in the next round, at the same moment.
--
-- Impacts join if their moment is the same, as it is rounded for sorting, they may bounce, are not
-- deep, and no earlier impact of the round has changed their bodies. Restitution counts only for a
-- pair that closes by more than its acceleration gives it in two steps.
--
-- The impulses are found pair by pair, each >= 0, until none changes (projected Gauss-Seidel).
--
-- Source: B. Smith, D. Kaufman, E. Vouga, R. Tamstorf, E. Grinspun, Reflections on Simultaneous
-- Impact, 2012.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local ball = require(root .. ".narrowphase.ball")
local filter = require(root .. ".broadphase.filter")
local impact = require(root .. ".solver.impact")
local path = require(root .. ".motion.path")
local rules = require(root .. ".narrowphase.rules")
local yielding = require(root .. ".narrowphase.yielding")

local together = {}

local max = math.max
-- Passes over the pairs at most; share of the largest impulse by which the last one changes any.
local PASSES, LEAST = 200, 1e-13

-- Returns empty lists for the impacts that happen together.
local function newList()
  return {
    count = 0,
    stamp = 0,
    impact = {}, -- its number in the list of the round
    joined = {}, -- by that number: the stamp with which it was listed
    nx = {}, -- unit normal to the low body
    ny = {},
    lowX = {}, -- by how much an impulse of 1 changes the velocity of each, px/s
    lowY = {},
    highX = {},
    highY = {},
    total = {}, -- and that along the normal
    impulse = {},
    bounce = {}, -- restitution
    at = {}, -- by slot: when it was listed,
    vx = {}, -- and its velocity
    vy = {},
  }
end

-- Returns whether impact n may join: both are solid, one is round, they may bounce, are not deep,
-- and nothing has changed them. The game is asked (`rules.passes`). (The first impact of a list:
-- `happen` in rounds.)
local function mayJoin(b, n)
  local impacts, round = b.impacts, b.roundStamp
  local i, j, p, axis = impacts.low[n], impacts.high[n], impacts.pair[n], impacts.axis[n]
  return not (b.passing[p] or impacts.isDeep[n])
    and filter.areSolid(b, i, j)
    and b.inRound[i] ~= round
    and b.inRound[j] ~= round
    and yielding.elasticity(b, i, j) > 0
    and ball.isRound(b, i, j)
    and not rules.passes(b, p, 2 * i + axis, 2 * j + axis, axis, false)
end

-- Adds impact n to the list, and marks its bodies.
local function join(b, list, n)
  list.count = list.count + 1
  list.impact[list.count], list.joined[n] = n, list.stamp
  list.at[b.impacts.low[n]], list.at[b.impacts.high[n]] = list.stamp, list.stamp
end

-- Lists the n-th impact and the later impacts that happen at the same moment and are linked with
-- it: a body that can move takes part in both, or in others between them.
local function gather(b, list, n)
  local impacts, at, stamp = b.impacts, list.at, list.stamp + 1
  local order, moment, m = impacts.order, impacts.moment, n + 1
  list.count, list.stamp = 0, stamp
  join(b, list, order[n])
  while m <= impacts.count and moment[order[m]] == moment[order[n]] do
    local c = order[m]
    local i, j = impacts.low[c], impacts.high[c]
    local isLinked = at[i] == stamp and b.give[2 * i] > 0 or at[j] == stamp and b.give[2 * j] > 0
    m = m + 1
    if isLinked and list.joined[c] ~= stamp and mayJoin(b, c) then
      join(b, list, c)
      m = n + 1 -- it may link those that were passed by
    end
  end
end

-- Brings the bodies of each impact to their places at moment t, tau s before the end of the step,
-- and notes their velocities there, how they give way (`ball.weigh`), whether they bounce, and the
-- hits.
local function prepare(b, list, t, tau)
  local impacts, dt = b.impacts, b.dt
  for n = 1, list.count do
    local c = list.impact[n]
    local i, j = impacts.low[c], impacts.high[c]
    path.advance(b, i, t)
    path.advance(b, j, t)
    local u, a, nx, ny = ball.closing(b, i, j, t, tau)
    local ix, iy, jx, jy = ball.weigh(b, i, j, nx, ny)
    list.vx[i], list.vy[i] = ball.speedAt(b, 2 * i, tau), ball.speedAt(b, 2 * i + 1, tau)
    list.vx[j], list.vy[j] = ball.speedAt(b, 2 * j, tau), ball.speedAt(b, 2 * j + 1, tau)
    list.nx[n], list.ny[n], list.impulse[n] = nx, ny, 0.0
    list.lowX[n], list.lowY[n], list.highX[n], list.highY[n] = nx * ix, ny * iy, nx * jx, ny * jy
    list.total[n] = nx * nx * (ix + jx) + ny * ny * (iy + jy)
    local isFast = u > 2 * dt * max(a, -a)
    list.bounce[n] = isFast and yielding.elasticity(b, i, j) or 0.0
    impact.note(b, impacts.pair[c], i, impacts.axis[c], max(u, 0.0), t)
  end
end

-- Gives the two of impact n an impulse.
local function push(b, list, n, impulse)
  local c, vx, vy = list.impact[n], list.vx, list.vy
  local i, j = b.impacts.low[c], b.impacts.high[c]
  vx[i], vy[i] = vx[i] + impulse * list.lowX[n], vy[i] + impulse * list.lowY[n]
  vx[j], vy[j] = vx[j] - impulse * list.highX[n], vy[j] - impulse * list.highY[n]
end

-- Finds the impulses with which no pair closes.
local function solve(b, list)
  local impacts, vx, vy = b.impacts, list.vx, list.vy
  for _ = 1, PASSES do
    local most, largest = 0.0, 0.0
    for n = 1, list.count do
      local i, j = impacts.low[list.impact[n]], impacts.high[list.impact[n]]
      local u = (vx[j] - vx[i]) * list.nx[n] + (vy[j] - vy[i]) * list.ny[n]
      local more = list.total[n] > 0 and max(u / list.total[n], -list.impulse[n]) or 0.0
      list.impulse[n] = list.impulse[n] + more
      push(b, list, n, more)
      most, largest = max(most, more, -more), max(largest, list.impulse[n])
    end
    if most <= LEAST * largest then
      return
    end
  end
end

--- Resolves the n-th impact of this round together with the impacts of round bodies that are linked
--- with it at the same moment. Those that give way fly on with their accelerations. All have had an
--- impact then, were deflected and stay awake. Returns their list; nil: there are no others.
function together.run(b, n)
  b.together = b.together or newList()
  local list, impacts = b.together, b.impacts
  gather(b, list, n)
  if list.count < 2 then
    return nil
  end
  local t = impacts.time[impacts.order[n]]
  local tau = (1 - t) * b.dt
  prepare(b, list, t, tau)
  solve(b, list)
  for m = 1, list.count do
    push(b, list, m, list.bounce[m] * list.impulse[m])
  end
  for m = 1, list.count do
    for side = 1, 2 do
      local i = side == 1 and impacts.low[list.impact[m]] or impacts.high[list.impact[m]]
      if b.give[2 * i] > 0 then
        path.fly(b, 2 * i, list.vx[i], b.accel[2 * i], tau)
        path.fly(b, 2 * i + 1, list.vy[i], b.accel[2 * i + 1], tau)
      end
      b.deflectedAt[i], b.mustStayAwake[i] = b.solveStamp, true
      b.impactsOf[i] = b.impactsOf[i] + 1
    end
    b.resolved = b.resolved + 1
  end
  return list
end

return together
