#!/usr/bin/env bash
# Gradescope runs this once, as root, when it makes the image: installs and builds everything, so that nothing
# but the submission is compiled later, and tries the grader on the reference.
set -euo pipefail
cd "${FIRSTLIGHT_AUTOGRADER:-/autograder}/source"
# The reference and the goldens are nobody's business: a submission runs as another user.
chmod 700 .
export DEBIAN_FRONTEND=noninteractive
bash run grade --submission reference --no-pictures --require-isolation
