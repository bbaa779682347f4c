--- The snippets of docs/maps.md run, and print what they say.

local physics = require("physics")
local snippets = require("spec.support.snippets")

local PAGE = snippets.read("docs/maps.md")

describe("docs/maps.md", function()
  local loveBefore

  before_each(function()
    loveBefore = rawget(_G, "love")
    physics.load()
  end)

  after_each(function()
    rawset(_G, "love", loveBefore)
    physics.load()
  end)

  local count = 0
  for snippet in PAGE:gmatch("\n```lua\n(.-)\n```\n") do
    count = count + 1
    it(("snippet %d prints what it says: %s"):format(count, snippet:match("[^\n]*")), function()
      local printed, said = {}, {}
      local environment = snippets.newEnvironment(printed, {})
      rawset(_G, "love", environment.love)
      snippets.compile(snippet, "=snippet", environment)()
      for line in snippet:gmatch("%-%-> ([^\n]*)") do
        said[#said + 1] = line
      end
      assert.is_true(#said > 0)
      assert.same(said, printed)
      environment.world:update(1 / 60)
    end)
  end

  it("has its snippets", function()
    assert.equal(6, count)
  end)

  it("lists every option of every loader #files", function()
    for _, name in ipairs({ "maps/tiled", "maps/array", "maps/ldtk" }) do
      local text = snippets.read("physics/" .. name .. ".lua")
      local list = text:match("local OPTIONS =%s*(%b{})")
      for option in list:gmatch('"(%w+)"') do
        assert.truthy(PAGE:find("`" .. option .. "`", 1, true), option)
      end
    end
  end)
end)
