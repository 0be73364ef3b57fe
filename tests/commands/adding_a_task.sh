#!/usr/bin/env bash
# Follows docs/adding_a_task.md in a copy of the project, and grades the new task there: the reference and the
# right solution pass, each wrong solution fails its promise, and the stub is not attempted. All tests that read
# the table of tasks pass with it.
# adding_a_task.sh FOLDER: the folder keeps the copy and its build, so that a second run is quick.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
page=$PWD/docs/adding_a_task.md tree=$1/tree
fail() {
  printf '%s\n' "FAILED: $*" >&2
  exit 1
}

# shellcheck source=tests/commands/copy_tree.sh
. tests/commands/copy_tree.sh
update_copy "$PWD" "$1"

# The files: a line "New file `F`:", and the block after it.
files=0 file='' inside=0 block=''
write_file() {
  files=$((files + 1))
  mkdir -p "$tree/$(dirname "$file")"
  printf '%s' "$block" | cmp -s - "$tree/$file" || printf '%s' "$block" >"$tree/$file"
}
while IFS= read -r line; do
  if [ "$inside" = 1 ]; then
    case $line in
      '```') inside=0; [ -z "$file" ] || write_file; file='' ;;
      *) block+=$line$'\n' ;;
    esac
    continue
  fi
  case $line in
    'New file `'*'`:') file=${line#*\`} file=${file%%\`*} ;;
    '```'*) inside=1 block='' ;;
  esac
done <"$page"
[ "$files" -eq 11 ] || fail "the page has $files files"
[ "$(grep -c '^## [0-9]\. ' "$page")" -eq 4 ] || fail "the page does not have four steps"

# Grades the new task with the copy's own ./run.
cd "$tree"
grade() { ./run grade sphere_area --no-pictures "$@" 2>&1 || true; }
said=$(grade --submission reference)
grep -qE 'sphere_area +pass' <<<"$said" || fail "the reference does not pass: $said"
mkdir -p "$1/solution/6_extra"
for file in build/mistakes/sphere_area/*/sphere_area.cpp; do
  cp "$file" "$1/solution/6_extra/sphere_area.cpp"
  promise=$(sed -n '1s/^\/\/ breaks: //p' "$file")
  said=$(grade --submission "$1/solution")
  grep -qE 'sphere_area +fail' <<<"$said" || fail "$file does not fail: $said"
  grep -qF "${promise//_/ }" <<<"$said" || fail "$file does not fail its promise '$promise': $said"
  sentence=$(sed -n '2s/^\/\/ //p' "$file")
  tr '\n' ' ' <<<"$said" | grep -qF "This is a known mistake: $sentence" || fail "$file is not named '$sentence': $said"
done
while read -r promise; do
  grep -qxF "breaks  $promise" grader/tasks/sphere_area/mistakes.txt || fail "no mistake breaks $promise"
done < <(sed -n 's/^PROMISE(sphere_area, \(.*\)) {$/\1/p' grader/tasks/sphere_area/properties.cpp)
for file in grader/tasks/sphere_area/right/*.cpp; do
  cp "$file" "$1/solution/6_extra/sphere_area.cpp"
  said=$(grade --submission "$1/solution")
  grep -qE 'sphere_area +pass' <<<"$said" || fail "$file does not pass: $said"
done
said=$(grade --submission student)
grep -qE 'sphere_area +not attempted' <<<"$said" || fail "the stub is not 'not attempted': $said"

# Runs the tests that read the table of tasks, or all tasks.
ninja -C build/check quick_tests rest_tests >"$1/said" 2>&1 || fail "the project is not built: $(tail -n 30 "$1/said")"
tests='tasks_test|layers_test|hostile_test|four_bugs_test|wrong_and_right_test|right_work|naming|test_hints|'
tests+='test_recipes|test_goldens|test_naming|test_report|test_intake|test_writeup|test_measure|pages|english|drawings|help_pages|measure|writeup|'
tests+='grade_class|sample_tables|compiled_once|link_lists|check[.]sphere_area|graded[.]sphere_area'
for name in ${tests//|/ }; do # a name of no test would be left out without a word
  [[ $(ctest --test-dir build/check -N -R "^$name\$") == *'Total Tests: 1' ]] || fail "'$name' in this list is not the name of one test"
done
ctest --test-dir build/check -j "$(nproc)" --output-on-failure --no-tests=error -R "^($tests)\$" >"$1/said" 2>&1 ||
  fail "the tests that read the table of tasks: $(tail -n 60 "$1/said")"
echo "one more task from $files files: graded"
