# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The page on speed and memory: tables of all figures, and what they say."""

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

Made by `Utilities/Studies/benchmark.sh --markdown Documentation/Benchmarks.md`, on {processors} processors. Generated
horizons of so many points; boundary simplification with a threshold of 0.4, rough with cells of 3, elaborate with cells
of 8 and a flatness of 0.03 without rough before, triangulation of all points and of those that rough leaves, and the
error between these two meshes. The whole chain is read, boundary, its simplification, rough and triangulation, in one
go; *file to mesh* is read and Horizon Surface with its defaults, which decimate for an error of 0.75. Attributes are carried along everywhere. Points per second are those of the input of the stage, for the error those
of the larger mesh.

{tables}## Memory: bytes per point

By how much the memory of the process grows at most, the result of the stage included, divided by the points of its
input. Below some hundred thousand points, what libraries load at their first use is a large part of it.

{memory}
## Growth

The time per point, by the clock on {most_threads} threads, is in

{growth}
## Other programs

Their time divided by ours at the same thread count, above 1 where ours is faster; each until it would take longer than
{most_seconds:g} s. Those in C++ (the bare loop, OpenCV, CGAL, vtkStaticCellLocator) are timed with our algorithm alone
in one process on one thread, on horizons that they make themselves; the others with our filters, attributes included.
OpenCV begins with an image that is ready, ours with a list of points. The *bare loop* over a mapped file knows digits,
points and minus signs, checks nothing, and puts numbers into vectors; ours is the parser without VTK's part. CGAL's
triangulations fill the hull; *triangles inside* is the constrained one with what it takes to list the triangles inside
the outline, as ours does. What is meshed *after rough* and *after elaborate* has the outline as simplified, and stands
under the points before. The clustering filters are timed with cells of 3 on the mesh of all points, and
`vtkQuadricDecimation` down to as many triangles as the mesh after rough has, all without the time to make that mesh.
*ParaView's chain* is vtkDelimitedTextReader on lines of i, j and k, vtkDelaunay2D and vtkDecimatePro. What their
results are worth is on another page: [Tables.md](Tables.md#what-a-vertex-buys).

{peers}"""


def page(results, most_seconds):
    """Other programs were left out that would have taken longer than `most_seconds`."""
    stages = results["stages"]
    threads = sorted({r["threads"] for r in stages})
    parts = []
    for n in threads:
        title = "%d thread%s" % (n, "" if n == 1 else "s")
        parts.append("## Seconds, %s\n\n%s" % (title, stage_table(stages, n, lambda r: r["seconds"])))
        parts.append("## Million points per second, %s\n\n%s" % (
            title, stage_table(stages, n, lambda r: 1e-6 * r["points_per_second"])))
    peers = peer_table(results) + "\n" + peer_sentences(results) if results["peers"] else "None were run.\n"
    return PAGE.format(processors=results["processors"], most_threads=threads[-1], most_seconds=most_seconds,
                       tables="\n".join(parts) + "\n",
                       memory=stage_table(stages, threads[-1], lambda r: r["bytes_per_point"]),
                       growth=growth_sentences(stages, threads[-1]), peers=peers)
