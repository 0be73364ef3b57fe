#!/usr/bin/env bash
# Changes between two gradings of a class, or during one: of a promise, a golden or a learner's file. The comparison names the
# learners who gain or lose and the promises, nothing is judged again that the change cannot affect, and files that change while
# they are judged are judged again.
# class_changes.sh GRADER: the folder with grade_class and its grade.json.
set -euo pipefail
grader=$1
# shellcheck source=tests/grader/service/classes/class_fixture.sh
. "$(dirname "${BASH_SOURCE[0]}")/class_fixture.sh"
log_what_is_judged "$grader"

# The judging programs log their arguments and take goldens from a folder of ours. The Python code in the file `edit` changes
# the findings on hit_sphere, as if its promises were others.
for program in graded.hit_triangle graded.hit_sphere graded_picture; do
  cat >"$folder/programs/$program" <<END
#!/bin/bash
report= recipe=
while [ "\$#" -gt 0 ]; do
  case \$1 in --report) report=\$2 ;; --recipe) recipe=\$2 ;; esac
  words+=("\$1")
  shift
done
echo "$program \$recipe" >>'$folder/asked'
status=0
'$grader/$program' "\${words[@]}" || status=\$?
[ $program != graded.hit_sphere ] || [ -z "\$report" ] || [ ! -e '$folder/edit' ] || python3 '$folder/edit' "\$report"
exit "\$status"
END
  chmod +x "$folder/programs/$program"
done
# Each promise counts here, also where others are broken for the same reason.
sed -i 's/"one_cause": 0.5/"one_cause": 1/' "$folder/root/grader/points.json"
rm "$folder/root/golden"
cp -r golden "$folder/root/golden"
python3 - "$folder" <<'END'
import json, sys
path = sys.argv[1] + "/programs/grade.json"
config = json.load(open(path))
for task in config["tasks"]:
    if task["slug"] in ("hit_sphere", "hit_triangle"):
        task["graded"] = sys.argv[1] + "/programs/graded." + task["slug"]
config["picture"] = sys.argv[1] + "/programs/graded_picture"
json.dump(config, open(path, "w"))
END

for learner in right wrong other unwritten; do
  mkdir -p "$folder/class/$learner"
  cp reference/1_rays/hit_triangle.cpp "$folder/class/$learner"
done
cp reference/1_rays/hit_sphere.cpp "$folder/class/right"
cp build/mistakes/hit_sphere/near_root_only/hit_sphere.cpp "$folder/class/wrong/hit_sphere.cpp"
cp build/mistakes/hit_sphere/assumes_unit_direction/hit_sphere.cpp "$folder/class/other/hit_sphere.cpp"
cp student/1_rays/hit_sphere.cpp "$folder/class/unwritten"

# grades OUT WORDS...: grades the class; the tasks are hit_sphere and hit_triangle.
grades() {
  local out=$1
  shift
  rm -f "$folder/asked" "$folder/judged"
  "$grader/grade_class" "$folder/class" --out "$folder/$out" --seed 7 --jobs 2 --not-isolated --config "$folder/programs/grade.json" \
    "$@" -- hit_sphere hit_triangle >"$folder/said" 2>&1 || complain "$(cat "$folder/said")"
}
asked() { sort -u "$folder/asked" 2>/dev/null | tr '\n' ',' | tr -d ' '; }

grades before
for program in graded.hit_{sphere,triangle} graded_picturerays_{clip,smooth,spheres}; do
  [[ ,$(asked) == *,$program,* ]] || complain "$program is not asked: $(asked)"
done
grades before
[ -z "$(asked)" ] || complain "nothing has changed, and it asks: $(asked)"
[ "$(grep -c 'as before' "$folder/said")" -eq 4 ] || complain "$(cat "$folder/said")"

# One promise becomes easier, so one more learner keeps it. Another becomes harder, so one fewer does. The share of the promises is the
# most that pictures earn of theirs.
python3 - "$folder" >"$folder/names" <<'END'
import json, sys
def broken(name):
    tasks = json.load(open(f"{sys.argv[1]}/before/{name}.json"))["tasks"]
    promises = [p for t in tasks if t["slug"] == "hit_sphere" for p in t["promises"] if not p["bonus"]]
    return {p["name"] for p in promises if not p["held"]}, {p["name"] for p in promises}
