#!/usr/bin/env bash
# Tests that a handout is whole without its compiled parts, that ./run update switches to a newer edition and keeps the learner's files,
# and that ./run submit packs all tasks.
# shellcheck disable=SC2015
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"

has() { [ "$(cat "$1" 2>/dev/null)" = "$2" ] || complain "$1 has '$(cat "$1" 2>/dev/null)', not '$2'"; }
seal() { (cd "$1" && find . -type f ! -name .edition -printf '%P\0' | sort -z | xargs -0 sha256sum) >"$folder/list" && mv "$folder/list" "$1/.edition"; }
refuses() { # refuses WORDS COMMAND ...
  local words=$1 said status=0
  shift
  said=$("$@" 2>&1) || status=$?
  case $status:$said in 2:*"$words"*) ;; *) complain "$*: status $status, and says: $said" ;; esac
}

# Every link in a page of the learners' edition leads to one of its files.
python3 - <(. scripts/editions/files.sh && edition_files "$not_for_learners") <<'END' || complain 'links of the handout lead nowhere'
import pathlib, re, sys
files = set(open(sys.argv[1]).read().split("\n")) | {"README.md"}
pages = [name for name in files if name.endswith(".md") and name != "README.md"]
assert len(pages) > 10, pages
links = dead = 0
for name in pages:
    for link in re.findall(r"\]\(([^)#\s]+)(?:#[^)]*)?\)", pathlib.Path(name).read_text()):
        if re.match(r"[a-z]+:", link):
            continue
        links += 1
        target = (pathlib.Path(name).parent / link).resolve()
        target = str(target.relative_to(pathlib.Path.cwd())).rstrip("/")
        if target not in files and not any(each.startswith(target + "/") for each in files):
            print(f"{name}: {link}")
            dead += 1
assert links > 20, links
sys.exit(dead > 0)
END

# Compiled parts that do not fit are left aside, and everything has a rule.
foreign=$folder/foreign
mkdir -p "$foreign/compiled" "$foreign/reference-objects/stubs"
(. scripts/editions/files.sh && edition_files "$not_for_learners" | copy_files "$foreign")
cp -r student/[1-9]* "$foreign/reference-objects/stubs"
echo 'machine Linux other' | tee "$foreign/compiled/stamp" >"$foreign/reference-objects/stamp"
touch "$foreign/compiled/sources"
for pch in ON OFF; do
  expect 0 'Build files have been written' cmake -S "$foreign" --preset check -B "$foreign/build/$pch" "-DFIRSTLIGHT_PCH=$pch"
  expect 0 '/hit_sphere.cpp.o' ninja -C "$foreign/build/$pch" -n grade graded watch render measure stability writeup view
  expect 0 'worker_main.cpp.o' ninja -C "$foreign/build/$pch" -n grade_examples
  grep -qF 'compiled for another compiler and another machine' "$foreign/build/$pch/not_compiled" || complain "it does not say why everything is built"
done

