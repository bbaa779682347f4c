-- Made by hand in the format of Tiled 1.10, File > Export As > Lua.
-- stylua: ignore
return {
  version = "1.10",
  luaversion = "5.1",
  tiledversion = "1.10.2",
  class = "",
  orientation = "orthogonal",
  renderorder = "right-down",
  width = 4,
  height = 2,
  tilewidth = 16,
  tileheight = 16,
  nextlayerid = 6,
  nextobjectid = 10,
  properties = {},
  tilesets = {
    {
      name = "slopes",
      firstgid = 1,
      class = "",
      tilewidth = 16,
      tileheight = 16,
      spacing = 0,
      margin = 0,
      columns = 2,
      image = "slopes.png",
      imagewidth = 32,
      imageheight = 32,
      objectalignment = "unspecified",
      tilerendersize = "tile",
      fillmode = "stretch",
      tileoffset = {
        x = 0,
        y = 0
      },
      grid = {
        orientation = "orthogonal",
        width = 16,
        height = 16
      },
      properties = {},
      wangsets = {},
      tilecount = 4,
      tiles = {
        {
          id = 0,
          objectGroup = {
            type = "objectgroup",
            draworder = "index",
            id = 2,
            name = "",
            class = "",
            visible = true,
            opacity = 1,
            offsetx = 0,
            offsety = 0,
            parallaxx = 1,
            parallaxy = 1,
            properties = {},
            objects = {
              {
                id = 1,
                name = "",
                type = "",
                shape = "polygon",
                x = 0,
                y = 0,
                width = 0,
                height = 0,
                rotation = 0,
                visible = true,
                polygon = {
                  { x = 0, y = 16 },
                  { x = 16, y = 0 },
                  { x = 16, y = 16 }
                },
                properties = {}
              },
              {
                id = 2,
                name = "",
                type = "",
                shape = "rectangle",
                x = 0,
                y = 12,
                width = 16,
                height = 4,
                rotation = 0,
                visible = true,
                properties = {}
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
      class = "",
      visible = true,
      opacity = 1,
      offsetx = 0,
      offsety = 0,
      parallaxx = 1,
      parallaxy = 1,
      properties = {},
      encoding = "lua",
      data = {
        0, 0, 1, 0,
        1, 2, 0, 7
      }
    },
    {
      type = "objectgroup",
      draworder = "topdown",
      id = 2,
      name = "shapes",
      class = "",
      visible = true,
      opacity = 1,
      offsetx = 100,
      offsety = -10,
      parallaxx = 1,
      parallaxy = 1,
      properties = {},
      objects = {
        {
          id = 1,
          name = "ramp",
          type = "",
          shape = "polygon",
          x = 10,
          y = 10,
          width = 0,
          height = 0,
          rotation = 0,
          visible = true,
          polygon = {
            { x = 0, y = 0 },
            { x = 32, y = 0 },
            { x = 32, y = -32 }
          },
          properties = {}
        },
        {
          id = 2,
          name = "",
          type = "",
          shape = "polyline",
          x = 20,
          y = 10,
          width = 0,
          height = 0,
          rotation = 0,
          visible = true,
          polyline = {
            { x = 0, y = 0 },
            { x = 32, y = 0 }
          },
          properties = {}
        },
        {
          id = 3,
          name = "",
          type = "",
          shape = "ellipse",
          x = 30,
          y = 10,
          width = 24,
          height = 16,
          rotation = 0,
          visible = true,
          properties = {}
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
          rotation = 0,
          visible = true,
          properties = {}
        },
        {
          id = 5,
          name = "",
          type = "",
          shape = "text",
          x = 50,
          y = 10,
          width = 60,
          height = 19,
          rotation = 0,
          visible = true,
          text = "Hello",
          wrap = true,
          properties = {}
        },
        {
          id = 6,
          name = "",
          type = "",
          shape = "rectangle",
          x = 60,
          y = 10,
          width = 16,
          height = 16,
          rotation = 30,
          visible = true,
          properties = {}
        },
        {
          id = 7,
          name = "",
          type = "",
          shape = "rectangle",
          x = 70,
          y = 10,
          width = 0,
          height = 0,
          rotation = 0,
          visible = true,
          properties = {}
        },
        {
          id = 8,
          name = "wide",
          type = "",
          shape = "rectangle",
          x = 80,
          y = 10,
          width = 16,
          height = 16,
          rotation = 0,
          visible = true,
          properties = {
            ["width"] = 99
          }
        },
        {
          id = 9,
          name = "quiet",
          type = "",
          shape = "point",
          x = 90,
          y = 10,
          width = 0,
          height = 0,
          rotation = 0,
          visible = true,
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
      class = "",
      visible = true,
      opacity = 1,
      offsetx = 0,
      offsety = 0,
      parallaxx = 0.5,
      parallaxy = 1,
      properties = {},
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
      class = "",
      visible = true,
      opacity = 1,
      offsetx = 0,
      offsety = 0,
      parallaxx = 1,
      parallaxy = 1,
      properties = {},
      encoding = "base64",
      compression = "zlib",
      data = "eJxjYMAEAAAgAAE="
    },
    {
      type = "imagelayer",
      image = "sky.png",
      id = 5,
      name = "hills",
      class = "",
      visible = true,
      opacity = 1,
      offsetx = 0,
      offsety = 0,
      parallaxx = 1,
      parallaxy = 1,
      repeatx = true,
      repeaty = false,
      properties = {
        ["solid"] = true
      }
    }
  }
}
