# Sourced by the scripts that check something. Each check is a command that succeeds or not; a
# script ends with `finish`; its last line is "N passed, N failed". .ci/run adds those lines up.

cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1
mkdir -p build

passed=0
failed=0

# check WHAT COMMAND...: runs the command and counts it. Its output is shown only when it fails.
check() {
  local what=$1 log=build/check-$$.log
  shift
  if "$@" >"$log" 2>&1 </dev/null; then
    passed=$((passed + 1))
    echo "ok      $what"
  else
    failed=$((failed + 1))
    echo "FAILED  $what"
    head -n 60 "$log" | sed 's/^/        /'
    [ "$(wc -l <"$log")" -le 60 ] || echo "        ... and $(($(wc -l <"$log") - 60)) lines more"
  fi
  rm -f "$log"
}

# refuses COMMAND...: succeeds when the command fails. For checks of the checks themselves.
refuses() { ! "$@"; }

# love_in ARGUMENT...: runs LÖVE in a virtual display, with its exit code. `timeout` stands inside:
# killed from outside, xvfb-run would leave its display behind. Its own exit code is not LÖVE's when
# it cannot clean up. LOVE names another LÖVE than that of the system.
love_in() {
  rm -f build/love.code
  xvfb-run -a bash -c 'timeout -k 2 300 "${LOVE:-love}" "$@"; echo $? >build/love.code' love "$@"
  return "$(cat build/love.code)"
}

# count_specs WHAT CODE LOG SECONDS: counts the specs of a run of busted that has ended.
count_specs() {
  local what=$1 code=$2 log=$3 seconds=$4 summary good bad broken pending
  summary=$(grep -E '^[0-9]+ success(es)? / [0-9]+ failures? / [0-9]+ errors? / [0-9]+ pending' \
    "$log" | tail -n 1)
  read -r good _ _ bad _ _ broken _ _ pending _ <<<"${summary:-0 - - 0 - - 0 - - 0 -}"
  # A run that dies, or that finds no spec, leaves no number that would count: it fails as a whole.
  if [ "$good" -eq 0 ] || { [ "$code" -ne 0 ] && [ $((bad + broken)) -eq 0 ]; }; then
    broken=$((broken + 1))
  fi
  passed=$((passed + good))
  failed=$((failed + bad + broken))
  if [ $((bad + broken)) -gt 0 ]; then
    echo "FAILED  specs on $what: $good passed, $((bad + broken)) failed ($seconds s)"
    tail -n 200 "$log" | sed 's/^/        /'
  else
    echo "ok      specs on $what: $good passed, $pending pending ($seconds s)"
  fi
}

# list_specs SLOW OPTION: lists the spec files in `files`, unless OPTION is --all without those named
# in SLOW.
list_specs() {
  local slow=" ${1//$'\n'/ } " file
  files=()
  for file in $(find spec -name '*_spec.lua' | LC_ALL=C sort); do
    if [ "$2" != --all ] && [[ "$slow" == *" $(basename "$file" _spec.lua) "* ]]; then
      echo "slow, only with --all: $file"
    else
      files+=("$file")
    fi
  done
}

finish() {
  echo "$passed passed, $failed failed"
  [ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
}

# The Lua files of the project, as far as they exist.
lua_sources() {
  local place
  for place in physics.lua physics spec examples bench scripts web/determinism web/playground; do
    [ ! -e "$place" ] || echo "$place"
  done
}
