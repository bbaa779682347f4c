#!/usr/bin/env bash
# Makes the pictures of the pages, docs/pictures/, in a virtual display: from the examples, played with
# scripted keys, and from the scenes of scripts/pictures/. They are kept in the repository: make them
# again when an example or a scene has changed.
set -uo pipefail
. "$(dirname "$0")/checks.sh"

target=docs/pictures
work=$PWD/build/film
rm -rf "$work" && mkdir -p "$target" "$work"

in_love() { xvfb-run -a timeout -k 2 300 love examples --bare "$@"; }
ffmpeg_quiet() { ffmpeg -hide_banner -loglevel error -y "$@"; }

# The bar with the keys, at the bottom, is left away.
GAME="crop=960:606:0:0"

# film GIF EXAMPLE FIRST LAST [KEYS]: films an example, and adds some of its pictures (15 a second)
# to those of a GIF.
film() {
  local all=$work/$1 folder=$work/$1/$2 number i
  mkdir -p "$folder"
  number=$(find "$all" -maxdepth 1 -name "*.png" | wc -l)
  in_love --example="$2" --frames=$(($4 * 4)) --keys="${5:-}" --film="$folder" || return 1
  for ((i = $3; i <= $4; i++)); do
    number=$((number + 1))
    cp "$folder/$(printf %04d "$i").png" "$all/$(printf %04d "$number").png" || return 1
  done
}

# video NAME RATE FILTERS: makes NAME.mp4 of its pictures. The site shows it in place of the animation of
# that name, which is for GitHub and several times as large.
video() {
  ffmpeg_quiet -framerate "$2" -i "$work/$1/%04d.png" -vf "$3" -c:v libx264 -pix_fmt yuv420p \
    -crf 28 -preset veryslow -movflags +faststart "$target/$1.mp4"
}

# animate NAME RATE QUALITY FILTERS: makes NAME.webp of its pictures, which is a fourth of a GIF.
animate() {
  ffmpeg_quiet -framerate "$2" -i "$work/$1/%04d.png" -filter_complex "$4" -loop 0 -q:v "$3" \
    -compression_level 6 "$target/$1.webp"
}

# clip NAME FRAMES: one of scripts/pictures/clips.lua, 20 pictures a second.
clip() {
  mkdir -p "$work/$1"
  xvfb-run -a timeout -k 2 60 love scripts/pictures "$1" "$work/$1" "$2" || return 1
  animate "$1" 20 45 "scale=320:-1:flags=lanczos" && video "$1" 20 "scale=480:-2:flags=lanczos"
}

# compare: the scenes of examples/compare; BUMP is the folder of bump.lua.
compare() {
  local filters="fps=10,scale=720:-1:flags=area,split[a][b];[a]palettegen=max_colors=24[p]"
  mkdir -p "$work/compare"
  xvfb-run -a timeout -k 2 300 love examples/compare --path "$BUMP" --record "$work/compare" || return 1
  ffmpeg_quiet -framerate 15 -i "$work/compare/%04d.png" \
    -filter_complex "$filters;[b][p]paletteuse=dither=none" "$target/compare.gif" || return 1
  video compare 15 "scale=960:-2:flags=area"
}

# still NAME EXAMPLE FRAMES [KEYS]
still() {
  local filters="$GAME,scale=720:-1:flags=lanczos,split[a][b];[a]palettegen[p]"
  in_love --example="$2" --frames="$3" --keys="${4:-}" --shot="$work/$1.png" || return 1
  ffmpeg_quiet -i "$work/$1.png" -filter_complex "$filters;[b][p]paletteuse" "$target/$1.png"
}

# scene NAME: one of scripts/pictures/scenes.lua
scene() {
  local filters="split[a][b];[a]palettegen[p];[b][p]paletteuse"
  xvfb-run -a timeout -k 2 60 love scripts/pictures "$1" "$work/$1.png" || return 1
  ffmpeg_quiet -i "$work/$1.png" -filter_complex "$filters" "$target/$1.png"
}

