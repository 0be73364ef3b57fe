#!/usr/bin/env bash
# Tests the learners' edition: it builds from nothing, grades with the compiled reference, and says so if the
# reference does not fit. release.sh, which is quicker, looks for lines of solutions in it.
# handout.sh BUILD: it gets BUILD's objects of the reference.
# shellcheck disable=SC2015
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
root=$PWD build=$1 folder="$1/a learner's handout" # CMake and shells have to quote it
# The folder is always the same, and paths do not name it, so that ccache can find what it has compiled before.
export CCACHE_BASEDIR=$folder CCACHE_NOHASHDIR=1

complain() {
  printf '%s\n' "$*"
  exit 1
}

# grades STATUS WORDS [OPTION ...]: checks the exit status and the words of ./run grade there.
grades() {
  local status=$1 words=$2 output got=0
  shift 2
  output=$("$folder/run" grade --no-pictures "$@" 2>&1) || got=$?
  { [ "$got" -eq "$status" ] && grep -qF -- "$words" <<<"$output"; } ||
    complain "grade $* ended with $got, and without '$words':" "$output"
}

rm -rf "$folder"
scripts/editions/handout.sh "$build" "$folder"
if scripts/editions/handout.sh "$build" "$folder" 2>/dev/null; then
  complain "a second handout has been made over the first"
fi
grep -q 'todo(' "$folder/student/1_rays/hit_triangle.cpp" || complain "there are no stubs"
for gone in reference fast tests bench grader/programs/bless.cpp grader/service/classes grader/service/intake/handed_in.cpp \
  grader/tasks/hit_box/mistakes.txt grader/tasks/hit_box/right grader/tasks/trace_path/noisy; do
  [ ! -e "$folder/$gone" ] || complain "$gone is in it"
done

# It is a repository with one commit that has nothing of ours, and ignores the files that ./run makes.
[ "$(git -C "$folder" rev-list --count HEAD)" = 1 ] && [ -z "$(git -C "$folder" status --porcelain)" ] ||
  complain "it is not a repository with one commit"
missing=$(comm -3 <(cd "$folder" && find . -path ./.git -prune -o -type f -printf '%P\n' | sort) <(git -C "$folder" ls-files | sort))
[ -z "$missing" ] || complain "a clone of it lacks what .gitignore keeps out of the first commit:" "$missing"
if grep -raF "$root" "$folder"; then complain "it contains the path where it was made"; fi
# An editor works before anything is built.
bash tests/commands/editors.sh "$folder" || [ $? -eq 77 ] || complain "an editor finds errors in it"

# GitHub and GitLab grade it in the system that it was made for.
bash tests/commands/workflows.sh "$build" "$folder" || [ $? -eq 77 ] || complain "a workflow of the handout fails"
[ "$(cat "$folder"/{.devcontainer/Dockerfile,.github/workflows/grade.yml,.gitlab-ci.yml} | grep -cE "^(FROM| *container:|image:) $(. /etc/os-release && echo "$ID:$VERSION_ID")\$")" = 3 ] ||
  complain "a workflow runs on another system"

# The first command may be the hunt: the compiled solutions judge, and the one that is found is a sentence, not its source.
cp tests/fixtures/examples/good/hit_sphere.examples.cpp "$folder/student/1_rays"
said=$(cd "$folder" && ./run hunt hit_sphere --seed 1 2>&1) || complain "./run hunt says: $said"
grep -q '^Found: it fails ' <<<"$said" && ! grep -q 'Which line' <<<"$said" || complain "./run hunt says: $said"
said=$(cd "$folder" && ./run examples hit_sphere 2>&1) || complain "./run examples says: $said"
grep -q '^The 15 valid examples catch ' <<<"$said" || complain "./run examples says: $said"
git -C "$folder" checkout --quiet student

# The compiled parts are used: only the learner's files have a rule.
grades 1 'not attempted' hit_triangle
if grep -E '^build [^:]*[.]o:' "$folder/build/check/build.ninja" | grep -vE 'student/|recorded/'; then
  complain "more than the learner's files is compiled"
fi
said=$(cd "$folder" && ./run render scenes/box_spheres.dae -f none.png -s 1 -r 16 12 2>&1) || complain "the stubs cannot be rendered: $said"
grep -q '^not written yet: ' <<<"$said" && grep -q '^the picture is black: write estimate_pixel ' <<<"$said" ||
  complain "a render of the stubs says: $said"
