#!/usr/bin/env bash
# Checks that ./run refuses wrong arguments before it builds anything: status 2, and one sentence.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"

# refuses SENTENCE WORD ...: tests that ./run WORD ... fails with this sentence.
refuses() {
  local sentence=$1 said status=0
  shift
  said=$(timeout 20 ./run "$@" 2>&1 >/dev/null </dev/null) || status=$?
  case $status:$said in
    2:*"$sentence"*) [ "$(wc -l <<<"$said")" -eq 1 ] && return ;;
  esac
  printf './run %s: status %s, and says: %s\n' "$*" "$status" "$said"
  failures=$((failures + 1))
}

refuses "'hit_me 7' is unknown: write tasks like hit_triangle" grade hit_me 7 --from student
refuses "'1.3 7' is unknown: write tasks like hit_triangle" grade 1.3 7 --from=reference
refuses "--from takes student or reference" grade hit_triangle --from
refuses "--from takes student or reference" grade --from theirs hit_triangle
refuses "--seed takes a whole number" grade hit_triangle --from student --seed one
refuses "--coverage counts how often the lines of your own files run" grade hit_triangle --from reference --coverage
refuses "--html cannot be used with --from" grade hit_triangle --from student --html page.html
refuses "there is no 'nosuch'; ./run help lists the commands" nosuch
refuses "the long tests take no options, but '--list' is one" test --long --list
refuses "say which task" debug
refuses "'hit_me' is not a task" debug hit_me
# Where there is no Linux, learners' code is tested without a box, and the commands that judge are not there.
mkdir "$folder/other_system"
printf '#!/bin/sh\necho Darwin\n' >"$folder/other_system/uname"
chmod +x "$folder/other_system/uname"
for command in submit stability "grade-class docs"; do
  # shellcheck disable=SC2086
  PATH=$folder/other_system:$PATH refuses "'${command% *}' needs Linux, or a container" $command
done
PATH=$folder/other_system:$PATH refuses "--submission needs Linux, or a container" view scenes/box_spheres.dae --submission student
PATH=$folder/other_system:$PATH refuses "without Linux, watch takes no options" watch hit_sphere
# A task is tested there when its file is saved, and nothing when another file is.
mkdir -p "$folder/saved/student/1_rays" "$folder/saved/pt/tasks"
touch "$folder/saved/student/1_rays/"{hit_sphere,hit_box,notes}.cpp "$folder/saved/pt/tasks/"{hit_sphere,hit_box}.h
(
  eval "$(sed -nE '/^watch_here\(\) \{/,/^\}/p' run)"
  root=$folder/saved turn=0
  sleep() {
    turn=$((turn + 1))
    [ "$turn" -gt 2 ] || echo "$turn" | tee "$root/student/1_rays/"{hit_sphere,notes}.cpp
    [ "$turn" -lt 4 ]
  }
  grade_here() { echo "tests $*"; }
  watch_here
) >"$folder/watched" 2>&1
[ "$(grep -c '^tests hit_sphere --from student$' "$folder/watched")$(grep -c ^tests "$folder/watched")" = 22 ] ||
  complain "watch did not test what was saved twice: $(cat "$folder/watched")"
PATH=$folder/other_system:$PATH refuses "--html cannot be used with --from" grade hit_triangle --html page.html
PATH=$folder/other_system:$PATH expect 0 'Firstlight 0' ./run --version
# An edition needs minutes of compiling, so what is wrong is said before.
mkdir "$folder/no_ninja"
printf '#!/bin/sh\nexit 1\n' | tee "$folder/no_ninja/cmake" >"$folder/no_ninja/ninja"
chmod +x "$folder"/no_ninja/*
for edition in handout autograder; do
  PATH=$folder/no_ninja:$PATH refuses "/docs exists and is not empty: name a new folder" $edition docs
done
mkdir -p "$folder/written/tests"
cp -r --parents run scripts pt/tasks student "$folder/written"
cp reference/2_bvh/hit_box.cpp "$folder/written/student/2_bvh"
expect 2 'student/*/hit_box.cpp is not a stub' env PATH="$folder/no_ninja:$PATH" "$folder/written/run" handout "$folder/course"
git -C "$folder/written" init --quiet
git -C "$folder/written" add run scripts pt student
touch "$folder/written/pt/new.h"
expect 2 'git does not know pt/new.h' env PATH="$folder/no_ninja:$PATH" "$folder/written/run" autograder "$folder/course"
(fail() { complain "$@"; exit 1; }; . scripts/editions/files.sh; expect_headers) || failures=$((failures + 1))

