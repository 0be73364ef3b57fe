#!/usr/bin/env bash
# The programs that find the cheapest settings, compare methods, and measure the worth of an idea: tests their
# words, their files, and the calls that they refuse.
# accuracy.sh BUILD: the folder of the programs.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"
programs=$1/measure

# cheapest WORD ...: measures a little of everything, with the reference.
cheapest() { "$programs/accuracy.reference" cheapest --seconds 1 --pixels 600 -r 48 36 "$@"; }

expect 0 './run render scenes/box_spheres.dae -s ' cheapest scenes/box_spheres.dae --error 10% --out "$folder/charts"
for words in 'predicted ' 'measured ' 'Light samples: ' 'Bounces: ' 'Roulette:' 'Adaptive sampling: ' 'Hemisphere sampling: ' \
  "The course's settings" 'Without a tree, 14 surfaces' 'Smooth normals'; do
  grep -qF -- "$words" "$folder/said" || complain "nothing about '$words"
done
# has FOLDER FILE ...: these files and no others; charts only if gnuplot exists.
has() {
  local where=$1 file
  shift
  for file in "$@"; do
    case $file in *.svg | *.pdf | *.tex) command -v gnuplot >/dev/null || continue ;; esac
    [ -s "$where/$file" ] || complain "no $file"
  done
  [ "$(find "$where" -type f | wc -l)" -le $# ] || complain "something is left over"
}
has "$folder/charts" {options,bounces,noise}.{csv,svg,pdf,tex} cheapest.json

# In no scene is anything that was tried cheaper than the answer, by more than its error.
for scene in box_spheres box_empty box_gems box_coil box_blob two_lights pale_room large_light penumbra point_light tiny_light; do
  camera=course
  [ "$scene" != pale_room ] || camera="file"
  expect 0 'predicted ' cheapest "scenes/$scene.dae" --error 20% --camera $camera --out "$folder/$scene"
  python3 - "$folder/$scene/cheapest.json" <<'END' || complain "$scene: something cheaper than the answer was measured"
import json, sys
found = json.load(open(sys.argv[1]))
ways = [found["course"], found["hemisphere"], *found["survivals"]]
times = [way["times"] for way in ways if way and way["error"] <= .2001]
sys.exit(not times or any(value + error < 1 - 1e-9 for value, error in times))
END
done

expect 0 'all lights are points or directions' cheapest scenes/point_light.dae --error .1
expect 0 'Hemisphere sampling: cannot reach this error' cheapest scenes/point_light.dae --error 10%
expect 2 'the picture is black: no light reaches the surfaces in view' cheapest scenes/pale_room.dae
expect 0 'predicted ' cheapest scenes/pale_room.dae --error 20% --camera file
expect 2 'the most that can be rendered is 16777216' cheapest scenes/box_spheres.dae --error 1e-7
for error in 0 -2% 2%% 101% nan two; do
  expect 2 '--error takes a part of the radiance' cheapest scenes/box_spheres.dae --error="$error"
done
expect 0 ' 32   ' cheapest scenes/box_spheres.dae --error 10% --light-samples 32,1
rows=$(grep -cE '^ +[0-9]+ +[0-9.e+-]+ +[0-9.e+-]+ +[0-9.]+ +[0-9.]+ +[0-9.]+ ± [0-9.]+$' "$folder/said") || true
[ "$rows" -ge 2 ] && [ "$rows" -le 4 ] ||
  complain "two numbers of light samples, and two that the model names at most, make $rows rows"
for numbers in 4 4,4 0,4 1,101 one,two; do
  expect 2 '--light-samples' cheapest scenes/box_spheres.dae --light-samples="$numbers"
done
expect 2 'no such file' cheapest scenes/nothing.dae
expect 2 '--engine' cheapest scenes/box_spheres.dae --engine steam
expect 2 'not written yet: ' "$programs/accuracy.student" cheapest scenes/box_spheres.dae

