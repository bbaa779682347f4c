# Sourced by the scripts that play specs: each file by a process of its own, since they share what is
# global, and side by side on all cores (JOBS=1: one at a time).

logs=$PWD/build/$(basename "$0" .sh)-logs
rm -rf "$logs" && mkdir -p "$logs"
export logs

# play_one NAME|COMMAND|FILE: leaves FILE.log, FILE.time, the seconds of the processor, and with
# --coverage the lines that no other run has left yet.
play_one() {
  local name command file log
  IFS='|' read -r name command file <<<"$1"
  log="$logs/$name ${file//\//-}"
  export PHYSICS_LUA=$name COVERAGE=$log.marks COVERAGE_KNOWN=$log.known TIMEFORMAT=%U
  case $command in
    *--coverage*) cat "$logs/"*.marks >"$COVERAGE_KNOWN" 2>/dev/null ;;
  esac
  # shellcheck disable=SC2086 # a command is several words
  { time $command "$file" >"$log.log" 2>&1 </dev/null; } 2>"$log.time"
  rm -f "$COVERAGE_KNOWN"
}
export -f play_one

play_all() {
  tr '\n' '\0' <"$logs/jobs" |
    xargs -0 -n 1 -P "${JOBS:-$(getconf _NPROCESSORS_ONLN || echo 2)}" bash -c 'play_one "$1" || true' _
}

# count_specs NAME: adds up what the files on an interpreter have counted.
count_specs() {
  local file log counts good bad out all=0 lost=0 waiting=0 seconds
  while IFS='|' read -r _ _ file; do
    log="$logs/$1 ${file//\//-}.log"
    counts=$(tr -d '\r' <"$log" | grep -Ex '[0-9]+ passed, [0-9]+ failed, [0-9]+ left out')
    # What died before it could count has failed.
    read -r good _ bad _ out _ <<<"${counts:-0 passed, 1 failed, 0 left out}"
    all=$((all + good)) lost=$((lost + bad)) waiting=$((waiting + out))
    if [ "$bad" -gt 0 ]; then
      echo "$file:" && tail -n 100 "$log" | sed 's/^/        /'
    fi
  done < <(grep "^$1|" "$logs/jobs")
  [ "$all" -gt 0 ] || lost=$((lost + 1))
  passed=$((passed + all))
  failed=$((failed + lost))
  seconds=$(cat "$logs/$1 "*.time | awk '{ sum += $1 } END { print sum }')
  [ "$lost" -eq 0 ] && echo -n "ok      " || echo -n "FAILED  "
  echo "specs on $1: $all passed, $lost failed, $waiting left out ($seconds s of one core)"
}

# play_specs: plays what it reads, lines of NAME|COMMAND|FILE; NAME is that of the interpreter
# (scripts/interpreter.lua), COMMAND plays a spec file.
play_specs() {
  local name
  cat >"$logs/jobs"
  check "all specs come to their end" play_all
  while IFS= read -r name; do
    count_specs "$name"
  done < <(cut -d '|' -f 1 "$logs/jobs" | LC_ALL=C sort -u)
}

# The spec files in order, those that may differ on another Lua (spec/slow.lua).
spec_files() { find spec -name '*_spec.lua' | LC_ALL=C sort; }
differing_files() { luajit -e 'print(table.concat(require("spec.slow").differs, "\n"))'; }

# same_number COMMAND...: the determinism scene gives the same number as on LuaJIT here.
same_number() {
  local here there
  here=$(luajit spec/support/everything.lua) || return 1
  there=$("$@" spec/support/everything.lua | tr -d '\r') || return 1
  echo "$there there, $here here"
  [ -n "$here" ] && [ "$here" = "$there" ]
}
