--- How much a game leaves to the garbage collector.

local garbage = {}

local jit = rawget(_G, "jit")

-- Makes the stack as large as it gets: it grows with the deepest call so far, which may come late,
-- and how much room there is before that depends on what runs the spec.
local function deepen(level)
  return level > 0 and 1 + deepen(level - 1) or 0
end

-- The trace compiler allocates for itself, so it is kept out. Returns what undoes that.
local function keepCompilerOut()
  if not (jit and jit.status()) then
    return function() end
  end
  jit.off()
  jit.flush() -- traces that are compiled already would go on running
  return jit.on
end

--- Returns the bytes that `count` calls of play(step) leave in use, after `warmUp` others.
function garbage.kept(play, warmUp, count)
  local letCompilerIn = keepCompilerOut()
  local before
  for step = 1, warmUp + count do
    play(step)
    if step == warmUp then
      collectgarbage()
      collectgarbage()
      before = collectgarbage("count")
    end
  end
  collectgarbage()
  collectgarbage()
  local after = collectgarbage("count")
  letCompilerIn()
  return (after - before) * 1024
end

--- Returns the bytes that `count` calls of play(step) allocate, after `warmUp` others in which
--- arrays and the stack reach their sizes.
function garbage.bytes(play, warmUp, count)
  local letCompilerIn = keepCompilerOut()
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
  letCompilerIn()
  return (after - before) * 1024
end

return garbage
