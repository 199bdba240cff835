#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Everything that must hold before a change goes in, on a bare Debian 12 (as root or with sudo):
#
#   build-paraview  ParaView 5.11 with plugin and Python   all tests
#   build-vtk       plain VTK 9.1 with Python              all tests but those of the plugin
#   build-asan      plain VTK 9.1, address and undefined   tests in C++ but those of quality
#
# Ends with zero only if all builds and tests went well. Arguments go to ctest: -R Demo runs the tests
# of this name. Tests that compare with other programs' results are skipped unless
# SURFACE_DENOISING_DATA names a folder with these.

set -u -o pipefail
if [ "${1-}" = -h ] || [ "${1-}" = --help ]; then
  sed -n '5,/^$/s/^# \{0,1\}//p' "$0"
  exit
fi
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1
source Testing/packages.sh

install_packages "${build_packages[@]}" "${paraview_packages[@]}" "${vtk_packages[@]}" \
  "${test_packages[@]}" || exit 1
fetch_plain_vtk "$unpacked/vtk-9.1" || exit 1

export CMAKE_GENERATOR=Ninja
if command -v ccache >/dev/null; then
  export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
  # What was compiled in another clone serves here too.
  export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=true
fi
common=(-DPython3_EXECUTABLE=/usr/bin/python3)
plain=("${common[@]}" -DSurfaceDenoising_WITH_PARAVIEW=OFF "-DCMAKE_PREFIX_PATH=$plain_vtk")
sanitized=("${plain[@]}" -DSurfaceDenoising_WRAP_PYTHON=OFF
  "-DSurfaceDenoising_SANITIZE=address,undefined"
  # Optimized, or it takes too long, but with assertions.
  -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O1)

failures=()

# build <folder> <cmake argument>...: quiet unless it fails or the compiler has something to say.
build() {
  local folder=$1 log=$1/run.log
  shift
  mkdir -p "$folder"
  echo "-- building $folder"
  if ! { cmake -S . -B "$folder" "$@" && cmake --build "$folder"; } >"$log" 2>&1; then
    tail -n 60 "$log"
    failures+=("$folder (build)")
    return 1
  fi
  grep -A 3 'warning:' "$log" || true
}

run_tests() {
  echo "-- testing $1"
  ctest --test-dir "$@" --output-on-failure --no-tests=error --parallel "$(nproc)" ||
    failures+=("$1 (tests)")
}

built=()
build build-paraview "${common[@]}" && built+=(build-paraview)
build build-vtk "${plain[@]}" && built+=(build-vtk)
build build-asan "${sanitized[@]}" && built+=(build-asan)
for folder in "${built[@]}"; do
  case $folder in
    build-asan) run_tests "$folder" --label-exclude quality "$@" ;;
    *) run_tests "$folder" "$@" ;;
  esac
done

if [ ${#failures[@]} -gt 0 ]; then
  printf 'FAILED: %s\n' "${failures[@]}" >&2
  exit 1
fi
