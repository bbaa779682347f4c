#!/usr/bin/env bash
# Plays every example in a virtual display with scripted keys, reads how far it got, and leaves its
# picture in build/pictures/. LOVE names another LÖVE than that of the system.
set -uo pipefail
. "$(dirname "$0")/checks.sh"

pictures=$PWD/build/pictures
reports=$PWD/build/reports
rm -rf "$pictures" "$reports" && mkdir -p "$pictures" "$reports"

# love_in FOLDER ARGUMENT...: runs LÖVE in a virtual display, with its exit code. `timeout` stands
# inside: killed from outside, xvfb-run would leave its display behind. Its own exit code is not
# LÖVE's when it cannot clean up.
love_in() {
  rm -f build/love.code
  xvfb-run -a bash -c 'timeout -k 2 120 "${LOVE:-love}" "$@"; echo $? >build/love.code' love "$@"
  return "$(cat build/love.code)"
}
in_love() { love_in examples "$@"; }

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

keys=$(cat examples/demos/platformer.keys)
check "platformer plays" play platformer platformer 300 "$keys"
check "platformer: the player ran to the right" at_least platformer x 400
check "platformer: the player took coins" at_least platformer coins 3
# The recorded keys win the level. When the level or the physics was changed on purpose and they do
# not any more: `luajit scripts/find_keys.lua platformer >examples/demos/platformer.keys`.
check "platformer plays to its end" play platformer-won platformer 900 "$keys"
check "platformer: the flag is reached" is platformer-won won true
check "platformer: at the first try" is platformer-won deaths 0

check "rooms plays" play rooms rooms 300 "$(cat examples/demos/rooms.keys)"
check "rooms: the player went to another room" at_least rooms x 490
check "rooms: thorns led back to the flag" at_least rooms deaths 1
check "rooms plays the saved game" play rooms-saved rooms 60 "c:5"
check "rooms: the saved game is in the other room" at_least rooms-saved x 490
check "rooms plays the other editor's map" play rooms-ldtk rooms 60 "g:5"

# These, too: `luajit scripts/find_keys.lua hills >examples/demos/hills.keys`.
check "hills plays to its end" play hills hills 1900 "$(cat examples/demos/hills.keys)"
check "hills: the flag is reached" is hills won true
check "hills: at the first try" is hills deaths 0
check "hills: coins were taken" at_least hills coins 40

# page NUMBER [KEYS]: the keys that open a page of the tutorial, and then some.
page() {
  local keys="" i
  for ((i = 1; i < $1; i++)); do
    keys="${keys}right:$i,"
  done
  echo "$keys${2:-}"
}
check "tutorial 1 plays" play tutorial-01 tutorial 90 "$(page 1 space:5)"
check "tutorial 2 plays" play tutorial-02 tutorial 30 "$(page 2 space:20,space:22)"
check "tutorial 2: boxes that cross overlap" is tutorial-02 overlap true
check "tutorial 3 plays" play tutorial-03 tutorial 60 "$(page 3 w:20-33,a:20-44,space:50)"
check "tutorial 3: side by side counts" is tutorial-03 side right
check "tutorial 4 plays" play tutorial-04 tutorial 30 "$(page 4 3:20)"
check "tutorial 4: the shape is wrong" is tutorial-04 shape left
check "tutorial 5 plays" play tutorial-05 tutorial 30 "$(page 5 2:20)"
check "tutorial 5: the middles are wrong" is tutorial-05 middles right
check "tutorial 6 plays" play tutorial-06 tutorial 30 "$(page 6 4:20)"
check "tutorial 6: the shape is wrong" is tutorial-06 shape left
check "tutorial 6: the middles are wrong" is tutorial-06 middles right
check "tutorial 6: the opposite sides are right" is tutorial-06 opposites bottom
check "tutorial 7 plays" play tutorial-07 tutorial 120 "$(page 7 d:20-110)"
check "tutorial 7: a was moved" at_least tutorial-07 a 150
check "tutorial 7: a and b are flush" is tutorial-07 gap 0
check "tutorial 8 plays" play tutorial-08 tutorial 70 "$(page 8)"
check "tutorial 9 plays" play tutorial-09 tutorial 160 "$(page 9 1:50,2:50,3:50)"
check "tutorial 9: the ghost stands on the cloud" is tutorial-09 ghost 250
check "tutorial 9: the block lies on the floor" is tutorial-09 block 440
check "tutorial 9: what stood on the trapdoor, too" is tutorial-09 lowest 440
check "tutorial 10 plays" play tutorial-10 tutorial 100 "$(page 10)"
check "tutorial 10: the grid finds some pairs" at_least tutorial-10 pairs 60

check "pile plays" play pile pile 600
check "pile: no box is lost" is pile inside 600
check "pile: the boxes lie on the floor, to the bit" is pile lowest 586
check "pile: boxes are added and taken away" play pile-more pile 60 "+:5,+:10,-:20,b:30,space:40"
check "pile: 100 boxes more" is pile-more boxes 700
check "pile: balls are dropped" play pile-balls pile 600 "o:5"
check "pile: no ball is lost" is pile-balls inside 300
check "pile: the balls lie still" is pile-balls resting 300
check "pile: both are dropped" play pile-both pile 900 "o:5,o:10"
check "pile: none of both is lost" is pile-both inside 300