# step NAME CROP: a program of docs/steps/.
step() {
  local filters="crop=$2,scale=480:-1:flags=lanczos,split[a][b];[a]palettegen[p]"
  xvfb-run -a timeout -k 2 60 love scripts/pictures "$1" "$work/$1.png" || return 1
  ffmpeg_quiet -i "$work/$1.png" -filter_complex "$filters;[b][p]paletteuse" "$target/$1.png"
}

smaller_than() {
  local size
  size=$(wc -c <"$2")
  echo "$2 has $size bytes, expected less than $1"
  [ "$size" -lt "$1" ]
}

hills=$(cat examples/demos/hills.keys)
check "hills is filmed" film hills hills 44 77 "$hills"
check "hills is filmed in the mine" film hills hills 382 419 "$hills"
check "hills is animated" animate hills 15 40 "$GAME,fps=12,scale=640:-1:flags=lanczos"
check "its film has less than 400 kB" smaller_than 400000 "$target/hills.webp"
check "hills is a video" video hills 15 "$GAME,scale=960:-2:flags=lanczos"
check "that has less than 350 kB" smaller_than 350000 "$target/hills.mp4"

for each in "seams 40" "stack 44" "ride 40" "bullets 40" "rates 40" "bits 58"; do
  read -r name frames <<<"$each"
  check "the clip $name is filmed" clip "$name" "$frames"
  check "it has less than 100 kB" smaller_than 100000 "$target/$name.webp"
done

if [ -n "${BUMP:-}" ]; then
  check "the engines are compared" compare
  check "that film has less than 150 kB" smaller_than 150000 "$target/compare.gif"
fi

platformer=$(cat examples/demos/platformer.keys)
lifts=$(cat examples/demos/lifts.keys)
check "hills is drawn" still hills hills 330 "$hills"
GAME="crop=720:405:120:201" check "pile is drawn" still pile pile 200
GAME="crop=760:250:100:356" check "a heap of balls is drawn" still balls pile 110 "o:2"
check "lifts is drawn" still lifts lifts 1000 "$lifts"
check "platformer is drawn" still platformer platformer 300 "$platformer"
check "tutorial is drawn" still tutorial tutorial 800 "$(cat examples/demos/tutorial.keys)"
check "topdown is drawn" still topdown topdown 400 "$(cat examples/demos/topdown.keys)"
check "breakout is drawn" still breakout breakout 500 "$(cat examples/demos/breakout.keys)"
check "survivors is drawn" still survivors survivors 1100 "$(cat examples/demos/survivors.keys)"
check "rollback is drawn" still rollback rollback 372 "$(cat examples/demos/rollback.keys)"
check "online is drawn" still online online 330 "$(cat examples/demos/online.keys)"
check "tiled is drawn" still tiled tiled 400 "$(cat examples/demos/tiled.keys)"
check "rooms is drawn" still rooms rooms 130 "$(cat examples/demos/rooms.keys)"
check "marbles is drawn" still marbles marbles 1300
for name in hills pile balls lifts platformer tutorial topdown survivors breakout rollback online tiled rooms marbles; do
  check "$name has less than 200 kB" smaller_than 200000 "$target/$name.png"
done

for name in objects contacts filters queries platforms debugging; do
  check "the scene of guide/$name.md is drawn" scene "guide-$name"
  check "guide-$name has less than 200 kB" smaller_than 200000 "$target/guide-$name.png"
done

for name in hero lift enemy crumble checkpoint bullet; do
  check "$name.lua is drawn" scene "kit-$name"
done

for number in 1 2 3 4 5 6 7; do
  check "platformer$number is drawn" step "platformer$number" 800:330:0:110
  check "topdown$number is drawn" step "topdown$number" 560:420:120:60
done

echo "The pictures are in $target/"
finish
