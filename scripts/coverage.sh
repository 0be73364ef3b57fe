# Sourced by ./run: which lines of a learner's file no input runs. gcc counts in the program check.SLUG.covered.
# shellcheck shell=bash

# forget_counts BUILD SLUG: the next run counts from 0.
forget_counts() { find "$1" -path "*/$2.covered.dir/*.gcda" -delete; }

# lines_never_run BUILD SLUG: names these lines after a run.
lines_never_run() {
  local counts
  counts=$(find "$1" -path "*/$2.covered.dir/*.gcda")
  if [ -z "$counts" ] || ! command -v gcov >/dev/null; then
    echo "no lines were counted: --coverage needs gcc with gcov, and a program that ends by itself"
    return
  fi
  (cd "$(dirname "$counts")" && gcov --stdout "$(basename "$counts")" 2>/dev/null) | awk -F: -v file="$2.cpp" '
    $3 == "Source" { ours = substr($0, length($0) - length(file)) == "/" file; next }
    ours && $1 ~ /#####/ {
      line = $2 + 0
      sub(/^[^:]*:[^:]*: */, "")
      print file ", line " line " was never run by our inputs: " $0
    }'
}
