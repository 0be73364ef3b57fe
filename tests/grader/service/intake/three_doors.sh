#!/usr/bin/env bash
# The same files get the same verdict as a submission of a class, by ./run grade, and by the autograder of each platform, in
# whatever form they are handed in.
# three_doors.sh GRADER: the folder with the programs.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../../fixtures/shell.sh"
grader=$1

mkdir "$folder/class" "$folder/autograder" "$folder/grade"
python3 - "$folder/class" <<'END'
import io, os, sys, tarfile, zipfile
box, sphere = (open("reference/" + file, "rb").read() for file in ("2_bvh/hit_box.cpp", "1_rays/hit_sphere.cpp"))
other = sphere + b"// another\n"

def packed(files):
    bytes = io.BytesIO()
    with zipfile.ZipFile(bytes, "w") as archive:
        for name, text in files.items() if isinstance(files, dict) else files:
            archive.writestr(name, text)
    return bytes.getvalue()

def tar_gz(files):
    bytes = io.BytesIO()
    with tarfile.open(fileobj=bytes, mode="w:gz") as archive:
        for name, text in files.items():
            entry = tarfile.TarInfo(name)
            entry.size = len(text)
            archive.addfile(entry, io.BytesIO(text))
    return bytes.getvalue()

work = {"work/1_rays/hit_sphere.cpp": sphere, "work/2_bvh/hit_box.cpp": box}
forms = {
    "plain": {"hit_sphere.cpp": sphere, "hit_box.cpp": box},
    "parts": {"1_rays/hit_sphere.cpp": sphere, "2_bvh/hit_box.cpp": box},
    "numbered": {"hit_sphere (1).cpp": sphere, "hit_box-2.cpp": box},
    "capital": {"Hit_Sphere.cpp": sphere, "hitbox.CPP": box},
    "text": {"hit_sphere.cpp.txt": sphere},
    "beside": {"report.pdf": b"?", **work},
    "deep": {"a/b/student/1_rays/hit_sphere.cpp": sphere, "README": b"?"},
    "wrong part": {"1_rays/hit_box.cpp": box, "1_rays/hit_sphere.cpp": sphere},
    "project": {"p/pt/a.h": b"", "p/grader/hit_sphere.cpp": other, "p/student/1_rays/hit_sphere.cpp": sphere},
    "tar": {"work.tar.gz": tar_gz(work)},
    "zip": {"work.zip": packed(work), "report.pdf": b"?"},
    "zip in zip": {"work.zip": packed({"inner.zip": packed(work)})},
    "rest": {"hit_sphere.cpp": sphere, "rest.zip": packed({"hit_box.cpp": box, "hit_sphere.cpp": other})},
    "twice": {"work.zip": packed([("hit_sphere.cpp", other), ("hit_sphere.cpp", sphere)])},
    "two zips": {"a.zip": packed(work), "b.zip": packed(work)},
    "two files": {"a/hit_sphere.cpp": sphere, "b/hit_sphere.cpp": other},
    "outer": {"hit_sphere.cpp": sphere, "old/hit_sphere.cpp": other},
    "broken": {"work.zip": b"PK no archive"},
    "one broken": {"hit_sphere.cpp": sphere, "work.zip": b"PK no archive"},
    "large": {"hit_sphere.cpp": sphere, "Hit_Box.cpp": b" " * (1 << 20) + b"1"},
    "nothing": {"report.pdf": b"?"},
    "rar": {"work.lz": b"?"},
    "named otherwise": {"hit_sphere.cpp": sphere, "hit_box_final.cpp": box, "rest.lz": b"?"},
}
for form, files in forms.items():
    for name, text in files.items():
        path = f"{sys.argv[1]}/{form}/{name}"
        os.makedirs(os.path.dirname(path), exist_ok=True)
        open(path, "wb").write(text)
os.makedirs(sys.argv[1] + "/link")
os.symlink(os.path.abspath("reference/1_rays/hit_sphere.cpp"), sys.argv[1] + "/link/hit_sphere.cpp")
END

what=(hit_sphere hit_box --no-pictures)
"$grader/grade_class" "$folder/class" --seed 7 --not-isolated -- "${what[@]}" >"$folder/said" 2>&1 || [ $? -eq 2 ] ||
  complain "the class: $(cat "$folder/said")"
