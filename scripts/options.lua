--- Reads the options of a script, "--seed 3 --keep-going".

--- Fills a table of defaults from arguments. A boolean needs no value, a number must be one.
---@param options table<string, any>
---@param list string[]
return function(options, list)
  local n = 1
  while list[n] do
    local name = list[n]:match("^%-%-(.+)$")
    local kind, value = type(options[name]), list[n + 1]
    if kind == "nil" then
      error("unknown option " .. list[n], 0)
    elseif kind == "boolean" then
      options[name] = true
    else
      options[name] = kind == "number" and tonumber(value) or kind ~= "number" and value
      if not options[name] then
        error(("a %s must follow %s"):format(kind, list[n]), 0)
      end
      n = n + 1
    end
    n = n + 1
  end
end
