--- How much a game leaves to the garbage collector.

local garbage = {}

local jit = rawget(_G, "jit")

-- Makes the stack as large as it gets: it grows with the deepest call so far, which may come late,
-- and how much room there is before that depends on what runs the spec.
local function deepen(level)
  return level > 0 and 1 + deepen(level - 1) or 0
end

--- Returns the bytes that `count` calls of play(step) allocate, after `warmUp` others in which
--- arrays and the stack reach their sizes. The trace compiler allocates for itself, so it is kept
--- out.
function garbage.bytes(play, warmUp, count)
  local wasOn = jit and jit.status()
  if wasOn then
    jit.off()
    jit.flush() -- traces that are compiled already would go on running
  end
  for step = 1, warmUp do
    play(step)
  end
  collectgarbage()
  collectgarbage("stop")
  deepen(1000)
  -- The collector gives back what the deepest calls have needed: first all happens once more.
  for step = 1, count do
    play(step)
  end
  local before = collectgarbage("count")
  for step = 1, count do
    play(step)
  end
  local after = collectgarbage("count")
  collectgarbage("restart")
  if wasOn then
    jit.on()
  end
  return (after - before) * 1024
end

return garbage
