#!/usr/bin/env bash
# Unpacks and runs the archive for Gradescope as Gradescope does, in its own folder: the reference gets its
# points, flat files too, a stub gets none, and a stopped run leaves valid results.
# gradescope_archive.sh BUILD: makes the folder in BUILD. Skipped (77) without root.
set -euo pipefail
[ "$(id -u)" -eq 0 ] || { echo "SKIPPED, the autograder was not tried: it runs as root"; exit 77; }
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
export FIRSTLIGHT_AUTOGRADER=$1/autograder
autograder=$FIRSTLIGHT_AUTOGRADER
export CCACHE_BASEDIR=$autograder/source CCACHE_NOHASHDIR=1

complain() {
  printf '%s\n' "$*"
  exit 1
}

# judges EXPRESSION [OPTION ...]: runs it, and tests an expression of Python in which `r` is results.json.
judges() {
  local expression=$1
  shift
  rm -rf "$autograder/results"
  "$autograder/source/run_autograder" "$@" >"$autograder/log" 2>&1 || complain "run_autograder: $?"
  python3 - "$autograder/results/results.json" "$expression" <<'END' ||
import json, sys
r = json.load(open(sys.argv[1]))
for test in r.get("tests", []):
    assert set(test) >= {"score", "max_score", "status", "name", "output"}, test
task = {test["name"]: test for test in r.get("tests", [])}
assert eval("(" + sys.argv[2] + ")"), r
END
    complain "not so: $expression" "$(cat "$autograder/log")"
}

rm -rf "$autograder"
mkdir -p "$autograder/source" "$autograder/submission"
scripts/editions/gradescope_zip.sh "$1" "$autograder/autograder.zip"
(cd "$autograder/source" && cmake -E tar xf ../autograder.zip)
bash "$autograder/source/setup.sh" >"$autograder/log" 2>&1 ||
  complain "setup.sh failed:" "$(cat "$autograder/log")"

# Another user who knows every path can read only the box, and the files in its folder.
readable=$(find "$autograder/source" -type f -print0 |
  setpriv --reuid 65534 --regid 65534 --clear-groups xargs -0 sh -c 'for file; do [ ! -r "$file" ] || echo "$file"; done' sh |
  grep -vE '/build/check/grader/(box|box_probe|unpack|graded/.*)$' || true)
[ -z "$readable" ] || complain "another user can read:" "$readable"

for tier in A B; do
  cp reference/*/hit_*.cpp "$autograder/submission"
  judges 'r["score"] > 0 and task["hit_bvh"]["status"] == "passed"
    and task["hit_triangle"]["score"] >= task["hit_triangle"]["max_score"] > 0
    and task["trace_path"]["score"] == 0' --no-pictures --isolation $tier
  rm "$autograder/submission/"*
done
mkdir "$autograder/submission/handed_in"
cp -r student "$autograder/submission/handed_in"
tasks=$(printf '%s\n' grader/tasks/*/task.json | wc -l)
judges "r['score'] == 0 and len(task) == $tasks" --no-pictures
cp -r reference/1_rays "$autograder/submission/handed_in/student"
judges 'task["hit_triangle"]["status"] == "passed"' --no-pictures
judges 'r["output"] and all(test["score"] == 0 and test["status"] == "failed" for test in task.values()
    if test["extra_data"]["state"] == "not_judged")' --time-limit 0.3 --no-pictures --seed 2
judges 'r["score"] == 0 and "could not be judged" in r["output"]' --no-such-option
rm -rf "$autograder"
