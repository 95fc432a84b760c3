# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The page on speed and memory."""

from text import table, wrapped


def number(value):
    return "%.0f" % value if value >= 100.0 else "%.3g" % value


def stage_table(results):
    """Returns seconds by number of threads at the two largest sizes, and memory at the largest size."""
    sizes = sorted({r["size"] for r in results})[-2:]
    counts = sorted({r["threads"] for r in results})
    found = {(r["stage"], r["size"], r["threads"]): r for r in results}
    rows = []
    for stage in dict.fromkeys(r["stage"] for r in results):
        row = [stage]
        for size in sizes:
            row.append(" / ".join(number(found[stage, size, threads]["seconds"]) if (stage, size, threads) in found else "-"
                                  for threads in counts))
        last = found.get((stage, sizes[-1], counts[-1]))
        rows.append(row + [number(last["bytes_per_point"]) if last else "-"])
    return table(["points"] + ["{:,}".format(size) for size in sizes] + ["bytes a point"], rows)


def ratios_by_size(results):
    """Returns the ratios of each other program by requested size; the C++ programs make horizons of nearly that size."""
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


PAGE = """\
# Benchmarks

These tables show the time and memory that the stages need, and the time that other programs need.

`Utilities/Studies/benchmark.sh --markdown Documentation/Benchmarks.md` measures and writes this page, here on
{processors} processors, with synthetic horizons and all their attributes.

## Time and memory

Seconds on {threads} threads, by number of points. Bytes are the peak growth of the process including the result, per
point of the largest horizon.

{stages}
*Boundary simplification* has a threshold of 0.4, *rough* has cells of 3, *elaborate* has cells of 8 and a flatness of
0.03. *Error* measures the mesh after rough. *Whole chain* is read, boundary, boundary simplification, rough and
triangulation. *File to mesh* is read and Horizon Surface with defaults.

## Threads

The algorithms without filters and attributes, on generated horizons; for *extraction*, on a cube with the given number
of samples. *Inside* is the fraction of the single-thread time spent in parallel loops. It limits the speed-up on 16
threads.

{scaling}
## Other programs

Their time divided by ours on the same number of threads: above 1, ours is faster. Programs that would need more than
{most_seconds:g} s are left out. [Tables.md](Tables.md#what-a-vertex-buys) compares the results.

{peers}
- Bare loop, OpenCV, CGAL and vtkStaticCellLocator are compared with our algorithms on one thread, on horizons of their
  own; all others with our filters, including attributes.
- The *bare loop* parses a memory-mapped file without checks. OpenCV starts from an image, ours from a list of points.
- CGAL also lists the triangles inside the outline, which is simplified in *after rough* and *after elaborate*.
- Clustering filters have cells of 3, and `vtkQuadricDecimation` makes as many triangles as after rough. The mesh of all
  points that they need is not included.
- *ParaView's chain* is vtkDelimitedTextReader, vtkDelaunay2D and vtkDecimatePro.
"""


def page(results, most_seconds):
    """Returns the page. Other programs that would take longer than `most_seconds` were omitted."""
    stages = results["stages"]
    threads = " / ".join(map(str, sorted({r["threads"] for r in stages})))
    peers = peer_table(results) if results["peers"] else "None were run.\n"
    scaling = "\n".join(results["scaling"] or ["The program was not built."]) + "\n"
    return wrapped(PAGE.format(processors=results["processors"], threads=threads, most_seconds=most_seconds,
                               stages=stage_table(stages), scaling=scaling, peers=peers))
