#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# run.sh [-f filter] [build folder [cmake argument...]]: builds and runs the benchmarks on the Fandisk
# model that Debian ships with CGAL, and prints tables. The machine should have nothing else to do.
#
# A filter is a regular expression: -f '^Method/' runs all methods and leaves the comparison with
# other programs out, -f '^Method/Guided' runs one of them. Memory is measured without a filter only.

set -eu -o pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source Testing/packages.sh
filter=
if [ "${1:-}" = -f ]; then
  filter=$2
  shift 2
fi
build=${1:-build-benchmarks}
[ $# -gt 0 ] && shift

install_packages "${build_packages[@]}" "${paraview_packages[@]}" libbenchmark-dev libcgal-demo

mkdir -p "$build"
if [ ! -e "$build/fandisk.off" ]; then
  tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -O data/meshes/fandisk.off >"$build/fandisk.off"
fi
export SURFACE_DENOISING_BENCHMARK_MESH="$build/fandisk.off"

cmake -G Ninja -S . -B "$build" -DSurfaceDenoising_BUILD_BENCHMARKS=ON \
  -DSurfaceDenoising_WRAP_PYTHON=OFF "$@" >"$build/run.log"
cmake --build "$build" >>"$build/run.log"

programs="$build/Testing/Benchmarks"
"$programs/SurfaceDenoisingBenchmarks" --benchmark_filter="${filter:-.}" \
  --benchmark_out="$build/times.json" --benchmark_out_format=json
for method in "Bilateral Normal" "Guided Normal"; do
  for cuts in 3 9 18; do
    [ -n "$filter" ] || "$programs/SurfaceDenoisingPeakMemory" $cuts "$method"
  done
done >"$build/memory.txt"
python3 Testing/Benchmarks/table.py "$build/times.json" "$build/memory.txt"
