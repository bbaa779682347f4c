--- examples/README.md: each example of the menu has a row, which names all files that it requires.

local files = require("spec.support.files")

local README = files.read("examples/README.md")

-- Adds the names of the files of examples/ that one of them requires, and those require.
local function addRequired(name, found)
  for other in files.read("examples/" .. name .. ".lua"):gmatch('require%("([%w_.]+)"%)') do
    other = other:gsub("%.", "/")
    if other ~= "physics" and other ~= "enet" and not found[other] then
      found[other] = true
      addRequired(other, found)
    end
  end
  return found
end

local count = 0
for name in files.read("examples/menu.lua"):gmatch('{ name = "(%w+)", title = ') do
  count = count + 1
  describe("the row of " .. name .. " in examples/README.md", function()
    it("names all files that the example needs", function()
      local row = README:match("\n| %[" .. name .. "%.lua%]%(" .. name .. "%.lua%) |[^\n]*")
      assert.truthy(row, "there is no row")
      for other in pairs(addRequired(name, {})) do
        local folder = "`" .. (other:match("^.*/") or "?") .. "`"
        local isNamed = row:find("`" .. other .. ".lua`", 1, true) or row:find(folder, 1, true)
        assert.truthy(isNamed, other .. ".lua is not named")
      end
    end)
  end)
end

it("examples/README.md has a row for each example", function()
  local _, rows = README:gsub("\n| %[%w+%.lua%]", "")
  assert.equal(count, rows)
  assert.is_true(count >= 12)
end)
