--- The clips of README.md: each entry makes a scene of 640 x 360 px and returns two functions, one
--- that plays a frame of 1/20 s and one that draws it. The numbers that they show are measured.

local physics = require("physics")

local clips = {}

local FPS, STEPS = 20, 3 -- frames a second, steps of a frame
local DT = 1 / (FPS * STEPS)
local WIDTH = 640

-- "Sweetie 16", a palette by GrafxKid.
local COLORS = {
  orange = { 0.94, 0.49, 0.34 },
  yellow = { 1, 0.8, 0.46 },
  green = { 0.22, 0.72, 0.39 },
  sky = { 0.25, 0.65, 0.96 },
  cyan = { 0.45, 0.94, 0.97 },
  blue = { 0.23, 0.36, 0.79 },
  red = { 0.69, 0.24, 0.33 },
  white = { 0.96, 0.96, 0.96 },
  slate = { 0.34, 0.42, 0.53 },
  dusk = { 0.2, 0.24, 0.34 },
}
local ROW = { "sky", "green", "yellow", "orange", "red", "cyan" }
local fonts = {}

local function color(name, alpha)
  local c = COLORS[name]
  love.graphics.setColor(c[1], c[2], c[3], alpha or 1)
end

local function write(text, x, y, size, name, width, align)
  fonts[size] = fonts[size] or love.graphics.newFont(size)
  love.graphics.setFont(fonts[size])
  color(name or "white")
  love.graphics.printf(text, x, y, width or WIDTH, align or "left")
end

local function box(object, name)
  color(name)
  love.graphics.rectangle("fill", object.x, object.y, object.width, object.height, 3)
  love.graphics.setColor(1, 1, 1, 0.2)
  love.graphics.rectangle("fill", object.x + 2, object.y + 2, object.width - 4, 3)
end

-- A box with eyes, which look to where it goes.
local function hero(object, look)
  box(object, "orange")
  local x, y = object.x + object.width / 2 + 4 * look, object.y + object.height * 0.38
  for side = -1, 1, 2 do
    color("white")
    love.graphics.circle("fill", x + 8 * side, y, 6)
    love.graphics.setColor(0.1, 0.11, 0.17)
    love.graphics.circle("fill", x + 8 * side + 2 * look, y, 3)
  end
end

local function ground(y)
  color("slate")
  love.graphics.rectangle("fill", 0, y, WIDTH, 60)
end

local function step(world, each)
  for _ = 1, STEPS do
    world:update(DT)
    if each then
      each()
    end
  end
end

