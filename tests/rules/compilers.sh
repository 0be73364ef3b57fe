#!/usr/bin/env bash
# compilers.sh ROOT BUILD COMPILER: compiles every source of the project with another compiler, with warnings as
# errors. Nothing is linked, and the learners' files may have warnings. BUILD is a folder for CMake's files.
set -euo pipefail

root=$1 build=$2 compiler=$3
mkdir -p "$build"
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_CXX_COMPILER_LAUNCHER= -DFIRSTLIGHT_WERROR=ON >"$build/configure.log" 2>&1 || {
  cat "$build/configure.log" >&2
  exit 2
}
cd "$build"
# The build writes some sources.
ninja -t targets rule CUSTOM_COMMAND | grep -E '\.(cpp|h)$' | xargs ninja >"$build/generated.log"
ninja -t commands all | grep -E -- ' -c [^ ]*\.cpp$' |
  sed -E 's/ -MD -MT [^ ]+ -MF [^ ]+ -o [^ ]+ -c / -fsyntax-only /' | awk '!seen[$NF]++' >"$build/commands"
[ -s "$build/commands" ] || { echo "$compiler: there is nothing to compile" >&2; exit 2; }
tr '\n' '\0' <"$build/commands" | xargs -0 -P "$(nproc)" -n 1 bash -c
echo "$compiler: $(wc -l <"$build/commands") sources, no warnings"
