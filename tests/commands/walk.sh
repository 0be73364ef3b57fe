#!/usr/bin/env bash
# Walks what README and docs/commands.md promise, each command once, on a small input: rendering, grading alone and together with
# pictures, the view, hints, a class. What measures is walked by tests/measure/submissions.sh. ./run builds these programs, and
# starts them with the same words. Every render that a page names is walked with its own options, on a few pixels.
# walk.sh BUILD: whose programs are walked.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"
build=$1

# What README and docs/commands.md name is a command of ./run, the help names it on docs/commands.md, and a line below or another
# test walks it.
walked=' render export judge view compare grade hint grade-class '
elsewhere=' watch debug examples hunt submit writeup cheapest measure converge ladder stability mesh bench handout release autograder test lint format tidy bless help convert site --version '
named() { grep -ohE '\./run [a-z-]+' "$@" | cut -d' ' -f2 | sort -u; }
for command in $(named README.md docs/commands.md); do
  case $walked$elsewhere in *" $command "*) ;; *) complain "$command is on a page, and nothing walks it" ;; esac
done
./run help >"$folder/help"
missing=$(comm -23 <(named "$folder/help") <(named docs/commands.md))
[ -z "$missing" ] || complain "docs/commands.md has no line for:" $missing

renders=0
while IFS= read -r words; do
  # The programs are built already, pictures are small, and adaptive sampling needs a batch.
  words=$(sed -E 's/ --from [^ ]+//g; s/ -r [0-9]+ [0-9]+//; s/ -s [0-9]+//; s#(-f|--resume) ([^ ]+)#\1 '"$folder"'/\2#' <<<"$words")
  case $words in *' -a '*) words+=' -s 32 -r 4 3' ;; *) words+=' -s 1 -r 16 12' ;; esac
  # shellcheck disable=SC2086
  expect 0 '' "$build/pt/render" $words
  renders=$((renders + 1))
done < <(sed -nE 's/ +# .*//; s/^    \.\/run render (scenes\/.*)$/\1/p; s/.*`\.\/run render (scenes\/[^`]*)`.*/\1/p' README.md docs/rendering.md student/*.md student/*/README.md | sort -u)
[ "$renders" -ge 30 ] || complain "the pages have only $renders renders"
expect 0 '' "$build/grader/compare" "$folder/box.png" "$folder/box.png"
"$build/pt/render" scenes/box_spheres.dae --camera file -r 32 24 -s 4 --seed 7 -f "$folder/one.png" >/dev/null
expect 0 'would have been called wrong' "$build/grader/compare_picture" "$folder/one.png" scenes/box_spheres.dae --camera file -s 4
expect 0 'scene.pbrt' "$build/pt/export" scenes/box_spheres.dae --to pbrt "$folder/pbrt"
expect 0 'agrees' "$build/grader/judge" scenes/large_light.dae -r 24 18 -m 1 --work "$folder/judge" -- "$build/pt/render" {scene} --camera file -r {width} {height} -s {samples} \
  -m {depth} --seed {seed} -f {out}
expect 0 'page.html' "$build/view/view" --worker "$build/view/view_worker.reference" scenes/box_spheres.dae -r 48 36 -s 2 \
  --pixel 24 9 --export "$folder/page.html"
grep -q '"same":true' "$folder/page.html" || complain 'the parts of a path do not add up to its light'

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
# What `./run --version` prints is in the text, the page, the results, and, below, in the row of a class.
version=$(./run --version)
[[ $version == 'Firstlight '[0-9]*.[0-9]*.[0-9]* ]] || complain "the version is '$version'"
grep -qF ". $version." "$folder/said" || complain "the text of a report does not end with $version: $(tail -1 "$folder/said")"
for file in page.html results.json; do grep -qF "$version" "$folder/$file" || complain "$file has no $version"; done
expect 1 'expected  a hit' "${grade[@]}" hit_triangle adaptive_pixel --no-pictures --submission "$folder/mixed"
expect 0 '?' "$build/grader/hint" --root . --work "$folder/work" hit_triangle

# ./run grade TASK --from student --sanitize: of the program, the learner's file alone is under sanitizers.
expect 1 'hit_sphere' "$build/grader/check.hit_sphere.sanitized" --gtest_brief=1
nm "$build/grader/check.hit_sphere.sanitized" | grep -c 'U __asan' >/dev/null || complain 'no sanitizer is in it'

mkdir -p "$folder/class/ada" "$folder/class/bob"
cp reference/1_rays/hit_sphere.cpp "$folder/class/ada"
cp student/1_rays/hit_sphere.cpp "$folder/class/bob"
expect 0 'bob' "$build/grader/grade_class" "$folder/class" --out "$folder/out" --seed 7 --not-isolated -- hit_sphere --no-pictures
[ "$(grep -c ",$version"$'\r$' "$folder/out/class.csv")" -eq 2 ] || complain "class.csv has no $version: $(cat "$folder/out/class.csv")"

finish
