#!/usr/bin/env bash
# gradescope_zip.sh BUILD FILE: makes the archive for a Gradescope autograder. It contains the sources of the
# reference, so it is for instructors only. Runs in the root of the project; `./run gradescope-zip` calls it.
set -euo pipefail
# shellcheck source=scripts/editions/files.sh
. scripts/editions/files.sh
file=$(realpath -m "$2")
mkdir -p "$(dirname "$file")"
half=$(mktemp -d)
trap 'rm -rf "$half" "$file.half"' EXIT
edition_files "$only_for_us"'|\.png$|^(view|writeup)/' | copy_files "$half"
copy_known "$1" "$half"
{ git ls-files reference fast 2>/dev/null | grep . || find reference fast -type f; } | copy_files "$half"
cp scripts/editions/gradescope/setup.sh scripts/editions/gradescope/run_autograder "$half"
chmod 755 "$half/setup.sh" "$half/run_autograder"
(cd "$half" && find . -mindepth 1 -maxdepth 1 -printf '%f\n' | sort | xargs cmake -E tar cf "$file.half" --format=zip --)
mv "$file.half" "$file"
echo "$file: $(du -h "$file" | cut -f1). It contains the reference: do not give it to learners."
