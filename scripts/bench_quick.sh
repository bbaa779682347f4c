#!/usr/bin/env bash
# Looks whether the benchmark runs: every scene with every engine that is there, a few frames each.
# No time is looked at.
set -uo pipefail
. "$(dirname "$0")/checks.sh"

check "the benchmark runs in LÖVE" bash scripts/bench.sh --quick
check "the benchmark runs without LÖVE" luajit bench/run.lua --quick --scene pile,level
check "the benchmark runs on Lua 5.1" lua5.1 bench/run.lua --quick --scene pile,level

# The real way: a process for each measurement, and the results as JSON.
measured() {
  bash scripts/bench.sh --scene rest --n 50 --steps 20 --rounds 2 --json >build/bench-quick.json &&
    luajit -e '
      package.path = "./?.lua;" .. package.path
      local text = io.open("build/bench-quick.json"):read("*a")
      local found = {}
      for _, job in ipairs(require("bench.json").decode(text).results) do
        found[job.engine .. job.mode] = job.median and job.p99 and job.garbage and job.overlap
      end
      for _, name in ipairs({ "oursjit", "oursoff", "lovejit", "loveoff" }) do
        assert(found[name], name .. " has no figures: " .. text)
      end'
}
check "processes of their own bring figures of ours and of love.physics" measured
worst() {
  luajit bench/worst.lua --only spot-open:5,piston:5 --growth --json >build/bench-worst.json &&
    luajit -e '
      package.path = "./?.lua;" .. package.path
      for line in io.lines("build/bench-worst.json") do
        local job = require("bench.json").decode(line)
        assert(job.growth or job.ending == "done" and job.worst and job.jump, line)
      end'
}
check "the worst cases can be played alone" worst
check "an unknown worst case is refused" refuses luajit bench/worst.lua --only nothing
check "the scenes of contacts run" luajit bench/contacts.lua --quick --verbose
check "one of them can be shown" luajit bench/contacts.lua --only rooms --seed 3
check "a subject that is not there is refused" refuses luajit bench/contacts.lua --only nothing
sizes() {
  luajit bench/size.lua --rounds 1 | tee build/sizes
  for what in "source, kB" "\`require\`, ms, lua5.1" "an empty world, kB, luajit"; do
    grep -qE "^\| $what \|( [0-9.]+ \|){3,}$" build/sizes || return 1
  done
}
check "the sizes are measured" sizes
check "an unknown option of it is refused" refuses luajit bench/size.lua --round 1
check "an unknown scene is refused" refuses bash scripts/bench.sh --quick --scene nothing

finish
