# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes all horizons of many files into one folder, each in a file of its own, with a table in meshes.csv.

    python3 many_horizons.py results picks/*.dat survey.vsm

Needs the Python package seismichorizons. Files that cannot be read are listed, and the other files are processed.
"""

import argparse
import csv
import pathlib
import re

import seismichorizons as sh

COLUMNS = ("file", "horizon", "points", "triangles", "largest error", "unit")


def file_name(path, name):
    """Returns a name that is valid on any file system."""
    return "%s_%s.vtp" % (path.stem, re.sub(r"[^\w.-]+", "_", name))


def mesh_file(path, folder, error):
    """Meshes the horizons of one file and yields a table row for each."""
    for name, horizon in sh.read(path).items():
        mesh = sh.surface(horizon, error)
        sh.write(mesh, folder / file_name(path, name))
        yield path.name, name, len(horizon), len(mesh), "%.4g" % mesh.largest_error, mesh.vertical_unit


def main():
    parser = argparse.ArgumentParser(prog="many_horizons", description=__doc__.splitlines()[0])
    parser.add_argument("folder", metavar="FOLDER", type=pathlib.Path, help="where results go")
    parser.add_argument("files", metavar="FILE", type=pathlib.Path, nargs="+", help="the horizons, in any format of sh.read")
    parser.add_argument("--largest-error", metavar="E",
                        help='how far meshes may be off, in the unit of z or as "2 ms" (default: six times the noise of each horizon)')
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    failures = 0
    with open(arguments.folder / "meshes.csv", "w", encoding="utf-8", newline="") as file:
        table = csv.writer(file)
        table.writerow(COLUMNS)
        for path in arguments.files:
            try:
                table.writerows(mesh_file(path, arguments.folder, arguments.largest_error))
            except (ValueError, OSError) as error:
                print("many_horizons: %s" % error)
                failures += 1
    raise SystemExit(1 if failures else 0)


main()