-- Two run over tiles, one of them under the ceiling. Counts the steps at another speed.
function clips.seams()
  local world, tiles, snags = physics.newWorld({ gravity = 800 }), {}, 0
  for i = -3, 19 do
    for _, y in ipairs({ 80, 280 }) do
      local tile = { x = 40 * i, y = y, width = 40, height = 40, static = true }
      tiles[#tiles + 1] = world:add("tiles", tile)
    end
  end
  local low = world:add("heroes", { x = -40, y = 240, width = 36, height = 40 })
  local high = world:add("heroes", { x = 650, y = 120, width = 36, height = 40, gravity = -800 })
  local function play()
    step(world, function()
      snags = snags + (low.vx == 340 and high.vx == -340 and 0 or 1)
      low.vx, high.vx = 340, -340
    end)
  end
  low.vx, high.vx = 340, -340
  return play,
    function()
      for _, tile in ipairs(tiles) do
        color("slate")
        love.graphics.rectangle("fill", tile.x + 1, tile.y, 38, 40, 2)
      end
      hero(low, 1)
      hero(high, -1)
      write(("%d snags"):format(snags), 0, 178, 40, "yellow", WIDTH, "center")
    end
end

-- Ten boxes fall onto each other. Shows the largest gap when all have landed.
function clips.stack()
  local world, boxes = physics.newWorld({ gravity = 800 }), {}
  world:add("tiles", { x = 0, y = 330, width = WIDTH, height = 40, static = true })
  for i = 1, 10 do
    local y = 330 - 30 * i - 34 * i
    boxes[i] = world:add("boxes", { x = 300, y = y, width = 40, height = 30 })
  end
  return function()
    step(world)
  end, function()
    ground(330)
    local gap = 0
    for i, each in ipairs(boxes) do
      box(each, ROW[(i - 1) % #ROW + 1])
      local below = i == 1 and 330 or boxes[i - 1].y
      gap = math.max(gap, math.abs(below - each.y - each.height))
    end
    write(("gap %.3g px"):format(gap), 380, 160, 40, "yellow", 260)
  end
end

-- A lift goes round a square, with a crate and a hero on that. Shows the air below their feet.
function clips.ride()
  local world, gap, time = physics.newWorld({ gravity = 800 }), 0, 0
  local lift = { x = 180, y = 300, width = 130, height = 20, kinematic = true }
  world:add("lifts", lift)
  local crate = world:add("crates", { x = 210, y = 256, width = 44, height = 44 })
  local rider = world:add("heroes", { x = 214, y = 216, width = 36, height = 40 })
  for _ = 1, 4 do
    world:update(DT)
  end
  local ways = { { 0, -280 }, { 300, 0 }, { 0, 280 }, { -300, 0 } }
  return function()
    for _ = 1, STEPS do
      local way = ways[math.floor(time / 30) % 4 + 1]
      lift.vx, lift.vy, time = way[1], way[2], time + 1
      world:update(DT)
      gap = math.max(gap, lift.y - crate.y - crate.height, crate.y - rider.y - rider.height)
    end
  end, function()
    color("dusk")
    love.graphics.setLineWidth(4)
    love.graphics.rectangle("line", 245, 170, 150, 140, 4)
    box(lift, "blue")
    box(crate, "red")
    hero(rider, lift.vx < 0 and -1 or 1)
    write(("gap %.3g px"):format(gap), 24, 20, 40, "yellow")
  end
end

-- A gun at a wall of 1 px. Counts what is behind the wall.
function clips.bullets()
  local world, bullets, frame = physics.newWorld({ gravity = 800 }), {}, 0
  world:add("tiles", { x = 0, y = 330, width = 900, height = 40, static = true })
  world:add("walls", { x = 520, y = -400, width = 1, height = 730, static = true })
  local function play()
    if frame % 5 == 0 and frame < 35 then
      local bullet = { x = 80, y = 196, width = 14, height = 8, vx = 90000, frame = frame }
      bullets[#bullets + 1] = world:add("bullets", bullet)
    end
    step(world)
    frame = frame + 1
  end
  return play,
    function()
      local through = 0
      ground(330)
      love.graphics.rectangle("fill", 30, 180, 50, 40, 6)
      love.graphics.rectangle("fill", 80, 192, 24, 16, 3)
      color("white")
      love.graphics.rectangle("fill", 520, 0, 1, 330)
      for _, bullet in ipairs(bullets) do
        local age = frame - 1 - bullet.frame
        if age < 3 then
          color("yellow", 0.9 - 0.3 * age)
          love.graphics.rectangle("fill", 104, 198 + age, 402, 4 - age)
          love.graphics.circle("fill", 516, 200, 14 - 4 * age)
        end
        box(bullet, "yellow")
        through = through + (bullet.x > 520 and 1 or 0)
      end
      write(("%d of %d through"):format(through, #bullets), 0, 20, 40, "yellow", WIDTH, "center")
    end
end

-- The same jump at three frame rates; a dot for each step.
function clips.rates()
  local lanes = {}
  for i, rate in ipairs({ 30, 60, 240 }) do
    local world = physics.newWorld({ gravity = 1600 })
    world:add("tiles", { x = 0, y = 300, width = 200, height = 40, static = true })
    local jumper = world:add("heroes", { x = 90, y = 260, width = 36, height = 40 })
    world:update(1 / rate)
    jumper.vy = -800
    lanes[i] =
      { rate = rate, world = world, jumper = jumper, dots = {}, left = 0, x = 213 * (i - 1) }
  end
  local function playLane(lane)
    lane.left = lane.left + 1 / FPS
    while lane.left > 1e-9 do
      if lane.jumper.touching.bottom and lane.jumper.vy >= 0 then
        lane.jumper.vy = -800
      end
      lane.world:update(1 / lane.rate)
      lane.left = lane.left - 1 / lane.rate
      lane.dots[#lane.dots + 1] = lane.jumper.y
    end
  end
  return function()
    for _, lane in ipairs(lanes) do
      playLane(lane)
    end
  end, function()
    ground(300)
    color("yellow", 0.7)
    for x = 8, WIDTH, 24 do
      love.graphics.rectangle("fill", x, 60, 12, 2)
    end
    for i, lane in ipairs(lanes) do
      color(ROW[i])
      for n = math.max(1, #lane.dots - lane.rate), #lane.dots do
        love.graphics.circle("fill", lane.x + 70, lane.dots[n], lane.rate == 240 and 2 or 4)
      end
      love.graphics.push()
      love.graphics.translate(lane.x, 0)
      hero(lane.jumper, 1)
      love.graphics.pop()
      write(lane.rate .. " Hz", lane.x, 312, 32, "white", 213, "center")
    end
  end
end

-- A ball hits a pyramid; the world is put back, and plays again. Shows the hash of both.
function clips.bits()
  local world, boxes, frame, hashes = physics.newWorld({ gravity = 800 }), {}, 0, {}
  world:add("tiles", { x = -400, y = 310, width = 1500, height = 40, static = true })
  for row = 0, 4 do
    for i = 0, 4 - row do
      local crate = { x = 260 + 20 * row + 40 * i, y = 270 - 40 * row, width = 40, height = 40 }
      crate.friction = 0.4
      boxes[#boxes + 1] = world:add("boxes", crate)
    end
  end
  local ball = world:add("balls", { x = 20, y = 120, radius = 34, mass = 12, vx = 620, vy = -60 })
  world:update(DT)
  local state = world:save()
  local function play()
    frame = frame + 1
    if frame == 25 then
      world:restore(state)
    end
    if frame <= 48 then
      step(world)
      hashes[math.ceil(frame / 24)] = world:hash()
    end
  end
  return play,
    function()
      ground(310)
      for i, each in ipairs(boxes) do
        box(each, ROW[i % #ROW + 1])
      end
      color("white")
      love.graphics.circle("fill", ball.x + 34, ball.y + 34, 34)
      for i, hash in ipairs(hashes) do
        write(({ "played:", "restored, again:" })[i], 24, 42 * i - 28, 32)
        write(("%.0f"):format(hash), 300, 42 * i - 28, 32, "yellow")
      end
    end
end

return clips
