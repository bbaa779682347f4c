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
    "while cell < size and level < LEVELS do",
    "while cell <= size and level < LEVELS do",
    "a box as large as a cell goes one level up, and is found there",
  },
  {
    "physics/broadphase/grid.lua",
    "while self.highest > 0 and self.members[self.highest] == 0 do",
    "while self.highest > 1 and self.members[self.highest] == 0 do",
    "empty levels are skipped all the same",
  },
  {
    "physics/broadphase/grid.lua",
    "return (width / cell + 3) * (height / cell + 3) > 16 + self.count",
    "return (width / cell + 4) * (height / cell + 3) > 16 + self.count",
    "when all are looked at instead of cells; each is tested in both cases",
  },
  {
    "physics/broadphase/grid.lua",
    "local axis = wideY > wideX and 1 or 0",
    "local axis = wideY >= wideX and 1 or 0",
    "a diagonal may be taken in strips either way; each is tested in the end",
  },
  {
    "physics/broadphase/grid.lua",
    "self.ranges[rangeCount + 3], self.ranges[rangeCount + 5] = 0, 0",
    "self.ranges[rangeCount + 4], self.ranges[rangeCount + 5] = 0, 0",
    "what lies behind the end is read and not used, be it a number or nothing",
  },
  {
    "physics/objects/readFields.lua",
    "b.hasCarriers = b.hasCarriers or b.kind[i] == KINEMATIC or b.surfaceSpeed[i] ~= 0",
    "b.hasCarriers = b.hasCarriers or b.kind[i] ~= KINEMATIC or b.surfaceSpeed[i] ~= 0",
    "carriers are looked for where there are none; without a rider none is found",
  },
  {
    "physics/memory/layout.lua",
    "news = false, -- something other than its motion has changed in this step",
    "news = true, -- something other than its motion has changed in this step",
    "begin.lua resets it for each awake body, and it is read of no other",
  },
  {
    "physics/memory/layout.lua",
    "pressedLow = false, -- something rested against this side in this step",
    "pressedLow = true, -- something rested against this side in this step",
    "read of awake dynamic bodies, for which begin.lua resets it at each step",
  },
  {
    "physics/memory/layout.lua",
    "to = 0, -- end of the path: its position at the end of the step",
    "to = 1, -- end of the path: its position at the end of the step",
    "a new object is given its place at once (see objects/read.lua)",
  },
  {
    "physics/memory/initial.lua",
    "b.pairSlots = 0",
    "b.pairSlots = 1",
    "the first place of the pairs is never used; no awake body is in it",
  },
  {
    "physics/memory/initial.lua",
    "b.hasCarriers = false -- an object has been a carrier",
    "b.hasCarriers = true -- an object has been a carrier",
    "carriers are looked for where there are none",
  },
  {
    "physics/memory/columns.lua",
    "b.from[k], b.to[k], b.speed[k], b.size[k] = 0, 0, 0, -1",
    "b.from[k], b.to[k], b.speed[k], b.size[k] = 0, 0, 0, -2",
    "the size of the empty slot: a negative one is never within reach",
  },
  {
    "physics/broadphase/pairFinder.lua",
    "or from[k] + size[k] > fatHigh[k]",
    "or from[k] + size[k] >= fatHigh[k]",
    "its neighbours are looked up one step earlier; more neighbours change no result",
  },
  {
    "physics/broadphase/pairFinder.lua",
    "return b.placed[i] ~= 2",
    "return b.placed[i] ~= 3",
    "the neighbours of all bodies are looked up in every step; more neighbours change no result",
  },
  {
    "physics/queries/query.lua",
    "line.from, done, piece = to, done + piece, piece * 2",
    "line.from, done, piece = to, done + piece, piece * 3",
    "how much of a ray is looked at next; the nearest of all pieces is the same",
  },
  {
    "physics/state/restoreMemory.lua",
    "return (object.friction or -1) == b.friction[i] and not object.mask and not b.mask[i]",
    "return (object.friction or -2) == b.friction[i] and not object.mask and not b.mask[i]",
    "static objects are read again, to the same end; what that marks is forgotten right after it",
  },
  {
    "physics/state/restoreMemory.lua",
    "b.fresh[i] = false",
    "b.fresh[i] = true",
    "a restored object is awake for a step at least, rests one step later, and is not saved so",
  },
  {
    "physics/objects/groups.lua",
    "mixed = false,",
    "mixed = true,",
    "keys are counted where a look at the next one would do",
  },
  {
    "physics/state/saveMemory.lua",
    "while at > 1 and numbers[other[found[at - 1]]] > number do",
    "while at > 1 and numbers[other[found[at - 1]]] >= number do",
    "two neighbours have one pair only, so no two numbers are equal",
  },
  {
    "physics/queries/index.lua",
    "or position[k + 1] < fatLow[k + 1]",
    "or position[k + 1] <= fatLow[k + 1]",
    "a box of a question's grid is drawn anew before it must be",
  },
}