# Every command of the menu has a --help, and builds nothing for it.
for command in $(./run | sed -nE 's/^  [.]\/run ([a-z-]+)( [|] ([a-z-]+))?.*/\1 \3/p' | sort -u); do
  status=0
  said=$(PATH=/usr/bin:/bin timeout 20 ./run "$command" --help 2>&1 </dev/null) || status=$?
  case $status:$said in
    0:*building*) ;;
    0:*"$command"*) continue ;;
  esac
  printf './run %s --help: status %s, and says: %s\n' "$command" "$status" "$said"
  failures=$((failures + 1))
done

# Lists build nothing either.
for words in 'writeup speedup' 'stability hit_sphere far_away' 'measure hit_sphere.half_b'; do
  read -r command words <<<"$words"
  expect 0 "${words% *}" env PATH=/usr/bin:/bin timeout 20 ./run "$command" --list
  ! grep -q building "$folder/said" || complain "$command --list builds: $(head -3 "$folder/said")"
done
expect 0 'bug_t' ./run writeup --list --from hit_bvh=student

# A figure that does not exist is named before anything is built.
for words in nonsense 'adaptive nonsense' '--quality draft nonsense' '--handbook nonsense'; do
  read -ra words <<<"$words"
  expect 2 "no figure 'nonsense'" env PATH=/usr/bin:/bin timeout 20 ./run writeup "${words[@]}"
  ! grep -q building "$folder/said" || complain "writeup ${words[*]} builds: $(head -3 "$folder/said")"
done
# A part builds what its own figures need.
(
  build() { echo "$*"; }
  eval "$(sed -nE '/^(figures_meant|writeup)\(\) \{/,/^\}/p' run)"
  choose_mixture() { mixture=reference rest=("$@"); }
  root=$PWD build=$folder/none
  exec() { :; }
  writeup 1; echo --; writeup fails_sum; echo --; writeup one_ray
) >"$folder/needed" 2>&1
printf '%s\n' 'release writeup generate writeup_render.reference' -- \
  'release writeup generate writeup_render.reference' 'check grade stability stability_programs measure' -- \
  'release writeup generate writeup_render.reference' 'check view view_worker.reference' |
  diff - "$folder/needed" || complain 'other programs are built for a page (see above)'

# A missing tool of ./run lint is a failure only where warnings are errors.
for werror in ON OFF; do
  status=0
  said=$(FIRSTLIGHT_WERROR=$werror bash -c '. scripts/lint.sh; root=$PWD build=/none
    PATH=; lint_with compilers clang++-14 && lint_format' 2>&1) || status=$?
  case $werror:$status:$said in
    ON:1:'clang++-14 is missing: nothing is proven') ;;
    OFF:0:*'clang-format-14 is missing: nothing is proven') ;;
    *) echo "lint without its tools: FIRSTLIGHT_WERROR=$werror, status $status, and says: $said"; failures=$((failures + 1)) ;;
  esac
done

# In a folder with a name that CMake cannot read, ./run says so. Spaces and apostrophes are allowed.
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
for name in 'a "b"' 'a\b' 'a;b' 'a$b'; do
  mkdir "$place/$name"
  cp run "$place/$name"
  status=0
  said=$("$place/$name/run" help 2>&1) || status=$?
  case $status:$said in
    2:*'move the folder'*) ;;
    *) echo "in $name: status $status, and says: $said"; failures=$((failures + 1)) ;;
  esac
done
mkdir "$place/it's a b"
cp -r run scripts "$place/it's a b"
sh "$place/it's a b/run" help >/dev/null || complain "a path with spaces is refused, or sh"

# One version, where it is read and where it is cited.
said=$(./run --version)
[[ $said =~ ^Firstlight\ ([0-9]+\.[0-9]+\.[0-9]+)$ ]] || complain "--version says '$said'"
for line in "CITATION.cff:version: ${BASH_REMATCH[1]}" "CHANGELOG.md:## ${BASH_REMATCH[1]}"; do
  grep -q "^${line#*:}" "${line%%:*}" || complain "${line%%:*} does not have '${line#*:}'"
done

# A task file that is gone is named before anything is built.
cp -r --parents student pt/tasks grader/tasks/*/task.json "$place/it's a b"
rm "$place/it's a b/student/2_bvh/hit_box.cpp"
cd "$place/it's a b"
refuses 'student/*/hit_box.cpp is gone' grade hit_sphere --from student
refuses 'student/*/hit_box.cpp is gone' render scenes/box_spheres.dae -f a.png --from student

finish
