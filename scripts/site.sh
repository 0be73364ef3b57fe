# shellcheck shell=bash
# ./run site: makes sample pages, compiles the reference for browsers where emscripten is installed, and writes the site. `./run`
# includes this file.
# shellcheck disable=SC2154 # root and build are those of ./run

# hand_in NAME: a submission that is right, but for what follows.
hand_in() { mkdir -p "$work/handed_in" && cp -r "$root/reference" "$work/handed_in/$1"; }

# sample WORDS...: runs a command whose verdict may be "wrong".
sample() {
  local status=0
  "$@" >"$work/log" 2>&1 || status=$?
  [ $status -lt 2 ] || { cat "$work/log" >&2; fail "a sample page could not be made: $1"; }
}

# make_samples: a report with a mistake, the table of a class, and the paths of a pixel.
make_samples() {
  local weights=$build/mistakes/hit_triangle/weights_permuted/hit_triangle.cpp
  mkdir -p "$work/samples"
  hand_in ada
  hand_in bea && cp "$weights" "$work/handed_in/bea/1_rays"
  hand_in cem && cp "$root/student/1_rays/hit_sphere.cpp" "$work/handed_in/cem/1_rays"
  sample "$build/check/grader/grade" --config "$build/check/grader/grade.json" 1 --submission build/site/handed_in/bea --seed 7 --html "$work/samples/report.html"
  sample "$build/check/grader/grade_class" "$work/handed_in" --out "$work/class" --seed 7 --not-isolated -- 1 --no-pictures
  mkdir "$work/samples/class" && cp "$work"/class/*.html "$work/class/class.csv" "$work/samples/class"
  # What was handed in here is solutions, so the sample pages do not show it.
  sed -i -E '/<!--code .*<!--\/code /d; /<!--code /,/<!--\/code /d; /<div class="sides">/,/<\/div><\/details>/c </details>' "$work"/samples/class/*.html
  # The same site has the same bytes, so measured times go.
  sed -i -E 's/ Judging one took [^.]* on average[.]//; s|<div><dt>Time</dt><dd>[^<]*</dd></div>||' "$work"/samples/report.html "$work"/samples/class/*.html
  sample "$build/check/view/view" --worker "$build/check/view/view_worker.reference" --recipes "$root/scenes/recipes.json" scenes/box_spheres.dae \
    -r 160 120 -s 4 --pixel 80 20 --export "$work/samples/view.html"
}

# compile_live: the reference as one script with WebAssembly in it, because pages in a folder cannot load other files; `words` gets its
# option. Files that are older than their objects are not compiled again.
compile_live() {
  local folder=$build/site.live exported source object old=() objects=() sources
  command -v em++ >/dev/null || {
    echo "emscripten is missing ($(install_command "$(package_manager)") emscripten): the site gets still pictures in the place of live figures" >&2
    return
  }
  words=(--live "$folder/reference.js")
  mkdir -p "$folder"
  sources=(site/live/*.cpp pt/{todo,file}.cpp pt/geometry/bvh_builder.cpp pt/scene/{light,recorder,scene,tracer}.cpp
    pt/accel/{binary_tree,collapse,kernel,wide_bvh,kernel_plain}.cpp pt/render/radiance_path.cpp reference/*/*.cpp)
  for source in "${sources[@]}"; do
    case $source in */hit_box.cpp | */hit_sphere.cpp) continue ;; esac # in site/live/recorded.cpp
    object=$folder/${source//\//.}.o
    objects+=("$object")
    # A header, or a source that another one includes, may have changed.
    if [ ! -e "$object" ] || [ -n "$(find pt reference site/live -newer "$object" -print -quit)" ]; then old+=("$source" "$object"); fi
  done
  [ ${#old[@]} -gt 0 ] || [ ! -e "$folder/reference.js" ] || return 0
  exported=$(sed -nE 's/^(int|double\*|const double\*) ((live|numbers)_[a-z_]+)\(.*/_\2/p' site/live/*.cpp | paste -sd,)
  # Debian keeps a module that emscripten needs with those of node.
  export NODE_PATH=/usr/share/nodejs
  with_progress "compiling the reference for browsers" "$folder/log" xargs -r -P "$(nproc)" -n 2 sh -c 'em++ -std=c++20 -O3 -msimd128 -I. -c "$0" -o "$1"' \
    < <(printf '%s\n' "${old[@]}") &&
    with_progress "linking the reference for browsers" "$folder/log" em++ -O3 "${objects[@]}" -o "$folder/new.js" -s SINGLE_FILE=1 -s MODULARIZE=1 \
      -s EXPORT_NAME=Reference -s ENVIRONMENT=web -s ALLOW_MEMORY_GROWTH=1 -s EXPORTED_FUNCTIONS="$exported" -s EXPORTED_RUNTIME_METHODS=HEAPF64 --no-entry ||
    fail "the reference could not be compiled for browsers: see build/site.live/log"
  mv "$folder/new.js" "$folder/reference.js"
}

# site FOLDER [--writeup PAGES]
site() {
  local target='' pages='' work=$build/site words=()
  while [ $# -gt 0 ]; do
    case $1 in
      --writeup) [ $# -gt 1 ] || fail "--writeup takes a folder that ./run writeup has made"; pages=$(realpath -m -- "$2"); shift 2 ;;
      -*) fail "$1 is not an option of site: ./run site FOLDER [--writeup PAGES]" ;;
      *) [ -z "$target" ] || fail "name one folder: ./run site FOLDER"; target=$(realpath -m -- "$1"); shift ;;
    esac
  done
  [ -n "$target" ] || fail "name the folder: ./run site FOLDER"
  [ -z "$pages" ] || [ -e "$pages/index.html" ] || fail "--writeup: there are no pages in $pages"
  # shellcheck source=scripts/editions/files.sh
  . "$root/scripts/editions/files.sh"
  expect_new_folder "$target"
  cd "$root"
  build check site grade graded_programs grade_class view view_worker.reference
  rm -rf "$work" "$target.half"
  compile_live
  make_samples
  [ -z "$pages" ] || cp -r "$pages" "$work/samples/writeup"
  "$build/check/site/site" --root "$root" --samples "$work/samples" ${words[@]+"${words[@]}"} "$target.half" || { rm -rf "$target.half"; exit 2; }
  rm -rf "$target" && mv "$target.half" "$target"
  [ -n "$pages" ] || echo "The site has no write-up: ./run writeup --quality draft --text writeup/questions makes one, and --writeup takes its folder"
  echo "$target/index.html"
}
