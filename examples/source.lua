-- What the sources say about themselves.

local source = {}

--- Returns the first paragraph of the comment at the head of an example's file, without its dashes
--- and line breaks.
function source.comment(name)
  local words = {}
  for line in love.filesystem.lines(name .. ".lua") do
    local text = line:match("^%-%-%s+(.*)$")
    if not text then
      break
    end
    words[#words + 1] = text
  end
  return table.concat(words, " ")
end

return source
