#!/usr/bin/env bash
# A class: submissions from learners and learning platforms, some of which cannot be judged, and a second call, which
# judges only the changes.
# grade_class.sh GRADE_CLASS: the program.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../../fixtures/shell.sh"
program=$1
stops=yes
options='--jobs 1'

# says STATUS WORDS...: calls it with the words of $options; each word is a line of its output, or part of a line.
says() {
  local status=$1 words output got=0
  shift
  output=$("$program" "${class:-$folder/class}" --not-isolated $options -- hit_triangle hit_sphere --no-pictures 2>&1) || got=$?
  [ "$got" -eq "$status" ] || complain "it ended with $got, not $status: $output"
  for words in "$@"; do
    grep -qF -- "$words" <<<"$output" || complain "it does not say '$words': $output"
  done
}

# row EXPRESSION: evaluates Python code; `row` has the lines of the table by submission.
row() {
  python3 - "$folder/class-graded/class.csv" "$1" <<'END' || complain "not so: $1"
import csv, sys
row = {line["submission"]: line for line in csv.DictReader(open(sys.argv[1], newline="", encoding="utf-8-sig"))}
assert eval(sys.argv[2]), row
END
}

mkdir -p "$folder/class/a, flat" "$folder/class/nested/unpacked" "$folder/class/wrong"
cp reference/1_rays/hit_*.cpp "$folder/class/a, flat"
cp -r student "$folder/class/nested/unpacked"
cp reference/1_rays/hit_sphere.cpp "$folder/class/nested/unpacked/student/1_rays"
{ echo '#include "pt/render/radiance.h"'; cat student/1_rays/hit_sphere.cpp; } >"$folder/forbidden.cpp"
mkdir "$folder/class/wrong/1_rays"
cp build/mistakes/hit_triangle/absolute_offset/hit_triangle.cpp "$folder/class/wrong/1_rays/hit_triangle.cpp"
ln -s "$PWD/reference/1_rays/hit_sphere.cpp" "$folder/class/wrong/1_rays/hit_sphere.cpp"

[ ! -e "$folder/class-graded/seed" ] || complain 'there is a seed before anything is graded'
says 0 '1/3 a, flat: 2 of 2 tasks pass' '2/3 nested: 1 of 2' '3/3 wrong: 0 of 2'
row 'row["a, flat"]["hit_triangle"] == row["nested"]["hit_sphere"] == "pass"'
row 'int(row["a, flat"]["points"]) == int(row["a, flat"]["max_points"]) > 0'
row 'row["nested"]["hit_triangle"] == "not attempted" and row["nested"]["hit_triangle_points"] == "0"'
row 'row["wrong"]["hit_triangle"] == "fail" and row["wrong"]["hit_sphere"] == "rejected"'
row 'row["wrong"]["camera_ray"] == "" and len(row) == 3'
# The points of a part include its bonus promises.
row 'int(row["a, flat"]["bonus_points"]) > 0'
row 'int(row["a, flat"]["1_rays_points"]) == int(row["a, flat"]["points"]) + int(row["a, flat"]["bonus_points"])'
grep -qE '"command": "\./run grade hit_triangle hit_sphere --no-pictures --seed [0-9]+"' "$folder/class-graded/nested.json" ||
  complain 'the report does not say how it was made'
grep -q 'hit_sphere' "$folder/class-graded/nested.html" || complain "there is no page"
! grep -qF "$folder" "$folder/class-graded/"{nested,wrong}.html || complain 'a learner would read a path of the instructor'
grep -qF '<dd>nested</dd>' "$folder/class-graded/nested.html" || complain 'the page does not say whose it is'
grep -qF 'href="a%2C%20flat.html"' "$folder/class-graded/class.html" || complain "the page of the class has no link to a page"

cp reference/1_rays/hit_triangle.cpp "$folder/class/wrong/1_rays/"
mkdir "$folder/class/zoe" "$folder/class-graded/zoe.json"
cp "$folder/forbidden.cpp" "$folder/class/zoe/hit_sphere.cpp"
cp student/2_bvh/hit_box.cpp "$folder/class/zoe"
says 2 'a, flat: 2 of 2 tasks pass. '"$(python3 - "$folder/class-graded/class.csv" <<'END'
import csv, sys
line = next(csv.DictReader(open(sys.argv[1], newline="", encoding="utf-8-sig")))
print(f'{line["points"]} of {line["max_points"]} points')
END
)" '(as before)' '3/4 wrong: 1 of 2' '4/4 zoe: '
row 'row["wrong"]["hit_triangle"] == "pass" and row["zoe"]["problem"] != "" and row["zoe"]["points"] == ""'
rmdir "$folder/class-graded/zoe.json"
says 0 '3/4 wrong: 1 of 2 tasks pass' '4/4 zoe: 0 of 2 tasks pass'
# A forbidden header is named, but not the project's folder.
grep -qF 'hit_sphere may not include pt/render/radiance.h' "$folder/class-graded/zoe.html" || complain 'the header is not named'
! grep -qF "$PWD" "$folder/class-graded/zoe.html" || complain 'a learner would read where the project is'

