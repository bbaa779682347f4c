--- Brings the results into bench/README.md and docs/performance.md, and draws docs/performance.svg:
---
---   luajit bench/docs.lua build/bench.json
---
--- `make bench-docs` measures and does this.

local root = arg and (arg[0] or ""):match("^(.*)bench/docs%.lua$")
if root then
  package.path = (root == "" and "." or root) .. "/?.lua;" .. package.path
end

local engines = require("bench.engines")
local files = require("spec.support.files")
local json = require("bench.json")
local report = require("bench.report")
local scenes = require("bench.scenes")

local docs = {}

local BEGIN, END = "<!-- figures: begin -->", "<!-- figures: end -->"

local NONE = "–"

local MODES = {
  jit = "With the trace compiler",
  off = "LuaJIT as an interpreter",
  ["lua5.1"] = "Lua 5.1",
}

-- The engines that have a figure, in our order.
local function enginesIn(results)
  local found, names = {}, {}
  for _, job in ipairs(results) do
    found[job.engine] = found[job.engine] or job.median ~= nil or job.isLimited
  end
  for _, name in ipairs(engines.names) do
    if found[name] then
      names[#names + 1] = name
    end
  end
  return names
end

local function select(results, isWanted)
  local list = {}
  for _, job in ipairs(results) do
    if isWanted(job) then
      list[#list + 1] = job
    end
  end
  return list
end

local function find(results, scene, n, engine)
  return select(results, function(job)
    return job.scene == scene and job.n == n and job.engine == engine
  end)[1]
end

local function line(cells)
  return "| " .. table.concat(cells, " | ") .. " |"
end

-- The row of a scene and size, or nil when no engine has a figure.
local function rowOf(results, job, names, cell)
  local cells, hasFigure = { job.scene, string.format("%d", job.n) }, false
  for _, name in ipairs(names) do
    local found = find(results, job.scene, job.n, name)
    local text = found and cell(found) or NONE
    cells[#cells + 1] = text
    hasFigure = hasFigure or text ~= NONE
  end
  return hasFigure and line(cells) or nil
end

-- A row per scene and size, a column per engine; nothing for rows without a figure.
local function matrix(results, cell)
  local names = enginesIn(results)
  local head, rule = { "scene", "n" }, { "---", "---:" }
  for _, name in ipairs(names) do
    head[#head + 1], rule[#rule + 1] = engines.title(name), "---:"
  end
  local lines, seen = { line(head), line(rule) }, {}
  for _, job in ipairs(results) do
    local key = job.scene .. " " .. job.n
    if not seen[key] then
      seen[key] = true
      lines[#lines + 1] = rowOf(results, job, names, cell)
    end
  end
  return table.concat(lines, "\n")
end

local function timeCell(results)
  return function(job)
    if job.isLimited then
      return report.limit(job, " ms")
    elseif not job.median then
      return NONE
    end
    local ratio = job.engine ~= "ours" and report.ratio(results, job)
    return report.ms(job.median) .. " ms" .. (ratio and string.format(" (%.1f×)", ratio) or "")
  end
end

local function hitchCell(job)
  if job.isLimited or not job.p99 then
    return NONE
  end
  return string.format("%s ms (%.1f×)", report.ms(job.p99), job.p99 / job.median)
end

local function worstCell(job)
  return job.worst and report.ms(job.worst) .. " ms" or NONE
end

local function overlapCell(job)
  return job.overlap and report.pixels(job.overlap) .. " px" or NONE
end

local function garbageCell(job)
  return job.garbage and report.bytes(job.garbage) or NONE
end

local function startCell(job)
  if not job.build then
    return NONE
  end
  return report.ms(job.build) .. " + " .. report.ms(job.slowest) .. " ms"
end

local function memoryCell(job)
  return job.memory and report.bytes(job.memory) .. " / " .. report.bytes(job.resident) or NONE
end

local function inMode(results, mode)
  return select(results, function(job)
    return job.mode == mode
  end)
end

-- The modes that were measured, in the order of the results.
local function modesIn(results)
  local modes, seen = {}, {}
  for _, job in ipairs(results) do
    if not seen[job.mode] then
      seen[job.mode] = true
      modes[#modes + 1] = job.mode
    end
  end
  return modes
end

local function addChapter(parts, title, text, body)
  parts[#parts + 1] = "### " .. title
  if text then
    parts[#parts + 1] = text
  end
  parts[#parts + 1] = body
end

local function describe(machine)
  return string.format(
    "%s%s%s, %s.",
    machine.love and "LÖVE " .. machine.love .. ", " or "",
    machine.lua,
    machine.processor and ", " .. machine.processor or "",
    machine.date
  )
end

--- The exponent with which our time grows with n, from the smallest to the largest size of a scene;
--- nil when there are not two figures.
---@param results table[] of one mode
---@param scene string
---@return number? exponent 1: in proportion
---@return number? from the smallest n
---@return number? to the largest n
function docs.growth(results, scene)
  local first, last
  for _, job in ipairs(results) do
    if job.scene == scene and job.engine == "ours" and job.median and not job.isLimited then
      first = (not first or job.n < first.n) and job or first
      last = (not last or job.n > last.n) and job or last
    end
  end
  if not first or first == last then
    return nil
  end
  return math.log(last.median / first.median) / math.log(last.n / first.n), first.n, last.n
end

local function growthLine(results, scene)
  local exponent, from, to = docs.growth(results, scene)
  local text = "From %d to %d boxes the time of physics.lua in `%s` grows as n^%.2f."
  return exponent and text:format(from, to, scene, exponent)
end

--- The figures as Markdown.
---@param data table what `--json` writes, decoded
---@return string
function docs.render(data)
  local parts = { describe(data.machine) }
  for _, mode in ipairs(modesIn(data.results)) do
    local results = inMode(data.results, mode)
    addChapter(
      parts,
      "Median time of a frame: " .. (MODES[mode] or mode),
      "In brackets how many times as long as physics.lua; `>`: given up, at least this on average.",
      matrix(results, timeCell(results))
    )
    parts[#parts + 1] = growthLine(results, "pile-awake")
  end
  local first = inMode(data.results, modesIn(data.results)[1])
  addChapter(
    parts,
    "99 of 100 frames are faster than",
    "In brackets: to the median.",
    matrix(first, hitchCell)
  )
  local worst = select(first, function(job)
    local definition = scenes.get(job.scene)
    return definition and definition.growth ~= nil
  end)
  if worst[1] then
    local text = "Of the worst cases, warm. A scene that was given up may have had slower ones."
    addChapter(parts, "The slowest frame", text, matrix(worst, worstCell))
  end
  addChapter(parts, "Largest overlap", nil, matrix(first, overlapCell))
  for _, mode in ipairs(modesIn(data.results)) do
    local title = "Garbage of a frame: " .. (MODES[mode] or mode)
    addChapter(parts, title, nil, matrix(inMode(data.results, mode), garbageCell))
  end
  local start = "Building a world + the slowest of the first 60 frames, which read it and compile."
  addChapter(parts, "To start", start, matrix(first, startCell))
  local rooms = select(first, function(job)
    return job.scene == "rooms"
  end)
  if rooms[1] then
    local text = "In the Lua heap / what the process grew by, which counts what C allocates, too."
    addChapter(parts, "Memory of one world of 40 objects", text, matrix(rooms, memoryCell))
  end
  return table.concat(parts, "\n\n")
end

--- Puts the figures between the two marks of a page.
---
--- Errors: a page without the marks.
---@param page string
---@param figures string
---@return string
function docs.insert(page, figures)
  local _, from = page:find(BEGIN, 1, true)
  local to = from and page:find(END, from, true)
  if not to then
    error("docs: the page needs the lines " .. BEGIN .. " and " .. END, 2)
  end
  return page:sub(1, from) .. "\n\n" .. figures .. "\n\n" .. page:sub(to)
end

-- What the page for users shows: a scene and its size each.
local SHOWN = {
  { "pile", 2000 },
  { "pile-awake", 1000 },
  { "level", 20000 },
  { "hills", 200 },
  { "gas", 2000 },
  { "balls", 1000 },
  { "swarm", 300 },
  { "swarm-ax", 300 },
  { "swarm-round", 300 },
  { "swarm-soft", 1000 },
  { "bullets", 2000 },
  { "lifts", 200 },
  { "rays", 5000 },
  { "spawn", 100 },
}
local SHOWN_ENGINES = { "ours", "love" }

local function shortCell(job)
  if not job or not job.median then
    return job and job.isLimited and report.limit(job, "") or NONE
  end
  return report.ms(job.median)
end

--- The few figures of docs/performance.md as Markdown.
---@param data table as for `render`
---@return string
function docs.summary(data)
  local results = inMode(data.results, "jit")
  local head, rule = { "scene", "n" }, { "---", "---:" }
  for _, name in ipairs(SHOWN_ENGINES) do
    head[#head + 1], rule[#rule + 1] = engines.title(name), "---:"
  end
  local lines = { line(head), line(rule) }
  for _, shown in ipairs(SHOWN) do
    local cells = { shown[1], string.format("%d", shown[2]) }
    for _, name in ipairs(SHOWN_ENGINES) do
      cells[#cells + 1] = shortCell(find(results, shown[1], shown[2], name))
    end
    lines[#lines + 1] = line(cells)
  end
  local machine = describe(data.machine) .. " Median time of a frame in ms:"
  return machine .. "\n\n" .. table.concat(lines, "\n")
end

--- How many times as fast as love.physics each shown scene is.
---@param data table
---@return table[] bars `title` and `ratio`
function docs.bars(data)
  local results, bars = inMode(data.results, "jit"), {}
  for _, shown in ipairs(SHOWN) do
    local love = find(results, shown[1], shown[2], "love")
    local ours = find(results, shown[1], shown[2], "ours")
    if love and love.median and ours and ours.median then
      bars[#bars + 1] = {
        title = shown[1] .. " " .. string.format("%d", shown[2]),
        ratio = love.median / ours.median,
      }
    end
  end
  return bars
end

-- Of the picture, px. A factor of 10 is DECADE wide; the middle is "as fast as love.physics".
local ROW, MIDDLE, DECADE, WIDTH = 34, 330, 150, 760

local function bar(ratio, y)
  local length = math.log(ratio) / math.log(10) * DECADE
  local x = MIDDLE + math.min(0, length)
  local colour = ratio >= 1 and "#38b764" or "#ef7d57"
  local text = '<rect x="%.1f" y="%d" width="%.1f" height="18" rx="2" fill="%s"/>'
  return text:format(x, y, math.max(1, math.abs(length)), colour)
end

--- The picture of these bars as SVG, readable on light and on dark ground.
---@param bars table[] from `bars`
---@return string
function docs.picture(bars)
  local height = ROW * #bars + 40
  local head = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 %d %d" '
    .. 'font-family="system-ui, sans-serif" font-size="14" fill="#7d8597">'
  local lines = { head:format(WIDTH, height) }
  for i, each in ipairs(bars) do
    local y = ROW * (i - 1) + 8
    lines[#lines + 1] = ('<text x="12" y="%d">%s</text>'):format(y + 15, each.title)
    lines[#lines + 1] = bar(each.ratio, y)
    local label = '<text x="%d" y="%d" text-anchor="end">%.1f×</text>'
    lines[#lines + 1] = label:format(WIDTH - 12, y + 15, each.ratio)
  end
  local axis = '<path d="M%d 0V%d" stroke="#7d8597"/>'
  lines[#lines + 1] = axis:format(MIDDLE, ROW * #bars + 8)
  local foot = ROW * #bars + 30
  local words = '<text x="%d" y="%d" text-anchor="%s">%s</text>'
  lines[#lines + 1] = words:format(MIDDLE - 8, foot, "end", "← slower")
  lines[#lines + 1] = words:format(MIDDLE + 8, foot, "start", "faster than love.physics →")
  for _, tick in ipairs({ 0.1, 100 }) do
    local x = MIDDLE + math.log(tick) / math.log(10) * DECADE
    local text = '<text x="%d" y="%d" text-anchor="middle">%s×</text>'
    lines[#lines + 1] = text:format(x, foot, tick)
  end
  return table.concat(lines, "\n") .. "\n</svg>\n"
end

-- Several files: their results one after the other, the machine of the first.
local function readAll(paths)
  local data = json.decode(files.read(paths[1]))
  for i = 2, #paths do
    for _, job in ipairs(json.decode(files.read(paths[i])).results) do
      data.results[#data.results + 1] = job
    end
  end
  return data
end

local function main(paths)
  local data = readAll(paths)
  local pages = {
    { "bench/README.md", docs.render },
    { "docs/performance.md", docs.summary },
  }
  for _, page in ipairs(pages) do
    files.write(page[1], docs.insert(files.read(page[1]), page[2](data)))
  end
  files.write("docs/performance.svg", docs.picture(docs.bars(data)))
end

if root then
  main(arg)
end

return docs
