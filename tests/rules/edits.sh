#!/usr/bin/env bash
# edits.sh: tests the files that cmake/edits.awk makes of correct tables, and its messages about faulty tables.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"

# edits TABLE WHAT: the table is on standard input below $folder.
edits() { awk -v "root=$folder" -v "reference=$folder/right.cpp" -v needed="says base" "$@" -f cmake/edits.awk "$folder/table"; }

printf '// right: a\n#include "a.h"\n\nint a() {\n  int i = 1;\n\n  return i + i;\n}\n' >"$folder/right.cpp"
cat >"$folder/table" <<'END'
# A comment.

breaks  a_promise

name    two_places
says    It says
        so.
hint    Look.
base    right.cpp
include <cmath>
old     int i = 1;
new     int i = 2;

          int j = 3;
old     + i;
new     + j;
vary    int j = 3 => int j = 4

breaks  another_promise

name    as_it_is
says    Nothing changes.
base    reference

name    one_more
says    It changes the first.
base    two_places
old     i + j
new     j + j
END
edits -v out="$folder/made" -v file=a.cpp >"$folder/names"
printf 'two_places\nas_it_is\none_more\n' | diff - "$folder/names" || complain 'other names'
diff - "$folder/made/two_places/a.cpp" <<'END' || complain 'another file'
// breaks: a_promise
// It says
// so.
// hint: Look.
#include <cmath>
#include "a.h"

int a() {
  int i = 2;

  int j = 3;

  return i + j;
}
END
[ "$(edits -v only=two_places | sed -n 1p)" = '// right: a' ] || complain 'one file has lost its first line'
[ "$(edits -v list="name breaks")" = "$(printf 'two_places\ta_promise\nas_it_is\tanother_promise\none_more\tanother_promise')" ] ||
  complain 'another list'
[ "$(edits -v only=one_more | sed -n '2p;$p')" = $'#include <cmath>\n}' ] && edits -v only=one_more | grep -qx '  return j + j;' ||
  complain 'an edit of an edit is another file'
[ "$(edits -v relatives="$folder/relatives" -v file=a.cpp)" = two_places ] || complain 'other relatives'
sed 's/int j = 3/int j = 4/; 2,4d; 1s/.*/\/\/ breaks: two_places/' "$folder/made/two_places/a.cpp" | diff - "$folder/relatives/two_places/a.cpp" ||
  complain 'another relative'
touch -d 2001-01-01 "$folder/made/two_places/a.cpp"
edits -v out="$folder/made" -v file=a.cpp >/dev/null
[ "$(date -r "$folder/made/two_places/a.cpp" +%Y)" = 2001 ] || complain 'a file that has not changed is written again'

# refuses WORDS: tests that the table on standard input is refused in one sentence with exit status 2.
refuses() {
  local status=0 said
  cat >"$folder/table"
  said=$(edits -v out="$folder/refused" -v file=a.cpp 2>&1) || status=$?
  [ "$status" -eq 2 ] && [[ $said == "$folder/table:"*"$1"* ]] && [ "$(wc -l <<<"$said")" -eq 1 ] ||
    complain "it should say '$1' and end with 2, not $status:" "$said"
}

entry=$'name    a\nsays    S.\nbase    right.cpp\n'
refuses "is 0 times" <<<"${entry}old     nowhere"$'\n'"new     x"
refuses "is 2 times" <<<"${entry}old     int"$'\n'"new     j"
refuses "is 2 times in right.cpp (1 after" <<<"${entry}old     int i"$'\n'"new     auto i"$'\n'"old     int"$'\n'"new     long"
refuses "after the edits above it" <<<"${entry}old     1;"$'\n'"new     1 + i;"$'\n'"old     + i;"$'\n'"new     ;"
refuses "are the same" <<<"${entry}old     1;"$'\n'"new     1;"
refuses "say where the code is now" <<<"${entry/right.cpp/gone.cpp}old     1;"$'\n'"new     2;"
refuses "not once" <<<"${entry}vary    ; => ;;"
refuses "not 'A => B'" <<<"${entry}vary    int i"
refuses "above the entries" <<<"${entry}breaks  a_promise"
refuses "an edit of itself" <<<"${entry/right.cpp/a}"
refuses "has no 'says'" <<<$'name    a\nbase    right.cpp'
refuses "has no 'base'" <<<$'guard   a\nold     1;\nnew     2;'
refuses "two of the name a" <<<"$entry"$'\n'"$entry"
refuses "is not a label" <<<"${entry}colour  red"
refuses "begins with its name" <<<$'says    S.'
refuses "continues nothing" <<<$'        S.'

# The base of all entries, and a guard, which has no sentence, between two mistakes that have one.
printf '%s\n' 'base    right.cpp' '' 'breaks  a_promise' '' 'name    a' 'says    S.' 'old     1;' 'new     2;' '' \
  'guard   b' 'old     1;' 'new     3;' '' 'name    c' 'says    S.' 'base    b' 'old     3;' 'new     4;' >"$folder/table"
[ "$(edits -v out="$folder/guarded" -v file=a.cpp | tr '\n' ' ')" = 'a b c ' ] || complain 'not three entries'
[ "$(sed -n 1,2p "$folder/guarded/b/a.cpp")" = $'// breaks: a_promise\n#include "a.h"' ] || complain 'a guard has a comment'
grep -qx '  int i = 2;' "$folder/guarded/a/a.cpp" && grep -qx '// S.' "$folder/guarded/a/a.cpp" && grep -qx '  int i = 3;' "$folder/guarded/b/a.cpp" &&
  grep -qx '  int i = 4;' "$folder/guarded/c/a.cpp" || complain 'another base than that of all entries'
finish
