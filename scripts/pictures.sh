#!/usr/bin/env bash
# Makes the pictures of the pages, docs/pictures/, in a virtual display: from the examples, played with
# scripted keys, and from the scenes of scripts/pictures/. They are kept in the repository: make them
# again when an example or a scene has changed.
set -uo pipefail
. "$(dirname "$0")/checks.sh"

target=docs/pictures
work=$PWD/build/film
rm -rf "$work" && mkdir -p "$target" "$work"

in_love() { love_in examples --bare "$@"; }
draw() { love_in scripts/pictures "$@"; }
ffmpeg_quiet() { ffmpeg -hide_banner -loglevel error -y "$@"; }

# The bar with the keys, at the bottom, is left away.
GAME="crop=960:606:0:0"

# film NAME EXAMPLE FIRST LAST KEYS: films an example, and adds some of its pictures (15 a second) to
# those of an animation.
film() {
  local all=$work/$1 folder=$work/$1/$2 number i
  mkdir -p "$folder"
  number=$(find "$all" -maxdepth 1 -name "*.png" | wc -l)
  in_love --example="$2" --frames=$(($4 * 4)) --keys="$5" --film="$folder" || return 1
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
  draw "$1" "$work/$1" "$2" || return 1
  animate "$1" 20 45 "scale=320:-1:flags=lanczos" && video "$1" 20 "scale=480:-2:flags=lanczos"
}

# compare: the scenes of examples/compare; BUMP is the folder of bump.lua.
compare() {
  local filters="fps=10,scale=720:-1:flags=area,split[a][b];[a]palettegen=max_colors=24[p]"
  mkdir -p "$work/compare"
  love_in examples/compare --path "$BUMP" --record "$work/compare" || return 1
  ffmpeg_quiet -framerate 15 -i "$work/compare/%04d.png" \
    -filter_complex "$filters;[b][p]paletteuse=dither=none" "$target/compare.gif" || return 1
  video compare 15 "scale=960:-2:flags=area"
}

# smaller_than BYTES FILE COMMAND...: the command leaves the file, with less than so many bytes.
smaller_than() {
  local size
  "${@:3}" || return 1
  size=$(wc -c <"$2")
  echo "$2 has $size bytes, expected less than $1"
  [ "$size" -lt "$1" ]
}

# still NAME FILTERS COMMAND...: the command leaves a picture, which gets few colours.
still() {
  paint() {
    "${@:3}" || return 1
    ffmpeg_quiet -i "$work/$1.png" \
      -filter_complex "$2,split[a][b];[a]palettegen[p];[b][p]paletteuse" "$target/$1.png"
  }
  check "$1 is drawn, in less than 200 kB" smaller_than 200000 "$target/$1.png" paint "$@"
}

demo() { cat "examples/demos/$1.keys"; }
check "hills is filmed" film hills hills 44 77 "$(demo hills)"
check "hills is filmed in the mine" film hills hills 382 419 "$(demo hills)"
check "hills is animated, in less than 400 kB" smaller_than 400000 "$target/hills.webp" \
  animate hills 15 40 "$GAME,fps=12,scale=640:-1:flags=lanczos"
check "hills is a video, in less than 350 kB" smaller_than 350000 "$target/hills.mp4" \
  video hills 15 "$GAME,scale=960:-2:flags=lanczos"

for each in "seams 40" "stack 44" "ride 40" "bullets 40" "rates 40" "bits 58"; do
  read -r name frames <<<"$each"
  check "the clip $name is filmed, in less than 100 kB" smaller_than 100000 "$target/$name.webp" \
    clip "$name" "$frames"
done

if [ -n "${BUMP:-}" ]; then
  check "the engines are compared, in less than 150 kB" smaller_than 150000 "$target/compare.gif" compare
fi

# The name of a picture, the example, how many frames, the keys (demo: those that are recorded), what is seen.
while read -r name example frames keys crop; do
  case $keys in
    -) keys="" ;;
    demo) keys=$(demo "$example") ;;
  esac
  still "$name" "${crop:-$GAME},scale=720:-1:flags=lanczos" \
    in_love --example="$example" --frames="$frames" --keys="$keys" --shot="$work/$name.png"
done <<'PICTURES'
hills hills 330 demo
pile pile 200 - crop=720:405:120:201
balls pile 110 o:2 crop=760:250:100:356
lifts lifts 1000 demo
platformer platformer 300 demo
tutorial tutorial 800 demo
topdown topdown 400 demo
breakout breakout 500 demo
survivors survivors 1100 demo
rollback rollback 372 demo
online online 330 demo
tiled tiled 400 demo
rooms rooms 130 demo
marbles marbles 1300 -
PICTURES

for name in guide-{objects,contacts,filters,queries,platforms,debugging} \
  kit-{hero,lift,enemy,crumble,checkpoint,bullet}; do
  still "$name" null draw "$name" "$work/$name.png"
done

for number in 1 2 3 4 5 6 7; do
  for each in "platformer$number 800:330:0:110" "topdown$number 560:420:120:60"; do
    read -r name crop <<<"$each"
    still "$name" "crop=$crop,scale=480:-1:flags=lanczos" draw "$name" "$work/$name.png"
  done
done

echo "The pictures are in $target/"
finish
