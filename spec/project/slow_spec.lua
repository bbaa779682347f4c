-- The list of slow specs (spec/slow.lua) and the tags in their names say the same.

local files = require("spec.support.files")

local read = files.read
local slow = require("spec.slow")

describe("the list of slow specs", function()
  it("names every spec file that has one, and no other #files", function()
    local listed, found = {}, {}
    for _, row in ipairs(slow.files) do
      assert.is_nil(listed[row[1]], row[1])
      listed[row[1]] = true
      assert.is_true(#row[2] > 0, row[1])
    end
    for _, path in ipairs(files.list("find spec -name '*_spec.lua'")) do
      local isAboutTags = path == "spec/project/slow_spec.lua"
        or path == "spec/project/plain_busted_spec.lua"
      if not isAboutTags and read(path):find("#slow", 1, true) then
        found[path] = true
      end
    end
    assert.same(found, listed)
  end)

  it("is played by scripts/test.sh with all rows, on LuaJIT #files", function()
    local script = read("scripts/test.sh")
    assert.truthy(script:find('%-%-all%)\n.*\n      jobs LuaJIT luajit "%$slow_files"\n'))
  end)
end)
