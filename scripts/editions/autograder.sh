#!/usr/bin/env bash
# autograder.sh BUILD FOLDER [IMAGE]: makes what platforms grade with: FOLDER/gradescope.zip, FOLDER/image for a container IMAGE,
# and what PrairieLearn, Autolab and Artemis take beside it. It contains the sources of the reference, so it is for
# instructors only. Runs in the root of the project; `./run autograder` calls it.
set -euo pipefail
# shellcheck source=scripts/editions/files.sh
. scripts/editions/files.sh
build=$1 folder=$(realpath -m "$2") image=${3:-firstlight} ours=scripts/editions/autograder
fail() {
  printf '%s\n' "$*" >&2
  exit 2
}
expect_new_folder "$folder"
expect_headers
mkdir -p "$(dirname "$folder")"
half=$(mktemp -d "$folder.XXXXXX")
trap 'rm -rf "$half"' EXIT
mkdir "$half/image"
edition_files "$only_for_us"'|\.png$|^(measure|view|writeup)/' | copy_files "$half/image"
copy_known "$build" "$half/image"
{ git ls-files reference fast 2>/dev/null | grep . || find reference fast -type f; } | copy_files "$half/image"
# The image has no solutions, by which examples are judged.
sed -i 's/"examples": [0-9]*/"examples": 0/g' "$half/image/grader/points.json"
install "$ours/setup.sh" "$ours/run_autograder" "$half/image"
(cd "$half/image" && find . -mindepth 1 -maxdepth 1 -printf '%f\n' | sort | xargs cmake -E tar cf ../gradescope.zip --format=zip --)
cp "$ours/Dockerfile" "$half/image"

cp -r "$ours/prairielearn" "$ours/artemis" "$half"
cp -r "$ours/autolab" "$half/firstlight"
sed -i "s|\bIMAGE\b|$image|; s|\bUUID\b|$(cat /proc/sys/kernel/random/uuid)|" "$half"/prairielearn/info.json "$half"/firstlight/firstlight.yml
# Autolab's problems are the tasks with their points, as stubs show them.
"$build/grader/grade" --submission student --quiet --csv "$half/points" >/dev/null || [ $? -eq 1 ]
awk -F, 'NR > 1 { printf "- name: %s\n  description: \x27\x27\n  max_score: %.1f\n  optional: false\n", $3, $6 }' "$half/points" \
  >>"$half/firstlight/firstlight.yml"
(cd "$half" && tar -cf firstlight/autograde.tar -T /dev/null && # Autolab wants the file, and the image has all that is needed
  tar -cf autolab.tar --format=ustar --owner=0 --group=0 firstlight)
rm -r "$half/firstlight" "$half/points"
chmod 755 "$half"
[ ! -e "$folder" ] || rmdir "$folder"
mv -T "$half" "$folder"
trap - EXIT
echo "$folder: $(du -sh "$folder" | cut -f1). It contains the reference: do not give it to learners."
