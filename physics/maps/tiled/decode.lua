--- Layers of tiles that Tiled has packed: base64, plain or compressed.

local root = (...):match("^(.*)%.maps%.")
local check = require(root .. ".world.check")

local floor = math.floor

local decode = {}

local ALPHABET = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"
local CSV = "choose CSV as Tile Layer Format in the map's properties"

local valueOf = {}
for i = 1, #ALPHABET do
  valueOf[ALPHABET:byte(i)] = i - 1
end

-- The bytes that four characters stand for. "=" is no character of the alphabet.
local function fromFour(text, at)
  local a, b, c, d = text:byte(at, at + 3)
  a, b, c, d = valueOf[a], valueOf[b], valueOf[c], valueOf[d]
  if not (a and b) then
    return nil
  end
  local number = a * 262144 + b * 4096 + (c or 0) * 64 + (d or 0)
  local high, middle = floor(number / 65536), floor(number / 256) % 256
  local low = floor(number % 256)
  if d then
    return string.char(high, middle, low)
  end
  return c and string.char(high, middle) or string.char(high)
end

--- Returns the bytes that a text in base64 stands for.
---@param text string
---@return string? bytes nil: it is no base64
function decode.base64(text)
  text = text:gsub("%s+", "")
  if #text % 4 ~= 0 or text:find("[^%w+/=]") or text:find("=[^=]") or text:find("===") then
    return nil
  end
  local parts = {}
  for at = 1, #text, 4 do
    local bytes = fromFour(text, at)
    if not bytes then
      return nil
    end
    parts[#parts + 1] = bytes
  end
  return table.concat(parts)
end

-- Compression -------------------------------------------------------------------------------------

-- The game's own `require`: in the library as one file that name means something else.
local function findLibrary(name)
  local ask = rawget(_G, "require")
  local isThere, library = pcall(ask, name)
  return isThere and type(library) == "table" and library or nil
end

-- Where the compressed data begins behind the head of a gzip file (RFC 1952), nil: it has none.
local function behindHead(data)
  local id1, id2, method, flags = data:byte(1, 4)
  if id1 ~= 31 or id2 ~= 139 or method ~= 8 then
    return nil
  end
  local at = 11
  if flags % 8 >= 4 then
    local low, high = data:byte(at, at + 1)
    at = floor(at + 2 + (low or 0) + 256 * (high or 0))
  end
  for _, bit in ipairs({ 8, 16 }) do -- a name, a comment
    if flags % (2 * bit) >= bit then
      at = (data:find("\0", at, true) or #data) + 1
    end
  end
  return at + (flags % 4 >= 2 and 2 or 0)
end

local function byLibDeflate(library, data, compression)
  if compression == "zlib" then
    return (library:DecompressZlib(data))
  end
  local first = behindHead(data)
  return first and (library:DecompressDeflate(data:sub(first)))
end

local function byLove(data, compression)
  local isDone, bytes = pcall(love.data.decompress, "string", compression, data)
  return isDone and bytes or nil
end

local function hasLove()
  return type(love) == "table" and type(love.data) == "table"
end

-- The unpacked bytes; nil if they are damaged; nil and a reason if nothing here can unpack them.
local function decompress(reading, data, compression)
  if reading.decompress then
    return (reading.decompress(data, compression))
  elseif compression ~= "zlib" and compression ~= "gzip" then
    local bytes = hasLove() and byLove(data, compression)
    return bytes or nil, not bytes and "nothing here can unpack it" or nil
  elseif hasLove() then
    return byLove(data, compression)
  end
  local library = findLibrary("LibDeflate")
  if library then
    return byLibDeflate(library, data, compression)
  end
  return nil, "neither LÖVE nor LibDeflate is here to unpack it"
end

-- Gids ------------------------------------------------------------------------------------------

local function toGids(bytes)
  local gids = {}
  for at = 1, #bytes - 3, 4 do
    local a, b, c, d = bytes:byte(at, at + 3)
    gids[#gids + 1] = a + b * 256 + c * 65536 + d * 16777216
  end
  return gids
end

local function fail(place, text)
  check.fail(place .. ": data " .. text)
end

--- Returns the gids of a layer, or of a part of an infinite one.
--- Errors: damaged data, data of another length.
---@param reading table
---@param layer table says how it is packed
---@param grid table the layer or the part: data, width, height
---@param place string how an error names it
---@return number[]? gids nil: it cannot be unpacked here
---@return string? reason why not
function decode.gids(reading, layer, grid, place)
  local encoding, compression = layer.encoding or "text", layer.compression
  for _, name in ipairs({ "encoding", "compression" }) do
    if layer[name] ~= nil and type(layer[name]) ~= "string" then
      check.fail(("%s: %s must be a string, got %s"):format(place, name, check.show(layer[name])))
    end
  end
  local packing = compression and compression .. ", " .. encoding or encoding
  local shown = ("encoded data (%s)"):format(packing)
  if encoding ~= "base64" then
    return nil, shown .. ": " .. CSV
  end
  local bytes = decode.base64(grid.data)
  if not bytes then
    fail(place, "must be base64, got " .. check.show(grid.data))
  end
  if compression and compression ~= "" then
    local reason
    bytes, reason = decompress(reading, bytes, compression)
    if reason then
      return nil, ("%s: %s; %s"):format(shown, reason, CSV)
    elseif type(bytes) ~= "string" then
      fail(place, ("cannot be unpacked (%s): it is damaged"):format(compression))
    end
  end
  local expected = grid.width * grid.height
  if #bytes ~= 4 * expected then
    local text = "must hold %d gids (%d x %d), got %.14g"
    fail(place, text:format(expected, grid.width, grid.height, #bytes / 4))
  end
  return toGids(bytes)
end

return decode
