--- Finds long sentences and phrases to avoid in pages: CONTRIBUTING.md, "Words".
---
---   luajit scripts/sentences.lua README.md docs/*.md     prints FILE:LINE: what, and fails if any
---
--- A sentence ends at a full stop, a semicolon or the end of its paragraph or list item. Code,
--- tables and headings are left out; a span of code counts as one word.

local MOST = 25 -- words

-- What is not said, and what is written in its place. As patterns of Lua, in small letters.
local PHRASES = {
  { "%f[%w]told%f[%W]", "gets, or is called" },
  { "asked before", "called before" },
  { "belongs? into", "belongs in" },
  { "what it leaves", "name the thing" },
  { "%f[%w]round machine", "kinematic circle" },
  { "a machine presse?[sd]", "a kinematic object" },
}

-- "What" begins a question, also behind these words ("it says what to do"). Elsewhere it stands in
-- the place of a noun ("what is held"): name the thing ("an object that is held").
local BEFORE_A_QUESTION = " ask asks decide decides explain explains know knows out say says said "
  .. "see sees show shows tell tells "

-- Returns the first words around a "what" that is no question, or nil.
local function nounOf(sentence)
  for before, after in (" . " .. sentence:lower()):gmatch("(%S+)%s+(what%f[%W]%s*%S*)") do
    if not BEFORE_A_QUESTION:find(" " .. before:match("%a*") .. " ", 1, true) then
      return (before .. " " .. after):gsub("^%. ", "")
    end
  end
end

local function countWords(sentence)
  return select(2, (sentence .. " "):gsub("%S*%w%S*%s", ""))
end

-- Removes marks and addresses, so that words are left.
local function plain(text)
  text = text:gsub("``.-``", "code"):gsub("`[^`]*`", "code")
  text = text:gsub("!%[[^%]]*%]%b()", ""):gsub("%[([^%]]*)%]%b()", "%1")
  return (text:gsub("<[^>]*>", ""):gsub("[*_]+", ""))
end

-- Calls report(line, message) for each sentence of a paragraph that is too long, and each phrase.
local function checkParagraph(text, line, report)
  text = plain(text)
  local hasSentences = text:find("[.?!;]") -- else it is a list of names
  for sentence, mark in (text .. ". "):gmatch('(.-)([.?!;])%f[%s)"]') do
    local count, noun = countWords(sentence), mark ~= "?" and nounOf(sentence)
    if noun then
      report(line, ('"%s": name the thing, "an object that …"'):format(noun))
    end
    if count > MOST and hasSentences then
      report(line, ("%d words: %s …"):format(count, sentence:match("^%s*(.-)$"):sub(1, 60)))
    end
  end
  local small = text:lower()
  for _, phrase in ipairs(PHRASES) do
    if small:find(phrase[1]) then
      report(line, ('"%s": %s'):format(small:match(phrase[1]), phrase[2]))
    end
  end
end

local function checkPage(path, report)
  local paragraph, first, isCode, number = {}, 1, false, 0
  local function finish()
    if #paragraph > 0 then
      checkParagraph(table.concat(paragraph, " "), first, report)
      paragraph = {}
    end
  end
  for line in io.lines(path) do
    number = number + 1
    local isFence = line:find("^%s*```")
    local isBreak = isFence or isCode or line:find("^%s*$") or line:find("^[|#]")
    if isBreak or line:find("^%s*[-*] ") or line:find("^%s*%d+%. ") or line:find("^    ") then
      finish()
      first = number
    end
    if not isBreak and not line:find("^    ") then
      paragraph[#paragraph + 1] = line:match("^%s*[-*]%s+(.*)$") or line
    end
    isCode = isFence and not isCode or not isFence and isCode
  end
  finish()
end

local found = 0
for _, path in ipairs(arg) do
  checkPage(path, function(line, message)
    found = found + 1
    print(("%s:%d: %s"):format(path, line, message))
  end)
end
os.exit(found == 0 and 0 or 1)
