--- Tries a case: plays it in several worlds side by side and checks everything after every update.
--
--   tried      as the case says: whatever broad phase, rest, cells, reloads
--   plain      pair by pair, nothing skipped, in a world in which others have been before
--   twin       a restored copy of the tried one, from some point on

local checks = require("spec.fuzz.checks")
local player = require("spec.fuzz.player")
local small = require("spec.support.small")

-- Runs no slower without the trace compiler, which has too many loops to see here.
local jit = rawget(_G, "jit")
if jit then
  jit.off(true, true)
end

local trial = {}

local PLAIN = { broadphase = "pairs", rest = false, guests = true }
local TWINS = {
  { broadphase = "grid", rest = true },
  { broadphase = "pairs", rest = true },
  { broadphase = "grid", rest = false },
}
local FIELDS = { "x", "y", "vx", "vy", "width", "height" }
local SIDES = { "top", "bottom", "left", "right" }

-- Comparing --------------------------------------------------------------------------------------

local function idIn(self, object)
  return object and (self.idOf[object] or "a wall")
end

local function differ(name, id, field, a, b)
  local text = "%s: object %d: %s is %s and %s"
  local function show(value)
    return type(value) == "number" and ("%.17g"):format(value) or tostring(value)
  end
  return "same " .. name, text:format(name, id, field, show(a), show(b))
end

local function compareObject(name, a, b, id)
  local first, second = a.list[id], b.list[id]
  for _, field in ipairs(FIELDS) do
    if first[field] ~= second[field] then
      return differ(name, id, field, first[field], second[field])
    end
  end
  local mine, its = first.touching, second.touching
  for _, side in ipairs(mine and its and SIDES or {}) do
    if idIn(a, mine[side]) ~= idIn(b, its[side]) then
      return differ(name, id, "touching." .. side, idIn(a, mine[side]), idIn(b, its[side]))
    end
  end
end

local function compareTold(name, a, b)
  for n = 1, math.max(#a.told, #b.told) do
    if a.told[n] ~= b.told[n] then
      local text = "%s: event %d is %s and %s"
      return "same " .. name, text:format(name, n, tostring(a.told[n]), tostring(b.told[n]))
    end
  end
end

-- The first difference between two players, if there is one.
local function compare(name, a, b, hasStepped)
  for id = 1, a.highest do
    if a.present[id] ~= b.present[id] then
      return differ(name, id, "in the world", a.present[id], b.present[id])
    elseif a.present[id] then
      local check, text = compareObject(name, a, b, id)
      if check then
        return check, text
      end
    end
  end
  local check, text = compareTold(name, a, b)
  -- A copy gets its callbacks after it was restored, and has to read some of them first.
  local isRead = name ~= "twin" or hasStepped and not (next(a.refusals) or a.isStayHeard)
  if not check and isRead and a.world:hash() ~= b.world:hash() then
    return "same " .. name, name .. ": the hashes differ"
  end
  return check, text
end

-- Trying -----------------------------------------------------------------------------------------

local function forget(list)
  for n = #list, 1, -1 do
    list[n] = nil
  end
end

local Trial = {}
Trial.__index = Trial

function Trial:update(act)
  local dt = act[2]
  self.steps = self.steps + 1
  self.watch:before()
  self.tried:act(act)
  local name, text = self.watch:after(dt)
  if name then
    return name, text
  end
  self.hasTwinStepped = self.hasTwinStepped or self.watch:hasStepped(dt)
  for _, role in ipairs({ "plain", "twin" }) do
    local other = self[role]
    if other then
      other:act(act)
      if role == "twin" then
        other.world:hash() -- which reads it, as the other two were for their hashes
      end
      name, text = compare(role, self.tried, other, self.hasTwinStepped)
      if name then
        return name, text
      end
      forget(other.told)
    end
  end
  forget(self.tried.told)
end

function Trial:act(act)
  if act[1] == "update" then
    return self:update(act)
  elseif act[1] == "twin" then
    self.twins = self.twins + 1
    self.twin = player.copy(self.tried, TWINS[self.twins % #TWINS + 1])
    self.twin.told, self.hasTwinStepped = small.copy(self.tried.told), false
    return
  end
  self.tried:act(act)
  self.plain:act(act)
  if self.twin then
    self.twin:act(act)
  end
end

--- Tries a case.
---@param case table as from spec/fuzz/case.lua
---@return table? failure `{ check, text, at }`: what does not hold, after which act; nil: all does
---@return integer steps updates that were made
function trial.run(case)
  local self = setmetatable({ steps = 0, twins = 0 }, Trial)
  self.tried, self.plain = player.new(case), player.new(case, PLAIN)
  self.watch = checks.new(self.tried, case.closed)
  for at, act in ipairs(case.acts) do
    local ok, name, text = pcall(self.act, self, act)
    if not ok then
      return { check = "error", text = tostring(name), at = at }, self.steps
    elseif name then
      return { check = name, text = text, at = at }, self.steps
    end
  end
  return nil, self.steps
end

return trial
