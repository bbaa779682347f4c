--- The few numbers that a list of times comes down to.

local statistics = {}

local function sorted(values)
  local copy = {}
  for i = 1, #values do
    copy[i] = values[i]
  end
  table.sort(copy)
  return copy
end

--- The value that `share` of all values do not exceed.
--- Source: nearest rank, so the result is always one of the values.
---@param values number[] not empty
---@param share number 0..1
---@return number
function statistics.quantile(values, share)
  local rank = math.ceil(share * #values)
  return sorted(values)[math.max(rank, 1)]
end

--- The value in the middle; of an even number the mean of the two in the middle.
---@param values number[] not empty
---@return number
function statistics.median(values)
  local list = sorted(values)
  local half = math.floor(#list / 2)
  if #list % 2 == 1 then
    return list[half + 1]
  end
  return (list[half] + list[half + 1]) / 2
end

---@param values number[] not empty
---@return number
function statistics.mean(values)
  local sum = 0
  for i = 1, #values do
    sum = sum + values[i]
  end
  return sum / #values
end

return statistics
