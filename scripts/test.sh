#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Sets everything up and runs the tests, as many at a time as there are processors.
#   scripts/test.sh [--times] [OPTION...]
#   --times prints the processor seconds of the build, of each test of Python files, and of all together
#   OPTION  of ctest: -L unit, -L cosim, -L synth, -R NAME ... Tests labelled `slow` run only where a label of -L names
#           them, as in -L slow, or where -LE says which ones do not: -LE none runs all
set -euo pipefail
case "${1:-}" in
   --help | -h)
      sed -n '3,7s/^# //p' "$0"
      exit 0
      ;;
esac
cd "$(dirname "$0")/.."
shows_times=no
if [ "${1:-}" = --times ]; then
   shows_times=yes
   shift
fi
# Sets `so_far` to the processor seconds of all that has run and ended. Not in $(...): a subshell has children of its own.
count_seconds() {
   times >"$seconds"
   so_far=$(awk -F '[ ms]+' 'NR == 2 { printf "%.1f", 60 * $1 + $2 + 60 * $3 + $4 }' "$seconds")
}
export STEREO_PRESET=${STEREO_PRESET:-release}
slow=no before=
for option in "$@"; do
   case "$before $option" in
      "-L "*slow* | "--label-regex "*slow* | *" --label-regex="*slow* | *" -LE" | *" --label-exclude"*) slow=yes ;;
   esac
   before=$option
done
./scripts/setup.sh
[ "$slow" = no ] || cmake --build --preset "$STEREO_PRESET" --target slow_tests
export STEREO_TIMES=$PWD/build/$STEREO_PRESET/processor_seconds.txt
seconds=$STEREO_TIMES.all
: >"$STEREO_TIMES"
count_seconds
build_seconds=$so_far
[ "$slow" = yes ] || set -- "$@" -LE slow
export STEREO_SKIPPED=$PWD/build/$STEREO_PRESET/skipped_cases.txt
rm -f "$STEREO_SKIPPED"
# Tests start the commands many times, each faster where Python keeps what it has compiled; not beside the sources.
unset PYTHONDONTWRITEBYTECODE
export PYTHONPYCACHEPREFIX=$PWD/build/pycache
code=0
ctest --test-dir "build/$STEREO_PRESET" --output-on-failure --no-tests=error -j "$(nproc)" "$@" || code=$?
if [ -s "$STEREO_SKIPPED" ]; then
   echo "In tests that passed, cases that were skipped or fail as expected:"
   sort "$STEREO_SKIPPED" | sed 's/^/   /'
fi
if [ "$shows_times" = yes ]; then
   echo "Processor seconds:"
   sort -rn "$STEREO_TIMES" | awk '{ printf "%8.1f  %s\n", $1, $2; all += $1 } END { printf "%8.1f  tests of Python files\n", all }'
   count_seconds
   printf '%8s  %s\n' "$build_seconds" "build" "$so_far" "all, with the other tests"
fi
exit "$code"
