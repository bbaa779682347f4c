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
    ["physics.broadphase.activePairs"] = "physics/broadphase/activePairs.lua",
    ["physics.broadphase.allPairs"] = "physics/broadphase/allPairs.lua",
    ["physics.broadphase.filter"] = "physics/broadphase/filter.lua",
    ["physics.broadphase.grid"] = "physics/broadphase/grid.lua",
    ["physics.broadphase.pairFinder"] = "physics/broadphase/pairFinder.lua",
    ["physics.contacts.contactState"] = "physics/contacts/contactState.lua",
    ["physics.contacts.events"] = "physics/contacts/events.lua",
    ["physics.maps.array"] = "physics/maps/array.lua",
    ["physics.maps.cells"] = "physics/maps/cells.lua",
    ["physics.maps.digging"] = "physics/maps/digging.lua",
    ["physics.maps.ldtk"] = "physics/maps/ldtk.lua",
    ["physics.maps.ldtk.project"] = "physics/maps/ldtk/project.lua",
    ["physics.maps.merge"] = "physics/maps/merge.lua",
    ["physics.maps.properties"] = "physics/maps/properties.lua",
    ["physics.maps.rewind"] = "physics/maps/rewind.lua",
    ["physics.maps.tiled"] = "physics/maps/tiled.lua",
    ["physics.maps.tiled.decode"] = "physics/maps/tiled/decode.lua",
    ["physics.maps.tiled.layers"] = "physics/maps/tiled/layers.lua",
    ["physics.maps.tiled.objectlayer"] = "physics/maps/tiled/objectlayer.lua",
    ["physics.maps.tiled.options"] = "physics/maps/tiled/options.lua",
    ["physics.maps.tiled.report"] = "physics/maps/tiled/report.lua",
    ["physics.maps.tiled.shapes"] = "physics/maps/tiled/shapes.lua",
    ["physics.maps.tiled.source"] = "physics/maps/tiled/source.lua",
    ["physics.maps.tiled.tilelayer"] = "physics/maps/tiled/tilelayer.lua",
    ["physics.maps.tiled.tileset"] = "physics/maps/tiled/tileset.lua",
    ["physics.maps.tiles"] = "physics/maps/tiles.lua",
    ["physics.maps.values"] = "physics/maps/values.lua",
    ["physics.memory.aabb"] = "physics/memory/aabb.lua",
    ["physics.memory.columnStore"] = "physics/memory/columnStore.lua",
    ["physics.memory.columns"] = "physics/memory/columns.lua",
    ["physics.memory.jit"] = "physics/memory/jit.lua",
    ["physics.memory.keyOrder"] = "physics/memory/keyOrder.lua",
    ["physics.memory.lazy"] = "physics/memory/lazy.lua",
    ["physics.memory.sort"] = "physics/memory/sort.lua",
    ["physics.memory.typedArrays"] = "physics/memory/typedArrays.lua",
    ["physics.motion.begin"] = "physics/motion/begin.lua",
    ["physics.motion.drift"] = "physics/motion/drift.lua",
    ["physics.motion.flight"] = "physics/motion/flight.lua",
    ["physics.motion.forces"] = "physics/motion/forces.lua",
    ["physics.motion.move"] = "physics/motion/move.lua",
    ["physics.motion.path"] = "physics/motion/path.lua",
    ["physics.motion.predict"] = "physics/motion/predict.lua",
    ["physics.motion.softCells"] = "physics/motion/softCells.lua",
    ["physics.objects.carriers"] = "physics/objects/carriers.lua",
    ["physics.objects.read"] = "physics/objects/read.lua",
    ["physics.objects.registry"] = "physics/objects/registry.lua",
    ["physics.objects.shift"] = "physics/objects/shift.lua",
    ["physics.objects.write"] = "physics/objects/write.lua",
    ["physics.queries.index"] = "physics/queries/index.lua",
    ["physics.queries.move"] = "physics/queries/move.lua",
    ["physics.queries.notice"] = "physics/queries/notice.lua",
    ["physics.queries.obstacle"] = "physics/queries/obstacle.lua",
    ["physics.queries.query"] = "physics/queries/query.lua",
    ["physics.queries.sweptAabb"] = "physics/queries/sweptAabb.lua",
    ["physics.sleep.islands"] = "physics/sleep/islands.lua",
    ["physics.solver.bonds"] = "physics/solver/bonds.lua",
    ["physics.solver.contacts"] = "physics/solver/contacts.lua",
    ["physics.solver.crowd"] = "physics/solver/crowd.lua",
    ["physics.solver.crush"] = "physics/solver/crush.lua",
    ["physics.solver.flow"] = "physics/solver/flow.lua",
    ["physics.solver.friction"] = "physics/solver/friction.lua",
    ["physics.solver.impact"] = "physics/solver/impact.lua",
    ["physics.solver.knots"] = "physics/solver/knots.lua",
    ["physics.solver.nudge"] = "physics/solver/nudge.lua",
    ["physics.solver.oneWay"] = "physics/solver/oneWay.lua",
    ["physics.solver.permission"] = "physics/solver/permission.lua",
    ["physics.solver.pool"] = "physics/solver/pool.lua",
    ["physics.solver.rules"] = "physics/solver/rules.lua",
    ["physics.solver.separate"] = "physics/solver/separate.lua",
    ["physics.solver.settle"] = "physics/solver/settle.lua",
    ["physics.solver.snap"] = "physics/solver/snap.lua",
    ["physics.solver.solver"] = "physics/solver/solver.lua",
    ["physics.solver.sweep"] = "physics/solver/sweep.lua",
    ["physics.state.hash"] = "physics/state/hash.lua",
    ["physics.state.own"] = "physics/state/own.lua",
    ["physics.state.restore"] = "physics/state/restore.lua",
    ["physics.state.save"] = "physics/state/save.lua",
    ["physics.state.standing"] = "physics/state/standing.lua",
    ["physics.state.validate"] = "physics/state/validate.lua",
    ["physics.types"] = "physics/types.lua",
    ["physics.world.bounds"] = "physics/world/bounds.lua",
    ["physics.world.check"] = "physics/world/check.lua",
    ["physics.world.draw"] = "physics/world/draw.lua",
    ["physics.world.explain"] = "physics/world/explain.lua",
    ["physics.world.fields"] = "physics/world/fields.lua",
    ["physics.world.settings"] = "physics/world/settings.lua",
    ["physics.world.strictMode"] = "physics/world/strictMode.lua",
    ["physics.world.tutorial"] = "physics/world/tutorial.lua",
    ["physics.world.world"] = "physics/world/world.lua",
  },
}