(cd "$folder" && ./run render scenes/box_spheres.dae -f reference.exr -s 4 -m 2 -r 64 48 --from reference >/dev/null) ||
  complain "the compiled reference cannot be rendered"
"$build/pt/render" scenes/box_spheres.dae -f "$folder/sources.exr" -s 4 -m 2 -r 64 48 >/dev/null
cmp "$folder/reference.exr" "$folder/sources.exr" || complain "what is compiled renders another picture"
said=$(cd "$folder" && ./run measure hit_sphere --seconds 1 2>&1) || [ $? -eq 1 ] || complain "nothing can be measured: $said"
grep -q '^. reference  *[0-9]' <<<"$said" && grep -q '^  student .*not written yet' <<<"$said" || complain "./run measure says: $said"
said=$(cd "$folder" && ./run writeup normals --quality draft 2>&1) || [ $? -eq 1 ] || complain "./run writeup says: $said"
rm -r "$folder/student/writeup" # the learner's texts, which git sees
said=$(cd "$folder" && ./run writeup normals --quality draft --from reference 2>&1) || complain "./run writeup --from reference says: $said"
said=$(cd "$folder" && ./run cheapest scenes/box_spheres.dae --from reference --error 50% 2>&1) ||
  complain "./run cheapest --from reference says: $said"
# A wrong name of a mistake is refused with those that are here.
said=$(cd "$folder" && ./run render scenes/box_spheres.dae --from reference --from hit_bvh=first 2>&1) && complain "hit_bvh=first is rendered"
said=$(tr -s ' \n' ' ' <<<"$said")
grep -q "no implementation 'first' of the task hit_bvh; there are student, reference, range_overwritten, first_child_that_hits" <<<"$said" ||
  complain "of hit_bvh=first it says: $said"
said=$(cd "$folder" && ./run measure hit_sphere hit_bvh --seconds 1 --from hit_bvh=range_overwritten 2>&1) || [ $? -eq 1 ] || complain "./run measure of a mistake says: $said"
grep -q '^. range_overwritten  *[0-9]' <<<"$said" || complain "./run measure of a mistake says: $said"
# Every command of the handbook works, and makes the picture that stands above it.
python3 tests/commands/handbook.py "$folder" "$build/grader/compare" || complain "a command of the handbook does not do what it says"
rm -f "$folder"/*.{png,exr,html,zip,csv}
git -C "$folder" reset -q --hard "$(git -C "$folder" rev-list --max-parents=0 HEAD)" # it has committed the texts of the write-up
said=$(cd "$folder" && ./run compare scenes/box_spheres.dae -s 1 -r 32 24 2>&1) || complain "./run compare says: $said"
grep -q '^relMSE ' <<<"$said" && grep -q 'A: student, not written yet: ' "$folder/build/compare/box_spheres/index.html" &&
  grep -q 'B: reference' "$folder/build/compare/box_spheres/index.html" || complain "./run compare says: $said"
[ -z "$(git -C "$folder" status --porcelain)" ] || complain "git sees what ./run makes: $(git -C "$folder" status --porcelain)"
cp reference/1_rays/hit_triangle.cpp "$folder/student/1_rays/"
grades 0 'pass' hit_triangle
said=$("$folder/run" grade hit_triangle 2>&1) || complain "with pictures it says: $said"
cp reference/4_global/trace_path.cpp "$folder/student/4_global/"
grades 1 'blocked' trace_path

# On another machine, everything is built from its sources.
sed -i 's/^machine .*/machine Linux other/' "$folder"/{reference-objects,compiled}/stamp
[[ $("$folder/run" grade --no-pictures hit_triangle 2>&1) == *'those in compiled/ were compiled for another machine'* ]] ||
  complain "it does not say why everything is built"
grades 0 'as the reference was compiled for another machine' hit_triangle
said=$("$folder/run" examples hit_sphere 2>&1) && complain "examples are judged without solutions: $said"
[[ $said == *'there are none to judge examples by' ]] || complain "./run examples says: $said"
grades 1 'blocked' trace_path
cp -r reference/* "$folder/student/"
count=$(printf '%s\n' grader/tasks/*/task.json | wc -l)
grades 0 "$count of $count tasks pass"
cd "$folder"
if ./run render scenes/spheres.dae -f none.png --from reference 2>errors; then
  complain "stubs have been rendered as the reference"
fi
grep -q 'there is no reference on this machine' errors || complain "$(cat errors)"
cd "$root"
rm -rf "$folder"
