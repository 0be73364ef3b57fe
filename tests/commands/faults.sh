#!/usr/bin/env bash
# Tests faults of the machine: a full disk, an output that cannot be written, a compiler that is killed, a
# worker that cannot start, an interrupt, damaged files. A submission never gets the blame, nothing half-made
# stays, and the next run gives the right verdict.
# faults.sh BUILD: the folder of the build.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"
build=$1 grader=$1/grader
stops=yes
chmod 755 "$folder" # another user judges there
mounted=
also_end() { [ -z "$mounted" ] || umount "$mounted"; }

# prepare NAME [COMPILER]: makes a folder to grade in, with an empty cache, in $folder/NAME.
prepare() {
  mkdir -p "$folder/$1"
  python3 - "$grader/grade.json" "$folder/$1" "${2:-}" <<'END'
import json, sys
config = json.load(open(sys.argv[1]))
config["work"] = sys.argv[2] + "/work"
config["compiler"] = sys.argv[3] or config["compiler"]
json.dump(config, open(sys.argv[2] + "/grade.json", "w"))
END
}

# grades NAME STATUS OPTIONS...: the output goes to $folder/said. Status 2 has one line and no verdict.
grades() {
  local name=$1 status=$2 got=0
  shift 2
  "$grader/grade" --config "$folder/$name/grade.json" --quiet "$@" >"$folder/said" 2>&1 || got=$?
  [ "$got" -eq "$status" ] || complain "grade $* ended with $got, not $status:" "$(cat "$folder/said")"
  [ "$got" -ne 2 ] || [ "$(wc -l <"$folder/said")" -eq 1 ] || complain "not one line:" "$(cat "$folder/said")"
}

says() { grep -qF -- "$1" "$folder/said" || complain "it does not say '$1':" "$(cat "$folder/said")"; }

# leaves NAME: tests that no temporary file is left there.
leaves() {
  local left
  left=$(find "$folder/$1/work" -regextype posix-extended -regex '.*\.[0-9]+\.([0-9]+|tmp)$')
  [ -z "$left" ] || complain "left behind in $1:" "$left"
}

asked=(hit_box --submission reference --no-pictures --threads 1)

# A full disk: however much fits, the verdict is right or missing, and with enough room it is right.
full_disk() {
  mkdir -p "$folder/disk/work"
  prepare disk
  if ! mount -t tmpfs -o size=64k tmpfs "$folder/disk/work" 2>/dev/null; then
    echo "NOT TESTED, a full disk: no file system can be mounted here"
    return
  fi
  mounted=$folder/disk/work
  local size got refused=0
  for size in 64k 512k 1m 2m 3m 4m 6m; do
    mount -o "remount,size=$size" "$mounted"
    got=0
    "$grader/grade" --config "$folder/disk/grade.json" --quiet "${asked[@]}" >"$folder/said" 2>&1 || got=$?
    case $got in
      0) ;;
      2) refused=$((refused + 1)); [ "$(wc -l <"$folder/said")" -eq 1 ] || complain "$(cat "$folder/said")" ;;
      *) complain "a full disk of $size is a verdict:" "$(cat "$folder/said")" ;;
    esac
  done
  [ "$refused" -ge 2 ] || complain "no disk was full"
  # A submission's own fault stays its fault.
  mount -o remount,size=200m "$mounted"
  grades disk 0 "${asked[@]}"
  leaves disk
  mkdir -p "$folder/broken"
  echo 'int f( {' >"$folder/broken/hit_box.cpp"
  grades disk 1 hit_box --submission "$folder/broken" --no-pictures
  says 'it does not compile'
  umount "$mounted"
  mounted=
}

full_output() {
  local status
  [ -w /dev/full ] || { echo "NOT TESTED, an output that cannot be written: there is no /dev/full"; return; }
  prepare output
  "$grader/grade" --config "$folder/output/grade.json" "${asked[@]}" --json "$folder/results.json" >"$folder/said"
  for command in "$grader/grade --from-results $folder/results.json" "$build/grader/compare golden/rays_star.exr \
    golden/rays_star.exr" "$build/pt/render scenes/star.dae -f $folder/star.png -s 1 -r 8 6"; do
    status=0
    $command >/dev/full 2>"$folder/said" || status=$?
    [ "$status" -eq 2 ] || complain "$command ended with $status and no output:" "$(cat "$folder/said")"
    says 'cannot be written'
  done
}

