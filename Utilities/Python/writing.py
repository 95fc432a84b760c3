# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Results as files: meshes, and the figures of the error."""

import csv

from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from .stage import HorizonError, watched


def write_mesh(mesh, path):
    """Writes a mesh as .vtp. Raises HorizonError."""
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputDataObject(0, mesh)
    # Not the default, which appends raw bytes: readers of VTK up to 9.2 stumble over them with a recent Expat library.
    writer.SetDataModeToBinary()
    try:
        with watched(writer, "%s: writing" % path.name):
            written = writer.Write()
    except HorizonError as error:
        raise HorizonError("cannot write %s: %s" % (path.name, error)) from None
    if not written or not path.is_file():
        raise HorizonError("cannot write %s" % path.name)


def write_figures(results, path):
    """Writes the figures of the error of all horizons as one file of comma-separated values."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        for number, result in enumerate(results):
            table = result.figures
            columns = range(table.GetNumberOfColumns())
            if number == 0:
                writer.writerow([table.GetColumnName(column) for column in columns])
            for row in range(table.GetNumberOfRows()):
                values = [table.GetValue(row, column) for column in columns]
                writer.writerow([repr(v.ToDouble()) if v.IsDouble() else v.ToString() for v in values])
