--- The README is true: its snippets run, its tables are those of the library, nothing is missing.

local fields = require("physics.world.fields")
local physics = require("physics")
local snippets = require("spec.support.snippets")

local unpack = table.unpack or unpack -- luacheck: ignore (Lua 5.1 has it as a global)

local read, compile = snippets.read, snippets.compile

local README = read("README.md")
local GLOBALS = { "objects", "physics_load", "physics_update", "checkCollision", "inside", "bump" }

--- The text below a heading, up to the next one of its level.
local function section(title)
  local _, last = README:find("\n## " .. title .. "\n", 1, true)
  assert(last, "no heading " .. title)
  return README:sub(last, (README:find("\n## ", last, true)))
end

--- Runs a snippet, and compares what it prints with what it says. Returns its environment.
local function run(snippet)
  local printed, said = {}, {}
  local environment = snippets.newEnvironment(printed, { right = true })
  rawset(_G, "love", environment.love)
  compile(snippet, "=snippet", environment)()
  for line in snippet:gmatch("%-%-> ([^\n]*)") do
    said[#said + 1] = line
  end
  if #said > 0 then
    assert.same(said, printed)
  end
  environment.world:update(1 / 60)
  return environment
end

describe("the README", function()
  local loveBefore

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
  for snippet in README:gmatch("\n```lua\n(.-)\n```\n") do
    number = number + 1
    local title = ("%d: %s"):format(number, snippet:match("[^\n]*"))

    it("has a snippet that runs and prints what it says, " .. title, function()
      local environment = run(snippet)
      if environment.love.load then
        environment.love.load()
        for _ = 1, 120 do
          environment.love.update(1 / 60)
          environment.love.draw()
        end
        local player = physics.objects.players[1]
        assert.equal(528, player.y)
        assert.near(440, player.x, 1e-9)
      end
    end)
  end

  it("has more than a handful of snippets", function()
    assert.is_true(number >= 10)
  end)

  it("tells the cells that the grid has", function()
    local cell = physics.newWorld()._bodies.broadphase.cell
    assert.truthy(section("Settings"):find(("| `cellSize` | %d | px |"):format(cell), 1, true))
  end)

  for _, kind in ipairs({
    { "Fields of objects", fields.objects },
    { "Settings", fields.settings },
  }) do
    describe("lists under " .. kind[1], function()
      local rows, count = {}, 0
      for name, default, unit, meaning in
        section(kind[1]):gmatch("\n| `([%w_]+)` | ([^|\n]*) | ([^|\n]*)| ([^\n]*) |")
      do
        rows[name] = { default, (unit:gsub("%s+$", "")), meaning }
        count = count + 1
      end

      it("nothing that is not there", function()
        assert.equal(#kind[2], count)
      end)

      for _, field in ipairs(kind[2]) do
        it(field.name .. " with its default, unit and meaning", function()
          local default, unit, meaning = unpack(rows[field.name] or {})
          assert.truthy(default, "no row")
          assert.equal(field.unit or "", unit)
          assert.truthy(meaning:find(field.meaning, 1, true), meaning)
          assert.truthy(meaning:find(field.signature or "", 1, true), meaning)
          for _, value in ipairs(field.values or {}) do
            assert.truthy(meaning:find('`"' .. value .. '"`', 1, true), meaning)
          end
          if field.required or field.written then
            assert.equal(field.required and "required" or "written", default)
          elseif field.absent then
            assert.equal(field.absent, default)
          else
            local value = compile("return " .. default:match("^`(.*)`$"), "=default", {})()
            if type(value) == "number" then
              assert.near(field.default, value, 1e-12)
            else
              assert.equal(field.default, value)
            end
          end
        end)
      end
    end)
  end

  it("has a heading for every function, and none for others", function()
    local documented, public = {}, {}
    for name in section("Functions"):gmatch("\n### ([%w_]+[:.][%w_]+)%(") do
      documented[#documented + 1] = name
    end
    local methods = getmetatable(physics.newWorld()).__index
    for name, value in pairs(methods) do
      if type(value) == "function" then
        public[#public + 1] = "world:" .. name
      end
    end
    for name, value in pairs(physics) do
      if type(value) == "function" and not methods[name] then
        public[#public + 1] = "physics." .. name
      end
    end
    table.sort(documented)
    table.sort(public)
    assert.same(public, documented)
  end)

  it("names only files that exist", function()
    for path in README:gmatch("%]%(([%w_/%.%-]+)[)#]") do
      read(path)
    end
    -- Letters, digits and hyphens of the title are left.
    local titles = {}
    for title in README:gmatch("\n##+ ([^\n]+)") do
      titles[title:lower():gsub("[^%w%- ]", ""):gsub(" ", "-")] = true
    end
    for anchor in README:gmatch("%]%(#([^)]+)%)") do
      assert.is_true(titles[anchor], anchor)
    end
    for anchor in README:gmatch("%]%(docs/recipes%.md#([%w%-]+)%)") do
      local title = anchor:gsub("%-", " ")
      assert.truthy(read("docs/recipes.md"):lower():find("\n## " .. title .. "\n", 1, true))
    end
    local version = physics._VERSION
    read("rockspec/physics-" .. version .. "-1.rockspec")
    assert.truthy(README:find("rockspec/physics-" .. version .. "-1.rockspec", 1, true))
  end)

  it("names every counter of world.stats", function()
    for name in pairs(physics.newWorld().stats) do
      assert.truthy(section("Functions"):find("`" .. name .. "`", 1, true), name)
    end
  end)
end)

-- What a page of docs/ says and does; docs/recipes.md has a spec of its own beside.
describe("a page of docs/", function()
  local loveBefore

  before_each(function()
    loveBefore = rawget(_G, "love")
    physics.load()
  end)

  after_each(function()
    rawset(_G, "love", loveBefore)
    physics.load()
  end)

  local listing = assert(io.popen("ls docs/*.md"))
  for path in listing:lines() do
    local number = 0
    for snippet in read(path):gmatch("\n```lua\n(.-)\n```\n") do
      number = number + 1
      it(("has snippets that run: %s, %d"):format(path, number), function()
        local environment = run(snippet)
        for _ = 1, 3 do
          for name, call in pairs({ update = { 1 / 60 }, draw = {}, keypressed = { "space" } }) do
            if environment.love[name] then
              environment.love[name](unpack(call))
            end
          end
        end
      end)
    end

    it("names only files that exist: " .. path .. " #files", function()
      for link in read(path):gmatch("%]%(([%w_/%.%-]+)[)#]") do
        read(link:find("^%.%./") and link:sub(4) or "docs/" .. link)
      end
    end)
  end
  listing:close()
end)
