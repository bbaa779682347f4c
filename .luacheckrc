-- The core is checked against what Lua 5.1 to 5.4 and LuaJIT have in common ("min"). It proves at
-- the same time that the core never names `love`; only the files listed as exceptions may.
std = "min"
max_line_length = 100
exclude_files = { "build", "lua_modules", ".luarocks", "node_modules" }

files["physics/draw.lua"] = { std = "min+love" }
files["physics/tiled.lua"] = { std = "min+love" }
-- Types for editors: functions without bodies, and types that are longer than a line.
files["physics/types.lua"] = { max_line_length = false, ignore = { "212", "241" } }
files["spec"] = { std = "min+busted" }
files["bench"] = { std = "luajit+love" }
files["bench/conf.lua"] = { std = "luajit+love", globals = { "love" } }
files["bench/main.lua"] = { std = "luajit+love", globals = { "love" } }
files["examples"] = { std = "min+love" }
-- Lines of an export of Tiled are as long as the level.
files["examples/maps"] = { max_line_length = false }
-- conf.lua and main.lua define the callbacks of LÖVE: that is what they are for.
files["examples/conf.lua"] = { std = "min+love", globals = { "love" } }
files["examples/main.lua"] = { std = "min+love", globals = { "love" } }
files["examples/script.lua"] = { std = "min+love", globals = { "love" } }
files["spec/gopher"] = { std = "min", globals = { "arg" }, max_line_length = false }
files["web"] = { std = "min+love", globals = { "love" } }
files["scripts"] = { std = "luajit" }
-- It plays an example without LÖVE and has to pretend a little.
files["scripts/find_keys.lua"] = { std = "luajit", globals = { "love" } }
-- It runs on every Lua, in the place of busted.
files["scripts/plain_busted.lua"] = { std = "min+busted", globals = { "arg" } }
