#!/usr/bin/env bash
# What ./run examples and ./run hunt say of examples of hit_sphere: weak, wrong, strict, hostile and empty ones, files that are not
# accepted, and examples by which the learner's own function is judged. README names the command.
# examples.sh BUILD: whose programs judge.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../fixtures/shell.sh"
judge=$1/grader/grade_examples
files=tests/fixtures/examples
# Weak examples: the mixed ones without the wrong and the strict ones.
mkdir "$folder/weak"
sed '/^EXAMPLE("wrong/,$d' $files/mixed/hit_sphere.examples.cpp >"$folder/weak/hit_sphere.examples.cpp"

# says WORDS ...: the last command said each of these.
says() {
  local words
  for words in "$@"; do grep -qF -- "$words" "$folder/said" || complain "without '$words': $(cat "$folder/said")"; done
}

expect 0 'No example of yours looks at "finds the near side":' "$judge" 1.4 --submission "$folder/weak"
says 'How many points does a line have in common with a sphere'
expect 1 '  wrong       wrong: t is a distance: no right solution agrees: hit_sphere(unit, {{0, 0, 3}, {0, 0, -2}})->t is 1, where you expect 2' \
  "$judge" hit_sphere --submission $files/mixed
says '  too strict  strict: touching is a miss: ' 'the contract leaves it open' 'both are' \
  'need not keep "stays accurate at any distance (bonus)"' 'The valid example catches 3 of'

expect 1 '  wrong       loops: no right solution agrees: it does not end' "$judge" hit_sphere --submission $files/hostile
says '  wrong       crashes' '  wrong       exits' '  wrong       aborts' '  wrong       throws' 'an exception ended it: words <>' \
  'an exception ended it: input <-1>' '  wrong       prints a verdict' '  unsteady    fails by chance' 'The valid example catches 2 of'

# Files that are not accepted, and the learner's own function.
for line in $'#include <unistd.h>\nEXAMPLE("forks") { EXPECT(fork() >= 0); }' 'namespace pt { std::optional<SurfaceHit> hit_sphere(const Sphere&, const Ray&) { return {}; } }' \
  '__attribute__((constructor(101))) void early() {}' 'EXAMPLE("no such function") { EXPECT(nothing()); }'; do
  { cat "$folder/weak/hit_sphere.examples.cpp"; echo "$line"; } >"$folder/hit_sphere.examples.cpp"
  expect 1 'does not compile' "$judge" hit_sphere --submission "$folder"
done
echo '#include "pt/examples/example.h"' >"$folder/hit_sphere.examples.cpp"
expect 1 'it has no EXAMPLE' "$judge" hit_sphere --submission "$folder"
echo 'EXAMPLE("never") { EXPECT(false); }' >>"$folder/hit_sphere.examples.cpp"
expect 1 'No example is valid yet, so none is tried' "$judge" hit_sphere --submission "$folder"
{ cat "$folder/weak/hit_sphere.examples.cpp"; echo 'static const int early = [] { std::abort(); return 1; }();'; } >"$folder/hit_sphere.examples.cpp"
expect 1 'it ends before its first example' "$judge" hit_sphere --submission "$folder"
expect 2 'is missing: write your examples there' "$judge" hit_box --submission "$folder"
expect 2 'is not a task' "$judge" hit_cone --submission "$folder"
cp $files/good/hit_sphere.examples.cpp "$folder"
cp build/mistakes/hit_sphere/normal_inwards/hit_sphere.cpp "$folder"
expect 1 'Your own hit_sphere fails 7 of your 15 valid examples' "$judge" hit_sphere --submission "$folder"
cp reference/1_rays/hit_sphere.cpp "$folder"
expect 0 'Your own hit_sphere passes your 15 valid examples.' "$judge" hit_sphere --submission "$folder"
says '15 examples, held against' 'that only rare inputs show'
grep -qE '^The 15 valid examples catch ([0-9]+) of \1 wrong solutions' "$folder/said" || complain 'good examples do not catch all ordinary mistakes'

# The hunt: good examples find each of the wrong solutions that a seed chooses, weak ones do not find those that only they find.
"$judge" hit_sphere --hunt --seed 2 --submission "$folder/weak" >"$folder/first" && complain "weak examples find solution 2"
"$judge" hit_sphere --hunt --seed 2 --submission "$folder/weak" >"$folder/again" || diff "$folder/first" "$folder/again" || complain 'a seed is not enough'
for seed in 1 2 3 4; do
  expect 0 'Found: it fails "' "$judge" hit_sphere --hunt --seed $seed --submission $files/good
  says 'Which line is wrong?' 'std::optional<SurfaceHit> hit_sphere'
  grep -q '^> ' "$folder/said" && complain "seed $seed: the line is marked before it is looked for"
  sed -n 's/^Found: .*because //p' "$folder/said" >>"$folder/reasons"
  expect 0 'Found: it fails "' "$judge" hit_sphere --hunt --show --seed $seed --submission $files/good
  [ "$(grep -c '^> ' "$folder/said")" -le 3 ] || complain "seed $seed: more than the wrong lines are marked"
done
[ "$(sort -u "$folder/reasons" | wc -l)" -gt 1 ] || complain 'all seeds choose the same solution'
expect 1 'agrees with all valid examples' "$judge" hit_sphere --hunt --seed 2 --submission "$folder/weak"
expect 1 'no right solution agrees' "$judge" hit_sphere --hunt --seed 2 --submission $files/mixed

# Every stub has an example that is valid.
expect 0 '  valid       ' ./run examples hit_sphere
says '  empty       ' 'Your own hit_sphere is not written yet.'
finish
