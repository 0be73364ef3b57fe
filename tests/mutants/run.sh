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
# shellcheck source=tests/copy_tree.sh
. "$root/tests/copy_tree.sh"
table=$here/mutants.txt
least=409
limit=300 # seconds that a test may take

fail() {
  printf '%s\n' "$*" >&2
  exit 2
}

# The table, into arrays. An entry is a paragraph of lines "field: value".
names=() files=() olds=() news=() targets=() tests=() whys=()
read_table() {
  local line number=0 label value i=-1 inside=0
  while IFS= read -r line || [ -n "$line" ]; do
    number=$((number + 1))
    case $line in
      '#'*) continue ;;
      '') inside=0; continue ;;
    esac
    label=${line%%:*} value=${line#*:}
    value=${value# }
    if [ "$inside" = 0 ]; then
      [ "$label" = name ] || fail "$table:$number: an entry begins with its name; write 'name: ...'"
      inside=1
      i=$((i + 1))
      olds[i]= news[i]= files[i]= targets[i]= tests[i]= whys[i]=
    fi
    case $label in
      name) names[i]=$value ;;
      file) files[i]=$value ;;
      old) olds[i]=$value ;;
      new) news[i]=$value ;;
      target) targets[i]=$value ;;
      test) tests[i]=$value ;;
      why) whys[i]=$value ;;
      *) fail "$table:$number: '$label' means nothing; write name, file, old, new, target, test or why" ;;
    esac
  done <"$table"
}

text_of() {
  text=$(cat "$1" && printf x)
  text=${text%x}
}

# occurrences FILE OLD: sets `count` to the number of places.
occurrences() {
  text_of "$1"
  local rest=${text//"$2"/}
  count=$(((${#text} - ${#rest}) / ${#2}))
}

check_table() {
  local i problems=0 seen=' '
  complain() {
    echo "$table: ${names[i]}: $*" >&2
    problems=$((problems + 1))
  }
  for i in "${!names[@]}"; do
    case $seen in *" ${names[i]} "*) complain "there are two of this name; choose another" ;; esac
    seen="$seen${names[i]} "
    if [ -z "${files[i]}" ] || [ -z "${olds[i]}" ] || [ -z "${targets[i]}" ] || [ -z "${tests[i]}" ] || [ -z "${whys[i]}" ]; then
      complain "file, old, target, test or why is missing; write it"
      continue
    fi
    [ "${olds[i]}" != "${news[i]}" ] || complain "old and new are the same; change something"
    [ -f "$root/${files[i]}" ] || { complain "there is no ${files[i]}; say where the code is now"; continue; }
    occurrences "$root/${files[i]}" "${olds[i]}"
    [ "$count" -eq 1 ] ||
      complain "'${olds[i]}' is $count times in ${files[i]}; write a text that is there once"
  done
  [ "${#names[@]}" -ge "$least" ] || {
    echo "$table: ${#names[@]} mistakes are fewer than $least; keep more" >&2
    problems=$((problems + 1))
  }
  [ "$problems" -eq 0 ] || exit 2
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
    # shellcheck disable=SC2206
    needed+=(${targets[i]})
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
  local i=$1 path=$folder/tree/${files[$1]} targets_of
  text_of "$path"
  printf '%s' "${text/"${olds[i]}"/"${news[i]}"}" >"$path"
  # shellcheck disable=SC2206
  targets_of=(${targets[i]})
  if ! build "${targets_of[@]}"; then
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
  check_table
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
check_table
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
entry() { echo "${names[$1]} ${files[$1]} ${olds[$1]} ${news[$1]} ${targets[$1]} ${tests[$1]}"; }
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
