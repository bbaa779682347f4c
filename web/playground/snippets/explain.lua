-- Explain: click on two objects, or press 1 to 4, and the library says in a sentence why they
-- collide or do not.

local physics = require("physics")

local QUESTIONS =
  { { "ghost", "wall" }, { "hero", "wall" }, { "hero", "coin" }, { "hero", "shelf" } }

local first, second, answer

function love.load()
  physics.load({ gravity = 900, masks = { ghosts = { walls = false } } })
  physics.setBounds(0, 0, 800, 600)
  local function add(group, object)
    physics.add(group, object)
    return object
  end
  physics.objects.things = {
    hero = { x = 180, y = 400, width = 32, height = 40 },
    coin = { x = 185, y = 520, width = 20, height = 20, static = true, sensor = true },
    shelf = { x = 140, y = 460, width = 160, height = 10, static = true, oneWay = "top" },
  }
  physics.objects.walls = { wall = { x = 480, y = 300, width = 30, height = 300, static = true } }
  physics.objects.ghosts =
    { ghost = { x = 380, y = 380, width = 32, height = 40, vx = 60, gravity = 0 } }
  add("crates", { x = 600, y = 400, width = 50, height = 50, active = false })
  first, second, answer = nil, nil, "Click on two objects."
end

local function find(name)
  for _, group in ipairs({ "things", "walls", "ghosts" }) do
    if physics.objects[group][name] then
      return physics.objects[group][name]
    end
  end
end

local function ask(a, b)
  first, second = a, b
  answer = physics.explain(a, b)
end

function love.keypressed(key)
  local question = QUESTIONS[tonumber(key)]
  if question then
    ask(find(question[1]), find(question[2]))
  end
end

function love.mousepressed(x, y)
  local object = physics.queryPoint(x, y)[1]
  if not object then
    return
  elseif first and not second and first ~= object then
    ask(first, object)
  else
    first, second, answer = object, nil, "And the other one?"
  end
end

function love.update(dt)
  physics.update(dt)
end

local function mark(object)
  if object then
    love.graphics.setLineWidth(3)
    love.graphics.rectangle("line", object.x - 4, object.y - 4, object.width + 8, object.height + 8)
  end
end

function love.draw()
  physics.draw({ names = true })
  love.graphics.setColor(1, 1, 1)
  mark(first)
  mark(second)
  love.graphics.setNewFont(18)
  love.graphics.printf(answer, 40, 40, 720)
end
