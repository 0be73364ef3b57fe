#!/usr/bin/env bash
# What an instructor says about a class: a roster with a late and a missing learner and an extension, the penalty, and points by
# hand that outlive a regrade.
# class_rules.sh GRADER: the folder with grade_class and its grade.json.
set -euo pipefail
grader=$1
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../../fixtures/shell.sh"
stops=yes
export TZ=UTC

# grades STATUS OPTIONS ...: grades the class into $folder/graded; $folder/said has the output.
grades() {
  local status=$1 got=0
  shift
  "$grader/grade_class" "$folder/class" --out "$folder/${out:-graded}" --seed 7 --not-isolated "$@" -- hit_sphere --no-pictures \
    >"$folder/said" 2>&1 || got=$?
  [ "$got" -eq "$status" ] || complain "$* ended with $got, not $status: $(cat "$folder/said")"
}
says() { grep -qF -- "$1" "$folder/said" || complain "it does not say '$1': $(cat "$folder/said")"; }

# row EXPRESSION: evaluates Python code; `row` has the lines of the table by submission, `full` the points of correct work.
row() {
  python3 - "$folder/${out:-graded}/class.csv" "$1" <<'PYTHON' || complain "not so: $1: $(cat "$folder/graded/class.csv")"
import csv, sys
row = {line["submission"]: line for line in csv.DictReader(open(sys.argv[1], newline="", encoding="utf-8-sig"))}
full = int(row["Ada"]["points"]) + int(row["Ada"]["bonus_points"])
assert eval(sys.argv[2])
PYTHON
}

# hand_in NUMBER NAME DATE: a file as D2L names it.
mkdir "$folder/class"
hand_in() { cp reference/1_rays/hit_sphere.cpp "$folder/class/$1-9 - $2 - $3 - hit_sphere.cpp"; }
hand_in 1 Ada 'Jan 15, 2027 0959 PM'
hand_in 2 Bob 'Jan 15, 2027 1010 PM'
hand_in 3 Cy 'Jan 17, 2027 1000 AM'
hand_in 4 Zoë 'Jan 17, 2027 1000 AM'
hand_in 5 Stray 'Jan 15, 2027 0900 PM'
cat >"$folder/roster.csv" <<'CSV'
ID;Name;Due;email
1-9;Ada Lovelace;;ada@x.org
;bob;;
3-9;Cy;;
;ZOË;2027-01-17 12:00;
6-9;"Missing; M";;
CSV
grades 0 --roster "$folder/roster.csv" --due '2027-01-15 22:00' --grace 15 --penalty 10
says 'due 2027-01-15 22:00, 15 minutes of grace, 10 % less for each day'
says 'roster.csv has no row for 1 of the submissions: Stray'
says '1 of the roster handed in nothing'
row 'len(row) == 6 and full > 8'
row 'row["Missing; M"]["points"] == row["Missing; M"]["grade"] == "0" and row["Missing; M"]["problem"] == "nothing was handed in"'
row 'all(row[name]["grade"] == str(full) and not row[name]["late"] for name in ("Ada", "Bob", "Zoë", "Stray"))'
row 'row["Cy"]["late"] == "late" and row["Cy"]["days_late"] == "2" and row["Cy"]["points"] == row["Ada"]["points"]'
row 'int(row["Cy"]["grade"]) == full - full * 20 // 100'
row '"not in the roster" in row["Stray"]["note"] and "roster" not in row["Ada"]["note"]'
grep -qF '2 days late, 20 % less' "$folder/graded/Cy.html" || complain 'the page does not say what lateness costs'
! grep -qF 'Grade:' "$folder/graded/Ada.html" || complain 'a grade that is that of the points has a sentence'
grep -qF 'What was handed in: hit_sphere.cpp' "$folder/graded/Ada.html" || complain 'the page does not show the code'
grep -qF '<strong>1</strong> of the roster handed in nothing' "$folder/graded/class.html" || complain 'the class page has nobody missing'

