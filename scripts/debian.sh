# Sourced by the scripts that use programs of Debian 13: nothing of them goes into the system.

# fetch_debian FOLDER ARCHITECTURE COMMAND...: runs apt with a COMMAND that leaves packages in FOLDER,
# and unpacks these into FOLDER/root.
fetch_debian() {
  local apt=$1/apt site package
  # shellcheck disable=SC2016 # it is apt that reads $(SITE)
  site=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' | grep -v security | head -n 1)
  rm -rf "$1" && mkdir -p "$1/root" "$apt/state/lists/partial" "$apt/cache/archives/partial"
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $site trixie main" \
    >"$apt/sources.list"
  local options=(-qq -o "Dir::State=$apt/state" -o "Dir::Cache=$apt/cache"
    -o "Dir::State::status=/dev/null" -o "Dir::Etc::sourcelist=$apt/sources.list"
    -o "Dir::Etc::sourceparts=-" -o "APT::Architecture=$2" -o "APT::Architectures=$2"
    -o "APT::Install-Recommends=false" -o "APT::Sandbox::User=$(id -un)" -o "Debug::NoLocking=1")
  (cd "$apt" && apt-get "${options[@]}" update && apt-get "${options[@]}" "${@:3}") || return
  while IFS= read -r package; do
    dpkg -x "$package" "$1/root" || return
  done < <(find "$apt" -name '*.deb')
  rm -r "$apt"
}
