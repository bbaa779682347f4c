--- The pages are true: every Lua snippet runs and prints what it says, every link leads somewhere.

local files = require("spec.support.files")
local snippets = require("spec.support.snippets")

local unpack = table.unpack or unpack -- luacheck: ignore (Lua 5.1 has it as a global)

local GLOBALS = { "objects", "physics_load", "physics_update", "checkCollision", "inside", "bump" }

local PAGES = files.list("ls *.md bench/*.md spec/*.md && find docs -name '*.md'")

local function runBlock(_, block)
  block()
end

-- A spec inside a snippet runs at once.
local SPEC = { assert = assert, describe = runBlock, it = runBlock }

--- Removes fenced code, in which nothing is a link or a heading.
local function withoutCode(text)
  return (("\n" .. text):gsub("\n```.-\n```", "\n"))
end

local function exists(path)
  local file = io.open(path, "rb")
  if file then
    file:close()
  end
  return file ~= nil
end

--- "docs/guide", "../api.md" -> "docs/api.md". Folders end in "/".
local function resolve(folder, target)
  local parts = {}
  for part in (folder .. "/" .. target):gmatch("[^/]+") do
    if part == ".." then
      parts[#parts] = nil
    elseif part ~= "." then
      parts[#parts + 1] = part
    end
  end
  return table.concat(parts, "/") .. (target:find("/$") and "/" or "")
end

local VERSION_PARTS = { Added = true, Changed = true, Fixed = true, Removed = true }

--- The anchors of a page, as GitHub and MkDocs make them of headings, and those of `<a id>`.
local function anchorsOf(path)
  local anchors, text = {}, withoutCode(snippets.read(path))
  for title in text:gmatch("\n#+ ([^\n]+)") do
    local anchor = title:lower():gsub("[^%w%-_ ]", ""):gsub(" ", "-")
    -- (Nothing links to the parts of a version.)
    local isOfEachVersion = path == "CHANGELOG.md" and VERSION_PARTS[title]
    assert.is_nil(not isOfEachVersion and anchors[anchor] or nil, path .. " has twice " .. title)
    anchors[anchor] = true
  end
  for anchor in text:gmatch('<a id="([^"]+)">') do
    assert.is_nil(anchors[anchor], path .. " has two anchors " .. anchor)
    anchors[anchor] = true
  end
  return anchors
end

local anchors = setmetatable({}, {
  __index = function(self, path)
    self[path] = anchorsOf(path)
    return self[path]
  end,
})

local function checkLink(page, link)
  local target, anchor = link:match("^([^#]*)#?(.*)$")
  local path = target == "" and page or resolve(page:match("^(.*)/") or "", target)
  local isFolder = path:find("/$")
  assert.is_true(exists(isFolder and path .. "." or path), page .. ": no file " .. path)
  if anchor ~= "" then
    assert.is_true(anchors[path][anchor] or false, ("%s: no anchor in %s"):format(page, link))
  end
end

local function isElsewhere(link)
  return link:find("^%a+:") ~= nil
end

--- Calls the callbacks of LÖVE that a snippet has defined, for some frames.
local function playCallbacks(environment)
  local calls = {
    { "update", { 1 / 60 } },
    { "draw", {} },
    { "keypressed", { "space" } },
    { "keypressed", { "x" } },
    { "keyreleased", { "space" } },
  }
  if environment.love.load then
    environment.love.load({})
  end
  for _ = 1, 3 do
    for _, call in ipairs(calls) do
      if environment.love[call[1]] then
        environment.love[call[1]](unpack(call[2]))
      end
    end
  end
end

for _, path in ipairs(PAGES) do
  describe("the page " .. path, function()
    local text = snippets.read(path)

    snippets.keepLove(before_each, after_each)
    after_each(function()
      for _, name in ipairs(GLOBALS) do -- of the tutorial
        rawset(_G, name, nil)
      end
    end)

    local number = 0
    for before, snippet in text:gmatch("([^\n]*)\n```lua\n(.-)\n```\n") do
      number = number + 1
      local title = ("%d: %s"):format(number, snippet:match("[^\n]*"))
      local program = before:match("^<!%-%- (steps/%w+%.lua) %-%->$")
      it("has a snippet that runs and prints what it says, " .. title, function()
        if program then -- a part of a program, which is played below
          local whole = snippets.read("docs/" .. program)
          assert.truthy(whole:find(snippet, 1, true), "is not in " .. program)
          return
        end
        local environment, said, printed = snippets.run(snippet, SPEC)
        assert.same(said, printed)
        playCallbacks(environment)
      end)
    end

    it("leaves no Lua snippet out", function()
      local _, fences = text:gsub("\n[ \t]*```lua", "")
      assert.equal(fences, number)
    end)

    it("links only to what exists #files", function()
      for link in withoutCode(text):gmatch("%]%(([^%s)]+)%)") do
        if not isElsewhere(link) then
          checkLink(path, link)
        end
      end
    end)

    it("has headings that make one anchor each", function()
      assert.is_true(next(anchors[path]) ~= nil)
    end)
  end)
end

it("ARCHITECTURE and CONTRIBUTING name functions and columns where they are #files", function()
  local pages = snippets.read("ARCHITECTURE.md") .. snippets.read("CONTRIBUTING.md")
  for name, file in pages:gmatch("`([%w_.]+)` [io][nf]%s+`([%w/]+%.lua)`") do
    local text, word = "", "[^%w_]" .. name:gsub("%.", "%%.") .. "[^%w_]"
    for _, path in ipairs(files.list("find ./physics* -path '*/" .. file .. "'")) do
      text = text .. snippets.read(path)
    end
    assert.is_truthy(text:find(word), name .. " in " .. file)
  end
end)

-- How the pages write some numbers.
local WORDS = { [3] = "three", [0.25] = "a quarter", [0.0625] = "a sixteenth" }

-- Returns the value of a constant of a file of the core.
local function constant(name, file)
  for _, path in ipairs(files.list("find ./physics -name '" .. file .. "'")) do
    for names, values in snippets.read(path):gmatch("local ([%u_, ]+) = ([^\n]+)") do
      for known in names:gmatch("[%u_]+") do
        local text, rest = values:match("^([^,]*),?(.*)$")
        if known == name then
          return tonumber(text)
        end
        values = rest
      end
    end
  end
end

it("ARCHITECTURE says what the constants are that bound a step #files", function()
  local count = 0
  for said, cell in snippets.read("ARCHITECTURE.md"):gmatch("\n|[^|\n]+|([^|\n]+)|([^|\n]+)|") do
    for names, file in cell:gmatch("([`%u_, ]+) in `([%w]+%.lua)`") do
      for name in names:gmatch("`([%u_]+)`") do
        local value = constant(name, file)
        local number = "[^%w.]" .. tostring(value):gsub("%.", "%%.") .. "[^%w.]"
        local isSaid = (" " .. said .. " "):find(number)
        assert.is_truthy(isSaid or said:find(WORDS[value] or "?", 1, true), name .. " in " .. file)
        count = count + 1
      end
    end
  end
  assert.equal(10, count)
end)

it("the page State names the version of a state #files", function()
  local version = require("physics.memory.layout").VERSION
  assert.equal(version, tonumber(snippets.read("docs/state.md"):match("version must be (%d+)")))
end)
