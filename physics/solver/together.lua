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
local impact = require(root .. ".solver.impact")
local path = require(root .. ".motion.path")
local press = require(root .. ".solver.press")
local rules = require(root .. ".narrowphase.rules")
local slant = require(root .. ".solver.slant")
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
    one = {}, -- the low body
    other = {}, -- the high body
    nx = {}, -- unit normal to the low body
    ny = {},
    dx = {}, -- by how much an impulse of 1 changes the velocity of each, px/s
    dy = {},
    ex = {},
    ey = {},
    total = {}, -- and that along the normal
    impulse = {},
    bounce = {}, -- restitution
    at = {}, -- by slot: when it was listed
    v = {}, -- by body: its velocity
  }
end

-- Returns whether impact n may join: one of the two is round, they may bounce, are not deep, and
-- nothing has changed them. (The first impact of a list: `happen` in rounds. Those of sensors have
-- other moments.)
local function mayJoin(b, n)
  local impacts, round = b.impacts, b.roundStamp
  local i, j, p, axis = impacts.low[n], impacts.high[n], impacts.pair[n], impacts.axis[n]
  return not (b.passing[p] or impacts.isDeep[n])
    and b.inRound[i] ~= round
    and b.inRound[j] ~= round
    and yielding.elasticity(b, i, j) > 0
    and ball.isRound(b, i, j)
    and not rules.passes(b, p, 2 * i + axis, 2 * j + axis, axis, false)
end

-- Adds impact c to the list, and marks its bodies.
local function join(b, list, c)
  local n, i, j = list.count + 1, b.impacts.low[c], b.impacts.high[c]
  list.count, list.impact[n], list.joined[c], list.one[n], list.other[n] = n, c, list.stamp, i, j
  list.at[i], list.at[j] = list.stamp, list.stamp
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
-- and notes their velocities there, how they give way, whether they bounce, and the hits.
local function prepare(b, list, t, tau)
  local impacts, dt, v = b.impacts, b.dt, list.v
  for n = 1, list.count do
    local c, i, j = list.impact[n], list.one[n], list.other[n]
    local k, m = 2 * i, 2 * j
    path.advance(b, i, t)
    path.advance(b, j, t)
    local u, a, nx, ny = ball.closing(b, i, j, t, tau)
    local ix, iy, jx, jy = ball.weigh(b, i, j, nx, ny)
    v[k], v[k + 1] = ball.speedAt(b, k, tau), ball.speedAt(b, k + 1, tau)
    v[m], v[m + 1] = ball.speedAt(b, m, tau), ball.speedAt(b, m + 1, tau)
    list.nx[n], list.ny[n], list.impulse[n] = nx, ny, 0.0
    list.dx[n], list.dy[n], list.ex[n], list.ey[n] = nx * ix, ny * iy, nx * jx, ny * jy
    list.total[n] = nx * nx * (ix + jx) + ny * ny * (iy + jy)
    local isFast = u > 2 * dt * max(a, -a)
    list.bounce[n] = isFast and yielding.elasticity(b, i, j) or 0.0
    impact.note(b, impacts.pair[c], i, impacts.axis[c], max(u, 0.0), t)
  end
end

-- Finds the impulses with which no pair closes.
local function solve(list)
  for _ = 1, PASSES do
    local most, largest = 0.0, 0.0
    for n = 1, list.count do
      local u = -slant.along(list.v, list.one[n], list.other[n], list.nx[n], list.ny[n])
      local more = list.total[n] > 0 and max(u / list.total[n], -list.impulse[n]) or 0.0
      list.impulse[n] = list.impulse[n] + more
      press.pushApart(list.v, list, n, more)
      most, largest = max(most, more, -more), max(largest, list.impulse[n])
    end
    if most <= LEAST * largest then
      return
    end
  end
end

--- Resolves the n-th impact of this round together with the impacts of round bodies that are linked
--- with it at the same moment. Returns their list; nil: there are no others.
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
  solve(list)
  for m = 1, list.count do
    press.pushApart(list.v, list, m, list.bounce[m] * list.impulse[m])
  end
  for m = 1, list.count do
    for side = 1, 2 do
      local i = side == 1 and list.one[m] or list.other[m]
      for k = 2 * i, b.give[2 * i] > 0 and 2 * i + 1 or 0 do
        path.fly(b, k, list.v[k], b.accel[k], tau)
      end
      b.deflectedAt[i], b.mustStayAwake[i] = b.solveStamp, true
      b.impactsOf[i] = b.impactsOf[i] + 1
    end
    b.resolved = b.resolved + 1
  end
  return list
end

return together
