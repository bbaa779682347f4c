--- Sorts a list of indexes by the values of columns, in place and without garbage. (`table.sort`
--- leaves a compiled trace, needs a closure, and leaves the order of equal items open.)

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
require(root .. ".memory.jit").file()

local sort = {}

local FEW = 8

-- Returns whether x comes before y: the smaller value first, column by column.
local function before(x, y, first, second, third, fourth)
  if first[x] ~= first[y] then
    return first[x] < first[y]
  end
  if second[x] ~= second[y] then
    return second[x] < second[y]
  end
  if third[x] ~= third[y] then
    return third[x] < third[y]
  end
  return fourth ~= nil and fourth[x] < fourth[y]
end

local function sink(list, node, count, first, second, third, fourth)
  local value = list[node]
  local child = 2 * node
  while child <= count do
    if child < count and before(list[child], list[child + 1], first, second, third, fourth) then
      child = child + 1
    end
    if not before(value, list[child], first, second, third, fourth) then
      break
    end
    list[node] = list[child]
    node, child = child, 2 * child
  end
  list[node] = value
end

local function insert(list, count, first, second, third, fourth)
  for n = 2, count do
    local value, at = list[n], n
    while at > 1 and before(value, list[at - 1], first, second, third, fourth) do
      list[at] = list[at - 1]
      at = at - 1
    end
    list[at] = value
  end
end

--- Sorts `list[1..count]` by `first[x]`, then `second[x]`, `third[x]` and, if given, `fourth[x]`,
--- ascending. Short lists are sorted by insertion, longer ones by heapsort (J. W. J. Williams,
--- 1964). No two items should be equal in all of them.
function sort.by(list, count, first, second, third, fourth)
  if count <= FEW then
    insert(list, count, first, second, third, fourth)
    return
  end
  for node = (count - count % 2) / 2, 1, -1 do
    sink(list, node, count, first, second, third, fourth)
  end
  for last = count, 2, -1 do
    list[1], list[last] = list[last], list[1]
    sink(list, 1, last - 1, first, second, third, fourth)
  end
end

return sort
