# shellcheck shell=bash
# The commands for a whole learners' edition: switch to a newer edition, and hand in. `./run` includes this file.
# shellcheck disable=SC2154 # root and build are those of ./run

# The file .edition lists every file of an edition as sha256sum does. read_hashes reads it into the array `hashes`, by path.
read_hashes() {
  local hash path
  hashes=()
  while read -r hash path; do hashes[$path]=$hash; done
}

# open_edition FOLDER|ARCHIVE: sets `edition` to the folder that has .edition in it.
open_edition() {
  local from=$1 unpacked
  [ -e "$from" ] || fail "there is no $from"
  if [ ! -d "$from" ]; then
    unpacked=$(mktemp -d)
    # shellcheck disable=SC2064
    trap "rm -rf $(printf %q "$unpacked")" EXIT
    from=$(realpath -- "$from")
    (cd "$unpacked" && cmake -E tar xf "$from") >/dev/null 2>&1 ||
      fail "$1 cannot be unpacked: give a folder, a .zip or a .tar.gz"
    from=$unpacked
  fi
  edition=$(find "$from" -maxdepth 2 -name .edition -type f | head -1)
  [ -n "$edition" ] || fail "$1 is not a learners' edition: it has no file .edition"
  edition=$(realpath -- "$(dirname "$edition")")
  [ "$edition" != "$root" ] || fail "$1 is this edition itself: name the newer edition"
  (cd "$edition" && grep -v '  student/.*\.cpp$' .edition | sha256sum --quiet --status -c -) ||
    fail "$1 is damaged: its files differ from the list in its .edition; get it again"
}

# put PATH: replaces our file with the new edition's, in one step. The file is new now, so that it is compiled again.
put() {
  mkdir -p "$root/$(dirname "$1")"
  cp "$edition/$1" "$root/$1.new.tmp"
  mv -f "$root/$1.new.tmp" "$root/$1"
}

# update FOLDER|ARCHIVE: the twelve files stay as they are, unless they are still the stubs of the edition before. Other
# files that were changed here are kept next to the new files, as FILE.mine. A second call continues an update that was
# interrupted.
update() {
  [ $# -eq 1 ] || fail "name the newer edition: ./run update FOLDER, or its archive"
  [ -e "$root/.edition" ] || fail "this is the whole project, not a learners' edition: update it with git"
  [ "${BASH_VERSINFO[0]}" -ge 4 ] || fail "./run update needs bash 4, and this is bash $BASH_VERSION: install it (on macOS: brew install bash)"
  local edition path kept=() saved=()
  local -A hashes=() old=() new=() ours=()
  open_edition "$1"
  lock_tree
  read_hashes <"$root/.edition"
  for path in "${!hashes[@]}"; do old[$path]=${hashes[$path]}; done
  read_hashes <"$edition/.edition"
  for path in "${!hashes[@]}"; do new[$path]=${hashes[$path]}; done
  read_hashes < <(cd "$root" && printf '%s\0' "${!old[@]}" "${!new[@]}" | xargs -0 sha256sum 2>/dev/null)
  for path in "${!hashes[@]}"; do ours[$path]=${hashes[$path]}; done
  for path in "${!old[@]}" "${!new[@]}"; do
    [ "${ours[$path]-}" != "${new[$path]-}" ] || continue
    if [ -n "${ours[$path]-}" ] && [ "${ours[$path]}" != "${old[$path]-}" ]; then
      case $path in
        student/*.cpp) kept+=("$path"); continue ;;
        *) cp -p "$root/$path" "$root/$path.mine"; saved+=("$path.mine") ;;
      esac
    fi
    if [ -n "${new[$path]-}" ]; then put "$path"; else rm -f "$root/$path"; fi
    ours[$path]=${new[$path]-}
  done
  put .edition
  chmod +x "$root/run"
  echo "The newer edition is in place: $(head -1 "$root/docs/edition.txt" 2>/dev/null)"
  [ ${#kept[@]} -eq 0 ] || echo "Your files are kept: $(printf '%s\n' "${kept[@]}" | sort -u | paste -sd' ' -)"
  [ ${#saved[@]} -eq 0 ] || echo "You had changed other files; your versions are kept here: $(printf '%s\n' "${saved[@]}" | sort -u | paste -sd' ' -)"
}

# name_other_verdicts TABLE: grades with three seeds that nobody has seen, as whoever gives points does, and names the tasks whose line is
# another one than in this table.
name_other_verdicts() {
  local seed other lines known=
  rows() { grep -E '^ +[0-9]+\.[0-9]+ ' || true; }
  known=$(rows <<<"$1")
  for seed in $(od -An -N12 -tu4 /dev/urandom); do
    other=$(grade --no-pictures --quiet --seed "$seed") || true
    lines=$(rows <<<"$other" | grep -vxF -- "$known") || true
    [ -z "$lines" ] || printf 'With the random inputs of seed %s (./run grade TASK --seed %s shows them):\n%s\n' "$seed" "$seed" "$lines"
  done
}

# submit [FILE.zip]: grades the promises of all tasks, and packs their files with the table.
submit() {
  local target=${1:-firstlight-submission.zip} slug file files=() examples=() conflicts graded others half status=0
  case $target in *.zip) ;; *) fail "the archive has to be a .zip: ./run submit mine.zip" ;; esac
  case $target in /*) ;; *) target=$PWD/$target ;; esac
  cd "$root"
  while read -r slug; do
    file=$(task_file "$slug")
    [ -n "$file" ] || fail "there is no $slug.cpp in student/: all $(tasks_meant | wc -l) files have to be handed in, stubs too"
    files+=("$file")
    file=${file%.cpp}.examples.cpp
    [ ! -e "student/$file" ] || examples+=("$file")
  done < <(tasks_meant)
  conflicts=$(cd student && grep -nE '^(<<<<<<<|>>>>>>>)( |$)' "${files[@]}" | cut -d: -f1,2 | paste -sd' ' -) || true
  [ -z "$conflicts" ] || fail "a merge is not finished: remove the conflict markers first (student/: $conflicts)"
  graded=$(grade --no-pictures) || status=$?
  printf '%s\n' "$graded"
  [ "$status" -lt 2 ] || fail "nothing was packed, because the files could not be graded"
  others=$(name_other_verdicts "$graded")
  [ -z "$others" ] || printf 'Points are given with other random inputs than those at home. Of three other seeds:\n%s\n' "$others"
  half=$(mktemp -d)
  # shellcheck disable=SC2064
  trap "rm -rf $(printf '%q ' "$half" "$target.half")" EXIT
  printf '%s\n' "$graded" >"$half/graded.txt"
  for file in "${files[@]}" ${examples[@]+"${examples[@]}"}; do
    mkdir -p "$half/$(dirname "$file")"
    cp "student/$file" "$half/$file"
  done
  (cd "$half" && cmake -E tar cf "$target.half" --format=zip -- graded.txt "${files[@]}" ${examples[@]+"${examples[@]}"}) || fail "$target cannot be written"
  mv "$target.half" "$target"
  echo "$target: ${#files[@]} files, ${#examples[@]} files of examples, and the table above. ${others:+Its verdicts are not sure, see above. }Pictures were not graded: ./run grade does that."
}
