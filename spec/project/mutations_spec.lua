--- The scripts that look at the specs themselves: what they change or mark in a source text.

if not rawget(_G, "jit") then
  return -- they run on LuaJIT: luacheck, which splits the text, is there for that
end

local coverage = require("scripts.coverage")
local mutations = require("scripts.mutations")

local SOURCE = [[
-- 1 + 1 is no code, "and" neither
local limit, text = -2.5, "a - b"
if a.min <= b and not text then
  return min(a, 0)
end
return {
  a == 1,
  function(t)
    t[1] = true
  end,
}
]]

-- Each change as "line: old new".
local function changesOf(text)
  local list = {}
  for n, change in ipairs(mutations.list(text)) do
    list[n] = ("%d: %s %s"):format(change.line, change.old, change.new)
  end
  return list
end

describe("scripts/mutations.lua", function()
  it("changes operators, comparisons, constants, min and max", function()
    local expected = { "2: - ", "2: 2.5 (2.5 * 2)", "3: <= <", "3: <= >", "3: and or", "3: not " }
    for _, change in ipairs({ "4: min max", "4: 0 1", "7: == ~=", "7: 1 2", "9: 1 2" }) do
      expected[#expected + 1] = change
    end
    expected[#expected + 1] = "9: true false"
    assert.same(expected, changesOf(SOURCE))
  end)

  it("writes one of them into the text, if that is Lua still", function()
    local text = "return 1 - 2\n"
    assert.equal("return 1 + 2\n", mutations.apply(text, mutations.list(text)[2]))
    assert.is_nil(mutations.apply("return -a", { at = 8, old = "-", new = "+" }))
  end)
end)

it("scripts/coverage.lua marks statements that begin a line, and counts those run", function()
  local _, marked = coverage.marked(SOURCE, "_")
  local list = {}
  for line in pairs(marked) do
    list[#list + 1] = line
  end
  table.sort(list)
  assert.same({ 2, 3, 4, 6, 9 }, list)
  local text, lines =
    coverage.marked("local x = 1\nif x > 1 then\n  x = 2\nend\nreturn x\n", "SEEN")
  rawset(_G, "SEEN", lines)
  assert.equal(1, (rawget(_G, "loadstring") or load)(text)())
  rawset(_G, "SEEN", nil)
  assert.same({ true, true, false, nil, true }, lines)
end)
