#!/usr/bin/env bash
# debug.sh [--batch] PROGRAM TASK [PROMISE]: gdb on the properties of a task in one process, stopped
# in the task's function with the smallest input for which the promise does not hold. What ./run
# debug does once the program is built. FIRSTLIGHT_SEED is the seed. With FIRSTLIGHT_SUBMISSION, a clone of
# CS184's skeleton, it stops in the function of the clone.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
batch=()
[ "$1" != --batch ] || { batch=(-batch); shift; }
program=$1 task=$2
promise=$(printf '%s' "${3:-}" | tr '[:upper:] ' '[:lower:]_' | tr -d "'")

command=("$program" --gtest_brief=1 "--gtest_filter=*.$promise*")
"${command[@]}" --gtest_list_tests | grep -q '^  ' || {
  echo "$task does not promise '$promise'; its promises are in pt/tasks/$task.h" >&2
  exit 2
}
# The functions that the contract declares.
functions=()
for function in $(sed -n 's/^[A-Za-z][^(]* \([a-z_]*\)(.*/\1/p' "$root/pt/tasks/$task.h"); do
  functions+=(-ex "break pt::$function")
done
if [ -n "${FIRSTLIGHT_SUBMISSION-}" ]; then
  clone=$(find "$FIRSTLIGHT_SUBMISSION" -maxdepth 4 -type d \( -path '*/src/pathtracer' -o -path '*/src/static_scene' \) | head -1)
  if [ -n "$clone" ]; then
    functions=()
    for function in $(sed -n 's/^function //p' "$root/grader/door/tasks/$task.txt"); do
      functions+=(-ex "break $function")
    done
    functions+=(-ex "directory ${clone%/src/*}")
  fi
fi
promise=${promise//_/ }
echo "Looking for the smallest input on which $task fails: ${promise:-every promise}," \
  "seed ${FIRSTLIGHT_SEED:-1}"
export FIRSTLIGHT_REPLAY=1
exec gdb -q ${batch[@]+"${batch[@]}"} -ex 'set debuginfod enabled off' \
  -ex 'break grader::check::at_smallest_failure' \
  "${functions[@]}" -x "$root/grader/check/language/debug.gdb" --args "${command[@]}"
