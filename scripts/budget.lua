--- The budget of the core: how many code lines each folder may have. `make lint` compares it with
--- the files. The numbers only go down: what needs room takes it from another place in the same
--- change, and what a change has freed leaves the table.
---
---   luajit scripts/budget.lua

local BUDGET = {
  { "physics.lua", 86 },
  { "physics/broadphase", 625 },
  { "physics/contacts", 373 },
  { "physics/fields", 658 },
  { "physics/maps", 2637 },
  { "physics/memory", 890 },
  { "physics/motion", 1053 },
  { "physics/narrowphase", 566 },
  { "physics/objects", 1308 },
  { "physics/overlaps", 832 },
  { "physics/queries", 846 },
  { "physics/sleep", 85 },
  { "physics/solver", 3401 },
  { "physics/space", 499 },
  { "physics/state", 1027 },
  { "physics/world", 1429 },
}
local SLACK = 10 -- code lines by which a folder may be below its number

local function run(command)
  local pipe = assert(io.popen(command))
  local text = pipe:read("*a")
  pipe:close()
  return text
end

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
local function countFolders()
  local counts, all = {}, 0
  for path in run("find physics.lua physics -name '*.lua' ! -name types.lua"):gmatch("[^\n]+") do
    local folder = path:match("^physics/[^/]+") or path
    local lines = countCode(path)
    counts[folder], all = (counts[folder] or 0) + lines, all + lines
  end
  return counts, all
end

local counts, all = countFolders()
local isMet, allowed = true, 0
for _, row in ipairs(BUDGET) do
  local folder, most = row[1], row[2]
  local count = counts[folder] or 0
  allowed, counts[folder] = allowed + most, nil
  local word = count > most and "too many" or count < most - SLACK and "lower the number" or ""
  isMet = isMet and word == ""
  print(("%6d of %5d  %s  %s"):format(count, most, folder, word))
end
for folder in pairs(counts) do
  isMet = false
  print(folder .. " has no row")
end
print(("%6d of %5d  code lines in all"):format(all, allowed))
os.exit(isMet and 0 or 1)
