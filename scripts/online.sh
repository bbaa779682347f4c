#!/usr/bin/env bash
# Plays the example Online in pairs of two processes each, over 127.0.0.1, without a window: football with
# keys at random, ping and loss made by the senders. Compares all hashes that both have reached.
#
#   scripts/online.sh SECONDS
set -uo pipefail
. "$(dirname "$0")/checks.sh"

seconds=${1:-6}
logs=$PWD/build/online
rm -rf "$logs" && mkdir -p "$logs"
export XDG_RUNTIME_DIR=${XDG_RUNTIME_DIR:-$logs}
port=$((20000 + $$ % 20000))

# play NAME SIDE PORT SECONDS PING LOSS [break]: one process, which ends by itself. Leaves NAME.SIDE.
play() {
  timeout -k 2 $(($4 + 30)) "${LOVE:-love}" scripts/online "${@:2}" >"$logs/$1.$2" 2>"$logs/$1.$2.errors" </dev/null
  echo "code $?" >>"$logs/$1.$2"
}

# pair NAME SECONDS PING LOSS [break]: both processes.
pair() {
  port=$((port + 1))
  play "$1" host "$port" "$2" "$3" "$4" &
  play "$1" join "$port" "$2" "$3" "$4" ${5:+"$5"} &
}

# number NAME SIDE WORD: the figure behind a word.
number() { sed -n "s/^$3 \([0-9.]*\).*/\1/p" "$logs/$1.$2"; }

ends_well() {
  local side
  for side in host join; do
    cat "$logs/$1.$side.errors" && grep -v ^hash "$logs/$1.$side"
    grep -qx "code 0" "$logs/$1.$side" && grep -qx "problem none" "$logs/$1.$side" || return 1
  done
}

# Those that one process has compared, and those of both, beside each other.
hashes_agree() {
  local least=$1 count
  awk '/^hash/ && $3 != $4 { print; wrong = 1 } END { exit wrong }' "$logs/$2.host" "$logs/$2.join" || return 1
  join <(grep ^hash "$logs/$2.host" | cut -d " " -f 2,3 | sort) \
    <(grep ^hash "$logs/$2.join" | cut -d " " -f 2,3 | sort) >"$logs/$2.both"
  awk '$2 != $3 { print; wrong = 1 } END { exit wrong }' "$logs/$2.both" || return 1
  count=$(wc -l <"$logs/$2.both")
  echo "$count hashes are equal, expected at least $least"
  [ "$count" -ge "$least" ]
}

# at_most NUMBER WORD NAME [SLACK]: of both sides. A word as SLACK: so much more as that is on either side.
at_most() {
  local side found more=0
  for side in host join; do
    [ -z "${4:-}" ] || more=$((more + $(number "$3" $side "$4")))
  done
  for side in host join; do
    found=$(number "$3" $side "$2")
    echo "$2 is '$found' for $side, expected at most $1 + $more"
    awk -v found="${found:-none}" -v most="$(($1 + more))" \
      'BEGIN { exit !(found + 0 == found && found <= most) }' || return 1
  done
}

for ping in 0 60 150; do
  for loss in 0 2 10; do
    pair "$ping-$loss" "$seconds" "$ping" "$loss"
  done
  wait
  for loss in 0 2 10; do
    name=$ping-$loss
    what="$ping ms, $loss % lost"
    check "$what: both end well" ends_well "$name"
    check "$what: the hashes are equal" hashes_agree $((seconds * 2 - 6)) "$name"
    check "$what: neither waits longer than 150 ms" at_most 150 longestWait "$name" longestSleep
    check "$what: at most 4 kB a second" at_most 4000 mostBytes "$name"
    check "$what: the frame with the longest rollback takes at most 8 ms" at_most 8 longestRollback "$name"
  done
done

# What goes wrong is found, named, and mended by the state of the host.
pair broken 10 60 2 break
# A guest that is killed; another one joins the same game.
again=$((port + 1))
{
  timeout -s KILL 6 "${LOVE:-love}" scripts/online join "$again" 20 60 2 >"$logs/killed.join" 2>&1 </dev/null
  play again join "$again" 10 60 2
} 2>/dev/null &
play again host "$again" 18 60 2 &
wait
says() { grep -E "$2" "$logs/$1" || { tail -n 5 "$logs/$1" && return 1; }; }
difference='^desync step [0-9]+: balls\[1\]\.[a-z]+ is .* here and .* there$'
check "a game that was changed is found by the host" says broken.host "$difference"
check "and by the other side" says broken.join "$difference"
# ends_equal LEAST LOG: so many of its last hashes are equal.
ends_equal() { awk -v least="$1" '/^hash/ { equal = $3 == $4 ? equal + 1 : 0 } END { print equal; exit equal < least }' "$logs/$2"; }
check "then they play on with equal hashes" ends_equal 3 broken.join
check "a player that was killed had played" ends_equal 1 killed.join
check "the next one joins the same game" ends_well again
check "and the hashes are equal" hashes_agree 4 again

finish
