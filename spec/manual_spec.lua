--- What scripts write from the source is what they would write now, and the source says it all.

local docstrings = require("scripts.docstrings")
local fields = require("physics.fields")
local manual = require("scripts.manual")
local physics = require("physics")
local types = require("scripts.types")

local function read(path)
  local file = assert(io.open(path, "rb"))
  local text = file:read("*a")
  file:close()
  return text
end

-- Compares line by line: two long texts that differ say nothing when shown as a whole.
local function assertSame(expected, found)
  local expectedLines, number = expected:gmatch("([^\n]*)\n"), 0
  for line in found:gmatch("([^\n]*)\n") do
    number = number + 1
    assert.equal(expectedLines(), line, "line " .. number .. ", is it old? make docs")
  end
  assert.equal(expected, found)
end

local SOURCES = {
  { "physics.lua", "physics" },
  { "physics/pure.lua", "pure" },
  { "physics/world.lua", "World" },
  { "physics/maps/tiles.lua", "Tiles" },
}

describe("docs/api.md", function()
  local page = read("docs/api.md")

  it("is what scripts/manual.lua writes", function()
    assertSame(manual.text(), page)
  end)

  it("has a heading for every function of the module and of worlds", function()
    local methods, count = getmetatable(physics.newWorld()).__index, 0
    for name, value in pairs(physics) do
      if type(value) == "function" then
        local place = methods[name] and "world:" or "physics."
        assert.truthy(page:find("\n### " .. place .. name .. "(", 1, true), place .. name)
        count = count + 1
      end
    end
    assert.is_true(count > 25)
  end)

  it("has a heading for every method of tiles", function()
    local tiles = physics.newWorld():addTiles("tiles", { 1 }, 1, 16)
    local count = 0
    for name, value in pairs(getmetatable(tiles).__index) do
      if type(value) == "function" then
        assert.truthy(page:find("\n### tiles:" .. name .. "(", 1, true), name)
        count = count + 1
      end
    end
    assert.equal(5, count)
  end)

  it("has every counter of world.stats, and nothing that only the library reads", function()
    local section = page:match("\n### physics%.Stats\n(.-)\n### ")
    local world, count = physics.newWorld(), 0
    for name in pairs(world.stats) do
      assert.truthy(section:find("- `" .. name .. "` (`integer`): ", 1, true), name)
      count = count + 1
    end
    assert.equal(6, count)
    assert.is_nil(page:find("world._", 1, true))
  end)

  it("links to files that exist", function()
    for path in page:gmatch("%]%(([^#)]+)%)") do
      read("docs/" .. path)
    end
  end)
end)

describe("physics/types.lua", function()
  local text = read("physics/types.lua")

  it("is what scripts/types.lua writes", function()
    assertSame(types.text(), text)
  end)

  it("has every field of objects and every setting", function()
    for _, list in pairs({ fields.objects, fields.settings }) do
      for _, field in ipairs(list) do
        assert.truthy(text:find("\n---@field " .. field.name .. "%??%s"), field.name)
      end
    end
  end)

  it("has every method of a world as a function", function()
    for name, value in pairs(getmetatable(physics.newWorld()).__index) do
      if type(value) == "function" then
        assert.truthy(text:find("\nfunction default." .. name .. "(", 1, true), name)
      end
    end
  end)

  it("is Lua that does nothing", function()
    local before = {}
    for name in pairs(_G) do
      before[name] = true
    end
    dofile("physics/types.lua")
    for name in pairs(_G) do
      assert.is_true(before[name], name)
    end
  end)
end)

describe("the docstring", function()
  for _, source in ipairs(SOURCES) do
    local _, list = docstrings.functions(source[1], source[2])

    it("names each parameter of each function, " .. source[1], function()
      assert.is_true(#list > 2)
      for _, entry in ipairs(list) do
        local names = {}
        for _, param in ipairs(entry.params) do
          names[#names + 1] = param.name
        end
        local expected = entry.arguments:gsub(",? ?%.%.%.", "")
        assert.equal(expected, table.concat(names, ", "), entry.name)
      end
    end)

    it("says what each parameter is, " .. source[1], function()
      for _, entry in ipairs(list) do
        for _, param in ipairs(entry.params) do
          assert.not_equal("", param.text, entry.name .. ": " .. param.name)
        end
      end
    end)

    it("says what is refused, " .. source[1], function()
      for _, entry in ipairs(list) do
        if #entry.params > 0 and entry.owner ~= "world" then
          local text = "\n" .. table.concat(entry.text, "\n")
          assert.truthy(text:find("\nErrors: "), entry.name .. " has no line of errors")
        end
      end
    end)
  end

  -- the line of a field, the name that is read
  for _, row in ipairs({
    { "---@field pairs integer neighbours", "pairs" },
    { "---@field public size number px", "size" },
    { "---@field private size number px" },
    { "---@field protected size number px" },
    { "---@field package _size number px" },
    { "---@field [string] any", "[string]" },
  }) do
    it("is read: " .. row[1], function()
      local path = os.tmpname()
      local file = assert(io.open(path, "wb"))
      file:write("---@class C\n", row[1], "\nlocal C = {}\n")
      file:close()
      local fieldsOfIt = docstrings.read(path)[1].fields
      os.remove(path)
      assert.equal(row[2], fieldsOfIt[1] and fieldsOfIt[1].name)
    end)
  end

  -- the lines of a docstring, the name and the type and the text that are read
  for _, row in ipairs({
    { "---@param x number px, left edge", "x", "number", "px, left edge" },
    { "---@param f fun(a: table, b: T): any who", "f", "fun(a: table, b: T): any", "who" },
    { '---@param m "a" | "b"|nil which', "m", '"a" | "b"|nil', "which" },
    { "---@param o table?", "o", "table?", "" },
    { "---@param o table? one\n---  two", "o", "table?", "one two" },
  }) do
    it("is read: " .. row[1]:gsub("\n", " / "), function()
      local path = os.tmpname()
      local file = assert(io.open(path, "wb"))
      file:write("--- Does.\n", row[1], "\nfunction M:go(a, b)\nend\n")
      file:close()
      local entry = docstrings.functions(path, "M").go
      os.remove(path)
      local param = entry.params[1]
      assert.same({ row[2], row[3], row[4] }, { param.name, param.type, param.text })
      assert.equal("a, b", entry.arguments)
    end)
  end
end)
