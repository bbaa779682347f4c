--- How many hundreds of instructions of the interpreter a function takes.
---@param f fun()
---@return integer
return function(f)
  local jit, count = rawget(_G, "jit"), 0
  if jit then
    jit.off()
    jit.flush()
  end
  debug.sethook(function()
    count = count + 1
  end, "", 100)
  f()
  debug.sethook()
  if jit then
    jit.on()
  end
  return count
end
