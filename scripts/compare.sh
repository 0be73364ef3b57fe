# shellcheck shell=bash disable=SC2154
# ./run compare SCENE.dae: renders a scene with two codes and shows both pictures on a page. `./run` includes this file.

# compare_codes SCENE.dae [--from ... | --submission DIR] [--against ...] RENDER OPTIONS
compare_codes() {
  local a=() b=() options=() name folder name_a name_b render_a render_b
  while [ $# -gt 0 ]; do
    case $1 in
      --from | --against) [ $# -gt 1 ] || fail "$1 takes an implementation, or task=implementation" ;;
    esac
    case $1 in
      --submission) [ $# -gt 1 ] || fail "--submission takes a folder"; take_submission "$2"; a=(--from submission); shift 2 ;;
      --submission=*) take_submission "${1#--submission=}"; a=(--from submission); shift ;;
      --from) a+=(--from "$2"); shift 2 ;;
      --from=*) a+=("$1"); shift ;;
      --against) b+=(--from "$2"); shift 2 ;;
      --against=*) b+=("--from=${1#--against=}"); shift ;;
      -f* | --output | --output=*) fail "the pictures of two codes have their own places: leave out $1" ;;
      *) case $1 in *.dae) name=$(basename "$1" .dae) ;; esac
         options+=("$1"); shift ;;
    esac
  done
  [ ${#a[@]} -gt 0 ] || a=(--from student)
  [ ${#b[@]} -gt 0 ] || b=(--from reference)
  choose_mixture "${b[@]}"
  name_b=$mixture render_b=$(render_target)
  choose_mixture "${a[@]}"
  name_a=$mixture render_a=$(render_target)
  build release compare "$render_a" "$render_b"
  folder=$build/compare/$name
  mkdir -p "$folder"
  echo "A: $name_a"
  "$build/release/pt/$render_a" "${options[@]}" -f "$folder/a.exr" --notes "$folder/a.txt" || exit
  echo "B: $name_b"
  "$build/release/pt/$render_b" "${options[@]}" -f "$folder/b.exr" --notes "$folder/b.txt" || exit
  [ ! -s "$folder/a.txt" ] || name_a+=", $(cat "$folder/a.txt")"
  [ ! -s "$folder/b.txt" ] || name_b+=", $(cat "$folder/b.txt")"
  "$build/release/grader/compare" "$folder/a.exr" "$folder/b.exr" --same-numbers --html "$folder/index.html" --name-a "$name_a" --name-b "$name_b" || exit
  if [ -n "${DISPLAY-}${WAYLAND_DISPLAY-}" ] && command -v xdg-open >/dev/null; then xdg-open "$folder/index.html"; fi
}
