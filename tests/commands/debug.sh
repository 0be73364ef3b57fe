#!/usr/bin/env bash
# debug.sh COMPILER OBJECTS: tests that ./run debug stops in the learner's function, called with the smallest
# input that the report shows. OBJECTS lists the objects of check.hit_triangle.reference without the task; other
# solutions replace it.
set -euo pipefail
compiler=$1 objects=$2
export FIRSTLIGHT_SEED=1
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"

skip() {
  echo "SKIPPED: $*"
  exit 77
}
command -v gdb >/dev/null || skip "gdb is missing, so ./run debug is not tested"
gdb -q -batch -ex 'set debuginfod enabled off' -ex run --args true 2>&1 |
  grep -q 'exited normally' ||
  skip "gdb may not trace programs here, so ./run debug is not tested"

# solution FILE: a program of the properties and this solution, as ./run debug builds the learner's.
solution() {
  "$compiler" -std=c++20 -g -O0 -ffp-contract=off -I. -c "$1" -o "$folder/task.o"
  "$compiler" "$folder/task.o" "@$objects" -pthread -o "$folder/check"
}

# Prints the numbers of a text in one notation.
numbers() {
  { grep -oE '[-]?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?' || true; } | awk '{ printf "%.9g ", $1 }'
}
# Print the numbers of the report, and of gdb, between the first word and the second.
reported() {
  sed -n "s/^  $1//p" "$folder/report" | head -1 |
    sed "s/${2:-$}.*//; s/[a-z][a-z][a-z]*//g" | numbers
}
in_gdb() {
  sed -n "s/^$1 = @0x[0-9a-f]*: //p" "$folder/gdb" |
    sed "s/${2:-$}.*//; s/[a-z][0-9] =//g" | numbers
}

stops_in() {
  local wrong=$1 promise triangle corners
  local file=build/mistakes/hit_triangle/$wrong/hit_triangle.cpp
  solution "$file"
  promise=$(sed -n 's|^// breaks: ||p' "$file" | tr _ ' ')
  "$folder/check" --gtest_brief=1 "--gtest_filter=*.${promise// /_}" >"$folder/report" || true
  grader/check/language/debug.sh --batch "$folder/check" hit_triangle "$promise" >"$folder/gdb" 2>&1
  grep -qE "^Breakpoint 2, pt::hit_triangle .* at .*/$wrong/hit_triangle\.cpp:" "$folder/gdb" ||
    complain "$wrong: it does not stop in pt::hit_triangle"
  grep -qx 'This is your function, called with the smallest input that fails.' "$folder/gdb" ||
    complain "$wrong: it does not say where it is"
  triangle=$(in_gdb triangle)
  # The simplest triangle fails too, along any axes: an edge from 0 to 1, and a corner beside its end and 1
  # away.
  corners=$(tr ' ' '\n' <<<"$triangle" | head -9 | sort -n | paste -sd' ')
  [ "$corners" = '0 0 0 0 0 0 1 1 1' ] || complain "$wrong: '$triangle' is not the smallest triangle"
  [ "$triangle" = "$(reported 'Triangle ')" ] || complain "$wrong: not the triangle of the report"
  [ "$(in_gdb ray ', t_min')" = "$(reported 'Ray from ' ', t in')" ] ||
    complain "$wrong: not the ray of the report"
  [ "$failures" -eq 0 ] || cat "$folder/gdb"
}

# The first mistake fails on the first input, the second after some inputs that hold.
stops_in range_unchecked
stops_in one_edge_unchecked

solution grader/tasks/hit_triangle/right/cramers_rule.cpp
debug=(grader/check/language/debug.sh --batch "$folder/check" hit_triangle)
"${debug[@]}" 'hits where it is aimed' >"$folder/gdb" 2>&1
grep -q '^Nothing failed' "$folder/gdb" || complain "a right solution: $(cat "$folder/gdb")"
grep -q ' fails: hits where it is aimed, seed 1$' "$folder/gdb" ||
  complain "it does not say what it looks for: $(head -1 "$folder/gdb")"

status=0
"${debug[@]}" 'walks on water' >"$folder/gdb" 2>&1 || status=$?
[ "$status" -eq 2 ] || complain "a promise that there is not: exit status $status, not 2"
grep -q "does not promise 'walks_on_water'" "$folder/gdb" ||
  complain "a promise that there is not: $(cat "$folder/gdb")"

finish
