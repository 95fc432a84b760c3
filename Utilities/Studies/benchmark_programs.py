# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The benchmark programs in C++, which compare our algorithms with other libraries."""

import subprocess

from text import cells, report

HUGE = 50000000  # points, more than the limit for OpenCV
SIZE_OF_SCALING = 886639
PEERS_UP_TO = 1000000  # limit for CGAL and VTK's locator


def run_program(folder, name, *arguments):
    """Returns the lines that a benchmark program prints; none if it was not built."""
    program = folder / name
    if not program.is_file():
        return []
    report(name)
    return subprocess.run([str(program), *map(str, arguments)], check=True, stdout=subprocess.PIPE,
                          text=True).stdout.splitlines()


def program_result(stage, peer, points, theirs, ours):
    return {"stage": stage, "peer": peer, "points": points, "threads": 1, "seconds": theirs, "our_seconds": ours}


def measure_scaling(folder, threads, sizes):
    """Returns the table of how our algorithms gain from threads: all at one size, surfaces and extraction at the largest."""
    words = ["--threads", ",".join(map(str, threads))]
    lines = run_program(folder, "ScalingBenchmark", *words, min(sizes, key=lambda size: abs(size - SIZE_OF_SCALING)))
    if lines and max(sizes) > SIZE_OF_SCALING:
        for stage in ("surface, best", "extraction"):
            lines += run_program(folder, "ScalingBenchmark", *words, "--stage", stage, max(sizes))[2:]
    return lines


def measure_reading(folder, path, size):
    """Measures the parser alone, on one thread, against a minimal loop."""
    rows = [line.split(",") for line in run_program(folder, "ReadingBenchmark", path)[1:]]
    seconds = {(what, int(threads)): float(value) for _, what, threads, value in rows}
    return [program_result("read", "bare loop", size, seconds["bare", 1], ours)
            for (what, threads), ours in seconds.items() if what == "parser" and threads == 1]


def measure_opencv(folder, sizes):
    rows = [line.split(",") for line in run_program(folder, "BoundaryBenchmark", "--exterior", *sizes)[1:]]
    ours = {row[0]: float(row[3]) for row in rows if row[1] == "exterior"}
    return [program_result("boundary", "OpenCV findContours and connectedComponents", int(row[0]), float(row[3]),
                           ours[row[0]]) for row in rows if row[1].startswith("opencv")]


CGAL_COLUMNS = (("CGAL constrained Delaunay", "CGAL inside s"),)


def measure_cgal(folder, sizes):
    """Measures all points at every size, and simplified points at the smallest, middle and largest size."""
    some = [sizes[n] for n in sorted({0, len(sizes) // 2, len(sizes) - 1})]
    return read_cgal(run_program(folder, "TriangulationBenchmark", "--full", *sizes), ("full",)) + \
        read_cgal(run_program(folder, "TriangulationBenchmark", *some), ("simplified", "elaborate"))


def read_cgal(lines, kinds):
    """Lists simplified horizons under their original number of points."""
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
    """Measures the distances of all points of a horizon from a simplified mesh of it."""
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
