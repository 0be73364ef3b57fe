#!/usr/bin/env bash
# judge.sh PROGRAMS: ./run judge on renderers that share no line with ours: one from the physics, right and with mistakes, and programs that
# cheat. PROGRAMS is the folder of `judge`.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
root=../../.. programs=$1 failures=0
here=$(mktemp -d)
trap 'rm -rf "$here"' EXIT
chmod 755 "$here"
c++ -O2 -std=c++20 -o "$here/naive" naive.cpp
cc -O1 -o "$here/cheat" cheat.c

# expect STATUS SENTENCE WORDS ...: what judge says of a command.
expect() {
  local status=$1 sentence=$2 said got=0
  shift 2
  said=$("$programs/judge" --work "$here/work" --format pfm -r 32 24 -m 2 --seconds 3 --html "$here/page.html" --json "$here/results.json" "$@" 2>/dev/null) || got=$?
  if [ "$got" != "$status" ] || [[ $said != *"$sentence"* ]]; then
    printf 'expected %s and "%s", got %s from %s:\n%s\n' "$status" "$sentence" "$got" "$*" "$said"
    failures=$((failures + 1))
  fi
}
naive() { expect "$1" "$2" "$root/scenes/large_light.dae" --as plain -- "$here/naive" {scene} {width} {height} {samples} {depth} {seed} {out} "${@:3}"; }
cheat() { expect 1 "$2" "$root/scenes/large_light.dae" -- "$here/cheat" "$1" {width} {height} {seed} {out} {scene} {samples}; }

naive 0 'agrees'
grep -q 'class="agrees"' "$here/page.html"
grep -q '"state": "pass"' "$here/results.json"
naive 1 'wrong: ' /pi
naive 1 'wrong: ' uniform
naive 1 'wrong: ' shallow
naive 1 'wrong: ' upside_down
cheat stored 'two batches of samples were identical'
cheat not_a_number 'is not a number'
cheat endless 'took more than 3 s of processor time'
cheat huge 'a file of more than 256 MiB'
rm -f /tmp/firstlight_outside.pfm
cheat outside 'Read-only file system'
[ ! -e /tmp/firstlight_outside.pfm ] || failures=$((failures + 1))
cheat "reads=$root/README.md" 'it printed last'
cheat silent 'wrote no picture'

expect 2 '' "$root/scenes/large_light.dae" -- "$here/naive" {scene} {samples} {sed} {out}
expect 2 '' "$root/scenes/large_light.dae" -- "$here/nothing" {scene} {samples} {seed} {out}
expect 2 '' "$root/scenes/large_light.dae"
[ "$failures" = 0 ]
