--- The ways in which one scene is played: shifted, in another order, with the other broad phase,
--- the other push, at another frame rate, turned. A row runs not in all of them (up to 1440) but in
--- a selection in which every two levels of two different factors occur together (about 30).
--- Interpreters play one in which every level occurs, each of them every other variant of it.
--- `PHYSICS_SPEC=full busted` runs all of them.

local effort = require("spec.support.effort")
local turn = require("spec.support.turn")

local variants = {}

variants.SHIFTS = { 0, 0.1, 0.3, 1 / 3, -1000.1, 100000.3 }
variants.ORDERS = { "forward", "backward", "shuffled" }
variants.BROADPHASES = { "grid", "pairs" }
variants.PUSHES = { "both", "first" }
variants.RATES = { 60, 30, 144, 240, "irregular" }
variants.TURNS = { 0, 1, 2, 3 }

-- At every rate and under gravity to every side; and for the relatives of such a row, about half.
variants.EVERYWHERE = { rate = variants.RATES, turn = variants.TURNS }
variants.SOME = {
  shift = { 0, 1 / 3, 100000.3 },
  order = { "forward", "shuffled" },
  rate = { 60, 30, "irregular" },
  turn = variants.TURNS,
}

local FACTORS = { "shift", "order", "broadphase", "push", "rate", "turn" }
local DEFAULTS = {
  shift = variants.SHIFTS,
  order = variants.ORDERS,
  broadphase = variants.BROADPHASES,
  push = variants.PUSHES,
  rate = { 60 },
  turn = { 0 },
}

--- The sentence that names a variant in a failure message.
local function describe(variant)
  local rate = variant.rate == "irregular" and "irregular dt" or variant.rate .. " Hz"
  return ("shift %.6g, %s, %s, push %s, %s, gravity %s"):format(
    variant.shift,
    variant.order,
    variant.broadphase,
    variant.push,
    rate,
    turn.names[variant.turn]
  )
end

--- All combinations of the levels.
local function combine(levels)
  local list = { {} }
  for _, factor in ipairs(FACTORS) do
    local longer = {}
    for _, short in ipairs(list) do
      for _, level in ipairs(levels[factor]) do
        local variant = { [factor] = level }
        for name, value in pairs(short) do
          variant[name] = value
        end
        longer[#longer + 1] = variant
      end
    end
    list = longer
  end
  return list
end

--- The names of the pairs of levels that a variant shows; of the single levels on an interpreter.
local function pairsOf(variant)
  local list = {}
  if not effort.isWhole then
    for i, factor in ipairs(FACTORS) do
      list[i] = factor .. tostring(variant[factor])
    end
    return list
  end
  for i = 1, #FACTORS do
    for j = i + 1, #FACTORS do
      local a, b = FACTORS[i], FACTORS[j]
      list[#list + 1] = a .. tostring(variant[a]) .. b .. tostring(variant[b])
    end
  end
  return list
end

local function countNew(shown, seen)
  local count = 0
  for i = 1, #shown do
    if not seen[shown[i]] then
      count = count + 1
    end
  end
  return count
end

--- Takes, again and again, the first variant that shows the most pairs not seen yet.
local function cover(list)
  local shown, seen, chosen = {}, {}, {}
  for i, variant in ipairs(list) do
    shown[i] = pairsOf(variant)
  end
  while true do
    local best, bestCount = nil, 0
    for i = 1, #list do
      local count = countNew(shown[i], seen)
      if count > bestCount then
        best, bestCount = i, count
      end
    end
    if not best then
      return chosen
    end
    chosen[#chosen + 1] = list[best]
    for _, pair in ipairs(shown[best]) do
      seen[pair] = true
    end
  end
end

local known = {}

--- The variants in which a row is played.
---@param levels table? lists of levels by factor: `{ rate = variants.RATES, push = { "both" } }`
---@return table[] list of `{ shift=, order=, broadphase=, push=, rate=, turn=, name= }`
function variants.select(levels)
  local all, key = {}, ""
  for _, factor in ipairs(FACTORS) do
    all[factor] = levels and levels[factor] or DEFAULTS[factor]
    for _, level in ipairs(all[factor]) do
      key = key .. tostring(level) .. " "
    end
    key = key .. "/"
  end
  if not known[key] then
    local list = combine(all)
    for _, variant in ipairs(list) do
      variant.name = describe(variant)
    end
    if os.getenv("PHYSICS_SPEC") ~= "full" then
      list = cover(list)
      list = effort.rows(list, math.min(effort.isFirst and 2 or 4, #list))
    end
    known[key] = list
  end
  return known[key]
end

return variants
