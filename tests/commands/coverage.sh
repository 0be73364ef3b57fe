#!/usr/bin/env bash
# Checks that --coverage names the lines that did not run, and no others.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"
# shellcheck source=scripts/coverage.sh
. scripts/coverage.sh

mkdir -p "$folder/student" "$folder/build/half.covered.dir"
cat >"$folder/student/half.cpp" <<'EOF'
int half(int number) {
  if (number < 0) {
    number = -number;
  }
  return number / 2;
}
int main() { return half(1); }
EOF
cd "$folder"
expect 0 'no lines were counted' lines_never_run build half
g++ -O0 --coverage -o build/half.covered.dir/half.cpp.o -c "$folder/student/half.cpp"
g++ --coverage -o half build/half.covered.dir/half.cpp.o
./half
expect 0 'half.cpp, line 3 was never run by our inputs: number = -number;' lines_never_run build half
[ "$(lines_never_run build half | wc -l)" = 1 ] || complain 'other lines are named too'
forget_counts build half
expect 0 'no lines were counted' lines_never_run build half
finish
