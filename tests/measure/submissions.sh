#!/usr/bin/env bash
# Somebody else's code through every command that measures it in the box, at small size: what is said, and the exit status. A copy of
# the reference, other right solutions, a wrong one, and code that does not compile, crashes, never ends or is missing.
# submissions.sh BUILD: the folder of the programs.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"
build=$1

# copy NAME [TASK FILE] ...: the reference with these files in place of its own, as somebody would hand it in.
copy() {
  local to=$folder/$1 task
  cp -r reference "$to"
  shift
  while [ $# -gt 0 ]; do
    task=$(compgen -G "$to/*/$1.cpp")
    cp "$2" "$task"
    shift 2
  done
}
# in_every_call NAME TASK WORDS: adds the words at the beginning of the function's body.
in_every_call() { sed -i "0,/^[a-zA-Z:<>]* $2(.*{\$/s//&\n  $3/" "$folder/$1/"*"/$2.cpp"; }

# COMMAND STATUS WORDS NAME ...: measures the submission; it ends with the status and prints the words.
scene() {
  local command=$1 status=$2 words=$3 name=$4
  shift 4
  expect "$status" "$words" timeout 900 "$build/measure/accuracy_boxed" "$command" scenes/box_spheres.dae \
    --submission "$folder/$name" --seconds 1 --pixels 300 -r 48 36 "$@"
}
cheapest() { scene cheapest "$1" "$2" "$3" --error 10%; }
converge() { scene converge "$1" "$2" "$3" -m 2; }
measure() { expect "$1" "$2" "$build/measure/measure" hit_sphere.half_b --seconds 1 --submission "$folder/$3"; }
stability() {
  expect "$1" "$2" "$build/measure/stability" hit_sphere --no-methods --coarse --effort .02 --submission "$folder/$3"
}
writeup() {
  expect "$1" "$2" "$build/writeup/writeup" --quality draft edge --submission "$folder/$3" --boxed "$build/measure/writeup_boxed" \
    --accuracy "$build/measure/accuracy_boxed" --generate "$build/scenes/generate" --work "$folder/work" --text writeup/questions
}

copy good
copy mixed hit_sphere grader/tasks/hit_sphere/right/textbook.cpp trace_path grader/tasks/trace_path/right/recursion.cpp \
  adaptive_pixel grader/tasks/adaptive_pixel/right/at_most_for_less.cpp
for right in good mixed; do
  cheapest 0 './run render scenes/box_spheres.dae -s ' $right
  grep -qF 'Without a tree, 14 surfaces' "$folder/said" || complain "the engine without a tree was not tried"
  converge 0 'lights, l = 1, the tree of part 2' $right
  grep -qF 'lights, l = 1, adaptive' "$folder/said" || complain "adaptive sampling was not tried"
  measure 0 "$right  " $right
  stability 0 'promised: at most' $right
  writeup 0 'draft/index.html' $right
done

# A wrong sphere is told by what knows right ones. The others show what it renders.
copy wrong hit_sphere build/mistakes/hit_sphere/float_arithmetic/hit_sphere.cpp
cheapest 0 './run render scenes/box_spheres.dae -s ' wrong
measure 1 'wrong for' wrong
stability 1 'yours breaks the promise at ' wrong
writeup 0 'draft/index.html' wrong
copy near hit_sphere build/mistakes/hit_sphere/near_root_only/hit_sphere.cpp
measure 1 'wrong for' near

copy broken
echo 'not C++' >>"$folder/broken/3_direct/direct_lights.cpp"
cheapest 1 'the submission cannot be measured: direct_lights' broken
copy half
echo 'not C++' >>"$folder/half/5_adaptive/adaptive_pixel.cpp"
cheapest 0 'adaptive_pixel is not written yet' half

copy crash
in_every_call crash camera_ray '__builtin_trap();'
in_every_call crash hit_sphere '__builtin_trap();'
cheapest 1 'the submission cannot be measured: ' crash
measure 1 'ended without a return' crash
stability 1 '* yours: ' crash
writeup 1 'edge: ' crash
copy endless
in_every_call endless camera_ray 'for (volatile int i = 0;;) i = 1;'
converge 1 'no answer within' endless

# An untouched handout, and a folder that is not there.
cp -r student "$folder/untouched"
cheapest 2 'not written yet: ' untouched
cheapest 2 'does not exist' nobody

finish
