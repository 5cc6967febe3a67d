#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs commands of the project in a fresh, minimal Debian: what it needs beyond its own list of packages shows. The committed
# HEAD is taken, in the folder /home/trial/stereo_hls of a chroot. Needs root and debootstrap.
#   scripts/try_distribution.sh [OPTION...] SUITE [COMMAND...]
#   SUITE      bookworm (Debian 12), trixie (Debian 13) or another that debootstrap knows
#   COMMAND    one word each, such as "scripts/test.sh -L unit" (default: scripts/demo.sh scripts/test.sh)
#   --user     runs them as a user who has sudo, instead of as root
#   --built DIR  gives the commands the program and the cores of a build of HEAD in the same distribution; the demo then builds nothing
#   --keep     keeps the system in build/distributions/SUITE (default: it is removed)
#   --out DIR  folder for the systems, and for SUITE.log with what the commands printed (default build/distributions)
# MIRROR in the environment is where Debian's packages come from. A base system is made once and kept as SUITE.tar.
# Exit codes: 0 all passed, 2 bad options, 3 not root or a tool is missing, 4 the system cannot be made, else that of the first
# command that failed.
set -euo pipefail
program=${0##*/}

end() {
   echo "$program: $2" >&2
   exit "$1"
}

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
as_user=no keep=no built="" out=$root/build/distributions given=("$@")
while [ $# -gt 0 ]; do
   case "$1" in
      --user) as_user=yes ;;
      --keep) keep=yes ;;
      --out | --built)
         [ -n "${2:-}" ] || end 2 "$1 needs a value (see $program --help)"
         declare "${1#--}=$(realpath -m -- "$2")"
         shift
         ;;
      --help | -h)
         sed -n '3,15s/^# //p' "${BASH_SOURCE[0]}"
         exit 0
         ;;
      -*) end 2 "unknown option '$1' (see $program --help)" ;;
      *) break ;;
   esac
   shift
