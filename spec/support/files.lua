--- Reads, writes and lists the files of the project, from its folder, and runs its commands.

local files = {}

--- Returns the text of a file.
function files.read(path)
  local file = assert(io.open(path, "rb"))
  local text = file:read("*a")
  file:close()
  return text
end

--- Writes a file.
function files.write(path, text)
  local file = assert(io.open(path, "wb"))
  file:write(text)
  file:close()
end

--- Returns what a command prints.
function files.output(command)
  local pipe = assert(io.popen(command))
  local text = pipe:read("*a")
  pipe:close()
  return text
end

--- Returns the files that a command prints, a line each, in order.
function files.list(command)
  local paths = {}
  local listing = assert(io.popen(command))
  for path in listing:lines() do
    paths[#paths + 1] = path
  end
  listing:close()
  table.sort(paths)
  return paths
end

return files
