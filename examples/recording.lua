-- Keys that were held in the frames of a game, and clicks of the mouse, as text:
-- "right:10-200,space:40-60,return:70,click@480x300:90".

local input = require("input")

local recording = {}

--- Reads a text, which may be empty. Returns a list of spans `{ key =, first =, last = }`, and the
--- last frame in which a key is held (0: in none). Errors: a part that is none.
function recording.read(text)
  local spans, length = {}, 0 ---@type table, number
  for part in text:gmatch("[^,%s]+") do
    local key, first, last = part:match("^(.+):(%d+)%-(%d+)$")
    if not key then
      key, first = part:match("^(.+):(%d+)$")
    end
    if not key then
      error('keys: expected "key:first-last" or "key:frame", got "' .. part .. '"')
    end
    ---@type table
    local span = { key = key, first = tonumber(first), last = tonumber(last or first) }
    spans[#spans + 1], length = span, math.max(length, span.last)
  end
  return spans, length
end

--- Holds the keys of a frame, and calls `press(key)` for those that go down in it, and
--- `click(x, y, 1)`, as love.mousepressed is called, for clicks.
function recording.play(spans, frame, press, click)
  input.held = {}
  for _, span in ipairs(spans) do
    if frame >= span.first and frame <= span.last then
      input.held[span.key] = true
      local x, y = span.key:match("^click@(%d+)x(%d+)$")
      if frame == span.first and x then
        click(tonumber(x), tonumber(y), 1)
      elseif frame == span.first then
        press(span.key)
      end
    end
  end
end

return recording
