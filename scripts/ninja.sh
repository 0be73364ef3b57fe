#!/usr/bin/env bash
# ninja.sh FOLDER TARGET ...: builds the targets in the folder with ninja, until they are made from the newest text of the learner's files.
# Ninja compares times only: a file that is saved while it is compiled is older than its object, and so is an older version that is
# copied back. So the objects of such a file also depend on saved/PART/TASK in the folder (cmake/tasks.cmake): the checksum that the file had
# when ninja was last started.
# ninja.sh --check FOLDER: succeeds if no file has another checksum now.
set -euo pipefail
student=$(cd "$(dirname "${BASH_SOURCE[0]}")/../student" && pwd -P)

# changed: prints a line for each file that is not as it was: PART/TASK CHECKSUM.
changed() {
  local task text
  while read -r text _ task; do
    task=${task%.cpp}
    [ ! -e "$folder/saved/$task" ] || [ "$(<"$folder/saved/$task")" = "$text" ] || echo "$task $text"
  done < <(cd "$student" && cksum ./*/*.cpp 2>/dev/null | sed 's| [.]/| |')
}

# note: keeps the checksums of now; fails if all files are as they were.
note() {
  local task text status=1
  while read -r task text; do
    echo "$text" >"$folder/saved/$task.new"
    mv -f "$folder/saved/$task.new" "$folder/saved/$task"
    status=0
  done < <(changed)
  return $status
}

if [ "$1" = --check ]; then
  folder=$2
  [ -z "$(changed)" ]
  exit
fi
folder=$1
# Another command may build here as well, for example an open view.
! command -v flock >/dev/null || { exec 8>>"$folder/saved.lock" && flock 8; }
note || true # first, so that nothing is compiled twice
while true; do
  status=0
  ninja -C "$folder" "${@:2}" 8>&- || status=$?
  note || exit $status
done
