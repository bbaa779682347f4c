-- Keys that were held in the frames of a game, as text: "right:10-200,space:40-60,return:70".

local input = require("input")

local recording = {}

--- Reads a text, which may be empty. Returns a list of spans `{ key =, first =, last = }`, and the
--- last frame in which a key is held (0: in none). Errors: a part that is none.
function recording.read(text)
  local spans, length = {}, 0
  for part in text:gmatch("[^,%s]+") do
    local key, first, last = part:match("^(.+):(%d+)%-(%d+)$")
    if not key then
      key, first = part:match("^(.+):(%d+)$")
    end
    if not key then
      error('keys: expected "key:first-last" or "key:frame", got "' .. part .. '"')
    end
    local span = { key = key, first = tonumber(first), last = tonumber(last or first) }
    spans[#spans + 1], length = span, math.max(length, span.last)
  end
  return spans, length
end

--- Holds the keys of a frame, and calls `press(key)` for those that go down in it.
function recording.play(spans, frame, press)
  input.held = {}
  for _, span in ipairs(spans) do
    if frame >= span.first and frame <= span.last then
      input.held[span.key] = true
      if frame == span.first then
        press(span.key)
      end
    end
  end
end

return recording
