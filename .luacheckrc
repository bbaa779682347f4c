-- The core is checked against what Lua 5.1 to 5.4 and LuaJIT have in common ("min"). It proves at
-- the same time that the core never names `love`; only the files listed as exceptions may.
std = "min"
max_line_length = 100
exclude_files = { "build", "lua_modules", ".luarocks", "node_modules", "web/node_modules" }

files["physics/world/draw.lua"] = { std = "min+love" }
-- Files of maps, and packed layers.
files["physics/maps/tiled/file.lua"] = { std = "min+love", read_globals = { "setfenv" } }
files["physics/maps/tiled/tilelayer.lua"] = { std = "min+love" }
-- Types for editors: functions without bodies, and types that are longer than a line.
files["physics/types.lua"] = { max_line_length = false, ignore = { "212", "241" } }
files["spec"] = { std = "min+busted" }
files["bench"] = { std = "luajit+love" }
files["bench/conf.lua"] = { std = "luajit+love", globals = { "love" } }
files["bench/main.lua"] = { std = "luajit+love", globals = { "love" } }
files["examples"] = { std = "min+love" }
-- The programs of pages define the callbacks of LÖVE; a step may name what the next one uses.
files["docs/steps"] = { std = "min+love", globals = { "love" }, ignore = { "212/self", "231/player" } }
-- Lines of an export of Tiled are as long as the level.
files["examples/maps"] = { max_line_length = false }
files["spec/maps"] = { std = "min+busted", max_line_length = false }
files["scripts/tiled_maps"] = { std = "luajit+love", globals = { "love" } }
-- conf.lua and main.lua define the callbacks of LÖVE: that is what they are for.
files["examples/conf.lua"] = { std = "min+love", globals = { "love" } }
files["examples/main.lua"] = { std = "min+love", globals = { "love" } }
files["examples/script.lua"] = { std = "min+love", globals = { "love" } }
files["spec/gopher"] = { std = "min", globals = { "arg" }, max_line_length = false }
files["web"] = { std = "min+love", globals = { "love" } }
-- They stand in for LÖVE, or prepare the Lua of the page, which is 5.4.
files["web/playground/stage.lua"] = { std = "min" }
files["web/playground/native.lua"] = { std = "min", globals = { "arg" } }
files["web/playground/boot.lua"] = {
  std = "lua54",
  globals = { "debug", "io", "loadstring", "math", "os", "package", "print", "unpack" },
}
files["scripts"] = { std = "luajit" }
files["scripts/online"] = { std = "luajit+love", globals = { "love" } }
files["scripts/pictures"] = { std = "luajit+love", globals = { "love" } }
-- It plays an example without LÖVE and has to pretend a little.
files["scripts/find_keys.lua"] = { std = "luajit", globals = { "love" } }
-- It runs on every Lua, in the place of busted.
files["scripts/plain_busted.lua"] = { std = "min+busted", globals = { "arg" } }
