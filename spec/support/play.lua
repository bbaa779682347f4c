--- Rows of scenario specs as data: what is there, and what is played and expected, line by line.
---
---     play.row("vx leads on at {vx} px/s", EVERYWHERE, { floor(), body() }, {
---       "listen body",                                  -- once: "body heard" counts from here on
---       "body.vx = vx",                                 -- once: Lua, on the views of the objects
---       { 2, "body at 200 + vx * t, 76", "body on floor" }, -- 2 s: both after every step
---       { 1, keep = "body.vx = 0", "body.vx == 0" },    -- 1 s: `keep` before every step
---       0.5,                                            -- half a second
---       { steps = 1, "body still" },                    -- one step
---       { "body.vx = 9", 0.5, "body.vx == 9" },         -- in order: what, how long, and then
---       "body heard 0, 0",                              -- begins and ends
---     }, { "vx", { 60 }, { -60 } })                     -- one row for each, with these names
---
--- `{ time = "2 / speed", … }` is so long. In a line stand the views by their names, the values of
--- the row (a text as it is, where it says `{name}`), what a line has set, `t` (seconds of this
--- part), `dt`, `n` (steps of this part), `world`, `run`, `heard` (by name), and what `math` has.
--- A line outside of a part with a time may hold some, with `; ` between them, or a function.
--- Lines with an expectation: `it at x, y [, tolerance]`, `it.x ~ number [, tolerance]`,
--- `it.x == value` (or <, >, <=, >=, ~=), `it on other`, `it still`, `it touches bottom right` (no
--- other side), `it rides other, offset` (at rest, so far to its right), `it heard begins, ends`.

local scene = require("spec.support.scene")

local play = {}

-- One variant, in the numbers of the scene.
play.ONCE = {
  shift = { 0 },
  order = { "forward" },
  broadphase = { "grid" },
  push = { "both" },
  rate = { 60 },
  turn = { 0 },
}

local setEnvironment, loadText = rawget(_G, "setfenv"), rawget(_G, "loadstring") or load

-- A function from Lua text, with the names of `env`.
local function compile(text, env)
  local f, message
  text = text:gsub("{(%w+)}", env.texts)
  if setEnvironment then
    f, message = loadText(text, text)
    f = f and setEnvironment(f, env)
  else
    f, message = loadText(text, text, "t", env)
  end
  return f or error(message)
end

