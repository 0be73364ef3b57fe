#!/usr/bin/env bash
# Does what docs/adding_a_task.md says in a copy of the project, and grades the new task there: the reference
# passes, the wrong solution fails its promise, the stub is not attempted.
# adding_a_task.sh FOLDER: where the copy and its build are kept, so that a second run is quick.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
page=$PWD/docs/adding_a_task.md tree=$1/tree
fail() {
  printf '%s\n' "FAILED: $*" >&2
  exit 1
}

# The copy: files that git knows, and new ones; files that are the same keep their times.
mkdir -p "$tree"
{ git ls-files --cached --others --exclude-standard 2>/dev/null | grep . ||
    find . -path ./build -prune -o -type f -print; } | while read -r file; do
  [ ! -f "$file" ] || cmp -s "$file" "$tree/$file" || { mkdir -p "$tree/$(dirname "$file")"; cp "$file" "$tree/$file"; }
done

# The steps: a line "New file `F`:" or "In `F`, above `TEXT`:", and the block after it.
steps=0 action='' file='' above='' inside=0 block=''
do_step() {
  steps=$((steps + 1))
  if [ "$action" = new ]; then
    mkdir -p "$tree/$(dirname "$file")"
    printf '%s' "$block" | cmp -s - "$tree/$file" || printf '%s' "$block" >"$tree/$file"
  else
    [ "$(grep -cF -- "$above" "$tree/$file")" -ge 1 ] || fail "$file has no line with '$above'"
    block=$block above=$above awk '{ lines[NR] = $0; if (index($0, ENVIRON["above"])) last = NR }
      END { for (i = 1; i <= NR; ++i) { if (i == last) printf "%s", ENVIRON["block"]; print lines[i] } }' \
      "$tree/$file" >"$tree/$file.new"
    mv "$tree/$file.new" "$tree/$file"
  fi
}
while IFS= read -r line; do
  if [ "$inside" = 1 ]; then
    case $line in
      '```') inside=0; [ -z "$action" ] || do_step; action='' ;;
      *) block+=$line$'\n' ;;
    esac
    continue
  fi
  case $line in
    'New file `'*'`:') action=new file=${line#*\`} file=${file%%\`*} ;;
    'In `'*'`, above `'*'`:') action=insert file=${line#*\`} above=${line%\`:} above=${above##*\`} file=${file%%\`*} ;;
    '```'*) inside=1 block='' ;;
  esac
done <"$page"
[ "$steps" -ge 12 ] || fail "the page has $steps steps"

# The new task, graded by the copy's own ./run.
cd "$tree"
grade() { ./run grade sphere_area --no-pictures "$@" 2>&1 || true; }
said=$(grade --submission reference)
grep -qE 'sphere_area +pass' <<<"$said" || fail "the reference does not pass: $said"
mkdir -p "$1/wrong/6_extra"
cp grader/tasks/sphere_area/wrong/of_one_circle.cpp "$1/wrong/6_extra/sphere_area.cpp"
said=$(grade --submission "$1/wrong")
grep -qE 'sphere_area +fail' <<<"$said" && grep -qF 'knows the unit sphere' <<<"$said" ||
  fail "the wrong solution does not fail its promise: $said"
said=$(grade --submission student)
grep -qE 'sphere_area +not attempted' <<<"$said" || fail "the stub is not 'not attempted': $said"
echo "a thirteenth task by $steps steps: graded"
