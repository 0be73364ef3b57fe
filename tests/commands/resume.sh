#!/usr/bin/env bash
# Tests that a killed run leaves results with everything that is not judged, and that --resume gives the results
# of a run that was never killed, without judging anything twice.
# resume.sh GRADER: the folder with grade and its grade.json.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"
grader=$1
stops=yes
running=
also_end() { [ -z "$running" ] || kill -9 "$running" 2>/dev/null; }

# prepare NAME: makes a folder to grade in, with an empty cache. All programs that judge write a line into its
# `log` for each call; the program for pictures waits for ever at the recipe that `hold` names.
prepare() {
  mkdir "$folder/$1"
  python3 - "$grader/grade.json" "$folder/$1" <<'END'
import json, os, sys
config = json.load(open(sys.argv[1]))
here = sys.argv[2]

def wrap(name, program):
    path = f"{here}/{name}"
    with open(path, "w") as script:
        script.write(f'''#!/bin/bash
name={name} recipe=
for word; do
  [ "$last" = --recipe ] && recipe=$word
  [ "$word" = --integrated ] && [ {name} != picture ] && name={name}.together
  last=$word
done
echo "$name $recipe" >>{here}/log
[ -z "$recipe" ] || [ "$recipe" != "$(cat {here}/hold 2>/dev/null)" ] || exec sleep infinity
exec {program} "$@"
''')
    os.chmod(path, 0o755)
    return path

config["work"] = here + "/work"
config["picture"] = wrap("picture", config["picture"])
for task in config["tasks"]:
    task["graded"] = wrap(task["slug"], task["graded"])
json.dump(config, open(here + "/grade.json", "w"))
END
}

# grades NAME STATUS OPTIONS...
grades() {
  local name=$1 status=$2 got=0
  shift 2
  "$grader/grade" --config "$folder/$name/grade.json" "$@" >"$folder/said" 2>&1 || got=$?
  [ "$got" -eq "$status" ] || complain "grade $* ended with $got, not $status:" "$(cat "$folder/said")"
}

asked=(camera_ray estimate_pixel --submission reference --threads 1)

prepare killed
echo rays_camera >"$folder/killed/hold"
"$grader/grade" --config "$folder/killed/grade.json" "${asked[@]}" --json "$folder/killed.json" \
  >"$folder/said" 2>&1 &
running=$!
until grep -qs 'picture rays_camera' "$folder/killed/log"; do
  kill -0 "$running" 2>/dev/null || complain "grade ended before it was killed:" "$(cat "$folder/said")"
  sleep 0.1
done
{ kill -9 "$running" && wait "$running" || true; } 2>/dev/null
running=

grades killed 1 --from-results "$folder/killed.json" --gradescope "$folder/gradescope.json"
grep -q 'This run was stopped before it ended' "$folder/said" || complain "$(cat "$folder/said")"
python3 - "$folder" <<'END' || complain "what the killed run left is not so"
import json, sys
results = json.load(open(sys.argv[1] + "/killed.json"))
assert results["complete"] is False and results["passed"] is False
assert {task["slug"] for task in results["tasks"]} == {"camera_ray", "estimate_pixel"}
for task in results["tasks"]:
    states = {picture["recipe"]: picture["state"] for picture in task["pictures"]}
    assert states.pop("rays_star") == "pass" and len(states) == 2, states
    assert set(states.values()) == {"not_judged"} and task["state"] == "not_judged", task
    earned = sum(p["points"] for p in task["promises"] if p["held"] and not p["bonus"])
    star = sum(p["points"] for p in task["pictures"] if p["recipe"] == "rays_star")
    assert all(p["held"] for p in task["promises"]) and task["points"] == earned + star, task
    assert 0 < task["points"] < task["max_points"], task
graded = json.load(open(sys.argv[1] + "/gradescope.json"))
assert graded["extra_data"]["complete"] is False
assert all(test["status"] == "failed" for test in graded["tests"])
assert graded["score"] == sum(t["points"] + t["bonus_points"] for t in results["tasks"])
END

# The rest needs the programs of the whole run; naming them judges nothing.
calls=$(wc -l <"$folder/killed/log")
named=$("$grader/grade" --config "$folder/killed/grade.json" --programs --resume | sort | paste -sd' ')
[[ $named == 'graded.'*' graded_picture '* && $(wc -l <"$folder/killed/log") -eq $calls ]] ||
  complain "grade --programs --resume says '$named', and makes calls"

rm "$folder/killed/hold"
grades killed 0 --resume
grades killed 2 --resume
grep -q 'nothing to --resume' "$folder/said" || complain "$(cat "$folder/said")"
prepare whole
grades whole 0 "${asked[@]}" --json "$folder/whole.json"

