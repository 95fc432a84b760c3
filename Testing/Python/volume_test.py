# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in pvpython: a compressed file is opened, and shown as points, as a volume, and as points again.

Arguments: the folder with the sample, and a folder for files.
"""

import gzip
import math
import pathlib
import sys

# Before any object of these classes comes out of a proxy: Python would take it for one of a base class, for good.
import seismichorizons.vtk  # noqa: F401

from paraview import simple


def show(reader, view):
    """What ParaView shows: the type of data, its points, and how it can be represented."""
    reader.UpdatePipeline()
    display = simple.Show(reader, view)
    simple.Render(view)
    data = reader.GetDataInformation()
    return data.GetDataSetTypeAsString(), data.GetNumberOfPoints(), list(display.GetProperty("Representation").Available)


def check_types(reader, view):
    """The kind of data may change after they were shown."""
    kind, points, _ = show(reader, view)
    assert (kind, points) == ("vtkPartitionedDataSetCollection", 6282 + 5957 + 6019), (kind, points)
    places = reader.GetDataInformation().GetBounds()
    reader.OutputType = "Volume"
    reader.VolumeArray = "Amplitude"
    kind, points, representations = show(reader, view)
    assert (kind, points) == ("vtkImageData", 120 * 100 * 60), (kind, points)
    assert "Slice" in representations and "Volume" in representations, representations
    reader.VolumeExtent = "Bounding Box"
    show(reader, view)
    return places


def check_bounds(reader, places):
    """Voxels lie where the points were, on a survey that is turned."""
    cells = simple.Threshold(Input=reader, Scalars=["POINTS", "SurfaceId"], LowerThreshold=1, UpperThreshold=3)
    cells.AllScalars = 0
    cells.UpdatePipeline()
    bounds = cells.GetDataInformation().GetBounds()
    # Cells reach to the neighbours of their voxel, by one step of each axis at most.
    for n in range(3):
        assert places[2 * n] - 3.1 <= bounds[2 * n] <= places[2 * n], (n, bounds, places)
        assert places[2 * n + 1] <= bounds[2 * n + 1] <= places[2 * n + 1] + 3.1, (n, bounds, places)
    plane = simple.Slice(Input=reader)
    plane.SliceType.Normal = [0.0, 0.0, 1.0]
    plane.SliceType.Origin = [0.0, 0.0, -30.0]
    plane.UpdatePipeline()
    data = plane.GetDataInformation()
    assert data.GetNumberOfPoints() > 10000
    assert data.GetPointDataInformation().GetArrayInformation("SurfaceId").GetComponentRange(0) == (0.0, 3.0)
    for proxy in (cells, plane):
        simple.Delete(proxy)


def main():
    data, folder = (pathlib.Path(argument) for argument in sys.argv[1:3])
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / "blobs.vsm.gz"
    path.write_bytes(gzip.compress((data / "blobs.vsm").read_bytes()))
    reader = simple.OpenDataFile(str(path))
    assert type(reader).__name__ == "VerneySparseMatrixReader", reader
    reader.ColumnStep = [2 * math.cos(0.5), 2 * math.sin(0.5)]
    reader.RowStep = [-math.sin(0.5), math.cos(0.5)]
    view = simple.CreateView("RenderView")
    check_bounds(reader, check_types(reader, view))
    reader.HorizonStatus = ["Horizon 2"]
    show(reader, view)
    extent = reader.GetDataInformation().GetExtent()
    assert extent[4] > -60 and extent[5] < 0, extent
    reader.OutputType = "Points"
    kind, points, _ = show(reader, view)
    assert kind == "vtkPartitionedDataSetCollection" and 5900 < points < 6300, (kind, points)
    simple.Delete(view)


main()
