# shellcheck shell=bash
# Lists the files of a copy of the project for others, and makes the copy.

# edition_files PATTERN: lists the files of every edition, without those that match; in a git checkout, only
# files that git knows.
edition_files() {
  local parts=(run README.md LICENSE CMakeLists.txt CMakePresets.json .clang-format .clangd compile_flags.txt
    .vscode .devcontainer
    cmake docs golden grader measure pt scenes scripts student view writeup)
  {
    git ls-files -- "${parts[@]}" 2>/dev/null | grep . ||
      find "${parts[@]}" -type f 2>/dev/null
  } | grep -vE "$1"
}

# Files for people who teach or work on the project, and the solutions of tasks.
only_for_us='^scripts/(editions/|pages/|site[.])|^grader/programs/(bless[.]|know[.]|judge[.]|compare_picture[.])|^grader/renderers/|^pt/(render/export_main[.]|scene/export/)|^grader/tasks/[a-z_]+/((right|noisy|ordinary)/|mistakes[.]txt)'
# shellcheck disable=SC2034
not_for_learners="$only_for_us"'|^grader/service/(classes|platforms)/|^grader/service/intake/((archive_reader|canvas_form|entry_path|gradescope|handed_in|names_that_differ|owner|pack|pieces|unpack|written_date)[.]|form_table[.]cpp)|^grader/name_forms|^grader/tasks/[a-z_]+/methods/|^writeup/[a-z0-9]+\.md$|^docs/(decisions/|instructors|four_bugs|coil|ladder|performance|README|commands)|^README'

# expect_new_folder FOLDER, expect_stubs, expect_headers: fail if an edition would be made over something, with what somebody wrote, or
# without a header. Everything is built before an edition is made, so ./run asks first. `fail` is the caller's.
expect_new_folder() {
  [ ! -e "$1" ] || [ -z "$(ls -A "$1")" ] || fail "$1 exists and is not empty: name a new folder"
}
expect_stubs() {
  local contract slug
  for contract in pt/tasks/*.h; do
    slug=$(basename "$contract" .h)
    grep -qF "todo(\"$slug\")" student/*/"$slug.cpp" ||
      fail "student/*/$slug.cpp is not a stub: learners would get what is in it (git stash -- student puts it away)"
  done
}

expect_headers() {
  local unknown
  unknown=$(comm -13 <(edition_files '^$' | sort) <(find pt -name '*.h' | sort) | paste -sd' ')
  [ -z "$unknown" ] || fail "git does not know $unknown, which the build uses: add it or remove it"
}

# copy_known BUILD FOLDER: copies what the build has made of the known mistakes: their fingerprints, and a list of them.
copy_known() {
  mkdir "$2/grader/known"
  cp "$1"/grader/known.*.json "$1"/grader/{solutions,ordinary}.*.txt "$2/grader/known"
}

# copy_files FOLDER: copies the files that standard input lists.
copy_files() { tar -c -f - -T - | tar -x -f - -C "$1"; }

# also_in_container: lists the packages that the handout's container has besides those of scripts/packages.txt.
also_in_container() { sed -nE 's/^ +\$\(sed .*packages[.]txt\) (.*) && \\$/\1/p' .devcontainer/Dockerfile | tr ' ' '\n'; }

# notes_of VERSION CHANGELOG: prints the section of a version, without its heading.
notes_of() { awk -v "version=$1" '/^## /{ here = $2 == version || $2 == version ","; next } here' "$2" | sed '/./,$!d'; }
