#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the fuzz targets (preset fuzz: Clang 16, libFuzzer, address and undefined-behaviour sanitizer) and runs them one
# after the other. What a run learns stays in build/fuzz/corpus/TARGET for the next one; seeds are in hls_tb/fuzz/corpus.
#   scripts/fuzz.sh [--seconds N] [TARGET...]
#   --seconds  of each target (default 600)
#   TARGET     calibration, camera_calibration, disparities, image, pfm (default: all)
# Exit codes: 0 nothing found, 1 an input was found, 2 bad options, 3 missing tool, 4 the build failed.
set -euo pipefail
cd "$(dirname "$0")/.."

end() {
   echo "fuzz.sh: $2" >&2
   exit "$1"
}

all=(calibration camera_calibration disparities image pfm)
seconds=600 targets=()
while [ $# -gt 0 ]; do
   case "$1" in
      --seconds)
         [[ ${2:-} =~ ^[1-9][0-9]{0,6}$ ]] || end 2 "--seconds needs a whole number above 0 (see fuzz.sh --help)"
         seconds=$2
         shift
         ;;
      --help | -h)
         sed -n '3,8s/^# //p' "$0"
         exit 0
         ;;
      -*) end 2 "unknown option '$1' (see fuzz.sh --help)" ;;
      *)
         [[ " ${all[*]} " == *" $1 "* ]] || end 2 "unknown target '$1'; known are: ${all[*]}"
         targets+=("$1")
         ;;
   esac
   shift
done
[ "${#targets[@]}" -gt 0 ] || targets=("${all[@]}")

on_debian="on Debian: apt-get install clang-16 libclang-rt-16-dev"
command -v clang++-16 >/dev/null || end 3 "clang++-16 not found in PATH; $on_debian"
work=build/fuzz
mkdir -p "$work" 2>/dev/null || end 4 "the folder $work cannot be created"
# A package of its own.
echo 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }' |
   clang++-16 -fsanitize=fuzzer,address,undefined -x c++ - -o "$work/probe" 2>"$work/probe.log" ||
   end 3 "clang++-16 cannot link with its sanitizers (see $work/probe.log); $on_debian"
echo "Building the targets ..."
{ cmake --preset fuzz -Wno-dev && cmake --build --preset fuzz; } >"$work/build.log" 2>&1 || end 4 "the build failed; see $work/build.log"

# OpenCV's own limit, so that small files do not ask for large images; reports go to files because the readers under test
# silence stderr. Leaks are left to the replay in the preset sanitize: looking for them after each input takes most of the time.
export OPENCV_IO_MAX_IMAGE_PIXELS=1048576

# The last line of a log that tells of progress, as "N executions, coverage M".
progress() { sed -nE 's/^#([0-9]+)\s+\S+\s+cov: ([0-9]+).*/\1 executions, coverage \2/p' "$1" | tail -n 1; }

summary=() found=0
for target in "${targets[@]}"; do
   corpus=$work/corpus/$target finds=$work/found/$target log=$work/$target.log
   mkdir -p "$corpus" "$finds"
   rm -f "$work/$target".report.*
   ASAN_OPTIONS=log_path=$work/$target.report:quarantine_size_mb=32 UBSAN_OPTIONS=log_path=$work/$target.report:print_stacktrace=1 \
      "$work/fuzz/fuzz_$target" -max_total_time="$seconds" -timeout=20 -max_len=4096 -detect_leaks=0 -print_final_stats=1 \
      -artifact_prefix="$finds/" "$corpus" "hls_tb/fuzz/corpus/$target" >"$log" 2>&1 &
   fuzzer=$!
   trap 'kill "$fuzzer" 2>/dev/null || true' EXIT
   started=$SECONDS
   while kill -0 "$fuzzer" 2>/dev/null; do
      sleep 1
      if [ $(((SECONDS - started) % 10)) -eq 0 ]; then
         echo "$target: $((SECONDS - started)) of $seconds s, $(progress "$log")"
      fi
   done
   code=0
   wait "$fuzzer" || code=$?
   trap - EXIT
   executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log" | tail -n 1)
   if [ "$code" -eq 0 ]; then
      [ "${executions:-0}" -gt 0 ] || end 4 "$target ran nothing; see $log"
      summary+=("$target $executions")
   else
      found=1
      input=$(sed -n "s/.*Test unit written to //p" "$log" | tail -n 1)
      summary+=("$target FOUND ${input:-something}")
      echo "$target: exit code $code, input ${input:-not written}; see $log. Keep it in hls_tb/fuzz/corpus/$target once it is mended." >&2
   fi
done
(IFS=,; echo "$([ $found -eq 0 ] && echo PASS || echo FAIL): executions in $seconds s each:${summary[*]/#/ }")
exit $found
