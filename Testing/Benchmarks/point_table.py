#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints what the benchmarks of point methods found beside what they should find.

point_table.py <times.json of SurfaceDenoisingPointBenchmarks>
               <output lines of SurfaceDenoisingPeakMemory>

What did not run is left out. What failed is named at the end, and the exit code is 1.
"""

import json
import sys

from table import fastest, least, print_figures, tell_failures

MILLION = 1000000
SIZES = (100000, MILLION, 4000000)
REFERENCE = "CGAL Bilateral"
# Times the speed of the reference that is wanted.
LEAST = {"Bilateral Point": 3.0, "Robust Point Normal, one step": 3.0}
MOST_BYTES = 600.0
FLAT = 1.3


class Runs:
    """The runs by method, number of points, threads and whether normals are given."""

    def __init__(self, results):
        self.times = fastest(results)
        self.processor = least(results, "processor_s")

    @staticmethod
    def name(method, points, threads, normals=1):
        return f"Points/{method}/points:{points}/threads:{threads}/normals:{normals}"

    def seconds(self, *key):
        name = self.name(*key)
        return self.times[name]["real_time"] / 1e3 if name in self.times else None

    def processor_seconds(self, *key):
        return self.processor.get(self.name(*key))

    def values(self, position):
        """What the names have at a position, in their order."""
        return list(dict.fromkeys(name.split("/")[position].split(":")[-1] for name in self.times))


def print_methods(runs, threads):
    reference = runs.seconds(REFERENCE, MILLION, threads)
    processor_reference = runs.processor_seconds(REFERENCE, MILLION, threads)
    print(f"\n{'method, ' + str(threads) + ' thread' + 's' * (threads > 1):26} {'normals':>8} "
          f"{'ns/point':>9} {'of CPU':>7} {'setup':>7} {'filter':>7} {'speed':>6} {'of CPU':>7}  wanted")
    for method in runs.values(1):
        for normals in (1, 0):
            seconds = runs.seconds(method, MILLION, threads, normals)
            if seconds is None:
                continue
            run = runs.times[runs.name(method, MILLION, threads, normals)]
            processor = runs.processor_seconds(method, MILLION, threads, normals)
            stages = [f"{run[stage] * 1e9 / MILLION:7.0f}" if stage in run else " " * 7
                      for stage in ("setup_s", "filter_s")]
            speeds = " " * 14
            wanted = ""
            if reference:
                speed = reference / seconds
                speeds = f"{speed:6.2f} {processor_reference / processor:7.2f}"
                if method in LEAST and normals:
                    wanted = f"{LEAST[method]:g} or more"
                    wanted += ", MISSED" if speed < LEAST[method] else ""
            print(f"{method:26} {'given' if normals else 'fitted':>8} "
                  f"{seconds * 1e9 / MILLION:9.0f} {processor * 1e9 / MILLION:7.0f} "
                  f"{' '.join(stages)} {speeds}  {wanted}".rstrip())
    if reference:
        print(f"speed: times that of {REFERENCE} in this run, in real time and in processor time")
    else:
        print("CGAL was not found: there is nothing to compare with")


def print_flatness(runs, threads):
    figures = []
    for method in LEAST:
        seconds = [runs.seconds(method, size, threads) for size in SIZES]
        processor = [runs.processor_seconds(method, size, threads) for size in SIZES]
        if None in seconds:
            continue
        for name, costs in (("", seconds), (" in processor time", processor)):
            per_point = [cost / size * 1e9 for cost, size in zip(costs, SIZES)]
            text = " ".join(f"{cost:.0f}" for cost in per_point)
            figures.append((max(per_point) / min(per_point),
                            f"{method}, {threads} threads{name}: largest over smallest of {text} "
                            "ns per point at 0.1, 1, 4 million",
                            "" if name else f"{FLAT} or less"))
    if figures:
        print_figures(figures)


def main(times_file, memory_file):
    with open(times_file, encoding="utf-8") as file:
        results = json.load(file)["benchmarks"]
    runs = Runs(results)
    for threads in map(int, runs.values(3)):
        print_methods(runs, threads)
    for threads in map(int, runs.values(3)):
        print_flatness(runs, threads)
    print()
    with open(memory_file, encoding="utf-8") as file:
        for line in file:
            points, bytes_per_point, name = line.rstrip().split(" ", 2)
            missed = ", MISSED" if float(bytes_per_point) > MOST_BYTES else ""
            wanted = "" if name.startswith("CGAL") else f" (wanted: {MOST_BYTES:g} or less{missed})"
            print(f"{bytes_per_point:>10}  bytes per point beyond {points} points, {name}{wanted}")
    tell_failures(results)


if __name__ == "__main__":
    main(*sys.argv[1:])
