# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes all horizons of many files into one folder, each in a file of its own, and prints a table of the results.

    python3 many_horizons.py results picks/*.dat survey.vsm

Runs in the system Python, which must find the package seismichorizons. Files that cannot be read are listed, and the
other files are processed.
"""

import argparse
import csv
import pathlib
import re

from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from seismichorizons_command import pipeline
from seismichorizons_command.core import HorizonError


def file_name(path, name):
    """Returns a name that is valid on any file system."""
    return "%s_%s.vtp" % (path.stem, re.sub(r"[^\w.-]+", "_", name))


def mesh_file(path, folder, error):
    """Meshes the horizons of one file and yields a table row for each."""
    horizons, _ = pipeline.read(str(path))
    for name, points in horizons:
        mesh, chosen = pipeline.surface(points, largest_error=error)
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(str(folder / file_name(path, str(name))))
        writer.SetInputData(mesh)
        writer.SetDataModeToBinary()  # some readers of VTK fail on appended data
        if not writer.Write():
            raise OSError("%s cannot be written" % writer.GetFileName())
        yield {"file": path.name, "horizon": name, "points": points.GetNumberOfPoints(),
               "triangles": mesh.GetNumberOfPolys(), "radius": chosen["Radius"]}


def main():
    parser = argparse.ArgumentParser(prog="many_horizons", description=__doc__.splitlines()[0])
    parser.add_argument("folder", metavar="FOLDER", type=pathlib.Path, help="where results go")
    parser.add_argument("files", metavar="FILE", type=pathlib.Path, nargs="+", help="the horizons, in any format that is read")
    parser.add_argument("--largest-error", metavar="E", type=float, default=1.0, help="how far meshes may be off")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    failures = 0
    with open(arguments.folder / "meshes.csv", "w", encoding="utf-8", newline="") as file:
        table = csv.DictWriter(file, ("file", "horizon", "points", "triangles", "radius"))
        table.writeheader()
        for path in arguments.files:
            try:
                table.writerows(mesh_file(path, arguments.folder, arguments.largest_error))
            except (HorizonError, OSError) as error:
                print("many_horizons: %s" % error)
                failures += 1
    raise SystemExit(1 if failures else 0)


main()