# edition NAME: makes an edition with its name in each file.
edition() {
  mkdir -p "$folder/$1/grader/old"
  cp -r run cmake scripts student "$folder/$1"
  mkdir -p "$folder/$1/grader/tasks" && cp -r --parents grader/tasks/*/task.json "$folder/$1"
  for file in grader/judge.txt "grader/with blank.txt" scenes.txt; do echo "$1" >"$folder/$1/$file"; done
}
edition first
echo first >"$folder/first/grader/old/gone.txt"
echo first >"$folder/first/grader/old/gone_but_edited.txt"
seal "$folder/first"
edition second
mkdir "$folder/second/new"
echo second >"$folder/second/new/file.txt"
echo '// second' >>"$folder/second/student/1_rays/hit_box_2.cpp"
for stub in 1_rays/hit_sphere 1_rays/hit_triangle; do echo '// second' >>"$folder/second/student/$stub.cpp"; done
seal "$folder/second"
find "$folder/second" -exec touch -d '2020-01-01' {} +
(cd "$folder" && cmake -E tar cf second.zip --format=zip second && tar -czf second.tar.gz second)

# The learner has written one file, changed one of the framework's, and added one.
for archive in second.zip second.tar.gz second; do
  rm -rf "$folder/mine"
  cp -r "$folder/first" "$folder/mine"
  cd "$folder/mine"
  echo mine >student/1_rays/hit_triangle.cpp
  echo mine >student/helper.h
  echo mine | tee scenes.txt >grader/old/gone_but_edited.txt
  said=$(./run update "../$archive") || complain "update $archive ends with $?: $said"
  has student/1_rays/hit_triangle.cpp mine
  has student/helper.h mine
  has grader/judge.txt second
  has 'grader/with blank.txt' second
  has new/file.txt second
  has scenes.txt second
  has scenes.txt.mine mine
  has grader/old/gone_but_edited.txt.mine mine
  cmp -s student/1_rays/hit_sphere.cpp ../second/student/1_rays/hit_sphere.cpp || complain "a stub that was not touched stays old"
  [ ! -e grader/old/gone.txt ] && [ ! -e grader/old/gone_but_edited.txt ] || complain "files of the first edition are left"
  [ grader/judge.txt -nt scenes.txt.mine ] || complain "a new file is older than what was built of the old one"
  [ -x run ] || complain "run cannot be run"
  cmp -s .edition ../second/.edition || complain ".edition is not the newer one's"
  [ -z "$(find . -name '*.new.tmp')" ] || complain "half of a file is left"
  case $said in *'Your files are kept: student/1_rays/hit_triangle.cpp'*'grader/old/gone_but_edited.txt.mine scenes.txt.mine'*) ;; *) complain "update says: $said" ;; esac
  # A second update has nothing to do, and keeps no more files as theirs.
  said=$(./run update "../$archive") || complain "the second update ends with $?"
  case $said in *scenes.txt.mine*) complain "the second update says: $said" ;; esac
  cd - >/dev/null
done

cd "$folder/mine"
refuses 'there is no ../nowhere' ./run update ../nowhere
refuses 'cannot be unpacked' ./run update scenes.txt
refuses 'is not a learners' ./run update new
refuses 'is this edition itself' ./run update .
echo spoilt >../second/grader/judge.txt
refuses 'is damaged' ./run update ../second
has grader/judge.txt second
cd - >/dev/null
refuses 'this is the whole project' ./run update "$folder/second"

# submit grades with programs that the test has made.
cd "$folder/mine"
echo 'build() { :; }' >>scripts/build.sh
mkdir -p build/check/grader
cat >build/check/grader/grade <<'END'
#!/bin/sh
case $1 in --programs) exit 0 ;; esac
echo "the table, of: $*"
printf '  1.2  camera_ray  pass  8/8\n'
case $* in *--seed*) cat other 2>/dev/null ;; *) printf '  1.3  hit_sphere  pass  8/8\n' ;; esac
exit "$(cat status)"
END
chmod +x build/check/grader/grade
echo 2 >status
refuses 'nothing was packed' ./run submit ../one.zip
[ ! -e ../one.zip ] || complain "files that cannot be graded are packed"
echo 1 >status
(cd student && ../run submit ../../two.zip >"$folder/said") || complain "submit ends with $?"
grep -q 'two.zip: 12 files, 12 files of examples' "$folder/said" && grep -q 'the table, of: --no-pictures' "$folder/said" || complain "submit says: $(cat "$folder/said")"
mkdir ../unpacked
(cd ../unpacked && cmake -E tar xf ../two.zip)
[ "$(head -1 ../unpacked/graded.txt)" = 'the table, of: --no-pictures' ] || complain "graded.txt: $(cat ../unpacked/graded.txt)"
diff <(cd ../unpacked && find . -type f ! -name graded.txt | sort) <(cd student && find . -mindepth 2 -name '*.cpp' ! -name hit_box_2.cpp | sort) ||
  complain "other files are handed in"
has ../unpacked/1_rays/hit_triangle.cpp mine
printf '  1.3  hit_sphere  fail  7/8\n' >other
./run submit ../other.zip >"$folder/said" || complain "submit ends with $? where other seeds fail"
[ "$(grep -c 'hit_sphere  fail' "$folder/said")" -eq 3 ] && grep -q 'Its verdicts are not sure' "$folder/said" && ! grep -q '^With.*camera_ray' "$folder/said" ||
  complain "submit says of other seeds: $(cat "$folder/said")"
printf '  1.3  hit_sphere  pass  8/8\n' >other
./run submit ../same.zip >"$folder/said" || complain "submit ends with $?"
! grep -q 'not sure' "$folder/said" || complain "submit doubts: $(cat "$folder/said")"
refuses 'the archive has to be a .zip' ./run submit mine.rar
# A crash in one process with the learner's code says what to do. Files that make much to build again are named.
for program in hit_box hit_sphere; do
  printf '#!/bin/sh\ncase $* in *--gtest_list_tests*) echo "  one" ;; *) kill -SEGV $$ ;; esac\n' >"build/check/grader/check.$program.student"
  chmod +x "build/check/grader/check.$program.student"
done
said=$(./run grade hit_box hit_sphere --from student 2>/dev/null) && complain 'a crash ends with 0'
[[ $said == *'hit_sphere ended by a signal: SIGSEGV. ./run grade hit_sphere names'*'hit_box ended by'* ]] || complain "a crash says: $said"
echo mine >grader/judge.txt
said=$(root=$PWD && . scripts/build.sh && name_changed_files 2>&1)
[[ $said == *'these files were changed: '*'grader/judge.txt'*'(git checkout '* && $said != *hit_triangle* ]] || complain "changed files: $said"
printf '// one\n<<<<<<< HEAD\n' >student/1_rays/hit_sphere.cpp
refuses 'student/: 1_rays/hit_sphere.cpp:2' ./run submit ../three.zip
rm student/1_rays/hit_sphere.cpp
refuses 'there is no hit_sphere.cpp' ./run submit ../three.zip
[ ! -e ../three.zip ] && [ ! -e ../three.zip.half ] || complain "half an archive is left"

finish
