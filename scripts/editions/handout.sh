#!/usr/bin/env bash
# handout.sh BUILD FOLDER: makes the learners' edition. The reference and everything that is not the learner's are there
# compiled, from BUILD. Runs in the root of the project; `./run handout` calls it.
set -euo pipefail
# shellcheck source=scripts/editions/files.sh
. scripts/editions/files.sh
build=$1 folder=${2%/}

fail() {
  step
  printf '%s\n' "$*" >&2
  exit 2
}

# step WORDS: on a terminal, one line shows the current step; without words the line is removed.
step() { [ ! -t 2 ] || printf '\r\033[K%s' "${1:+packing the handout: $1}" >&2; }

expect_new_folder "$folder"
expect_stubs
expect_headers

mkdir -p "$(dirname "$folder")"
half=$(mktemp -d "$folder.XXXXXX")
trap 'rm -rf "$half"' EXIT
chmod 755 "$half"
edition_files "$not_for_learners" | copy_files "$half"
copy_known "$build" "$half"
# Without the commands that learners do not have, and the packages of those.
awk '/^#/ || $2 == "student"' scripts/packages.txt >"$half/scripts/packages.txt"
awk '/^== /{ ours = $2 ~ /^(bless|grade-class|ladder)$/ } !ours' docs/help.txt >"$half/docs/help.txt"
cp scripts/editions/handout_README.md "$half/README.md"
mkdir -p "$half/.github/workflows"
cp scripts/editions/ci/github.yml "$half/.github/workflows/grade.yml"
cp scripts/editions/ci/gitlab.yml "$half/.gitlab-ci.yml"
system=$(. /etc/os-release && echo "$ID:$VERSION_ID")
case $system in debian:[0-9]* | ubuntu:[0-9]*)
  sed -i -E "s/^(FROM| *container:|image:) .*/\1 $system/" "$half"/{.devcontainer/Dockerfile,.github/workflows/grade.yml,.gitlab-ci.yml} ;;
esac

objects=$half/reference-objects
mkdir "$objects"
cmake "$build" >/dev/null
# Replaces the name of this folder: the same number of characters, which mean the current folder.
nowhere=.$(printf '%*s' "${#PWD}" '' | tr ' ' /)
# rename_locals OBJECT: the linker needs names for thread-local variables, but any names will do.
rename_locals() {
  local name options=()
  for name in $(nm "$1" 2>/dev/null | sed -n 's/^.* [bdrt] //p'); do options+=("--redefine-sym=$name=local${#options[@]}"); done
  [ ${#options[@]} -eq 0 ] || objcopy "${options[@]}" "$1"
}

# copy_stripped FROM TO: copies without local names, debugging information, and the path where it was compiled.
copy_stripped() {
  step "$(basename "$2")"
  mkdir -p "$(dirname "$2")"
  strip --strip-unneeded --remove-section=.comment -o "$2" "$1"
  [[ $2 != *.o ]] || rename_locals "$2"
  LC_ALL=C sed -i "s|$PWD/|$nowhere|g" "$2"
  ! grep -qaF "$PWD" "$2" || fail "$1 contains the path where it was compiled"
}
for source in reference/*/*.cpp; do
  slug=$(basename "$source" .cpp)
  copy_stripped "$build/CMakeFiles/$slug.reference.dir/$source.o" "$objects/$slug.o"
  recorded=$build/CMakeFiles/$slug.reference.recorded.dir/recorded/$slug.reference.cpp.o
  [ ! -e "$recorded" ] || copy_stripped "$recorded" "$objects/$slug.recorded.o"
done
for source in fast/*/*.cpp; do
  slug=$(basename "$source" .cpp)
  copy_stripped "$build/CMakeFiles/$slug.fast.dir/$source.o" "$objects/$slug.fast.o"
done
# The stubs replace the reference if the objects do not fit.
for stub in student/*/*.cpp; do
  mkdir -p "$objects/stubs/$(basename "$(dirname "$stub")")"
  cp "$stub" "$objects/stubs/${stub#student/}"
done

compiled=$half/compiled
while read -r kind name file; do
  case $kind in
    archive) copy_stripped "$file" "$compiled/lib$name.a" ;;
    object) file_name=${file##*.dir/} # in two folders there may be two of one name
            copy_stripped "$file" "$compiled/$name/${file_name//\//.}" ;;
    program) copy_stripped "$file" "$compiled/$name" ;;
    mistake) copy_stripped "$file" "$objects/mistakes/$name.o" ;;
  esac
done <"$build/compiled/files"
step "a list of its files"
cp "$build/compiled/links.cmake" "$compiled"
cp "$build/reference.stamp" "$compiled/stamp"
cmake "-DROOT=$half" "-DOUTPUT=$compiled/sources" "-DSTAMP=$compiled/stamp" -P cmake/source_hash.cmake
cp "$compiled/stamp" "$objects/stamp"

# The folder gets a list of its files, for ./run update, and a repository with a first commit.
cp scripts/editions/handout_gitignore "$half/.gitignore"
echo "$(./run --version) for learners, made of $(git describe --always --abbrev=12 --exclude='*' --dirty=-changed 2>/dev/null || echo unknown)" >"$half/docs/edition.txt"
(cd "$half" && find . -type f -printf '%P\n' | sort | tr '\n' '\0' | xargs -0 sha256sum >"$half.edition")
mv "$half.edition" "$half/.edition"
if command -v git >/dev/null; then
  step "its first commit"
  git -C "$half" -c init.defaultBranch=main init --quiet
  git -C "$half" add --all
  git -C "$half" -c user.name=Firstlight -c user.email=firstlight@localhost -c commit.gpgsign=false \
    commit --quiet -m "Firstlight, as it was given out"
fi

[ ! -e "$folder" ] || rmdir "$folder"
mv -T "$half" "$folder"
trap - EXIT
step
echo "$folder: $(wc -l <"$folder/.edition") files, $(du -sh --exclude=.git "$folder" | cut -f1). Begin there with ./run watch"
