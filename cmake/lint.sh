# shellcheck shell=bash
# `./run lint` checks the sources, and runs none of our programs. `./run` includes this file.
# shellcheck disable=SC2154 # root and build are those of ./run

# missing TOOL: says that the tool proves nothing, since it is missing. That is a failure only where a warning is one.
missing() {
  echo "$1 is missing: nothing is proven" >&2
  [ "${FIRSTLIGHT_WERROR:-}" != ON ]
}

# lint_with SCRIPT COMPILER
lint_with() {
  command -v "$2" >/dev/null || { missing "$2"; return; }
  bash "$root/tests/$1.sh" "$root" "$build/lint/$2" "$2"
}

# Other versions break lines elsewhere.
lint_format() {
  command -v clang-format-14 >/dev/null || { missing clang-format-14; return; }
  (cd "$root" && sources | xargs clang-format-14 --dry-run -Werror) && return
  echo "clang-format writes these lines in another way: ./run format corrects them" >&2
  return 1
}

# lint [--all]: the compilers are the oldest that the README names; what is missing is installed where that is allowed.
lint() {
  setup
  (setup packages-lint.txt) || true
  unlock_tree
  lint_format
  lint_with one_definition g++-11
  [ "${1:-}" != --all ] || lint_with compilers clang++-14
}
