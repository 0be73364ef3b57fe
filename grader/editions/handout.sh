#!/usr/bin/env bash
# handout.sh BUILD FOLDER: the learners' edition, with the reference as the objects that BUILD has made. Runs
# in the root of the project; `./run handout` calls it.
set -euo pipefail
# shellcheck source=grader/editions/files.sh
. grader/editions/files.sh
build=$1 folder=${2%/}

fail() {
  printf '%s\n' "$*" >&2
  exit 2
}

[ ! -e "$folder" ] || [ -z "$(ls -A "$folder")" ] ||
  fail "$folder is there already, and not empty: name a new folder"
for contract in pt/tasks/*.h; do
  slug=$(basename "$contract" .h)
  grep -qF "todo(\"$slug\")" student/*/"$slug.cpp" ||
    fail "student/*/$slug.cpp is not a stub: learners would get what is in it"
done

mkdir -p "$(dirname "$folder")"
half=$(mktemp -d "$folder.XXXXXX")
trap 'rm -rf "$half"' EXIT
chmod 755 "$half"
edition_files "$not_for_learners" | copy_files "$half"
cp grader/editions/handout_README.md "$half/README.md"
headers() { (cd "$1" && find pt -name '*.h' | sort); }
diff <(headers .) <(headers "$half") >/dev/null ||
  fail "there are headers in pt/ that git does not know: add them, or take them away"

objects=$half/reference-objects
mkdir "$objects"
cmake "$build" >/dev/null
cp "$build/reference.stamp" "$objects/stamp"
copy_object() {
  strip --strip-unneeded --remove-section=.comment -o "$2" "$1"
  ! grep -qaF "$PWD" "$2" || fail "$1 tells where it was compiled"
}
for source in reference/*/*.cpp; do
  slug=$(basename "$source" .cpp)
  copy_object "$build/CMakeFiles/$slug.reference.dir/$source.o" "$objects/$slug.o"
  counted=$build/CMakeFiles/$slug.reference.counted.dir/counted/$slug.reference.cpp.o
  [ ! -e "$counted" ] || copy_object "$counted" "$objects/$slug.counted.o"
done
for source in fast/*/*.cpp; do
  slug=$(basename "$source" .cpp)
  copy_object "$build/CMakeFiles/$slug.fast.dir/$source.o" "$objects/$slug.fast.o"
done
# The stubs stand for the reference where the objects do not fit.
for stub in student/*/*.cpp; do
  mkdir -p "$objects/stubs/$(basename "$(dirname "$stub")")"
  cp "$stub" "$objects/stubs/${stub#student/}"
done

[ ! -e "$folder" ] || rmdir "$folder"
mv -T "$half" "$folder"
trap - EXIT
echo "$folder: $(find "$folder" -type f | wc -l) files, $(du -sh "$folder" | cut -f1)"
