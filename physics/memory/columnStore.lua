--- Columns that grow together: tables, or typed arrays in a program that has everything compiled.
--
-- A table grows by itself and takes whatever is written to it, so compiled code looks at each value
-- whether it is there, and of which kind it is. A typed array (`double[]` or `bool[]` of LuaJIT's
-- FFI) needs no such look; that is a fifth to a third of a step. But interpreted code takes ten
-- times as long with it, so typed arrays come with `physics.compile()`, for worlds that are made
-- after it.
--
-- A typed array holds as much as it was made for, and nobody stops who writes behind its end.
-- Whoever needs more says so before (`grow`). The columns are others afterwards: nobody may hold
-- one in a local meanwhile.

local bank = {}

local HUGE = math.huge
local KINDS = { "number", "integer", "boolean" }

-- Where typed arrays come from; false: columns are tables.
local source = false ---@type any

--- Lets banks that are made from now on have their columns from a source; false: they are tables.
--- `source.give(kind, lengths)` returns a list of columns of these lengths, all 0 or false, and
--- what must be kept as long as they are used, until `source.drop` gets it;
--- `source.room(old, last)` says how much room to make for the indexes up to `last`, where there
--- was `old`.
--- Returns what was used before.
function bank.use(given)
  local before = source
  source = given
  return before
end

-- Gives the owner columns of one kind from the source, with what the old ones have in their first
-- `count` indexes.
local function replace(self, kind, room, count)
  local owner, names, widths, lengths = self.owner, {}, {}, {}
  for n = 1, #self.layout do
    local part = self.layout[n]
    for m = 1, part.kind == kind and #part.names or 0 do
      local at = #names + 1
      names[at], widths[at], lengths[at] = part.names[m], part.width, part.width * (room + 1)
    end
  end
  local given, block = self.source.give(kind, lengths)
  for n = 1, #names do
    local old, new = owner[names[n]], given[n]
    for k = 0, widths[n] * count - 1 do
      if old[k] ~= nil then -- a table may have gaps
        new[k] = old[k]
      end
    end
    owner[names[n]] = new
  end
  if self.kept[kind] then
    self.source.drop(self.kept[kind])
  end
  self.kept[kind] = block
end

local function replaceAll(self, room, count)
  for n = 1, #KINDS do
    replace(self, KINDS[n], room, count)
  end
  self.room = room
end

--- Gives `owner` the columns of `layout`, a list of `{ kind, width, names }`: of numbers, of whole
--- numbers that 32 bits hold ("integer"), of booleans, or "any" (always a table), with `width`
--- places for each index from 0 to `room`. An error if it has something else by one of these names.
function bank.new(owner, layout)
  local self = { owner = owner, layout = layout, room = HUGE, source = false, kept = {} }
  for n = 1, #layout do
    for _, name in ipairs(layout[n].names) do
      if owner[name] ~= nil then
        error("the owner has another " .. name, 2)
      end
      owner[name] = {}
    end
  end
  bank.adopt(self, -1)
  return self
end

--- Changes to the source that is used now, if that was a table until now; `last` is the highest
--- index in use.
function bank.adopt(self, last)
  if source and not self.source then
    self.source = source
    replaceAll(self, source.room(0, last), last + 1)
  end
end

--- Makes room for the indexes up to `last`.
function bank.grow(self, last)
  replaceAll(self, self.source.room(self.room, last), self.room + 1)
end

-- Returns the first `length` places of a table, from 0 on.
local function head(column, length)
  local new = {}
  for k = 0, length - 1 do
    new[k] = column[k]
  end
  return new
end

--- Gives back what is behind the index `last`.
function bank.shrink(self, last)
  if self.source then
    replaceAll(self, self.source.room(0, last), last + 1)
  end
  for n = 1, #self.layout do
    local part = self.layout[n]
    for m = 1, (part.kind == "any" or not self.source) and #part.names or 0 do
      self.owner[part.names[m]] = head(self.owner[part.names[m]], part.width * (last + 1))
    end
  end
end

return bank
