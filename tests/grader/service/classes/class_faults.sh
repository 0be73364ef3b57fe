#!/usr/bin/env bash
# A class on a full disk, with a submission that sleeps in every call: nobody is judged twice, nobody is lost, a verdict that
# could not be written counts for nobody, and the next call with enough space finishes the class.
# class_faults.sh GRADER: the folder with grade_class and its grade.json.
set -euo pipefail
grader=$1
# shellcheck source=tests/grader/service/classes/class_fixture.sh
. "$(dirname "${BASH_SOURCE[0]}")/class_fixture.sh"
disk=
also_end() { [ -z "$disk" ] || umount "$disk"; }
log_what_is_judged "$grader"
make_class 6
mkdir "$folder/class/"{sleeper,spinner}
# spoil LEARNER STATEMENT: adds the statement to a right file.
spoil() {
  echo '#include <thread>' >"$folder/class/$1/hit_sphere.cpp"
  sed "s/^std::optional<SurfaceHit> hit_sphere(.*{/&\n  $2/" reference/1_rays/hit_sphere.cpp >>"$folder/class/$1/hit_sphere.cpp"
}
spoil sleeper 'std::this_thread::sleep_for(std::chrono::seconds(3));'
spoil spinner 'for (volatile int i = 0;; i = 0) {}'

# However full the disk: the exit status is 2, earlier verdicts stay, and the disk decides no verdict.
out=$folder/graded
mkdir "$out"
if ! mount -t tmpfs -o size=16k tmpfs "$out" 2>/dev/null; then
  echo 'NOT TESTED, a full disk: no file system can be mounted here'
  exit 77
fi
disk=$out
done_now() { (cd "$out" && find . -name '*.key' -size +0 | sed 's|^./||; s|.key$||' | sort); }
: >"$folder/kept"
refused=0
for size in 16k 150k 300k 64m; do
  mount -o "remount,size=$size" "$out"
  : >"$folder/judged"
  status=0
  grade_class graded --jobs 2 || status=$?
  [ "$status" -eq 2 ] || complain "with a disk of $size it ended with $status: $(cat "$folder/said")"
  echo "$size: $(wc -l <"$folder/judged") judged, $(done_now | wc -l) done; $(tail -1 "$folder/said")"
  again=$(sort "$folder/judged" | comm -12 - "$folder/kept")
  [ -z "$again" ] || complain "with a disk of $size they were judged again: $again"
  lost=$(done_now | comm -13 - "$folder/kept")
  [ -z "$lost" ] || complain "with a disk of $size their verdicts are lost: $lost"
  judged_once
  done_now >"$folder/kept"
  [ "$(wc -l <"$folder/kept")" -eq 8 ] || refused=$((refused + 1))
  left=$(find "$out" -name '*.tmp')
  [ -z "$left" ] || complain "with a disk of $size it leaves: $left"
done
[ "$refused" -ge 2 ] || complain 'no disk was full'
for words in 'sleeper,.*,timeout,0,' 'spinner,.*,timeout,0,' 'learner 6,.*,pass,'; do
  grep -q "^$words" "$out/class.csv" || complain "$(cat "$out/class.csv")"
done
grade_class whole --jobs 2 || true
same_table whole graded
