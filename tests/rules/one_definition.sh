#!/usr/bin/env bash
# one_definition.sh ROOT BUILD COMPILER: links programs of the grader with link-time optimisation, which detects if two files
# define one type or function in different ways: undefined behaviour that no single file shows. BUILD is a folder for CMake's
# files. Nothing is optimised, because types are compared before, and nothing is run. First it checks the lists of all targets,
# with the benchmarks, which no build of the tests has: no file is compiled twice, and no library is listed for nothing.
set -euo pipefail

root=$1 build=$2 compiler=$3
# Together these contain every folder of the grader, and the write-up's programs that start submissions. They are not run, so
# they are built without the programs of all tasks, which they would start.
programs=(watch hint grade grade_class bless stability graded.hit_bvh graded_picture wrong_and_right_test naming know
  writeup_boxed measure)
mkdir -p "$build"
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O0 -flto=auto" -DFIRSTLIGHT_PCH=OFF -DFIRSTLIGHT_LINK_ONLY=ON \
  -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_EXE_LINKER_FLAGS="-Werror=odr -Werror=lto-type-mismatch" \
  -DCMAKE_AR="$(command -v gcc-ar)" -DCMAKE_RANLIB="$(command -v gcc-ranlib)" \
  -DFIRSTLIGHT_WERROR=ON >"$build/configure.log" 2>&1 || {
  cat "$build/configure.log" >&2
  exit 2
}
for lists in compiled_once link_lists; do
  python3 "$root/tests/rules/$lists.py" "$build" >"$build/$lists.log" || {
    cat "$build/$lists.log" >&2
    exit 1
  }
done
ninja -C "$build" "${programs[@]}" >"$build/build.log" 2>&1 || {
  grep -vE '^(ninja: |\[[0-9]+/[0-9]+\] )' "$build/build.log" >&2
  exit 1
}
echo "$compiler: ${#programs[@]} programs, one definition of everything"