# If a file does not link, the missing name is shown.
mkdir "$folder/class/otto"
: >"$folder/class/otto/hit_sphere.cpp"
says 0 'otto: 0 of 2 tasks pass'
grep -qF "undefined reference to" "$folder/class-graded/otto.html" || complain 'it is not said what is missing'
! grep -qF -e "$PWD" -e kept/ "$folder/class-graded/otto.html" || complain 'a learner would read where the grader is built'
rm -r "$folder/class/otto"

# Two refused files are two problems, even if they are equal: each page has its own reason.
mkdir "$folder/class/"{link,large}
ln -s "$PWD/reference/1_rays/hit_sphere.cpp" "$folder/class/link/hit_sphere.cpp"
{ cat reference/1_rays/hit_sphere.cpp && head -c 2M /dev/zero | tr '\0' ' '; } >"$folder/class/large/hit_sphere.cpp"
says 0 'link: 0 of 2 tasks pass' 'large: 0 of 2 tasks pass'
grep -q 'the file is a link' "$folder/class-graded/link.html" || complain 'a link is not named'
grep -q 'the file is larger than' "$folder/class-graded/large.html" || complain 'a large file is not named'
rm -r "$folder/class/"{link,large}

# The class's seed is drawn once, printed, kept and shown in the reports; another seed judges again.
seed=$(cat "$folder/class-graded/seed")
echo damaged >"$folder/class-graded/seed"
says 2 'seed holds no number; write --seed'
echo "$seed" >"$folder/class-graded/seed"
says 0 "seed $seed " '1/4 a, flat: 2 of 2 tasks pass' '(as before)'
grep -q "\"seed\": $seed," "$folder/class-graded/nested.json" || complain "the report has another seed than $seed"
rm -r "$folder/class/"{nested,zoe,wrong}
options='--jobs 1 --seed 7'
says 0 'seed 7 ' '1/1 a, flat: 2 of 2 tasks pass'
grep -q '"seed": 7,' "$folder/class-graded/a, flat.json" || complain 'the report has another seed than 7'
options='--jobs 1'
says 0 'seed 7 ' '(as before)'

# A name that contains a line break and a colour, and is a formula.
mkdir "$folder/class/=1+1"$'\n\x1b[31mzoe'
cp student/2_bvh/hit_box.cpp "$folder/class/=1+1"$'\n\x1b[31mzoe'
says 0 '1/2 =1+1__[31mzoe: 0 of 2' '2/2 a, flat'
[ "$(wc -l <"$folder/class-graded/class.csv")" -eq 3 ] || complain "$(cat "$folder/class-graded/class.csv")"
! grep -q $'\x1b' "$folder/class-graded/class.csv" || complain 'a colour code in the table'
row 'len(row) == 2 and any(name.startswith("\u0027=1+1_") for name in row)'
rm -rf "$folder/class/"*
says 2 'has no submissions in it'

