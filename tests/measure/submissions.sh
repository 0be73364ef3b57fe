#!/usr/bin/env bash
# Somebody else's code through every command that measures it in the box, at small size: what is said, and the exit status. A copy of
# the reference, three other right ones, three wrong, three hostile, and code that does not compile or is missing.
# submissions.sh BUILD few | more: the folder of the programs. `few` are one of each kind, `more` all others.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"
build=$1 which=$2

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
# right NAME TASK.SOLUTION ...: a copy with these right solutions; wrong: with this wrong one.
right() {
  local name=$1 each files=()
  shift
  for each; do files+=("${each%.*}" "grader/tasks/${each%.*}/right/${each#*.}.cpp"); done
  copy "$name" "${files[@]}"
}
wrong() { copy "$1" "${2%.*}" "build/mistakes/${2%.*}/${2#*.}/${2%.*}.cpp"; }
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
converge() { scene converge "$@" -m 2; }
measure() { expect "$1" "$2" "$build/measure/measure" "${4:-hit_sphere.half_b}" --seconds 1 --submission "$folder/$3"; }
stability() {
  expect "$1" "$2" "$build/measure/stability" "${4:-hit_sphere}" --no-methods --coarse --effort .02 --submission "$folder/$3"
}
writeup() {
  expect "$1" "$2" "$build/writeup/writeup" --quality draft edge --submission "$folder/$3" --boxed "$build/measure/writeup_boxed" \
    --accuracy "$build/measure/accuracy_boxed" --generate "$build/scenes/generate" --work "$folder/work" --text writeup/questions
}

# of FEW MORE: the submissions to try now.
of() { if [ "$which" = few ]; then echo "$1"; else echo "$2"; fi; }

copy good
right mixed hit_sphere.textbook trace_path.recursion adaptive_pixel.at_most_for_less
right spread hit_sphere.half_b estimate_pixel.stratified direct_lights.solid_angle build_bvh.median
right plain hit_sphere.textbook hit_bvh.recursive_unordered diffuse_bsdf.uniform direct_hemisphere.stratified
for each in $(of good "mixed spread plain"); do
  cheapest 0 './run render scenes/box_spheres.dae -s ' $each
  grep -qF 'Without a tree, 14 surfaces' "$folder/said" || complain "the engine without a tree was not tried"
  converge 0 'lights, l = 1, the tree of part 2' $each
  grep -qF 'lights, l = 1, adaptive' "$folder/said" || complain "adaptive sampling was not tried"
  measure 0 "$each  " $each
  stability 0 'promised: at most' $each
  writeup 0 'draft/index.html' $each
done

# A wrong sphere is told by what knows right ones. The others show what it renders.
wrong single hit_sphere.float_arithmetic
wrong near hit_sphere.near_root_only
wrong dark trace_path.bsdf_applied_twice
for each in $(of single "near dark"); do
  [ $each != dark ] || converge 0 'fails: off by ' $each --reference
  cheapest 0 './run render scenes/box_spheres.dae -s ' $each
  converge 0 'lights, l = 1, the tree of part 2' $each
  writeup 0 'draft/index.html' $each
done
if [ "$which" = few ]; then
  measure 1 'wrong for' single
  stability 1 'yours breaks the promise at ' single
else
  measure 1 'wrong for' near
  measure 1 'its mean is ' dark trace_path.recursion
  stability 0 'promised: at most' near  # the curves have no ray that starts inside
fi

# Code that crashes, never ends, or ends the program as if all were well.
copy crash
copy endless
copy ends
for each in hit_sphere camera_ray; do
  in_every_call crash $each '__builtin_trap();'
  in_every_call endless $each 'for (volatile int i = 0;;) i = 1;'
  in_every_call ends $each '__builtin_exit(0);'
done
for each in $(of crash "endless ends"); do
  cheapest 1 'the submission cannot be measured: ' $each
  converge 1 'the submission cannot be measured: ' $each
  measure 1 "$each  " $each
  stability 1 '* yours: ' $each
  writeup 1 'edge: ' $each
done

# Several at once, in every place whose they are: a right one, the wrong one of above, and one that crashes.
if [ "$which" = few ]; then
  several=(--submission "$folder/good" --submission "$folder/single" --submission "$folder/crash")
  expect 1 'crash cannot be measured: ' timeout 900 "$build/measure/accuracy_boxed" converge scenes/box_spheres.dae "${several[@]}" \
    --reference --seconds 1 --pixels 300 -r 48 36 -m 2 --out "$folder/beside"
  grep -qE '^ +good +single$' "$folder/said" || complain "no table beside the reference: $(cat "$folder/said")"
  for file in {reference,good,single}.{converge.csv,samples.svg} reference.good.single.beside.{csv,svg,tex} converge.json; do
    case $file in *.svg | *.tex) command -v gnuplot >/dev/null || continue ;; esac
    [ -s "$folder/beside/$file" ] || complain "no $file"
  done
  expect 1 'single  ' "$build/measure/measure" hit_sphere.half_b --seconds 1 "${several[@]}"
  grep -qE '^  crash +[a-z]' "$folder/said" || complain "no line of the code that crashes: $(cat "$folder/said")"
  grep -qE '^. good +[0-9]' "$folder/said" || complain "no line of the right code: $(cat "$folder/said")"
  expect 2 'cheapest takes one --submission' "$build/measure/accuracy_boxed" cheapest scenes/box_spheres.dae "${several[@]}"
  expect 2 'at most 4 can be compared' "$build/measure/measure" hit_sphere "${several[@]}" "${several[@]}"
fi

[ "$which" = few ] || finish
copy broken
echo 'not C++' >>"$folder/broken/3_direct/direct_lights.cpp"
cheapest 1 'the submission cannot be measured: direct_lights' broken
copy half
echo 'not C++' >>"$folder/half/5_adaptive/adaptive_pixel.cpp"
cheapest 0 'adaptive_pixel is not written yet' half

# An untouched handout, and a folder that is not there.
cp -r student "$folder/untouched"
cheapest 2 'not written yet: ' untouched
cheapest 2 'does not exist' nobody

finish
