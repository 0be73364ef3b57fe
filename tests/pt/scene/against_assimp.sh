#!/usr/bin/env bash
# against_assimp.sh BUILD FOLDER: compares how our loader and assimp 5 read each .dae file below FOLDER: triangles, corners, winding
# order, normals, diffuse colours. It prints a line per file and kind of difference, then the number of files of each kind.
# docs/scenes.md says who is right. Exit code 77 without assimp (Debian: libassimp-dev).
set -euo pipefail
[ $# = 2 ] || { echo 'against_assimp.sh BUILD FOLDER' >&2; exit 2; }
echo '#include <assimp/version.h>' | c++ -x c++ -E - >/dev/null 2>&1 || { echo 'skipped: assimp is missing'; exit 77; }
cmake "$1" >/dev/null
ninja -C "$1" against_assimp >/dev/null
export program=$1/tests/against_assimp
# assimp ends with a signal on some files, so that each file has a process of its own.
one() {
  { timeout 60 "$program" "$1" 2>/dev/null || printf 'ended with %s\t\n' $?; } | sed "s|^|$1\t|"
}
export -f one
lines=$(find "$2" -iname '*.dae' -print0 | sort -z | xargs -0 -P "$(nproc)" -I{} bash -c 'one "$1"' _ {})
printf '%s\n\n' "$lines"
cut -f2 <<<"$lines" | sort | uniq -c | sort -rn
