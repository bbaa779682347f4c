#!/usr/bin/env bash
# Plays every example in a virtual display with scripted keys, reads how far it got, and leaves its
# picture in build/pictures/. LOVE names another LÖVE than that of the system.
set -uo pipefail
. "$(dirname "$0")/checks.sh"

pictures=$PWD/build/pictures
reports=$PWD/build/reports
rm -rf "$pictures" "$reports" && mkdir -p "$pictures" "$reports"

in_love() { love_in examples "$@"; }

# play PICTURE EXAMPLE FRAMES KEYS
play() {
  in_love --example="$2" --frames="$3" --keys="$4" --shot="$pictures/$1.png" | tee "$reports/$1"
  [ "${PIPESTATUS[0]}" -eq 0 ] && [ -s "$pictures/$1.png" ]
}

# number NAME PICTURE: what the report of a picture says after NAME=
number() { sed -n "s/.*[ :]$1=\([^ ]*\).*/\1/p" "$reports/$2"; }

# reports PICTURE NAME=VALUE, or NAME>=LEAST
reports() {
  local found
  found=$(number "${2%%[>=]*}" "$1")
  echo "found '$found', expected $2; the report: $(cat "$reports/$1")"
  case $2 in
    *">="*) [ -n "$found" ] && [ "$found" -ge "${2##*=}" ] ;;
    *) [ "$found" = "${2##*=}" ] ;;
  esac
}

# plays PICTURE EXAMPLE FRAMES KEYS [NAME=VALUE | NAME>=LEAST]...
plays() {
  local wanted
  check "$1 plays" play "${@:1:4}"
  for wanted in "${@:5}"; do
    check "$1: $wanted" reports "$1" "$wanted"
  done
}
demo() { cat "examples/demos/$1.keys"; }

plays menu menu 300 "" "boxes>=20"
# The recorded keys win the level. When the level or the physics was changed on purpose and they do
# not any more: `luajit scripts/find_keys.lua platformer >examples/demos/platformer.keys`; so for hills.
plays platformer platformer 300 "$(demo platformer)" "x>=400" "coins>=3"
plays platformer-won platformer 900 "$(demo platformer)" won=true deaths=0
plays hills hills 1900 "$(demo hills)" won=true deaths=0 "coins>=40"

# Thorns have led back to the flag; the game is saved in another room.
plays rooms rooms 300 "$(demo rooms)" "x>=490" "deaths>=1"
plays rooms-saved rooms 60 c:5 "x>=490"
plays rooms-ldtk rooms 60 g:5

# page NUMBER [KEYS]: the keys that open a page of the tutorial, and then some.
page() {
  local keys="" i
  for ((i = 1; i < $1; i++)); do
    keys="${keys}right:$i,"
  done
  echo "$keys${2:-}"
}
plays tutorial-01 tutorial 90 "$(page 1 space:5)"
plays tutorial-02 tutorial 30 "$(page 2 space:20,space:22)" overlap=true
plays tutorial-03 tutorial 60 "$(page 3 w:20-33,a:20-44,space:50)" side=right
plays tutorial-04 tutorial 30 "$(page 4 3:20)" shape=left
plays tutorial-05 tutorial 30 "$(page 5 2:20)" middles=right
plays tutorial-06 tutorial 30 "$(page 6 4:20)" shape=left middles=right opposites=bottom
plays tutorial-07 tutorial 120 "$(page 7 d:20-110)" "a>=150" gap=0
plays tutorial-08 tutorial 70 "$(page 8)"
# The ghost stands on the cloud, the block and what stood on the trapdoor on the floor.
plays tutorial-09 tutorial 160 "$(page 9 1:50,2:50,3:50)" ghost=250 block=440 lowest=440
plays tutorial-10 tutorial 100 "$(page 10)" "pairs>=60"

plays pile pile 600 "" inside=600 lowest=586
plays pile-more pile 60 "+:5,+:10,-:20,b:30,space:40" boxes=700
plays pile-balls pile 600 o:5 inside=300 resting=300
plays pile-both pile 900 o:5,o:10 inside=300
plays marbles marbles 2400 "click@300x60:900,space:1200" inside=25 "laps>=10" "bumps>=20"

# The checks ask for less than these keys take, so that small changes do not break them.
plays lifts lifts 1400 "$(demo lifts)" won=true "flattened>=3"
plays topdown topdown 1620 "$(demo topdown)" won=true gate=open
plays tiled tiled 1180 "$(demo tiled)" won=true "coins>=8" deaths=0 rectangles=38
plays tiled-tiles tiled 60 g:5,x:10,x:12 rectangles=540
# A shaft, into which the hero falls, and a tunnel. Only the rectangles around them are cut.
digs=down:5-200,e:40,e:70,right:125-300,e:150,e:165,e:190,e:205,e:230,e:245
plays tiled-digs tiled 320 $digs "dug>=5" rectangles=41 "y>=500"
plays survivors survivors 1200 "$(demo survivors)" "enemies>=380" "killed>=150" "gems>=100" "blasts>=3"
plays breakout breakout 828 "$(demo breakout)" "broken>=15" "shots>=10" lost=0
# Time is turned back and seen again, the same to the bit.
football=right:8-30,left:90-130,d:20-70,w:45-46,d:100-135,w:110-111,up:60-61,left:150-200
plays rollback rollback 415 $football,q:240-300,space:330 "same>=60" different=0
plays rollback-on rollback 300 $football,q:240-270,a:275-299
plays online online 330 "$(demo online)" "equal>=9" "back>=3" desync=none
plays online-cut online 400 "$(demo online),c:100,c:200" "equal>=8"

