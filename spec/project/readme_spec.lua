--- The README: the game in it runs, what it promises has a spec, and it stays short. That all
--- snippets run and all links lead somewhere is checked by docs_spec.lua, for every page.

local files = require("spec.support.files")
local physics = require("physics")
local snippets = require("spec.support.snippets")

local README = snippets.read("README.md")
local MOST_WORDS = 900
local MOST_IN_MANUAL = 31000

--- The text below a heading, up to the next one of its level.
local function section(title)
  local _, last = README:find("\n## " .. title .. "\n", 1, true)
  assert(last, "no heading " .. title)
  return README:sub(last, (README:find("\n## ", last, true)))
end

describe("the README", function()
  snippets.keepLove(before_each, after_each)

  it("begins with a game of at most 25 lines, which plays", function()
    local game = README:match("\n```lua\n(.-)\n```\n")
    local _, lines = game:gsub("\n", "")
    assert.is_true(lines < 25)
    local environment = snippets.run(game)
    environment.love.load()
    local player = physics.objects.players[1]
    local highest = player.y
    for _ = 1, 120 do
      environment.love.update(1 / 60)
      environment.love.draw()
      highest = math.min(highest, player.y)
    end
    assert.equal(528, player.y)
    assert.near(440, player.x, 1e-9)
    local before = player.y
    environment.love.keyboard.isDown = function(key)
      return key == "space"
    end
    environment.love.update(1 / 60)
    assert.is_true(player.y < before and player.vx == 0)
    environment.love.keyboard.isDown = function(key)
      return key == "left"
    end
    environment.love.update(1 / 60)
    assert.equal(-200, player.vx)
  end)

  it("is short", function()
    local _, words = README:gsub("%S+", "")
    assert.is_true(words <= MOST_WORDS, words .. " words")
  end)

  it("belongs to a manual that is not too long", function()
    local sum = 0
    for _, path in ipairs(files.list("find docs -name '*.md'")) do
      local _, words = snippets.read(path):gsub("%S+", "")
      sum = sum + words
    end
    assert.is_true(sum <= MOST_IN_MANUAL, sum .. " words")
  end)

  it("names a spec for each promise", function()
    local count = 0
    local promises = section("What it promises")
    for promise in promises:gmatch("| (%*%*[^|]*)") do
      count = count + 1
      assert.truthy(promise:find("%(spec/[%w_/]+_spec%.lua%)"), promise)
    end
    local _, clips = promises:gsub("| !%[[^%]]+%]%(docs/pictures/%w+%.webp%)", "")
    assert.same({ 6, 6 }, { count, clips })
    local rows, text = 0, snippets.read("docs/compare.md"):match("\n## Promises\n(.*)$")
    for row, specs in text:gmatch("\n| ([^|\n]+) | ([^|\n]+) |") do
      if row ~= "what it does" and not row:find("^%-") then
        rows = rows + 1
        assert.truthy(specs:find("%]%(%.%./spec/[%w_/]+_spec%.lua%)"), row)
      end
    end
    assert.is_true(rows >= 15, rows .. " rows")
  end)

  it("links every page of docs/", function()
    for _, path in ipairs(files.list("find docs -name '*.md'")) do
      assert.truthy(README:find("](" .. path, 1, true), path .. " is not linked")
    end
  end)
end)
