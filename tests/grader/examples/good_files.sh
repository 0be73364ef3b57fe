#!/usr/bin/env bash
# Examples of every task get what they deserve. Good ones, at most 15 for a task, written from its chapter and its contract: all of them
# are valid, and they catch all mistakes that ordinary inputs show (grader/tasks/<task>/ordinary), which are at least two fifths of all
# mistakes. Mixed ones are what the first word of their names says; those that are weak catch less than a third of the ordinary mistakes.
# good_files.sh BUILD: whose programs judge.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../fixtures/shell.sh"
# caught: of how many ordinary mistakes the last command caught how many: 3 18.
caught() { sed -nE 's/^The .*valid examples? catch(es)? ([0-9]+) of ([0-9]+) wrong.*/\2 \3/p' "$folder/said"; }

for file in tests/fixtures/examples/good/*.examples.cpp; do
  slug=$(basename "$file" .examples.cpp)
  [ "$(grep -c '^EXAMPLE' "$file")" -le 15 ] || complain "$file has more than 15 examples"
  expect 0 "$slug: " "$1/grader/grade_examples" "$slug" --submission tests/fixtures/examples/good
  read -r caught all < <(caught)
  [ "$caught" -eq "$all" ] || complain "$slug: $caught of $all ordinary mistakes"
  mistakes=$(grep -cv ' right$' "$1/grader/solutions.$slug.txt")
  [ $((5 * all)) -ge $((2 * mistakes)) ] || complain "$slug: only $all of $mistakes mistakes are ordinary"
  expect 1 "$slug: " "$1/grader/grade_examples" "$slug" --submission tests/fixtures/examples/mixed
  verdicts=$(sed -nE 's/^  ([a-z ]+[a-z])  +([a-z]+): .*/\1, \2/p' "$folder/said" | sort -u | paste -sd';')
  [ "$verdicts" = 'too strict, strict;valid, weak;wrong, wrong' ] || complain "$slug, mixed: $(cat "$folder/said")"
  read -r caught all < <(caught)
  [ $((3 * caught)) -lt "$all" ] || complain "$slug: weak examples catch $caught of $all"
  # The stub has one valid example.
  expect 0 'The valid example catches' "$1/grader/grade_examples" "$slug"
done
finish
