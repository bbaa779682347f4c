rockspec_format = "3.0"
package = "physics"
version = "scm-1"

source = {
  url = "git+https://github.com/physics-lua/physics.lua",
  branch = "main",
}

description = {
  summary = "2D physics for games made of boxes, with your own tables as the objects",
  detailed = [[
A pure-Lua 2D physics library for LÖVE and every other Lua: axis-aligned boxes, exact contacts, no
snagging on tile seams, no tunnelling, the same result at every frame rate and on every machine.
The game's own tables are the physics objects, nothing has to be synchronized.
]],
  homepage = "https://github.com/physics-lua/physics.lua",
  issues_url = "https://github.com/physics-lua/physics.lua/issues",
  license = "MIT",
  labels = { "love", "game", "physics", "collision" },
}

dependencies = { "lua >= 5.1, < 5.6" }

-- `luarocks test`: the specs, on the Lua of that LuaRocks instead of the one in .busted.
test_dependencies = { "busted >= 2.1" }

test = {
  type = "busted",
  flags = { "--ignore-lua" },
}

build = {
  type = "builtin",
  -- Written by scripts/list_modules.lua; spec/rockspec_spec.lua compares it with the files.
  modules = {
    ["physics"] = "physics.lua",
    ["physics.aabb"] = "physics/aabb.lua",
    ["physics.approach"] = "physics/approach.lua",
    ["physics.ask"] = "physics/ask.lua",
    ["physics.bank"] = "physics/bank.lua",
    ["physics.begin"] = "physics/begin.lua",
    ["physics.bounds"] = "physics/bounds.lua",
    ["physics.broadphase.grid"] = "physics/broadphase/grid.lua",
    ["physics.broadphase.pairs"] = "physics/broadphase/pairs.lua",
    ["physics.cargo"] = "physics/cargo.lua",
    ["physics.carrier"] = "physics/carrier.lua",
    ["physics.check"] = "physics/check.lua",
    ["physics.collect"] = "physics/collect.lua",
    ["physics.columns"] = "physics/columns.lua",
    ["physics.contact"] = "physics/contact.lua",
    ["physics.crush"] = "physics/crush.lua",
    ["physics.detect"] = "physics/detect.lua",
    ["physics.draw"] = "physics/draw.lua",
    ["physics.events"] = "physics/events.lua",
    ["physics.explain"] = "physics/explain.lua",
    ["physics.fields"] = "physics/fields.lua",
    ["physics.filter"] = "physics/filter.lua",
    ["physics.footing"] = "physics/footing.lua",
    ["physics.forces"] = "physics/forces.lua",
    ["physics.friction"] = "physics/friction.lua",
    ["physics.gather"] = "physics/gather.lua",
    ["physics.grip"] = "physics/grip.lua",
    ["physics.guard"] = "physics/guard.lua",
    ["physics.hash"] = "physics/hash.lua",
    ["physics.impact"] = "physics/impact.lua",
    ["physics.interpreted"] = "physics/interpreted.lua",
    ["physics.keyorder"] = "physics/keyorder.lua",
    ["physics.live"] = "physics/live.lua",
    ["physics.lone"] = "physics/lone.lua",
    ["physics.meet"] = "physics/meet.lua",
    ["physics.move"] = "physics/move.lua",
    ["physics.nudge"] = "physics/nudge.lua",
    ["physics.obstacle"] = "physics/obstacle.lua",
    ["physics.oneway"] = "physics/oneway.lua",
    ["physics.part"] = "physics/part.lua",
    ["physics.pass"] = "physics/pass.lua",
    ["physics.path"] = "physics/path.lua",
    ["physics.predict"] = "physics/predict.lua",
    ["physics.press"] = "physics/press.lua",
    ["physics.publish"] = "physics/publish.lua",
    ["physics.pure"] = "physics/pure.lua",
    ["physics.query"] = "physics/query.lua",
    ["physics.queue"] = "physics/queue.lua",
    ["physics.reserve"] = "physics/reserve.lua",
    ["physics.resolve"] = "physics/resolve.lua",
    ["physics.rest"] = "physics/rest.lua",
    ["physics.restore"] = "physics/restore.lua",
    ["physics.ring"] = "physics/ring.lua",
    ["physics.roster"] = "physics/roster.lua",
    ["physics.rounds"] = "physics/rounds.lua",
    ["physics.settings"] = "physics/settings.lua",
    ["physics.slide"] = "physics/slide.lua",
    ["physics.sort"] = "physics/sort.lua",
    ["physics.state"] = "physics/state.lua",
    ["physics.sweep"] = "physics/sweep.lua",
    ["physics.tiled"] = "physics/tiled.lua",
    ["physics.tiled.merge"] = "physics/tiled/merge.lua",
    ["physics.tiled.objectlayer"] = "physics/tiled/objectlayer.lua",
    ["physics.tiled.properties"] = "physics/tiled/properties.lua",
    ["physics.tiled.report"] = "physics/tiled/report.lua",
    ["physics.tiled.tilelayer"] = "physics/tiled/tilelayer.lua",
    ["physics.tiled.tileset"] = "physics/tiled/tileset.lua",
    ["physics.tower"] = "physics/tower.lua",
    ["physics.turns"] = "physics/turns.lua",
    ["physics.typed"] = "physics/typed.lua",
    ["physics.types"] = "physics/types.lua",
    ["physics.verify"] = "physics/verify.lua",
    ["physics.view"] = "physics/view.lua",
    ["physics.weld"] = "physics/weld.lua",
    ["physics.world"] = "physics/world.lua",
  },
}
