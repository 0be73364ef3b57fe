#!/usr/bin/env bash
# attack_table.sh BUILD [--so-far]: makes the table of attacks in docs/decisions/0020-sandbox.md from runs of attack_test, as root
# and as nobody: with this kernel's full Landlock, without its scopes (version 5), and without Landlock. Attacks that read and write
# files also run with older versions (3: no ports, 2: no truncating, 1: no links). Root only; an hour. Exit status 1: an attack got
# through. --so-far runs nothing and makes the table from the known results.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../../.." && pwd)
fail() { printf '%s\n' "$*" >&2; exit 2; }
so_far='' failed=0 versions='all 5 4 3 2 1 0'
[ "${2:-}" != --so-far ] || { so_far=1; set -- "$1"; }
if [ $# != 1 ] || [ ! -x "$1/tests/attack_test" ]; then
  fail 'say where it is built: attack_table.sh build/check'
fi
[ "$(id -u)" = 0 ] || fail 'only root can be root and nobody'
build=$(cd "$1" && pwd)
hostile=$root/tests/fixtures/hostile
document=$root/docs/decisions/0020-sandbox.md
rows=$build/attacks # what is known of this build: it may be stopped and started again
mkdir -p "$rows"
find "$rows" -name '*.done' ! -newer "$build/grader/grade" -delete
find "$rows" -name '*.done' ! -newer "$build/tests/attack_test" -delete

# attacks_as USER VERSION: writes the notes of attack_test to $rows/USER.VERSION; once per build.
attacks_as() {
  [ ! -e "$rows/$1.$2.done" ] || return 0
  local folder=/tmp/firstlight_attacks.$1 tests='tier/*'
  case $2 in [1-4]) tests='tier/*run_time*:tier/*names_and_files*:tier/*directives*' ;; esac
  local words=("$build/tests/attack_test" "--gtest_filter=$tests")
  mkdir -p "$folder"
  : >"$rows/$1.$2"
  [ "$1" = root ] || chown "$1" "$folder" "$rows/$1.$2"
  local environment=(PATH=/usr/bin:/bin LANG=C.UTF-8 TMPDIR="$folder" TEST_TMPDIR="$folder" FIRSTLIGHT_ATTACKS="$rows/$1.$2")
  [ "$2" = all ] || environment+=(FIRSTLIGHT_LANDLOCK="$2")
  env -i "${environment[@]}" setpriv --reuid="$1" --regid="$(id -g "$1")" --clear-groups "${words[@]}" \
    >"$rows/$1.$2.log" 2>&1 || {
    tail -30 "$rows/$1.$2.log" >&2
    echo "as $1, with Landlock $2: attack_test does not pass" >&2
    failed=1
  }
  rm -rf "$folder"
  touch "$rows/$1.$2.done"
}

# sentence ATTACK: the first comment of its entry.
sentence() {
  [ "$1" != killed/hit_box ] || { echo 'The judge is killed while a worker computes.'; return; }
  awk -v task="${1##*/}" '/^=== / { here = $2 == task; next } here && !/^\/\/ / { exit }
    here { sub(/^\/\/ /, ""); printf "%s%s", gap, $0; gap = " " } END { print "" }' "$hostile/${1%%/*}.txt"
}

# in_words STATE...: one state per version, empty if untested. Equal states are joined; the last, without
# Landlock, is separate if it differs.
in_words() {
  local last=${!#} other
  mapfile -t other < <(printf '%s\n' "${@:1:$#-1}" | sed '/^$/d' | uniq)
  local words
  words=$(printf ', %s' "${other[@]:-not run}")
  words=${words:2}
  [ -z "$last" ] || [ "$last" = "$words" ] || words="$words; $last"
  echo "$words"
}

for version in all 5 0 1 3 2 4; do
  for user in root nobody; do
    [ -n "$so_far" ] || attacks_as $user $version
    touch "$rows/$user.$version"
  done
done

{
  echo '| attack | A, root | A, nobody | B, root | B, nobody |'
  echo '|---|---|---|---|---|'
  cut -f1 "$rows"/*.{all,5,4,3,2,1,0} | sort -u | while read -r attack; do
    line="| $(sentence "$attack")"
    for tier in A B; do
      for user in root nobody; do
        cells=()
        for version in $versions; do
          cells+=("$(awk -F '\t' -v a="$attack" -v t="$tier" '$1 == a && $2 == t { print $3 }' \
            "$rows/$user.$version" | tail -1)")
        done
        line="$line | $(in_words "${cells[@]}")"
      done
    done
    echo "$line |"
  done
} >"$rows/table"
awk -v table="$rows/table" '
  /^<!-- attacks -->$/ { print; while ((getline line < table) > 0) print line; skip = 1; next }
  /^<!-- end -->$/ { skip = 0 }
  !skip' "$document" >"$rows/document"
cat "$rows/document" >"$document"
! grep -h 'GOT THROUGH' "$rows"/*.{all,5,4,3,2,1,0} && [ $failed = 0 ]
