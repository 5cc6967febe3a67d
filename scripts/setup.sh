#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the Debian packages that are missing, then builds the native program and its tests. Does nothing that is done
# already.
#   scripts/setup.sh [--packages-only | --core CONFIG]
#   --core  builds only the program and the clocked core of one configuration
set -euo pipefail
cd "$(dirname "$0")/.."

packages=(
   g++ cmake ninja-build ccache                              # native build
   make                                                      # what Verilator writes is built by it
   libopencv-dev libgtest-dev libcli11-dev nlohmann-json3-dev
   ghdl-mcode verilator yosys                                # co-simulation and proofs
   iverilog                                                  # a simulator of four values, for a test
   python3 python3-venv python3-rich python3-jinja2                # the flow
   python3-matplotlib                                        # pictures of report.py, cosim.py and explore.py
   python3-dev python3-numpy                                 # the Python module
   python3-pytest python3-hypothesis chromium                # its tests; pages as a browser shows them
   gcc tcl                                                   # driver and scripts of the kits
)

case "${1:-}" in
   "" | --packages-only) ;;
   --core) [ -n "${2:-}" ] || { echo "setup.sh: --core needs a value (see setup.sh --help)" >&2; exit 2; } ;;
   --help | -h)
      sed -n '3,6s/^# //p' "$0"
      exit 0
      ;;
   *)
      echo "setup.sh: unknown option '$1' (see setup.sh --help)" >&2
      exit 2
      ;;
esac

missing=()
for package in "${packages[@]}"; do
   status=$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null || true)
   [ "$status" = "install ok installed" ] || missing+=("$package")
done

if [ "${#missing[@]}" -gt 0 ]; then
   if ! command -v apt-get >/dev/null; then
      echo "setup.sh: this system has no apt-get; install the equivalents of: ${missing[*]}" >&2
      exit 3
   fi
   as_root=()
   if [ "$(id -u)" -ne 0 ]; then
      command -v sudo >/dev/null || {
         echo "setup.sh: installing ${missing[*]} needs root; run as root or install sudo" >&2
         exit 3
      }
      as_root=(sudo)
   fi
   echo "Installing: ${missing[*]}"
   "${as_root[@]}" apt-get update -qq
   "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
fi

[ "${1:-}" = --packages-only ] && exit 0
preset=${STEREO_PRESET:-release}
if [ "${1:-}" = --core ]; then
   program=build/$preset/stereo_hls
   [ -f "build/$preset/build.ninja" ] || cmake --preset "$preset" -Wno-dev
   cmake --build --preset "$preset" --target stereo_hls
   "$program" configurations | grep "^$2:" >/dev/null || {
      echo "setup.sh: unknown configuration '$2' (see $program configurations)" >&2
      exit 2
   }
   cmake --build --preset "$preset" --target "core_$2"
else
   cmake --preset "$preset" -Wno-dev
   cmake --build --preset "$preset"
fi
