#!/usr/bin/env bash
# release.sh BUILD FOLDER [--no-image]: makes what a release gives out: the handout as an archive, an image of a system with its
# packages, the notes, and checksums. The archive has the same bytes if it is made again of the same build. Runs in the root of
# the project; `./run release` calls it.
set -euo pipefail
# shellcheck source=scripts/editions/files.sh
. scripts/editions/files.sh
build=$1 folder=${2%/} image=${3-}

fail() {
  printf '%s\n' "$*" >&2
  exit 2
}

expect_new_folder "$folder"
version=$(./run --version | cut -d' ' -f2)
notes=$(notes_of "$version" CHANGELOG.md)
[ -n "$notes" ] || fail "CHANGELOG.md has no section for $version: write '## $version', and a line for each thing that is new"

mkdir -p "$(dirname "$folder")"
half=$(mktemp -d "$folder.XXXXXX")
trap 'rm -rf "$half"' EXIT
chmod 755 "$half"
# All times are those of the commit.
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || echo 0)}
export SOURCE_DATE_EPOCH
system=$(. /etc/os-release && echo "$ID-${VERSION_ID-}")
name=firstlight-$version
scripts/editions/handout.sh "$build" "$half/$name" >/dev/null
tar -C "$half" --exclude=.git --format=gnu --sort=name --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner \
  --mode=u=rwX,go=rX -cf - "$name" | gzip -9n >"$half/$name-$system-$(uname -m).tar.gz"
printf '%s\n' "$notes" >"$half/notes.md"

# The image: this system, with the packages of the handout's container and its user.
if [ -n "$image" ]; then
  echo "The image is left out, as $image says"
elif ! command -v mmdebstrap >/dev/null; then
  echo "The image is left out, because mmdebstrap is missing (apt-get install mmdebstrap)"
else
  packages=$({ awk '!/^#/ { print $1 }' "$half/$name/scripts/packages.txt"; also_in_container; } | paste -sd,)
  # shellcheck disable=SC2016 # of the hook's shell
  mmdebstrap --variant=minbase --include="$packages" --customize-hook='chroot "$1" useradd --create-home --shell /bin/bash learner' \
    "$(. /etc/os-release && echo "$VERSION_CODENAME")" "$half/$name-image-$system-$(uname -m).tar" 2>"$half.log" ||
    fail "the image could not be made: $(tail -3 "$half.log")"
  gzip -9n "$half"/*.tar
fi
rm -rf "${half:?}/$name" "$half.log"
(cd "$half" && sha256sum -- * >SHA256SUMS)

[ ! -e "$folder" ] || rmdir "$folder"
mv -T "$half" "$folder"
trap - EXIT
echo "$folder: Firstlight $version for $system: $(cd "$folder" && du -h --apparent-size -- *.gz | awk '{ print $2, $1 }' | paste -sd,), its notes and checksums"
