--- Lists, for each field of objects, the files of the core that name it, besides those that handle
--- all fields alike (physics/fields) or read them (objects/readFields.lua). A field should be named
--- where it acts only. The same for the files that write the path of a body. `make lint` compares
--- the counts with this table. They only ever go down.
---
---   luajit scripts/field_files.lua          fails where a field is named by more files
---   luajit scripts/field_files.lua slope    shows which files name it

package.path = "./?.lua;" .. package.path

local fields = require("physics.fields.fields")
local projectFiles = require("spec.support.files")

-- Files that may name a field; 2 if it is not here.
local ALLOWED = {
  surfaceSpeed = 2,
  airFriction = 2,
  radius = 10,
  ax = 3,
  ay = 3,
  static = 19,
  kinematic = 9,
  active = 14,
  sensor = 21,
  area = 4,
  pushable = 5,
  mass = 7,
  friction = 3,
  restitution = 3,
  drag = 4,
  mask = 5,
  hits = 7,
  carry = 3,
  oneWay = 12,
  slope = 8,
  nudge = 4,
  snap = 3,
  touching = 13,
  onStay = 3,
  canCollide = 4,
}
local FEW = 2

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

local files = {}
for _, path in ipairs(projectFiles.list("find physics -name '*.lua'")) do
  local isLeftOut = path:find("^physics/fields/")
    or path == "physics/types.lua"
    or path == "physics/objects/readFields.lua"
  if not isLeftOut then
    files[#files + 1] = { path = path, code = codeOf(path) }
  end
end

local isMet, sum = true, 0
for _, row in ipairs(fields.objects) do
  local name, found = row.name, {}
  for _, file in ipairs(EVERYWHERE[name] and {} or files) do
    if file.code:find("%f[%w_]" .. name .. "%f[^%w_]") then
      found[#found + 1] = file.path
    end
  end
  local most, count = ALLOWED[name] or FEW, #found
  sum = sum + count
  if name == arg[1] then
    print(table.concat(found, "\n"))
  elseif count > most then
    isMet = false
    print(("%s is named by %d files, at most %d may:"):format(name, count, most))
    print("  " .. table.concat(found, "\n  "))
  elseif count < most and ALLOWED[name] then
    print(("%s is named by %d files only: lower its number, which is %d"):format(name, count, most))
  end
end
print(sum .. " times a file names a field")

-- Files that write a column: an assignment names it on its left side.
for name, most in pairs({ to = 11, speed = 11, from = 6, accel = 8 }) do
  local found, own, alias = {}, "b%." .. name .. "%[", "%f[%w_.]" .. name .. "%["
  for _, file in ipairs(files) do
    local isAlias, isWriter = file.code:find("b%." .. name .. "%f[^%w_%[]"), false
    for left in file.code:gmatch("\n%s*([^\n=]-) =%s") do
      local isHere = left:find(own) or isAlias and left:find(alias)
      isWriter = isWriter or isHere and not left:find("^local ")
    end
    found[#found + 1] = isWriter and file.path or nil
  end
  if #found > most then
    isMet = false
    print(("%s is written by %d files, at most %d may:"):format(name, #found, most))
    print("  " .. table.concat(found, "\n  "))
  elseif name == arg[1] then
    print(table.concat(found, "\n"))
  end
end
os.exit(isMet and 0 or 1)
