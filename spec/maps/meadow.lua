-- Made by hand in the format of Tiled 1.10, File > Export As > Lua.
-- stylua: ignore
return {
  orientation = "orthogonal",
  width = 16,
  height = 8,
  tilewidth = 16,
  tileheight = 16,
  tilesets = {
    {
      name = "terrain",
      firstgid = 1,
      tilewidth = 16,
      tileheight = 16,
      tilecount = 8,
      tiles = {
        {
          id = 0,
          type = "earth",
          properties = {
            ["friction"] = 0.5,
            ["solid"] = true
          }
        },
        {
          id = 1,
          properties = {
            ["oneWay"] = "top",
            ["solid"] = true
          }
        },
        {
          id = 2,
          type = "water",
          properties = {
            ["sensor"] = true,
            ["solid"] = true
          }
        },
        {
          id = 3,
          type = "flower",
          animation = {
            {
              tileid = 3,
              duration = 200
            },
            {
              tileid = 4,
              duration = 200
            }
          }
        }
      }
    }
  },
  layers = {
    {
      type = "imagelayer",
      id = 7,
      name = "sky",
      repeatx = true,
      repeaty = false,
    },
    {
      type = "tilelayer",
      x = 0,
      y = 0,
      width = 16,
      height = 8,
      id = 1,
      name = "ground",
      encoding = "lua",
      data = {
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 2, 2, 2, 2, 2, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 3, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0,
        1, 0, 0, 0, 0, 0, 1, 1, 1, 1, 0, 0, 0, 0, 0, 1,
        1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1
      }
    },
    {
      type = "tilelayer",
      x = 0,
      y = 0,
      width = 16,
      height = 8,
      id = 2,
      name = "flowers",
      encoding = "lua",
      data = {
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 4, 0, 4, 4, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0
      }
    },
    {
      type = "group",
      id = 3,
      name = "things in it",
      offsety = 16,
      layers = {
        {
          type = "objectgroup",
          id = 4,
          name = "things",
          objects = {
            {
              id = 1,
              name = "hero",
              type = "player",
              shape = "rectangle",
              x = 32,
              y = 64,
              width = 12,
              height = 20,
              properties = {
                ["lives"] = 3,
                ["maxSpeedY"] = 400
              }
            },
            {
              id = 2,
              name = "crate",
              shape = "rectangle",
              x = 80,
              y = 80,
              width = 16,
              height = 16,
              gid = 6,
              properties = {
                ["mass"] = 0.5
              }
            },
            {
              id = 3,
              name = "lift",
              type = "platform",
              shape = "rectangle",
              x = 176,
              y = 48,
              width = 48,
              height = 8,
              properties = {
                goal = { id = 6 },
                ["kinematic"] = true,
                ["oneWay"] = "top",
                ["toY"] = 112
              }
            },
            {
              id = 6,
              name = "door",
              shape = "rectangle",
              x = 240,
              y = 72,
              width = 8,
              height = 40,
              properties = {
                ["color"] = "#ff336699",
                ["open"] = false,
                ["static"] = true
              }
            }
          }
        },
        {
          type = "group",
          id = 5,
          name = "high up",
          offsety = -8,
          layers = {
            {
              type = "objectgroup",
              id = 6,
              name = "coins",
              offsetx = 2,
              offsety = -4,
              properties = {
                ["sensor"] = true,
                ["static"] = true
              },
              objects = {
                {
                  id = 4,
                  type = "coin",
                  shape = "rectangle",
                  x = 64,
                  y = 20,
                  width = 8,
                  height = 8,
                },
                {
                  id = 5,
                  type = "coin",
                  shape = "rectangle",
                  x = 100,
                  y = 20,
                  width = 8,
                  height = 8,
                  visible = false,
                }
              }
            }
          }
        }
      }
    }
  }
}
