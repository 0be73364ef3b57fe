#!/usr/bin/env bash
# Tests that clangd finds no error in the twelve files and their contracts, before anything is built; and that the files in
# .vscode are JSON.
# editors.sh [FOLDER]: the folder is the root of the project or of an edition.
set -euo pipefail
cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}"
command -v clangd >/dev/null || exit 77
failures=0

# errors FILE: prints clangd's errors in it. It checks at most the stated number of lines, because the rest takes
# long.
errors() { clangd --check="$1" --check-lines=1-2 2>&1 | grep -E '^E\[|^I.*All checks completed' || true; }

for file in student/*/*.cpp pt/tasks/*.h; do
  said=$(errors "$file")
  case $said in
    *'All checks completed, 0 errors'*) ;;
    *) printf '%s:\n%s\n' "$file" "$said"; failures=$((failures + 1)) ;;
  esac
done
# clangd has to find an error.
wrong=$(mktemp -p student --suffix=.cpp)
trap 'rm -f "$wrong"' EXIT
printf '#include "pt/tasks/hit_box.h"\nint x = pt::no_such_name;\n' >"$wrong"
errors "$wrong" | grep -q no_such_name || { echo "clangd finds no mistake at all"; failures=$((failures + 1)); }

if command -v python3 >/dev/null; then
  for file in .vscode/*.json .devcontainer/*.json; do
    [ ! -e "$file" ] || python3 -m json.tool "$file" >/dev/null || { echo "$file is not JSON"; failures=$((failures + 1)); }
  done
fi
echo "$failures complaints"
[ "$failures" -eq 0 ]
