-- A floor that crumbles: it goes a moment after something has landed on it, and comes back when its
-- place is free.
--
--   world:add("crumbling", {
--     x = 20, y = 300, width = 80, height = 16, static = true,
--     crumble = crumble.new({ after = 0.5, back = 3 }), onBegin = crumble.onBegin,
--   })
--
--   for _, tile in ipairs(world.objects.crumbling) do crumble.update(world, tile, dt) end
--
-- To let it tremble in its picture: tile.crumble.left is the time in s until it goes, or false.
-- With `world.ownFields = { "crumble" }` it is part of each saved state.

local crumble = {}

--- Returns what goes into tile.crumble. `settings`: after, s from the landing until it goes (0.5);
--- back, s until it is there again (3), false: never.
function crumble.new(settings)
  settings = settings or {}
  local back = settings.back
  return {
    after = settings.after or 0.5,
    back = back == nil and 3 or back,
    left = false, -- s until it goes, or comes back
  }
end

--- The callback of a tile. A tile with a callback of its own calls it there.
function crumble.onBegin(tile, other, side)
  local me = tile.crumble
  if side == "top" and not other.sensor and not me.left then
    me.left = me.after
  end
end

local function show(world, tile, isThere)
  tile.active = isThere
  world:refresh(tile) -- a static object is read only once
end

--- To be called in each frame.
function crumble.update(world, tile, dt)
  local me = tile.crumble
  if not me.left then
    return
  end
  me.left = me.left - dt
  if me.left > 0 then
    return
  elseif tile.active ~= false then
    show(world, tile, false)
    me.left = me.back
  elseif world:fits(tile.x, tile.y, tile.width, tile.height) then
    me.left = false
    show(world, tile, true)
  end
end

return crumble
