#!/usr/bin/env bash
# Another project renders with pt/: its picture is that of the render program, byte by byte.
# outside.sh RENDER: the program, with the reference's tasks alone.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../fixtures/shell.sh"
scene=scenes/box_spheres.dae
cmake -S tests/pt/outside -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O2 "-DFIRSTLIGHT=$PWD" >"$folder/log" 2>&1 &&
  cmake --build "$folder/build" >>"$folder/log" 2>&1 || complain "it does not build: $(tail -20 "$folder/log")"
"$1" "$scene" -f "$folder/here.png" -r 80 60 -s 16 -m 5 --camera fit --engine wide >"$folder/said"
"$folder/build/outside" "$scene" "$folder/there.png"
cmp "$folder/here.png" "$folder/there.png" || complain 'the pictures differ'
expect 2 'no such file' "$folder/build/outside" nowhere.dae "$folder/there.png"
finish
