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

finish() {
  echo "$passed passed, $failed failed"
  [ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
}

# Ends a script of which the rest makes no sense when this has failed.
finish_if_failed() { [ "$failed" -eq 0 ] || { finish; exit 1; }; }

# The Lua files of the project.
lua_sources() {
  printf '%s\n' physics.lua physics spec examples bench scripts web/determinism web/playground
}