converge() { "$programs/accuracy.reference" converge --seconds 1 --pixels 600 -r 48 36 "$@"; }
expect 0 'hemisphere, l = 8 ' converge scenes/box_spheres.dae -m 3 --out "$folder/curves"
has "$folder/curves" converge.{csv,json} {efficiency,factors,front}.csv {efficiency,samples,seconds,rays}.{svg,pdf,tex}
[ "$(grep -c '"lights, l = 1, adaptive"' "$folder/curves/converge.csv")" -eq 4 ] || {
  echo "FAILED: a curve has not four points"
  failures=$((failures + 1))
}
expect 0 'lights, l = 1, adaptive' converge scenes/point_light.dae -m 2
grep -q 'hemisphere, l = 1 .*fails: ' "$folder/said" || complain "hemisphere sampling finds a point light"
! grep -qE 'hemisphere, l = 8|l = 2|survival' "$folder/said" || {
  echo "FAILED: methods that change nothing or are wrong: $(cat "$folder/said")"
  failures=$((failures + 1))
}
expect 2 '--bounces' converge scenes/box_spheres.dae -m 17

# Errors against pictures of a file: beside those of the scene nothing is wrong, beside that of another scene everything is.
for seed in 101 102; do
  "$1/pt/render" scenes/box_spheres.dae --camera file -r 48 36 -s 256 -m 3 --seed $seed -f "$folder/$seed.exr" >/dev/null
done
for others in "" "--golden $folder/102.exr"; do
  # shellcheck disable=SC2086
  expect 0 'hemisphere, l = 8 ' converge scenes/box_spheres.dae --camera file -m 3 --golden "$folder/101.exr" $others
  ! grep -q 'fails: ' "$folder/said" || complain "right code fails beside right pictures: $(cat "$folder/said")"
done
"$1/pt/render" scenes/box_empty.dae --camera file -r 48 36 -s 256 -m 3 -f "$folder/other.exr" >/dev/null
expect 0 'fails: off by ' converge scenes/box_spheres.dae --camera file -m 3 --golden "$folder/other.exr"
expect 2 'give -r 48 36 too' "$programs/accuracy.reference" converge scenes/box_spheres.dae --golden "$folder/101.exr"
expect 2 'is not an EXR' converge scenes/box_spheres.dae --golden scenes/box_spheres.dae
expect 2 'one picture, or two' converge scenes/box_spheres.dae --golden "$folder/101.exr" --golden "$folder/101.exr" --golden "$folder/101.exr"

ladder() { "$programs/ladder" --seconds 2 -r 48 36 -s 4 "$@"; }
expect 0 'The best, with' ladder scenes/box_spheres.dae -m 3 --out "$folder/ladder"
for words in 'the plainest renderer' 'the wide engine' 'light sampling' 'rectangles by solid angle' 'adaptive sampling'; do
  grep -qF -- "$words" "$folder/said" || complain "no rung '$words"
done
has "$folder/ladder" ladder.{csv,svg,pdf,tex}
expect 0 'Hemisphere sampling would miss' ladder scenes/point_light.dae -m 2
expect 2 '--samples' ladder scenes/box_spheres.dae -s 2
cp "$programs/ladder" "$folder/ladder/"
expect 2 'is missing: build the target ladder_rungs' "$folder/ladder/ladder" --seconds 2 -r 48 36 scenes/point_light.dae

expect 2 "there is no method 'steam' here, but these: \"lights, l = 1\"" converge scenes/box_spheres.dae --beside steam
expect 2 'a submission is measured in a box' converge scenes/box_spheres.dae --submission reference

# All engines have a line. Compared with itself, a method takes 1 times the time.
expect 0 'lights, l = 1, no tree' converge scenes/box_spheres.dae -m 1 --beside 'lights, l = 4' --out "$folder/engines"
grep -qF 'lights, l = 1, the tree of part 2' "$folder/said" || complain "no tree"
grep -qE '^"lights, l = 4","lights, l = 4",1,[^,]*,1,[^,]*,1,' "$folder/engines/factors.csv" || {
  echo "FAILED: a method is not as good as itself"
  failures=$((failures + 1))
}

finish
