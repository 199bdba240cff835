#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints what the benchmarks found beside what they should find.

table.py <times.json of SurfaceDenoisingBenchmarks> <output lines of SurfaceDenoisingPeakMemory>

Tables whose benchmarks did not run are left out. Those that failed are named at the end, and the
exit code is 1.
"""

import json
import sys

SIZES = (3, 9, 18)  # cuts per edge
REFERENCE = "Bilateral Normal"
# How many times the time of the bilateral filter with the same iterations a method may take.
MOST = 6.0
OTHER_MOST = {"Guided Normal": 10.0, "Global Bilateral Normal": None}


def fastest(results):
    """The fastest run of each benchmark by its name with arguments."""
    times = {}
    for result in results:
        if not result.get("error_occurred") and result["run_type"] == "iteration":
            name = result["name"].replace("/real_time", "").replace("/manual_time", "")
            name = name.split("/iterations")[0].split("/repeats")[0]
            if name not in times or result["real_time"] < times[name]["real_time"]:
                times[name] = result
    return times


def tell_failures(results):
    """Ends the program if there are any."""
    failures = [f"{result['name']}: {result['error_message']}" for result in results
                if result.get("error_occurred")]
    if failures:
        sys.exit("\n".join(["Benchmarks that failed:"] + list(dict.fromkeys(failures))))


def flatness(times, name):
    """Cost per triangle at the sizes, largest over smallest."""
    costs = [times[name.format(cuts)]["real_time"] / times[name.format(cuts)]["faces"]
             for cuts in SIZES]
    return max(costs) / min(costs)


def print_figures(figures):
    print()
    for value, text, wanted in figures:
        print(f"{value:10.2f}  {text}" + (f" (wanted: {wanted})" if wanted else ""))


def print_memory(memory, method):
    for faces, bytes_per_face, name in memory:
        if name == method:
            print(f"{bytes_per_face:10.1f}  bytes per triangle at {faces:.0f} triangles")


def print_bilateral(times, memory):
    def bilateral(cuts, shuffled=0):
        return times[f"Bilateral/cuts:{cuts}/shuffled:{shuffled}"]

    print(f"\n{'faces':>10} {'order':>9} {'seconds':>8} {'ns/face':>8} {'setup':>7} "
          f"{'normals':>8} {'vertices':>9} {'sweeps GB/s':>12}")
    for cuts in SIZES:
        for shuffled in (0, 1):
            t = bilateral(cuts, shuffled)
            print(f"{t['faces']:10.0f} {'random' if shuffled else 'of file':>9} "
                  f"{t['real_time'] / 1e3:8.2f} {t['real_time'] * 1e6 / t['faces']:8.0f} "
                  f"{t['setup_s']:7.2f} {t['normals_s']:8.2f} {t['vertices_s']:9.2f} "
                  f"{t['sweep_GB/s']:12.2f}")

    million = bilateral(9)
    textbook = times["TextbookBilateral/cuts:9"]
    copy = times["Copy"]["GB/s"]
    iterations = million["normals_s"] + million["vertices_s"]
    figures = [
        (textbook["real_time"] / million["real_time"], "times faster than the textbook version",
         "12 or more"),
        ((textbook["real_time"] / 1e3 - textbook["setup_s"]) / iterations,
         "the same without setup on either side", ""),
        (times["WindowedSinc/cuts:9"]["real_time"] / million["real_time"],
         "times the speed of 20 iterations of windowed sinc", "1 or more"),
        (flatness(times, "Bilateral/cuts:{}/shuffled:0"),
         "cost per triangle, largest over smallest of three sizes", "1.2 or less"),
        (copy, "GB/s of copying memory on the same threads", ""),
        (million["sweep_GB/s"] / copy, "share of it that a normal iteration reaches", "")]
    peaks = [bytes_per_face for _, bytes_per_face, name in memory if name == REFERENCE]
    if peaks:
        figures.append((max(peaks), "bytes per triangle beyond the input at the peak",
                        "300 or less"))
    print_figures(figures)
    print_memory(memory, REFERENCE)


def least(results, counter):
    """The least value of a counter by benchmark, which need not be that of the fastest run."""
    values = {}
    for result in results:
        if result["run_type"] == "iteration" and counter in result:
            name = result["name"].split("/iterations")[0]
            values[name] = min(result[counter], values.get(name, result[counter]))
    return values


def print_methods(times, results):
    references = least(results, "bilateral_s")
    processor = least(results, "processor_s")
    processor_references = least(results, "bilateral_processor_s")
    print(f"\n{'method':26} {'faces':>8} {'iterations':>10} {'seconds':>8} {'ns/face':>8} "
          f"{'bilateral':>10} {'ratio':>6} {'of CPU':>6}  wanted")
    for name, t in times.items():
        if not name.startswith("Method/"):
            continue
        method = name.split("/")[1]
        seconds = t["real_time"] / 1e3
        most = OTHER_MOST.get(method, MOST)
        ratio = seconds / references[name]
        wanted = f"{most:g} or less" + (", MISSED" if ratio > most else "") if most else "-"
        if t.get("solver_iterations"):
            wanted += f" ({t['solver_iterations']:.0f} iterations of the solver)"
        iterations = (f"{t['outer']:.0f}/{t['normal']:.0f}/{t['vertex']:.0f}"
                      if "outer" in t else "1 step")
        print(f"{method:26} {t['faces']:8.0f} {iterations:>10} {seconds:8.2f} "
              f"{1e9 * seconds / t['faces']:8.0f} {references[name]:10.2f} {ratio:6.2f} "
              f"{processor[name] / processor_references[name]:6.2f}  {wanted}")


def main(times_file, memory_file):
    with open(times_file, encoding="utf-8") as file:
        results = json.load(file)["benchmarks"]
    times = fastest(results)
    with open(memory_file, encoding="utf-8") as file:
        memory = [(float(line.split()[0]), float(line.split()[1]), " ".join(line.split()[2:]))
                  for line in file]

    wanted = {f"Bilateral/cuts:{cuts}/shuffled:{shuffled}" for cuts in SIZES for shuffled in (0, 1)}
    if wanted | {"TextbookBilateral/cuts:9", "WindowedSinc/cuts:9", "Copy"} <= times.keys():
        print_bilateral(times, memory)
    if any(name.startswith("Method/") for name in times):
        print_methods(times, results)
    if {f"Method/Guided Normal/cuts:{cuts}" for cuts in SIZES} <= times.keys():
        seconds = least(results, "processor_s")
        processor = [seconds[name] / times[name]["faces"]
                     for name in map("Method/Guided Normal/cuts:{}".format, SIZES)]
        print_figures([(flatness(times, "Method/Guided Normal/cuts:{}"),
                        "guided, cost per triangle, largest over smallest of three sizes",
                        "1.3 or less"),
                       (max(processor) / min(processor), "the same in processor time", "")])
        print_memory(memory, "Guided Normal")
    tell_failures(results)


if __name__ == "__main__":
    main(*sys.argv[1:])
