-- The runner for where busted cannot run (scripts/plain_busted.lua) notices what busted would.

local files = require("spec.support.files")

-- Each line fails, where the other of its pair holds.
local PAIRS = {
  { "assert.equal(1, 1)", "assert.equal(1, 2)" },
  { "assert.are.equal(1, 1)", 'assert.are.equal("1", 1)' },
  { "assert.not_equal(1, 2)", "assert.not_equal(1, 1)" },
  { "assert.same({ { 1 } }, { { 1 } })", "assert.same({ { 1 } }, { { 1, 2 } })" },
  { "assert.same({ 1 }, { 1 }, 'a')", "assert.same({ 1 }, { 2 }, 'a')" },
  { "assert.same({ a = 1 }, { a = 1 })", "assert.are.same({ a = 1 }, {})" },
  { "assert.near(1, 1.1, 0.2)", "assert.near(1, 1.1, 0.05)" },
  { "assert.is_near(1, 0.9, 0.2)", "assert.near(1, 0 / 0, 0.2)" },
  { "assert.truthy(0)", "assert.truthy(false)" },
  { "assert.is_truthy({})", "assert.is_truthy(nil)" },
  { "assert.is_true(true)", "assert.is_true(1)" },
  { "assert.is_false(false)", "assert.is_false(nil)" },
  { "assert.is_nil(nil)", "assert.is_nil(false)" },
  { "assert.is_not_nil(false)", "assert.is_not_nil(nil)" },
  { "assert.is_table({})", "assert.is_table(1)" },
  { "assert.is_string('')", "assert.is_string(1)" },
  { "assert.is_function(print)", "assert.is_function(1)" },
  { "assert(1)", "assert(nil)" },
  { "assert.matches('b+', 'abb')", "assert.matches('c', 'b')" },
  { "assert.matches('b+', 'b+', 1, true)", "assert.matches('b+', 'bb', 1, true)" },
  { "assert.has_error(function() error('a') end)", "assert.has_error(function() end)" },
  {
    "assert.has_error(function() error('a') end, 'a')",
    "assert.has_error(function() error('a') end, 'b')",
  },
  {
    "assert.error_matches(function() error('abc') end, 'b')",
    "assert.error_matches(function() error('abc') end, 'a b')",
  },
}

-- What the runner prints about a spec file with this text. What scripts/test.sh asks of this
-- process is not for that one.
local function run(text, options)
  local path = os.tmpname()
  files.write(path, text)
  local command = "env -u PHYSICS_LUA luajit scripts/plain_busted.lua %s '%s' 2>&1"
  local printed = files.output(command:format(options, path))
  os.remove(path)
  return printed
end

describe("scripts/plain_busted.lua", function()
  it("knows when an assertion holds, and when it does not #files", function()
    local lines = {}
    for i, pair in ipairs(PAIRS) do
      lines[#lines + 1] = ('it("holds %d", function() %s end)'):format(i, pair[1])
      lines[#lines + 1] = ('it("fails %d", function() %s end)'):format(i, pair[2])
    end
    local printed = run(table.concat(lines, "\n"), "")
    for i, pair in ipairs(PAIRS) do
      assert.is_nil(printed:find("FAILED  holds " .. i .. "\n", 1, true), pair[1])
      assert.truthy(printed:find("FAILED  fails " .. i .. "\n", 1, true), pair[2])
    end
    assert.truthy(printed:find("23 passed, 23 failed, 0 left out\n", 1, true), printed)
  end)
end)
