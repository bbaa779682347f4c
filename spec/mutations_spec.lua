--- The scripts that look at the specs themselves: what they change or mark in a source text.

local coverage = require("scripts.coverage")
local mutations = require("scripts.mutations")
local tokens = require("scripts.tokens")

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

describe("scripts/tokens.lua", function()
  it("takes a text apart, without spaces and comments", function()
    local list = {}
    for n, token in ipairs(tokens.list("a.b=c~=1e-9 -- d\n..'e'")) do
      list[n] = token.line .. token.text
    end
    assert.are.same({ "1a", "1.", "1b", "1=", "1c", "1~=", "11e-9", "2..", "2'e'" }, list)
  end)
end)

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
    assert.are.same(expected, changesOf(SOURCE:gsub("%[=%[.-%]=%]", "")))
  end)

  it("writes one of them into the text, if that is Lua still", function()
    local text = "local a = 1 - 2\nreturn a\n"
    local list = mutations.list(text)
    assert.are.equal("local a = 2 - 2\nreturn a\n", mutations.apply(text, list[1]))
    assert.are.equal("local a = 1 + 2\nreturn a\n", mutations.apply(text, list[2]))
    assert.is_nil(mutations.apply("return -a", { at = 8, old = "-", new = "+" }))
  end)

  it("finds something in files of the core #files", function()
    for _, name in ipairs({ "space/shapes", "world/world", "solver/friction", "motion/path" }) do
      local file = assert(io.open("physics/" .. name .. ".lua"))
      local text, valid = file:read("*a"), 0
      file:close()
      local list = mutations.list(text)
      for _, change in ipairs(list) do
        valid = valid + (mutations.apply(text, change) and 1 or 0)
      end
      assert.is_true(valid > 10 and valid > 0.95 * #list, name)
    end
  end)
end)

describe("scripts/coverage.lua", function()
  it("marks the statements that begin a line", function()
    local _, lines = coverage.marked(SOURCE, "_")
    local list = {}
    for line in pairs(lines) do
      list[#list + 1] = line
    end
    table.sort(list)
    assert.are.same({ 2, 3, 4, 5, 7, 10, 14, 17 }, list)
  end)

  it("counts what was run, and leaves the lines where they are", function()
    local source = "local x = 1\nif x > 1 then\n  x = 2\nend\nreturn x\n"
    local text, lines = coverage.marked(source, "SEEN")
    local load = rawget(_G, "setfenv") and loadstring or load -- luacheck: ignore
    rawset(_G, "SEEN", lines)
    assert.are.equal(1, load(text)())
    rawset(_G, "SEEN", nil)
    assert.are.same({ true, true, false, nil, true }, lines)
    assert.are.equal(5, select(2, text:gsub("\n", "")))
  end)

  it("names the lines that were not run #files", function()
    local known = { ["physics/solver/rules.lua"] = { true, true, false, true } }
    local report = coverage.report(known, { "physics/solver/rules.lua" })
    assert.is_truthy(report:find("physics/solver/rules.lua: 75.0 %% of 4 lines\n     3  "))
    assert.is_truthy(report:find("75.00 %% of the lines of the core were run: 3 of 4, in 1 files"))
  end)
end)
