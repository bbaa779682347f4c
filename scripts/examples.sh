#!/usr/bin/env bash
# Plays every example in a virtual display with scripted keys, reads how far it got, and leaves its
# picture in build/pictures/.
set -uo pipefail
. "$(dirname "$0")/checks.sh"

pictures=$PWD/build/pictures
reports=$PWD/build/reports
rm -rf "$pictures" "$reports" && mkdir -p "$pictures" "$reports"

# `timeout` stands inside: killed from outside, xvfb-run would leave its display behind.
in_love() { xvfb-run -a timeout -k 2 120 love examples "$@"; }

# play PICTURE EXAMPLE FRAMES [KEYS]
play() {
  in_love --example="$2" --frames="$3" --keys="${4:-}" --shot="$pictures/$1.png" |
    tee "$reports/$1"
  [ "${PIPESTATUS[0]}" -eq 0 ] && [ -s "$pictures/$1.png" ]
}

# number NAME PICTURE: what the report of a picture says after NAME=
number() { sed -n "s/.*[ :]$1=\([^ ]*\).*/\1/p" "$reports/$2"; }

at_least() {
  local found
  found=$(number "$2" "$1")
  echo "$2 is '$found', expected at least $3; the report: $(cat "$reports/$1")"
  [ -n "$found" ] && [ "$found" -ge "$3" ]
}

is() {
  local found
  found=$(number "$2" "$1")
  echo "$2 is '$found', expected $3; the report: $(cat "$reports/$1")"
  [ "$found" = "$3" ]
}

check "menu plays" play menu menu 300
check "menu: boxes rain" at_least menu boxes 20

check "platformer plays" play platformer platformer 150 "right:10-150,space:60-80"
check "platformer: the player ran to the right" at_least platformer x 220
check "platformer: the player took a coin" at_least platformer coins 1

check "pile plays" play pile pile 600
check "pile: no box is lost" is pile inside 600
check "pile: the boxes lie on the floor, to the bit" is pile lowest 610
check "pile: boxes are added and taken away" \
  play pile-more pile 60 "+:5,+:10,-:20"
check "pile: 100 boxes more" is pile-more boxes 700

for picture in "$pictures"/*.png; do
  name=$(basename "$picture" .png)
  check "$name: the picture is not empty" at_least "$name" colors 20
done

# An example that fails has to be seen here.
check "an example that does not exist fails" refuses in_love --example=nothing --frames=5
check "an unknown option fails" refuses in_love --examples=pile

echo "The pictures are in ${pictures#"$PWD"/}/"
finish
