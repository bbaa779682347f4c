--- The budget of the core: how many code lines each folder may have. `make lint` compares it with
--- the files. The numbers only go down: what needs room takes it from another place in the same
--- change, and what a change has freed leaves the table.
---
---   luajit scripts/budget.lua

package.path = "./?.lua;" .. package.path

local files = require("spec.support.files")

local BUDGET = {
  { "physics.lua", 79 },
  { "physics/broadphase", 611 },
  { "physics/contacts", 364 },
  { "physics/fields", 661 },
  { "physics/maps", 2196 },
  { "physics/memory", 698 },
  { "physics/motion", 968 },
  { "physics/narrowphase", 553 },
  { "physics/objects", 1271 },
  { "physics/overlaps", 839 },
  { "physics/queries", 933 },
  { "physics/sleep", 81 },
  { "physics/solver", 3197 },
  { "physics/space", 488 },
  { "physics/state", 860 },
  { "physics/world", 1330 },
}
local SLACK = 10 -- code lines by which a folder may be below its number

-- Lines that are neither empty nor only a comment.
local function countCode(path)
  local count = 0
  for line in io.lines(path) do
    if line:find("%S") and not line:find("^%s*%-%-") then
      count = count + 1
    end
  end
  return count
end

-- Code lines by the folder below `physics`. The types for editors are no code.
local counts, all = {}, 0
for _, path in ipairs(files.list("find physics.lua physics -name '*.lua' ! -name types.lua")) do
  local folder, lines = path:match("^physics/[^/]+") or path, countCode(path)
  counts[folder], all = (counts[folder] or 0) + lines, all + lines
end

local isMet, allowed = true, 0
for _, row in ipairs(BUDGET) do
  local folder, most, count = row[1], row[2], counts[row[1]] or 0
  local word = count > most and "too many" or count < most - SLACK and "lower the number" or ""
  allowed, counts[folder], isMet = allowed + most, nil, isMet and word == ""
  print(("%6d of %5d  %s  %s"):format(count, most, folder, word))
end
for folder in pairs(counts) do
  isMet = false
  print(folder .. " has no row")
end
print(("%6d of %5d  code lines in all"):format(all, allowed))
os.exit(isMet and 0 or 1)