check "marbles plays" play marbles marbles 2400 "click@300x60:900,space:1200"
check "marbles: none is lost" is marbles inside 25
check "marbles: the lift brings them up" at_least marbles laps 10
check "marbles: they hit the bumpers" at_least marbles bumps 20

# The checks ask for less than these keys take, so that small changes do not break them.
check "lifts plays to its end" play lifts lifts 1400 "$(cat examples/demos/lifts.keys)"
check "lifts: all coins were taken" is lifts won true
check "lifts: crates were crushed" at_least lifts flattened 3
check "topdown plays to its end" play topdown topdown 1620 "$(cat examples/demos/topdown.keys)"
check "topdown: all coins were taken" is topdown won true
check "topdown: the crate opened the gate" is topdown gate open
check "tiled plays to its end" play tiled tiled 1180 "$(cat examples/demos/tiled.keys)"
check "tiled: the flag is reached" is tiled won true
check "tiled: coins were taken" at_least tiled coins 8
check "tiled: and the hero was not hurt" is tiled deaths 0
check "tiled: few rectangles" is tiled rectangles 38
check "tiled plays with each tile an object" play tiled-tiles tiled 60 "g:5,x:10,x:12"
check "tiled: as many as tiles" is tiled-tiles rectangles 540
digs="down:5-200,e:40,e:70,right:125-300,e:150,e:165,e:190,e:205,e:230,e:245"
check "tiled digs" play tiled-digs tiled 320 "$digs"
check "tiled: a shaft and a tunnel" at_least tiled-digs dug 5
check "tiled: and only what is around them is cut" is tiled-digs rectangles 41
check "tiled: the hero fell into the shaft" at_least tiled-digs y 500
check "survivors plays" play survivors survivors 1200 "$(cat examples/demos/survivors.keys)"
check "survivors: the crowd is there" at_least survivors enemies 380
check "survivors: enemies were shot" at_least survivors killed 150
check "survivors: gems flew to the player" at_least survivors gems 100
check "survivors: there were blasts" at_least survivors blasts 3
check "breakout plays" play breakout breakout 828 "$(cat examples/demos/breakout.keys)"
check "breakout: bricks were removed" at_least breakout broken 15
check "breakout: bullets were shot" at_least breakout shots 10
check "breakout: and none was lost" is breakout lost 0
football="right:8-30,left:90-130,d:20-70,w:45-46,d:100-135,w:110-111,up:60-61,left:150-200"
check "rollback plays" play rollback rollback 415 "$football,q:240-300,space:330"
check "rollback: time was turned back and seen again" at_least rollback same 60
check "rollback: and it was the same, to the bit" is rollback different 0
check "rollback plays on differently" play rollback-on rollback 300 "$football,q:240-270,a:275-299"

online=$(cat examples/demos/online.keys)
check "online plays" play online online 330 "$online"
check "online: the hashes of both sides are equal" at_least online equal 9
check "online: time was turned back" at_least online back 3
check "online: and the games are the same" is online desync none
check "online: the line is cut and mended" play online-cut online 400 "$online,c:100,c:200"
check "online: the games are the same again" at_least online-cut equal 8

# The menu, and what the frame around the examples does for all of them.
check "the menu starts what is chosen" play menu-starts menu 30 "down:5,down:8,down:11,return:15"
check "the menu: that is lifts" at_least menu-starts x 300
check "esc leads back to the menu" play frame-esc lifts 30 escape:10
check "esc: lifts is still chosen" is frame-esc chosen 4
run=right:10-300
check "a run of 59 frames" play frame-59 platformer 59 "$run"
check "a run of 62 frames" play frame-62 platformer 62 "$run"
check "the time stops in frame 60" play frame-pause platformer 200 "$run,p:60"
check "pause: nothing moves any more" is frame-pause x "$(number x frame-59)"
check "a paused step at a time" play frame-steps platformer 200 "$run,p:60,n:100,n:110,n:120"
check "steps: the player ran for three" is frame-steps x "$(number x frame-62)"
check "slow motion, a fifth as fast" play frame-slow platformer 74 "$run,m:60"
check "slow motion: 15 frames are 3" is frame-slow x "$(number x frame-62)"
check "what the physics sees" play frame-physics lifts 120 "x:30"
check "and with names" play frame-names lifts 120 "x:30,x:31"
check "r starts again" play frame-again lifts 120 "left:10-100,r:119"
check "r: the player is where it began" is frame-again x 300

# Whatever else the menu offers, so that no example is forgotten.
for name in $(sed -n 's/^ *{ name = "\([a-z]*\)".*/\1/p' examples/menu.lua); do
  if ! ls "$pictures/$name"*.png >/dev/null 2>&1; then
    check "$name plays" play "$name" "$name" 240
  fi
done

for picture in "$pictures"/*.png; do
  name=$(basename "$picture" .png)
  check "$name: the picture is not empty" at_least "$name" colors 20
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
for name in $(sed -n 's/^ *{ name = "\([a-z]*\)".*/\1/p' examples/menu.lua); do
  check "$name runs out of its folder" alone "$name"
done

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
