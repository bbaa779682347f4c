--- Columns that grow together: tables, or typed arrays in a program that has everything compiled.
--
-- A table grows by itself and takes any value, so compiled code checks each value that it reads: is
-- it there, and of which type? A typed array (`double[]` or `bool[]` of LuaJIT's FFI) needs no such
-- check, which saves a fifth to a third of a step. But interpreted code takes ten times as long
-- with it. So typed arrays come with `physics.compile()`, for worlds that are made after it.
--
-- A typed array has a fixed length, and nothing stops a write behind its end. Code that needs more
-- room must call `grow` first. After that the columns are different objects, so no local may hold
-- one across that call.

local columnStore = {}

local HUGE = math.huge
local KINDS = { "number", "integer", "boolean" }

-- Where typed arrays come from; false: columns are tables.
local source = false ---@type any

--- Sets where the columns of stores made from now on come from; false: they are tables. Returns
--- what was set before. A source has three functions:
--- - `source.give(kind, lengths)` returns a list of columns of these lengths, all 0 or false, and a
---   block. The block must be kept while the columns are used, until `source.drop` gets it.
--- - `source.room(old, last)` returns how much room to make for the indexes up to `last`, where
---   there was `old`.
function columnStore.use(given)
  local before = source
  source = given
  return before
end

-- Replaces the owner's columns of one kind by columns of the source. Copies the first `count`
-- indexes.
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

--- Gives `owner` the columns of `layout`, a list of `{ kind, width, names }`. A column has `width`
--- places for each index from 0 to `room`. Kinds: "number", "integer" (whole numbers of 32 bits),
--- "boolean", "any" (always a table). Errors: the owner already has a field of one of these names.
function columnStore.new(owner, layout)
  local self = { owner = owner, layout = layout, room = HUGE, source = false, kept = {} }
  for n = 1, #layout do
    for _, name in ipairs(layout[n].names) do
      if owner[name] ~= nil then
        error("the owner has another " .. name, 2)
      end
      owner[name] = {}
    end
  end
  columnStore.adopt(self, -1)
  return self
end

--- Changes to the current source if the columns were tables until now. `last` is the highest index
--- in use.
function columnStore.adopt(self, last)
  if source and not self.source then
    self.source = source
    replaceAll(self, source.room(0, last), last + 1)
  end
end

--- Makes room for the indexes up to `last`.
function columnStore.grow(self, last)
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

--- Gives back the memory behind the index `last`. As after `grow`, the columns are different
--- objects.
function columnStore.shrink(self, last)
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

return columnStore
