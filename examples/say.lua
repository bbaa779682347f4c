-- Says on the standard output what goes on, for tests that see nothing but that: a program that
-- steers a browser, for one. What the lines look like is written down in main.lua.

local say = { isOn = false }

local name, time, second ---@type string?, number, number

-- A line that is kept back until a buffer is full comes too late for the program that waits for it.
local function line(text)
  io.stdout:write(text, "\n")
  io.stdout:flush()
end

--- To be called when a screen has started.
function say.start(screenName)
  name, time, second = screenName, 0, 0
  if say.isOn then
    line(("example %s started"):format(name))
  end
end

--- To be called in every frame. `report()` returns the line that says how far the screen got.
function say.update(dt, report)
  time = time + dt
  if say.isOn and time >= second + 1 then
    second = math.floor(time)
    local values = report():match("^%a+: (.*)$")
    line(("example %s second %d: %s"):format(name, second, values))
  end
end

return say