# Every program with --help reports if the help cannot be written, and ends with 2.
full_help() {
  local program status count=0
  [ -w /dev/full ] || return 0
  for program in "$build"/{bench,grader,pt,scenes,writeup}/*; do
    if [ ! -f "$program" ] || [ ! -x "$program" ]; then continue; fi
    status=0
    timeout 20 "$program" --help >"$folder/help" 2>/dev/null </dev/null || status=$?
    if [ "$status" -ne 0 ] || ! grep -q -- '--help' "$folder/help"; then continue; fi
    count=$((count + 1))
    timeout 20 "$program" --help >/dev/full 2>"$folder/said" </dev/null || status=$?
    [ "$status" -eq 2 ] || complain "$program --help ended with $status and no output:" "$(cat "$folder/said")"
    says 'the output cannot be written: No space left on device'
  done
  [ "$count" -ge 3 ] || complain "only $count programs have --help"
}

# The name of a file cannot act as a command to a terminal: no control character, no other direction of writing, valid UTF-8.
plain_names() {
  local name=$'a\e[31m\xe2\x80\xae\xff.png'
  "$build/pt/render" scenes/star.dae -f "$folder/$name" -s 1 -r 8 6 >"$folder/said" 2>&1
  says 'wrote '
  "$build/pt/render" scenes/star.dae -f "$folder/none/$name" -s 1 -r 8 6 >>"$folder/said" 2>&1 || true
  says 'there is no folder'
  python3 - "$folder/said" <<'END' || complain "a name is shown as it is:" "$(cat -v "$folder/said")"
import sys
text = open(sys.argv[1], encoding="utf-8").read()
sys.exit(any(c in text for c in "\x1b\u202e"))
END
}

# A submission's files are also read carefully before any box: a named pipe or an endless file does not stop the
# judge, and tasks that may be right have their pictures.
named_programs() {
  local kind expected
  for kind in tree flat folder pipe endless unwritten missing; do mkdir -p "$folder/named/$kind/1_rays"; done
  cp reference/1_rays/hit_sphere.cpp "$folder/named/tree/1_rays"
  cp reference/1_rays/hit_sphere.cpp "$folder/named/flat"
  mkdir "$folder/named/folder/1_rays/hit_sphere.cpp"
  mkfifo "$folder/named/pipe/1_rays/hit_sphere.cpp"
  ln -s /dev/zero "$folder/named/endless/1_rays/hit_sphere.cpp"
  cp student/1_rays/hit_sphere.cpp "$folder/named/unwritten"
  prepare named
  for kind in tree flat folder pipe endless unwritten missing; do
    expected=graded_picture
    case $kind in unwritten | missing) expected= ;; esac
    (ulimit -v 4000000 && exec timeout 20 "$grader/grade" --config "$folder/named/grade.json" --programs hit_sphere \
      --submission "$folder/named/$kind" >"$folder/said" 2>&1) || complain "$kind: $?" "$(cat "$folder/said")"
    says graded.hit_sphere
    [ "$(grep -x graded_picture "$folder/said" || true)" = "$expected" ] ||
      complain "a file that is a $kind:" "$(cat "$folder/said")"
  done
}

# Faults of the compiler: it is killed, every time or once; a part of it is killed; the program that watches the part is killed; it fails
# although no part failed. Faults of the linker: its disk is full, always or for a moment; it refuses the submission's objects (1.o, ...).
killed_compiler() {
  local name
  for name in killed once part watcher nothing linker moment undefined; do
    cat >"$folder/$name.sh" <<END
#!/bin/bash
full() { echo "/usr/bin/ld: final link failed: No space left on device" >&2; exit 1; }
case "$name \$*" in
  killed*) kill -9 \$\$ ;;
  once*hit_box.cpp*) [ -e "$folder/has_killed" ] || { touch "$folder/has_killed"; kill -9 \$\$; } ;;
  part*-wrapper*) \${2//,/ } sh -c 'kill -9 \$\$'; exit 1 ;;
  watcher*-wrapper*) \${2//,/ } sh -c 'kill -9 \$PPID; sleep 1'; exit 1 ;;
  nothing*-wrapper*) \${2//,/ } true; exit 1 ;;
  *' -c '*) ;;
  linker*) full ;;
  moment*) [ -e "$folder/failed" ] || { touch "$folder/failed"; full; } ;;
  undefined*' 1.o'*) echo "hit_box.cpp: undefined reference to \\\`pt::nothing'" >&2; exit 1 ;;
esac
exec c++ "\$@"
END
    chmod +x "$folder/$name.sh"
    prepare "$name" "$folder/$name.sh"
  done
  for name in killed part watcher nothing; do
    grades "$name" 2 "${asked[@]}" --isolation C
    says 'hit_box could not be judged: the compiler was killed'
    leaves "$name"
  done
  # It may have been killed although another process took the memory, so it runs once more, alone.
  grades once 0 "${asked[@]}" --isolation C
  [ -e "$folder/has_killed" ] || complain "no compiler was killed"
  grades linker 2 "${asked[@]}" --isolation C
  says 'final link failed'
  leaves linker
  grades moment 0 "${asked[@]}" --isolation C
  grades undefined 1 "${asked[@]}" --isolation C
  says 'it does not link'
}

# The launcher of boxes is next to the program that judges: this one can start nothing.
no_worker() {
  prepare worker
  mkdir -p "$folder/programs/grader"
  cp "$grader/graded.hit_box" "$folder/programs/grader"
  printf '#!/bin/bash\necho "box: all users for boxes are taken" >&2\nexit 127\n' >"$folder/programs/grader/box"
  chmod +x "$folder/programs/grader/box"
  sed -i "s|\"[^\"]*/graded.hit_box\"|\"$folder/programs/grader/graded.hit_box\"|" "$folder/worker/grade.json"
  if ! "$grader/grade" --config "$folder/output/grade.json" "${asked[@]}" --isolation B >"$folder/said" 2>&1; then
    echo "NOT TESTED, a worker that cannot start: tier B does not work here"
    return
  fi
  grades worker 2 "${asked[@]}" --isolation B
  says 'hit_box could not be judged: a worker cannot start: box: all users for boxes are taken'
  cp "$grader/box" "$folder/programs/grader"
  grades worker 0 "${asked[@]}" --isolation B
}

