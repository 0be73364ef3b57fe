#!/usr/bin/env bash
# Tests that docs/help has the help of the programs: ./run COMMAND --help shows it without building anything.
# help.sh BUILD [--renew]: compares them, or writes them again.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build=$1 failures=0
while read -r command program words; do
  page=docs/help/$command.txt
  # shellcheck disable=SC2086
  said=$("$build/$program" $words --help)
  if [ "${2:-}" = --renew ]; then
    printf '%s\n' "$said" >"$page"
  elif ! diff <(./run "$command" --help) <(printf '%s\n' "$said"); then
    echo "$page is not the help of ./run $command; write it again: tests/commands/help.sh BUILD --renew"
    failures=$((failures + 1))
  fi
done <<'END'
bless grader/bless
cheapest measure/accuracy.reference cheapest
compare pt/compare
converge measure/accuracy.reference converge
grade grader/grade
grade-class grader/grade_class
hint grader/hint
ladder measure/ladder
measure measure/measure
mesh scenes/generate
render pt/render
stability measure/stability
view view/view
watch grader/watch
writeup writeup/writeup
END
[ "$failures" -eq 0 ]
