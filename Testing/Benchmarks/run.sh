#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# run.sh [-o meshes|points] [-f filter] [-a model [-c cuts]] [build folder [cmake argument...]]: builds
# and runs the benchmarks on the Fandisk model that Debian ships with CGAL, and prints tables. The
# machine should have nothing else to do.
#
# -a compares automatic denoising with the best of a sweep on an OFF file and runs nothing else: minutes
# for each ten thousand triangles. -o points does so with the points of the model, of which -c 3 makes
# nine times as many, on the same surface: a dense scan.
#
# -o runs those of meshes or of points only. A filter is a regular expression: -f '^Method/' runs all
# methods for meshes and leaves the comparison with other programs out, -f '^Method/Guided' runs one of
# them, -f '^Points/' runs those of points. Memory is measured without a filter only.

set -eu -o pipefail

fail() {
  echo "Benchmarks: $*" >&2
  exit 1
}

filter=
only=
model=
cuts=1
while getopts a:c:f:o: option; do
  case $option in
    c) cuts=$OPTARG ;;
    f) filter=$OPTARG ;;
    o) only=$OPTARG ;;
    a) model=$(realpath -e "$OPTARG") || exit 1 ;;
    *) exit 1 ;;
  esac
done
case $only in
  '' | meshes | points) ;;
  *) fail "there are benchmarks of meshes and of points, none of $only" ;;
esac
shift $((OPTIND - 1))
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source Testing/packages.sh
build=${1:-build-benchmarks}
[ $# -gt 0 ] && shift

install_packages "${build_packages[@]}" "${paraview_packages[@]}" "${benchmark_packages[@]}" ||
  fail "cannot install what is needed"

mkdir -p "$build"
export SURFACE_DENOISING_BENCHMARK_MESH="$build/fandisk.off"
if [ ! -s "$SURFACE_DENOISING_BENCHMARK_MESH" ]; then
  { fetch_cgal_data "$unpacked/cgal" && extract_model fandisk "$SURFACE_DENOISING_BENCHMARK_MESH"; } ||
    fail "cannot get the model"
fi

if ! { cmake -G Ninja -S . -B "$build" -DSurfaceDenoising_BUILD_BENCHMARKS=ON \
  -DSurfaceDenoising_WRAP_PYTHON=OFF "$@" && cmake --build "$build"; } >"$build/run.log" 2>&1; then
  tail -n 30 "$build/run.log"
  fail "cannot build; see $build/run.log"
fi
grep -e '-- Benchmarks:' "$build/run.log" || true

programs="$build/Testing/Benchmarks"

if [ -n "$model" ] && [ "$only" = points ]; then
  exec "$programs/SurfaceDenoisingAutomaticPointBenchmark" "$model" "$cuts"
elif [ -n "$model" ]; then
  exec "$programs/SurfaceDenoisingAutomaticBenchmark" "$model"
fi

measured=

# measure <program> <file> <argument>...: runs what the filter lets through. Returns false if there is
# nothing. A failure ends it all, which set -e would not do in a condition.
measure() {
  "$programs/$1" --benchmark_filter="${filter:-.}" \
    --benchmark_out="$build/$2" --benchmark_out_format=json "${@:3}" || fail "$1 failed"
  [ -s "$build/$2" ] && measured=yes
}

peak_memory() {
  [ -n "$filter" ] || "$programs/SurfaceDenoisingPeakMemory" "$@"
}

if [ "$only" != points ] && measure SurfaceDenoisingBenchmarks times.json; then
  for method in "Bilateral Normal" "Guided Normal"; do
    for cuts in 3 9 18; do
      peak_memory $cuts "$method"
    done
  done >"$build/memory.txt"
  python3 Testing/Benchmarks/table.py "$build/times.json" "$build/memory.txt"
fi

if [ "$only" != meshes ] && measure SurfaceDenoisingPointBenchmarks point-times.json \
  --benchmark_enable_random_interleaving=true; then
  "$programs/SurfaceDenoisingPeakMemory" names | while read -r method; do
    peak_memory 1000000 "$method"
  done >"$build/point-memory.txt"
  python3 Testing/Benchmarks/point_table.py "$build/point-times.json" "$build/point-memory.txt"
fi

[ -n "$measured" ] || fail "the filter $filter lets nothing through"