export FIRSTLIGHT_AUTOGRADER=$folder/autograder
mkdir -p "$folder/autograder/source/build"
ln -s "$(dirname "$grader")" "$folder/autograder/source/build/check"
for submission in "$folder/class/"*; do
  name=$(basename "$submission")
  "$grader/grade" "${what[@]}" --seed 7 --submission "$submission" --json "$folder/grade/$name.json" >"$folder/grade/$name.txt" 2>&1 ||
    [ $? -eq 1 ] || complain "./run grade, $name: $(cat "$folder/grade/$name.txt")"
  rm -rf "$folder/autograder/submission"
  cp -r "$submission" "$folder/autograder/submission"
  scripts/editions/autograder/run_autograder --seed 7 "${what[@]}" >"$folder/said" 2>&1
  ! grep -q 'require-isolation refuses' "$folder/said" || { echo 'NOT TESTED: nothing isolates here'; exit 77; }
  cp "$folder/autograder/results/results.json" "$folder/grade/$name.scope"
  # The others take it where their containers have it; Autolab takes one file only.
  case $name in rest | numbered | outer | nothing | broken) ;; *) continue ;; esac
  (
    export FIRSTLIGHT_GRADE=$folder/grade/$name
    mkdir -p "$FIRSTLIGHT_GRADE/assignment"
    cp -r "$submission" "$FIRSTLIGHT_GRADE/student"
    cp -r "$submission" "$FIRSTLIGHT_GRADE/assignment/handed in"
    (cd "$submission" && cmake -E tar cf "$FIRSTLIGHT_GRADE/handin.zip" --format=zip .)
    run=$PWD/scripts/editions/autograder/run_autograder
    cd "$FIRSTLIGHT_GRADE"
    for platform in prairielearn autolab artemis; do "$run" $platform --seed 7 "${what[@]}" >$platform 2>$platform.errors; done
  )
done
# Files may not become large here, so unpacking fails.
(ulimit -f 2; "$grader/grade" "${what[@]}" --submission "$folder/class/tar") >"$folder/said" 2>&1 && complain 'unpacked all the same'
grep -q 'could not be unpacked' "$folder/said" || complain "unpacking failed: $(cat "$folder/said")"
# Copies are named after the process that made them. Other tests may be at work beside this one.
for copy in "$grader"/graded/intake/*.*; do
  pid=${copy##*/}
  [ -d "/proc/${pid%.*}" ] || [ ! -e "$copy" ] || complain "the copy $copy of what was handed in is left"
done

python3 - "$folder" <<'END' || complain 'the doors differ'
import csv, json, sys, xml.etree.ElementTree
rows = {row["submission"]: row for row in csv.DictReader(open(sys.argv[1] + "/class-graded/class.csv", encoding="utf-8-sig"))}
assert len(rows) == 24, rows.keys()
for name, row in rows.items():
    results = json.load(open(f"{sys.argv[1]}/grade/{name}.json"))
    scope = json.load(open(f"{sys.argv[1]}/grade/{name}.scope"))
    text = open(f"{sys.argv[1]}/grade/{name}.txt").read()
    said = scope["output"] + "".join(test["output"] for test in scope["tests"])
    points = {task["slug"]: task["points"] + task["bonus_points"] for task in results["tasks"]}
    in_class = {slug: int(row[slug + "_points"] or 0) for slug in points}
    assert in_class == points, (name, row, points)
    assert scope["score"] == sum(points.values()), (name, scope)
    for task in results["tasks"]:
        if not row["problem"]:
            assert task["state"].replace("_", " ") == row[task["slug"]], (name, task)
    for sentence in (row["problem"], row["note"].split("the same files:")[0].rstrip("; ")):
        assert sentence in text.replace("\n", " ") and sentence in said, (name, sentence, text, said)
# Each platform's own program reads these files so: see autograders_test.cpp.
for name in ("rest", "numbered", "outer", "nothing", "broken"):
    folder = f"{sys.argv[1]}/grade/{name}/"
    tasks = json.load(open(f"{sys.argv[1]}/grade/{name}.json"))["tasks"]
    points = {task["slug"]: task["points"] + task["bonus_points"] for task in tasks}
    learn = json.load(open(folder + "results/results.json"))
    in_tests = {test["name"].split()[-1]: test["points"] for test in learn["tests"]}
    bonus = sum(task["bonus_points"] for task in tasks)
    assert in_tests.pop("bonus", 0) == bonus, (name, learn)
    assert in_tests == {task["slug"]: task["points"] for task in tasks}, (name, learn)
    most = sum(task["max_points"] for task in tasks)
    assert learn["gradable"] and abs(learn["score"] - min(1, sum(points.values()) / most)) < 1e-9, (name, learn)
    assert json.loads(open(folder + "autolab").read().splitlines()[-1]) == {"scores": points}, name
    tests = xml.etree.ElementTree.parse(folder + "results/firstlight.xml").getroot()
    passed = [test.get("name").split()[0] for test in tests if test.find("failure") is None]
    assert {slug: passed.count(slug) for slug in points} == points, (name, passed)
right = int(rows["plain"]["hit_sphere_points"])
assert right > 0
for name in ("parts", "numbered", "capital", "text", "beside", "deep", "wrong part", "project", "tar", "zip", "zip in zip", "rest", "outer", "twice", "one broken"):
    assert rows[name]["hit_sphere_points"] == str(right), rows[name]
large = next(task for task in json.load(open(sys.argv[1] + "/grade/large.json"))["tasks"] if task["slug"] == "hit_box")
assert (large["state"], large["reason"]) == ("rejected", "the file is larger than 1 MiB"), large
for name in ("two zips", "two files", "broken", "nothing", "rar"):
    assert rows[name]["problem"], rows[name]
END
finish
