#!/usr/bin/env bash
# Runs the specs without busted, which needs modules in C: on any Lua, on Windows and macOS too.
#
#   scripts/plain.sh LUA...     LUA: the command of an interpreter, or 5.1 to 5.5 to have it built
#
# Left out are what is tagged #slow, what looks at files (#files), on Windows what needs a shell of
# Unix (#posix), and files that are about the scripts of this repository.
set -uo pipefail
. "$(dirname "$0")/checks.sh"
. scripts/specs.sh

[ $# -gt 0 ] || set -- 5.1 5.2 5.3 5.4 5.5
number=$(sed -n 's/^  everything = "\(.*\)",$/\1/p' spec/golden.lua)
known_number() { [ "$("$1" spec/support/everything.lua | tr -d '\r')" = "$number" ]; }
name_of() { "$1" -e 'io.write(rawget(_G, "jit") and "LuaJIT" or _VERSION)'; }

for lua in "$@"; do
  case $lua in
    5.?)
      # In its folder: specs that start other interpreters find this one.
      lua=$(bash scripts/puc_lua.sh "$lua") || { check "Lua is there" false && continue; }
      export PATH="$PWD/build/puc:$PATH"
      ;;
  esac
  check "$lua runs" name_of "$lua"
  tags=slow,files
  [ "$("$lua" -e 'io.write(package.config:sub(1, 1))')" = / ] || tags=slow,files,posix
  check "the determinism scene gives the known number on $lua" known_number "$lua"
  spec_files | grep -vE '/project/(bench|manual|mutations|plain_busted|portable|rockspec|slow)_' |
    sed "s#^#$(name_of "$lua")|$lua scripts/plain_busted.lua --exclude-tags=$tags|#" >>"$logs/all"
done
play_specs <"$logs/all"

finish
