#!/usr/bin/env bash
# Runs the specs without busted, which needs modules in C: on any Lua, on Windows and macOS too.
#
#   scripts/plain.sh LUA...     LUA: the command of an interpreter, or 5.1 to 5.5 to have it built
#
# Left out are what is tagged #slow, what looks at files (#files), on Windows what needs a shell of
# Unix (#posix), and files that are about the scripts of this repository.
set -uo pipefail
. "$(dirname "$0")/checks.sh"

[ $# -gt 0 ] || set -- 5.1 5.2 5.3 5.4 5.5
about_scripts="bench manual mutations plain_busted portable rockspec slow"

run_one() { "$1" scripts/plain_busted.lua --exclude-tags="$tags" "$2" </dev/null; }
runs() { "$1" -e 'io.write(_VERSION)' >/dev/null 2>&1; }

for lua in "$@"; do
  case $lua in
    5.?)
      # In its folder: specs that start other interpreters find this one.
      lua=$(bash scripts/puc_lua.sh "$lua") || { check "Lua is there" false && continue; }
      export PATH="$PWD/build/puc:$PATH"
      ;;
  esac
  check "$lua runs" runs "$lua"
  tags=slow,files
  [ "$("$lua" -e 'io.write(package.config:sub(1, 1))')" = / ] || tags=slow,files,posix
  number=$("$lua" spec/support/everything.lua | tr -d '\r')
  known() { grep -qF "everything = \"$number\"" spec/golden.lua; }
  check "the determinism scene gives the known number on $lua" known
  for file in $(find spec -name '*_spec.lua' | LC_ALL=C sort); do
    name=$(basename "$file" _spec.lua)
    [[ " $about_scripts " != *" $name "* ]] || continue
    log=build/plain.log
    run_one "$lua" "$file" >"$log" 2>&1
    counts=$(tr -d '\r' <"$log" | grep -E '^[0-9]+ passed, [0-9]+ failed, [0-9]+ left out$' | tail -n 1)
    # What died before it could count has failed.
    read -r good _ bad _ <<<"${counts:-0 passed, 1 failed}"
    passed=$((passed + good))
    failed=$((failed + bad))
    if [ "$bad" -gt 0 ]; then
      echo "FAILED  $file on $lua: $bad failed"
      tail -n 60 "$log" | sed 's/^/        /'
    else
      echo "ok      $file on $lua: $good passed"
    fi
  done
done

finish
