#!/usr/bin/env bash
# The learners' edition: it has no line of a solution, builds from nothing, grades with the compiled
# reference, and says so where that does not fit.
# handout.sh BUILD: whose objects of the reference it gets.
# shellcheck disable=SC2015
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD build=$1 folder="$1/a learner's handout" # CMake and shells have to quote it
# Always in one place, and by paths that do not name it: then ccache knows what it has compiled before.
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
grader/editions/handout.sh "$build" "$folder"
if grader/editions/handout.sh "$build" "$folder" 2>/dev/null; then
  complain "a second handout has been made over the first"
fi
grep -q 'todo(' "$folder/student/1_rays/hit_triangle.cpp" || complain "there are no stubs"
for gone in reference fast tests bench grader/self_check grader/programs/bless.cpp grader/programs/grade_class \
  grader/tasks/hit_box/wrong grader/tasks/hit_box/right grader/tasks/trace_path/noisy; do
  [ ! -e "$folder/$gone" ] || complain "$gone is in it"
done

# A repository with one commit that has nothing of ours, and ignores what ./run makes.
[ "$(git -C "$folder" rev-list --count HEAD)" = 1 ] && [ -z "$(git -C "$folder" status --porcelain)" ] ||
  complain "it is not a repository with one commit"
missing=$(comm -3 <(cd "$folder" && find . -path ./.git -prune -o -type f -printf '%P\n' | sort) <(git -C "$folder" ls-files | sort))
[ -z "$missing" ] || complain "a clone of it lacks what .gitignore keeps out of the first commit:" "$missing"
if grep -raF "$root" "$folder"; then complain "it tells where it was made"; fi
# An editor is right before anything is built.
bash tests/editors.sh "$folder" || [ $? -eq 77 ] || complain "an editor finds errors in it"

# Long lines of the reference that are in no file for learners.
lines=$(mktemp)
trap 'rm -f "$lines"' EXIT
trimmed() { cat "$@" | sed 's/^ *//; s/ *$//' | sort -u; }
mapfile -t open < <(find student pt -name '*.cpp' -o -name '*.h' -o -name '*.md')
comm -23 <(trimmed {reference,fast}/*/*.cpp fast/*/*.h) <(trimmed "${open[@]}") | grep -E '.{41}' >"$lines"
[ "$(wc -l <"$lines")" -gt 100 ] || complain "the reference has hardly any lines: this looks for nothing"
if grep -raFf "$lines" "$folder"; then complain "it has lines of the reference"; fi
if nm "$folder"/reference-objects/*.o | grep -i ' [tbdr] .*_GLOBAL__N_'; then
  complain "the objects name what is local to the reference"
fi

# The compiled parts are used: nothing but the learner's files has a rule.
grades 1 'not attempted' hit_triangle
if grep -E '^build [^:]*[.]o:' "$folder/build/check/build.ninja" | grep -vE 'student/|writeup/|counted/|taped/'; then
  complain "more than the learner's files is compiled"
fi
said=$(cd "$folder" && ./run render scenes/box_spheres.dae -f none.png -s 1 -r 16 12 2>&1) || complain "the stubs cannot be rendered: $said"
grep -q '^not written yet: ' <<<"$said" || complain "a render of the stubs says: $said"
(cd "$folder" && ./run render scenes/box_spheres.dae -f reference.exr -s 4 -m 2 -r 64 48 --from reference >/dev/null) ||
  complain "the compiled reference cannot be rendered"
"$build/pt/render" scenes/box_spheres.dae -f "$folder/sources.exr" -s 4 -m 2 -r 64 48 >/dev/null
cmp "$folder/reference.exr" "$folder/sources.exr" || complain "what is compiled renders another picture"
said=$(cd "$folder" && ./run measure hit_sphere --seconds 1 2>&1) || complain "nothing can be measured: $said"
grep -q '^. reference  *[0-9]' <<<"$said" && grep -q '^  student .*not written yet' <<<"$said" || complain "./run measure says: $said"
[ -z "$(git -C "$folder" status --porcelain)" ] || complain "git sees what ./run makes: $(git -C "$folder" status --porcelain)"
cp reference/1_rays/hit_triangle.cpp "$folder/student/1_rays/"
grades 0 'pass' hit_triangle
said=$("$folder/run" grade hit_triangle 2>&1) || complain "with pictures it says: $said"
cp reference/4_global/trace_path.cpp "$folder/student/4_global/"
grades 1 'blocked' trace_path

# Another machine: everything is built from its sources.
sed -i 's/^machine .*/machine Linux other/' "$folder"/{reference-objects,compiled}/stamp
[[ $("$folder/run" grade --no-pictures hit_triangle 2>&1) == *'those in compiled/ were compiled for another machine'* ]] ||
  complain "it does not say why everything is built"
grades 0 'as the reference was compiled for another machine' hit_triangle
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