# The menu (its fourth example is lifts), and what the frame around the examples does for all.
plays menu-starts menu 30 down:5,down:8,down:11,return:15 "x>=300"
plays frame-esc lifts 30 escape:10 chosen=4
run=right:10-300
plays frame-59 platformer 59 $run
plays frame-62 platformer 62 $run
# A pause, three single steps in it, and slow motion, in which 15 frames are 3.
plays frame-pause platformer 200 $run,p:60 "x=$(number x frame-59)"
plays frame-steps platformer 200 $run,p:60,n:100,n:110,n:120 "x=$(number x frame-62)"
plays frame-slow platformer 74 $run,m:60 "x=$(number x frame-62)"
# What the physics sees, also with names; then a new start.
plays frame-physics lifts 120 x:30
plays frame-names lifts 120 x:30,x:31
plays frame-again lifts 120 left:10-100,r:119 x=300

# alone NAME: takes an example out of its folder, as examples/README.md says, and plays half a second.
alone() {
  local folder=$PWD/build/alone file
  rm -rf "$folder" && mkdir -p "$folder"
  cp -r physics.lua physics "examples/$1.lua" "$folder" || return 1
  for file in $(sed -n "s/^| \[$1\.lua\].*| //p" examples/README.md | tr -d '`,|'); do
    mkdir -p "$folder/$(dirname "$file")"
    cp -r "examples/$file" "$folder/$(dirname "$file")" || return 1
  done
  sed -n '/^```lua$/,/^```$/p' examples/README.md | sed "/^\`/d; s/\"platformer\"/\"$1\"/" >"$folder/main.lua"
  cat >>"$folder/main.lua" <<END
local frames, update = 0, love.update
function love.update()
  frames = frames + 1
  update(1 / 60)
  if frames == 30 then love.event.quit() end
end
function love.errorhandler(message)
  io.stderr:write(message, "\n")
  os.exit(1)
end
END
  love_in "$folder"
}
# Whatever else the menu offers, so that no example is forgotten.
for name in $(sed -n 's/^ *{ name = "\([a-z]*\)".*/\1/p' examples/menu.lua); do
  ls "$pictures/$name"*.png >/dev/null 2>&1 || plays "$name" "$name" 240 ""
  check "$name runs out of its folder" alone "$name"
done

for picture in "$pictures"/*.png; do
  name=$(basename "$picture" .png)
  check "$name: the picture is not empty" reports "$name" "colors>=20"
done

# Tests that only see what is printed, as in a browser, rely on the lines that main.lua describes.
says() {
  "${@:2}" | tee build/said
  echo "expected: $1"
  grep -Eqx "$1" build/said
}
moved="example platformer second 1: x=(3[0-9]{2}) y=[0-9]+ coins=[0-9]+ deaths=0 won=false"
check "--say tells of the start" \
  says "example lifts started" in_love --example=lifts --frames=2 --say
check "--say tells where the player is" \
  says "$moved" in_love --example=platformer --frames=70 --keys=right:10-60 --say
check "nothing is said without it" \
  refuses says "example .*" in_love --example=lifts --frames=70
# Files beside main.lua do the same.
copy=$PWD/build/copy
rm -rf "$copy" && mkdir -p "$copy" && cp -r physics.lua physics examples "$copy"
echo topdown >"$copy/examples/start.txt"
in_copy() { love_in "$copy/examples" "$@"; }
check "start.txt names the example" says "topdown: .*" in_copy --frames=2
check "and says nothing by itself" refuses says "example .*" in_copy --frames=2
touch "$copy/examples/say.txt"
check "say.txt is --say" says "example topdown started" in_copy --frames=2
check "an argument goes before start.txt" \
  says "example lifts started" in_copy --example=lifts --frames=2

# An example that fails has to be seen here, at once and not when the time is over.
fails() {
  in_love "$@"
  local code=$?
  echo "the exit code is $code, expected 1"
  [ "$code" -eq 1 ]
}
check "an example that does not exist fails" fails --example=nothing --frames=5
check "an unknown option fails" fails --examples=pile
check "keys that cannot be read fail" fails --example=pile --keys=right

echo "The pictures are in ${pictures#"$PWD"/}/"
finish
