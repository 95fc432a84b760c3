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

# How many surfaces of a cube become meshes, the strongest ones.
LARGEST_NUMBER = 20
# Bytes per sample, at most, of a cube whose reflections are joined, its own included (ReflectionBenchmark).
WORKED = 20
WORKED_WITH_PICKS = 45


def is_named_so(path):
    """Whether the name of a file says that it is SEG-Y, whatever is in it."""
    return pathlib.Path(path).suffix.lower() in (".sgy", ".segy")


def is_extraction(source):
    return source.IsA(EXTRACTION)


def open_cube(path, Picks=None, Limits=(), **properties):
    """The extraction from a cube, connected to its reader. Properties are those of both, and files that are kept as
    `picks` and `limits`. Raises HorizonError when neither has one."""
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
    """How many samples will be read, from the headers. Raises HorizonError."""
    reader = extraction.GetInputAlgorithm()
    with watched(reader):
        reader.UpdateInformation()
    extent = reader.GetOutputInformation(0).Get(reader.GetExecutive().WHOLE_EXTENT())
    return (extent[1] - extent[0] + 1) * (extent[3] - extent[2] + 1) * (extent[5] - extent[4] + 1)


def read(extraction, path):
    """Reads the cube; an error is then that of its reader. Returns the seconds it took. Raises HorizonError."""
    return update(extraction.GetInputAlgorithm(), "%s: reading the cube" % path.name, work=file_work(path))


def counts_down(cube):
    """Whether vertical indices of an image count downwards in the world, by its field data, or else its axes."""
    direction = cube.GetFieldData().GetArray("VerticalDirection")
    if direction is not None and direction.GetNumberOfValues():
        return direction.GetTuple1(0) < 0
    return cube.GetSpacing()[2] * cube.GetDirectionMatrix().GetElement(2, 2) < 0


def lattice_properties(extraction):
    """Properties of readers of picks, by which these stand on the columns of a cube that has been read. Picks of wells and of
    other surveys are between columns. z counts as that of the cube; where it is downwards, negative z are above 0 all the
    same."""
    data = extraction.GetInputAlgorithm().GetOutputDataObject(0).GetFieldData()
    matrix = vtk_to_numpy(data.GetArray("LatticeToWorld")).reshape(4, 4)
    return {"Origin": matrix[:2, 3].tolist(), "ColumnStep": matrix[:2, 0].tolist(), "RowStep": matrix[:2, 1].tolist(),
            "LatticeTolerance": 0.499, "StrayPicks": "LeaveOut",
            "VerticalDirection": "Up" if data.GetArray("VerticalDirection").GetValue(0) > 0 else "Automatic"}


def require(extraction, budget, path):
    """Raises HorizonError where the cube and its picks do not fit in memory."""
    size = (WORKED_WITH_PICKS if extraction.picks else WORKED) * count_samples(extraction)
    budget.require_bytes(size, "%s: a cube that takes %s with its picks" % (path, size_text(size)),
                         "; --inlines and --crosslines read a part")