# As they come: an archive of archives, a broken archive, and one without a file. The other learners are graded.
class=$folder/export.zip
mkdir "$folder/export" && (
  cd "$folder/export"
  mkdir 1_rays
  cp "$OLDPWD"/reference/1_rays/hit_*.cpp 1_rays
  cmake -E tar cf lovelace_LATE_12_34_work-1.zip --format=zip 1_rays
  echo broken >hopper_13_35_work.zip
  mkdir empty
  echo words >empty/notes.txt
  cmake -E tar cf noether_14_36_work.zip --format=zip empty
  cp 1_rays/hit_sphere.cpp germain_15_37_hit_sphere.cpp
  cmake -E tar cf "$class" --format=zip ./*.zip ./*.cpp
)
options='--jobs 3 --out '$folder/class-graded
says 2 'lovelace: 2 of 2' 'germain: 1 of 2' "hopper: 'work.zip' cannot be unpacked" 'noether: it holds none of the files' '4/4 '
row 'row["lovelace"]["late"] == "late" and row["lovelace"]["id"] == "12" and row["lovelace"]["hit_sphere"] == "pass"'
row 'row["hopper"]["points"] == "" and "cannot be unpacked" in row["hopper"]["problem"] and len(row) == 4'
says 2 'lovelace: 2 of 2' '(as before)'

# The files for the platforms: Canvas' table, Moodle's, and the pages under the platforms' names.
python3 - "$folder/class-graded" <<'END' || complain 'Canvas cannot read it'
import csv, sys, zipfile
folder = sys.argv[1]
table = list(csv.DictReader(open(folder + "/canvas.csv", newline="", encoding="utf-8")))
name = [key for key in table[0] if key not in ("Student", "ID", "SIS User ID", "SIS Login ID", "Section")]
assert name == ["export"] and table[0]["Student"].strip() == "Points Possible", table[0]
grades = {row["ID"]: row["export"] for row in table[1:]}
assert set(grades) == {"12", "13", "14", "15"} and grades["13"] == grades["14"] == "", grades
assert int(grades["12"]) > int(grades["15"]) > 0, grades
rows = {row["id"]: row for row in csv.DictReader(open(folder + "/class.csv", newline="", encoding="utf-8-sig"))}
for number in ("12", "15"):
    assert int(rows[number]["bonus_points"]) > 0, rows
    assert int(grades[number]) == int(rows[number]["points"]) + int(rows[number]["bonus_points"]), (grades, rows)
pages = zipfile.ZipFile(folder + "/feedback.zip")
assert pages.testzip() is None
assert set(pages.namelist()) == {"lovelace_LATE_12_34_report.html", "germain_15_37_report.html"}, pages.namelist()
assert pages.read("germain_15_37_report.html") == open(folder + "/germain.html", "rb").read()
END
# Another archive of the same files gives its name to the column. Files unpacked for the old plan stay, because chunks of that
# plan may be running on another machine.
class=$folder/rays.v2.tar.gz
(cd "$folder/export" && cmake -E tar czf "$class" ./*.zip ./*.cpp)
says 2 'lovelace: 2 of 2' '(as before)'
head -1 "$folder/class-graded/canvas.csv" | grep -q ',rays\.v2.$' || complain "$(head -1 "$folder/class-graded/canvas.csv")"
[ "$(find "$folder/class-graded/unpacked" -mindepth 1 -maxdepth 1 | wc -l)" -eq 2 ] || complain 'not two plans are unpacked'
# Of what was unpacked, only the files that are judged stay.
left=$(find "$(find "$folder/class-graded/unpacked" -mindepth 1 -maxdepth 1 -printf '%T@ %p\n' | sort -n | tail -1 | cut -d' ' -f2-)" -type f ! -name 'hit_*.cpp')
[ -z "$left" ] || complain "it is left from unpacking: $left"
rm -r "$folder/class-graded"
class=$folder/moodle
mkdir -p "$class/"{"Zoë 北_7_assignsubmission_file_","Nobody_8_assignsubmission_file_"}
cp reference/1_rays/hit_sphere.cpp "$class/Zoë 北_7_assignsubmission_file_"
says 2 'Zoë 北: 1 of 2' 'Nobody: it holds none'
python3 - "$folder/class-graded" <<'END' || complain 'Moodle cannot read it'
import csv, sys, zipfile
folder = sys.argv[1]
table = {row["Identifier"]: row for row in csv.DictReader(open(folder + "/moodle.csv", newline="", encoding="utf-8"))}
assert set(table) == {"Participant 7", "Participant 8"}, table
zoe, nobody = table["Participant 7"], table["Participant 8"]
# Moodle refuses grades above the maximum.
assert zoe["Full name"] == "Zoë 北" and 0 < int(zoe["Grade"]) <= int(zoe["Maximum Grade"]), zoe
assert nobody["Grade"] == "" and "none of the files" in nobody["Feedback comments"], nobody
assert zipfile.ZipFile(folder + "/feedback.zip").namelist() == ["Zoë 北_7_assignsubmission_file_/report.html"]
END

# Moodle's own worksheet, filled in: the rest stays, also for learners without submission or with a locked grade.
for learner in Participant_9_assignsubmission_file Ada_11_assignsubmission_file_ Stray_12_assignsubmission_file_; do
  mkdir "$class/$learner"
  cp reference/1_rays/hit_sphere.cpp "$class/$learner"
done
# worksheet MAXIMUM: writes $folder/sheet.csv as Moodle exports it.
worksheet() {
  python3 - "$folder" "$1" <<'END'
import csv, sys
columns = ["Identifier", "Full name", "Email address", "Status", "Grade", "Maximum Grade", "Grade can be changed",
           "Last modified (submission)", "Last modified (grade)", "Feedback comments"]
rows = {7: ("Zoë 北", "", "Yes", ""), 8: ("Nobody", "1.00", "Yes", "old"), 9: ("", "", "Yes", ""),
        10: ('زوي "Z"\r\nBob', "", "Yes", "wait,\nfor it"), 11: ("Ada", "3.00", "No", "final")}
with open(sys.argv[1] + "/sheet.csv", "w", newline="", encoding="utf-8-sig") as file:
    sheet = csv.writer(file)
    sheet.writerow(columns)
    for number, (name, grade, can, comment) in rows.items():
        sheet.writerow([f"Participant {number}", name, "a@x.org", "No submission" if number == 10 else "Submitted for grading", grade,
                        sys.argv[2], can, "Monday, 4 January 2027, 10:00 AM", "-", comment])
END
}
most=$(python3 -c 'import csv, sys; print(next(csv.DictReader(open(sys.argv[1], encoding="utf-8")))["Maximum Grade"])' "$folder/class-graded/moodle.csv")
worksheet "$most.00"
options="--jobs 2 --out $folder/class-graded --worksheet $folder/sheet.csv"
says 2 'that Moodle lets their grade not be changed: it stays' 'sheet.csv has no row for 1 of the submissions: Stray' '5/5 '
python3 - "$folder" <<'END' || complain 'the worksheet is not filled in'
import csv, sys
def table(path):
    return {row["Identifier"]: row for row in csv.DictReader(open(sys.argv[1] + path, newline="", encoding="utf-8-sig"))}
before, after = table("/sheet.csv"), table("/class-graded/moodle.csv")
assert list(before) == list(after) == [f"Participant {i}" for i in (7, 8, 9, 10, 11)], after
filled = {(f"Participant {i}", column) for i in (7, 9) for column in ("Grade", "Feedback comments")}
filled.add(("Participant 8", "Feedback comments"))
for key, row in after.items():
    for column in row:
        assert (row[column] != before[key][column]) == ((key, column) in filled), (key, column, row)
for key in ("Participant 7", "Participant 9"):
    assert 0 < int(after[key]["Grade"]) < float(after[key]["Maximum Grade"]), after[key]
    assert "1 of 2 tasks pass" in after[key]["Feedback comments"], after[key]
assert "none of the files" in after["Participant 8"]["Feedback comments"], after
END
worksheet 100.00
says 2 "sheet.csv:2: Moodle's maximum is '100.00', and there are $most points"
[ ! -e "$folder/class-graded/moodle.csv" ] || complain 'there is a worksheet with other points'
[ -e "$folder/class-graded/feedback.zip" ] || complain 'there are no pages'
echo 'Kennung,Bewertung' >"$folder/sheet.csv"
before=$(cat "$folder/class-graded/plan.json")
says 2 "sheet.csv:1: it has no column 'Identifier'; download the grading worksheet with Moodle in English"
[ "$before" = "$(cat "$folder/class-graded/plan.json")" ] || complain 'a plan is made with a file that is not a worksheet'
worksheet "$most"
class=$folder/class
mkdir -p "$class/ada"
cp reference/1_rays/hit_sphere.cpp "$class/ada"
says 2 '--worksheet is for what Moodle exports'

# The program that unpacks an archive runs in a box. Here awk replaces it, and runs the archive's name as its own
# program.
boxed=$(grep -l '"isolation": "[AB]:' "$folder/class-graded/"*.json || true)
rm -rf "$folder/class" "$folder/class-graded"
mkdir "$folder/programs" "$folder/class"
cp "$(dirname "$program")/grade.json" "$folder/programs"
cp "$(readlink -f "$(command -v awk)")" "$folder/programs/unpack"
echo words >"$folder/secret"
looks='BEGIN { s = sprintf("%c", 47); p = "'${folder//\//@}'@secret"; gsub("@", s, p)'
looks+='; print "cannot be unpacked: sees " ((getline x <p) >= 0) " files"; exit 2 } #.zip'
echo words >"$folder/class/$looks"
class=$folder/class options="--jobs 1 --config $folder/programs/grade.json"
if [ -n "$boxed" ] && ! grep -qa __asan_init "$program"; then
  says 2 'cannot be unpacked: sees 0 files'
else
  echo 'NOT TESTED, the box in which archives are unpacked: there is none here'
fi

# A fault of the machine is in nobody's row, submissions contain no reports, and nobody's files are named.
rm -rf "$folder/class" "$folder/class-graded"
mkdir -p "$folder/class/ada"
cp reference/1_rays/hit_sphere.cpp "$folder/class/ada"
echo words >"$folder/class/notes.txt"
options="--jobs 1 --out $folder/class/graded"
says 2 'would lie among the submissions'
[ ! -e "$folder/class/graded" ] || complain 'the folder is made nevertheless'
options='--jobs 1'
says 0 '1 file in the class belongs to nobody: notes.txt'
# A file that may be somebody's work is not passed over. Which of two files counts, and who has the same files, is said.
cp reference/1_rays/hit_sphere.cpp "$folder/class/hit_sphere.cpp"
says 2 '2 files in the class belong to nobody: hit_sphere.cpp, notes.txt'
status=0
"$program" collect "$folder/class-graded" >"$folder/said" 2>&1 || status=$?
[ "$status" -eq 2 ] && grep -q '2 files in the class belong to nobody: hit_sphere.cpp' "$folder/said" ||
  complain "collect passes over a file that may be work: $status, $(cat "$folder/said")"
rm "$folder/class/hit_sphere.cpp"
mkdir -p "$folder/class/"{bob,cy/old,stub,stub2}
cp reference/1_rays/hit_sphere.cpp "$folder/class/bob"
cp student/1_rays/hit_sphere.cpp "$folder/class/stub"
cp student/1_rays/hit_sphere.cpp "$folder/class/stub2"
{ cat reference/1_rays/hit_sphere.cpp; echo '// by cy'; } >"$folder/class/cy/hit_sphere.cpp"
echo '// old' >"$folder/class/cy/old/hit_sphere.cpp"
says 0 'ada: 1 of 2' 'stub2: 0 of 2'
row 'row["ada"]["note"] == row["bob"]["note"] == "the same files: ada, bob"'
row 'row["stub"]["note"] == row["stub2"]["note"] == ""'
row 'row["cy"]["note"] == "\u0027hit_sphere.cpp\u0027 counts, and not \u0027old/hit_sphere.cpp\u0027, which differs"'
grep -q 'old/hit_sphere.cpp' "$folder/class-graded/cy.html" || complain 'the page does not say which file counts'
grep -q 'the same files: ada, bob' "$folder/class-graded/class.html" || complain 'the page of the class does not say who has the same files'
! grep -q bob "$folder/class-graded/ada.html" || complain "a learner's page names another learner"
# What is alike is on a page of its own, with its share of the class, and the files lie as JPlag wants them.
alike=$folder/class-graded/likeness
grep -q '2 of 3 (67 %).*ada.html.*bob.html' "$alike.html" || complain "the page of what is alike: $(cat "$alike.html")"
grep -q '<strong>100 %</strong> <code>hit_sphere</code>.*ada.html.*cy.html' "$alike.html" || complain 'it does not see that a comment differs'
! grep -q 'stub' "$alike.html" || complain 'what is not written is alike'
cmp -s "$alike/cy/hit_sphere.cpp" "$folder/class/cy/hit_sphere.cpp" && [ "$(ls "$alike")" = $'ada\nbob\ncy\nstub\nstub2' ] ||
  complain "JPlag would compare: $(ls -R "$alike")"
options='--jobs 1 --no-likeness'
says 0 'ada: 1 of 2'
[ ! -e "$alike" ] && [ ! -e "$alike.html" ] || complain 'the switch does not turn it off'
options='--jobs 1'
rm -r "$folder/class/"{bob,cy,stub,stub2}
options="--jobs 1 --compare $folder/class"
says 2 'has no grading of a class'
options='--jobs 1'
cp "$(readlink -f "$(command -v awk)")" "$folder/programs/unpack"
echo words >"$folder/class/BEGIN { exit 3 } #.zip"
options="--jobs 1 --config $folder/programs/grade.json"
says 2 'could not be unpacked' 'run this again'

# At its limit of processor time, the unpacking program reports the archive before the kernel kills it.
mkdir "$folder/slow"
head -c 40M /dev/urandom >"$folder/slow/noise.txt"
(cd "$folder/slow" && cmake -E tar cjf ../slow.tar.bz2 noise.txt)
status=0
(cd "$folder/slow" && ulimit -t 3 && "$(dirname "$program")/unpack" slow.tar.bz2 one <../slow.tar.bz2 2>"$folder/said") || status=$?
[ "$status" -eq 2 ] || complain "it ended with $status at its limit of time: $(cat "$folder/said")"
grep -q 'it takes too long' "$folder/said" || complain "$(cat "$folder/said")"
