#!/usr/bin/env bash
# Gradescope runs this once, as root, when it makes the image: it installs and builds everything, so that only
# submissions are compiled later, and tests the grader on the reference.
set -euo pipefail
cd "${FIRSTLIGHT_AUTOGRADER:-/autograder}/source"
export DEBIAN_FRONTEND=noninteractive
# A submission is compiled and runs as another user. It has to reach the folder of its box, but must not list or read
# anything on the way: the reference and the goldens are secret.
chmod 711 .
bash run grade --submission reference --no-pictures --require-isolation
chmod 711 build build/check build/check/grader
closed() { find "$1" -mindepth 1 -maxdepth 1 "${@:2}" -exec chmod -R go-rwx {} +; }
closed . ! -name build
closed build ! -name check
closed build/check ! -name grader
closed build/check/grader ! -name graded ! -name box ! -name box_probe ! -name unpack
