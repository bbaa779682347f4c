--- What random games have found, made small. `make fuzz` prints such cases: paste one here, see it
--- fail, repair the library.

local trial = require("spec.fuzz.trial")

local FOUND = {
  {
    "a fixed step may leave a little less than no time",
    {
      settings = { timestep = 0.02 },
      acts = {
        { "update", 0.03333333333333333 },
        { "update", 0.03333333333333333 },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "reload" },
      },
    },
  },
  {
    "whoever the game has put in by hand can be pushed at once",
    {
      settings = {},
      acts = {
        { "insert", 1, "crates", { height = 20, width = 20, x = 200, y = 300 } },
        { "impulse", 1, -392, 213 },
        { "update", 0.016666666666666666 },
      },
    },
  },
  {
    "whoever the game has put in by hand stands on nothing yet",
    {
      settings = {},
      acts = {
        { "insert", 1, "players", { height = 1000, width = 600, x = 1800, y = 1000 } },
        { "drop", 1 },
        { "update", 0.016666666666666666 },
      },
    },
  },
}

describe("a random game has found that", function()
  for _, row in ipairs(FOUND) do
    it(row[1], function()
      local failure = trial.run(row[2])
      assert(not failure, failure and failure.check .. ": " .. failure.text)
    end)
  end
end)
