#!/usr/bin/env bash
# Checks that the tables on pages are tables that grade prints. A page names the source above a table:
#   <!-- grade OPTIONS; BASE [TASK/NAME ...] -->
# that is, grade with these options and seed 1, on the files of BASE (student or reference), some replaced by these mistakes. grade
# has to print the indented lines below it together, in this order.
# sample_tables.sh GRADE: GRADE is the program.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"
grade=$1 tables=0

# submission BASE [SOLUTION ...]: makes this submission in $folder/submission.
submission() {
  local base=$1 solution task
  shift
  rm -rf "$folder/submission"
  cp -r "$base" "$folder/submission"
  for solution in "$@"; do
    task=${solution%%/*}
    cp "build/mistakes/$solution/$task.cpp" "$folder"/submission/*/"$task.cpp"
  done
}

while IFS=: read -r page line words; do
  words=${words#*<!-- grade } words=${words% -->}
  read -ra options <<<"${words%%;*}"
  read -ra files <<<"${words#*;}"
  submission "${files[@]}"
  # Reads the indented block below it, without the indentation and the empty lines after it.
  awk -v "first=$line" 'NR <= first { next }
    /^    / { for (; empty > 0; --empty) print ""; print substr($0, 5); seen = 1; next }
    /^$/ { if (seen) ++empty; next }
    seen { exit }' "$page" >"$folder/table"
  [ -s "$folder/table" ] || { echo "$page:$line: there is no table below"; exit 1; }
  "$grade" "${options[@]}" --seed 1 --submission "$folder/submission" --name student --quiet >"$folder/said" 2>&1 || [ $? -eq 1 ]
  if ! python3 -c 'import sys; sys.exit(open(sys.argv[1]).read() not in open(sys.argv[2]).read())' "$folder/table" "$folder/said"; then
    complain "$page:$line: grade prints another table: $(diff "$folder/table" "$folder/said")"
  fi
  tables=$((tables + 1))
done < <(grep -rn --include='*.md' -E '^<!-- grade .*; .* -->$' student docs)
[ "$tables" -ge 2 ] || complain "there are $tables tables to compare"
finish
