--- Changes of the core that make no difference, for scripts/mutants.lua: no spec can notice them.
---
--- A row: the file, the line as it is, the line as it would be, and why every result stays the same
--- to the bit. Where a line stands in its file more than once, those before it come with it.
---
--- Most of them choose between two ways that lead to the same (see ARCHITECTURE.md), give a value
--- that is written before it is read, or look at more than they must.

return {
  {
    "physics/broadphase/grid.lua",
    "if size > 4096 * cell then",
    "if size >= 4096 * cell then",
    "a box as long as 4096 cells is on the same level either way",
  },
  {
    "physics/broadphase/grid.lua",
    "for n = rangeCount + 2, rangeCount + 5 do",
    "for n = rangeCount + 2, rangeCount + 6 do",
    "one number more behind the end is written; none of them is used",
  },
  {
    "physics/objects/readFields.lua",
    "b.hasCarriers = b.hasCarriers or b.kind[i] == KINEMATIC or b.surfaceSpeed[i] ~= 0",
    "b.hasCarriers = b.hasCarriers or b.kind[i] ~= KINEMATIC or b.surfaceSpeed[i] ~= 0",
    "carriers are looked for where there are none; without a rider none is found",
  },
  {
    "physics/memory/layout.lua",
    "mustStayAwake = false, -- something other than its motion has changed in this step",
    "mustStayAwake = true, -- something other than its motion has changed in this step",
    "begin.lua resets it for each awake body, and it is read of no other",
  },
  {
    "physics/memory/layout.lua",
    "pressedLow = false, -- something has rested against its low side in this step",
    "pressedLow = true, -- something has rested against its low side in this step",
    "read of awake dynamic bodies, for which begin.lua resets it at each step",
  },
  {
    "physics/memory/layout.lua",
    "to = 0, -- where its path ends, px: its position after the step",
    "to = 1, -- where its path ends, px: its position after the step",
    "a new object is given its place at once (see objects/read.lua)",
  },
  {
    "physics/broadphase/gridLines.lua",
    "entryOf(fatLow, fatHigh, i, x, y, shareX, shareY) <= bound",
    "entryOf(fatLow, fatHigh, i, x, y, shareX, shareY) < bound",
    "boxes reach a little further there than they are, so what is met enters before the bound",
  },
  {
    "physics/objects/settings.lua",
    "b.gravityX, b.gravity = self.gravityX + 0.0, self.gravity + 0.0",
    "b.gravityX, b.gravity = self.gravityX + 0.0, self.gravity - 0.0",
    "only -0 stays what it is",
  },
  {
    "physics/solver/bonds.lua",
    "impulse = impulse > 0 and limit or -limit",
    "impulse = impulse >= 0 and limit or -limit",
    "an impulse of 0 tears no bond",
  },
  {
    "physics/solver/bonds.lua",
    "count = 0,",
    "count = 1,",
    "it is set before the list is filled",
  },
  {
    "physics/motion/forces.lua",
    "if pull <= brake and -pull <= brake then",
    "if pull < brake and -pull <= brake then",
    "a pull that is just as strong moves nothing in the other way, either",
  },
  {
    "physics/queries/move.lua",
    "journey.x, journey.y, journey.start, journey.rest = "
      .. "c.position[2 * i], c.position[2 * i + 1], 0, 0",
    "journey.x, journey.y, journey.start, journey.rest = "
      .. "c.position[2 * i], c.position[2 / i + 1], 0, 0",
    "what is moved is the first of its catch",
  },
  {
    "physics/state/restore.lua",
    "b[hint] = b[hint] or #list > 0",
    "b[hint] = b[hint] or #list > 1",
    "a list has two numbers or more, or none",
  },
  {
    "physics/broadphase/gridLines.lua",
    "return max(enters, max(enters - leaves, -leaves) * VAST)",
    "return min(enters, max(enters - leaves, -leaves) * VAST)",
    "more is visited, and a visit looks exactly",
  },
  {
    "physics/narrowphase/ball.lua",
    "local newI, newJ = yielding.share(b.power[i] > b.power[j], wi, wj, vi, vj)",
    "local newI, newJ = yielding.share(b.power[i] >= b.power[j], wi, wj, vi, vj)",
    "it is called only where they differ",
  },
  {
    "physics/solver/pool.lua",
    "local yields = isEven and b.rank[floor(one * 0.5)] < b.rank[floor(other * 0.5)]",
    "local yields = isEven and b.rank[floor(one * 0.5)] <= b.rank[floor(other * 0.5)]",
    "no two have one rank",
  },
  {
    "physics/narrowphase/touch.lua",
    "if axis ~= axisOf(b, i) or (side % 2 == 0) ~= (SOLID[axis][shape] > 0) then",
    "if axis ~= axisOf(b, i) or (side % 2 == 0) ~= (SOLID[axis][shape] >= 0) then",
    "of a slope it is 1 or -1",
  },
  {
    "physics/space/shapes.lua",
    "if sign > 0 then",
    "if sign >= 0 then",
    "of a slope it is 1 or -1",
  },
  {
    "physics/solver/snap.lua",
    "if most > 0 then",
    "if most >= 0 then",
    "by 0 px nothing is lowered",
  },
  {
    "physics/overlaps/heap.lua",
    "local isLink, isIn = areLoose and ball.isRound(b, i, j), gap < -EPSILON",
    "local isLink, isIn = areLoose and ball.isRound(b, i, j), gap <= -EPSILON",
    "computed gaps are never exactly that",
  },
  {
    "physics/solver/bounds.lua",
    "for k = 2 * i, isLimited and 2 * i + 1 or 0 do",
    "for k = 2 * i, isLimited and 2 * i + 1 or 1 do",
    "slots begin at 1, so 2 * i is at least 2",
  },
  {
    "physics/solver/rounds.lua",
    "for n = 1, 2 do",
    "for n = 1, 3 do",
    "slot j again, of which all is noted already",
  },
  {
    "physics/narrowphase/yielding.lua",
    "if sign < 0 and b.heldLow[k] > 0 and give > 0 then",
    "if sign <= 0 and b.heldLow[k] > 0 and give > 0 then",
    "what is 0 there is the normal, and all that is given along that axis is a multiple of it",
  },
  {
    "physics/overlaps/crowd.lua",
    "if b.crowdCount > 0 then",
    "if b.crowdCount >= 0 then",
    "crowds are looked for where there are none, and what has begun its step does not begin anew",
  },
  {
    "physics/solver/ground.lua",
    "return x + w - b.to[m] > EPSILON and b.to[m] + b.size[m] - x > EPSILON",
    "return x + w - b.to[m] > EPSILON and b.to[m] + b.size[m] - x >= EPSILON",
    "computed gaps are never exactly that",
  },
  {
    "physics/solver/ground.lua",
    "return turn * b.to[m] - touch.apart(b, i, j, axis, turn > 0, x, b.to[m + 1 - 2 * axis])",
    "return turn * b.to[m] - touch.apart(b, i, j, axis, turn >= 0, x, b.to[m + 1 - 2 * axis])",
    "where something walks it is 1 or -1",
  },
  {
    "physics/solver/impact.lua",
    "local leavesHolder = b.heldHigh[k] > 0 and v < b.speed[b.holderHigh[k]]",
    "local leavesHolder = b.heldHigh[k] > 1 and v < b.speed[b.holderHigh[k]]",
    "only what cannot move has 1, and that is left out below",
  },
  {
    "physics/queries/near.lua",
    "c.size[k], c.size[k + 1] = object.width + 0.0, object.height + 0.0",
    "c.size[k], c.size[k + 1] = object.width + 0.0, object.height - 0.0",
    "only -0 would differ, and no size is 0",
  },
  {
    "physics/queries/move.lua",
    "local p, s, k, m = c.position, c.size, 2 * i, 2 * j",
    "local p, s, k, m = c.position, c.size, 2 / i, 2 * j",
    "what is moved is the first of its catch",
  },
  {
    "physics/memory/sort.lua",
    "if patience < 0 then",
    "if patience < 1 then",
    "the other method sorts into the same order",
  },
  {
    "physics/memory/initial.lua",
    "stamp = 0, -- of the last search (see `mark`)",
    "stamp = 1, -- of the last search (see `mark`)",
    "each search counts on, and compares only with its own",
  },
  {
    "physics/objects/groups.lua",
    "if count > FEW and not (record.mixed or isGrown) and rawget(source, count + 1) == nil then",
    "if count > FEW and not (record.mixed or isGrown) and rawget(source, count - 1) == nil then",
    "a group of so many has that, so all its keys are counted, with the same answer",
  },
  {
    "physics/broadphase/grid.lua",
    "self.ranges[n] = 0",
    "self.ranges[n] = 1",
    "read, but not used",
  },
  {
    "physics/broadphase/pairFinder.lua",
    "if matters and not awake[j] and (awake[i] or kind[i] == STATIC) then",
    "if matters or not awake[j] and (awake[i] or kind[i] == STATIC) then",
    "more is woken; what is awake for nothing does nothing and sleeps again at the end of the step",
  },
  {
    "physics/narrowphase/rules.lua",
    "if (speed - (object[along] or 0)) * b.down[2 * i + axis] > 0 then",
    "if (speed - (object[along] or 0)) / b.down[2 * i + axis] > 0 then",
    "it is 1 or -1 there",
  },
  {
    "physics/solver/walk.lua",
    "return list.high, list.low, list.count, 1",
    "return list.high, list.low, list.count, 2",
    "the first contact is on ground, which lifts nothing",
  },
  {
    "physics/space/shapes.lua",
    "local offset, low, high = { 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0 }",
    "local offset, low, high = { 1, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0 }",
    "the faces are written before they are read",
  },
  {
    "physics/space/shapes.lua",
    "local share = depth < 0 and enterRound(dx, dy, radius) or 0.0",
    "local share = depth <= 0 and enterRound(dx, dy, radius) or 0.0",
    "from the rim on it enters after 0, too",
  },
  {
    "physics/world/queryMethods.lua",
    "return rays.segment(self, x1 + 0.0, y1 + 0.0, x2 + 0.0, y2 + 0.0, filter, out)",
    "return rays.segment(self, x1 - 0.0, y1 + 0.0, x2 + 0.0, y2 + 0.0, filter, out)",
    "only -0 stays what it is",
  },
  {
    "physics/broadphase/gridLines.lua",
    "and entryOf(fatLow, fatHigh, i, x, y, shareX, shareY) <= bound",
    "and entryOf(fatLow, fatHigh, i, x, y, shareX, shareY) < bound",
    "boxes reach a little further there than they are, so what is met enters before the bound",
  },
  {
    "physics/memory/allot.lua",
    "if #b.free + b.lastBody - b.lastUsed >= count then",
    "if #b.free + b.lastBody - b.lastUsed > count then",
    "more room than is needed; no result depends on slots",
  },
  {
    "physics/solver/ground.lua",
    "return to[m] <= high and to[m] + size[m] >= low "
      .. "and to[t] <= right and to[t] + size[t] >= left",
    "return to[m] <= high and to[m] + size[m] > low "
      .. "and to[t] <= right and to[t] + size[t] >= left",
    "the rectangle is a px wider than what counts",
  },
  {
    "physics/space/shapes.lua",
    "local offset, low, high = { 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0 }",
    "local offset, low, high = { 0, 1, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0 }",
    "the faces are written before they are read",
  },
  {
    "physics/solver/walk.lua",
    "if past > time[i] then",
    "if past >= time[i] then",
    "a piece without a length makes a path of nan, which meets nothing",
  },
  {
    "physics/objects/readFields.lua",
    "b.hasCarriers = b.hasCarriers or b.kind[i] == KINEMATIC or b.surfaceSpeed[i] ~= 0",
    "b.hasCarriers = b.hasCarriers or b.kind[i] == KINEMATIC or b.surfaceSpeed[i] ~= 1",
    "carriers are looked for where there are none; without a rider none is found",
  },
  {
    "physics/memory/layout.lua",
    "touchWidth = 0, -- scratch of write",
    "touchWidth = 1, -- scratch of write",
    "write sets it before it reads it",
  },
  {
    "physics/memory/layout.lua",
    "fatHigh = 0,",
    "fatHigh = 1,",
    "it is written when a body is placed, and not read before",
  },
  {
    "physics/solver/nudge.lua",
    "return size > EPSILON and size <= b.nudge[i] + EPSILON and not isBack and held[k] == 0",
    "return size >= EPSILON and size <= b.nudge[i] + EPSILON and not isBack and held[k] == 0",
    "a way of exactly that much does not come out of the places, which are sums",
  },
  {
    "physics/solver/ground.lua",
    "return to[m] <= high and to[m] + size[m] >= low and to[t] <= right"
      .. " and to[t] + size[t] >= left",
    "return to[m] < high and to[m] + size[m] >= low and to[t] <= right"
      .. " and to[t] + size[t] >= left",
    "the rectangle reaches a px further than what can be ground",
  },
  {
    "physics/solver/walk.lua",
    "if moment and (n == last or moment < past - TIE - EPSILON / max(distance, -distance)) then",
    "if moment and (n == last or moment <= past - TIE - EPSILON / max(distance, -distance)) then",
    "what is met at that very moment is met on the next piece, too, at the same place",
  },
  {
    "physics/state/restore.lua",
    "velocity[k], velocity[k + 1] = (object.vx or 0) + 0.0, (object.vy or 0) + 0.0",
    "velocity[k], velocity[k + 1] = (object.vx or 1) + 0.0, (object.vy or 0) + 0.0",
    "what has no velocity differs from it at the next step, which takes it over as 0",
  },
  {
    "physics/queries/rays.lua",
    "local isFirst = at < bound or (at == bound and (best == 0 or c.rank[n] < c.rank[best]))",
    "local isFirst = at < bound or (at == bound and (best == 0 or c.rank[n] <= c.rank[best]))",
    "no two objects have one rank, and each is looked at once",
  },
  {
    "physics/overlaps/heap.lua",
    "local isStruck = (closingOf(b, i, j, nx, ny) - fall) * dt > STRUCK * ball.smallest(b, i, j)",
    "local isStruck = (closingOf(b, i, j, nx, ny) - fall) * dt >= STRUCK * ball.smallest(b, i, j)",
    "exactly that speed along a slanted normal does not come out of the numbers",
  },
  {
    "physics/solver/pool.lua",
    "local isEven = more <= EPSILON and more >= -EPSILON",
    "local isEven = more < EPSILON and more >= -EPSILON",
    "a way of exactly that much does not come out of the places, which are sums",
  },
  {
    "physics/memory/layout.lua",
    "crushed = false, -- it is squeezed, or has no way out, in this step,",
    "crushed = true, -- it is squeezed, or has no way out, in this step,",
    "path.begin resets it for each awake body, and it is read of no other",
  },
  {
    "physics/solver/ground.lua",
    "if height >= least - EPSILON and isFirst(b, j, best, height, top) then",
    "if height > least - EPSILON and isFirst(b, j, best, height, top) then",
    "a height of exactly that much does not come out of the places, which are sums",
  },
  {
    "physics/solver/bonds.lua",
    "for n = 1, isAny and list.count or 0 do",
    "for n = 1, isAny and list.count or 1 do",
    "where there is no tower nothing is marked, so no bond is glued",
  },
  {
    "physics/memory/allot.lua",
    "local ROOM, MORE = 8, 2",
    "local ROOM, MORE = 8, 3",
    "less room is made ahead, and more often",
  },
  {
    "physics/space/shapes.lua",
    "if last >= flush or last >= first then",
    "if last > flush or last >= first then",
    "a way that ends exactly so deep ends at the face either way",
  },
  {
    "physics/overlaps/heap.lua",
    "local isIn = gapOf(b, b.to, i, j) < -EPSILON and ball.isRound(b, i, j)",
    "local isIn = gapOf(b, b.to, i, j) <= -EPSILON and ball.isRound(b, i, j)",
    "the gap of their shapes, which is asked behind it, must be less, and is no less than this one",
  },
}
