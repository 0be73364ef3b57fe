# shellcheck shell=bash
# ./run test: builds what the tests need, and runs them. `./run` includes this file.
# shellcheck disable=SC2154 # root and build are those of ./run

# needs_of TEST...: the targets that these tests run, from the table that CMake has written. If there is no such test, it fails, and
# prints the name.
needs_of() {
  awk -v names="$*" '
    BEGIN { many = split(names, name, " ") }
    { for (i = 1; i <= many; ++i) if (name[i] == $1) { found[i] = 1; for (k = 3; k <= NF; ++k) needs = needs $k "\n" } }
    END { for (i = 1; i <= many; ++i) if (!(i in found)) { print name[i]; exit 1 }
          printf "%s", needs }' "$build/$preset/tests.txt"
}

# say_how_long TIER: before anything is built.
say_how_long() {
  case $1 in
    quick) echo "The quick tests: with nothing built yet, some 8 minutes on two idle cores; when all is built, 2." ;;
    all) echo "All tests but the long ones: with nothing built yet, some 30 minutes on two idle cores; when all is built, 16." ;;
    long) echo "The long tests: hours." ;;
  esac >&2
}

# run_tests [NAME ... | --all | --long] [--sanitize] [OPTIONS of ctest]
run_tests() {
  local preset=check tier=quick names=() options=() targets=() which word said
  for word in "$@"; do
    case $word in
      --sanitize) preset=sanitize ;;
      --all | --long) tier=${word#--} ;;
      -*) options+=("$word") ;;
      *) if [ ${#options[@]} -gt 0 ]; then options+=("$word"); else names+=("$word"); fi ;;
    esac
  done
  if [ ${#names[@]} -gt 0 ]; then
    setup
    lock_tree
    configure "$preset" || { explain_configure "$preset"; exit 2; }
    said=$(needs_of "${names[@]}") || fail "there is no test '$said'; build/$preset/tests.txt has their names"
    [ -z "$said" ] || mapfile -t targets <<<"$said"
    which=(-R "^($(IFS='|'; echo "${names[*]}"))\$")
  else
    say_how_long "$tier"
    case $tier in
      quick) targets=(quick_tests) which=(-L '^quick$') ;;
      # A test that needs one of the packages is skipped without it.
      all) (setup test) || true
           targets=(quick_tests rest_tests) which=(-LE '^long$') ;;
      long) (setup test) || true
            targets=(long_tests) which=(-L '^long$') ;;
    esac
  fi
  [ ${#targets[@]} -eq 0 ] || build "$preset" "${targets[@]}"
  cd "$build/$preset"
  ctest --output-on-failure --no-tests=error -j "$(nproc)" "${which[@]}" ${options[@]+"${options[@]}"}
  # With hours to spare: the sanitizers, every compiler, and clang-tidy.
  [ "$tier" != long ] || [ $# -gt 1 ] || { "$root/run" test --all --sanitize && "$root/run" lint --all && "$root/run" tidy; }
}
