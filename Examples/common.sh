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

# show_help <script> <argument>...: ends with the help, if it is asked for. The start of the program
# says how it is called, and Python, without ParaView, what the options are.
show_help() {
  local argument
  for argument in "${@:2}"; do
    [ "$argument" = -h ] || [ "$argument" = --help ] || continue
    sed -n '5,/^$/s/^# \{0,1\}//p' "$0"
    command -v python3 >/dev/null || fail "python3 is not installed, which lists the options"
    PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$root/Examples/Python \
      python3 "$root/Examples/${1}_options.py" --help
    exit
  done
}

# take_files <most> <argument>...: arguments before the first option are files, the rest is options.
take_files() {
  local most=$1 before='' option
  shift
  files=()
  while [ $# -gt 0 ] && [ ${#files[@]} -lt "$most" ] && [ "${1#-}" = "$1" ]; do
    [ -f "$1" ] || fail "there is no file $1"
    files+=("$1")
    shift
  done
  options=("$@")
  [ ${#files[@]} -eq 0 ] || return 0
  for option in "$@"; do
    [ ! -f "$option" ] || [ "$before" = --truth ] || fail "files come before options: $option"
    before=$option
  done
}

# has_option <name>: is it there?
has_option() {
  local option
  for option in "${options[@]}"; do
    [ "${option%%=*}" != "$1" ] || return 0
  done
  return 1
}

# fetch_model: $model, from Debian's collection of CGAL data, into the output folder.
fetch_model() {
  { fetch_cgal_data "$unpacked/cgal" && extract_model "$model" "$truth"; } ||
    fail "cannot get the model $model"
}

build_plugin() {
  local log=$build/$program.log
  mkdir -p "$build" || return 1
  echo "-- building the plugin in $build (a few minutes the first time)"
  # What a configuration that failed has found must not be there for the next one.
  [ -e "$build/build.ninja" ] || [ -e "$build/Makefile" ] ||
    rm -rf "$build/CMakeCache.txt" "$build/CMakeFiles"
  # The generator counts where nothing is configured yet.
  { CMAKE_GENERATOR=Ninja cmake -S "$root" -B "$build" -DPython3_EXECUTABLE=/usr/bin/python3 &&
    cmake --build "$build"; } >"$log" 2>&1 || { tail -n 30 "$log" && return 1; }
}

# prepare: all that run_script needs, and the folder for the results.
prepare() {
  mkdir -p "$out" || fail "cannot write to $out"
  install_packages "${build_packages[@]}" "${paraview_packages[@]}" "${test_packages[@]}" ||
    fail "cannot install what is needed"
  build_plugin || fail "cannot build the plugin; see $build/$program.log"
}

# run_script <script> <argument>...: a script below Examples, without its ending, in pvpython, with the plugin.
run_script() {
  local plugins script=$root/Examples/$1.py
  shift
  # Tests install a copy of the plugin below Testing, which may be of yesterday.
  plugins=$(cd "$build" && find . -path ./Testing -prune -o -name surface-denoising.xml -print -quit)
  [ -n "$plugins" ] || fail "there is no plugin in $build"
  # Without -noreset, the display may restart while ParaView opens its second window on it.
  PV_PLUGIN_CONFIG_FILE=$build/$plugins PYTHONDONTWRITEBYTECODE=1 \
    xvfb-run -a -s "-screen 0 1600x1200x24 -noreset" \
    pvpython "$script" --output "$out" "$@"
}
