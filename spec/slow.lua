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

--- The files about what a Lua may do otherwise: numbers and how they are written, messages, the
--- order of tables, states, maps, what is printed by the snippets of the pages, memory.
slow.differs = {
  "spec/debugging_bad_input_spec.lua",
  "spec/debugging_errors_spec.lua",
  "spec/debugging_spec.lua",
  "spec/events_spec.lua",
  "spec/fields_at_run_time_spec.lua",
  "spec/fields_spec.lua",
  "spec/files_spec.lua",
  "spec/filters_spec.lua",
  "spec/inside/lazy_spec.lua",
  "spec/invariants/determinism_spec.lua",
  "spec/invariants/garbage_spec.lua",
  "spec/maps_damaged_spec.lua",
  "spec/maps_ldtk_spec.lua",
  "spec/maps_refusals_spec.lua",
  "spec/maps_spec.lua",
  "spec/maps_tiled_spec.lua",
  "spec/maps_tiled_tiles_spec.lua",
  "spec/maps_tiles_spec.lua",
  "spec/objects_order_spec.lua",
  "spec/objects_spec.lua",
  "spec/platformers_spec.lua",
  "spec/project/docs_spec.lua",
  "spec/project/manual_spec.lua",
  "spec/project/rockspec_spec.lua",
  "spec/queries_many_spec.lua",
  "spec/queries_rays_spec.lua",
  "spec/queries_spec.lua",
  "spec/recipes_spec.lua",
  "spec/settings_spec.lua",
  "spec/sprites_spec.lua",
  "spec/state_damaged_spec.lua",
  "spec/state_maps_spec.lua",
  "spec/state_restore_spec.lua",
  "spec/state_spec.lua",
  "spec/steps_spec.lua",
  "spec/topdown_spec.lua",
  "spec/types_spec.lua",
  "spec/world_spec.lua",
  "spec/world_tutorial_spec.lua",
}

--- The files with slow rows, the longest first, and what takes so long.
slow.files = {
  { "spec/scenarios/20_crowds_spec.lua", "a crowd of 300 around a player, for 20 s" },
  { "spec/scenarios/21_no_room_spec.lua", "machines that leave no room, for eight seconds" },
  { "spec/invariants/recovery_spec.lua", "an error at each place of an update" },
  {
    "spec/invariants/determinism_spec.lua",
    "the scene with everything in it, with other histories and on every Lua",
  },
  { "spec/state_maps_spec.lua", "100 journeys through rooms that are dug" },
  { "spec/state_spec.lua", "a rollback of 8 steps, with each combination of settings" },
  { "spec/oracles/friction_in_stacks_spec.lua", "stacks compared with steps of 1/1500 s" },
  { "spec/character_spec.lua", "a player in a crowd of 100, for each setting" },
  { "spec/scenarios/13_piles_spec.lua", "1000 boxes without friction, for 20 s" },
  { "spec/scenarios/17_pushable_spec.lua", "rows between two boxes, at five frame rates" },
  { "spec/scenarios/12_momentum_spec.lua", "200 bouncing boxes, for 20 s" },
  { "spec/scenarios/27_heaps_spec.lua", "100 balls, poured into a room at three frame rates" },
  { "spec/invariants/soak_spec.lua", "falls of 4600 steps" },
  { "spec/invariants/fuzz_found_spec.lua", "a game with a knot of 30 boxes" },
  { "spec/objects_order_spec.lua", "eight more seeds of random edits" },
}

return slow
