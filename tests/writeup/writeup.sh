#!/usr/bin/env bash
# The write-up in draft quality: every figure exists; nothing is made twice; a changed task renews
# everything that depends on it and nothing else; a killed run continues; a crash and an endless loop
# affect only their own figure; wrong names in a text are found; the pages work in a browser.
# writeup.sh BUILD: the folder of the programs.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"
root=$PWD build=$1
made=$folder/work  # the files that the write-up writes

# Programs with their own lists of objects, so that changed code needs no compiler.
# code NAME SUFFIX: the renderer NAME, which runs writeup_render.SUFFIX, and NAME.accuracy, which measures as little as
# possible.
code() {
  local name=$1 program=$build/writeup/writeup_render.$2 task
  mkdir -p "$folder/writeup" "$folder/objects"
  printf '#!/bin/sh\nexec "%s" "$@"\n' "$program" >"$folder/writeup/$name"
  chmod +x "$folder/writeup/$name"
  for task in framework $(for each in grader/tasks/*/task.json; do basename "$(dirname "$each")"; done); do
    echo "$name $task" >"$folder/objects/$name.$task"
    echo "$task objects/$name.$task"
  done >"$folder/writeup/$name.objects"
  cp "$folder/writeup/$name.objects" "$folder/writeup/$name.accuracy.objects"
  cat >"$folder/writeup/$name.accuracy" <<END
#!/bin/bash
words=()
while [ \$# -gt 0 ]; do
  words+=("\$1")
  [ "\$1" != --seconds ] || { words+=(.1); shift; }
  shift
done
exec "$build/measure/accuracy.$2" "\${words[@]}"
END
  chmod +x "$folder/writeup/$name.accuracy"
}
# Curves of the reference alone, with the fewest possible cases; one curve of the prices.
cat >"$folder/stability" <<END
#!/bin/bash
exec "$build/measure/stability" "\$@" --no-methods --effort .001
END
cat >"$folder/measure" <<END
#!/bin/bash
words=(hit_sphere.textbook)
for word; do
  case \$word in */*) words+=("\$word") ;; *.*) ;; *) words+=("\$word") ;; esac
done
exec "$build/measure/measure" "\${words[@]}"
END
chmod +x "$folder/stability" "$folder/measure"
# writeup CODE WORD ...: runs the program.
writeup() {
  local name=$1
  shift
  ${go-} "$build/writeup/writeup" --quality draft --root "$root" --by 'an author' --from "$name" --renderer "$folder/writeup/$name" \
    --accuracy "$folder/writeup/$name.accuracy" --stability "$folder/stability" --measure "$folder/measure" --mistakes "$build/writeup" --generate "$build/scenes/generate" \
    --view "$build/view/view" --view-worker "$build/view/view_worker.reference" --work "$made" --text "${texts:-$root/writeup}" "$@"
}
# expect STATUS WORDS COMMAND ...: it ends with the status and prints the words.
expect() {
  local status=$1 words=$2 got=0
  shift 2
  "$@" >"$folder/said" 2>&1 || got=$?
  { [ "$got" -eq "$status" ] && grep -qF -- "$words" "$folder/said"; } ||
    complain "$* ended with $got, and without '$words': $(tail -5 "$folder/said")"
}

code reference reference
code student student

# A killed run continues: finished parts are not made again.
go=exec writeup reference >"$folder/first" 2>&1 &
victim=$!
for _ in $(seq 600); do
  [ "$(find "$made/renders" -name '*+*.json' 2>/dev/null | wc -l)" -ge 5 ] && break
  sleep 0.1
done
kill -9 "$victim"
wait "$victim" 2>/dev/null || true
find "$made/renders" -name '*+*.json' -printf '%p %T@\n' | sort >"$folder/before"
[ -s "$folder/before" ] || complain "nothing was finished before it was killed"
expect 0 'draft/index.html' writeup reference
renders() { sed -n 's/.* to make, \([0-9]*\) renders.*/\1/p' "$1"; }
[ $(($(renders "$folder/said") + $(wc -l <"$folder/before"))) -eq "$(renders "$folder/first")" ] ||
  complain "after a kill it made $(renders "$folder/said") of $(renders "$folder/first") renders"
while read -r file time; do
  [ "$(find "$file" -printf '%T@')" = "$time" ] || complain "$file was made again after a kill"
done <"$folder/before"

