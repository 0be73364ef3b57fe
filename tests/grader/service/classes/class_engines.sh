#!/usr/bin/env bash
# A class gets the same table chunk by chunk, through GNU parallel and through Slurm, and nothing is judged twice.
# class_engines.sh GRADER [parallel | slurm]: the folder with grade_class and its grade.json, and an engine; without
# an engine, the class is graded step by step.
set -euo pipefail
grader=$1
engine=${2:-}
# shellcheck source=tests/grader/service/classes/class_fixture.sh
. "$(dirname "${BASH_SOURCE[0]}")/class_fixture.sh"

case $engine in
  parallel) command -v parallel >/dev/null || { echo 'GNU parallel is missing (parallel): not tried'; exit 77; } ;;
  slurm) why=$(why_no_slurm); [ -z "$why" ] || { echo "$why"; exit 77; } ;;
esac
log_what_is_judged "$grader"
make_class 7 # 2 and 7 are equal

status=0
grade_class here --jobs 2 || status=$?
[ "$status" -eq 2 ] || complain "it ended with $status: $(cat "$folder/said")"
for words in '8/8 ' 'nobody: it holds none'; do
  grep -q "$words" "$folder/said" || complain "$(cat "$folder/said")"
done
[ "$(wc -l <"$folder/judged")" -eq 6 ] || complain "equal submissions were judged twice: $(cat "$folder/judged")"
judged_once
python3 - "$folder/here/class.csv" <<'END' || complain 'the table is not so'
import csv, sys
rows = {row["submission"]: row for row in csv.DictReader(open(sys.argv[1], newline="", encoding="utf-8-sig"))}
assert len(rows) == 8
a, b = rows["learner 2"], rows["learner 7"]
assert all(a[key] == b[key] for key in a if key != "submission") and a["hit_sphere"] == "pass", (a, b)
assert rows["learner 5"]["hit_sphere"] == "not attempted" and rows["learner 5"]["points"] == "0", rows
for row in rows.values():
    assert row["1_rays_points"] == row["hit_sphere_points"] and row["2_bvh_points"] == "", row
END
grep -q '"submission": "learner 7"' "$folder/here/learner 7.json" || complain 'an equal submission has the name of another'
grep -q '<dd>learner 7</dd>' "$folder/here/learner 7.html" || complain 'an equal submission has the page of another'