done
suite=${1:-}
[[ $suite =~ ^[a-z]+$ ]] || end 2 "which distribution? For example: $program trixie (see $program --help)"
shift
[ $# -gt 0 ] || set -- scripts/demo.sh scripts/test.sh
for part in stereo_hls stereo_hls_images.so stereo_hls_video.so cores; do
   [ -z "$built" ] || [ -e "$built/$part" ] || end 2 "--built $built: there is no $part"
done
[ "$(id -u)" -eq 0 ] || end 3 "SKIP: a chroot needs root"
for tool in debootstrap unshare git; do
   command -v "$tool" >/dev/null || end 3 "SKIP: $tool is not installed; on Debian: apt-get install debootstrap util-linux git"
done

# Everything below happens where mounts and processes end with this script, on whatever way out.
if [ -z "${STEREO_TRIAL:-}" ]; then
   alone=(unshare --mount --propagation private --pid --fork --kill-child --mount-proc)
   "${alone[@]}" true 2>/dev/null || end 3 "SKIP: this system does not let its root mount anything"
   mkdir -p -- "$out" 2>/dev/null || end 4 "--out $out: the folder cannot be created"
   exec 9>"$out/$suite.lock"
   flock -n 9 || end 4 "another trial of $suite runs in $out"
   [ ! -e "$out/$suite" ] || rm -rf --one-file-system -- "${out:?}/$suite"
   # unshare itself waits whatever comes, and the first process of its own world ignores signals.
   STEREO_TRIAL=yes "${alone[@]}" "${BASH_SOURCE[0]}" "${given[@]}" &
   trial=$!
   leave() {
      kill -KILL $trial 2>/dev/null || true
      wait $trial 2>/dev/null || true
      [ $keep = yes ] || rm -rf --one-file-system -- "${out:?}/$suite"
   }
   trap leave EXIT
   trap 'exit 130' INT
   trap 'exit 143' TERM HUP
   code=0
   wait $trial || code=$?
   exit $code
fi

system=$out/$suite home=/home/trial log=$out/$suite.log
if [ ! -f "$out/$suite.tar" ]; then
   echo "Making a minimal $suite ..."
   debootstrap --variant=minbase "$suite" "$system" ${MIRROR:+"$MIRROR"} >"$log" 2>&1 ||
      end 4 "debootstrap cannot make $suite: $(tail -n 1 "$log"); see $log"
   tar -C "$system" --one-file-system -cf "$out/$suite.tar.new" .
   mv "$out/$suite.tar.new" "$out/$suite.tar"
else
   mkdir "$system"
   tar -C "$system" -xf "$out/$suite.tar"
fi
mount --rbind /dev "$system/dev"
mount -t proc proc "$system/proc"

# What the network of this machine asks for: names, proxies, certificates. No package of it.
environment=(HOME="$home" TERM=dumb LANG=C.UTF-8 PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin CI="${CI:-}")
for name in http_proxy https_proxy no_proxy PIP_INDEX_URL PIP_EXTRA_INDEX_URL PIP_DEFAULT_TIMEOUT; do
   [ -z "${!name:-}" ] || environment+=("$name=${!name}")
done
for name in SSL_CERT_FILE PIP_CERT REQUESTS_CA_BUNDLE CURL_CA_BUNDLE; do
   if [ -f "${!name:-}" ]; then
      cp -L -- "${!name}" "$system/etc/of_the_host_$name"
      environment+=("$name=/etc/of_the_host_$name")
   fi
done
for name in resolv.conf hosts; do cp -L "/etc/$name" "$system/etc/$name"; done
[ ! -f /etc/pip.conf ] || cp -L /etc/pip.conf "$system/etc/pip.conf"
apt-config dump Acquire >"$system/etc/apt/apt.conf.d/99of_the_host"
echo force-unsafe-io >"$system/etc/dpkg/dpkg.cfg.d/force-unsafe-io" # a trial need not survive a power cut
printf '#!/bin/sh\nexit 101\n' >"$system/usr/sbin/policy-rc.d" # and starts no services
chmod +x "$system/usr/sbin/policy-rc.d"

inside=(chroot "$system" env -i "${environment[@]}")
who=()
if [ $as_user = yes ]; then
   chroot "$system" useradd --create-home --shell /bin/bash trial
   "${inside[@]}" sh -c 'apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends sudo' \
      >"$log" 2>&1 || end 4 "sudo cannot be installed in $suite; see $log"
   echo "trial ALL=(ALL) NOPASSWD: ALL" >"$system/etc/sudoers.d/trial"
   printf 'Defaults env_keep += "%s"\n' "${environment[*]%%=*}" >>"$system/etc/sudoers.d/trial"
   who=(setpriv --reuid trial --regid trial --init-groups)
fi
mkdir -p "$system$home"
git -c safe.directory="$root" clone -q --no-hardlinks "file://$root" "$system$home/stereo_hls" || end 4 "the checkout $root cannot be cloned"
commit=$(git -c safe.directory='*' -C "$system$home/stereo_hls" rev-parse --short HEAD)
if [ -n "$built" ]; then
   mkdir "$system$home/built"
   cp -r -- "$built"/stereo_hls "$built"/*.so "$built/cores" "$system$home/built" || end 4 "the build $built cannot be copied"
   inside+=(STEREO_HLS="$home/built/stereo_hls")
fi
[ $as_user = no ] || chroot "$system" chown -R trial:trial "$home"

: >"$log"
code=0 results=()
for command in "$@"; do
   echo "== $suite: $command"
   started=$SECONDS of_this=0
   "${inside[@]}" "${who[@]}" bash -c "cd $home/stereo_hls && $command" </dev/null 2>&1 | tee -a "$log" || of_this=${PIPESTATUS[0]}
   result="passed"
   [ "$of_this" -eq 0 ] || result="exit code $of_this"
   [ "$code" -ne 0 ] || code=$of_this
   results+=("$command: $result, $(((SECONDS - started + 59) / 60)) min")
done

# A version without Debian's own additions to it.
version() {
   local text
   text=$(chroot "$system" dpkg-query -W -f '${Version}' "$1" 2>/dev/null) || true
   text=${text#*:} text=${text%-*} text=${text%%+*}
   echo "${text:--}"
}
echo
echo "Debian $(cat "$system/etc/debian_version") ($suite), $([ $as_user = yes ] && echo "a user with sudo" || echo root), commit $commit"
echo "GHDL $(version ghdl-mcode), Verilator $(version verilator), yosys $(version yosys), g++ $(version g++), OpenCV $(version libopencv-dev)," \
   "Python $(version python3), CMake $(version cmake)"
printf '%s\n' "${results[@]}"
exit "$code"
