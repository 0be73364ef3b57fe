#!/usr/bin/env bash
# --from hit_bvh=NAME with a name that there is not: one sentence that has the names that there are, or where they stand.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"

# sentence MIXTURE: what CMake says of it.
sentence() {
  ! cmake --preset release -B "$folder/build" "-DFIRSTLIGHT_MIXTURES=$1" >"$folder/log" 2>&1 || complain "$1 is accepted"
  sed -n '/^CMake Error/,/^Call Stack/{/^CMake Error/d;/^Call Stack/d;p}' "$folder/log" | tr -s ' \n' ' '
}

said=$(sentence reference+hit_bvh=first_child)
for words in "no implementation 'first_child' of the task hit_bvh" 'student, reference, range_overwritten, first_child_that_hits' \
  'build/mistakes/hit_bvh' 'grader/tasks/hit_bvh/right'; do
  [[ $said == *"$words"* ]] || complain "it does not say '$words':" "$said"
done
said=$(sentence reference+hit_me=student)
[[ $said == *"'hit_me=student' is not a choice"* ]] || complain "an unknown task:" "$said"

finish
