--- Which spec files are about a field, setting or method?
---
---   luajit scripts/spec_index.lua mask     lists them
---   luajit scripts/spec_index.lua          looks whether each has one; `make lint`
---
--- A spec is about a name if the title of its `describe`, or its own, begins with the name, or with
--- a list in which it is: "vx and vy: ...".
---
--- What must hold: each page of the guide and the reference has a spec file of its name, and each
--- file in spec/ itself has the name of a page. Each field, setting and method has a spec, and each
--- outermost title begins with one of them, or with "every".

package.path = "./?.lua;" .. package.path

local fields = require("physics.fields.fields")
local files = require("spec.support.files")

-- By file: the titles of all `describe` and `it`, without playing any.
local function titlesOf(path)
  local titles, depth = {}, 0
  local function add(title)
    titles[#titles + 1] = { text = title, isOutermost = depth == 0 }
  end
  local function describe(title, body)
    add(title)
    depth = depth + 1
    body()
    depth = depth - 1
  end
  local function nothing() end
  -- (As globals: helpers of the specs call them, too.)
  local globals = { describe = describe, it = add, pending = add, finally = nothing }
  for _, name in ipairs({ "setup", "teardown", "before_each", "after_each" }) do
    globals[name] = nothing
  end
  for name, word in pairs(globals) do
    _G[name] = word
  end
  dofile(path)
  return titles
end

-- Full names, each with the short one that a title may have instead; words that may begin a title.
local shortOf, isSubject = {}, {}

local function addName(full, short)
  shortOf[full], isSubject[full], isSubject[short] = short, true, true
end

for _, row in ipairs(fields.objects) do
  addName(row.name, row.name)
end
for _, row in ipairs(fields.area) do
  addName("area." .. row.name, "area." .. row.name)
end
for _, row in ipairs(fields.settings) do
  addName("world." .. row.name, row.name)
end
for name in files.output("cat physics/world/*.lua"):gmatch("\nfunction World:(%l%w*)%(") do
  addName("world:" .. name, name)
end
for word in
  ([[
  every filter stats load require globals newWorld inside side checkCollision bump world.objects
  level:addMap level:removeMap
]]):gmatch("%S+")
do
  isSubject[word] = true
end

-- The names that a title begins with, as a set: "vx and vy: seams" is about both.
local function subjectsOf(title)
  local subjects, at = {}, 1
  while at do
    local name = (title:match("^%a[%w_.:]*", at) or ""):gsub("[.:]+$", "")
    if not isSubject[name] then
      break
    end
    subjects[name], at = true, at + #name
    at = title:match("^,? and ()", at) or title:match("^, ()", at)
  end
  return subjects
end

-- What is about no name: files of the project and of the core, and games at random.
local function isFree(path, title)
  return path:find("^spec/project/")
    or path:find("^spec/inside/")
    or path:find("/fuzz[%w_]*_spec%.lua$")
    or title:find("^%l+/[%w/]+%.%l+:? ") -- of a page or an example: "docs/recipes.md: "
    or title:find("^%l+/[%w/]+%.%l+:?$")
end

-- What every name has: its wrong values and its row.
local GENERAL = { ["spec/debugging_bad_input_spec.lua"] = true, ["spec/fields_spec.lua"] = true }

local problems = {}

local function need(isMet, text, ...)
  if not isMet then
    problems[#problems + 1] = text:format(...)
  end
end

local about, ofPages = {}, {} -- name -> paths; names of the files in spec/ itself
for _, path in ipairs(files.list("find spec -name '*_spec.lua'")) do
  local page = path:match("^spec/([^/]+)_spec%.lua$")
  ofPages[#ofPages + 1] = page
  for _, title in ipairs(titlesOf(path)) do
    local subjects = subjectsOf(title.text)
    for name in pairs(GENERAL[path] and {} or subjects) do
      about[name] = about[name] or {}
      about[name][path] = true
    end
    local isNamed = not title.isOutermost or next(subjects) or isFree(path, title.text)
    need(
      isNamed,
      "%s: '%s' should begin with a field, setting, callback or function",
      path,
      title.text
    )
  end
end

local isPage = {}
for _, path in ipairs(files.list("ls docs/guide/*.md docs/api/*.md docs/*.md")) do
  local page, hasSpec = path:match("([^/]+)%.md$"), false
  for _, name in ipairs(ofPages) do
    local isOf = name == page or name:sub(1, #page + 1) == page .. "_"
    isPage[name], hasSpec = isPage[name] or isOf, hasSpec or isOf
  end
  local isFreePage = page == "index" or not path:find("^docs/%l+/")
  need(hasSpec or isFreePage, "%s has no spec of its name", path)
end
for _, name in ipairs(ofPages) do
  need(isPage[name], "spec/%s_spec.lua has the name of no page", name)
end
for full, short in pairs(shortOf) do
  need(about[full] or about[short], "no title begins with %s", full)
end

if arg[1] then
  local list = {}
  for _, name in ipairs({ arg[1], shortOf[arg[1]] }) do
    for path in pairs(about[name] or {}) do
      list[#list + 1] = path
    end
  end
  table.sort(list)
  print(table.concat(list, "\n"))
else
  table.sort(problems)
  io.stderr:write(table.concat(problems, "\n"), problems[1] and "\n" or "")
  os.exit(problems[1] and 1 or 0)
end