local function split(text)
  local words = {}
  for word in (text or ""):gmatch("[^%s,]+") do
    words[#words + 1] = word
  end
  return words
end

-- What a line may say of a view: `it WORD rest`.
local CHECKS = {
  at = function(run, view, _, x, y, tolerance)
    run:at(view, x, y, tolerance)
  end,
  on = function(run, view, _, other)
    run:standsOn(view, other)
  end,
  still = function(run, view)
    run:still(view)
  end,
  rides = function(run, view, _, other, offset)
    run:near("offset", view.x - other.x, offset)
    run:standsOn(view, other)
    run:still(view)
  end,
  touches = function(run, view, rest)
    run:touches(view, (rawget(_G, "unpack") or rawget(table, "unpack"))(split(rest)))
  end,
  heard = function(run, view, _, begins, ends)
    local log = run.heard[view.name]
    run:same(view.name .. ": begins", log.begins, begins)
    run:same(view.name .. ": ends", log.ends, ends or 0)
  end,
}

-- The function of a line `left OPERATOR right`, or nil.
local function comparison(line, env)
  local left, sign, right = line:match("^(%b()[^~=<>]*) ([~=<>]=?) (.+)$")
  if not left then
    left, sign, right = line:match("^(.-) ([~=<>]=?) (.+)$")
  end
  if not left or sign == "=" then
    return nil
  end
  local isNear = sign == "~" or sign == "=="
  local third = isNear and "" or (", (%s) %s (%s)"):format(left, sign, right)
  local values = compile(("return %s, %s"):format(left, right) .. third, env)
  return function(run)
    local a, b, more = values()
    if sign == "~" then
      run:near(left, a, b, more)
    elseif sign == "==" then
      run:same(left, a, b)
    else
      local text = "%s is %s, not %s %s"
      run:check(more, text, left, tostring(a), sign, tostring(b))
    end
  end
end

local function expectation(line, env)
  line = line:gsub("{(%w+)}", env.texts)
  local name, word, rest = line:match("^(%S+) (%a+) ?(.*)$")
  if name and CHECKS[word] then
    local values = compile(word == "touches" and "" or "return " .. rest, env)
    return function(run)
      CHECKS[word](run, env[name], rest, values())
    end
  end
  return comparison(line, env)
end

-- What is played once.
local function statement(line, env)
  local name = line:match("^listen (%S+)$")
  if name then
    return function(run)
      run.heard[name] = run:listen(env[name])
    end
  end
  return not line:find("^function ") and expectation(line, env) or compile(line, env)
end

local function checkAll(run, checks)
  for i = 1, #checks do
    checks[i](run)
  end
end

local function noStep() end

-- A part with a time: its expectations after every step.
local function lasting(part, env)
  local checks, keep, steps = {}, part.keep and compile(part.keep, env), part.steps
  local isTimed = type(part[1]) == "number"
  local seconds = (isTimed or part.time) and compile("return " .. (part.time or part[1]), env)
  for i = isTimed and 2 or 1, #part do
    checks[#checks + 1] = expectation(part[i], env) or error(part[i])
  end
  local function before(time, dt)
    env.t, env.dt, env.n = time, dt, env.n + 1
    return keep and keep()
  end
  return function(run)
    env.t, env.n = 0, 0
    for _ = 1, steps or 0 do
      local dt = run.rate == "irregular" and 1 / 60 or 1 / run.rate
      before(env.t + dt, dt)
      run:step(dt)
      checkAll(run, checks)
    end
    for time, dt in seconds and run:steps(seconds(), before) or noStep do
      env.t, env.dt = time, dt
      checkAll(run, checks)
    end
  end
end

local part

-- Parts in their order.
local function sequence(given, env)
  local list = {}
  for i = 1, #given do
    list[i] = part(given[i], env)
  end
  return function(run)
    checkAll(run, list)
  end
end

-- A line: what stands in it, one after the other.
local function lineOf(text, env)
  local list, filled = {}, text:gsub("{(%w+)}", env.texts) .. "; "
  for one in filled:gmatch("(.-); ") do
    list[#list + 1] = statement(one, env)
  end
  return function(run)
    checkAll(run, list)
  end
end

function part(given, env)
  if type(given) == "string" then
    return lineOf(given, env)
  elseif type(given) == "function" then
    return function(run)
      given(run, env)
    end
  elseif type(given) == "number" then
    return lasting({ given }, env)
  elseif type(given[1]) == "string" and not given.time and not given.steps then
    return sequence(given, env)
  end
  return lasting(given, env)
end

local function newEnvironment(values)
  local env = { views = {}, texts = {} }
  for name, value in pairs(values) do
    env.texts[name] = type(value) == "string" and value or nil
  end
  return setmetatable(env, {
    __index = function(_, name)
      if env.views[name] == nil and values[name] ~= nil then
        return values[name]
      end
      return env.views[name] or math[name] or _G[name]
    end,
  })
end

-- Plays the parts in one variant.
local function playOne(run, env, entries, playParts, values)
  env.views = run:build(type(entries) == "function" and entries(values, run) or entries)
  env.world, env.run, run.heard = run.world, run, {}
  env.heard = run.heard
  playParts(run)
end

local function valuesOf(names, row, shared)
  local values = setmetatable({}, { __index = shared })
  for i, name in ipairs(names) do
    values[name] = row[i]
  end
  return values
end

local function titleOf(title, values)
  return (
    title:gsub("{(%w+)}", function(name)
      local value = values[name]
      return type(value) == "number" and ("%.6g"):format(value) or tostring(value)
    end)
  )
end

--- Defines a row, or one for each of `rows`.
---@param title string `{name}` is a value of the row
---@param levels table? see variants.select
---@param entries table|fun(values: table, run: table): table the scene
---@param given table what is played, see above; a function gets the run and all names
---@param rows table[]? first the names of the values as one text, then a list of values each
---@param shared table? other names that the lines know
function play.row(title, levels, entries, given, rows, shared)
  local names = split(rows and rows[1])
  for i = rows and 2 or 1, rows and #rows or 1 do
    local values = valuesOf(names, rows and rows[i] or {}, shared)
    local env = newEnvironment(values)
    local parts = sequence(given, env)
    scene.it(titleOf(title, values), values.levels or levels, function(run)
      playOne(run, env, entries, parts, values)
    end)
  end
end

--- The same for rows with lines that know some other names, too.
function play.with(shared)
  return function(title, levels, entries, given, rows)
    play.row(title, levels, entries, given, rows, shared)
  end
end

--- The same for rows that are played in one variant.
function play.once(shared)
  return function(title, entries, given, rows)
    play.row(title, play.ONCE, entries, given, rows, shared)
  end
end

return play
