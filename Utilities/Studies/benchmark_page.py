# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The page on speed and memory."""

from text import table


def number(value):
    return "%.0f" % value if value >= 100.0 else "%.3g" % value


def stage_table(results, threads, quantity):
    sizes = sorted({r["size"] for r in results})
    rows = []
    for stage in dict.fromkeys(r["stage"] for r in results):
        values = {r["size"]: quantity(r) for r in results if r["stage"] == stage and r["threads"] == threads}
        rows.append([stage] + [number(values[size]) if size in values else "-" for size in sizes])
    return table(["points"] + ["{:,}".format(size) for size in sizes], rows)


def growth_table(results, threads):
    """How far from linear each stage is."""
    rows = []
    for stage in dict.fromkeys(r["stage"] for r in results):
        found = sorted((r["points"], r["seconds"]) for r in results if r["stage"] == stage and r["threads"] == threads)
        middle = [f for f in found if f[0] >= 100000] or found
        (few, quick), (many, slow) = middle[0], middle[-1]
        if many > few:
            rows.append([stage, "{:,}".format(few), "{:,}".format(many), number((slow / many) / (quick / few))])
    return table(["stage", "points", "and", "times"], rows) if rows else "One size alone.\n"


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


PAGE = """\
# Benchmarks

`Utilities/Studies/benchmark.sh --markdown Documentation/Benchmarks.md` measures and writes this page, here on
{processors} processors, with generated horizons and all their attributes.

- *Boundary simplification* has a threshold of 0.4, *rough* cells of 3, *elaborate* cells of 8 and a flatness of 0.03,
  without rough before.
- *Error* is that between the meshes of all points and of those that rough leaves.
- *Whole chain* is read, boundary, its simplification, rough and triangulation in one run.
- *File to mesh* is read and Horizon Surface with its defaults (an error of 0.75).

{tables}## Memory: bytes per point

The largest growth of the process, including the result of the stage, per point of its input. Below some hundred
thousand points, libraries that load at their first use are a large fraction.

{memory}
## Growth

Time per point at the larger number of points, divided by that at the smaller, on {most_threads} threads:

{growth}
## Other programs

Their time divided by ours at the same thread count: above 1, ours is faster. Programs that would take longer than
{most_seconds:g} s are left out. [Tables.md](Tables.md#what-a-vertex-buys) compares the results.

- The bare loop, OpenCV, CGAL and vtkStaticCellLocator are timed with our algorithm alone, in one process on one thread,
  on horizons of their own; the others with our filters, attributes included.
- The *bare loop* over a mapped file knows digits, points and minus signs, checks nothing, and fills vectors; ours is
  the parser without VTK.
- OpenCV starts with an image, ours with a list of points.
- CGAL fills the hull; *triangles inside* also lists the triangles inside the outline, as ours does. *After rough* and
  *after elaborate*, the outline is simplified; the columns are those of the points before.
- Clustering filters have cells of 3, and `vtkQuadricDecimation` as many triangles as after rough. Making the mesh of
  all points that they need is not timed.
- *ParaView's chain* is vtkDelimitedTextReader on lines of i, j and k, vtkDelaunay2D and vtkDecimatePro.

{peers}"""


def page(results, most_seconds):
    """Other programs were left out that would have taken longer than `most_seconds`."""
    stages = results["stages"]
    threads = sorted({r["threads"] for r in stages})
    parts = []
    for n in threads:
        title = "%d thread%s" % (n, "" if n == 1 else "s")
        parts.append("## Seconds, %s\n\n%s" % (title, stage_table(stages, n, lambda r: r["seconds"])))
    peers = peer_table(results) if results["peers"] else "None were run.\n"
    return PAGE.format(processors=results["processors"], most_threads=threads[-1], most_seconds=most_seconds,
                       tables="\n".join(parts) + "\n",
                       memory=stage_table(stages, threads[-1], lambda r: r["bytes_per_point"]),
                       growth=growth_table(stages, threads[-1]), peers=peers)
