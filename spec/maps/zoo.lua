-- Made by hand in the format of Tiled 1.10, File > Export As > Lua.
-- stylua: ignore
return {
  orientation = "orthogonal",
  width = 4,
  height = 2,
  tilewidth = 16,
  tileheight = 16,
  tilesets = {
    {
      name = "slopes",
      firstgid = 1,
      tilewidth = 16,
      tileheight = 16,
      tilecount = 4,
      tiles = {
        {
          id = 0,
          objectGroup = {
            type = "objectgroup",
            id = 2,
            objects = {
              {
                id = 1,
                shape = "polygon",
                x = 0,
                y = 0,
                width = 0,
                height = 0,
                polygon = {
                  { x = 0, y = 16 },
                  { x = 16, y = 0 },
                  { x = 16, y = 16 }
                },
              },
              {
                id = 2,
                shape = "rectangle",
                x = 0,
                y = 12,
                width = 16,
                height = 4,
              }
            }
          }
        },
        {
          id = 1,
          properties = {
            ["solid"] = true
          }
        }
      }
    },
    {
      name = "far",
      firstgid = 5,
      filename = "far.tsx"
    }
  },
  layers = {
    {
      type = "tilelayer",
      x = 0,
      y = 0,
      width = 4,
      height = 2,
      id = 1,
      name = "slopes",
      encoding = "lua",
      data = {
        0, 0, 1, 0,
        1, 2, 0, 7
      }
    },
    {
      type = "objectgroup",
      id = 2,
      name = "shapes",
      offsetx = 100,
      offsety = -10,
      objects = {
        {
          id = 1,
          name = "ramp",
          shape = "polygon",
          x = 10,
          y = 10,
          width = 0,
          height = 0,
          polygon = {
            { x = 0, y = 0 },
            { x = 32, y = 0 },
            { x = 32, y = -32 }
          },
        },
        {
          id = 2,
          shape = "polyline",
          x = 20,
          y = 10,
          width = 0,
          height = 0,
          polyline = {
            { x = 0, y = 0 },
            { x = 32, y = 0 }
          },
        },
        {
          id = 3,
          shape = "ellipse",
          x = 30,
          y = 10,
          width = 24,
          height = 16,
        },
        {
          id = 4,
          name = "start",
          type = "spawn",
          shape = "point",
          x = 40,
          y = 10,
          width = 0,
          height = 0,
        },
        {
          id = 5,
          shape = "text",
          x = 50,
          y = 10,
          width = 60,
          height = 19,
          text = "Hello",
          wrap = true,
        },
        {
          id = 6,
          shape = "rectangle",
          x = 60,
          y = 10,
          width = 16,
          height = 16,
          rotation = 30,
        },
        {
          id = 7,
          shape = "rectangle",
          x = 70,
          y = 10,
          width = 0,
          height = 0,
        },
        {
          id = 8,
          name = "wide",
          shape = "rectangle",
          x = 80,
          y = 10,
          width = 16,
          height = 16,
          properties = {
            ["width"] = 99
          }
        },
        {
          id = 9,
          name = "quiet",
          shape = "point",
          x = 90,
          y = 10,
          width = 0,
          height = 0,
          properties = {
            ["solid"] = false
          }
        }
      }
    },
    {
      type = "tilelayer",
      x = 0,
      y = 0,
      width = 4,
      height = 2,
      id = 3,
      name = "clouds",
      parallaxx = 0.5,
      encoding = "lua",
      data = {
        2, 2, 0, 0,
        0, 0, 0, 0
      }
    },
    {
      type = "tilelayer",
      x = 0,
      y = 0,
      width = 4,
      height = 2,
      id = 4,
      name = "packed",
      encoding = "base64",
      compression = "zlib",
      data = "eJxjYMAEAAAgAAE="
    },
    {
      type = "imagelayer",
      id = 5,
      name = "hills",
      repeatx = true,
      repeaty = false,
      properties = {
        ["solid"] = true
      }
    }
  }
}
