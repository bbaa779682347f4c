--- What publishing needs. The address of the project stands in one place, `source.url` of the
--- rockspec. The site, the rockspec of a release and the links to download take it from here, and
--- are left out while it is empty.
---
---   luajit scripts/publish.lua address        prints https://github.com/OWNER/NAME, or nothing
---   luajit scripts/publish.lua rockspec 1.2.0 [FILE]
---                                             prints the rockspec of that release
---   luajit scripts/publish.lua                says what is left to do before publishing

package.path = "./?.lua;" .. package.path

local files = require("spec.support.files")

local publish = {}

local ROCKSPEC = "rockspec/physics-scm-1.rockspec"

--- Returns the address of the repository, or nil while the rockspec has none.
---@param rockspec string? text of the rockspec; default: that of the project
---@return string?
function publish.address(rockspec)
  local url = (rockspec or files.read(ROCKSPEC)):match('\n  url = "([^"]*)"')
  return url:match("^git%+(https://[^/]+/[^/]+/[^/]+)$")
end

--- Returns the address of the site: pages of GitHub, or nil.
---@param address string? of the repository
---@return string?
function publish.siteOf(address)
  local owner, name = (address or ""):match("^https://github%.com/([^/]+)/([^/]+)$")
  return owner and ("https://%s.github.io/%s/"):format(owner:lower(), name)
end

--- Returns the rockspec of a release: that of the main branch, with a version, a tag, and the pages
--- that follow from the address. Errors: the rockspec has no address.
---@param version string
---@param rockspec string? text of the rockspec; default: that of the project
---@return string
function publish.rockspec(version, rockspec)
  local text = rockspec or files.read(ROCKSPEC)
  local address = assert(publish.address(text), ROCKSPEC .. ": source.url is empty")
  local pages = ('  homepage = "%s",\n  issues_url = "%s/issues",\n'):format(address, address)
  text = text:gsub("%-%- The address.-\n(source = )", "%1")
  text = text:gsub('version = "scm%-1"', ('version = "%s-1"'):format(version))
  text = text:gsub('branch = "main"', ('tag = "v%s"'):format(version))
  return (text:gsub("(\n  license = )", "\n" .. pages:gsub("\n$", "") .. "%1"))
end

--- Returns what is left to do before version `version` can be published, a sentence each.
---@param state table texts: `rockspec`, `version`, `changelog`, `readme`, `tags` of the last commit
---@return string[]
function publish.left(state)
  local left = {}
  local function need(isDone, text)
    if not isDone then
      left[#left + 1] = text
    end
  end
  local address = publish.address(state.rockspec)
  local site = publish.siteOf(address)
  need(address, ROCKSPEC .. ": set source.url to git+https://github.com/OWNER/NAME")
  for _, link in ipairs(address and { "/releases/latest/download/physics.lua", "/issues" } or {}) do
    need(state.readme:find(address .. link, 1, true), "README.md: link " .. address .. link)
  end
  if address then
    need(site and state.readme:find(site, 1, true), "README.md: link the site, " .. tostring(site))
  end
  local release = state.version:match("^%d+%.%d+%.%d+$")
  need(release, "physics.lua: _VERSION is " .. state.version .. ", not that of a release")
  local first = state.changelog:match("\n## ([^\n]+)")
  local dated = "^" .. (release or ""):gsub("%.", "%%.") .. " %- %d%d%d%d%-%d%d%-%d%d$"
  local isDated = release and first:find(dated)
  need(isDated, "CHANGELOG.md: begin with the version and its date, not with " .. first)
  local tag = "v" .. (release or "X.Y.Z")
  local isTagged = release and ("\n" .. state.tags):find("\n" .. tag .. "\n", 1, true)
  need(isTagged, "git: the last commit needs the tag " .. tag)
  return left
end

local function main(command, version, file)
  if command == "address" then
    print(publish.address() or "")
  elseif command == "rockspec" then
    io.write(publish.rockspec(assert(version, "which version?"), files.read(file or ROCKSPEC)))
  else
    local left = publish.left({
      rockspec = files.read(ROCKSPEC),
      version = files.read("physics.lua"):match('_VERSION = "([^"]+)"'),
      changelog = files.read("CHANGELOG.md"),
      readme = files.read("README.md"),
      tags = files.output("git tag --points-at HEAD 2>/dev/null"),
    })
    for _, text in ipairs(left) do
      print("to do   " .. text)
    end
    print(
      "by hand is the name of the rock, physics, free or yours? May flaws be reported privately?"
    )
    print(#left .. " to do")
    os.exit(#left == 0 and 0 or 1)
  end
end

if arg and arg[0] and arg[0]:find("scripts/publish.lua", 1, true) then
  main(arg[1], arg[2], arg[3])
end

return publish
