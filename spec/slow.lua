--- What is not played everywhere, and why. LuaJIT, as LÖVE has it, plays every row of every file;
--- in `make test` without the rows that hold the tag #slow, and in fewer variants.
---
--- That every Lua computes the same bits is shown by determinism_spec.lua: the scene with
--- everything in it comes to one number on each of them. So a row that compares worlds with each
--- other, or with numbers worked out by hand, shows nothing new on a second Lua. What is left out:
---
--- - Lua 5.4 in `make test`, and Lua 5.1, 5.2, 5.3 and 5.5 in `make test-all`, play the files of
---   `slow.differs` only.
--- - LuaJIT -joff in `make test-all` plays all files for the coverage, but no slow rows, and of
---   rows and variants another selection than `make test`. It runs the code of LuaJIT, and has the
---   language and the numbers of Lua 5.1.
--- - Lua 5.4 in `make test-all` plays the same: in it whole numbers are another type.
---
--- spec/support/effort.lua selects. slow_spec.lua compares these lists with the tags and files.

local slow = {}

--- Interpreters on which `make test-all` plays the slow rows, by their names in
--- scripts/interpreter.lua.
slow.interpreters = { "LuaJIT" }

--- The files about what a Lua may do otherwise: numbers and how they are written, messages, the
--- order of tables, states, maps, what is printed by the snippets of the pages, memory.
slow.differs = {
  "spec/bad_input_spec.lua",
  "spec/check_spec.lua",
  "spec/determinism_spec.lua",
  "spec/docs_spec.lua",
  "spec/events_spec.lua",
  "spec/fields_spec.lua",
  "spec/fixed_step_spec.lua",
  "spec/garbage_spec.lua",
  "spec/debugging_spec.lua",
  "spec/lazy_spec.lua",
  "spec/ldtk_spec.lua",
  "spec/manual_spec.lua",
  "spec/maps_damaged_spec.lua",
  "spec/maps_game_spec.lua",
  "spec/maps_refusals_spec.lua",
  "spec/pure_spec.lua",
  "spec/queries_spec.lua",
  "spec/recipes_spec.lua",
  "spec/registry_spec.lua",
  "spec/rockspec_spec.lua",
  "spec/runtime_spec.lua",
  "spec/settings_spec.lua",
  "spec/state_spec.lua",
  "spec/tiled_spec.lua",
  "spec/tiled_tiles_spec.lua",
  "spec/tiles_spec.lua",
  "spec/tutorial_spec.lua",
  "spec/world_spec.lua",
}

--- The files with slow rows, the longest first, and what takes so long.
slow.files = {
  { "spec/scenarios/20_crowds_spec.lua", "a crowd of 300 around a player, for 20 s" },
  { "spec/scenarios/21_no_room_spec.lua", "machines that leave no room, for eight seconds" },
  { "spec/recovery_spec.lua", "an error at each place of an update" },
  {
    "spec/determinism_spec.lua",
    "the scene with everything in it, with other histories and on every Lua",
  },
  { "spec/state_spec.lua", "a rollback of 8 steps, with each combination of settings" },
  { "spec/properties_spec.lua", "eight more seeds of games in which nothing may sink" },
  { "spec/friction_spec.lua", "stacks compared with steps of 1/1500 s" },
  { "spec/strength_spec.lua", "a player in a crowd of 100, for each setting" },
  { "spec/scenarios/13_piles_spec.lua", "1000 boxes without friction, for 20 s" },
  { "spec/scenarios/17_pushable_spec.lua", "rows between two boxes, at five frame rates" },
  { "spec/scenarios/12_momentum_spec.lua", "200 bouncing boxes, for 20 s" },
  { "spec/balls_spec.lua", "200 balls, for a minute" },
  { "spec/heaps_spec.lua", "100 balls, poured into a room at three frame rates" },
  { "spec/soak_spec.lua", "falls of 4600 steps" },
  { "spec/registry_spec.lua", "eight more seeds of random edits" },
}

return slow
