# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The package as functions: read, horizon, surface, every other stage, distance, layers, extract and write.

    import seismichorizons as sh

    for name, top in sh.read("picks.dat").items():
        sh.write(sh.surface(top, largest_error="2 ms"), name + ".ts")

Other stages are made from their classes (stages.py).
"""

from __future__ import annotations

import os
import pathlib
import types
from collections.abc import Sequence
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData, vtkUnstructuredGrid

from . import calls, cubes, heights, making, reading, tsurf, writing
from .calls import details  # noqa: F401: a function of the package
from .making import horizon, horizon_from_points  # noqa: F401: functions of the package
from .stage import make
from .stages import *  # functions of the package
from .stages import STAGES, apply
from .volumes import crossings, layers  # noqa: F401: functions of the package

DISTANCE_LABELS = ("reference to mesh", "mesh to reference", "both")


def read(path: str | os.PathLike, horizons: Sequence[str | int] | None = None, **keywords: Any) -> dict[str, vtkPolyData]:
    """The horizons of a file in any format that is known, by what is in it.

    Parameters
    ----------
    path : str or path
        picks, grids, sparse voxels, surfaces, tables; for SEG-Y there are `read_cube` and `extract`.
    horizons : list of str, optional
        the names of those wanted; all by default.
    **keywords
        properties of the reader of that format: `vertical_unit`, `vertical_direction`, `columns`, `gridding` and the like.

    Returns
    -------
    dict of str to vtkPolyData, or to pyvista.PolyData where PyVista is imported
        names and horizons, in the order of the file; of GOCAD surfaces the triangles.

    Raises
    ------
    FileNotFoundError, OSError
        there is no such file, or it cannot be read.
    ValueError
        it is in no format that is known, or wrong; the message says where, and what was expected.
    MemoryError
        it is larger than memory.

    Examples
    --------
    >>> import seismichorizons as sh
    >>> list(sh.read("sample.vsm"))
    ['Horizon 1', 'Horizon 2']
    """
    path = _existing(path)
    reader = reading.find_reader(path)
    if reader == cubes.READER:
        raise ValueError("%s: a seismic cube, expected horizons: extract(read_cube(path)) finds them" % path)
    with calls.python_errors():
        source = make(reader, FileName=str(path)) if reader == tsurf.READER else reading.open_file(path)
        calls.set_keywords(source, keywords)
        if horizons is not None:
            reading.select(source, horizons, path)
    calls.run(source, path.name)
    found = [(name, points) for name, points in reading.list_horizons(source.GetOutputDataObject(0))
             if source.GetHorizonStatus(name)]
    if not found:
        raise ValueError("%s: no points, expected those of a horizon at least" % path)
    if len(found) == 1 and found[0][0] is None:
        found = [(path.stem, found[0][1])]
    return {name: calls.wrap(points) for name, points in found}


def read_cube(path: str | os.PathLike, **keywords: Any) -> vtkImageData:
    """The samples of a SEG-Y file.

    Parameters
    ----------
    path : str or path
    **keywords
        properties of SEGYCubeReader: `inline_range`, `crossline_range`, `sample_range`, `inline_byte` and the like.

    Returns
    -------
    vtkImageData, or pyvista.ImageData where PyVista is imported
        with the array Amplitude of shape (samples, inlines, crosslines).

    Raises
    ------
    FileNotFoundError, OSError, ValueError, MemoryError
        as those of `read`.
    """
    path = _existing(path)
    reader = make(cubes.READER, FileName=str(path))
    calls.set_keywords(reader, keywords)
    calls.run(reader, path.name)
    return calls.wrap(reader.GetOutputDataObject(0))


def extract(cube: vtkImageData, picks: Any = None, limits: Any = None, **keywords: Any) -> dict[str, vtkPolyData]:
    """The reflections of a seismic cube, joined to horizons.

    Parameters
    ----------
    cube : vtkImageData
        what `read_cube` gives, or any image with amplitudes.
    picks : dict of str to vtkPolyData or to array of shape (n, 3), or one of these, optional
        some picks of each horizon that is wanted, in place of all horizons that there are; rows with nan are left out.
        z of arrays is as for `horizon_from_points`: time or depth, downwards, in a cube where these count downwards, as in
        those of `read_cube`; if none is positive, or in other cubes, world z, as points of data have.
    limits : the same, or a list of them, optional
        two horizons on the traces of the cube to search between, or one to search below, or above with
        `limit_side="Above"`.
    **keywords
        properties of SeismicReflectionExtraction: `largest_number` (20 by default), `polarity`, `position`, `joining`,
        `amplitude_percentile`, `smallest_size` and the like.

    Returns
    -------
    dict of str to vtkPolyData, or to pyvista.PolyData where PyVista is imported
        the strongest first; with picks the horizons that these ask for. Points have the arrays Origin, which is 0 where a
        pick is, 1 on a part that was taken and 2 where it grew, and GuideDistance in columns.

    Raises
    ------
    TypeError, ValueError, MemoryError
        no image, an image without amplitudes, one that is too large, or picks or limits that are not on it.

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> from vtkmodules.util.numpy_support import numpy_to_vtk
    >>> from vtkmodules.vtkCommonDataModel import vtkImageData
    >>> cube = vtkImageData()
    >>> cube.SetDimensions(30, 20, 40)
    >>> amplitudes = np.zeros((40, 20, 30))
    >>> amplitudes[9:12], amplitudes[25] = [[[1.0]], [[3.0]], [[1.0]]], 5.0
    >>> _ = cube.GetPointData().SetScalars(numpy_to_vtk(amplitudes.ravel(), deep=True))
    >>> {name: top.GetNumberOfPoints() for name, top in sh.extract(cube, {"Top": [[7, 3, 10]]}).items()}
    {'Top': 600}
    """
    if not isinstance(cube, vtkImageData):
        raise TypeError("%s, expected a cube as vtkImageData: read_cube(path) gives that of a SEG-Y file"
                        % type(cube).__name__)
    extraction = make(cubes.EXTRACTION, LargestNumber=cubes.LARGEST_NUMBER)
    calls.set_keywords(extraction, keywords, cube)
    extraction.SetInputDataObject(cube)
    counts_down = cubes.counts_down(cube)
    if picks is not None:
        extraction.SetInputDataObject(1, making.collect_picks(picks, counts_down))
    for horizons in limits if isinstance(limits, (list, tuple)) else [] if limits is None else [limits]:
        extraction.AddInputDataObject(2, making.collect_picks(horizons, counts_down))
    calls.run(extraction, "extract")
    return {name: calls.wrap(points) for name, points in reading.list_horizons(extraction.GetOutputDataObject(0))}


def surface(horizon: vtkPolyData, largest_error: float | str | None = None, triangles: int | None = None,  # noqa: F811
            **keywords: Any) -> vtkPolyData:
    """The mesh of a horizon, with parameters that are chosen from its points.

    Parameters
    ----------
    horizon : vtkPolyData
        points on a lattice, as `read`, `horizon`, `horizon_from_points` and `extract` give them.
    largest_error : float or str, optional
        how far a point may be from the mesh, vertically: in vertical indices, or with a unit, as "2 ms". By default, where
        there is no number of triangles, six times the noise of the heights.
    triangles : int, optional
        the most triangles there may be, in place of the error.
    **keywords
        properties of HorizonSurface: `radius`, `smallest_hole_size`, `minimum_patch_size` and the like.

    Returns
    -------
    vtkPolyData, or pyvista.PolyData where PyVista is imported
        triangles and outlines; `details` tells the errors, what was chosen, and the ledger: what is known, filled, bridged, extrapolated
        and left out. A warning names what is more than 0.1 % of the covered area.

    Raises
    ------
    TypeError, ValueError
        no horizon, both an error and a number of triangles, or a parameter out of its range.

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> mesh = sh.surface(sh.horizon(np.zeros((20, 30))), largest_error=1.0)
    >>> mesh.GetNumberOfPolys()
    2
    """
    if largest_error is not None and triangles is not None:
        raise ValueError("largest_error and triangles, expected one of them")
    target = {}
    if largest_error is not None:
        target = {"maximum_error": largest_error}
    elif triangles is not None:
        target = {"target": "NumberOfTriangles", "maximum_number_of_triangles": triangles}
    known = calls.properties(make("vtkHorizonSurface"))
    chosen = {"automatic_" + name: False for name in keywords if "automatic_" + name in known}
    return apply("vtkHorizonSurface", (horizon,), {**target, **chosen, **keywords})


class Distance(types.SimpleNamespace):
    """What `distance` found. `vertical` is the largest vertical distance; `reference` and `mesh` are the surfaces with the
    arrays Distance and VerticalDistance; `largest`, `mean`, `rms`, `percentile_95` and the like are over both directions, in the unit that was asked for, and
    `figures` is all of them by direction, as {"both": {"largest": ...}, ...}."""

    def __repr__(self):
        unit = getattr(self.vertical, "unit", "")
        return "Distance(vertical=%.6g%s, largest=%.6g, mean=%.6g, rms=%.6g)" % (
            self.vertical, " " + unit if unit else "", self.largest, self.mean, self.rms)


def distance(reference: vtkPolyData, mesh: vtkPolyData, unit: str | None = None, **keywords: Any) -> Distance:
    """How far a mesh is from a horizon, or from another mesh, in both directions.

    Parameters
    ----------
    reference : vtkPolyData
        a horizon, or a mesh.
    mesh : vtkPolyData
        a mesh.
    unit : {"Lattice", "World"}, optional
        that of distances: columns and vertical indices, or world units, which are the default for a mesh whose error was
        given with a unit.
    **keywords
        properties of HorizonSurfaceDistance: `samples_per_point` and the like.

    Returns
    -------
    Distance

    Raises
    ------
    TypeError, ValueError
        no meshes.

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> top = sh.horizon(np.zeros((20, 30)))
    >>> round(sh.distance(top, sh.surface(top)).largest, 6)
    0.0
    """
    for data in (reference, mesh):
        calls.require_points(data, "a horizon or a mesh")
    noted = heights.unit_of(mesh, heights.NOTED_UNIT)
    unit = unit or ("World" if noted else "Lattice")
    meter = make("vtkHorizonSurfaceDistance")
    calls.set_keywords(meter, {"distance_unit": unit, **keywords}, reference)
    meter.SetInputDataObject(0, reference)
    meter.SetInputDataObject(1, mesh)
    calls.run(meter, "distance")
    measured = [meter.GetOutputDataObject(port) for port in (0, 1)]
    fields = measured[0].GetFieldData()
    figures = {label: {} for label in DISTANCE_LABELS}
    for number in range(fields.GetNumberOfArrays()):
        name = fields.GetArrayName(number)
        array = fields.GetArray(number)
        if array is not None and array.GetNumberOfTuples() == len(DISTANCE_LABELS) and "Distance" in (name or ""):
            values = vtk_to_numpy(array)[:, ("Lattice", "World").index(unit)]
            for label, value in zip(DISTANCE_LABELS, values):
                figures[label][calls.snake(name.replace("Distance", ""))] = float(value)
    vertical = max(map(_largest_vertical, measured))
    if unit == "World" and noted:
        vertical = heights.Height.of(vertical * heights.per_index(mesh, noted) / (heights.step_of(mesh) or 1.0), noted)
    return Distance(vertical=vertical, reference=calls.wrap(measured[0]), mesh=calls.wrap(measured[1]), figures=figures,
                    **figures[DISTANCE_LABELS[-1]])


def _largest_vertical(measured):
    """Of a surface that was measured, where the other one is above or below it."""
    array = measured.GetPointData().GetArray("VerticalDistance")
    values = np.zeros(0) if array is None else np.abs(vtk_to_numpy(array))
    return float(values[np.isfinite(values)].max(initial=0.0))


def write(data: vtkPolyData, path: str | os.PathLike, name: str | None = None) -> None:
    """Writes a horizon or a mesh in the format of the extension of a file.

    Parameters
    ----------
    data : vtkPolyData
        a mesh for .vtp, .ts, .stl, .ply, .obj, .dxf and the grids .irap, .gri, .zmap and .tif; a horizon for .dat, .vsm
        and .vtp; cells of layers for .vtu, .msh, .inp and .disv.
    path : str or path
    name : str, optional
        that of the surface in the file; the name of the file without its extension by default.

    Raises
    ------
    ValueError
        another extension, or data that the format cannot hold.
    OSError
        the file cannot be written.

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> sh.write(sh.surface(sh.horizon(np.zeros((20, 30)))), "top.ts")
    """
    calls.require_data(data, "a horizon or a mesh")
    path = pathlib.Path(path)
    form = path.suffix[1:]
    is_of_cells = isinstance(data, vtkUnstructuredGrid)
    forms = (*writing.LAYER_FORMATS, "vtu") if is_of_cells else tuple(writing.WRITERS)
    if form not in forms:
        raise ValueError("%s: the extension %s, expected one of .%s" % (path, path.suffix or "is missing", ", .".join(forms)))
    if not is_of_cells and form not in writing.POINT_FORMATS and form != "vtp" and not data.GetNumberOfPolys():
        raise ValueError("%s: a horizon without triangles, expected a mesh: surface(horizon) makes one" % path)
    if not path.absolute().parent.is_dir():
        raise FileNotFoundError("%s: folder \"%s\" does not exist" % (path, path.absolute().parent))
    with calls.python_errors():
        told = writing.write_cells(data, path) if is_of_cells else writing.write_data(data, path, name or path.stem)
    for text in told:
        calls.warn(text)


def _existing(path):
    """A file. Raises FileNotFoundError and ValueError."""
    path = pathlib.Path(path)
    reading.require_text(path)
    if not os.path.lexists(path):
        raise FileNotFoundError("%s: no such file" % path)
    return path


__all__ = ["crossings", "details", "distance", "extract", "horizon", "horizon_from_points", "layers", "read", "read_cube", "surface", "write",
           *STAGES]
