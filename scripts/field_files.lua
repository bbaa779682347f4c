--- Lists, for each field of objects, the files of the core that name it, besides those that handle
--- all fields alike (physics/fields) or read them (objects/readFields.lua). A field should be named
--- where it acts only. The same for the files that write the path of a body. `make lint` compares
--- the counts with this table. They only ever go down.
---
---   luajit scripts/field_files.lua          fails where a field is named by more files
---   luajit scripts/field_files.lua slope    shows which files name it

package.path = "./?.lua;" .. package.path

local fields = require("physics.fields.fields")
local files = require("spec.support.files")

-- Files that may name a field; 2 if it is not here.
local ALLOWED = {
  surfaceSpeed = 2,
  airFriction = 1,
  radius = 10,
  ax = 3,
  ay = 3,
  static = 19,
  kinematic = 9,
  active = 14,
  sensor = 19,
  area = 4,
  pushable = 4,
  mass = 7,
  friction = 3,
  restitution = 2,
  drag = 3,
  mask = 5,
  hits = 7,
  carry = 3,
  oneWay = 12,
  slope = 8,
  nudge = 4,
  snap = 3,
  touching = 12,
  onStay = 3,
  canCollide = 4,
}
local FEW = 2

-- Files that may write a column of the path of a body.
local WRITERS = { to = 11, speed = 11, from = 6, accel = 8 }

-- Place, size and velocity are what the core is about.
local EVERYWHERE = { x = true, y = true, width = true, height = true, vx = true, vy = true }

-- Returns the code of a file, without comments.
local function codeOf(path)
  local lines = {}
  for line in io.lines(path) do
    lines[#lines + 1] = line:match("^%s*%-%-") and "" or line:gsub("%s%-%-%s.*", "")
  end
  return table.concat(lines, "\n")
end

local sources = {}
for _, path in ipairs(files.list("find physics -name '*.lua'")) do
  local isLeftOut = path:find("^physics/fields/")
    or path == "physics/types.lua"
    or path == "physics/objects/readFields.lua"
  sources[#sources + 1] = not isLeftOut and { path = path, code = codeOf(path) } or nil
end

local isMet, sum = true, 0

-- Compares the files for which `isOne(code)` holds with how many there may be. Returns how many
-- there are.
local function compare(name, is, most, isOne)
  local found = {}
  for _, source in ipairs(sources) do
    found[#found + 1] = isOne(source.code) and source.path or nil
  end
  if name == arg[1] then
    print(table.concat(found, "\n"))
  elseif #found > most then
    isMet = false
    print(("%s is %s by %d files, at most %d may:"):format(name, is, #found, most))
    print("  " .. table.concat(found, "\n  "))
  elseif #found < most and is == "named" and ALLOWED[name] then
    print(("%s is named by %d files only: lower its number, %d"):format(name, #found, most))
  end
  return #found
end

for _, row in ipairs(fields.objects) do
  if not EVERYWHERE[row.name] then
    local most = ALLOWED[row.name] or FEW
    sum = sum
      + compare(row.name, "named", most, function(code)
        return code:find("%f[%w_]" .. row.name .. "%f[^%w_]")
      end)
  end
end
print(sum .. " times a file names a field")

-- Files that write a column: an assignment names it on its left side.
for name, most in pairs(WRITERS) do
  local own, alias = "b%." .. name .. "%[", "%f[%w_.]" .. name .. "%["
  compare(name, "written", most, function(code)
    local isAlias, isWriter = code:find("b%." .. name .. "%f[^%w_%[]"), false
    for left in code:gmatch("\n%s*([^\n=]-) =%s") do
      local isHere = left:find(own) or isAlias and left:find(alias)
      isWriter = isWriter or isHere and not left:find("^local ")
    end
    return isWriter
  end)
end
os.exit(isMet and 0 or 1)
