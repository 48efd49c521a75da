#!/usr/bin/env bash
# Gradescope runs this once when it builds the image of the autograder.
# The zip holds: setup.sh, run_autograder, jointwise/ (the source), key.toml, and the files of exercises that the key names.
set -euo pipefail
cd "${AUTOGRADER:-/autograder}/source"
jointwise/dev setup
