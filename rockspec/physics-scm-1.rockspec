rockspec_format = "3.0"
package = "physics"
version = "scm-1"

-- The address of this project stands here and nowhere else, as "git+https://github.com/OWNER/NAME".
-- While it is empty, pages and site have no links that need it (scripts/publish.lua).
source = {
  url = "",
  branch = "main",
}

description = {
  summary = "2D physics for LÖVE games made of boxes, slopes and balls, with your own tables as the objects",
  detailed = [[
A pure-Lua 2D physics library for LÖVE and every other Lua: axis-aligned boxes, exact contacts, no
snagging on tile seams, no tunnelling, the same result at every frame rate and on every machine.
The game's own tables are the physics objects, nothing has to be synchronized.
]],
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
  -- Written by scripts/list_modules.lua; spec/project/rockspec_spec.lua compares it with the files.
  modules = {
    ["physics"] = "physics.lua",
    ["physics.broadphase.filter"] = "physics/broadphase/filter.lua",
    ["physics.broadphase.grid"] = "physics/broadphase/grid.lua",
    ["physics.broadphase.gridLines"] = "physics/broadphase/gridLines.lua",
    ["physics.broadphase.pairFinder"] = "physics/broadphase/pairFinder.lua",
    ["physics.contacts.contactState"] = "physics/contacts/contactState.lua",
    ["physics.contacts.events"] = "physics/contacts/events.lua",
    ["physics.fields.check"] = "physics/fields/check.lua",
    ["physics.fields.fields"] = "physics/fields/fields.lua",
    ["physics.fields.forms"] = "physics/fields/forms.lua",
    ["physics.fields.wording"] = "physics/fields/wording.lua",
    ["physics.maps.array"] = "physics/maps/array.lua",
    ["physics.maps.atlas"] = "physics/maps/atlas.lua",
    ["physics.maps.cells"] = "physics/maps/cells.lua",
    ["physics.maps.ldtk"] = "physics/maps/ldtk.lua",
    ["physics.maps.level"] = "physics/maps/level.lua",
    ["physics.maps.properties"] = "physics/maps/properties.lua",
    ["physics.maps.recall"] = "physics/maps/recall.lua",
    ["physics.maps.tiled"] = "physics/maps/tiled.lua",
    ["physics.maps.tiled.file"] = "physics/maps/tiled/file.lua",
    ["physics.maps.tiled.objectlayer"] = "physics/maps/tiled/objectlayer.lua",
    ["physics.maps.tiled.shapes"] = "physics/maps/tiled/shapes.lua",
    ["physics.maps.tiled.tilelayer"] = "physics/maps/tiled/tilelayer.lua",
    ["physics.maps.tiled.tileset"] = "physics/maps/tiled/tileset.lua",
    ["physics.maps.tiles"] = "physics/maps/tiles.lua",
    ["physics.memory.allot"] = "physics/memory/allot.lua",
    ["physics.memory.arrays"] = "physics/memory/arrays.lua",
    ["physics.memory.compiler"] = "physics/memory/compiler.lua",
    ["physics.memory.constants"] = "physics/memory/constants.lua",
    ["physics.memory.initial"] = "physics/memory/initial.lua",
    ["physics.memory.keyOrder"] = "physics/memory/keyOrder.lua",
    ["physics.memory.layout"] = "physics/memory/layout.lua",
    ["physics.memory.lazy"] = "physics/memory/lazy.lua",
    ["physics.memory.links"] = "physics/memory/links.lua",
    ["physics.memory.sort"] = "physics/memory/sort.lua",
    ["physics.motion.carriers"] = "physics/motion/carriers.lua",
    ["physics.motion.drift"] = "physics/motion/drift.lua",
    ["physics.motion.forces"] = "physics/motion/forces.lua",
    ["physics.motion.move"] = "physics/motion/move.lua",
    ["physics.motion.path"] = "physics/motion/path.lua",
    ["physics.motion.zones"] = "physics/motion/zones.lua",
    ["physics.narrowphase.ball"] = "physics/narrowphase/ball.lua",
    ["physics.narrowphase.rules"] = "physics/narrowphase/rules.lua",
    ["physics.narrowphase.touch"] = "physics/narrowphase/touch.lua",
    ["physics.narrowphase.yielding"] = "physics/narrowphase/yielding.lua",
    ["physics.objects.groups"] = "physics/objects/groups.lua",
    ["physics.objects.read"] = "physics/objects/read.lua",
    ["physics.objects.readFields"] = "physics/objects/readFields.lua",
    ["physics.objects.registry"] = "physics/objects/registry.lua",
    ["physics.objects.settings"] = "physics/objects/settings.lua",
    ["physics.objects.shift"] = "physics/objects/shift.lua",
    ["physics.objects.write"] = "physics/objects/write.lua",
    ["physics.overlaps.crowd"] = "physics/overlaps/crowd.lua",
    ["physics.overlaps.heap"] = "physics/overlaps/heap.lua",
    ["physics.overlaps.overlap"] = "physics/overlaps/overlap.lua",
    ["physics.overlaps.patience"] = "physics/overlaps/patience.lua",
    ["physics.queries.load"] = "physics/queries/load.lua",
    ["physics.queries.move"] = "physics/queries/move.lua",
    ["physics.queries.near"] = "physics/queries/near.lua",
    ["physics.queries.query"] = "physics/queries/query.lua",
    ["physics.queries.rays"] = "physics/queries/rays.lua",
    ["physics.sleep.islands"] = "physics/sleep/islands.lua",
    ["physics.solver.bonds"] = "physics/solver/bonds.lua",
    ["physics.solver.bounds"] = "physics/solver/bounds.lua",
    ["physics.solver.clip"] = "physics/solver/clip.lua",
    ["physics.solver.contacts"] = "physics/solver/contacts.lua",
    ["physics.solver.flow"] = "physics/solver/flow.lua",
    ["physics.solver.friction"] = "physics/solver/friction.lua",
    ["physics.solver.ground"] = "physics/solver/ground.lua",
    ["physics.solver.impact"] = "physics/solver/impact.lua",
    ["physics.solver.nudge"] = "physics/solver/nudge.lua",
    ["physics.solver.pool"] = "physics/solver/pool.lua",
    ["physics.solver.press"] = "physics/solver/press.lua",
    ["physics.solver.rounds"] = "physics/solver/rounds.lua",
    ["physics.solver.settle"] = "physics/solver/settle.lua",
    ["physics.solver.slant"] = "physics/solver/slant.lua",
    ["physics.solver.snap"] = "physics/solver/snap.lua",
    ["physics.solver.solver"] = "physics/solver/solver.lua",
    ["physics.solver.sweep"] = "physics/solver/sweep.lua",
    ["physics.solver.together"] = "physics/solver/together.lua",
    ["physics.solver.walk"] = "physics/solver/walk.lua",
    ["physics.space.boxes"] = "physics/space/boxes.lua",
    ["physics.space.lines"] = "physics/space/lines.lua",
    ["physics.space.planes"] = "physics/space/planes.lua",
    ["physics.space.shapes"] = "physics/space/shapes.lua",
    ["physics.state.format"] = "physics/state/format.lua",
    ["physics.state.hash"] = "physics/state/hash.lua",
    ["physics.state.restore"] = "physics/state/restore.lua",
    ["physics.state.save"] = "physics/state/save.lua",
    ["physics.state.validate"] = "physics/state/validate.lua",
    ["physics.types"] = "physics/types.lua",
    ["physics.world.bounds"] = "physics/world/bounds.lua",
    ["physics.world.checked"] = "physics/world/checked.lua",
    ["physics.world.class"] = "physics/world/class.lua",
    ["physics.world.draw"] = "physics/world/draw.lua",
    ["physics.world.explain"] = "physics/world/explain.lua",
    ["physics.world.explosion"] = "physics/world/explosion.lua",
    ["physics.world.queryMethods"] = "physics/world/queryMethods.lua",
    ["physics.world.step"] = "physics/world/step.lua",
    ["physics.world.tutorial"] = "physics/world/tutorial.lua",
    ["physics.world.world"] = "physics/world/world.lua",
  },
}
