#!/usr/bin/env bash
# Tests that docs/help.txt has the help of the programs: ./run COMMAND --help shows it without building anything.
# help.sh BUILD [--renew]: compares it, or writes it again.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build=$1 page=docs/help.txt failures=0
new=$(mktemp)
trap 'rm "$new"' EXIT
echo '# What ./run COMMAND --help shows, command by command. tests/commands/help.sh BUILD --renew writes this file.' >"$new"
while read -r command program words; do
  # shellcheck disable=SC2086
  said=$("$build/$program" $words --help)
  printf '== %s\n%s\n' "$command" "$said" >>"$new"
  [ "${2:-}" = --renew ] || diff <(./run "$command" --help) <(printf '%s\n' "$said") || failures=$((failures + 1))
done <<'END'
bless grader/bless
cheapest measure/accuracy.reference cheapest
compare grader/compare
converge measure/accuracy.reference converge
examples grader/grade_examples
export pt/export
grade grader/grade
grade-class grader/grade_class
hint grader/hint
judge grader/judge
ladder measure/ladder
measure measure/measure
mesh scenes/generate
render pt/render
stability measure/stability
view view/view
watch grader/watch
writeup writeup/writeup
END
if [ "${2:-}" = --renew ]; then
  cp "$new" "$page"
elif [ "$failures" -gt 0 ] || ! diff "$page" "$new"; then
  echo "$page is not the help of the programs; write it again: tests/commands/help.sh BUILD --renew"
  exit 1
fi
