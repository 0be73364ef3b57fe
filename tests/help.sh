#!/usr/bin/env bash
# The pages in docs/help are what the programs say: ./run COMMAND --help shows them without building anything.
# help.sh BUILD [--renew]: compares them, or writes them again.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=$1 failures=0
while read -r command program words; do
  page=docs/help/$command.txt
  # shellcheck disable=SC2086
  said=$("$build/$program" $words --help)
  if [ "${2:-}" = --renew ]; then
    printf '%s\n' "$said" >"$page"
  elif ! diff <(./run "$command" --help) <(printf '%s\n' "$said"); then
    echo "$page is not what ./run $command says; write it again: tests/help.sh BUILD --renew"
    failures=$((failures + 1))
  fi
done <<'END'
bless grader/bless
cheapest writeup/accuracy.reference cheapest
compare pt/compare
converge writeup/accuracy.reference converge
grade grader/grade
grade-class grader/grade_class
hint grader/hint
ladder writeup/ladder
measure grader/measure
mesh scenes/generate mesh
render pt/render
stability grader/stability
watch grader/watch
writeup writeup/writeup
END
[ "$failures" -eq 0 ]
