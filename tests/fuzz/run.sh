#!/usr/bin/env bash
# run.sh FOLDER [--seconds N | --runs N] [TARGET ...] | --list: builds fuzz targets with clang in FOLDER and runs them one
# after the other, for 600 s each by default. Without a name it runs all targets. It shows the fault that an input causes.
# FOLDER keeps this input and the growing corpus. Exit status 1: a fault was found; 77: there is no clang.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mapfile -t all < <(sed -n 's/^firstlight_fuzz(\([a-z_]*\) .*/\1/p' "$here/CMakeLists.txt")
[ "${1:-}" != --list ] || { printf '%s\n' "${all[@]}"; exit; }
fail() { printf '%s\n' "$*" >&2; exit 2; }
[ $# -ge 1 ] || fail "say where to build: run.sh FOLDER [--seconds N | --runs N] [TARGET ...]"
mkdir -p "$1"
folder=$(cd "$1" && pwd)
shift
length=-max_total_time=600
case ${1:-} in
  --seconds) length=-max_total_time=${2:?}; shift 2 ;;
  --runs) length=-runs=${2:?}; shift 2 ;;
esac
targets=("$@")
[ $# -gt 0 ] || targets=("${all[@]}")
for target in "${targets[@]}"; do
  printf '%s\n' "${all[@]}" | grep -qxF -- "$target" || fail "'$target' is not a fuzz target; write one of: ${all[*]}"
done
if ! echo 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }' |
    clang++ -x c++ -fsanitize=fuzzer - -o "$folder/try" 2>/dev/null; then
  echo 'skipped: libFuzzer comes with clang, which is not here (package clang)'
  exit 77
fi
cmake -S "$here/../.." -B "$folder" --preset fuzz >"$folder/cmake.log" 2>&1 || { cat "$folder/cmake.log"; exit 2; }
ninja -C "$folder" "${targets[@]/#/fuzz.}" >"$folder/ninja.log" 2>&1 || { tail -30 "$folder/ninja.log"; exit 2; }
# A library's own memory leak when it refuses a file is not our fault; the tests find our leaks.
export ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 status=0
for target in "${targets[@]}"; do
  mkdir -p "$folder/corpus/$target"
  words=()
  [ ! -e "$here/$target.dict" ] || words+=(-dict="$here/$target.dict")
  if "$folder/tests/fuzz.$target" "$length" -artifact_prefix="$folder/$target." -max_len=16384 -timeout=20 \
      -rss_limit_mb=2048 -malloc_limit_mb=1536 -use_value_profile=1 -print_final_stats=1 ${words[@]+"${words[@]}"} \
      "$folder/corpus/$target" "$here/corpus/$target" >"$folder/$target.log" 2>&1; then
    printf '%-12s %s inputs, %s edges, nothing found\n' "$target" \
      "$(sed -n 's/^stat::number_of_executed_units: *//p' "$folder/$target.log")" \
      "$(sed -n 's/.* cov: \([0-9]*\) .*/\1/p' "$folder/$target.log" | tail -1)"
  else
    status=1
    tail -40 "$folder/$target.log"
    echo "$target: found by the input that stands above (Test unit written to ...)"
  fi
done
exit $status
