--- Writes spec/README.md: for each field, setting and method the specs that are about it.
---
---   luajit scripts/spec_index.lua            writes the page
---   luajit scripts/spec_index.lua --check    fails if it would be another one
---
--- A spec is about a name if the title of its `describe`, or its own, begins with the name. Names
--- without one are listed with the files that have them most often in their titles.

package.path = "./?.lua;" .. package.path

local fields = require("physics.fields.fields")

local PATH = "spec/README.md"
local HEAD = [[
# Where a promise has its specs

Written by `luajit scripts/spec_index.lua`; `make lint` checks it. To find a spec, look for the
field, setting or method here. To add one: open that file, or one in [scenarios](scenarios/);
begin the title with the name, draw the scene above the numbers, see the row fail: `busted FILE`.
]]

local function read(command)
  local pipe = assert(io.popen(command))
  local text = pipe:read("*a")
  pipe:close()
  return text
end

-- Titles ------------------------------------------------------------------------------------------

-- By file: the titles of all `describe` and `it`, without playing any.
local function titlesOf(path)
  local titles, around = {}, {}
  local function add(title)
    titles[#titles + 1] = { text = title, within = table.concat(around, " ") }
  end
  local nothing = function() end
  -- (As globals: helpers of the specs call them, too.)
  for name, word in pairs({
    describe = function(title, body)
      add(title)
      around[#around + 1] = title
      body()
      around[#around] = nil
    end,
    it = add,
    pending = add,
    setup = nothing,
    teardown = nothing,
    before_each = nothing,
    after_each = nothing,
    lazy_setup = nothing,
    lazy_teardown = nothing,
    finally = nothing,
  }) do
    _G[name] = word
  end
  dofile(path)
  return titles
end

-- Names -------------------------------------------------------------------------------------------

local function names(rows, form)
  local list = {}
  for _, row in ipairs(rows) do
    list[#list + 1] = { form:format(row.name), row.name }
  end
  return list
end

local function methods()
  local list, seen = {}, {}
  for name in read("cat physics/world/*.lua"):gmatch("\nfunction World:(%l%w*)%(") do
    if not seen[name] then
      seen[name] = true
      list[#list + 1] = { "world:" .. name, name }
    end
  end
  table.sort(list, function(a, b)
    return a[1] < b[1]
  end)
  return list
end

local function beginsWith(title, name)
  local first, last = title:find(name, 1, true)
  return first == 1 and not title:find("^[%w_]", last + 1)
end

local function mentions(title, word)
  return title:find("%f[%w_]" .. word .. "%f[^%w_]") ~= nil
end

-- The page ----------------------------------------------------------------------------------------

-- What every name has: its wrong values, and what games have found.
local GENERAL = { bad_input = true, fuzz_found = true }

-- Returns the cell of a name: files with titles about it, else files that mention it, most first.
local function cellOf(files, name)
  local about, elsewhere = {}, {}
  for _, file in ipairs(files) do
    local own, count = {}, 0
    for _, title in ipairs(file.titles) do
      if beginsWith(title.text, name[1]) or beginsWith(title.text, name[2]) then
        own[#own + 1] = title.text:gsub("%s*#%w+", ""):gsub("|", "\\|")
      end
      count = count + (mentions(title.text, name[2]) and 1 or 0)
    end
    local link = ("[%s](%s)"):format(file.name, file.path:gsub("^spec/", ""))
    if #own > 0 and not GENERAL[file.name] then
      local more = #own > 3 and (", and %d more"):format(#own - 3) or ""
      about[#about + 1] = link .. ": " .. table.concat(own, "; ", 1, math.min(#own, 3)) .. more
    elseif count > 0 and not GENERAL[file.name] then
      elsewhere[#elsewhere + 1] = { link, count, file.path }
    end
  end
  table.sort(elsewhere, function(a, b)
    return a[2] > b[2] or a[2] == b[2] and a[3] < b[3]
  end)
  local others = {}
  for n = 1, math.min(#elsewhere, about[1] and 0 or 3) do
    others[n] = elsewhere[n][1]
  end
  return about[1] and table.concat(about, "<br>")
    or others[1] and "see " .. table.concat(others, ", ")
    or "none"
end

local function page()
  local files, lines = {}, { HEAD }
  local listing = read("find spec -name '*_spec.lua' | LC_ALL=C sort")
  for path in listing:gmatch("[^\n]+") do
    local name = path:match("([^/]+)_spec%.lua$")
    files[#files + 1] = { path = path, name = name, titles = titlesOf(path) }
  end
  for _, part in ipairs({
    { "Fields of objects", names(fields.objects, "%s") },
    { "What a zone does", names(fields.area, "area.%s") },
    { "Settings", names(fields.settings, "world.%s") },
    { "Methods", methods() },
  }) do
    lines[#lines + 1] = "## " .. part[1] .. "\n\n| name | specs |\n|---|---|"
    for _, name in ipairs(part[2]) do
      lines[#lines + 1] = ("| `%s` | %s |"):format(name[1], cellOf(files, name))
    end
    lines[#lines + 1] = ""
  end
  return table.concat(lines, "\n")
end

local text = page()
if arg[1] == "--check" then
  local file = io.open(PATH)
  local old = file and file:read("*a")
  if old ~= text then
    io.stderr:write(PATH .. " is old: luajit scripts/spec_index.lua\n")
    os.exit(1)
  end
else
  local file = assert(io.open(PATH, "w"))
  file:write(text)
  file:close()
end