(wrong, all), (other, _), (right, _) = broken("wrong"), broken("other"), broken("right")
assert not right and len(other) > 1 and wrong
print(min(other - wrong), min(all - wrong - other))
END
read -r easier harder <"$folder/names"
cat >"$folder/edit" <<END
import json, sys
results = json.load(open(sys.argv[1]))
promises = {each["name"]: each for each in results["tasks"][0]["promises"]}
held = [each["held"] for each in promises.values()]
if "$easier" in promises and not all(held) and any(held):
    if promises["$easier"]["held"]:
        promises["$harder"]["held"] = False
    else:
        promises["$easier"].update(held=True, failures=[])
json.dump(results, open(sys.argv[1], "w"))
END
echo '# another program' >>"$folder/programs/graded.hit_sphere"
grades promise --compare "$folder/before"
[ "$(asked)" = graded.hit_sphere, ] || complain "a promise of hit_sphere has changed, and it asks: $(asked)"
grep -q '1 gains points, 1 loses points' "$folder/said" || complain "$(cat "$folder/said")"
# changes OUT: its comparison: learner, first three words of the promise, points before and after.
changes() {
  python3 - "$folder/$1/compare.csv" <<'END'
import csv, sys
for row in csv.DictReader(open(sys.argv[1], newline="", encoding="utf-8-sig")):
    print(row["submission"], row["task"], *row["promise"].split()[:3], row["promise_before"], row["promise_after"])
END
}
[ "$(changes promise)" = "other hit_sphere hits where it 0 1
wrong hit_sphere finds the near 1 0
wrong hit_sphere picture bvh_bounces 3 2" ] || complain "$easier is easier, $harder harder:" "$(changes promise)"

# A wrong golden is corrected in place; the time of its folder does not change.
python3 - "$folder/root/golden" <<'END'
import hashlib, json, sys
golden = sys.argv[1] + "/rays_spheres"
picture = open("golden/rays_smooth.exr", "rb").read()
about = json.load(open(golden + ".json"))
about["files_sha256"] = hashlib.sha256(picture).hexdigest()
open(golden + ".exr", "wb").write(picture)
json.dump(about, open(golden + ".json", "w"))
END
grades wrong --compare "$folder/promise"
[ "$(asked)" = graded_picturerays_spheres, ] || complain "the golden of rays_spheres has changed, and it asks: $(asked)"
[ "$(changes wrong)" = "other hit_sphere picture rays_spheres 2 0
right hit_sphere picture rays_spheres 3 0" ] || complain "$(changes wrong)"
cp golden/rays_spheres.{exr,json} "$folder/root/golden"
grades golden --compare "$folder/wrong"
[ -z "$(asked)" ] || complain "what this golden says was known, and it asks: $(asked)"
[ "$(changes golden)" = "other hit_sphere picture rays_spheres 0 2
right hit_sphere picture rays_spheres 0 3" ] || complain "$(changes golden)"

# A file that changes while it is judged has no outcome, and the same chunk judges it again.
cat >"$folder/make_plan" <<END
exec '$grader/grade_class' plan '$folder/class' --out '$folder/chunks' --seed 7 --not-isolated --config '$folder/programs/grade.json' \
  -- hit_sphere hit_triangle --no-pictures >'$folder/planned' 2>&1
END
bash "$folder/make_plan" || complain "$(cat "$folder/planned")"
chunks() {
  "$grader/grade_class" chunk "$folder/chunks" 1 2 3 4 --config "$folder/programs/grade.json" >"$folder/said" 2>&1
}
python3 - "$folder" <<'END'
import sys
folder = sys.argv[1]
path = folder + "/programs/grade"
lines = open(path).read().splitlines()
lines.insert(1, f"""if [ -e '{folder}/hook' ]; then . '{folder}/hook'; fi""")
open(path, "w").write("\n".join(lines) + "\n")
END
echo "rm '$folder/hook'; echo '// later' >>'$folder/class/other/hit_sphere.cpp'" >"$folder/hook"
status=0
chunks || status=$?
[ "$status" -eq 2 ] || complain "a chunk with a submission that has changed meanwhile ended with $status"
grep -q 'other: .*have changed while it was judged' "$folder/said" || complain "$(cat "$folder/said")"
[ "$(grep -c 'tasks pass' "$folder/said")" -eq 3 ] || complain "$(cat "$folder/said")"
[ ! -e "$folder/chunks/other.problem" ] || complain 'that is taken for its outcome'
rm "$folder/judged"
chunks || complain "$(cat "$folder/said")"
[ "$(cat "$folder/judged")" = other ] || complain "judged: $(cat "$folder/judged")"

# A new plan while a chunk of the old plan runs: this chunk stops judging, and its reason for not judging somebody does not
# count for the new plan.
for learner in right other wrong unwritten; do echo '// of a new plan' >>"$folder/class/$learner/hit_triangle.cpp"; done
echo "rm '$folder/hook'; bash '$folder/make_plan'; echo 'a fault of before' >&2; exit 2" >"$folder/hook"
bash "$folder/make_plan" || complain "$(cat "$folder/planned")"
rm "$folder/judged"
status=0
chunks || status=$?
[ "$status" -eq 2 ] || complain "a chunk of an earlier plan ended with $status"
grep -q 'a fault of before' "$folder/said" || complain "$(cat "$folder/said")"
[ "$(grep -c 'another plan of this class has been made' "$folder/said")" -eq 3 ] || complain "$(cat "$folder/said")"
[ ! -e "$folder/judged" ] || complain "judged by an earlier plan: $(cat "$folder/judged")"
"$grader/grade_class" collect "$folder/chunks" --config "$folder/programs/grade.json" >"$folder/said" 2>&1 || true
grep -q '^0 of 4 submissions are judged' "$folder/said" || complain "$(cat "$folder/said")"
[ "$(grep -c 'it is not judged yet' "$folder/chunks/class.csv")" -eq 4 ] || complain "$(cat "$folder/chunks/class.csv")"
chunks || complain "$(cat "$folder/said")"
[ "$(sort "$folder/judged" | tr '\n' ' ')" = 'other right unwritten wrong ' ] || complain "judged: $(cat "$folder/judged")"

# While others judge, a submission's files are not read repeatedly to check its older reports.
if command -v parallel >/dev/null; then
  cat >"$folder/opens.py" <<'END'
import ctypes, os, select, struct, subprocess, sys
IN_OPEN = 0x20
libc = ctypes.CDLL(None)
watch = libc.inotify_init1(os.O_NONBLOCK)
libc.inotify_add_watch(watch, os.fsencode(sys.argv[1]), IN_OPEN)
run = subprocess.Popen(sys.argv[2:], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
count = 0
while run.poll() is None:
    if select.select([watch], [], [], 0.1)[0]:  # two events that nobody has read become one
        count += len(os.read(watch, 1 << 16)) // struct.calcsize("iIII")
print(count if run.returncode == 0 else 0)
END
  opens() { # SECONDS that each judgement takes; prints how often the file is opened
    echo "sleep $1" >"$folder/hook"
    local learner # the watched learner comes last
    for learner in other right unwritten wrong; do echo "// now $1" >>"$folder/class/$learner/hit_triangle.cpp"; done
    python3 "$folder/opens.py" "$folder/class/wrong/hit_triangle.cpp" "$grader/grade_class" "$folder/class" --out "$folder/chunks" \
      --not-isolated --engine parallel --jobs 1 --config "$folder/programs/grade.json" -- hit_sphere hit_triangle --no-pictures
  }
  short=$(opens 0) long=$(opens 3)
  [ "$short" -gt 0 ] || complain 'nothing was seen'
  [ "$long" -le $((short + 4)) ] || complain "in some seconds more the file was opened $long times, not $short"
fi
