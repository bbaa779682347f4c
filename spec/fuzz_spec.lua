--- A short part of the random games (spec/fuzz/). `make fuzz SECONDS=600` plays more of them.

local case = require("spec.fuzz.case")
local effort = require("spec.support.effort")
local trial = require("spec.fuzz.trial")
local write = require("spec.fuzz.write")

local loadText = rawget(_G, "loadstring") or load

describe("random games", function()
  it("keep what is promised after every step", function()
    local updates = 0
    for seed = 1, effort.share(12) do
      local one = case.new(seed, 40)
      local failure, steps = trial.run(one)
      if failure then
        error(("seed %d: %s: %s"):format(seed, failure.check, failure.text))
      end
      updates = updates + steps
    end
    assert.equal(40 * effort.share(12), updates)
  end)

  it("are the same each time, and written down they are the same again", function()
    local one, other = case.new(3, 20), case.new(3, 20)
    assert.same(one, other)
    local read = assert(loadText("return " .. write.case(one)))()
    assert.same(one.acts, read.acts)
    assert.same(one.settings, read.settings)
  end)
end)
