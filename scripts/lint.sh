# shellcheck shell=bash
# `./run lint` checks the sources, and runs none of our programs. `./run` includes this file.
# shellcheck disable=SC2154 # root and build are those of ./run

# missing TOOL: reports that the tool is missing. It is a failure only where warnings are errors.
missing() {
  echo "$1 is missing: nothing is proven" >&2
  [ "${FIRSTLIGHT_WERROR:-}" != ON ]
}

# lint_with SCRIPT COMPILER
lint_with() {
  command -v "$2" >/dev/null || { missing "$2"; return; }
  bash "$root/tests/rules/$1.sh" "$root" "$build/lint/$2" "$2"
}

# Other versions break lines in other places.
lint_format() {
  command -v clang-format-14 >/dev/null || { missing clang-format-14; return; }
  (cd "$root" && sources | xargs clang-format-14 --dry-run -Werror) && return
  echo "clang-format formats these lines differently: ./run format corrects them" >&2
  return 1
}

# lint [--all]: the format alone takes seconds. All uses the oldest compilers that the README names, for some 20 minutes. What is missing
# is installed if that is allowed.
lint() {
  setup
  (setup lint) || true
  unlock_tree
  lint_format
  [ "${1:-}" = --all ] || return 0
  lint_with one_definition g++-11
  lint_with compilers clang++-14
}
