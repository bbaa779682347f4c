--- The scripts that look at the specs themselves: what they change or mark in a source text.

local coverage = require("scripts.coverage")
local mutations = require("scripts.mutations")

local SOURCE = [[
-- 1 + 1 is no code, "and" neither
local limit, text = -2.5, "a - b" --[=[ not this ]=]
local function least(a, b)
  if a.min <= b and not text then
    return min(a, 0) - 1e-9
  end
  return {
    a == 1 or b,
    function(t)
      t[1] = true
    end,
  }
end
while
  limit > 0
do
  limit =
    least(limit, 1)
end
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
    local expected = {
      "2: - ",
      "2: 2.5 (2.5 * 2)",
      "4: <= <",
      "4: <= >",
      "4: and or",
      "4: not ",
      "5: min max",
      "5: 0 1",
      "5: - +",
      "5: 1e-9 (1e-9 * 2)",
      "8: == ~=",
      "8: 1 2",
      "8: or and",
      "10: 1 2",
      "10: true false",
      "15: > >=",
      "15: > <=",
      "15: 0 1",
      "18: 1 2",
    }
    assert.same(expected, changesOf(SOURCE:gsub("%[=%[.-%]=%]", "")))
  end)

  it("writes one of them into the text, if that is Lua still", function()
    local text = "return 1 - 2\n"
    assert.equal("return 1 + 2\n", mutations.apply(text, mutations.list(text)[2]))
    assert.is_nil(mutations.apply("return -a", { at = 8, old = "-", new = "+" }))
  end)
end)

describe("scripts/coverage.lua", function()
  it("marks the statements that begin a line, and counts those that are run", function()
    local _, marked = coverage.marked(SOURCE, "_")
    local list = {}
    for line in pairs(marked) do
      list[#list + 1] = line
    end
    table.sort(list)
    assert.same({ 2, 3, 4, 5, 7, 10, 14, 17 }, list)
    local text, lines =
      coverage.marked("local x = 1\nif x > 1 then\n  x = 2\nend\nreturn x\n", "SEEN")
    rawset(_G, "SEEN", lines)
    assert.equal(1, (rawget(_G, "loadstring") or load)(text)())
    rawset(_G, "SEEN", nil)
    assert.same({ true, true, false, nil, true }, lines)
  end)
end)
