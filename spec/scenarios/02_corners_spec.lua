--- Corner to corner: what is met, and on which side.

local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE = variants.EVERYWHERE

describe("onBegin and touching: corners", function()
  --        +-----+
  --    ^   |block|
  --     \  +-----+
  --      +--+
  --      |  |   leaves along the diagonal
  --      +--+
  scene.it("(2a) do not catch a box that moves away from them", EVERYWHERE, function(run)
    local body = run:build({
      gravity = 0,
      { "tiles", { x = 16, y = 0, width = 32, height = 32, static = true } },
      { "boxes", { name = "body", x = 0, y = 32, width = 16, height = 16, vx = -60, vy = -60 } },
    }).body
    local log = run:listen(body)
    run:play(10 / 60)
    run:at(body, -10, 22)
    run:same("vx", body.vx, -60)
    run:same("vy", body.vy, -60)
    run:same("begins", log.begins, 0)
  end)

  --   +--+
  --   |  |  \                 a tie is vertical (so it is not turned)
  --   +--+   v
  --      +--+
  --      |  |
  --      +--+
  for _, group in ipairs({ "tiles", "boxes" }) do
    scene.it("(2b) land a box that meets them exactly, block in group " .. group, nil, function(run)
      local named = run:build({
        gravity = 0,
        { group, { name = "block", x = 16, y = 16, width = 16, height = 16, static = true } },
        { "boxes", { name = "body", x = 0, y = 0, width = 16, height = 16, vx = 600, vy = 600 } },
      })
      local log = run:listen(named.body)
      run:step(1 / 60)
      run:at(named.body, 10, 0)
      run:near("vx", named.body.vx, 600)
      run:same("vy", named.body.vy, 0)
      run:touches(named.body, "bottom")
      run:flush(named.body, named.block, "bottom")
      run:same("begins at the bottom", log.sides.bottom, 1)
      run:same("begins", log.begins, 1)
      run:near("speed", log.speed, 600)
    end)
  end

  --   +----+
  --   |    |  both gaps are 4: met at a tenth of the step
  --   +----+
  --          +--+
  --          +--+
  scene.it("(2c) are met at their moment inside the step", nil, function(run)
    local body = run:build({
      gravity = 0,
      { "tiles", { x = 20, y = 20, width = 8, height = 8, static = true } },
      { "boxes", { name = "body", x = 0, y = 0, width = 16, height = 16, vx = 2400, vy = 2400 } },
    }).body
    local log = run:listen(body)
    run:step(1 / 60)
    run:at(body, 40, 4)
    run:near("vx", body.vx, 2400)
    run:same("vy", body.vy, 0)
    run:same("begins", log.begins, 1)
    run:same("begins at the bottom", log.sides.bottom, 1)
  end)

  --         |  |
  --   +--+  +--+
  --   |  |  |  |       the face of one tile and the corner of the next, half a step away
  --   +--+  |  |
  --      \  +--+
  --       v |  |
  scene.it("of a wall are met after its face", { turn = variants.TURNS }, function(run)
    local description = scene.tiles({ gravity = 0 }, 10, 21, -59, 16, 16, 0, 16)
    local body = { name = "body", x = 0, y = 0, width = 16, height = 16, vx = 600, vy = 600 }
    description[11] = { "boxes", body }
    body = run:build(description).body
    run:step(1 / 60)
    run:at(body, 5, 10)
    run:same("vx", body.vx, 0)
    run:near("vy", body.vy, 600)
  end)

  --   v ->
  --   +--+
  --   |  |
  --   +--+           the top of the block is exactly at the feet
  --         +-----+
  --         |block|
  scene.it(
    "(2d) level with the feet do not stop a box that flies over them",
    EVERYWHERE,
    function(run)
      local body = run:build({
        gravity = 0,
        { "tiles", { x = 40, y = 100, width = 32, height = 32, static = true } },
        { "players", { name = "body", x = 0, y = 76, width = 14, height = 24, vx = 200 } },
      }).body
      local log = run:listen(body)
      for time in run:steps(1) do
        run:at(body, 200 * time, 76)
        run:same("vx", body.vx, 200)
      end
      run:same("begins", log.begins, 0)
    end
  )

  scene.it(
    "(2d) level with the floor do not stop a box that walks on to them",
    EVERYWHERE,
    function(run)
      local body = run:build({
        { "tiles", { x = 0, y = 100, width = 96, height = 8, static = true } },
        { "blocks", { x = 96, y = 100, width = 32, height = 64, static = true } },
        { "tiles", { x = 128, y = 100, width = 200, height = 8, static = true } },
        { "players", { name = "body", x = 0, y = 76, width = 14, height = 24, vx = 200 } },
      }).body
      for time in run:steps(1.5) do
        run:at(body, 200 * time, 76)
        run:same("vx", body.vx, 200)
        run:touches(body, "bottom")
      end
    end
  )

  --        ^
  --      +---++---+
  --      |   ||   |     a jump beside a block of the same height
  --      +---++---+
  --   +---+---+---+---+
  --   64      fractional sizes
  for _, o in ipairs({ 0, 0.1, 0.3, 0.7 }) do
    scene.it(
      ("(2e) beside a jump let it come down where it began, at %g"):format(o),
      EVERYWHERE,
      function(run)
        local description = scene.tiles({}, 6, -32.6, 64 + o, 16.3, 16.3, 16.3, 0)
        description[3][2].name = "floor"
        local size = 16.3
        local block = { x = size + o, y = 47.7 + o, width = size, height = size, static = true }
        local body = { name = "body", x = o, y = 47.7 + o, width = size, height = size, vy = -300 }
        description[#description + 1] = { "blocks", block }
        description[#description + 1] = { "players", body }
        local named = run:build(description)
        for time in run:steps(2) do
          local height = math.max(0, 300 * time - 400 * time * time)
          if time < 0.75 then
            run:at(named.body, o, 47.7 + o - height)
          end
        end
        run:at(named.body, o, 47.7 + o, 1e-9)
        run:flush(named.body, named.floor, "bottom")
        run:still(named.body)
        run:touches(named.body, "bottom")
      end
    )
  end
end)
