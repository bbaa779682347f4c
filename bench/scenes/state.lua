--- What rollback needs every frame: the state of a pile, put away, brought back, as one number.

local pile = require("bench.scenes.pile")[1]

local function advance(world)
  world:step(1 / 60)
end

local function scene(name, title, prepare)
  return {
    name = name,
    title = title,
    sizes = { 1000 },
    quick = 60,
    build = function(count)
      local built = pile.build(count)
      built.steps, built.needs = nil, { "state" }
      built.frame, built.between = prepare()
      return built
    end,
  }
end

return {
  scene("save", "save(out) of n objects", function()
    local state
    return function(world)
      state = world:save(state)
    end, advance
  end),
  scene("restore", "restore of n objects, one step back", function()
    local state
    return function(world)
      world:restore(state)
    end, function(world)
      state = world:save(state)
      world:step(1 / 60)
    end
  end),
  scene("hash", "hash of n objects", function()
    return function(world)
      world:hash()
    end, advance
  end),
}
