#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Sets everything up and runs the tests. Options go to ctest: -L unit, -L cosim, -L slow, -R NAME ...
# Without options all but the tests labelled `slow` run.
set -euo pipefail
cd "$(dirname "$0")/.."
export STEREO_PRESET=${STEREO_PRESET:-release}
./scripts/setup.sh
[ $# -gt 0 ] || set -- -LE slow
ctest --test-dir "build/$STEREO_PRESET" --output-on-failure --no-tests=error "$@"
