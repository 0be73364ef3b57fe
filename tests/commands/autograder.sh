#!/usr/bin/env bash
# Makes what platforms grade with, and looks at what each of them takes. Then it unpacks and runs the archive for Gradescope
# as Gradescope does, in its own folder: the reference gets its points, flat files too, a stub gets none, and a stopped run
# leaves valid results.
# autograder.sh BUILD [made]: makes the folder in BUILD; made: only configures what is in it. Skipped (77) without root.
set -euo pipefail
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
scripts/editions/autograder.sh "$1" "$autograder/made" school/firstlight
if scripts/editions/autograder.sh "$1" "$autograder/made" 2>/dev/null; then complain "a second autograder has been made over the first"; fi
(cd "$autograder/source" && cmake -E tar xf ../made/gradescope.zip)
diff -r --exclude=Dockerfile "$autograder/source" "$autograder/made/image" >"$autograder/log" ||
  complain "Gradescope does not get what the container has:" "$(cat "$autograder/log")"
[ -x "$autograder/source/setup.sh" ] && [ -x "$autograder/source/run_autograder" ] || complain "Gradescope finds no programs"
# The rules are those of infoQuestion.json (PrairieLearn), and of valid_asmt_tar and problem.rb (Autolab).
python3 - "$autograder/made" <<'END' || complain "PrairieLearn or Autolab would refuse it"
import glob, json, re, sys, tarfile
info = json.load(open(sys.argv[1] + "/prairielearn/info.json"))
assert re.fullmatch("[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}", info["uuid"]), info
options = info["externalGradingOptions"]
assert (info["type"], info["gradingMethod"], options["image"]) == ("v3", "External", "school/firstlight"), info
assert options["timeout"] <= 600 and options["entrypoint"][0].startswith("/") and info["title"] and info["topic"], info
with tarfile.open(sys.argv[1] + "/autolab.tar") as tar:
    names = tar.getnames()
    assert tar.getmembers()[0].isdir() and names[0] == "firstlight" and all(name.startswith("firstlight") for name in names), names
    assert {"firstlight/firstlight.yml", "firstlight/autograde.tar", "firstlight/autograde-Makefile"} <= set(names), names
    text = tar.extractfile("firstlight/firstlight.yml").read().decode()
assert "autograde_image: school/firstlight\n" in text, text
problems = dict(re.findall(r"^- name: (\w+)\n  description: ''\n  max_score: ([0-9.]+)$", text, re.M))
assert set(problems) == {path.split("/")[2] for path in glob.glob("grader/tasks/*/task.json")}, problems
assert sum(map(float, problems.values())) > 200, problems
END
bash -n "$autograder/made/artemis/build_script.sh"
if [ "${2:-}" = made ]; then
  (cd "$autograder/source" && cmake --preset check) >"$autograder/log" 2>&1 ||
    complain "the image cannot be configured:" "$(cat "$autograder/log")"
  rm -rf "$autograder"
  exit
fi
[ "$(id -u)" -eq 0 ] || { echo "SKIPPED, the autograder was not tried: it runs as root"; exit 77; }
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
