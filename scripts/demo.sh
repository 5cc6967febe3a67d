#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# From a stereo pair to a checked hardware design: disparity map, co-simulation of the VHDL in GHDL (some rows) and in
# Verilator (two whole frames), and one HTML page with the results.
#   scripts/demo.sh [--left L --right R] [--config NAME] [--seed N] [--out DIR]
#   --left, --right  a rectified pair; of larger images the centre is taken. Without: a generated scene
#   --config         configuration (default ambrosch2007)
#   --seed           of the scene and of filler pixels (default 1)
#   --out            folder for the results (default build/demo)
# With STEREO_HLS in the environment, that program is taken as it is, and nothing is built.
# Exit codes: 0 done, 2 bad options or input, else that of the step that failed.
set -euo pipefail
program=${0##*/}
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

refuse() {
   echo "$program: $1" >&2
   exit 2
}

left="" right="" config=ambrosch2007 seed=1 out=$root/build/demo
while [ $# -gt 0 ]; do
   case "$1" in
      --left | --right | --config | --seed | --out)
         [ -n "${2:-}" ] || refuse "$1 needs a value (see $program --help)"
         declare "${1#--}=$2"
         shift 2
         ;;
      --help | -h)
         sed -n '3,11s/^# //p' "${BASH_SOURCE[0]}"
         exit 0
         ;;
      *) refuse "unknown option '$1' (see $program --help)" ;;
   esac
done
[[ $seed =~ ^[0-9]{1,18}$ ]] || refuse "--seed $seed: must be a whole number, 0 or above"
[ -z "$left$right" ] || { [ -n "$left" ] && [ -n "$right" ]; } || refuse "--left and --right go together"
for image in "$left" "$right"; do
   [ -z "$image" ] || [ -f "$image" ] || refuse "$image: there is no such file"
done

# Names within the project become relative to it, so that the page reads alike on every machine.
name_of() { realpath -m --relative-base="$root" -- "$1"; }
out=$(name_of "$out")
[ -z "$left" ] || left=$(name_of "$left") right=$(name_of "$right")
cd "$root"
mkdir -p -- "$out" 2>/dev/null || refuse "--out $out: the folder cannot be created"
[ ! -e "$out/report.html" ] || [ -e "$out/match/match.json" ] ||
   refuse "$out/report.html is no result of an earlier run, and would be replaced; name another folder"
rm -f -- "$out/report.html"
export STEREO_PRESET=${STEREO_PRESET:-release}

# The failing step has said why on stderr; its exit code is ours.
step() {
   echo
   echo "== $1"
   shift
   "$@" || {
      local code=$?
      [ $code -eq 2 ] || echo "$program: stopped with exit code $code of: $*" >&2
      exit $code
   }
}

if [ -n "${STEREO_HLS:-}" ]; then
   step "Tools" ./scripts/setup.sh --packages-only
else
   step "Tools, native program, core" ./scripts/setup.sh --core "$config"
   export STEREO_HLS=build/$STEREO_PRESET/stereo_hls
fi
truth=() fit=()
if [ -z "$left" ]; then
   scene=$out/scene left=$out/scene/left.png right=$out/scene/right.png
   step "Scene $seed for $config" "$STEREO_HLS" scene --config "$config" --seed "$seed" --out "$scene"
   truth=(--truth "$scene/disparity_right.png" --visible "$scene/visible_right.png")
else
   echo
   echo "The given pair is used; if it is larger than the configuration takes, the centre is cut out (--fit crop)."
   fit=(--fit crop)
fi
pair=(--config "$config" --left "$left" --right "$right" "${fit[@]}")
step "Disparity map" "$STEREO_HLS" match "${pair[@]}" "${truth[@]}" --out "$out/match"
step "Co-simulation in GHDL, some rows" ./scripts/cosim.py "${pair[@]}" --seed "$seed" --rows 8 --out "$out/cosim-ghdl"
step "Co-simulation in Verilator, two frames" ./scripts/cosim.py "${pair[@]}" --seed "$seed" --frames 2 \
   --simulator verilator --out "$out/cosim-verilator"
# The packages that setup.sh installs are for Debian's Python; another one of the path, as of a virtual environment, may have
# them, too.
python=python3
"$python" -c "import jinja2, matplotlib" 2>/dev/null || python=/usr/bin/python3
step "Report" "$python" scripts/report.py --demo "$out"
