#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Repeats the measurements of the thesis and writes a page that compares its tables 4.1 to 4.6 and 5.1, its curves 3.18,
3.19 and 5.18 and its figures of surfaces with our results and those of other programs.

Utilities/Studies/reproduce_thesis.sh sets everything up and runs it. Needs the package seismichorizons in PYTHONPATH;
Matplotlib for the curves, an X server for the pictures of surfaces, and MeshLab as well for the programs compared in the
thesis. Results whose programs are missing are omitted.
"""

import argparse
import pathlib
import subprocess
import tempfile

from text import cells, report
from thesis import figures, partners, reported, stages, study
from thesis.page import all_tables, page

CURVE_SURFACE = 60511  # surface whose errors are plotted against vertices


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("generator", help="the program generate_horizons")
    parser.add_argument("folder", type=pathlib.Path, help="where Tables.md goes, and the folder Pictures")
    parser.add_argument("--tables", type=pathlib.Path, metavar="FILE",
                        help="write the rows of tables 4.1 to 4.6, of which the page has medians, and captions")
    parser.add_argument("--surfaces", type=int, default=len(reported.SURFACES), metavar="N",
                        help="only so many surfaces, the smallest first (default: all)")
    parser.add_argument("--triangulation-benchmark", metavar="PROGRAM",
                        help="the program TriangulationBenchmark, for the times of CGAL")
    return parser.parse_args()


def measure_surfaces(options, folder, pace):
    """Measures all surfaces of table 4.1, and the errors by number of vertices of one of them."""
    sizes = sorted(reported.SURFACES)[:options.surfaces]
    found = []
    curves = None
    for size in sizes:
        report("%d points: simplification" % size)
        surface = study.Surface(options.generator, size, folder, pace)
        if size == min(CURVE_SURFACE, sizes[-1]):
            curves = (size, surface.curves())
        surface.forget()
        found.append(surface)
    return found, curves


def measure_meshings(options, folder, pace):
    sizes = sorted(reported.TRIANGULATION)
    sizes = sizes if options.surfaces == len(reported.SURFACES) else sizes[:options.surfaces]
    found = []
    for size in sizes:
        report("%d points: triangulation" % size)
        found.append(study.Meshing(options.generator, size, folder, pace))
    return found


def measure_cgal(program, meshings):
    """Returns the times of CGAL's Delaunay triangulations of the same numbers of points, by name."""
    if not program:
        return {}
    report("CGAL")
    sizes = [str(m.size) for m in meshings]
    lines = subprocess.run([program, "--full", *sizes], check=True, capture_output=True, text=True).stdout.splitlines()
    heads, _, *rows = map(cells, lines)
    return {name: [(int(row[heads.index("points")]), float(row[heads.index(name + " s")])) for row in rows]
            for name in ("CGAL Delaunay", "CGAL constrained")}


def draw(found, curves, meshings, cgal, folder):
    try:
        from thesis import curves as draw_curves
    except ImportError:
        report("no Matplotlib, no curves")
        return
    folder.mkdir(parents=True, exist_ok=True)
    draw_curves.boundary_time(found, folder / "BoundaryTime.png")
    draw_curves.boundary_rate(found, folder / "BoundaryRate.png")
    draw_curves.triangulation_time(meshings, cgal, folder / "TriangulationTime.png")
    draw_curves.vertex_worth(curves[1], "A surface of {:,} points".format(curves[0]), folder / "VertexWorth.png")


def draw_figures(shown, folder):
    if not figures.can_draw():
        report("no X server, no pictures of surfaces")
        return
    folder.mkdir(parents=True, exist_ok=True)
    for figure in shown:
        figure.draw(folder)


def main():
    options = parse_arguments()
    stages.set_threads(0)
    paces = (partners.Pace(), study.meshing_pace())
    with tempfile.TemporaryDirectory() as folder:
        found, curves = measure_surfaces(options, folder, paces[0])
        meshings = measure_meshings(options, folder, paces[1])
        report("figures")
        shown = figures.figures(options.generator, folder, found[-1].size)
    cgal = measure_cgal(options.triangulation_benchmark, meshings)
    options.folder.mkdir(parents=True, exist_ok=True)
    (options.folder / "Tables.md").write_text(page(found, curves, paces, shown), encoding="utf-8")
    if options.tables:
        options.tables.write_text(all_tables(found, meshings, paces, shown), encoding="utf-8")
    draw(found, curves, meshings, cgal, options.folder / "Pictures")
    draw_figures(shown, options.folder / "Pictures")


if __name__ == "__main__":
    main()