if [ -z "$engine" ]; then
  grade_class steps plan --chunk-size 2 || complain "$(cat "$folder/said")"
  grep -q '8 submissions in 3 chunks' "$folder/said" || complain "$(cat "$folder/said")"
  step() { "$grader/grade_class" "$1" "$folder/steps" "${@:2}" --config "$folder/programs/grade.json" >"$folder/said" 2>&1; }
  status=0
  step chunk 4 || status=$?
  [ "$status" -eq 2 ] || complain "a chunk that is not there ends with $status"
  grep -q 'there is no chunk 4' "$folder/said" || complain "$(cat "$folder/said")"
  step chunk 2 || complain "$(cat "$folder/said")"
  ! step collect || complain 'it says that all is judged'
  grep -q '^2 of 8 submissions are judged' "$folder/said" || complain "$(cat "$folder/said")"
  grep -q '^learner 1,.*not judged yet' "$folder/steps/class.csv" || complain "$(cat "$folder/steps/class.csv")"
  # Two chunks at the same time that begin with the same submission.
  step chunk 3 1 & first=$!
  "$grader/grade_class" chunk "$folder/steps" 3 2 1 --config "$folder/programs/grade.json" >/dev/null 2>&1 || complain 'a chunk fails'
  wait "$first" || complain "$(cat "$folder/said")"
  step collect || true
  judged_once
  same_reports here steps

  # A promise is worth more, another one nothing. Nobody is judged again; gains and losses are shown.
  sed -i 's/"tasks": {}/"tasks": {"hit_sphere": {"promise": 2, "promises": {"PROMISE": 0}}}/' "$folder/root/grader/points.json"
  # A name that is not a promise's is told once, and before anything is judged.
  status=0
  grade_class again || status=$?
  [ "$status" -eq 2 ] && [ "$(grep -c 'PROMISE is not a promise of its task' "$folder/said")" -eq 1 ] && [ ! -e "$folder/again/plan.json" ] ||
    complain "bad points: $status, $(cat "$folder/said")"
  broken=$(python3 -c 'import json, sys; print(next(p["name"] for p in json.load(open(sys.argv[1]))["tasks"][0]["promises"] if not p["held"] and not p["bonus"]))' \
    "$folder/here/learner 3.json")
  sed -i "s/PROMISE/$broken/" "$folder/root/grader/points.json"
  # So is a golden that somebody has exchanged.
  mv "$folder/root/golden" "$folder/goldens"
  cp -r golden "$folder/root/golden"
  cp golden/rays_star.exr "$folder/root/golden/rays_spheres.exr"
  status=0
  grade_class again || status=$?
  [ "$status" -eq 2 ] && [ "$(grep -c 'golden/rays_spheres.exr is not the golden that was made' "$folder/said")" -eq 1 ] &&
    [ ! -e "$folder/again/plan.json" ] || complain "an exchanged golden: $status, $(cat "$folder/said")"
  rm -r "$folder/root/golden"
  mv "$folder/goldens" "$folder/root/golden"
  status=0
  "$grader/grade_class" "$folder/class" --out "$folder/again" --compare "$folder/here" --not-isolated \
    --config "$folder/programs/grade.json" -- hit_sphere --no-pictures >"$folder/said" 2>&1 || status=$?
  [ "$status" -eq 2 ] || complain "$(cat "$folder/said")"
  [ ! -e "$folder/judged" ] || complain "judged again: $(cat "$folder/judged")"
  grep -q '^seed 7 ' "$folder/said" || complain 'it has another seed than the one before'
  python3 - "$folder" <<'END' || complain 'the comparison is not so'
import csv, sys
def table(path):
    return list(csv.DictReader(open(sys.argv[1] + path, newline="", encoding="utf-8-sig")))
before, after = ({row["submission"]: row for row in table(f"/{name}/class.csv")} for name in ("here", "again"))
full = int(before["learner 1"]["max_points"])
assert int(after["learner 1"]["max_points"]) == 2 * (full - 1) and after["learner 1"]["points"] == after["learner 1"]["max_points"]
changes = table("/again/compare.csv")
by = {}
for row in changes:
    assert row["task"] == "hit_sphere" and int(row["promise_before"]) != int(row["promise_after"]), row
    by[row["submission"]] = by.get(row["submission"], 0) + int(row["promise_after"]) - int(row["promise_before"])
def points(row):
    return int(row["points"]) + int(row["bonus_points"])
for name, row in after.items():
    if row["points"]:
        assert by.get(name, 0) == points(row) - points(before[name]), (name, row)
assert by["learner 1"] > 0 and "learner 5" not in by and "nobody" not in by, by
END
  grep -q 'gain points, 0 lose points' "$folder/said" || complain "$(cat "$folder/said")"
  grep -q 'learner%201.html' "$folder/again/compare.html" || complain 'the page of the comparison does not name who gains'
  status=0
  "$grader/grade_class" "$folder/class" --out "$folder/again" --compare "$folder/again" --config "$folder/programs/grade.json" >"$folder/said" 2>&1 || status=$?
  [ "$status" -eq 2 ] || complain 'it compares a folder with itself'
  grep -q 'cannot be compared with themselves' "$folder/said" || complain "$(cat "$folder/said")"

  # Names appear only in the files that may contain them.
  grade_class hidden --anonymous || true
  ! grep -rlE 'learner [1-7]|nobody' "$folder/hidden" --include='*.html' --include='*.json' --include='class.csv' ||
    complain 'an anonymous class has names'
  python3 - "$folder" <<'END' || complain "$(cat "$folder/hidden/names.csv")"
import csv, os, sys
folder = sys.argv[1]
def table(path):
    return list(csv.DictReader(open(folder + path, newline="", encoding="utf-8-sig")))
