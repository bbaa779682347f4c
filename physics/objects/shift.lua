--- Moves a whole world: every object by the same way, with nothing that happens because of it.
--
-- The game's tables and the columns are moved by the same sum, so what was not changed by the game
-- is not changed now. Everything is woken, since sums round: what was flush is flush to 1e-6 px,
-- and the next step makes it exact.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".world.check")
local interpreted = require(root .. ".memory.jit")
local rest = require(root .. ".sleep.islands")

local shift = {}

-- Columns of places.
local PLACES =
  { "position", "written", "last", "from", "to", "origin", "swept", "fatLow", "fatHigh" }

-- Calls f(object, group, key) for all objects in the game's tables.
local function each(objects, f)
  for name, members in next, objects, nil do
    if type(members) == "table" and type(members.width) == "number" then
      f(members, name, nil)
    elseif type(members) == "table" then
      for key, object in next, members, nil do
        if type(object) == "table" then
          f(object, name, key)
        end
      end
    end
  end
end

-- Fails if an object cannot be where it would be.
local function checkAll(objects, dx, dy)
  each(objects, function(object, name, key)
    check.object(object, check.place(name, key))
    if not (check.isFinite(object.x + dx) and check.isFinite(object.y + dy)) then
      check.fail(
        ("world:shift(dx, dy): %s would be too far away, at %s, %s"):format(
          check.place(name, key),
          check.show(object.x + dx),
          check.show(object.y + dy)
        )
      )
    end
  end)
end

local function moveColumns(b, dx, dy)
  for n = 1, #PLACES do
    local column = b[PLACES[n]]
    for k = 2, 2 * b.slots, 2 do
      column[k], column[k + 1] = column[k] + dx, column[k + 1] + dy
    end
  end
  for i = 1, b.slots do
    if b.grown[i] then
      b.wasAt[2 * i], b.wasAt[2 * i + 1] = b.wasAt[2 * i] + dx, b.wasAt[2 * i + 1] + dy
    end
  end
end

-- Puts everything at its new place in the broad phase.
local function refile(b)
  local list, count = {}, 0
  for i = 1, b.slots do
    if b.kind[i] ~= 0 and b.placed[i] ~= 0 then
      count = count + 1
      list[count] = i
    end
  end
  b.broadphase:update(list, count)
end

--- Moves everything by (dx, dy) px.
--- Errors: an object has a field that cannot be used, or would be too far away.
function shift.run(world, dx, dy)
  local b = world._bodies
  checkAll(world.objects, dx, dy)
  each(world.objects, function(object)
    object.x, object.y = object.x + dx, object.y + dy
  end)
  moveColumns(b, dx, dy)
  refile(b)
  rest.wakeAll(b)
  b.view = false -- made anew by the next query
  for layer in next, b.tileLayers or {}, nil do
    layer:_shift(dx, dy)
  end
end

interpreted.always(each, checkAll, shift.run)

return shift
