#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints what the benchmarks found beside what they should find.

table.py <times.json of SurfaceDenoisingBenchmarks> <output lines of SurfaceDenoisingPeakMemory>
"""

import json
import sys


def main(times_file, memory_file):
    with open(times_file, encoding="utf-8") as file:
        results = json.load(file)["benchmarks"]
    times = {}  # the fastest run of each
    for result in results:
        if not result.get("error_occurred") and result["run_type"] == "iteration":
            name = result["name"].replace("/real_time", "").split("/iterations")[0]
            name = name.split("/repeats")[0]
            if name not in times or result["real_time"] < times[name]["real_time"]:
                times[name] = result
    with open(memory_file, encoding="utf-8") as file:
        memory = [tuple(float(word) for word in line.split()) for line in file]

    def bilateral(cuts, shuffled=0):
        return times[f"Bilateral/cuts:{cuts}/shuffled:{shuffled}"]

    print(f"\n{'faces':>10} {'order':>9} {'seconds':>8} {'ns/face':>8} {'setup':>7} "
          f"{'normals':>8} {'vertices':>9} {'sweeps GB/s':>12}")
    for cuts in (3, 9, 18):
        for shuffled in (0, 1):
            t = bilateral(cuts, shuffled)
            print(f"{t['faces']:10.0f} {'random' if shuffled else 'of file':>9} "
                  f"{t['real_time'] / 1e3:8.2f} {t['real_time'] * 1e6 / t['faces']:8.0f} "
                  f"{t['setup_s']:7.2f} {t['normals_s']:8.2f} {t['vertices_s']:9.2f} "
                  f"{t['sweep_GB/s']:12.2f}")

    million = bilateral(9)
    textbook = times["TextbookBilateral/cuts:9"]
    copy = times["Copy"]["GB/s"]
    costs = [bilateral(cuts)["real_time"] / bilateral(cuts)["faces"] for cuts in (3, 9, 18)]
    iterations = million["normals_s"] + million["vertices_s"]
    print()
    for text, value, target in (
            ("times faster than the textbook version", textbook["real_time"]
             / million["real_time"], "12 or more"),
            ("the same without setup on either side",
             (textbook["real_time"] / 1e3 - textbook["setup_s"]) / iterations, ""),
            ("times the speed of 20 iterations of windowed sinc",
             times["WindowedSinc/cuts:9"]["real_time"] / million["real_time"], "1 or more"),
            ("bytes per triangle beyond the input at the peak",
             max(bytes_per_face for _, bytes_per_face in memory), "300 or less"),
            ("cost per triangle, largest over smallest of three sizes",
             max(costs) / min(costs), "1.2 or less"),
            ("GB/s of copying memory on the same threads", copy, ""),
            ("share of it that a normal iteration reaches", million["sweep_GB/s"] / copy, "")):
        print(f"{value:10.2f}  {text}" + (f" (wanted: {target})" if target else ""))
    for faces, bytes_per_face in memory:
        print(f"{bytes_per_face:10.1f}  bytes per triangle at {faces:.0f} triangles")


if __name__ == "__main__":
    main(*sys.argv[1:])