# Points by hand count in place of the judged ones, and stay when only the class is named again, and in another folder.
printf 'id,name,points,word\n3-9,,17,"ill, with a note"\n6-9,,5,shown in person\n,Ada,,<b>well done</b>\n' >"$folder/by hand.csv"
grades 0 --overrides "$folder/by hand.csv"
says 'overrides '
row 'row["Cy"]["grade"] == "17" and row["Cy"]["grade_reason"] == "by hand: ill, with a note" and row["Cy"]["points"] == row["Ada"]["points"]'
row 'row["Missing; M"]["grade"] == "5" and row["Ada"]["grade"] == str(full)'
cp "$folder/graded/Cy.html" "$folder/before.html"
grades 0
cmp "$folder/before.html" "$folder/graded/Cy.html" || complain 'a page is not the same when it is written again'
sed -i 's/,17,/,18,/' "$folder/by hand.csv"
"$grader/grade_class" collect "$folder/graded" >"$folder/said" 2>&1 || complain "$(cat "$folder/said")"
row 'row["Cy"]["grade"] == "18"'
sed -i 's/,18,/,17,/' "$folder/by hand.csv"
hand_in 3 Cy 'Jan 18, 2027 1000 AM'
echo '// changed' >>"$folder/class/3-9 - Cy - Jan 18, 2027 1000 AM - hit_sphere.cpp"
out=again grades 0 --compare "$folder/graded"
out=again row 'row["Cy"]["grade"] == "17" and row["Cy"]["days_late"] == "3" and "of several attempts the last counts" in row["Cy"]["note"]'
grep -qF 'Grade: 17 points (by hand: ill, with a note).' "$folder/again/Cy.html" || complain 'the page has no grade by hand'
grep -qF '&lt;b&gt;well done' "$folder/again/Ada.html" || complain 'a word by hand is not shown as it is'
grades 0 --overrides '' --penalty 0
row 'row["Cy"]["grade"] == str(full) and row["Missing; M"]["grade"] == "0"'

# The first attempt alone, and its time.
out=first grades 0 --attempt first --penalty 10 --due '2027-01-15 22:00' --roster "$folder/roster.csv" --overrides ''
says 'the first of several attempts counts'
out=first row 'row["Cy"]["days_late"] == "2" and row["Cy"]["note"].startswith("of several attempts the first counts")'
! grep -qF '// changed' "$folder/first/Cy.html" || complain 'a later attempt counts'
grep -qF '// changed' "$folder/graded/Cy.html" || complain 'the last attempt does not count'

# Moodle's worksheet has the times.
mkdir "$folder/moodle"
for learner in 'Ada L_7' Bob_8; do
  mkdir "$folder/moodle/${learner}_assignsubmission_file"
  cp reference/1_rays/hit_sphere.cpp "$folder/moodle/${learner}_assignsubmission_file"
done
cat >"$folder/sheet.csv" <<'CSV'
Identifier,Full name,Grade,Maximum Grade,Grade can be changed,Last modified (submission)
Participant 7,Ada L,,MOST,Yes,"Friday, 15 January 2027, 9:59 PM"
Participant 8,Bob,,MOST,Yes,"Saturday, 16 January 2027, 11:05 PM"
Participant 9,Cy,,MOST,Yes,-
CSV
sed -i "s/MOST/$(python3 -c 'import csv, sys; print(int(next(csv.DictReader(open(sys.argv[1], encoding="utf-8-sig")))["points"]))' "$folder/graded/class.csv")/" "$folder/sheet.csv"
mv "$folder/class" "$folder/of d2l"
mv "$folder/moodle" "$folder/class"
out=moodle grades 0 --worksheet "$folder/sheet.csv" --due '2027-01-15 22:00' --penalty 10
out=moodle python3 - "$folder/moodle/class.csv" <<'PYTHON' || complain 'the times of the worksheet do not count'
import csv, sys
row = {line["submission"]: line for line in csv.DictReader(open(sys.argv[1], newline="", encoding="utf-8-sig"))}
assert row["Ada L"]["days_late"] == "" and row["Bob"]["days_late"] == "2" and row["Bob"]["grade_reason"] == "2 days late, 20 % less"
PYTHON
rm -r "$folder/class"
mv "$folder/of d2l" "$folder/class"

