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
  {
    "a row between two that cannot be pushed stops both",
    {
      settings = { gravity = 0 },
      acts = {
        {
          "add",
          1,
          "boxes",
          { x = 0, y = 0, width = 16, height = 16, vx = 150, pushable = false },
        },
        { "add", 2, "boxes", { x = 16, y = 0, width = 16, height = 16 } },
        { "add", 3, "boxes", { x = 32, y = 0, width = 16, height = 16 } },
        { "add", 4, "boxes", { x = 48, y = 0, width = 16, height = 16, pushable = false } },
        { "update", 0.016666666666666666 },
      },
    },
  },
  {
    "a restored copy may be told to read an object anew before its first step",
    {
      settings = {},
      acts = {
        { "add", 1, "tiles", { height = 20, static = true, width = 20, x = 100, y = 300 } },
        { "listen", 1, "onBegin", {} },
        { "update", 0.01 },
        { "twin" },
        { "update", 0 },
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