# Every figure of the list is on its page, with its files.
mapfile -t figures < <(writeup reference --list | awk '{print $2}')
[ "${#figures[@]}" -ge 20 ] || complain "the list has ${#figures[@]} figures"
for figure in "${figures[@]}"; do
  [ "$(grep -lF "<figure class=\"figure" "$made"/draft/*.html | xargs grep -hoF "id=\"$figure\"" | wc -l)" -eq 1 ] ||
    complain "$figure is not on exactly one page"
  compgen -G "$made/draft/figures/$figure.*" >/dev/null || complain "$figure has no files"
done
while read -r file; do
  [ -s "$made/draft/$file" ] || complain "a page names $file, which is not there"
done < <(grep -ohE '(src|href)="figures/[^"]+' "$made"/draft/*.html | cut -d'"' -f2 | sort -u)
if grep -n 'class="problem"' "$made"/draft/*.html; then complain "the reference has problems"; fi
if grep -no 'class="chart[^"]*" src="[^"]*" alt' "$made"/draft/*.html; then complain "charts without a size make a page jump"; fi
for page in part2 accuracy needs stability; do
  [ "$(grep -c '<svg class="chart"' "$made/draft/$page.html")" -eq "$(grep -c '^ viewBox=\|<svg class="chart".* viewBox=' "$made/draft/$page.html")" ] ||
    complain "a drawing of $page has no size"
  grep -q '<title>.*: .* at .*</title>' "$made/draft/$page.html" || complain "the charts of $page show no values under the pointer"
  ! grep -q 'gnuplot_svg\|<title>[^<]*using' "$made/draft/$page.html" || complain "the charts of $page show commands of gnuplot"
done
[ "$(grep -c '^<nav class="contents"\|^<a href="#' "$made/draft/stability.html")" -gt 12 ] || complain "stability has no contents"
[ "$(grep -c '<img src="figures/' "$made/draft/index.html")" -eq 9 ] || complain "the front page has not a picture of each page"
for page in part5 needs accuracy bugs; do
  grep -q '<math display="block"><m' "$made/draft/$page.html" || complain "$page has no formula"
done
grep -q 'Made by: .* · an author · [0-9-]* · To cite: .* (CITATION.cff)</p>' "$made/draft/index.html" || complain "the foot does not say who made the pages, when, and what to cite"

# Nothing has changed, so nothing is made.
expect 0 'draft/index.html' writeup reference
! grep -q 'to make' "$folder/said" || complain "the second call made something: $(cat "$folder/said")"

# Another adaptive_pixel renews part 5 and the measurements.
echo changed >"$folder/objects/reference.adaptive_pixel"
changed=$(writeup reference --list | { grep -F 'to be made' || true; } | awk '{print $2}' | sort | paste -sd' ')
[ "$changed" = "adaptive adaptive_uniform converge_bunny converge_point converge_spheres left_out needs needs_spheres prices survival tolerances" ] ||
  complain "another adaptive_pixel changes: $changed"
echo 'reference adaptive_pixel' >"$folder/objects/reference.adaptive_pixel"

# An untouched handout.
expect 1 'not written yet: ' writeup student 1
grep -qF 'not written yet' "$made/draft/part1.html" || complain "part 1 does not say what is missing"

# A renderer that crashes in one figure and never ends in another.
code broken reference
cat >"$folder/writeup/broken" <<END
#!/bin/bash
grep -qF '"light_samples":64' "\$1" && kill -SEGV \$\$
grep -qF '"light_samples":16' "\$1" && while :; do :; done
exec "$build/writeup/writeup_render.reference" "\$@"
END
expect 1 'soft_shadows: ' writeup broken soft_shadows
for words in crashed 'endless loop'; do
  grep -qF "$words" "$made/draft/part3.html" || complain "part 3 does not say '$words'"
done
[ -s "$made/draft/figures/soft_shadows.l4.png" ] || complain "the other pictures are missing"

# Somebody's code that measures nothing gives a sentence on the page. A program that never ends is
# stopped once.
code silent reference
cat >"$folder/writeup/silent.accuracy" <<END
#!/bin/bash
echo 'not written yet: trace_path' >&2
exit 2
END
expect 1 'needs_spheres: box_spheres: not written yet: trace_path' writeup silent needs_spheres

# If trace_path cannot be split by bounces, each bounce is rendered by itself, with the same result.
code layered reference
cat >"$folder/writeup/layered" <<END
#!/bin/bash
grep -qF '"ranges"' "\$1" && { echo 'bounces cannot be taken apart: no' >&2; exit 2; }
exec "$build/writeup/writeup_render.reference" "\$@"
END
expect 0 'layered/index.html' writeup layered components --out "$folder/layered"
for picture in full direct indirect; do
  [ -s "$folder/layered/figures/components.$picture.png" ] || complain "no layers for $picture"
done

# Somebody removes a folder during the run: a sentence and no crash.
code thief reference
cat >"$folder/writeup/thief" <<END
#!/bin/bash
rm -rf "$made/renders/times"
exec "$build/writeup/writeup_render.reference" "\$@"
END
expect 2 "there is no folder '$made/renders/times'" writeup thief soft_shadows

# What is wrong with a picture stands below it, whoever's code it is: the goldens are the reference's. Right pictures have noise alone.
# judged NAME FIGURE WORDS: the code of writeup_render.NAME.
judged() {
  "$build/writeup/writeup" --quality draft --root "$root" --from "$1" --renderer "$build/writeup/writeup_render.$1" --mistakes "$build/writeup" \
    --generate "$build/scenes/generate" --work "$made" --text "$root/writeup" --out "$folder/judged" "$2" >"$folder/said" 2>&1 || true
  grep -oE 'error [0-9][^<]*' "$folder/judged/part"[34].html >"$folder/facts" || true
  grep -qE -- "$3" "$folder/facts" || complain "$1 in $2: no '$3', but: $(cat "$folder/said" "$folder/facts")"
}
judged bsdf_applied_twice roulette '% noise, and 4[01]\.[0-9] % too dark$'
judged emission_at_every_vertex roulette '% noise, and 9[0-9]\.[0-9] % too bright$'
judged reference equal_direct 'error [0-9.]+ . [0-9.]+ %$'
! grep -q noise "$folder/facts" || complain "the reference is wrong: $(cat "$folder/facts")"

# The kept pictures are exactly the pictures of the plan.
handbook() {
  "$build/writeup/writeup" --handbook --root "$root" --from reference --renderer "$folder/writeup/reference" \
    --mistakes "$build/writeup" --generate "$build/scenes/generate" --work "$made" "$@"
}
expect 0 '' handbook --check 1 2
kept=$folder/kept
mkdir "$kept"
cp -r --parents student/pictures docs/four_bugs docs/*.png "$kept"
cp student/pictures/gems.png "$kept/student/pictures/coil_normals.png"
expect 1 'coil_normals: ' handbook --check 2 --out "$kept"
cp student/pictures/gems.png "$kept/docs/another.png"
expect 1 'another.png is not in a plan' handbook --check gems --out "$kept"
expect 0 'coil_normals.png' handbook 2 --out "$kept"
cmp -s student/pictures/coil_normals.png "$kept/student/pictures/coil_normals.png" ||
  complain "coil_normals.png was not corrected"
expect 2 'handbook' "$build/writeup/writeup" --check

# A wrong name is found before anything is made.
texts=$folder/texts
mkdir "$texts"
cp writeup/*.md "$texts"
printf '\n{{figure nothing}}\n' >>"$texts/part3.md"
expect 2 "part3.md:$(wc -l <"$texts/part3.md"): there is no figure 'nothing'" writeup reference 1
cp writeup/part3.md "$texts"
printf '\nIt is {{speedup.nothing}}.\n' >>"$texts/part4.md"
expect 2 "part4.md:$(wc -l <"$texts/part4.md"): there is no number 'speedup.nothing'" writeup reference 1
texts=$root/writeup/questions
expect 0 'draft/index.html' writeup reference 1
texts=
expect 2 "there is no part and no figure 'six'" writeup reference six

# The pages in a browser: each control of a group works once, and the console stays empty.
if ! command -v chromium >/dev/null; then
  echo "SKIPPED, the pages were not opened: chromium is missing (scripts/packages.txt)"
else
  writeup reference >/dev/null
  for page in index part1 part2 part3 part4 part5 accuracy needs stability bugs; do
    sed "s|</body>|<script>$(tr '\n' ' ' <tests/writeup/writeup_page.js | sed 's/[\\&|]/\\&/g')</script></body>|" \
      "$made/draft/$page.html" >"$made/draft/tried.html"
    HOME=$folder timeout 100 chromium --headless --no-sandbox --disable-gpu --enable-logging=stderr \
      --user-data-dir="$folder/profile" --virtual-time-budget=20000 --dump-dom \
      "file://$made/draft/tried.html" >"$folder/dom" 2>"$folder/console" || true
    grep -q 'data-tried="good"' "$folder/dom" ||
      complain "$page.html: $(grep -o 'data-tried="[^"]*"' "$folder/dom")"
    if grep -F 'CONSOLE' "$folder/console"; then complain "$page.html: the console says the above"; fi
  done
fi

finish
