#!/usr/bin/env bash
# Good examples, at most 15 for a task, written from its chapter and its contract: all of them are valid, and they catch all mistakes that
# ordinary inputs show (grader/tasks/<task>/ordinary), which are at least two fifths of all mistakes.
# good_files.sh BUILD: whose programs judge.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../fixtures/shell.sh"
for file in tests/fixtures/examples/good/*.examples.cpp; do
  slug=$(basename "$file" .examples.cpp)
  [ "$(grep -c '^EXAMPLE' "$file")" -le 15 ] || complain "$file has more than 15 examples"
  expect 0 "$slug: " "$1/grader/grade_examples" "$slug" --submission tests/fixtures/examples/good
  read -r caught all < <(sed -nE 's/^The .*valid examples catch ([0-9]+) of ([0-9]+) wrong.*/\1 \2/p' "$folder/said")
  [ "$caught" -eq "$all" ] || complain "$slug: $caught of $all ordinary mistakes"
  mistakes=$(grep -cv ' right$' "$1/grader/solutions.$slug.txt")
  [ $((5 * all)) -ge $((2 * mistakes)) ] || complain "$slug: only $all of $mistakes mistakes are ordinary"
  # The stub has one valid example.
  expect 0 'The valid example catches' "$1/grader/grade_examples" "$slug"
done
finish
