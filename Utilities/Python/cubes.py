# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Seismic cubes: the reflections of a SEG-Y file, joined to horizons."""

import pathlib

from vtkmodules.util.numpy_support import vtk_to_numpy

from .memory import size_text
from .progress import file_work
from .stage import HorizonError, configure, make, update, watched

READER = "vtkSEGYCubeReader"
EXTRACTION = "vtkSeismicReflectionExtraction"

# Number of surfaces of a cube that become meshes, strongest first.
LARGEST_NUMBER = 20
# Peak memory in bytes per sample, cube included, while reflections are joined (ReflectionBenchmark).
WORKED = 20
WORKED_WITH_PICKS = 45


def is_named_so(path):
    """Whether a file has the extension of SEG-Y, whatever it contains."""
    return pathlib.Path(path).suffix.lower() in (".sgy", ".segy")


def is_extraction(source):
    return source.IsA(EXTRACTION)


def open_cube(path, Picks=None, Limits=(), **properties):
    """Returns the extraction from a cube, connected to its reader. Properties belong to either of them; the files of picks
    and limits are kept as `picks` and `limits`. Raises HorizonError for a property that neither has."""
    reader = make(READER, FileName=str(path))
    extraction = make(EXTRACTION, LargestNumber=LARGEST_NUMBER)
    extraction.picks, extraction.limits = Picks, Limits
    extraction.SetInputConnection(reader.GetOutputPort())
    for name, value in properties.items():
        owner = next((owner for owner in (reader, extraction) if hasattr(owner, "Set" + name)), None)
        if owner is None:
            raise HorizonError("%s: a seismic cube does not support %s" % (path, name))
        configure(owner, **{name: value})
    return extraction


def count_samples(extraction):
    """Returns the number of samples to read, from the headers. Raises HorizonError."""
    reader = extraction.GetInputAlgorithm()
    with watched(reader):
        reader.UpdateInformation()
    extent = reader.GetOutputInformation(0).Get(reader.GetExecutive().WHOLE_EXTENT())
    return (extent[1] - extent[0] + 1) * (extent[3] - extent[2] + 1) * (extent[5] - extent[4] + 1)


def read(extraction, path):
    """Reads the cube and returns the time in seconds. Raises HorizonError with the error of the reader."""
    return update(extraction.GetInputAlgorithm(), "%s: reading the cube" % path.name, work=file_work(path))


def counts_down(cube):
    """Whether the vertical indices of an image increase downwards, by its field data or, without them, by its axes."""
    direction = cube.GetFieldData().GetArray("VerticalDirection")
    if direction is not None and direction.GetNumberOfValues():
        return direction.GetTuple1(0) < 0
    return cube.GetSpacing()[2] * cube.GetDirectionMatrix().GetElement(2, 2) < 0


def lattice_properties(extraction):
    """Returns the properties that make a reader place picks on the columns of a cube that has been read; well picks and
    other surveys lie between columns. z has the direction of the cube; if that is downwards, negative z still lies above 0."""
    data = extraction.GetInputAlgorithm().GetOutputDataObject(0).GetFieldData()
    matrix = vtk_to_numpy(data.GetArray("LatticeToWorld")).reshape(4, 4)
    return {"Origin": matrix[:2, 3].tolist(), "ColumnStep": matrix[:2, 0].tolist(), "RowStep": matrix[:2, 1].tolist(),
            "LatticeTolerance": 0.499, "StrayPicks": "LeaveOut",
            "VerticalDirection": "Up" if data.GetArray("VerticalDirection").GetValue(0) > 0 else "Automatic"}


def require(extraction, budget, path):
    """Raises HorizonError if the cube and its picks do not fit in memory."""
    size = (WORKED_WITH_PICKS if extraction.picks else WORKED) * count_samples(extraction)
    budget.require_bytes(size, "%s: a cube that takes %s with its picks" % (path, size_text(size)),
                         "; --inlines and --crosslines read a part")
