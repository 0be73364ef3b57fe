#!/usr/bin/env bash
# Checks that the pages of the project agree with its files: every relative link and its anchor lead
# somewhere, every scene that a command names exists, every task has a chapter, and every picture of the
# handbook is small and has its command below it; and that sample tables have points that can occur.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

failures=0
complain() {
  printf '%s\n' "$*"
  failures=$((failures + 1))
}

# The anchors of a page's headings, as GitHub makes them.
anchors() { sed -n 's/^##* //p' "$1" | tr '[:upper:] ' '[:lower:]-' | tr -cd 'a-z0-9_\n-'; }

check_page() {
  local page=$1 folder link file
  folder=$(dirname "$page")
  # This page is at the root of the learners' edition.
  [ "$page" != ./scripts/editions/handout_README.md ] || folder=.
  while read -r link; do
    case $link in http*) continue ;; esac
    file=$folder/${link%%#*}
    [ "${link%%#*}" = "" ] && file=$page
    [ -e "$file" ] || { complain "$page: nothing at '$link'"; continue; }
    case $link in
      *#*) anchors "$file" | grep -qxF -- "${link#*#}" || complain "$page: no heading for '$link'" ;;
    esac
  done < <(grep -oE '\]\([^)]+\)' "$page" | sed 's/^](//; s/)$//')
  while read -r file; do
    [ -e "$file" ] || complain "$page: no scene '$file'"
  done < <(grep -oE 'render scenes/[a-z_]+\.dae' "$page" | cut -d' ' -f2)
  # The name of the mistake is below its picture.
  while read -r _ task wrong _; do
    file=grader/tasks/${task%:}/mistakes.txt
    grep -qxF "name    $wrong" "$file" || complain "$page: $file has no mistake '$wrong'"
  done < <(grep -E '^<!-- [a-z_]+: [a-z0-9_]+ -->$' "$page")
}

check_picture() {
  local picture=$1 name page
  name=$(basename "$picture" .png)
  [ "$(stat -c %s "$picture")" -le 122880 ] || complain "$picture is larger than 120 KiB"
  page=$(grep -lF "pictures/$name.png" student/*/README.md || true)
  [ -n "$page" ] || { complain "no page shows $picture"; return; }
  # The sample-rate pictures are written beside the picture that the command names.
  grep -qE -- "-f ${name%_rate}\.png" "$page" || complain "$page: no command makes $name.png"
}

# The rows of a sample table, "1.3  hit_triangle  fail  13/23", have the right number of possible points, by the
# usual worth of a promise and of a picture.
check_points() {
  local page=$1 slug points got most promises pictures
  while read -r _ slug _ points _; do
    got=${points%/*} most=${points#*/}
    promises=$(grep '^//   - ' "pt/tasks/$slug.h" | grep -vc '(bonus)' || true)
    pictures=$(grep '"tasks"' scenes/recipes.json | grep -c "\"$slug\"" || true)
    [ "$most" -eq $((promises + 3 * pictures)) ] && [ "$got" -le "$most" ] ||
      complain "$page: $slug has $((promises + 3 * pictures)) points, not $points"
  done < <(grep -E '^ +[1-9]\.[0-9]  [a-z_]+ +[a-z]+ +[0-9]+/[0-9]+' "$page")
}

pages=0
while read -r page; do
  check_points "$page"
  check_page "$page"
  pages=$((pages + 1))
done < <(find . -name '*.md' -not -path './build/*' -not -path './.git/*')
[ "$pages" -ge 6 ] || complain "only $pages pages found"
for picture in student/pictures/*.png; do check_picture "$picture"; done
for contract in pt/tasks/*.h; do
  slug=$(basename "$contract" .h)
  grep -qxE "## [0-9.]+ $slug" student/*/README.md -h || complain "no chapter for $slug"
  grep -qF "tasks/$slug.h" student/*/README.md || complain "no link to $contract"
done
echo "$pages pages, $failures complaints"
[ "$failures" -eq 0 ]
