#!/usr/bin/env bash
# Tests what ./run does before a program runs: it finds the packages, shows its progress, and waits for another ./run.
# Programs of the test replace cmake, ninja and the package managers.
# shellcheck disable=SC2016,SC2015
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"
tree=$folder/tree bin=$folder/bin

# program NAME: makes it from standard input.
program() {
  rm -f "$bin/$1"
  { echo '#!/bin/bash'; cat; } >"$bin/$1"
  chmod 755 "$bin/$1"
}

# The tree's `grade` gives this answer to --programs.
: >"$folder/programs"

# A tree with only ./run, and a system with every tool except package managers.
begin() {
  rm -rf "$tree" "$bin"
  mkdir -p "$tree/docs" "$tree/grader" "$bin"
  cp -r run cmake scripts student CMakePresets.json "$tree"
  cp --parents grader/tasks/*/task.json "$tree"
  cp docs/help.txt "$tree/docs"
  ln -s /usr/bin/* "$bin"
  rm -f "$bin"/{apt-get,apk,brew,dnf,dpkg-query,pacman,rpm,sudo,cmake,ninja}
  program cmake <<<'while [ $# -gt 0 ]; do [ "$1" != --preset ] || mkdir -p '"$tree"'/build/$2; shift; done'
  program ninja <<<'case " $* " in *" build.ninja "*) echo "no work to do"; exit ;; *" -n "*) echo "[1/2] x"; exit ;; esac; echo "$*" >>'"$folder/built"'; '"$tree"'/steps'
  printf '#!/bin/sh\n' >"$tree/steps"
  chmod 755 "$tree/steps"
  for preset in check release; do
    for place in grader/grade grader/compare; do
      mkdir -p "$tree/build/$preset/${place%/*}"
      printf '#!/bin/sh\n[ "$1" = --programs ] && { cat %s; exit; }\necho done "$@"\n' "$folder/programs" >"$tree/build/$preset/$place"
      chmod 755 "$tree/build/$preset/$place"
    done
  done
}

# debian MISSING: dpkg-query knows all packages except this.
debian() {
  program apt-get <<<'echo "Unpacking $*"; echo "$*" >>'"$folder/installed"
  program dpkg-query <<<'[ "${@: -1}" = "'"$1"'" ] && ! grep -q " $1" '"$folder/installed"' || echo "install ok installed"'
  : >"$folder/installed"
}

user() { program id <<<"echo $1"; }

run() { PATH=$bin "$tree/run" "$@"; }

# stops SENTENCE WORD ...: tests that it ends with status 2 and one line, and makes nothing.
stops() {
  local sentence=$1 said status=0
  shift
  rm -rf "$tree/build"
  said=$(run "$@" 2>&1 </dev/null) || status=$?
  [ "$status" -eq 2 ] && [ "$(wc -l <<<"$said")" -eq 1 ] || complain "./run $*: status $status, and says: $said"
  case $said in *"$sentence"*) ;; *) complain "'$sentence' is not in: $said" ;; esac
  [ ! -e "$tree/build" ] || complain "./run $* has made $(ls "$tree/build")"
}

begin
debian libfmt-dev
user 1000
stops 'sudo apt-get install -y --no-install-recommends libfmt-dev' grade 1
program sudo <<<'exit 1'
stops 'sudo apt-get install -y --no-install-recommends libfmt-dev' render scene.dae --from student

begin
user 1000
stops 'does not know the package manager of this system' grade 1
program rpm <<<'[ "${@: -1}" != fmt-devel ]'
program dnf </dev/null
stops 'sudo dnf install fmt-devel' grade 1
rm "$bin/dnf"
program pacman <<<'case $* in "-Q gcc" | "-Q ninja") exit 1 ;; esac'
stops 'sudo pacman -S --needed gcc ninja;' grade 1

# Every package has its use, and a name in each system.
awk '!/^#/ && (NF != 6 || $2 !~ /^(student|class|convert|site|test|lint)$/) { print; wrong = 1 } END { exit wrong }' scripts/packages.txt ||
  complain "these rows of scripts/packages.txt are not complete"

# For root it announces the packages and installs them without a question.
begin
debian libfmt-dev
user 0
echo graded.hit_box >"$folder/programs"
said=$(run grade 1 2>&1 </dev/null) || complain "root does not install: $said"
case $said in
  *'These are missing, and are now installed with apt-get:'*'libfmt-dev'*'building grade (check)'*'building graded.hit_box (check)'*'done 1') ;;
  *) complain "root installs, and says: $said" ;;
esac
: >"$folder/programs"

# The first time, the judge is built together with the programs of the named tasks; later the programs that it names.
for words in 'hit_box --seed 2' '2.2'; do
  mv "$tree/build/check/grader/grade" "$folder/judge"
  printf '#!/bin/sh\ncp -n %s %s\n' "$folder/judge" "$tree/build/check/grader/grade" >"$tree/steps"
  : >"$folder/built"
  # shellcheck disable=SC2086
  run grade $words >/dev/null 2>&1 </dev/null || complain "./run grade $words: the first time it ends with status $?"
  grep -q 'grade .*graded.hit_box' "$folder/built" && ! grep -q graded.camera_ray "$folder/built" || complain "./run grade $words builds $(cat "$folder/built")"
done
printf '#!/bin/sh\n' >"$tree/steps"

# Programs describe themselves without being built.
for page in grade render watch; do
  rm -rf "$tree/build"
  run $page 7 --help | grep -c "Usage: ./run $page" >"$folder/said" || complain "there is no help on $page"
  [ ! -e "$tree/build" ] || complain "./run $page --help builds"
done

# A step without output still shows the time. It ends when the log has shown it, or fails after 30 s.
begin
debian none
cat >"$tree/steps" <<END
#!/bin/bash
echo '[1/4] Building CXX object grader/check/CMakeFiles/x.dir/__/tasks/hit_box/properties.cpp.o'
for ((i = 0; i < 300; ++i)); do
  [ "\$(grep -c 'building grade (check): \[1/4\] compiled grader/check/../tasks/hit_box/properties.cpp' $folder/log)" -lt 2 ] || exit 0
  sleep 0.1
done
exit 1
END
run grade 1 2>"$folder/log" >/dev/null || complain "a long step is silent: $(cat "$folder/log")"
# On a terminal, one line shows it.
printf '#!/bin/bash\necho "[1/2] Linking CXX executable grade"; echo "[2/2] $(printf "%%200s" x)"\n' >"$tree/steps"
PATH=$bin TERM=xterm script -qec "stty cols 60; $tree/run grade 1" /dev/null >"$folder/screen" </dev/null
grep -q $'\r\x1b\\[Kbuilding grade (check): \\[1/2\\] linked grade' "$folder/screen" || complain "no line is rewritten: $(cat -v "$folder/screen")"
[ "$(tr '\r' '\n' <"$folder/screen" | sed 's/\x1b\[K//' | awk '{ if (length > longest) longest = length } END { print longest }')" -lt 60 ] ||
  complain "a line is wider than the terminal: $(cat -v "$folder/screen")"
# If the compiler fails, its messages are shown.
printf '#!/bin/bash\necho "[1/2] Building x"; echo "a.cpp:3: error: no"; exit 1\n' >"$tree/steps"
status=0
said=$(run grade 1 2>&1) || status=$?
case $status:$said in 2:*'a.cpp:3: error: no'*'the build failed'*) ;; *) complain "a build that fails: $status, $said" ;; esac

# With two commands at a time the second waits, and names the first.
cat >"$tree/steps" <<END
#!/bin/bash
echo begin >>$folder/order
until [ -e $folder/go ]; do sleep 0.05; done
echo end >>$folder/order
END
: >"$folder/order"
run grade 1 >/dev/null 2>&1 &
first=$!
until grep -q begin "$folder/order"; do sleep 0.05; done
run compare a b >"$folder/second" 2>&1 &
second=$!
for ((i = 0; i < 300; ++i)); do
  ! grep -q "waiting for './run grade', which is building" "$folder/second" || break
  sleep 0.1
done
touch "$folder/go"
wait $first || complain "the first of two fails"
wait $second || complain "the second of two fails"
grep -q "waiting for './run grade', which is building" "$folder/second" || complain "the second says: $(cat "$folder/second")"
[ "$(tr '\n' ' ' <"$folder/order")" = 'begin end begin end ' ] || complain "they build at the same time: $(cat "$folder/order")"
# Who has nothing to build waits for nobody.
program ninja <<<'case " $* " in *" -n "*) echo "no work to do"; exit ;; esac; exit 1'
touch "$tree/build/release/build.ninja"
exec 8>>"$tree/build/lock"
flock 8
said=$(PATH=$bin timeout 60 "$tree/run" compare a b 2>&1 8>&-) || complain "it waits for another, and has nothing to build: $said"
[ "$said" = 'done a b' ] || complain "it has nothing to build, and says: $said"
exec 8>&-
# While the program itself runs, nobody waits.
flock -n "$tree/build/lock" true || complain "the lock is still held"

finish
