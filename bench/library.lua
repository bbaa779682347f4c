--- Takes the library from another folder, for comparisons.

local function isThere(file)
  local handle = io.open(file)
  return handle and handle:close()
end

--- Makes `require` look in this folder for the modules of the library, and only for them.
---
--- Errors: there is no physics.lua; later, a module that is not there.
---@param root string
return function(root)
  if not (isThere(root .. "/physics.lua") or isThere(root .. "/physics/init.lua")) then
    error(("--root %s: there is no physics.lua"):format(root), 0)
  end
  local function search(name)
    local path = (name == "physics" or name:find("^physics%.")) and name:gsub("%.", "/")
    for _, form in ipairs(path and { "/%s.lua", "/%s/init.lua" } or {}) do
      local file = root .. form:format(path)
      local chunk, problem = loadfile(file)
      if chunk then
        return chunk
      elseif not problem:find("cannot open", 1, true) then
        error(problem, 0)
      end
    end
    if path then
      error(("--root %s: there is no module %s"):format(root, name), 0)
    end
  end
  table.insert(rawget(package, "searchers") or package.loaders, 2, search)
end
