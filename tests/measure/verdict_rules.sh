#!/usr/bin/env bash
# Checks ./run bench verdicts: all rules let right pictures pass, and reject those with much more light, in a block too.
# verdict_rules.sh PROGRAM
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"

expect 0 'wrote rules.csv' "$1" --quick --out "$folder/out"
for rule in "ours" "Mitsuba 3's" "two pictures by blocks" "two pictures by pixel"; do
  for where in 'everywhere' 'in a block'; do
    for row in 0,0 30,1; do
      grep -qE "^global_m2,48,36,$rule,[0-9]+,$where,$row,1\$" "$folder/out/rules.csv" ||
        complain "$rule, $where: no row $row,1 in $(cat "$folder/out/rules.csv")"
    done
  done
done
expect 2 'nosuch' "$1" nosuch --quick --out "$folder/out"
finish