# The judge's program for one task dies, or takes too long, as answers could make it: that task has a reason, the other one
# its verdict, and nothing is cached.
judge_dies() {
  local kind says
  prepare dies
  mkdir -p "$folder/dying"
  for kind in 'kill -SEGV $$' 'while :; do :; done'; do
    printf '#!/bin/bash\n%s\n' "$kind" >"$folder/dying/graded.hit_box"
    chmod +x "$folder/dying/graded.hit_box"
    cp "$folder/dies/grade.json" "$folder/dies/whole.json"
    sed -i "s|\"[^\"]*/graded.hit_box\"|\"$folder/dying/graded.hit_box\"|" "$folder/dies/grade.json"
    grades dies 1 camera_ray "${asked[@]}" --call-limit 100 --json "$folder/dies/results.json"
    says=$(python3 -c '
import json, sys
for task in json.load(open(sys.argv[1]))["tasks"]:
    kept = sum(promise["held"] for promise in task["promises"])
    print(task["slug"], task["state"], kept, "of", len(task["promises"]) > 3, task["reason"])' "$folder/dies/results.json")
    mv "$folder/dies/whole.json" "$folder/dies/grade.json"
    case $kind in
      kill*) grep -q '^hit_box crash 0 of True .*could not work with its answers: its program ended with signal 11' <<<"$says" ;;
      *) grep -q '^hit_box timeout 0 of True .*could not work with its answers: its program took too long' <<<"$says" ;;
    esac || complain "$kind:" "$says"
    grep -q '^camera_ray pass' <<<"$says" || complain "$kind:" "$says"
  done
  grades dies 0 "${asked[@]}"
}

# Root judges as another user, who cannot enter a folder of root's.
unreachable_work() {
  [ "$(id -u)" -eq 0 ] || return 0
  mkdir -m 700 "$folder/closed"
  prepare closed/in
  grades closed/in 2 "${asked[@]}" --isolation B
  says 'its user cannot reach'
}

# Interrupted at any moment: nothing is lost, and nothing stays.
interrupted() {
  local pause judge
  prepare interrupt
  for pause in 0.02 0.2 0.5 1 1.7 2.6; do
    "$grader/grade" --config "$folder/interrupt/grade.json" camera_ray "${asked[@]}" >"$folder/said" 2>&1 &
    judge=$!
    sleep "$pause"
    { kill -INT "$judge" || true; wait "$judge" || true; } 2>/dev/null
  done
  sleep 0.5
  grades interrupt 0 camera_ray "${asked[@]}"
  leaves interrupt
}

