#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Speed and memory of every stage and of the whole chain, from thousands to millions of points, beside other programs.

Utilities/benchmark.sh makes all that is needed, and runs it. Each size with each number of threads is a process of its
own, so that nobody starts with memory that another one has left behind. Seconds are by the clock, the least of some
runs. Memory is by how much the resident memory of the process grows at most during the first run of a stage, result
included, beyond what it had before (VmHWM after a reset through /proc/self/clear_refs, less VmRSS).

The table goes to the standard output, and with --markdown into a file; with --json all figures go into a file, too.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

SIZES = (15626, 32402, 60511, 68956, 98231, 148317, 346796, 664582, 886639, 10000000)
HUGE = 50000000
MOST_SECONDS = 10.0  # for a run of another program
PEERS_UP_TO = 1000000  # for the programs in C++, which make points of their own


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=pathlib.Path, help="folder of generate_horizons and the benchmark programs")
    parser.add_argument("--sizes", type=int, nargs="+", default=list(SIZES), metavar="N", help="points of the horizons")
    parser.add_argument("--huge", action="store_true", help="50 million points as well (16 GB of memory, some minutes)")
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2], metavar="N")
    parser.add_argument("--no-peers", action="store_true", help="only ours")
    parser.add_argument("--json", type=pathlib.Path, metavar="FILE")
    parser.add_argument("--markdown", type=pathlib.Path, metavar="FILE")
    return parser.parse_args()


def report(text):
    print(text, file=sys.stderr, flush=True)


def measure_apart(*arguments):
    """In a process of its own."""
    command = [sys.executable, str(pathlib.Path(__file__).with_name("benchmark_stages.py")), *arguments]
    return json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout)


def measure_stages(path, threads, before):
    """`before` has the results of the size before, which tell how much memory a stage will need."""
    needs = {r["stage"]: r["bytes_per_point"] for r in before if r["threads"] == threads}
    return measure_apart("stages", str(path), str(threads), json.dumps(needs))


class Peers:
    """Other programs, each until it is too slow."""

    def __init__(self):
        self.last = {}  # name: (points, seconds)

    def measure(self, path, points, threads):
        slow = [name for name, (size, seconds) in self.last.items()
                if seconds * (points / size) ** 1.3 > MOST_SECONDS]
        found = measure_apart("peers", str(path), str(threads), json.dumps(slow))
        self.last.update((r["peer"], (points, r["seconds"])) for r in found)
        return found


def run_program(folder, name, *arguments):
    """Lines that a benchmark program prints; none where it was not built."""
    program = folder / name
    if not program.is_file():
        return []
    report(name)
    return subprocess.run([str(program), *map(str, arguments)], check=True, stdout=subprocess.PIPE,
                          text=True).stdout.splitlines()


def cells(line):
    return [cell.strip() for cell in line.strip("| \n").split("|")]


def program_result(stage, peer, points, theirs, ours):
    return {"stage": stage, "peer": peer, "points": points, "threads": 1, "seconds": theirs, "our_seconds": ours}


def measure_opencv(folder, sizes):
    rows = [line.split(",") for line in run_program(folder, "BoundaryBenchmark", "--exterior", *sizes)[1:]]
    ours = {row[0]: float(row[3]) for row in rows if row[1] == "exterior"}
    return [program_result("boundary", "OpenCV findContours and connectedComponents", int(row[0]), float(row[3]),
                           ours[row[0]]) for row in rows if row[1].startswith("opencv")]


CGAL_COLUMNS = (("CGAL Delaunay", "CGAL Delaunay s"), ("CGAL constrained Delaunay", "CGAL constrained s"),
                ("CGAL constrained, triangles inside", "CGAL inside s"))


