#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Denoises a surface with the ParaView plugin, on a bare Debian 12 (as root or with sudo):
#
#   bash Examples/demo.sh                                  a real model that gets noise
#   bash Examples/demo.sh scan.ply --method robust -n 30   your own: PLY OBJ STL OFF VTP VTK
#
# Options are those of Examples/Python/demo.py; --help lists them. What is missing is installed, and
# the plugin is built once, in build-paraview. Results go to $OUT, by default ./out.

set -u -o pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd) || exit 1
# shellcheck source=Testing/packages.sh
source "$root/Testing/packages.sh"

out=${OUT:-out}
build=$root/build-paraview

fail() {
  echo "demo: $*" >&2
  exit 1
}

# fetch_model <name>: a model from Debian's collection of CGAL data, into the output folder. Nothing
# but the data is wanted, so that the package is unpacked rather than installed.
fetch_model() {
  local archive=usr/share/doc/libcgal-dev/data.tar.gz folder=/
  if [ ! -e "/$archive" ]; then
    echo "-- fetching libcgal-demo"
    folder=$(mktemp -d) || return 1
    (cd "$folder" && as_root apt-get update -qq &&
      apt-get download -qq -o APT::Sandbox::User=root libcgal-demo && dpkg -x ./*.deb .) || return 1
  fi
  tar -xzf "$folder/$archive" -O "data/meshes/$1" >"$out/$1" || return 1
  [ "$folder" = / ] || rm -r "$folder"
}

build_plugin() {
  local log=$build/demo.log
  mkdir -p "$build"
  echo "-- building the plugin in $build (a few minutes the first time)"
  if [ ! -e "$build/CMakeCache.txt" ]; then
    cmake -G Ninja -S "$root" -B "$build" -DPython3_EXECUTABLE=/usr/bin/python3 >"$log" 2>&1 ||
      { tail -n 30 "$log" && return 1; }
  fi
  cmake --build "$build" >"$log" 2>&1 || { tail -n 30 "$log" && return 1; }
}

surface=
if [ $# -gt 0 ] && [ "${1#-}" = "$1" ]; then
  surface=$1
  shift
  [ -f "$surface" ] || fail "there is no file $surface"
fi
mkdir -p "$out" || fail "cannot write to $out"

install_packages "${build_packages[@]}" "${paraview_packages[@]}" "${test_packages[@]}" ||
  fail "cannot install what is needed"
build_plugin || fail "cannot build the plugin; see $build/demo.log"

if [ -n "$surface" ]; then
  arguments=("$surface")
else
  fetch_model fandisk.off || fail "cannot get the model"
  # Noise in all directions distorts triangles, which Integral Fit evens out again.
  arguments=(--truth "$out/fandisk.off" --vertex-scheme "Integral Fit" --vertex-iterations 20
    --view 1 -1.6 -0.9 --up 0 0 -1)
fi

echo "-- denoising ${surface:-$out/fandisk.off}"
plugins=$(find "$build" -name surface-denoising.xml -print -quit)
# Without -noreset, the display may restart while ParaView opens its second window on it.
PV_PLUGIN_CONFIG_FILE=$plugins PYTHONDONTWRITEBYTECODE=1 \
  xvfb-run -a -s "-screen 0 1600x1200x24 -noreset" \
  pvpython "$root/Examples/Python/demo.py" --output "$out" "${arguments[@]}" "$@" || exit 1
