# shellcheck shell=bash
# Configures and builds, one ./run at a time. `./run` includes this file.
# shellcheck disable=SC2154 # root, build and command are those of ./run

# lock_tree: until unlock_tree nobody else installs, configures or builds in this tree. The file contains the
# command that has the lock.
tree_is_locked=
lock_tree() {
  [ -z "$tree_is_locked" ] || return 0
  { mkdir -p "$build" && [ -w "$build" ]; } 2>/dev/null ||
    fail "$build cannot be written: copy the whole folder to a place of your own, and work there"
  tree_is_locked=yes
  command -v flock >/dev/null || return 0 # macOS has no flock: there nobody waits
  exec 9>>"$build/lock"
  local start=$SECONDS
  until flock -w 1 9; do
    progress_show "waiting for '$(cat "$build/lock")', which is building in the same folder ($((SECONDS - start)) s)"
  done
  [ "$SECONDS" -eq "$start" ] || progress_clear
  echo "./run $command" >"$build/lock"
}

unlock_tree() {
  exec 9>&-
  tree_is_locked=
}

# clear_foreign_build: removes what a copied or moved folder, or another place of the same folder, has left in build/: CMake, the
# programs and everything that is kept there know the folder where they were made, and would go on with the files of that folder.
clear_foreign_build() {
  local made
  made=$(foreign_place)
  [ -n "$made" ] || return 0
  lock_tree
  made=$(foreign_place) # another ./run may have removed it
  if [ -n "$made" ]; then
    echo "build/ was made for the folder $made, and this folder is $root: everything is built anew." >&2
    find "$build/" -mindepth 1 -maxdepth 1 ! -name lock -exec rm -rf {} + 2>/dev/null ||
      fail "some of it belongs to another user: remove the folder $build, and try again"
  fi
  unlock_tree
}

# foreign_place: a folder other than this one for which something in build/ was made; nothing if there is none.
foreign_place() {
  sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build"/*/CMakeCache.txt 2>/dev/null | grep -vxF -m 1 -- "$root" || true
}

# settings: prints what CMake is told, besides the preset.
settings() {
  local mixtures=''
  [ -e "$build/mixtures" ] && mixtures=$(sort -u "$build/mixtures" | paste -sd';' -)
  echo "$mixtures ${FIRSTLIGHT_WERROR:-OFF}"
}

# has_settings PRESET, nothing_to_do PRESET TARGET...: succeed if CMake was told what it would be told now, and if the
# targets are there. A build that another ./run does in the same folder does not disturb them.
has_settings() {
  [ ! "$root/CMakePresets.json" -nt "$build/$1/build.ninja" ] && [ "$(settings)" = "$(cat "$build/$1/settings" 2>/dev/null)" ]
}
nothing_to_do() { ninja -C "$build/$1" -n "${@:2}" 2>/dev/null | grep -q 'no work to do'; }

# compile_learners_files TARGET...: succeeds if these targets do, or may do.
compile_learners_files() { case " $* " in *student* | *.sanitized* | *.covered* | *' render '*) ;; *) return 1 ;; esac; }

# is_newest PRESET TARGET...: succeeds if what the targets compile of the learner's files was compiled from their text of now.
is_newest() { ! compile_learners_files "${@:2}" || bash "$root/scripts/ninja.sh" --check "$build/$1"; }

# configure PRESET: runs CMake with all mixtures of implementations that were asked for, if one is new or a file that CMake
# read has changed. FIRSTLIGHT_WERROR=ON makes warnings errors. Returns 2 if CMake fails; explain_configure shows why.
configure() {
  local preset=$1 folder=$build/$1 told words=()
  lock_tree
  told=$(settings)
  if ! has_settings "$preset"; then
    words=(cmake -S "$root" --preset "$preset" "-DFIRSTLIGHT_MIXTURES=${told% *}" "-DFIRSTLIGHT_WERROR=${told##* }")
  elif ! nothing_to_do "$preset" build.ninja; then
    words=(ninja -C "$folder" build.ninja)
  else
    return 0
  fi
  mkdir -p "$folder"
  with_progress "configuring ($preset)" "$folder/configure.log" "${words[@]}" || return 2
  printf '%s' "$told" >"$folder/settings"
  [ ! -e "$folder/not_compiled" ] || cat "$folder/not_compiled" >&2
}

# explain_configure PRESET: prints CMake's own sentence, without its place in CMake.
explain_configure() {
  local log=$build/$1/configure.log
  sed -n '/^CMake Error/,/^Call Stack/{/^CMake Error/d;/^Call Stack/d;p}' "$log" | grep . >&2 || tail "$log" >&2
}

# forget_mixtures: fails if there are none. An old mixture may not exist any more, for example in a copy of the folder on
# another machine.
forget_mixtures() { [ -s "$build/mixtures" ] && rm "$build/mixtures"; }

# task_file TASK: the learner's file of the task, from student/ on; nothing if it is gone.
task_file() { (cd "$root/student" && find . -mindepth 2 -maxdepth 2 -name "$1.cpp" | sed 's|^[.]/||'); }

# expect_task_files: fails if a file of the learner is gone.
expect_task_files() {
  local slug
  for slug in $(tasks_meant); do
    [ -n "$(task_file "$slug")" ] ||
      fail "student/*/$slug.cpp is gone: get it back (git checkout student), or write it again from pt/tasks/$slug.h"
  done
}

# name_changed_files: names the files of a learners' edition, besides the learner's own, that make so much to build.
name_changed_files() {
  local changed
  changed=$(cd "$root" && sha256sum --quiet -c .edition 2>/dev/null | sed -n 's|: FAILED.*||p' | grep -v '^student/' | head -n 5 |
    paste -sd' ' -) || true
  [ -z "$changed" ] || echo "Much is built again, because these files were changed: $changed (git checkout $changed takes them back)" >&2
}

# build PRESET TARGET...: prints nothing, and waits for nobody, if there is nothing to do; prints the compiler's messages if
# it fails.
build() {
  local preset=$1 steps
  shift
  ! compile_learners_files "$@" || expect_task_files
  setup
  if [ -z "$tree_is_locked" ] && has_settings "$preset" && nothing_to_do "$preset" build.ninja &&
    is_newest "$preset" "$@" && nothing_to_do "$preset" "$@"; then
    return 0
  fi
  lock_tree
  configure "$preset" || { forget_mixtures && configure "$preset"; } || { explain_configure "$preset"; exit 2; }
  steps=$(ninja -C "$build/$preset" -n "$@" 2>/dev/null) || true
  if [[ $steps != *'no work to do'* ]] || ! is_newest "$preset" "$@"; then
    [ ! -e "$root/.edition" ] || [ "$(wc -l <<<"$steps")" -lt 30 ] || name_changed_files
    if ! NINJA_STATUS='[%f/%t] ' with_progress "building $1 ($preset)" "$build/$preset/build.log" \
      bash "$root/scripts/ninja.sh" "$build/$preset" "$@"; then
      grep -vE '^(ninja: |\[[0-9]+/[0-9]+\] )' "$build/$preset/build.log" | sed 's/\bunrecorded_//g' >&2
      fail "the build failed; the whole output is in build/$preset/build.log"
    fi
  fi
  unlock_tree
}