# An interrupted run goes on from any folder, whatever its own is called.
resumed_elsewhere() {
  local home=$folder/"a 'b' c"
  prepare resume
  mkdir -p "$home/work here/1_rays"
  cp reference/1_rays/camera_ray.cpp "$home/work here/1_rays"
  (cd "$home" && printf '%s\0' "$PWD" --config "$folder/resume/grade.json" camera_ray --no-pictures \
    --submission 'work here' --json it.json) >"$folder/unfinished"
  local work=$folder/resume/work
  mkdir -p "$work"
  cp "$folder/unfinished" "$work"
  (cd / && grades resume 0 --resume)
  [ -e "$home/it.json" ] || complain "the results went elsewhere"
  cp "$folder/unfinished" "$work"
  rm -r "$home"
  (cd / && grades resume 2 --resume)
  says 'which does not exist any more'
}

# results.json, damaged in each way, gives one sentence that names the file.
damaged_results() {
  python3 - "$folder/results.json" "$folder/damaged" <<'END'
import json, os, sys
text = open(sys.argv[1]).read()
out = sys.argv[2]
os.mkdir(out)
kinds = {"empty": "", "half": text[:len(text) // 2], "zeros": "\0" * 100, "list": "[]", "null": "null",
         "word": '"results"', "bytes": "\xff\xfe", "deep": "[" * 100000, "no_version": "{}"}
def changed(name, change):
    results = json.loads(text)
    change(results)
    kinds[name] = json.dumps(results)
changed("version", lambda r: r.update(schema_version=999))
changed("tasks", lambda r: r.update(tasks=7))
changed("task", lambda r: r["tasks"].append("hit_box"))
changed("state", lambda r: r["tasks"][0].update(state="right"))
changed("points", lambda r: r["tasks"][0].update(points="many"))
changed("negative_points", lambda r: r["tasks"][0].update(points=-1))
changed("more_points_than_there_are", lambda r: r["tasks"][0].update(points=r["tasks"][0]["max_points"] + 1))
changed("task_twice", lambda r: r["tasks"].append(r["tasks"][0]))
changed("state_of_a_terminal", lambda r: r["tasks"][0].update(state="\x1b[2J"))
changed("half_a_point", lambda r: r["tasks"][0].update(points=0.5))
changed("too_many_points", lambda r: r["tasks"][0].update(points=1e300))
changed("points_beyond_all_numbers", lambda r: r["tasks"][0].update(points=2**64 - 5))
changed("far_too_many_points", lambda r: r["tasks"][0].update(points=2**63))
changed("promises", lambda r: r["tasks"][0].update(promises={}))
changed("seed", lambda r: r.update(seed=[]))
changed("complete", lambda r: r.update(complete="yes"))
changed("many_tasks", lambda r: r.update(tasks=[{}] * 5000))
for name, content in kinds.items():
    open(f"{out}/{name}.json", "w", encoding="latin-1").write(content)
os.mkdir(f"{out}/folder.json")
os.symlink("loop.json", f"{out}/loop.json")
os.mkfifo(f"{out}/pipe.json")
END
  local file got
  for file in "$folder"/damaged/*.json "$folder/damaged/none.json" "$folder/damaged/null.json/a.json" \
    "$folder/$(printf 'long%.0s' {1..100}).json"; do
    got=0
    "$grader/grade" --from-results "$file" --html "$folder/page.html" >"$folder/said" 2>&1 || got=$?
    [ "$got" -eq 2 ] || complain "$file is taken for results ($got)" "$(head -3 "$folder/said")"
    [ "$(wc -l <"$folder/said")" -eq 1 ] || complain "$file: not one line" "$(cat "$folder/said")"
    says "$file"
    ! grep -qE 'filesystem error|\[json' "$folder/said" || complain "$file:" "$(cat "$folder/said")"
  done
  [ ! -e "$folder/page.html" ] || complain "there is a page of damaged results"
}

# Damaged files of CMake, and the note of an interrupted run, give one sentence that names the file.
damaged_notes() {
  local text
  mkdir "$folder/notes"
  for text in '' '{' '[]' '{"root": 7}'; do
    printf '%s' "$text" >"$folder/notes/grade.json"
    grades notes 2 "${asked[@]}"
    says "$folder/notes/grade.json is not what CMake wrote"
    ! grep -qF '[json' "$folder/said" || complain "$(cat "$folder/said")"
  done
  prepare notes
  local note=$folder/notes/work
  mkdir -p "$note"
  note+=/unfinished
  for text in '' half; do
    printf '%s' "$text" >"$note"
    grades notes 2 --resume
    says "$note does not say which run was interrupted"
  done
}

full_output
full_help
plain_names
named_programs
full_disk
killed_compiler
no_worker
judge_dies
unreachable_work
interrupted
resumed_elsewhere
damaged_results
damaged_notes
echo 'faults of the machine are nobody'\''s verdict'
