#!/usr/bin/env bash
# Examples that are handed in by a class earn points where grader/points.json gives them, and none elsewhere. One of the class has good
# examples and no task yet, one has weak, wrong and strict ones, one has some that do not compile, one has none.
# class.sh BUILD: whose programs grade.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../fixtures/shell.sh"
files=tests/fixtures/examples

# The project with other points.
mkdir -p "$folder/root/grader"
ln -s "$PWD"/* "$folder/root" 2>/dev/null || true
ln -s "$PWD"/grader/* "$folder/root/grader"
rm "$folder/root/grader/points.json"
sed 's/"tasks": {}/"tasks": {"hit_sphere": {"examples": 2}}/' grader/points.json >"$folder/root/grader/points.json"
mkdir "$folder/grader"
ln -s "$1"/grader/* "$folder/grader"
for program in grade.json grade grade_examples; do # programs look for others next to them, and not next to a link
  rm "$folder/grader/$program"
  cp "$1/grader/$program" "$folder/grader"
done
sed "s#^ \"root\": .*# \"root\": \"$folder/root\",#; s#^ \"work\": .*# \"work\": \"$folder/work\",#" "$1/grader/grade.json" \
  >"$folder/grader/grade.json"

for name in ada bob cem dag; do
  mkdir -p "$folder/class/$name/1_rays"
  cp reference/1_rays/hit_sphere.cpp "$folder/class/$name/1_rays"
done
cp student/1_rays/hit_sphere.cpp "$folder/class/ada/1_rays"
cp $files/good/hit_sphere.examples.cpp "$folder/class/ada/1_rays"
cp $files/mixed/hit_sphere.examples.cpp "$folder/class/bob/1_rays"
echo 'this is not C++' >"$folder/class/cem/1_rays/hit_sphere.examples.cpp"

expect 0 'ada' "$1/grader/grade_class" "$folder/class" --out "$folder/out" --seed 7 --not-isolated \
  --config "$folder/grader/grade.json" -- hit_sphere --no-pictures
# bonus_of NAME: the bonus points in the table of the class.
bonus_of() { awk -F, -v "name=$1" '$1 == name { print $7 }' "$folder/out/class.csv"; }
promises=$(grep -c '"name": *"examples:' "$folder/out/ada.json") || true
[ "$promises" -ge 5 ] || complain "ada has $promises rows of examples"
[ "$(bonus_of ada)" -eq $((2 * promises)) ] || complain "good examples of $promises promises earn $(bonus_of ada)"
for name in cem dag; do
  ! grep -q '"examples:' "$folder/out/$name.json" || complain "$name has points for examples"
done
weak=$(($(bonus_of bob) - $(bonus_of dag)))
{ [ "$weak" -ge 0 ] && [ "$weak" -lt "$promises" ]; } || complain "weak examples earn $weak"
grep -q 'Mistakes that examples do not catch' "$folder/out/class.html" || complain 'class.html has no table of examples'
grep -q '>1 of 2</td><td><code>hit_sphere</code></td><td>examples catch what breaks' "$folder/out/class.html" || complain 'nobody is counted'
grep -q 'wrong solutions caught' "$folder/out/bob.html" || complain 'the page does not say how many are caught'
finish
