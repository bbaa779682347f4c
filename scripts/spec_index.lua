--- Writes spec/README.md: for each page of the guide and the reference its spec files, and for each
--- field, setting and method the specs that are about it.
---
---   luajit scripts/spec_index.lua            writes the page
---   luajit scripts/spec_index.lua --check    fails if it would be another, or a name is missing
---
--- A spec is about a name if the title of its `describe`, or its own, begins with the name, or with
--- a list in which it is: "vx and vy: ...".
---
--- What must hold: each page of the guide and the reference has a spec file of its name, and each
--- file in spec/ itself has the name of a page. Each field, setting and method has a spec, and each
--- outermost title begins with one of them, or with "every".

package.path = "./?.lua;" .. package.path

local fields = require("physics.fields.fields")

local PATH = "spec/README.md"
local HEAD = [[
# Where a promise has its specs

Written by `luajit scripts/spec_index.lua`; `make lint` checks it. Look for a field, setting or
method here, and for its name in the titles of the files. To add a spec:
[CONTRIBUTING](../CONTRIBUTING.md#how-to-add-a-spec).

| where | specs of |
|---|---|
| `NAME_spec.lua`, `NAME_…_spec.lua` | the page `NAME` of the guide, the reference or `docs/` |
| [scenarios](scenarios/) | one behaviour each: a picture, rows of numbers, many variants |
| [oracles](oracles/) | motion, impacts and friction that are worked out by hand |
| [invariants](invariants/) | every scene: bits, garbage, errors, random games |
| [inside](inside/) | files of the core |
| [project](project/) | pages, scripts, benchmark |
| [support](support/), [fuzz](fuzz/) | (helpers, random games) |
| [maps](maps/), [gopher](gopher/) | (maps of Tiled, a Lua in Go) |

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
  local titles, depth = {}, 0
  local function add(title)
    titles[#titles + 1] = { text = title, isOutermost = depth == 0 }
  end
  local nothing = function() end
  -- (As globals: helpers of the specs call them, too.)
  for name, word in pairs({
    describe = function(title, body)
      add(title)
      depth = depth + 1
      body()
      depth = depth - 1
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

local function names(rows, form, short)
  local list = {}
  for _, row in ipairs(rows) do
    list[#list + 1] = { form:format(row.name), (short or "%s"):format(row.name) }
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

local PARTS = {
  { "Fields of objects", names(fields.objects, "%s") },
  { "What a zone does", names(fields.area, "area.%s", "area.%s") },
  { "Settings", names(fields.settings, "world.%s") },
  { "Methods", methods() },
}

-- What titles may begin with, besides these names.
local SUBJECTS = {}
for word in
  ([[
  every filter stats load require globals newWorld inside side checkCollision bump world.objects
  level:addMap level:removeMap
]]):gmatch("%S+")
do
  SUBJECTS[word] = true
end
for _, part in ipairs(PARTS) do
  for _, name in ipairs(part[2]) do
    SUBJECTS[name[1]], SUBJECTS[name[2]] = true, true
  end
end

-- The names that a title begins with, as a set: "vx and vy: seams" is about both.
local function subjectsOf(title)
  local subjects, at = {}, 1
  while at do
    local word = title:match("^%a[%w_.:]*", at) or ""
    local name = word:gsub("[.:]+$", "")
    if not SUBJECTS[name] then
      break
    end
    subjects[name], at = true, at + #name
    local _, last = title:find("^,? and ", at)
    if not last then
      _, last = title:find("^, ", at)
    end
    at = last and last + 1
  end
  return subjects
end

-- The page ----------------------------------------------------------------------------------------

-- What every name has: its wrong values, its row, and what games have found.
local GENERAL = { debugging_bad_input = true, fields = true, fuzz = true, fuzz_found = true }

local function linkTo(file)
  return ("[%s](%s)"):format(file.name, file.path:gsub("^spec/", ""))
end

-- Returns the cell of a name: the files with titles about it.
local function cellOf(files, name)
  local about = {}
  for _, file in ipairs(files) do
    local isAbout = false
    for _, title in ipairs(file.titles) do
      isAbout = isAbout or title.subjects[name[1]] or title.subjects[name[2]]
    end
    if isAbout and not GENERAL[file.name] then
      about[#about + 1] = linkTo(file)
    end
  end
  return #about > 0 and table.concat(about, ", ") or "none"
end

local function listFiles()
  local files = {}
  for path in read("find spec -name '*_spec.lua' | LC_ALL=C sort"):gmatch("[^\n]+") do
    local file = { path = path, name = path:match("([^/]+)_spec%.lua$"), titles = titlesOf(path) }
    for _, title in ipairs(file.titles) do
      title.subjects = subjectsOf(title.text)
    end
    file.isPage = path:find("^spec/[^/]+$") ~= nil
    files[#files + 1] = file
  end
  -- Files of pages come first: most of a name is there.
  table.sort(files, function(a, b)
    if a.isPage ~= b.isPage then
      return a.isPage
    end
    return a.name < b.name
  end)
  return files
end

local function isOf(file, page)
  return file.isPage and (file.name == page or file.name:sub(1, #page + 1) == page .. "_")
end

-- The rows of pages. A file of no page, and a page of the guide or reference without a file, are
-- problems.
local function pages(files, problems)
  local lines, isListed = { "## Pages\n\n| page | specs |\n|---|---|" }, {}
  local listing = read("ls docs/guide/*.md docs/api/*.md docs/*.md")
  for path in listing:gmatch("[^\n]+") do
    local page, links = path:match("([^/]+)%.md$"), {}
    for _, file in ipairs(files) do
      if isOf(file, page) then
        links[#links + 1], isListed[file] = linkTo(file), true
      end
    end
    if links[1] then
      local short, all = path:match("^docs/(.*)%.md$"), table.concat(links, ", ")
      lines[#lines + 1] = ("| [%s](../%s) | %s |"):format(short, path, all)
    elseif path:find("^docs/%l+/") and page ~= "index" then
      problems[#problems + 1] = path .. " has no spec of its name"
    end
  end
  for _, file in ipairs(files) do
    if file.isPage and not isListed[file] then
      problems[#problems + 1] = file.path .. " has the name of no page"
    end
  end
  lines[#lines + 1] = ""
  return lines
end

-- What is about no name: files of the project and of the core, and games at random.
local function isFree(file, title)
  return file.path:find("^spec/project/")
    or file.path:find("^spec/inside/")
    or file.name:find("^fuzz")
    or title.text:find("^%l+/[%w/]+%.%l+:? ") -- of a page or an example: "docs/recipes.md: "
    or title.text:find("^%l+/[%w/]+%.%l+:?$")
end

-- Returns the text, and what is wrong, a line each.
local function build()
  local files, problems = listFiles(), {}
  local lines = { HEAD .. table.concat(pages(files, problems), "\n") }
  for _, part in ipairs(PARTS) do
    lines[#lines + 1] = "## " .. part[1] .. "\n\n| name | specs |\n|---|---|"
    for _, name in ipairs(part[2]) do
      local cell = cellOf(files, name)
      lines[#lines + 1] = ("| `%s` | %s |"):format(name[1], cell)
      if cell == "none" then
        problems[#problems + 1] = "no title begins with " .. name[1]
      end
    end
    lines[#lines + 1] = ""
  end
  for _, file in ipairs(files) do
    for _, title in ipairs(file.titles) do
      if title.isOutermost and next(title.subjects) == nil and not isFree(file, title) then
        local text = "%s: '%s' should begin with a field, setting, callback or function"
        problems[#problems + 1] = text:format(file.path, title.text)
      end
    end
  end
  return table.concat(lines, "\n"), problems
end

local text, problems = build()
if arg[1] == "--check" then
  local file = io.open(PATH)
  local old = file and file:read("*a")
  if old ~= text then
    problems[#problems + 1] = PATH .. " is old: luajit scripts/spec_index.lua"
  end
  io.stderr:write(table.concat(problems, "\n"), problems[1] and "\n" or "")
  os.exit(problems[1] and 1 or 0)
else
  local file = assert(io.open(PATH, "w"))
  file:write(text)
  file:close()
end
