--- The pages are true: every Lua snippet runs and prints what it says, every link leads somewhere.

local files = require("spec.support.files")
local physics = require("physics")
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
    assert.is_nil(
      not isOfEachVersion and anchors[anchor] or nil,
      path .. " has two headings " .. title
    )
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
    environment.love.load()
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
    local loveBefore
    local text = snippets.read(path)

    before_each(function()
      loveBefore = rawget(_G, "love")
      physics.load()
    end)

    after_each(function()
      rawset(_G, "love", loveBefore)
      for _, name in ipairs(GLOBALS) do -- of the tutorial
        rawset(_G, name, nil)
      end
      physics.load()
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

describe("a step of a page", function()
  local loveBefore, held

  before_each(function()
    loveBefore, held = rawget(_G, "love"), {}
  end)

  after_each(function()
    rawset(_G, "love", loveBefore)
  end)

  --- Starts it. Returns its `love`, and its locals `player` and `world`.
  local function start(name)
    local text = snippets.read("docs/steps/" .. name .. ".lua")
    local environment = snippets.newEnvironment({}, held)
    rawset(_G, "love", environment.love)
    local look = snippets.compile(
      text .. "\nreturn function() return player, world end",
      "=step",
      environment
    )()
    environment.love.load()
    local player, world = look()
    return environment.love, player, world
  end

  for _, page in ipairs({ "platformer", "topdown" }) do
    for step = 1, 7 do
      it(page .. " " .. step .. " plays, and the page links it", function()
        local game, player = start(page .. step)
        local x = player.x
        held.right = true
        for _ = 1, 60 do
          game.update(1 / 60)
          game.draw()
        end
        local walks = page == "topdown" or step > 1
        assert.equal(walks, player.x > x + 40)
        local path = page == "topdown" and "docs/topdown.md" or "docs/platformers.md"
        assert.truthy(snippets.read(path):find("](steps/" .. page .. step .. ".lua)", 1, true))
      end)
    end
  end

  local function wait(game, steps, each)
    for _ = 1, steps do
      game.update(1 / 60)
      if each then
        each()
      end
    end
  end

  it("platformer: jumps, stomps, rides the lift and dies in the spikes as it says", function()
    local game, player, world = start("platformer7")
    local top
    local function jump()
      top = player.y
      game.keypressed("space")
      wait(game, 60, function()
        top = math.min(top, player.y)
      end)
    end
    wait(game, 60)
    local ground, enemy = player.y, world.objects.enemies[1]
    jump()
    assert.near(ground - 113, top, 0.5)
    player.x, player.y, player.vy = enemy.x, enemy.y - 80, 0
    repeat
      game.update(1 / 60)
    until player.vy < 0
    assert.equal(0, #world.objects.enemies)
    local y = player.y
    jump() -- not from an enemy: only the stomp lifts it
    assert.near(y - 300 * 300 / (2 * 1200), top, 0.5)
    local lift = world.objects.lifts[1]
    player.x, player.y = lift.x + 30, lift.y - 40
    wait(game, 60)
    assert.equal(lift, player.touching.bottom)
    player.x, player.y = 13.5 * 32, 180
    wait(game, 60)
    assert.equal(32, player.x)
  end)

  it("topdown: walks at its speed, shoots, goes through the door, takes gems", function()
    local game, player, world = start("topdown7")
    held.right, held.down = true, true
    wait(game, 1)
    assert.near(160, math.sqrt(player.vx * player.vx + player.vy * player.vy), 1e-9)
    held.down = nil
    wait(game, 1) -- it looks to the right
    held.right = nil
    for _, enemy in ipairs(world.objects.enemies) do
      enemy.active = false
    end
    world.objects.crates[1].active = false
    local enemy = world.objects.enemies[1]
    enemy.active, enemy.x, enemy.y = true, player.x + 100, player.y
    for _ = 1, 3 do
      game.keypressed("space")
      wait(game, 20)
    end
    assert.same({ 9, 0 }, { #world.objects.enemies, #world.objects.bullets })
    wait(game, 120)
    assert.equal(0, #world.objects.gems)
    player.x, player.y, held.right = 260, 256, true -- the door is at 260
    wait(game, 60)
    assert.is_true(player.x > 324)
  end)
end)
