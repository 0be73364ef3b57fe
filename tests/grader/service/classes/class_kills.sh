#!/usr/bin/env bash
# kill -9 hits the grading of a class at ten random moments: the judge, a worker, a chunk, GNU parallel, or the program itself,
# which is then started again. The table is the same as without kills.
# class_kills.sh GRADER ENGINE: the folder with grade_class and its grade.json; local, parallel or slurm.
set -euo pipefail
grader=$1
engine=$2
# shellcheck source=tests/grader/service/classes/class_fixture.sh
. "$(dirname "${BASH_SOURCE[0]}")/class_fixture.sh"
case $engine in
  parallel) command -v parallel >/dev/null || { echo 'GNU parallel is missing (parallel): not tried'; exit 77; } ;;
  slurm) why=$(why_no_slurm); [ -z "$why" ] || { echo "$why"; exit 77; }
         start_slurm "$folder/slurm" || complain 'Slurm does not start' ;;
esac
log_what_is_judged "$grader"
make_class 50
: >"$folder/judged"
kills=10
RANDOM=18

# The processes that may be killed: all with our folder in their command line, except Slurm itself.
victims() {
  pgrep -f -- "$folder" | while read -r pid; do
    [ "$pid" -ne $$ ] || continue
    case $(tr '\0' ' ' 2>/dev/null <"/proc/$pid/cmdline") in
      *slurmctld* | *slurmd* | *munged* | *class_kills* | '') ;;
      *) echo "$pid" ;;
    esac
  done
}

begun() { wc -l <"$folder/judged"; }

start() {
  grade_class killed --engine "$engine" --chunk-size 3 --jobs 2 &
  running=$!
}

# as_many_as N: waits until N judgements have begun and a random part of the next (it takes a third of a second);
# restarts the grading if it has ended. Fails if everything is complete before.
as_many_as() {
  while [ "$(begun)" -lt "$1" ]; do
    if ! kill -0 "$running" 2>/dev/null; then
      is_complete && return 1
      start
    fi
    sleep 0.02
  done
  sleep "0.0$((RANDOM % 9))"
}

# Everybody is judged except learners who handed in nothing.
is_complete() {
  [ -e "$folder/killed/class.html" ] && [ "$(grep -c $',Firstlight [0-9.]*\r$' "$folder/killed/class.csv")" -eq 50 ]
}

moments=$(for _ in $(seq $kills); do echo $((1 + RANDOM % 38)); done | sort -n)
start
hit=0
for moment in $moments; do
  as_many_as "$moment" || break
  mapfile -t found < <(victims)
  [ ${#found[@]} -gt 0 ] || continue
  victim=${found[RANDOM % ${#found[@]}]}
  words=$(tr '\0' ' ' 2>/dev/null <"/proc/$victim/cmdline" | cut -c1-100) || true
  kill -9 "$victim" 2>/dev/null || continue
  echo "after $(begun): killed ${words//$folder\//}"
  hit=$((hit + 1))
done
[ "$hit" -ge 7 ] || complain "only $hit of $kills were killed"

# Finishes the grading, with another call if necessary.
for _ in 1 2 3 4 5 6; do
  wait "$running" 2>/dev/null || true
  ! is_complete || break
  start
done
is_complete || complain "it is not complete: $(cat "$folder/killed/class.csv")"
lines=$(begun)
echo "$lines judgements were begun, of 41 that differ"
[ "$lines" -le $((51 + 3 * kills)) ] || complain 'much was judged more than once'

rm -r "$folder/work"
grade_class whole --jobs 2 || true
same_table whole killed
