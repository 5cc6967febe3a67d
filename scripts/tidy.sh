#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Checks the C++ with clang-tidy and the file .clang-tidy: the program, models, vectors, fuzz targets, benchmark and, through
# them and stereo_top.cpp, the core's headers. The cores of all configurations are left out: they take hours; the Python
# module as well, which this build does not make.
#   scripts/tidy.sh [FILE...]
#   FILE  only these sources (default: all of the above)
# Exit codes: 0 nothing found, 1 findings, 2 bad options, 3 missing tool, 4 the build folder cannot be configured.
set -euo pipefail
cd "$(dirname "$0")/.."

end() {
   echo "tidy.sh: $2" >&2
   exit "$1"
}

case "${1:-}" in
   --help | -h)
      sed -n '3,8s/^# //p' "$0"
      exit 0
      ;;
   -*) end 2 "unknown option '$1' (see tidy.sh --help)" ;;
esac
for file in "$@"; do
   [ -f "$file" ] || end 2 "$file: there is no such file"
done

tidy=${CLANG_TIDY:-clang-tidy-16}
command -v "$tidy" >/dev/null || end 3 "SKIP: $tidy is not installed; on Debian: apt-get install clang-tidy-16, or name another in CLANG_TIDY"
work=build/tidy
mkdir -p "$work" 2>/dev/null || end 4 "the folder $work cannot be created"
cmake -B "$work" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DCMAKE_CXX_COMPILER_LAUNCHER= -Wno-dev \
   >"$work/configure.log" 2>&1 || end 4 "cmake failed; see $work/configure.log"

sources=("$@")
if [ $# -eq 0 ]; then
   mapfile -t sources < <(find hls_tb hls/top -name '*.cpp' |
      grep -v -e '_test\.cpp$' -e '/testing/' -e '/cosim/verilator' -e '/shell/' -e '/python/' -e '_rejected' -e 'libfuzzer_entry' | sort)
fi
echo "${#sources[@]} files"
# Each file's findings in one piece, whatever runs beside it.
check() {
   local said code=0
   said=$("$1" -p "$2" --quiet "$3" 2>"$2/errors.$$") || code=$?
   if [ $code -ne 0 ]; then
      [ -n "$said" ] || said=$(cat "$2/errors.$$")
      printf '%s: findings\n%s\n' "$3" "$said"
   else
      echo "$3: clean"
   fi
   rm -f "$2/errors.$$"
   return $code
}
export -f check
code=0
printf '%s\0' "${sources[@]}" | xargs -0 -P "${STEREO_JOBS:-$(nproc)}" -I{} bash -c 'check "$@"' _ "$tidy" "$work" {} || code=$?
[ $code -eq 0 ] || end 1 "there are findings, above"
echo "PASS: ${#sources[@]} files, nothing found"
