--- The specs that `make test` leaves out and `make test-all` plays: their names hold the tag #slow.
--- slow_spec.lua compares this list with the tags.

local slow = {}

--- Interpreters on which `make test-all` plays them, as scripts/interpreter.lua names them: LuaJIT
--- in its two ways, and one of the others. LuaJIT plays all rows and variants, the others a
--- selection (spec/support/effort.lua). Lua 5.1 and 5.2 have the numbers and the language of LuaJIT
--- -joff; 5.3 and 5.5 have those of 5.4. Slow specs compare worlds with each other or with numbers
--- worked out by hand. That every Lua computes the same bits is shown on each by
--- determinism_spec.lua, so they would show nothing new there.
slow.interpreters = { "LuaJIT", "LuaJIT -joff", "Lua 5.4" }

--- The files with such specs, the longest first, and what takes so long.
slow.files = {
  { "spec/scenarios/20_crowds_spec.lua", "a crowd of 300 around a player, for a minute" },
  { "spec/scenarios/21_no_room_spec.lua", "machines that leave no room, for eight seconds" },
  { "spec/recovery_spec.lua", "1600 steps of a crowd, and an error at each place of an update" },
  {
    "spec/determinism_spec.lua",
    "the scene with everything in it, with other histories and on every Lua",
  },
  { "spec/state_spec.lua", "a rollback of 8 steps, with each combination of settings" },
  { "spec/properties_spec.lua", "28 seeds of games in which nothing may sink" },
  { "spec/friction_spec.lua", "stacks compared with steps of 1/1500 to 1/4800 s" },
  { "spec/strength_spec.lua", "a player in a crowd of 100, for each setting" },
  { "spec/scenarios/13_piles_spec.lua", "1000 boxes without friction, for 20 s" },
  { "spec/scenarios/17_pushable_spec.lua", "rows between two boxes, at five frame rates" },
  { "spec/scenarios/12_momentum_spec.lua", "200 bouncing boxes, for a minute" },
  { "spec/balls_spec.lua", "200 balls, for a minute" },
  { "spec/heaps_spec.lua", "100 balls, poured into a room at three frame rates" },
  { "spec/examples_spec.lua", "whole levels of the examples, as recorded" },
  { "spec/slopes_spec.lua", "850 walks over hills, and 15 busy worlds in five ways" },
  { "spec/soak_spec.lua", "falls of 4600 steps" },
  { "spec/registry_spec.lua", "eight more seeds of random edits" },
  { "spec/limits_spec.lua", "engines in steps of 1/1000 s" },
}

return slow
