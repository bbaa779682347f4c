--- Columns of ten boxes that stand on a floor and do not move.
---
---   +-+ +-+ +-+
---   +-+ +-+ +-+
---   +-+ +-+ +-+
---   -----------

local HIGH, SIZE, SPACING = 10, 16, 20 -- boxes, px, px

local function build(count)
  local columns = math.ceil(count / HIGH)
  local objects = {
    { group = "walls", x = -20, y = 0, width = columns * SPACING + 40, height = 40, static = true },
  }
  for i = 0, count - 1 do
    local column = math.floor(i / HIGH)
    objects[#objects + 1] = {
      group = "boxes",
      x = column * SPACING,
      y = -SIZE * (i - column * HIGH + 1),
      width = SIZE,
      height = SIZE,
      friction = 0.3,
    }
  end
  return objects
end

local function scene(name, title, rest)
  return {
    name = name,
    title = title,
    sizes = { 1000, 10000 },
    quick = 60,
    build = function(count)
      return { gravity = 800, rest = rest, objects = build(count) }
    end,
  }
end

return {
  scene("rest", "everything at rest", true),
  scene("rest-awake", "the same, without rest", false),
}
