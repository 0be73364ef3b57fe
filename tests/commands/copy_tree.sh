# shellcheck shell=bash
# update_copy ROOT FOLDER: makes FOLDER/tree a copy of the project in ROOT: the files that git knows, and new files. A file that
# is the same keeps its time, so that a build in the copy compiles only what has changed. A file that is gone from ROOT is removed
# from the copy. FOLDER/files lists the copied files.
update_copy() {
  local root=$1 tree=$2/tree list=$2/files path
  mkdir -p "$tree"
  (cd "$root" && { git ls-files --cached --others --exclude-standard 2>/dev/null | grep . ||
    find . -name build -prune -o -type f -printf '%P\n'; } | sort -u) >"$list.now"
  if [ -e "$list" ]; then
    comm -23 "$list" "$list.now" | while IFS= read -r path; do rm -f "$tree/$path"; done
  fi
  while IFS= read -r path; do
    [ -f "$root/$path" ] || { rm -f "$tree/$path"; continue; }
    cmp -s "$root/$path" "$tree/$path" && continue
    mkdir -p "$tree/$(dirname "$path")"
    cp "$root/$path" "$tree/$path"
  done <"$list.now"
  mv "$list.now" "$list"
}
