# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash disable=SC2034
#
# To be sourced by the scripts beside it: from a bare Debian 12 to a Python script that runs with
# the plugin. What is missing is installed, and the plugin is built once, in build-paraview. Results
# go to $OUT, by default ./out.

set -u -o pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd) || exit 1
# shellcheck source=Testing/packages.sh
source "$root/Testing/packages.sh"

out=${OUT:-out}
build=$root/build-paraview
program=$(basename "$0" .sh)
model=${MODEL:-fandisk} # one of the meshes of CGAL
truth=$out/$model.off
view=()
[ "$model" != fandisk ] || view=(--view 1 -1.6 -0.9 --up 0 0 -1) # shows the steps and the groove

fail() {
  echo "$program: $*" >&2
  exit 1
}

# fetch_model: $model, from Debian's collection of CGAL data, into the output folder. Nothing but the
# data is wanted, so that the package is unpacked rather than installed.
fetch_model() {
  local archive=usr/share/doc/libcgal-dev/data.tar.gz folder=/
  if [ ! -e "/$archive" ]; then
    echo "-- fetching libcgal-demo"
    folder=$(mktemp -d) || return 1
    (cd "$folder" && as_root apt-get update -qq &&
      apt-get download -qq -o APT::Sandbox::User=root libcgal-demo && dpkg -x ./*.deb .) || return 1
  fi
  tar -xzf "$folder/$archive" -O "data/meshes/$model.off" >"$truth" || return 1
  [ "$folder" = / ] || rm -r "$folder"
}

build_plugin() {
  local log=$build/$program.log
  mkdir -p "$build"
  echo "-- building the plugin in $build (a few minutes the first time)"
  if [ ! -e "$build/CMakeCache.txt" ]; then
    cmake -G Ninja -S "$root" -B "$build" -DPython3_EXECUTABLE=/usr/bin/python3 >"$log" 2>&1 ||
      { tail -n 30 "$log" && return 1; }
  fi
  cmake --build "$build" >"$log" 2>&1 || { tail -n 30 "$log" && return 1; }
}

# prepare: all that run_script needs, and the folder for the results.
prepare() {
  mkdir -p "$out" || fail "cannot write to $out"
  install_packages "${build_packages[@]}" "${paraview_packages[@]}" "${test_packages[@]}" ||
    fail "cannot install what is needed"
  build_plugin || fail "cannot build the plugin; see $build/$program.log"
}

# run_script <name> <argument>...: a script of Examples/Python in pvpython, with the plugin.
run_script() {
  local plugins script=$root/Examples/Python/$1
  shift
  # Tests install a copy of the plugin below Testing, which may be of yesterday.
  plugins=$(find "$build" -name surface-denoising.xml -not -path "*/Testing/*" -print -quit)
  # Without -noreset, the display may restart while ParaView opens its second window on it.
  PV_PLUGIN_CONFIG_FILE=$plugins PYTHONDONTWRITEBYTECODE=1 \
    xvfb-run -a -s "-screen 0 1600x1200x24 -noreset" \
    pvpython "$script" --output "$out" "$@"
}
