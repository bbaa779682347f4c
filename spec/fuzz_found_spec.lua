--- What random games have found, made small. `make fuzz` prints such cases: paste one here, see it
--- fail, repair the library. One of them has found nothing but a change that no spec noticed
--- (`make mutants`).

local trial = require("spec.fuzz.trial")

-- Adds updates of a sixtieth of a second.
local function followedBy(acts, updates)
  for _ = 1, updates do
    acts[#acts + 1] = { "update", 0.016666666666666666 }
  end
  return acts
end

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
  {
    "a rider that becomes a lift itself has no carrier any more",
    {
      settings = { gravityX = -12800 },
      acts = {
        { "add", 23, "crates", { height = 1000, width = 1000, x = 13800, y = 19000 } },
        { "add", 24, "boxes", { height = 1000, width = 1000, x = 13800, y = 18000 } },
        { "add", 27, "boxes", { friction = 1, height = 1000, width = 1000, x = 13100, y = 19000 } },
        { "add", 28, "crates", { height = 1000, width = 1000, x = 13100, y = 18000 } },
        {
          "add",
          46,
          "lifts",
          {
            height = 800,
            kinematic = true,
            vx = -500,
            vy = -4600,
            width = 6100,
            x = 6700,
            y = 19900,
          },
        },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "set", "maxStep", 0.01 },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "write", 28, { kinematic = true } },
        { "update", 0.016666666666666666 },
        { "remove", 24 },
        { "update", 0.016666666666666666 },
      },
    },
  },
  {
    "a lift goes on to where it was written after an error, restored or not",
    {
      settings = {},
      acts = {
        { "add", 8, "crates", { height = 1, width = 1, x = 10, y = 20 } },
        { "add", 9, "boxes", { height = 1, width = 1, x = 10, y = 20 } },
        { "add", 10, "crates", { height = 1, width = 1, x = 10, y = 20 } },
        { "insert", 34, "lifts", { height = 1, kinematic = true, width = 2, x = 0.125, y = 20 } },
        { "update", 0.006944444444444444 },
        { "write", 34, { x = 10, y = 10 } },
        { "listen", 0, "onStay", { { "fail" } } },
        { "update", 0.0753890756474706 },
        { "twin" },
        { "update", 0.016666666666666666 },
      },
    },
  },
  {
    "who stands under a ceiling is not dragged into it",
    {
      settings = {},
      acts = {
        { "add", 15, "tiles", { height = 10, static = true, width = 10, x = 100, y = 160 } },
        { "insert", 24, 1, { friction = 1, height = 10, width = 10, x = 110, y = 150 } },
        { "add", 25, "players", { friction = 1, height = 10, width = 10, x = 117, y = 150 } },
        { "add", 53, "statics", { height = 10, static = true, width = 100, x = 100, y = 140 } },
        { "update", 0.015625 },
        { "impulse", 25, -1743.3629573726685, -4199.60041735284 },
        { "update", 0.015625 },
      },
    },
  },
  {
    "a row that comes apart between a wall and one that cannot be pushed leaves the wall",
    {
      settings = {},
      acts = followedBy({
        { "add", 1, "tiles", { height = 10, static = true, width = 10, x = 0, y = 160 } },
        { "insert", 5, "tiles", { height = 10, static = true, width = 10, x = 30, y = 160 } },
        { "insert", 7, "tiles", { height = 10, static = true, width = 10, x = 48, y = 160 } },
        { "insert", 10, "tiles", { height = 10, static = true, width = 10, x = 70, y = 160 } },
        { "add", 12, "tiles", { height = 10, static = true, width = 10, x = 90, y = 160 } },
        { "insert", 21, "walls", { height = 330, static = true, width = 10, x = -8, y = -160 } },
        { "add", 24, "players", { height = 8, width = 10, x = 80, y = 150 } },
        { "add", 25, "crates", { height = 8, width = 8, x = 87, y = 150 } },
        { "add", 26, "players", { height = 8, restitution = 1, width = 8, x = 90, y = 152 } },
        { "add", 30, "boxes", { height = 10, width = 10, x = 86, y = 140 } },
        {
          "add",
          31,
          "players",
          { height = 8, pushable = false, restitution = 1, width = 10, x = 86.5, y = 140 },
        },
        { "add", 39, "players", { height = 10, width = 14, x = 50, y = 100 } },
        { "add", 49, 1, { height = 20, pushable = false, vx = -40, width = 3, x = 30, y = 50 } },
        {
          "add",
          52,
          "lifts",
          { height = 10, kinematic = true, vx = -30, width = 100, x = 97, y = 150 },
        },
        { "insert", 53, "statics", { height = 5.5, static = true, width = 20, x = 90, y = 137 } },
      }, 51),
    },
  },
  {
    "a restored copy is told of those who had left after a callback had failed",
    {
      settings = {},
      acts = {
        { "add", 27, "crates", { height = 1, width = 1, x = 10, y = 20 } },
        { "insert", 29, 2.5, { height = 1, width = 1, x = 15, y = 20 } },
        { "bounds", 1.8029632994932712, 0.40417612474800657, 14.5, 14.5 },
        { "update", 0.015625 },
        { "listen", 0, "onEnd", { { "fail" } } },
        { "bounds", 1.1206745152554238, 1.1765847794493518, 11.3, 11.3 },
        { "update", 0.015625 },
        { "twin" },
        { "update", 0.015625 },
      },
    },
  },
  {
    "a stack that is pushed off a wall again and again takes along who cannot be pushed",
    {
      settings = { timestep = 0.008333333333333333 },
      acts = {
        { "add", 36, 2.5, { height = 20, pushable = false, width = 20, x = 100, y = 260 } },
        { "add", 37, "players", { height = 20, width = 20, x = 100, y = 240 } },
        { "add", 38, 2.5, { height = 20, width = 20, x = 100, y = 220 } },
        { "add", 42, "boxes", { height = 30, width = 20, x = 140, y = 200 } },
        { "add", 49, "boxes", { height = 20, vx = 200, width = 20, x = 120, y = 200 } },
        { "add", 54, "statics", { height = 20, static = true, width = 30, x = 100, y = 190 } },
        { "update", 0.015625 },
        {
          "listen",
          42,
          "onStay",
          {
            {
              "add",
              61,
              "lifts",
              { height = 16, kinematic = true, vx = -76, vy = 16, width = 48, x = 312, y = 154 },
            },
            {
              "insert",
              62,
              "crates",
              {
                friction = 0.16042504865715748,
                height = 30,
                vx = -160,
                width = 20,
                x = 100,
                y = 200,
              },
            },
          },
        },
        { "update", 0.015625 },
        { "update", 0.015625 },
      },
    },
  },
  {
    "a lift pushes two that cannot be pushed, and the row between them",
    {
      settings = {},
      acts = {
        { "insert", 2, "crates", { height = 30, pushable = false, width = 30, x = 140, y = 100 } },
        { "insert", 3, "crates", { height = 20, vx = 10, width = 16, x = 124, y = 100 } },
        { "add", 4, 2.5, { height = 20, pushable = false, width = 20, x = 100, y = 100 } },
        { "insert", 5, "crates", { height = 20, width = 20, x = 80, y = 100 } },
        {
          "add",
          6,
          "lifts",
          { height = 20, kinematic = true, vx = 200, width = 20, x = 60, y = 100 },
        },
        { "update", 0.03333333333333333 },
      },
    },
  },
  {
    "one that bounces between a lift and a row is not left in it",
    {
      settings = {},
      acts = {
        { "add", 1, "players", { height = 20, restitution = 1, width = 20, x = 180, y = 100 } },
        { "insert", 2, "crates", { height = 20, pushable = false, width = 20, x = 160, y = 100 } },
        { "add", 3, 2.5, { height = 20, width = 16, x = 144, y = 100 } },
        {
          "insert",
          4,
          "players",
          { height = 20, pushable = false, vx = 100, width = 20, x = 124, y = 100 },
        },
        {
          "insert",
          5,
          "lifts",
          { height = 20, kinematic = true, vx = -100, width = 20, x = 200, y = 100 },
        },
        { "update", 0.015625 },
      },
    },
  },
  {
    "a lift pushes a stack down onto one that cannot be pushed",
    {
      settings = {},
      acts = {
        { "insert", 1, 1, { height = 20, pushable = false, width = 20, x = 100, y = 180 } },
        { "add", 2, 1, { height = 20, width = 20, x = 100, y = 160 } },
        { "add", 3, "players", { height = 30, width = 20, x = 100, y = 100 } },
        { "add", 5, 2.5, { height = 20, pushable = false, width = 20, x = 100, y = 100 } },
        {
          "insert",
          7,
          "lifts",
          { height = 20, kinematic = true, vy = 200, width = 20, x = 100, y = 70 },
        },
        { "insert", 9, "boxes", { height = 16, width = 20, x = 100, y = 100 } },
        { "update", 0.03333333333333333 },
        { "update", 0.016666666666666666 },
        { "update", 0.03333333333333333 },
      },
    },
  },
  {
    "a pile on one that bounces is settled in the order of the queue, above the origin, too",
    {
      settings = {},
      acts = followedBy({
        { "add", 16, "tiles", { height = 100, static = true, width = 100, x = -1000, y = -500 } },
        { "add", 18, "tiles", { height = 100, static = true, width = 100, x = -800, y = -500 } },
        { "add", 22, "walls", { height = 4100, static = true, width = 100, x = -500, y = -4500 } },
        {
          "insert",
          24,
          "boxes",
          { ax = 4100, friction = 1, height = 100, width = 100, x = -900, y = -700 },
        },
        { "add", 25, "players", { height = 100, width = 100, x = -900, y = -800 } },
        {
          "add",
          28,
          "crates",
          { height = 100, restitution = 1, width = 100, x = -930, y = -600 },
        },
        { "insert", 30, "boxes", { friction = 1, height = 100, width = 100, x = -700, y = -600 } },
        { "insert", 31, "players", { height = 100, width = 100, x = -630, y = -600 } },
        { "insert", 32, "boxes", { height = 100, width = 100, x = -530, y = -600 } },
      }, 2),
    },
  },
  {
    "who hangs on a wall by friction stays at every dt",
    {
      settings = { gravity = 4000 },
      acts = {
        { "add", 22, "walls", { height = 4100, static = true, width = 100, x = 2000, y = -2000 } },
        {
          "add",
          43,
          1,
          { friction = 10, gravityX = 3100, height = 100, width = 100, x = 1970, y = 800 },
        },
        { "update", 0.37540420979764705 },
        { "update", 3.191472257665798e-07 },
      },
    },
  },
  {
    "masks that change are in force before overlaps part, restored or not",
    {
      settings = {},
      acts = {
        { "add", 12, "tiles", { height = 100, static = true, width = 100, x = 1100, y = 2000 } },
        { "add", 22, "walls", { height = 4100, static = true, width = 100, x = 2000, y = -2000 } },
        { "add", 29, 2.5, { height = 100, width = 100, x = 1100, y = 1900 } },
        { "insert", 30, "crates", { height = 100, width = 100, x = 1140, y = 1800 } },
        { "add", 37, 1, { height = 200, mass = 4.5, vx = -700, width = 100, x = 1100, y = 1500 } },
        {
          "insert",
          50,
          "boxes",
          { height = 100, mass = 6, vx = 1100, width = 100, x = 1000, y = 1500 },
        },
        { "update", 0.015625 },
        { "update", 0.015625 },
        { "update", 0.015625 },
        { "update", 0.015625 },
        { "update", 0.015625 },
        { "update", 0.015625 },
        { "update", 0.015625 },
        { "update", 0.015625 },
        {
          "bounds",
          14.744784603589014,
          15.596282310407872,
          1545.0290478254008,
          1545.0290478254008,
        },
        { "update", 0.015625 },
        { "update", 0.015625 },
        { "update", 0.015625 },
        { "update", 0.015625 },
        { "update", 0.015625 },
        { "update", 0.015625 },
        { "update", 0.015625 },
        { "update", 0.015625 },
        { "update", 0.015625 },
        { "update", 0.015625 },
        { "update", 0.015625 },
        { "update", 0.015625 },
        { "write", 22, { x = 1220, y = 40 } },
        { "set", "masks", { { boxes = false, crates = false } } },
        { "update", 0.015625 },
        { "set", "masks", {} },
        { "reload" },
        { "update", 0.015625 },
      },
    },
  },
  {
    "who rests on two that are exchanged in the order of the groups touches the first",
    {
      settings = { masks = { [2.5] = { [2.5] = false, crates = false } } },
      acts = {
        { "insert", 13, "tiles", { height = 20, static = true, width = 20, x = 200, y = 320 } },
        { "add", 26, "crates", { height = 16, width = 20, x = 197, y = 300 } },
        { "add", 27, 2.5, { height = 16, width = 20, x = 197, y = 300 } },
        { "add", 28, 1, { height = 20, width = 20, x = 200, y = 270 } },
        { "add", 29, 2.5, { height = 20, width = 20, x = 200, y = 260 } },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "set", "maxStep", 0.01 },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "set", "order", { 1, "crates", "boxes" } },
        { "update", 0.05 },
      },
    },
  },
  {
    "who rests on two that are exchanged in their group touches the first",
    {
      settings = {},
      acts = {
        { "add", 1, "tiles", { height = 20, static = true, width = 20, x = 180, y = 320 } },
        { "add", 2, "tiles", { height = 20, static = true, width = 20, x = 200, y = 320 } },
        { "add", 3, "boxes", { height = 20, width = 20, x = 190, y = 300 } },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "update", 0.016666666666666666 },
        { "regroup", 1, "tiles" },
        { "update", 0.016666666666666666 },
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