def measure_cgal(folder, sizes):
    """All points at every size; what the simplifications leave, at the least, the middle and the largest."""
    some = [sizes[n] for n in sorted({0, len(sizes) // 2, len(sizes) - 1})]
    return read_cgal(run_program(folder, "TriangulationBenchmark", "--full", *sizes), ("full",)) + \
        read_cgal(run_program(folder, "TriangulationBenchmark", *some), ("simplified", "elaborate"))


def read_cgal(lines, kinds):
    """Simplified horizons are filed under the points they had before."""
    stages = {"full": "triangulation, all points", "simplified": "triangulation, after rough",
              "elaborate": "triangulation, after elaborate"}
    rows = [cells(line) for line in lines]
    found = []
    points = 0
    for row in rows[2:]:
        values = dict(zip(rows[0], row))
        points = int(values["points"]) if values["horizon"] == "full" else points
        for name, column in CGAL_COLUMNS:
            if values["horizon"] in kinds:
                found.append(program_result(stages[values["horizon"]], name, points, float(values[column]),
                                            float(values["VTS s"])))
    return found


def measure_locator(folder, sizes):
    """Distances of all points of a horizon to a simplified mesh of it."""
    found = []
    for size in sizes:
        lines = map(cells, run_program(folder, "SurfaceDistanceBenchmark", size))
        rows = {row[0]: row for row in lines if len(row) == 6}
        if rows:
            seconds = [float(rows[name][1]) + float(rows[name][2]) for name in ("vtkStaticCellLocator", "TriangleTree")]
            found.append(program_result("error", "vtkStaticCellLocator, points only", size, *seconds))
    return found


def measure_programs(folder, sizes):
    small = [size for size in sizes if size <= PEERS_UP_TO]
    largest = small[-1:]
    return measure_opencv(folder, sizes[:-1] if sizes[-1] == HUGE else sizes) + measure_cgal(folder, small) + \
        measure_locator(folder, largest)


def measure(options):
    sizes = sorted(options.sizes + ([HUGE] if options.huge else []))
    stages, others = [], []
    peers = Peers()
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "horizon.vsm"
        for size in sizes:
            report("%d points" % size)
            subprocess.run([str(options.programs / "generate_horizons"), "--points", str(size), "--horizons", "1",
                            str(path)], check=True, stdout=subprocess.DEVNULL)
            before = [r for r in stages if r["size"] == max((r["size"] for r in stages), default=0)]
            found = [dict(r, size=size, threads=threads) for threads in options.threads
                     for r in measure_stages(path, threads, before)]
            stages += found
            if not options.no_peers:
                threads = max(options.threads)
                ours = {r["stage"]: r["seconds"] for r in found if r["threads"] == threads}
                others += [dict(r, points=size, threads=threads, our_seconds=ours[r["stage"]])
                           for r in peers.measure(path, size, threads)]
    if not options.no_peers:
        others += measure_programs(options.programs, sizes)
    return {"processors": os.cpu_count(), "stages": stages,
            "peers": [dict(r, ratio=r["seconds"] / r["our_seconds"]) for r in others]}


def number(value):
    return "%.0f" % value if value >= 100.0 else "%.3g" % value


def table(heads, rows):
    lines = ["| " + " | ".join(heads) + " |", "|" + " --- |" * len(heads)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def stage_table(results, threads, quantity):
    sizes = sorted({r["size"] for r in results})
    rows = []
    for stage in dict.fromkeys(r["stage"] for r in results):
        values = {r["size"]: quantity(r) for r in results if r["stage"] == stage and r["threads"] == threads}
        rows.append([stage] + [number(values[size]) if size in values else "-" for size in sizes])
    return table(["points"] + ["{:,}".format(size) for size in sizes], rows)


def growth_sentences(results, threads):
    """How far from linear each stage is."""
    lines = []
    for stage in dict.fromkeys(r["stage"] for r in results):
        found = sorted((r["points"], r["seconds"]) for r in results if r["stage"] == stage and r["threads"] == threads)
        middle = [f for f in found if f[0] >= 100000] or found
        (few, quick), (many, slow) = middle[0], middle[-1]
        if many > few:
            lines.append("- %s, at %s points, %s times what it is at %s" % (
                stage, "{:,}".format(many), number((slow / many) / (quick / few)), "{:,}".format(few)))
    return "\n".join(lines) + "\n" if lines else ""


def ratios_by_size(results):
    """Of each other program, by the size asked for: those in C++ make horizons of nearly that size."""
    sizes = sorted({r["size"] for r in results["stages"]})
    found = {}
    for r in results["peers"]:
        size = min(sizes, key=lambda s: abs(s - r["points"]))
        found.setdefault((r["stage"], r["peer"]), {})[size] = r["ratio"]
    return sizes, found


def peer_table(results):
    sizes, found = ratios_by_size(results)
    rows = [[stage, peer] + [number(ratios[size]) if size in ratios else "-" for size in sizes]
            for (stage, peer), ratios in found.items()]
    return table(["stage", "other program"] + ["{:,}".format(size) for size in sizes], rows)


def peer_sentences(results):
    """Who is slower and who is faster at every size, and who now this, now that."""
    lines = []
    for (stage, peer), ratios in ratios_by_size(results)[1].items():
        least, most = min(ratios.values()), max(ratios.values())
        verdict = "slower than ours" if least > 1.1 else "faster than ours" if most < 0.9 else "sometimes faster, " \
            "sometimes slower than ours, or the same"
        span = number(least) if least == most else "%s to %s" % (number(least), number(most))
        lines.append("- %s: %s is %s, at %s times the time" % (stage, peer, verdict, span))
    return "\n".join(lines) + "\n"


PAGE = """\
# Benchmarks

Made by `Utilities/benchmark.sh --markdown Documentation/Benchmarks.md`, on {processors} processors. Generated horizons
of so many points; boundary simplification with a threshold of 0.4, rough with cells of 3, elaborate with cells of 8
and a flatness of 0.03 without rough before, triangulation of all points and of those that rough leaves, and the error
between these two meshes. The whole chain is read, boundary, its simplification, rough and triangulation, in one go.
Attributes are carried along everywhere. Points per second are those of the input of the stage, for the error those of
the larger mesh.

{tables}## Memory: bytes per point

By how much the memory of the process grows at most, the result of the stage included, divided by the points of its
input. Below some hundred thousand points, what libraries load at their first use is a large part of it.

{memory}
## Growth

The time per point, by the clock on {most_threads} threads, is in

{growth}
## Other programs

Their time divided by ours at the same thread count, above 1 where ours is faster; each until it would take longer than
{most_seconds:g} s. Those in C++ (OpenCV, CGAL, vtkStaticCellLocator) are timed with our algorithm alone in one process
on one thread, on horizons that they make themselves; the others with our filters, attributes included. OpenCV begins
with an image that is ready, ours with a list of points. CGAL's triangulations fill the hull; *triangles inside* is the
constrained one with what it takes to list the triangles inside the outline, as ours does. What is meshed *after rough* and *after elaborate* has the outline as simplified,
and stands under the points before. The clustering filters are timed with cells of 3 on the mesh of all points, and
`vtkQuadricDecimation` down to as many triangles as the mesh after rough has, all without the time to make that mesh.
*ParaView's chain* is vtkDelimitedTextReader on lines of i, j and k, vtkDelaunay2D and vtkDecimatePro. What their results
are worth is on another page: [Tables.md](Tables.md#what-a-vertex-buys).

{peers}"""


def page(results):
    stages = results["stages"]
    threads = sorted({r["threads"] for r in stages})
    parts = []
    for n in threads:
        title = "%d thread%s" % (n, "" if n == 1 else "s")
        parts.append("## Seconds, %s\n\n%s" % (title, stage_table(stages, n, lambda r: r["seconds"])))
        parts.append("## Million points per second, %s\n\n%s" % (
            title, stage_table(stages, n, lambda r: 1e-6 * r["points_per_second"])))
    peers = peer_table(results) + "\n" + peer_sentences(results) if results["peers"] else "None were run.\n"
    return PAGE.format(processors=results["processors"], most_threads=threads[-1], most_seconds=MOST_SECONDS,
                       tables="\n".join(parts) + "\n",
                       memory=stage_table(stages, threads[-1], lambda r: r["bytes_per_point"]),
                       growth=growth_sentences(stages, threads[-1]), peers=peers)


def main():
    options = parse_arguments()
    results = measure(options)
    text = page(results)
    print(text, end="")
    if options.json:
        options.json.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    if options.markdown:
        options.markdown.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
