#!/usr/bin/env bash
# Learners' examples get what they deserve: good, weak, wrong, strict and hostile ones of hit_sphere, and examples by which the
# learner's own function is judged. README names the command.
# examples.sh BUILD: whose programs judge.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../fixtures/shell.sh"
judge=$1/grader/grade_examples
files=tests/fixtures/examples

# says WORDS ...: the last command said each of these.
says() {
  local words
  for words in "$@"; do grep -qF -- "$words" "$folder/said" || complain "without '$words': $(cat "$folder/said")"; done
}
# caught: how many of the ordinary mistakes the last command caught: 3 of 18.
caught() { sed -nE 's/^The .*valid examples? catch(es)? ([0-9]+ of [0-9]+) wrong.*/\2/p' "$folder/said"; }

expect 0 '15 examples, held against' "$judge" hit_sphere --submission $files/good
[ "$(grep -c '^  valid ' "$folder/said")" -eq 15 ] || complain "an example that follows from the contract is not valid: $(cat "$folder/said")"
good=$(caught)
expect 0 'No example of yours looks at "finds the near side":' "$judge" 1.4 --submission $files/weak
says 'How many points does a line have in common with a sphere'
weak=$(caught)
{ [ "${good% of*}" -eq "${good#*of }" ] && [ "${good% of*}" -gt 15 ] && [ "${weak% of*}" -le 3 ]; } ||
  complain "of the ordinary mistakes good examples catch $good, weak ones $weak"
expect 1 '  wrong       t is a distance: no right solution agrees: hit->t is 1, where you expect 2' "$judge" hit_sphere --submission $files/wrong
says '  wrong       seen from inside' '  valid       right' '  empty       to be written' 'The valid example catches'
expect 1 '  too strict  touching is a miss' "$judge" hit_sphere --submission $files/strict
says '  too strict  the last bit' 'the contract leaves it open' 'both are' 'No example is valid yet'

expect 1 '  wrong       loops: no right solution agrees: it does not end' "$judge" hit_sphere --submission $files/hostile
says '  wrong       crashes' '  wrong       exits' '  wrong       aborts' '  wrong       throws' 'an exception ended it: words <>' \
  'an exception ended it: input <-1>' '  wrong       prints a verdict' '  unsteady    fails by chance' 'The valid example catches 1 of'

# Files that are not accepted, and the learner's own function.
for line in $'#include <unistd.h>\nEXAMPLE("forks") { EXPECT(fork() >= 0); }' 'namespace pt { std::optional<SurfaceHit> hit_sphere(const Sphere&, const Ray&) { return {}; } }' \
  '__attribute__((constructor(101))) void early() {}' 'EXAMPLE("no such function") { EXPECT(nothing()); }'; do
  { cat $files/weak/hit_sphere.examples.cpp; echo "$line"; } >"$folder/hit_sphere.examples.cpp"
  expect 1 'does not compile' "$judge" hit_sphere --submission "$folder"
done
echo '#include "pt/examples/example.h"' >"$folder/hit_sphere.examples.cpp"
expect 1 'it has no EXAMPLE' "$judge" hit_sphere --submission "$folder"
{ cat $files/weak/hit_sphere.examples.cpp; echo 'static const int early = [] { std::abort(); return 1; }();'; } >"$folder/hit_sphere.examples.cpp"
expect 1 'it ends before its first example' "$judge" hit_sphere --submission "$folder"
expect 2 'is missing: write your examples there' "$judge" hit_box --submission "$folder"
expect 2 'is not a task' "$judge" hit_cone --submission "$folder"
cp $files/good/hit_sphere.examples.cpp "$folder"
cp student/1_rays/hit_sphere.cpp "$folder"
expect 0 'Your own hit_sphere is not written yet.' "$judge" hit_sphere --submission "$folder"
cp build/mistakes/hit_sphere/normal_inwards/hit_sphere.cpp "$folder"
expect 1 'Your own hit_sphere fails 7 of your 15 valid examples' "$judge" hit_sphere --submission "$folder"
cp reference/1_rays/hit_sphere.cpp "$folder"
expect 0 'Your own hit_sphere passes your 15 valid examples.' "$judge" hit_sphere --submission "$folder"

# The hunt: good examples find each of the wrong solutions that a seed chooses, weak ones do not find those that only they find.
"$judge" hit_sphere --hunt --seed 1 --submission $files/weak >"$folder/first" && complain "weak examples find solution 1"
"$judge" hit_sphere --hunt --seed 1 --submission $files/weak >"$folder/again" || diff "$folder/first" "$folder/again" || complain 'a seed is not enough'
for seed in 1 2 3 4; do
  expect 0 'Found: it fails "' "$judge" hit_sphere --hunt --seed $seed --submission $files/good
  says 'Which line is wrong?' 'std::optional<SurfaceHit> hit_sphere'
  grep -q '^> ' "$folder/said" && complain "seed $seed: the line is marked before it is looked for"
  sed -n 's/^Found: .*because //p' "$folder/said" >>"$folder/reasons"
  expect 0 'Found: it fails "' "$judge" hit_sphere --hunt --show --seed $seed --submission $files/good
  [ "$(grep -c '^> ' "$folder/said")" -le 3 ] || complain "seed $seed: more than the wrong lines are marked"
done
[ "$(sort -u "$folder/reasons" | wc -l)" -gt 1 ] || complain 'all seeds choose the same solution'
expect 1 'agrees with all valid examples' "$judge" hit_sphere --hunt --seed 1 --submission $files/weak
expect 1 'no right solution agrees' "$judge" hit_sphere --hunt --seed 1 --submission $files/wrong

# Every stub has an example that is valid.
expect 0 '  valid       ' ./run examples hit_sphere
finish
