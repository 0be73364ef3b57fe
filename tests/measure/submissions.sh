#!/usr/bin/env bash
# The needs of a scene, measured for a submission in the box: the same as by the program that links it. Code
# that does not compile, crashes, never ends or is missing gives a sentence.
# accuracy_boxed.sh BUILD: the folder of the programs.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"
program=$1/measure/accuracy_boxed

# measure STATUS WORDS COMMAND SUBMISSION ...: it ends with the status and prints the words.
measure() {
  local status=$1 words=$2 command=$3 submission=$4 got=0
  shift 4
  timeout 900 "$program" "$command" scenes/box_spheres.dae --submission "$submission" --seconds 2 --pixels 300 -r 48 36 "$@" \
    >"$folder/said" 2>&1 || got=$?
  { [ "$got" -eq "$status" ] && grep -qF -- "$words" "$folder/said"; } ||
    complain "$command of $submission ended with $got, and without '$words': $(tail -5 "$folder/said")"
}
# copy NAME: the reference, as somebody would hand it in.
copy() { cp -r reference "$folder/$1"; }

copy good
measure 0 './run render scenes/box_spheres.dae -s ' cheapest "$folder/good" --error 10%
grep -qF 'Without a tree, 14 surfaces' "$folder/said" || complain "the engine without a tree was not tried"
measure 0 'lights, l = 1, the tree of part 2' converge "$folder/good" -m 2
grep -qF 'lights, l = 1, adaptive' "$folder/said" || complain "adaptive sampling was not tried"

copy broken
echo 'not C++' >>"$folder/broken/3_direct/direct_lights.cpp"
measure 1 'the submission cannot be measured: direct_lights' cheapest "$folder/broken"
copy half
echo 'not C++' >>"$folder/half/5_adaptive/adaptive_pixel.cpp"
measure 0 'adaptive_pixel is not written yet' cheapest "$folder/half" --error 10%
# in_every_call FOLDER TASK WORDS: adds the words at the beginning of the function's body.
in_every_call() { sed -i "0,/^[a-zA-Z:]* $2(.*{\$/s//&\n  $3/" "$folder/$1/"*"/$2.cpp"; }
copy crash
in_every_call crash camera_ray '__builtin_trap();'
measure 1 'the submission cannot be measured: ' cheapest "$folder/crash"
copy endless
in_every_call endless camera_ray 'for (volatile int i = 0;;) i = 1;'
measure 1 'no answer within' converge "$folder/endless"
measure 2 'not written yet: ' cheapest student
measure 2 'does not exist' cheapest "$folder/nobody"

finish
