#!/usr/bin/env bash
# The program that finds the cheapest settings: its answer, its files, and what it refuses.
# cheapest.sh BUILD: whose programs are tried.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
programs=$1/writeup
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

failures=0
# expect STATUS WORDS COMMAND ...: it ends with the status and says the words.
expect() {
  local status=$1 words=$2 got=0
  shift 2
  "$@" >"$folder/said" 2>&1 || got=$?
  { [ "$got" -eq "$status" ] && grep -qF -- "$words" "$folder/said"; } || {
    echo "FAILED: $* ended with $got, and without '$words': $(tail -5 "$folder/said")"
    failures=$((failures + 1))
  }
}
# cheapest WORD ...: a little of everything, by the reference.
cheapest() { "$programs/cheapest.reference" --seconds 2 -r 48 36 "$@"; }

expect 0 './run render scenes/box_spheres.dae -s ' cheapest scenes/box_spheres.dae --error 10% --out "$folder/charts"
for words in 'predicted ' 'measured ' 'Light samples: ' 'Bounces: ' 'Roulette:' 'Adaptive sampling: ' 'Hemisphere sampling: ' \
  "The course's settings" 'Without a tree, 14 surfaces' 'Smooth normals'; do
  grep -qF -- "$words" "$folder/said" || { echo "FAILED: nothing about '$words'"; failures=$((failures + 1)); }
done
for name in options bounces noise; do
  for ending in csv svg; do
    [ "$ending" != svg ] || command -v gnuplot >/dev/null || continue
    [ -s "$folder/charts/$name.$ending" ] || { echo "FAILED: no $name.$ending"; failures=$((failures + 1)); }
  done
done
[ "$(find "$folder/charts" -type f | wc -l)" -le 6 ] || { echo "FAILED: something is left over"; failures=$((failures + 1)); }

expect 0 'all lights are points or directions' cheapest scenes/point_light.dae --error .1
expect 0 'Hemisphere sampling: cannot reach this error' cheapest scenes/point_light.dae --error 10%
sed '/<instance_light/d' scenes/point_light.dae >"$folder/dark.dae"
expect 2 'the scene has no light' cheapest "$folder/dark.dae"
expect 2 'more than 16777216 samples per pixel' cheapest scenes/box_spheres.dae --error 1e-7
for error in 0 -2% 2%% 101% nan two; do
  expect 2 '--error takes a part of the radiance' cheapest scenes/box_spheres.dae --error="$error"
done
expect 2 'no such file' cheapest scenes/nothing.dae
expect 2 '--engine' cheapest scenes/box_spheres.dae --engine steam
expect 2 'not written yet: ' "$programs/cheapest.student" scenes/box_spheres.dae

[ "$failures" -eq 0 ] && echo 'cheapest works'
exit $((failures > 0))
