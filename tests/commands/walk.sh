#!/usr/bin/env bash
# Walks what README promises, each command once, on a small input: rendering, grading alone and together with pictures, hints, a
# class, the settings that a scene needs, the time of a call. ./run builds these programs, and starts them with the same words.
# walk.sh BUILD: whose programs are walked.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"
build=$1

expect 0 '' "$build/pt/render" scenes/box_spheres.dae -s 1 -m 2 -r 48 36 -f "$folder/one.png"
expect 0 '' "$build/pt/compare" "$folder/one.png" "$folder/one.png"

# A submission that is right but for one task, and has not written another one.
cp -r reference "$folder/good"
mkdir "$folder/mixed"
cp -r reference/. "$folder/mixed"
cp build/mistakes/hit_triangle/absolute_offset/hit_triangle.cpp "$folder/mixed/1_rays"
cp student/5_adaptive/adaptive_pixel.cpp "$folder/mixed/5_adaptive"
sed "s#^ \"work\": .*# \"work\": \"$folder/work\",#" "$build/grader/grade.json" >"$folder/grade.json"
grade=("$build/grader/grade" --config "$folder/grade.json")
expect 0 'trace_path' "${grade[@]}" --submission "$folder/good" --html "$folder/page.html" --json "$folder/results.json"
grep -q '"complete": *true' "$folder/results.json" || complain 'results.json is not complete'
expect 1 'expected  a hit' "${grade[@]}" hit_triangle adaptive_pixel --no-pictures --submission "$folder/mixed"
expect 0 '?' "$build/grader/hint" --config "$folder/grade.json" hit_triangle

mkdir -p "$folder/class/ada" "$folder/class/bob"
cp reference/1_rays/hit_sphere.cpp "$folder/class/ada"
cp student/1_rays/hit_sphere.cpp "$folder/class/bob"
expect 0 'bob' "$build/grader/grade_class" "$folder/class" --out "$folder/out" --seed 7 --not-isolated -- hit_sphere --no-pictures

small=(scenes/box_spheres.dae --seconds 1 --pixels 300 -r 48 36)
expect 0 './run render scenes/box_spheres.dae -s ' "$build/measure/accuracy_boxed" cheapest "${small[@]}" --error 10% --submission "$folder/good"
expect 0 'hit_box' "$build/measure/measure" hit_box --seconds 1 --submission "$folder/good" --out "$folder/measured"

finish
