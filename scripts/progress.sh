# shellcheck shell=bash
# Long steps show their progress: on a terminal in one line that is rewritten, elsewhere in a line every two
# seconds. `./run` includes this file.

progress_on_terminal() { [ -t 2 ] && [ "${TERM:-dumb}" != dumb ]; }

# progress_show TEXT: shows it at once on a terminal; elsewhere only two seconds after the last line.
progress_shown=-2
progress_show() {
  if progress_on_terminal; then
    local width
    width=$(stty size <&2 2>/dev/null | cut -d' ' -f2)
    [ "${width:-0}" -gt 0 ] || width=80
    printf '\r\033[K%.*s' "$((width - 1))" "$1" >&2
  elif [ $((SECONDS - progress_shown)) -ge 2 ]; then
    printf '%s\n' "$1" >&2
    progress_shown=$SECONDS
  fi
}

progress_clear() {
  ! progress_on_terminal || printf '\r\033[K' >&2
  progress_shown=-2
}

# progress_step LINE: sets `progress_step` to the step in a line of ninja's output, in fewer words.
progress_step() {
  progress_step=$1
  case $1 in
    'Building CXX object '*)
      progress_step=${1#Building CXX object }
      progress_step=${progress_step%%CMakeFiles/*}${progress_step##*.dir/}
      progress_step=${progress_step%.o}
      progress_step="compiled ${progress_step//__\//../}"
      # Files that are compiled together (cmake/precompiled.cmake).
      progress_step=${progress_step/%\/Unity\/unity_*/: several files} ;;
    'Linking CXX '*) progress_step="linked ${1##* }" ;;
  esac
}

# with_progress WHAT LOG COMMAND ...: runs the command, keeps its output in LOG, and shows WHAT is done, the last step
# and, after the first seconds, the time left. It returns the status of the command.
with_progress() {
  local what=$1 log=$2
  shift 2
  "$@" 2>&1 9>&- | tee "$log" | progress_follow "$what"
}

# A shell older than 4.0 cannot tell a pause from the end: it shows steps only when they come.
progress_follow() {
  local what=$1 start=$SECONDS line part='' got count='' step='' left pause=(-t 1)
  [ "${BASH_VERSINFO[0]}" -ge 4 ] || pause=()
  progress_show "$what ..."
  while true; do
    got=0
    IFS= read -r ${pause[@]+"${pause[@]}"} line || got=$?
    line=$part$line part=
    if [ "$got" -gt 128 ]; then
      part=$line
    elif [ "$got" -ne 0 ]; then
      break
    elif [[ $line =~ ^\[([0-9]+)/([0-9]+)\]\ (.*) ]]; then
      count=${BASH_REMATCH[1]}/${BASH_REMATCH[2]} left=
      if [ $((SECONDS - start)) -ge 3 ]; then
        left=", about $(((SECONDS - start) * (BASH_REMATCH[2] - BASH_REMATCH[1]) / BASH_REMATCH[1] + 1)) s left"
      fi
      progress_step "${BASH_REMATCH[3]}"
      step=" [$count] $progress_step$left"
    elif [ -z "$count" ] && [ -n "$line" ] && [[ $line != ninja:* ]]; then
      step=" $line"
    fi
    progress_show "$what:${step:- ...}$([ $((SECONDS - start)) -lt 3 ] || echo " ($((SECONDS - start)) s)")"
  done
  progress_clear
}
