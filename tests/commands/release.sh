#!/usr/bin/env bash
# Makes a release twice: the same bytes. Its archive has no line of a solution, is unpacked in another place, and grades there with
# what is compiled in it.
# release.sh BUILD: its compiled parts are taken. The image is left out, because it would be downloaded.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"
build=$1
stops=yes
version=$(./run --version | cut -d' ' -f2)
name=firstlight-$version

for each in one two; do
  expect 0 'The image is left out, as --no-image says' scripts/editions/release.sh "$build" "$folder/$each" --no-image
done
expect 2 'exists and is not empty' scripts/editions/release.sh "$build" "$folder/two" --no-image
diff -r "$folder/one" "$folder/two" || complain 'the second release has other bytes'
[ "$(cd "$folder/one" && printf '%s ' *)" = "SHA256SUMS $name-$(. /etc/os-release && echo "$ID-$VERSION_ID")-$(uname -m).tar.gz notes.md " ] ||
  complain "it has other files: $(ls "$folder/one")"
(cd "$folder/one" && sha256sum --quiet --strict -c SHA256SUMS && [ "$(wc -l <SHA256SUMS)" -eq 2 ]) || complain 'the checksums are not those of the files'

# The notes are the section of this version alone.
grep -qxF -- "$(sed -n "/^## $version/,\$p" CHANGELOG.md | sed -n 3p)" "$folder/one/notes.md" || complain 'the notes are not those of this version'
! grep -q '^## ' "$folder/one/notes.md" || complain 'the notes have a heading of a version'
# shellcheck source=scripts/editions/files.sh
. scripts/editions/files.sh
printf '%s\n' '## 1.10.0' 'ten' '## 1.1.0, not released' '' 'one' '' '## 1.0.0' 'zero' >"$folder/changes"
[ "$(notes_of 1.1.0 "$folder/changes")" = one ] || complain 'the notes of 1.1.0 are wrong'
[ "$(notes_of 1.0.0 "$folder/changes")" = zero ] || complain 'the notes of 1.0.0 are wrong'
[ -z "$(notes_of 1.1 "$folder/changes")" ] || complain 'the beginning of a version is taken for a version'

# One folder, one time, one owner; no solution and no repository.
tar -tvf "$folder/one/"*.tar.gz --full-time --numeric-owner >"$folder/entries"
[ "$(awk '{ print $2, $4, $5 }' "$folder/entries" | sort -u | wc -l)" -eq 1 ] || complain 'its files have several times or owners'
! awk '{ print $6 }' "$folder/entries" | grep -vE "^$name/" || complain "not all is in the folder $name"
! awk '{ print $6 }' "$folder/entries" | grep -E "^$name/(\.git/|reference/|fast/|tests/)" || complain 'it has what is not for learners'

mkdir "$folder/another place"
tar -C "$folder/another place" -xf "$folder/one/"*.tar.gz

# No file for learners has a long line of the reference.
trimmed() { cat "$@" | sed 's/^ *//; s/ *$//' | sort -u; }
mapfile -t open < <(find student pt -name '*.cpp' -o -name '*.h' -o -name '*.md')
comm -23 <(trimmed {reference,fast}/*/*.cpp fast/*/*.h) <(trimmed "${open[@]}") | grep -E '.{41}' >"$folder/lines"
[ "$(wc -l <"$folder/lines")" -gt 100 ] || complain 'the reference has hardly any lines: this looks for nothing'
! grep -raFf "$folder/lines" "$folder/another place" || complain 'it has lines of the reference'
! nm "$folder/another place/$name"/reference-objects/{,mistakes/}*.o | grep -i ' [tbdr] .*_GLOBAL__N_' ||
  complain 'the objects name what is local to the reference'

# Unpacked elsewhere, without a compiler cache, the learner's file alone is compiled.
cd "$folder/another place/$name"
export CCACHE_DISABLE=1
expect 1 'not attempted' ./run grade hit_triangle --no-pictures
! grep -E '^build [^:]*[.]o:' build/check/build.ninja | grep -vE 'student/|recorded/' || complain 'more than the file of a learner is compiled'
cp "$OLDPWD/reference/1_rays/hit_triangle.cpp" student/1_rays
expect 0 '1 of 1 task' ./run grade hit_triangle --no-pictures
grep -qF ". Firstlight $version." "$folder/said" || complain "the report has another version: $(tail -1 "$folder/said")"
[ "$(./run --version)" = "Firstlight $version" ] || complain "it says that it is $(./run --version)"
cd "$OLDPWD"

# The workflow refuses a tag that is not the version.
python3 -c 'import yaml' 2>/dev/null || { echo 'the workflow is not looked at: python3-yaml is missing (scripts/packages.txt)'; finish; }
python3 - <<'END' >"$folder/steps"
import yaml
steps = yaml.load(open(".github/workflows/release.yml"), yaml.BaseLoader)["jobs"]["make"]["steps"]
print("git() { :; }", *[step["run"] for step in steps if "./run" in step.get("run", "")], sep="\n")
END
mkdir "$folder/stub"
# shellcheck disable=SC2016
printf '#!/bin/sh\n[ "$1" != --version ] || exec "%s/run" --version\necho "makes: $*"\n' "$PWD" >"$folder/stub/run"
chmod +x "$folder/stub/run"
cd "$folder/stub"
export GITHUB_REF_NAME
GITHUB_REF_NAME=v$version expect 0 'makes: release release' bash --noprofile --norc -eo pipefail "$folder/steps"
GITHUB_REF_NAME=v$version.1 expect 1 'is not the version' bash --noprofile --norc -eo pipefail "$folder/steps"
finish
