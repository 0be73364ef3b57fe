#!/usr/bin/env bash
# A person who clicks, turns the camera and saves at random, for SECONDS: afterwards the server and the two programs of the tasks are
# about as large as after the first minute, and once it ends, no process and no file of it is left.
# soak.sh BUILD [SECONDS]. Skipped (77) if Chromium is missing.
set -euo pipefail
# shellcheck source=tests/fixtures/browser.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/browser.sh"
seconds=${2:-600} RANDOM=20261126
[ "$seconds" -ge 120 ] || { echo "soak.sh: at least 120 seconds, not $seconds" >&2; exit 2; }

# A save compiles a task in a moment, or has an error; the program of the tasks is always the same.
worker=$folder/build/view_worker.reference
mkdir -p "$folder/build" "$folder/tasks" "$folder/tmp"
cp "$1/view/view_worker.reference" "$folder/real"
cp "$folder/real" "$folder/right"
cp "$folder/real" "$worker"
cat >"$folder/build/build.ninja" <<'E2'
rule compile
  command = ! grep -q wrong $in || { echo 'task.cpp:1: error: wrong'; exit 1; }; cp ../real $out.new && mv $out.new $out
build view_worker.reference: compile ../tasks/task.cpp
E2
printf 'exec ninja -C "$@"\n' >"$folder/ninja"
echo 'saved 0' >"$folder/tasks/task.cpp"
go_to_server env "TMPDIR=$folder/tmp" "$1/view/view" --worker "$worker" --reference "$folder/right" --tasks "$folder/tasks" --build "$folder/ninja" "$folder/build" \
  scenes/box_spheres.dae -r 160 120 -s 8 --no-browser
stage=$(element '#stage')

# of PROGRAM: its process.
of() { pgrep -n -f "^$1 " || true; }
kib_of() { sed -n 's/^VmRSS:[^0-9]*\([0-9]*\).*/\1/p' "/proc/$1/status" 2>/dev/null || true; }
# The size of each program now, in KiB; of those of the tasks the largest so far, because every save starts one anew.
declare -A now=([server]=0 [own]=0 [reference]=0)
look() {
  local size
  now[server]=$(kib_of "$server")
  size=$(kib_of "$(of "$worker")")
  [ "${size:-0}" -le "${now[own]}" ] || now[own]=$size
  size=$(kib_of "$(of "$folder/right")")
  [ "${size:-0}" -le "${now[reference]}" ] || now[reference]=$size
}
sizes() { echo "server ${now[server]}, tasks ${now[own]}, reference ${now[reference]} KiB"; }

kKeys=(a d w s + - r l b v f c t n p z Z e E '.' ',' '[' ']' 1 2 3 4 5)
saves=0 steps=0 first_sizes=
start=$SECONDS
while [ $((SECONDS - start)) -lt "$seconds" ]; do
  steps=$((steps + 1))
  case $((RANDOM % 12)) in
    0 | 1 | 2 | 3) pointer "$stage" $((RANDOM % 300 - 150)) $((RANDOM % 200 - 100)) click ;;
    4) saves=$((saves + 1)); echo "saved $saves" >"$folder/tasks/task.cpp" ;;
    5) saves=$((saves + 1)); echo "wrong $saves" >"$folder/tasks/task.cpp" ;;
    6) kill -SEGV "$(of "$worker")" 2>/dev/null || true ;;
    *) post "$session/element/$stage/value" "{\"text\": \"${kKeys[RANDOM % ${#kKeys[@]}]}\"}" >/dev/null ;;
  esac
  sleep 0.1
  look
  if [ -z "$first_sizes" ] && [ $((SECONDS - start)) -ge 60 ]; then
    first_sizes="${now[server]} ${now[own]} ${now[reference]}"
    echo "after a minute: $(sizes)"
  fi
done
echo "after $((SECONDS - start)) s, $steps steps and $saves saves: $(sizes)"
[ "$(number <<<"return document.querySelectorAll('#stage canvas').length;")" = 2 ] || complain 'the page is gone'
# Threads and their heaps come with the first requests; a leak of 10 KiB in each request would be more than this.
kGrowth=32768
read -r -a before <<<"$first_sizes"
after=("${now[server]}" "${now[own]}" "${now[reference]}")
for i in 0 1 2; do
  [ "${after[i]}" -le $((before[i] + kGrowth)) ] || complain "program $i grew from ${before[i]} to ${after[i]} KiB"
done

post "$session/url" '{"url": "about:blank"}' >/dev/null
kill "$server"
wait "$server" || complain "the server ended with $?"
sleep 0.5
! pgrep -f "^$folder/(build|right)" >/dev/null || complain 'a program of the tasks is left'
left=$(ls -A "$folder/tmp")
[ -z "$left" ] || complain "files are left: $left"
finish