names = {row["submission"]: row["name"] for row in table("/hidden/names.csv")}
points = {row["submission"]: row["points"] for row in table("/again/class.csv")}
hidden = table("/hidden/class.csv")
assert sorted(names.values()) == sorted(points), names
assert sorted(names) == sorted(row["submission"] for row in hidden), names
for row in hidden:  # whose number it is
    assert row["points"] == points[names[row["submission"]]], row
END
  numbers() { grep -o '"submission-[0-9a-f]*"' "$folder/$1/plan.json" | sort; }
  before=$(numbers hidden)
  for plan in hidden other; do grade_class "$plan" plan --anonymous || complain "$(cat "$folder/said")"; done
  [ "$before" = "$(numbers hidden)" ] || complain 'a second plan has other numbers'
  [ "$before" != "$(numbers other)" ] || complain 'who knows the names knows the numbers'

  # An anonymous grading does not overwrite one with names; an archive's name may be a learner's.
  ! grade_class here --anonymous || complain 'reports with names become anonymous'
  grep -q 'has reports that show names' "$folder/said" || complain "$(cat "$folder/said")"
  echo broken >"$folder/class/learner 9.zip"
  grade_class hidden --anonymous || true
  ! grep -r 'learner 9' "$folder/hidden/class.csv" "$folder/hidden/class.html" || complain 'a problem names the learner'
  grep -q "'…' cannot be unpacked" "$folder/hidden/class.csv" || complain "$(cat "$folder/hidden/class.csv")"
  # An anonymous grading is compared with one by name, learner by learner, without naming anybody.
  rm "$folder/class/learner 9.zip" "$folder/judged"
  mv "$folder/class/learner 5" "$folder/withdrawn"
  "$grader/grade_class" "$folder/class" --out "$folder/hidden again" --compare "$folder/here" --anonymous --not-isolated \
    --config "$folder/programs/grade.json" -- hit_sphere --no-pictures >"$folder/said" 2>&1 || true
  [ ! -e "$folder/judged" ] || complain "judged again: $(cat "$folder/judged")"
  ! grep -E 'learner [1-9]' "$folder/hidden again/compare."* || complain 'a comparison names a learner'
  [ "$(wc -l <"$folder/hidden again/compare.csv")" -gt 3 ] || complain "nobody is compared: $(cat "$folder/hidden again/compare.csv")"
  exit 0
fi

[ "$engine" != slurm ] || start_slurm "$folder/slurm" || complain 'Slurm does not start'
status=0
options=(--sshlogin=:)
[ "$engine" != slurm ] || options=(--comment=of-a-test --time=60)
grade_class elsewhere --engine "$engine" --chunk-size 2 --jobs 2 "${options[@]/#/--engine-option=}" || status=$?
[ "$status" -eq 2 ] || complain "it ended with $status: $(cat "$folder/said")" "$(cat "$folder/elsewhere/engine.log")"
grep -q '8/8 ' "$folder/said" || complain "$(cat "$folder/said")"
! grep -q 'as before' "$folder/said" || complain "what is judged now counts as judged before: $(cat "$folder/said")"
[ "$(wc -l <"$folder/judged")" -eq 6 ] || complain "judged: $(cat "$folder/judged")"
judged_once
same_reports here elsewhere
case $engine in
  parallel) [ "$(grep -c 'grade_class' "$folder/elsewhere/joblog")" -eq 3 ] || complain "$(cat "$folder/elsewhere/joblog")" ;;
  slurm) grep -q 'learner 1: ' "$folder/elsewhere/slurm/1.log" || complain "$(cat "$folder"/elsewhere/slurm/*)" ;;
esac

# A second call judges only new submissions.
echo '// again' >>"$folder/class/learner 3/hit_sphere.cpp"
grade_class elsewhere --engine "$engine" --chunk-size 2 || true
[ "$(cat "$folder/judged")" = 'learner 3' ] || complain "judged again: $(cat "$folder/judged")"
[ "$(grep -c 'as before' "$folder/said")" -eq 6 ] || complain "$(cat "$folder/said")"
