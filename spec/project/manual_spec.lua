--- What scripts write from the source is what they would write now, and the source says it all.

local docstrings = require("scripts.docstrings")
local fields = require("scripts.meanings")
local manual = require("scripts.manual")
local physics = require("physics")
local snippets = require("spec.support.snippets")
local types = require("scripts.types")

local read = snippets.read

-- Compares line by line: two long texts that differ say nothing when shown as a whole.
local function assertSame(expected, found)
  local expectedLines, number = expected:gmatch("([^\n]*)\n"), 0
  for line in found:gmatch("([^\n]*)\n") do
    number = number + 1
    assert.equal(expectedLines(), line, "line " .. number .. ", is it old? make docs")
  end
  assert.equal(expected, found)
end

describe("the reference", function()
  local pages = manual.pages()
  local text = {}
  for path, page in pairs(pages) do
    text[#text + 1] = page
    it("has " .. path .. " as scripts/manual.lua writes it", function()
      assertSame(page, read(path))
    end)
  end
  local all = table.concat(text, "\n")

  it("has a heading and an example for every function of the module and of worlds", function()
    local methods, found = getmetatable(physics.newWorld()).__index, {}
    local expected = { ["world:load"] = 1 }
    for name, value in pairs(physics) do
      if type(value) == "function" then
        local isOwn = name == "load" or not methods[name] -- (`load` means something else there)
        expected[(isOwn and "physics." or "world:") .. name] = 1
      end
    end
    local marked = all:gsub("\n## ", "\n\1")
    for name, section in marked:gmatch("\1(%l+[:.]%l%w*)\n\n(`[^`\n]+%([^\1]*)") do
      assert(section:find("\n```lua\n"), "docs/api/ has no example at the end of " .. name)
      found[name] = name:find("^world") or name:find("^physics") or nil
    end
    assert.same(expected, found)
  end)

  -- Every default that is written as Lua is the one that a new world or object has.
  for kind, list in pairs({ field = fields.objects, setting = fields.settings }) do
    it("has the default of each " .. kind, function()
      for _, field in ipairs(list) do
        local row = ('id="%s%%-%s"></a>'):format(kind, field.name:lower())
          .. "`[^`]*` | [^|\n]* | ([^|\n]*) | [^\n]* |\n"
        local default = assert(all:match(row), field.name)
        local code = default:match("^`(.*)`$")
        if code then
          local value = snippets.compile("return " .. code, "=default", {})()
          assert.equal(field.default, value, field.name)
        else
          assert.is_true(
            field.required or field.written or (field.absent or "none") == default,
            field.name
          )
        end
      end
    end)
  end

  it("has a heading for every method of tiles", function()
    local tiles = physics.newWorld():addTiles("tiles", { 1 }, 1, 16)
    local count = 0
    for name, value in pairs(getmetatable(tiles).__index) do
      if type(value) == "function" then
        assert.truthy(all:find("\n## tiles:" .. name .. "\n", 1, true), name)
        count = count + 1
      end
    end
    assert.equal(5, count)
  end)

  it("has every counter of world.stats, and nothing that only the library reads", function()
    local section = all:match("\n## physics%.Stats %(type%)\n(.-)\n## ")
    local world, count = physics.newWorld(), 0
    for name in pairs(world.stats) do
      assert.truthy(section:find("- `" .. name .. "` (`integer`): ", 1, true), name)
      count = count + 1
    end
    assert.equal(6, count)
    assert.is_nil(all:find("world._", 1, true))
  end)
end)

local text = read("physics/types.lua")

it("physics/types.lua is what scripts/types.lua writes", function()
  assertSame(types.text(), text)
end)

describe("the docstring", function()
  for _, source in ipairs(docstrings.SOURCES) do
    local list = docstrings.functions(source)

    it("names each parameter, says what it is, and what is refused: " .. source.owner, function()
      assert.is_true(#list > 1)
      for _, entry in ipairs(list) do
        local names = {}
        for _, param in ipairs(entry.params) do
          names[#names + 1] = param.name
          assert.not_equal("", param.text, entry.name .. ": " .. param.name)
        end
        assert.equal(entry.arguments:gsub(",? ?%.%.%.", ""), table.concat(names, ", "), entry.name)
        local saysErrors = ("\n" .. table.concat(entry.text, "\n")):find("\nErrors: ")
        assert(#names == 0 or entry.owner == "world" or saysErrors, entry.name .. ": errors")
      end
    end)
  end
end)

it("docs/maps.md lists every option of every loader #files", function()
  local page = read("docs/maps.md")
  for _, name in ipairs({ "maps/tiled", "maps/array", "maps/ldtk" }) do
    local list = read("physics/" .. name .. ".lua"):match("local OPTIONS =(.-)\n[-\n]")
    for option in list:gmatch("%w+") do
      assert.truthy(page:find("`" .. option .. "`", 1, true), option)
    end
  end
end)
