#!/usr/bin/env bash
# ./run stability: a textbook's sphere leaves the reference's line, and code that hangs, crashes or
# does not compile gives a place of the curve or a sentence, and never ends the run.
# stability.sh STABILITY: the program.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"
stability=$1

# shown STATUS WORDS...: sets $said to the output.
shown() {
  local expected=$1 got=0
  shift
  said=$("$stability" "$@" --no-variants --effort .05 2>&1) || got=$?
  [ "$got" -eq "$expected" ] || complain "stability $* ended with $got:" "$said"
}

# says WORDS: they are in $said.
says() { grep -qF -- "$1" <<<"$said" || complain "it does not say '$1':" "$said"; }

# error FILE LINE PLACE: the error in the CSV.
error() { awk -F, -v line="$2" -v place="$3" '$1 == line && $2 == place { print $3 }' "$1"; }

# larger A B: A is larger than B.
larger() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a != "" && b != "" && a + 0 > b + 0) }'; }

mkdir -p "$folder/mine/1_rays" "$folder/right/1_rays"
cp grader/tasks/hit_sphere/right/textbook.cpp "$folder/mine/1_rays/hit_sphere.cpp"
cp grader/tasks/hit_sphere/right/textbook.cpp "$folder/right/1_rays/hit_sphere.cpp"
shown 0 hit_sphere --submission "$folder/mine" --out "$folder/out"
csv=$folder/out/hit_sphere.far_away.csv
larger 1e-9 "$(error "$csv" yours 10)" || complain "a textbook's sphere is wrong at ten radii:" "$(cat "$csv")"
larger 1e-3 "$(error "$csv" yours 1e+06)" || complain "a textbook's sphere is wrong at 1e6 radii:" "$(cat "$csv")"
larger "$(error "$csv" yours 1e+07)" 1e-3 || complain "a textbook's sphere is right at 1e7 radii:" "$(cat "$csv")"
larger 1e-6 "$(error "$csv" reference 1e+07)" || complain "the reference is wrong at 1e7 radii:" "$(cat "$csv")"
! command -v gnuplot >/dev/null || [ -s "$folder/out/hit_sphere.far_away.svg" ] || complain "there is no chart"

# Beyond a million radii, this code gives no answer, never ends, or returns no number.
for how in '__builtin_trap();' 'for (volatile int i = 0;; i = 0) { }' \
  'return SurfaceHit{0.0 / (ray.origin.x - ray.origin.x), {0, 0, 1}};'; do
  sed "s|^  const Vec3 oc.*|&\n  if (length(oc) > 1e6 * sphere.radius) { $how }|; t; s|^  const Vec3 m = .*|&|" \
    grader/tasks/hit_sphere/right/half_b.cpp >"$folder/mine/1_rays/hit_sphere.cpp"
  grep -qF 'length(oc)' "$folder/mine/1_rays/hit_sphere.cpp" || complain "the solution has another form now"
  shown 1 hit_sphere --submission "$folder/mine" --out "$folder/out"
  [ -n "$(error "$csv" yours 1000)" ] && [ -z "$(error "$csv" yours 1e+08)" ] ||
    complain "with $how, places have the wrong numbers:" "$(cat "$csv")"
  says '* yours: '
done

# A search sees a missing answer at once, and continues where it stopped.
shown 0 hit_sphere --submission "$folder/mine" --search --minutes .01
says 'broken: '
before=$(grep -o '[0-9]* inputs in' <<<"$said" | head -1)
shown 0 hit_sphere --submission "$folder/mine" --search --minutes .01
[ "$(grep -o '[0-9]* inputs in' <<<"$said" | head -1 | tr -dc 0-9)" -gt "$(tr -dc 0-9 <<<"$before")" ] ||
  complain "a second search did not go on:" "$before" "$said"
# The reference is searched in this program itself.
shown 0 hit_bvh --search --minutes .01
says 'hit_bvh: '
says ' inputs in '

# A broken promise is named with its place. The reference keeps all promises.
shown 0 hit_sphere --submission "$folder/right"
says 'yours breaks the promise of the bonus at '
! grep -q 'yours breaks the promise at' <<<"$said" || complain "a textbook's sphere breaks a promise:" "$said"
cp build/mistakes/hit_sphere/float_arithmetic/hit_sphere.cpp "$folder/right/1_rays/hit_sphere.cpp"
shown 1 hit_sphere --submission "$folder/right"
says 'yours breaks the promise at '
"$stability" --no-methods --coarse --effort .3 >"$folder/reference"
! grep 'reference breaks the promise at' "$folder/reference" || complain "the reference breaks a promise"
grep -qF '  promised: ' "$folder/reference" && grep -qF '  promised by a bonus: ' "$folder/reference" ||
  complain "no promise is shown:" "$(cat "$folder/reference")"

echo 'int' >"$folder/mine/1_rays/hit_sphere.cpp"
shown 1 hit_sphere --submission "$folder/mine"
says 'yours is not measured: '
rm "$folder/mine/1_rays/hit_sphere.cpp"
shown 1 hit_sphere --submission "$folder/mine"
says 'there is no 1_rays/hit_sphere.cpp'
shown 2 hit_spheres
shown 2 hit_sphere --submission "$folder/nowhere"
finish
