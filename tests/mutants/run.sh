#!/usr/bin/env bash
# run.sh --check | FOLDER [--only NAME]...
#
# Tests the tests of the framework: puts one mistake of the table (mutants.txt) after the other into a copy of
# the project in FOLDER, builds one program and runs one test there, which must fail. The results for a tree
# are kept in FOLDER, so that a run may be stopped and started again. --check: runs nothing; says which
# entries do not fit the files any more.
#
# The exit status is 1 if a mistake survives its test, 2 if the table cannot be used.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
# shellcheck source=tests/commands/copy_tree.sh
. "$root/tests/commands/copy_tree.sh"
table=$here/mutants.txt
least=486
limit=300 # seconds that a test may take

fail() {
  printf '%s\n' "$*" >&2
  exit 2
}

# edits WHAT: what cmake/edits.awk says of the table.
edits() { awk -v "root=$root" -v needed="says base old test" "$@" -f "$root/cmake/edits.awk" "$table"; }

# The table, into arrays.
names=() files=() targets=() tests=() whys=()
read_table() {
  local rows name file target test why
  rows=$(edits -v list="name base test says target") || exit 2
  while IFS=$'\t' read -r name file test why target; do
    names+=("$name") files+=("$file") targets+=("$target") tests+=("$test") whys+=("$why")
  done <<<"$rows"
  [ "${#names[@]}" -ge "$least" ] || fail "$table: ${#names[@]} mistakes are fewer than $least; keep more"
}

# The targets of entry i: what its test runs, by the table of tests, and its own.
targets_of() {
  awk -v line="${tests[$1]}" -v own="${targets[$1]}" '
    BEGIN { match(line, /(^| )tests\/[^ ]*/); test = substr(line, RSTART, RLENGTH); sub(/.*tests\//, "", test) }
    $1 == test { $1 = $2 = ""; print; found = 1 }
    END { if (own) print own; else if (!found) print test }' "$folder/tree/build/check/tests.txt"
}

build() { ninja -C "$folder/tree/build/check" "$@" >"$folder/build.log" 2>&1; }

# The test of entry i, in the folder that its program was built in.
passes() { (cd "$folder/tree/build/check" && timeout "$limit" bash -c "$1" >"$folder/test.log" 2>&1 </dev/null); }

# Without a mistake every test passes; else it would prove nothing that it fails with one. A test that is skipped here proves
# nothing either: `skipped` has its mistakes.
declare -A skipped=()
check_without_mistakes() {
  local all=("${!wanted[@]}") i needed=() status
  local -A statuses=()
  for i in "${all[@]}"; do
    # shellcheck disable=SC2207
    needed+=($(targets_of "$i"))
  done
  build "${needed[@]}" || fail "the project does not build: see $folder/build.log"
  for i in "${all[@]}"; do
    status=${statuses[${tests[i]}]:-}
    if [ -z "$status" ]; then
      status=0
      passes "${tests[i]}" || status=$?
      statuses[${tests[i]}]=$status
    fi
    case $status in
      0) ;;
      77) skipped[$i]=1 ;;
      *) fail "the test '${tests[i]}' fails without any mistake: see $folder/test.log" ;;
    esac
  done
}

# Sets `outcome` to the result of the test on the mistake.
try() {
  local i=$1 path=$folder/tree/${files[$1]}
  edits -v only="${names[i]}" >"$folder/changed" && cp "$folder/changed" "$path"
  # shellcheck disable=SC2046
  if ! build $(targets_of "$i"); then
    outcome='does not compile'
  elif passes "${tests[i]}"; then
    outcome=SURVIVES
  else
    outcome=killed
  fi
  cp "$root/${files[i]}" "$path"
}

read_table
if [ "${1:-}" = --check ]; then
  echo "${#names[@]} mistakes fit their files"
  exit
fi
[ $# -gt 0 ] || fail "say where: run.sh FOLDER"
folder=$(realpath -m -- "$1")
shift
only=()
while [ $# -gt 0 ]; do
  [ "$1" = --only ] && [ $# -gt 1 ] || fail "'$1': write --only NAME"
  only+=("$2")
  shift 2
done
declare -A wanted=()
for i in "${!names[@]}"; do
  [ ${#only[@]} -gt 0 ] || wanted[$i]=1
  for name in ${only[@]+"${only[@]}"}; do
    [ "$name" != "${names[i]}" ] || wanted[$i]=1
  done
done
[ ${#only[@]} -eq 0 ] || [ ${#wanted[@]} -eq ${#only[@]} ] || fail "a mistake of --only is not in $table"

update_copy "$root" "$folder"
[ -e "$folder/tree/build/check/build.ninja" ] ||
  (cd "$folder/tree" && cmake --preset check) >"$folder/build.log" 2>&1 ||
  fail "the copy cannot be configured: see $folder/build.log"
known=$folder/known.$(cd "$root" && grep -v ^tests/mutants/ "$folder/files" | tr '\n' '\0' |
  { xargs -0 cat 2>/dev/null || true; } | cksum | tr ' ' .) # a file that was removed is still in git's list
touch "$known"
entry() { echo "${names[$1]} ${targets[$1]} ${tests[$1]} $(edits -v only="${names[$1]}" | cksum)"; }
for i in "${!wanted[@]}"; do
  ! grep -qxF -- "$(entry "$i")" "$known" || [ ${#only[@]} -gt 0 ] || unset "wanted[$i]"
done
[ ${#wanted[@]} -eq 0 ] || check_without_mistakes

survivors=0 broken=0
printf '%-40s %-50s %s\n' mistake file outcome
for i in "${!names[@]}"; do
  if [ -n "${skipped[$i]:-}" ]; then
    outcome='not tried: its test is skipped here'
  elif [ -n "${wanted[$i]:-}" ]; then
    try "$i"
    [ "$outcome" != killed ] || entry "$i" >>"$known"
  elif [ ${#only[@]} -gt 0 ]; then
    continue
  else
    outcome='killed before'
  fi
  printf '%-40s %-50s %s\n' "${names[i]}" "${files[i]}" "$outcome"
  case $outcome in
    SURVIVES) survivors=$((survivors + 1)); echo "    ${whys[i]}" ;;
    'does not compile') broken=$((broken + 1)) ;;
  esac
done
echo "$survivors of ${#names[@]} mistakes survive, $broken do not compile, ${#skipped[@]} were not tried"
[ "$broken" -eq 0 ] || exit 2
[ "$survivors" -eq 0 ] || exit 1