# Without a time that anybody names, nothing is taken off, which is said; a roster may have the time.
cp -r "$folder/class" "$folder/with times"
rm -r "$folder/class/"*
for learner in ada bob; do
  mkdir "$folder/class/$learner"
  cp reference/1_rays/hit_sphere.cpp "$folder/class/$learner"
done
mkdir "$folder/class/stub"
cp student/1_rays/hit_sphere.cpp "$folder/class/stub"
printf 'name,handed_in\nADA,\nbob,2027-01-16T01:30+02:00\n' >"$folder/roster.csv"
grades 0 --penalty 50
! grep -qF 'What was handed in' "$folder/graded/stub.html" || complain 'a page shows a file that is as it was handed out'
says 'nothing says when 2 of the submissions were handed in, so nothing is taken off'
python3 - "$folder/graded/class.csv" <<'PYTHON' || complain 'the time of the roster does not count'
import csv, sys
row = {line["submission"]: line for line in csv.DictReader(open(sys.argv[1], newline="", encoding="utf-8-sig"))}
assert row["ada"]["days_late"] == "" and row["bob"]["days_late"] == "1" and int(row["bob"]["grade"]) < int(row["ada"]["grade"])
PYTHON

# An instructor's form of names holds in an archive of the class too, which is unpacked in a box.
mkdir "$folder/named"
for learner in x_Ada_7 x_Bob_8; do
  mkdir "$folder/named/$learner"
  cp reference/1_rays/hit_sphere.cpp "$folder/named/$learner"
done
(cd "$folder/named" && python3 -m zipfile -c "$folder/named.zip" x_Ada_7 x_Bob_8)
printf 'platform,pattern\nours,{any}_{name}_{number}\n' >"$folder/forms.csv"
"$grader/grade_class" plan "$folder/named.zip" --out "$folder/planned" --forms "$folder/forms.csv" --not-isolated -- hit_sphere >"$folder/said" 2>&1 ||
  complain "a class with a form of its own has no plan: $(cat "$folder/said")"
python3 - "$folder/planned/plan.json" <<'PYTHON' || complain 'the form of the instructor does not hold in an archive'
import json, sys
everybody = json.load(open(sys.argv[1]))["everybody"]
assert [(by["name"], by["id"], by["problem"]) for by in everybody] == [("Ada", "7", ""), ("Bob", "8", "")], everybody
PYTHON
printf 'platform,pattern\nours,{nobody}_{file}\n' >"$folder/forms.csv"
grades 2 --forms "$folder/forms.csv"
says "forms.csv:2: '{nobody}_{file}': there is no field {nobody}"

# Bad input: one sentence, and nothing is judged.
refuses() {
  printf '%b' "$2" >"$folder/$1"
  grades 2 --roster "$folder/roster.csv" --overrides "$folder/by hand.csv"
  says "$3"
  printf 'name,points\nada,1\n' >"$folder/by hand.csv"
  printf 'name\nada\nbob\n' >"$folder/roster.csv"
}
printf 'name,points\nada,1\n' >"$folder/by hand.csv"
refuses roster.csv 'who\nada\n' "roster.csv:1: it has no column 'id' and none 'name'"
refuses roster.csv 'name,due\nada,tomorrow\n' "roster.csv:2: 'tomorrow' in the column 'due' is no time"
refuses roster.csv 'name,due\nada,2027-02-30 10:00\n' "roster.csv:2: '2027-02-30 10:00' in the column 'due' is no time"
refuses roster.csv 'name\nada\nada\n' "roster.csv:3: 'ada' has line 2 already"
refuses roster.csv 'name\nada\nÁda\nbob\n,\n' 'roster.csv:5: it has 2 cells'
refuses roster.csv 'id,name\n,ada\nada,\n' "roster.csv:2: 'ada' and 'ada' in line 3 are both 'ada'"
refuses 'by hand.csv' 'name,points\nada,1.5\n' "by hand.csv:2: '1.5' is not a whole number of points"
refuses 'by hand.csv' 'name,points\neve,1\n' "by hand.csv:2: 'eve' is not in the class"
refuses 'by hand.csv' 'name,points\nada\n' "by hand.csv:2: 'ada' has no points and no word"
grades 2 --due soon
says "--due: 'soon' is no time"
finish
