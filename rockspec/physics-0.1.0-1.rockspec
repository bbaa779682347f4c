rockspec_format = "3.0"
package = "physics"
version = "0.1.0-1"

source = {
  url = "git+https://github.com/physics-lua/physics.lua",
  tag = "v0.1.0",
}

description = {
  summary = "2D physics for games made of boxes, with your own tables as the objects",
  detailed = [[
A pure-Lua 2D physics library for LÖVE and every other Lua: axis-aligned boxes, exact contacts, no
snagging on tile seams, no tunnelling, the same result at every frame rate and on every machine.
The game's own tables are the physics objects, nothing has to be synchronized.
]],
  homepage = "https://github.com/physics-lua/physics.lua",
  license = "MIT",
  labels = { "love", "game", "physics", "collision" },
}

dependencies = { "lua >= 5.1, < 5.5" }

build = {
  type = "builtin",
  -- spec/rockspec_spec.lua compares this list with the files.
  modules = {
    ["physics"] = "physics.lua",
  },
}
