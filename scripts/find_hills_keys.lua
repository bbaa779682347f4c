-- Plays the example hills without a window, as a player would that sees it, and prints the keys:
--
--   luajit scripts/find_hills_keys.lua >examples/demos/hills.keys
--
-- Needed when the level, the player or (**Behaviour**) the physics changed so that the recorded
-- keys no longer win.

package.path = "./?.lua;./examples/?.lua;" .. package.path

local LONGEST, JUMP, BEFORE = 3600, 22, 20 -- frames: at most; a key is held; before the first key

-- The game asks LÖVE for the keyboard, and its art for nothing.
local function nothing() end
package.loaded.hills_art = { load = nothing, update = nothing, burst = nothing }
love = {
  keyboard = {
    isDown = function()
      return false
    end,
  },
}
local input = require("input")
local hills = require("hills")

hills.load()
local objects = hills.world.objects
local player, cart, car = objects.players[1], objects.carts[1], objects.cars[1]
local pond, turtle, planks = objects.water[1], objects.turtles[1], objects.planks
local frame, first, keys = 0, {}, {}

local function hold(key)
  first[key] = first[key] or frame + 1
end

local function letGo(key)
  if first[key] then
    keys[#keys + 1] = ("%s:%d-%d"):format(key, first[key], frame)
    first[key] = nil
  end
end

local function step()
  frame = frame + 1
  assert(frame < LONGEST, "the way is not found")
  input.held = {}
  for key in pairs(first) do
    input.held[key] = true
  end
  hills.update(1 / 60)
  assert(hills.report():find("deaths=0"), "the player fell into the water")
  if first.space and frame - first.space + 1 >= JUMP then
    letGo("space")
  end
end

local function wait(isReached)
  while not isReached() do
    step()
  end
end

local function runTo(x)
  hold("right")
  wait(function()
    return player.x >= x
  end)
end

local function stand()
  letGo("right")
end

local function jump()
  hold("space")
  step()
end

local function isOn(group)
  return function()
    for _, object in ipairs(objects[group]) do
      if player.touching.bottom == object then
        return true
      end
    end
    return false
  end
end

for _ = 1, BEFORE do
  step()
end
for i = 1, 3 do -- over the crates
  runTo(objects.crates[i].x - 46)
  jump()
end
runTo(objects.crates[5].x - 52)
jump()
runTo(planks[#planks].x - 240) -- through the bridge, in its middle
letGo("right")
hold("down")
step()
letGo("down")
runTo(pond.x - 34)
stand()
wait(function()
  return turtle.x < pond.x + 16
end)
runTo(pond.x - 24)
jump()
wait(isOn("turtles"))
runTo(turtle.x + 60)
stand()
wait(function()
  return turtle.x + 150 > pond.x + pond.width - 16
end)
runTo(turtle.x + 96)
jump()
runTo(objects.crates[6].x - 50) -- at the top of the stairs
jump()
runTo(car.fromX - 30)
stand()
wait(function()
  return car.y > car.fromY - 1
end)
hold("right")
jump()
runTo(car.x + 20)
stand()
wait(function()
  return car.y < car.toY + 1
end)
runTo(cart.x - 46)
jump()
runTo(cart.x + 4)
stand()
wait(function()
  return cart.touching.right
end)
hold("right")
jump()
wait(function()
  return hills.report():find("won=true")
end)
stand()
print(table.concat(keys, ","))
