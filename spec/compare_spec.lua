--- The table of docs/compare.md: the scenes of examples/compare, with the numbers that the two
--- engines come to which need no LÖVE.

package.path = package.path .. ";./examples/compare/?.lua"

local files = require("spec.support.files")
local physics = require("physics")
local plays = require("plays")
local scenes = require("scenes")
local small = require("spec.support.small")

local PAGE = files.read("docs/compare.md")

local function cellsOf(scene)
  local cells = {}
  local start = PAGE:find("\n| " .. scene.title .. " |", 1, true)
  for cell in PAGE:match("\n|([^\n]*)", start):gmatch(" *(.-) *|") do
    cells[#cells + 1] = cell
  end
  return cells
end

describe("docs/compare.md", function()
  local engines = {}
  for _, each in ipairs(plays.engines()) do
    engines[each.name] = each
  end

  it("has a row for each scene", function()
    local _, rows = PAGE:match("## Side by side(.-)## Promises"):gsub("\n|[^\n]*|[^\n]*|", "")
    assert.equal(#scenes.list + 2, rows) -- and two of the head
  end)

  for _, scene in ipairs(scenes.list) do
    it("says what comes out: " .. scene.title, function()
      local cells = cellsOf(scene)
      assert.equal(scene.unit, cells[2])
      if not scene.isTimed then
        local ours = plays.number(scene, engines.ours)
        assert.equal(cells[3], plays.show(ours))
        assert.equal(scene.name == "bullet" and "stopped" or 0, ours)
        assert.equal(cells[6], plays.show(plays.number(scene, engines.tutorial)))
      end
    end)
  end

  it("says how high a rider is above the lift that does not hold it", function()
    local world = physics.newWorld({ gravity = 600 })
    local lift = small.put(0, 60, 120, 12, { kinematic = true, carry = false, vy = 300 })
    world:add("lifts", lift)
    local rider, gap = world:add("riders", small.put(20, 36, 24, 24)), 0
    small.run(world, 60, 60, function()
      gap = math.max(gap, lift.y - rider.y - rider.height)
    end)
    assert.near(75, gap, 0.1)
  end)
end)