python3 - "$folder" <<'END' || complain "it did not go on as it had begun"
import json, sys
folder = sys.argv[1]
FILES = ["golden", "render", "evidence", "golden_counts", "counts"]

def content(path):
    return open(path, "rb").read() if path else b""

# Everything except times and paths of files; the content of a file replaces its path.
def found(value):
    if isinstance(value, list):
        return [found(each) for each in value]
    if not isinstance(value, dict):
        return value
    return {name: content(each) if name in FILES else found(each)
            for name, each in value.items() if name not in ("seconds", "phases")}

killed, whole = ([json.load(open(f"{folder}/{name}.json")) for name in ("killed", "whole")])
assert whole["complete"] and whole["passed"] and found(killed) == found(whole)

# Only the call that was killed is made again.
log = {name: open(f"{folder}/{name}/log").read().splitlines() for name in ("killed", "whole")}
assert sorted(log["whole"]) == sorted(set(log["whole"])) and len(log["whole"]) == 7, log
assert sorted(log["killed"]) == sorted(log["whole"] + ["picture rays_camera"]), log
END
# A task that was not asked for is not judged together with the others, as long as nothing fails.
prepare needed
grades needed 0 direct_lights --submission reference --no-pictures
together=$(grep together "$folder/needed/log")
[ "$together" = 'direct_lights.together ' ] || complain 'judged together with the others:' "$together"
# ./run first builds the named programs, with the known mistakes: only these are called.
named=$("$grader/grade" --programs direct_lights --submission reference --no-pictures | grep -v '^known[.]' | sort | paste -sd' ')
called=$(sed 's/^/graded./; s/[.]together//; s/ *$//' "$folder/needed/log" | sort -u | paste -sd' ')
{ [ "$named" = "$called" ] && [[ $named == *' '* ]]; } || complain "grade --programs names '$named', and '$called' are called"
# Pictures have a program, which is needed when something can be rendered.
named=$("$grader/grade" --programs direct_lights --submission reference | grep -c graded_picture || true)
mkdir -p "$folder/begun"
cp -r student/* "$folder/begun"
said=$("$grader/grade" --programs --submission "$folder/begun")
[[ $named == 1 && $said != *graded_picture* ]] || complain "grade --programs names graded_picture $named times, and where nothing is written: $said"
for change in 's/todo("diffuse_bsdf");/throw 1;/' '0,/todo("diffuse_bsdf");/s//return {};/' 's|^// TODO.*|/* {|'; do
  cp student/3_direct/diffuse_bsdf.cpp "$folder/begun/3_direct"
  sed -i "$change" "$folder/begun/3_direct/diffuse_bsdf.cpp"
  said=$("$grader/grade" --programs --submission "$folder/begun")
  [[ $said == *graded_picture* ]] || complain "grade --programs does not see '$change'"
done
[ -z "$("$grader/grade" --programs --from-results "$folder/whole.json")" ] || complain 'a report needs programs'

# Another project with the same cache: a change of a contract's code affects the tasks that may include it, a change of
# its comments none.
prepare changed
mkdir "$folder/root"
for each in grader golden scenes; do ln -s "$PWD/$each" "$folder/root/$each"; done
cp -r pt "$folder/root"
sed -i "s|\"root\": \"[^\"]*\"|\"root\": \"$folder/root\"|" "$folder/changed/grade.json"
grep -qF "$folder/root" "$folder/changed/grade.json" || complain 'grade.json names no root'
judged() {
  : >"$folder/changed/log"
  grades changed 0 "${asked[@]}" --no-pictures
  wc -l <"$folder/changed/log"
}
[ "$(judged)" -gt 0 ] || complain 'nothing was judged'
[ "$(judged)" -eq 0 ] || complain 'it is judged again though nothing changed'
printf '\n// A word more.\n' | tee -a "$folder/root/pt/tasks/"{hit_sphere,camera_ray}.h >/dev/null
[ "$(judged)" -eq 0 ] || complain 'words of contracts changed, and it is judged again'
echo 'struct Unused;' >>"$folder/root/pt/tasks/trace_path.h"
[ "$(judged)" -eq 0 ] || complain 'a contract that its tasks may not include changed, and it is judged again'
echo 'struct Unused;' >>"$folder/root/pt/tasks/camera_ray.h"
[ "$(judged)" -gt 0 ] || complain 'its contract changed, and it is not judged again'
echo 'a killed run goes on where it was, and nothing is judged again without need'
