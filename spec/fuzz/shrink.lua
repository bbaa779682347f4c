--- Makes a failing case small: leaves out acts, fields and settings, and takes rounder numbers, as
--- long as the same check fails.
--- Source: A. Zeller, R. Hildebrandt, "Simplifying and isolating failure-inducing input" (2002).

local copyOf = require("spec.support.small").copy
local trial = require("spec.fuzz.trial")

local floor = math.floor

local Shrinker = {}
Shrinker.__index = Shrinker

local function without(list, from, to)
  local shorter = {}
  for n = 1, #list do
    if n < from or n > to then
      shorter[#shorter + 1] = list[n]
    end
  end
  return shorter
end

-- Returns whether two failures are of one kind: the same check, and errors of the same line.
local function areAlike(one, other)
  local isError = one.check == "error" and other.check == "error"
  return one.check == other.check
    and (not isError or one.text:match("^.-:%d+") == other.text:match("^.-:%d+"))
end

-- Takes a smaller case if it fails in the same way.
function Shrinker:try(case)
  if os.clock() > self.deadline then
    return false
  end
  local failure = self.run(case)
  if not failure or not areAlike(failure, self.failure) then
    return false
  end
  self.case, self.failure = case, failure
  self.case.acts = without(case.acts, failure.at + 1, #case.acts)
  return true
end

-- Leaves out acts, many at a time at first.
function Shrinker:dropActs()
  local any, size = false, #self.case.acts
  while size >= 1 do
    local at = #self.case.acts - size + 1
    while at > 1 - size do
      local case = copyOf(self.case)
      case.acts = without(case.acts, math.max(at, 1), at + size - 1)
      any = self:try(case) or any
      at = math.min(at, #self.case.acts + 1) - size
    end
    size = size > 1 and floor(size / 2) or 0
  end
  return any
end

-- Every table of the case that holds fields, as a path of keys.
local function fieldTables(case)
  local paths = { { "settings" } }
  for n, act in ipairs(case.acts) do
    for m = 3, 4 do
      if type(act[m]) == "table" then
        paths[#paths + 1] = { "acts", n, m }
      end
    end
  end
  return paths
end

local function follow(case, path)
  local found = case
  for _, key in ipairs(path) do
    found = found and found[key]
  end
  return found
end

local function sortedKeys(list)
  local keys = {}
  for key in pairs(list) do
    keys[#keys + 1] = key
  end
  table.sort(keys, function(a, b)
    return tostring(a) < tostring(b)
  end)
  return keys
end

-- Calls visit(path, key) for each field; returns whether any call has made the case smaller.
function Shrinker:eachField(visit)
  local any = false
  for _, path in ipairs(fieldTables(self.case)) do
    for _, key in ipairs(sortedKeys(follow(self.case, path) or {})) do
      any = visit(self, path, key) or any
    end
  end
  return any
end

local NEEDED = { x = true, y = true, width = true, height = true }

function Shrinker:drop(path, key)
  local case = copyOf(self.case)
  local fields = follow(case, path)
  if fields and type(key) == "string" and not NEEDED[key] then
    fields[key] = nil
    return self:try(case)
  end
end

-- Rounder numbers than one, the roundest first.
local function rounder(value)
  local list = {}
  for _, step in ipairs({ 100, 10, 1, 0.5, 0.125 }) do
    local round = floor(value / step + 0.5) * step
    if round ~= 0 or value == 0 then
      list[#list + 1] = round
    end
  end
  return list
end

function Shrinker:round(path, key)
  local value = (follow(self.case, path) or {})[key]
  for _, round in ipairs(type(value) == "number" and rounder(value) or {}) do
    if round == value then
      return false
    end
    local case = copyOf(self.case)
    follow(case, path)[key] = round
    if self:try(case) then
      return true
    end
  end
  return false
end

-- The acts of a callback, done at once by the game instead, or fewer of them.
function Shrinker:dropReactions()
  local any = false
  for n = #self.case.acts, 1, -1 do
    local act = self.case.acts[n]
    if act and act[1] == "listen" then
      for m = #act[4], 1, -1 do
        local case = copyOf(self.case)
        table.remove(case.acts[n][4], m)
        any = self:try(case) or any
      end
    end
  end
  return any
end

local shrink = {}

--- Returns a smaller case that fails the same check, and its failure.
---@param case table one that fails
---@param failure table of it, from spec/fuzz/trial.lua
---@param seconds number how long it may try
---@param run? fun(case: table): table? what plays a case and returns its failure
function shrink.run(case, failure, seconds, run)
  local self = setmetatable({ case = copyOf(case), failure = failure }, Shrinker)
  self.run = run or trial.run
  self.deadline = os.clock() + seconds
  self.case.acts = without(self.case.acts, failure.at + 1, #self.case.acts)
  local again = true
  while again and os.clock() < self.deadline do
    again = self:dropActs()
    again = self:dropReactions() or again
    again = self:eachField(self.drop) or again
    again = self:eachField(self.round) or again
  end
  return self.case, self.failure
end

return shrink
