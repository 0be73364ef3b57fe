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
    long) echo "The long tests: hours, in pieces of at most 40 minutes on two idle cores. Stop them whenever you like: the same command goes on." ;;
  esac >&2
}

# run_pieces [PIECE ...]: the long tests one by one, and then the sanitizers, every compiler and clang-tidy. build/long_tests.txt keeps the result of each,
# its commit, the day and the seconds. A piece that has passed at this commit is not run again, so the same command goes on where it was stopped.
run_pieces() {
  local table=$build/long_tests.txt pieces piece commit start result part failed=0
  mapfile -t pieces < <(awk '$2 == "long" { print $1 }' "$build/check/tests.txt")
  for part in 1 2 3 4 5 6; do pieces+=("sanitize_$part"); done
  pieces+=(sanitize_thread lint_all tidy)
  for piece; do
    case " ${pieces[*]} " in *" $piece "*) ;; *) fail "there is no piece '$piece': ${pieces[*]}" ;; esac
  done
  [ $# -eq 0 ] || pieces=("$@")
  commit=$(git -C "$root" describe --always --dirty --abbrev=12)
  for piece in "${pieces[@]}"; do
    ! grep -q "^$piece passed $commit " "$table" 2>/dev/null || [[ $commit == *-dirty ]] || continue
    echo "== $piece" >&2
    start=$SECONDS result=passed
    case $piece in
      # The tests of what runs in threads.
      sanitize_thread) "$root/run" test test_accel_meshes test_image test_render test_render_program test_process_time process_test test_status_line \
        test_view_server test_measure test_writeup --sanitize=thread ;;
      sanitize_*) "$root/run" test --all --sanitize -I "${piece#*_},,6" ;;
      lint_all) "$root/run" lint --all ;;
      tidy) "$root/run" tidy ;;
      *) "$root/run" test "$piece" ;;
    esac || result=FAILED
    [ $result = passed ] || failed=1
    { grep -v "^$piece " "$table" 2>/dev/null || true
      echo "$piece $result $commit $(date -u +%F) $((SECONDS - start))s"; } >"$table.new"
    mv "$table.new" "$table"
  done
  sort "$table" | column -t
  return $failed
}

# run_tests [NAME ... | --all | --long [PIECE ...]] [--sanitize[=thread]] [OPTIONS of ctest]
run_tests() {
  local preset=check tier=quick names=() options=() targets=() which word said
  for word in "$@"; do
    case $word in
      --sanitize) preset=sanitize ;;
      --sanitize=thread) preset=sanitize_thread ;;
      --all | --long) tier=${word#--} ;;
      -*) options+=("$word") ;;
      *) if [ ${#options[@]} -gt 0 ]; then options+=("$word"); else names+=("$word"); fi ;;
    esac
  done
  if [ "$tier" = long ]; then
    [ ${#options[@]} -eq 0 ] || fail "the long tests take no options, but '${options[0]}' is one: name pieces, or none for all of them"
    [ ${#names[@]} -gt 0 ] || say_how_long long
    (setup test) || true
    lock_tree
    configure check || { explain_configure check; exit 2; }
    unlock_tree # each piece has its own
    run_pieces ${names[@]+"${names[@]}"}
    return
  fi
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
    esac
  fi
  [ ${#targets[@]} -eq 0 ] || build "$preset" "${targets[@]}"
  cd "$build/$preset"
  ctest --output-on-failure --no-tests=error -j "$(nproc)" "${which[@]}" ${options[@]+"${options[@]}"}
}
