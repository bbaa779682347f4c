-- Made by hand in the format of Tiled 1.10, File > Export As > Lua.
-- stylua: ignore
return {
  version = "1.10",
  luaversion = "5.1",
  tiledversion = "1.10.2",
  class = "",
  orientation = "orthogonal",
  renderorder = "right-down",
  width = 16,
  height = 8,
  tilewidth = 16,
  tileheight = 16,
  nextlayerid = 8,
  nextobjectid = 7,
  properties = {},
  tilesets = {
    {
      name = "terrain",
      firstgid = 1,
      class = "",
      tilewidth = 16,
      tileheight = 16,
      spacing = 0,
      margin = 0,
      columns = 4,
      image = "terrain.png",
      imagewidth = 64,
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
      image = "sky.png",
      id = 7,
      name = "sky",
      class = "",
      visible = true,
      opacity = 1,
      offsetx = 0,
      offsety = 0,
      parallaxx = 1,
      parallaxy = 1,
      repeatx = true,
      repeaty = false,
      properties = {}
    },
    {
      type = "tilelayer",
      x = 0,
      y = 0,
      width = 16,
      height = 8,
      id = 1,
      name = "ground",
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
      class = "",
      visible = true,
      opacity = 1,
      offsetx = 0,
      offsety = 16,
      parallaxx = 1,
      parallaxy = 1,
      properties = {},
      layers = {
        {
          type = "objectgroup",
          draworder = "topdown",
          id = 4,
          name = "things",
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
              name = "hero",
              type = "player",
              shape = "rectangle",
              x = 32,
              y = 64,
              width = 12,
              height = 20,
              rotation = 0,
              visible = true,
              properties = {
                ["lives"] = 3,
                ["maxSpeedY"] = 400
              }
            },
            {
              id = 2,
              name = "crate",
              type = "",
              shape = "rectangle",
              x = 80,
              y = 80,
              width = 16,
              height = 16,
              rotation = 0,
              gid = 6,
              visible = true,
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
              rotation = 0,
              visible = true,
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
              type = "",
              shape = "rectangle",
              x = 240,
              y = 72,
              width = 8,
              height = 40,
              rotation = 0,
              visible = true,
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
          class = "",
          visible = true,
          opacity = 1,
          offsetx = 0,
          offsety = -8,
          parallaxx = 1,
          parallaxy = 1,
          properties = {},
          layers = {
            {
              type = "objectgroup",
              draworder = "topdown",
              id = 6,
              name = "coins",
              class = "",
              visible = true,
              opacity = 1,
              offsetx = 2,
              offsety = -4,
              parallaxx = 1,
              parallaxy = 1,
              properties = {
                ["sensor"] = true,
                ["static"] = true
              },
              objects = {
                {
                  id = 4,
                  name = "",
                  type = "coin",
                  shape = "rectangle",
                  x = 64,
                  y = 20,
                  width = 8,
                  height = 8,
                  rotation = 0,
                  visible = true,
                  properties = {}
                },
                {
                  id = 5,
                  name = "",
                  type = "coin",
                  shape = "rectangle",
                  x = 100,
                  y = 20,
                  width = 8,
                  height = 8,
                  rotation = 0,
                  visible = false,
                  properties = {}
                }
              }
            }
          }
        }
      }
    }
  }
}
