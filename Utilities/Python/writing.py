# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Results as files: meshes, and the figures of the error.

All are made in memory, and written by Python: where a disk is full, VTK's writers go on, and may crash.
"""

import csv
import io

from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from .stage import HorizonError, update


def write_mesh(mesh, path):
    """Writes a mesh as .vtp. Raises HorizonError."""
    writer = vtkXMLPolyDataWriter()
    writer.WriteToOutputStringOn()
    writer.SetInputDataObject(0, mesh)
    # Not the default, which appends raw bytes: readers of VTK up to 9.2 stumble over them with a recent Expat library.
    writer.SetDataModeToBinary()
    update(writer, "%s: writing" % path.name)
    write_file(writer.GetOutputString().encode(), path)


def write_figures(results, path):
    """Writes the figures of the error of all horizons as one file of comma-separated values. Raises HorizonError."""
    text = io.StringIO()
    writer = csv.writer(text)
    for number, result in enumerate(results):
        table = result.figures
        columns = range(table.GetNumberOfColumns())
        if number == 0:
            writer.writerow([table.GetColumnName(column) for column in columns])
        for row in range(table.GetNumberOfRows()):
            values = [table.GetValue(row, column) for column in columns]
            writer.writerow([repr(v.ToDouble()) if v.IsDouble() else v.ToString() for v in values])
    write_file(text.getvalue().encode(), path)


def write_file(content, path):
    """Writes bytes. Raises HorizonError."""
    try:
        path.write_bytes(content)
    except OSError as error:
        raise HorizonError("%s can not be written: %s" % (path.name, error.strerror)) from None
