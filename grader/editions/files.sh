# shellcheck shell=bash
# The files of a copy of the project for others, and the function that makes such a copy.

# edition_files PATTERN: the files that every edition has, but those that match; in a working copy, only
# those that git knows.
edition_files() {
  local parts=(run README.md LICENSE CMakeLists.txt CMakePresets.json .clang-format .clangd compile_flags.txt
    .vscode .devcontainer
    cmake docs golden grader pt scenes student writeup)
  {
    git ls-files -- "${parts[@]}" 2>/dev/null | grep . ||
      find "${parts[@]}" -type f 2>/dev/null
  } | grep -vE "$1"
}

# Files that only those need who teach or work on the project, and the solutions of tasks.
only_for_us='^grader/(editions|intake|self_check)/|^grader/programs/(bless[.]|know[.]|unpack[.]|grade_class/)|^cmake/packages-class[.]|^grader/tasks/[a-z_]+/((wrong|right|noisy)/|(mistakes|relatives)[.]txt)'
# shellcheck disable=SC2034
not_for_learners="$only_for_us"'|^grader/tasks/[a-z_]+/methods/|^writeup/[a-z0-9]+\.md$|^docs/(decisions/|help/(bless|grade-class|ladder)|instructors|four_bugs|box_spheres|ladder|performance)|^README'

# copy_known BUILD FOLDER: by what mistakes are named, as the build has found it out.
copy_known() {
  mkdir "$2/grader/known"
  cp "$1"/grader/known.*.json "$2/grader/known"
}

# copy_files FOLDER: those on standard input.
copy_files() { tar -c -f - -T - | tar -x -f - -C "$1"; }
