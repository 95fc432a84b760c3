# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The functions of the package: read, horizon, surface, the other stages, distance, layers, extract and write.

    import seismichorizons as sh

    for name, top in sh.read("picks.dat").items():
        sh.write(sh.surface(top, largest_error="2 ms"), name + ".ts")

The functions of the other stages are generated from their classes (stages.py).
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
    """Reads the horizons of a file; the format is recognized by the content.

    Parameters
    ----------
    path : str or path
        File of picks, a grid, sparse voxels, surfaces or a table. For SEG-Y use `read_cube` and `extract`.
    horizons : list of str, optional
        Names of the horizons to read; all by default.
    **keywords
        Properties of the reader of the format, such as `vertical_unit`, `vertical_direction`, `columns` or `gridding`.

    Returns
    -------
    dict of str to vtkPolyData, or to pyvista.PolyData if PyVista is imported
        Horizons by name, in the order of the file. For GOCAD surfaces, the triangles.

    Raises
    ------
    FileNotFoundError, OSError
        If the file does not exist or cannot be read.
    ValueError
        If the format is unknown or the content is invalid. The message gives the place and what was expected.
    MemoryError
        If the data do not fit in memory.

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
    """Reads the samples of a SEG-Y file.

    Parameters
    ----------
    path : str or path
        SEG-Y file.
    **keywords
        Properties of SEGYCubeReader, such as `inline_range`, `crossline_range`, `sample_range` or `inline_byte`.

    Returns
    -------
    vtkImageData, or pyvista.ImageData if PyVista is imported
        Image with the array Amplitude of shape (samples, inlines, crosslines).

    Raises
    ------
    FileNotFoundError, OSError, ValueError, MemoryError
        As for `read`.
    """
    path = _existing(path)
    reader = make(cubes.READER, FileName=str(path))
    calls.set_keywords(reader, keywords)
    calls.run(reader, path.name)
    return calls.wrap(reader.GetOutputDataObject(0))


def extract(cube: vtkImageData, picks: Any = None, limits: Any = None, **keywords: Any) -> dict[str, vtkPolyData]:
    """Extracts the reflections of a seismic cube and joins them to horizons.

    Parameters
    ----------
    cube : vtkImageData
        Cube from `read_cube`, or any image with amplitudes.
    picks : dict of str to vtkPolyData or to array of shape (n, 3), or a single such value, optional
        Some picks of each horizon to extract; without picks, all horizons are extracted. Rows with nan are ignored. z of
        arrays is interpreted as by `horizon_from_points`: as time or depth, increasing downwards, if the vertical indices
        of the cube increase downwards, as in cubes from `read_cube`. If no z is positive, or in other cubes, z is world
        z, as for points of datasets.
    limits : same types as picks, or a list of them, optional
        Horizons on the traces of the cube that bound the search: two horizons to search between, or one to search below
        it, or above it with `limit_side="Above"`.
    **keywords
        Properties of SeismicReflectionExtraction, such as `largest_number` (20 by default), `polarity`, `position`,
        `joining`, `amplitude_percentile` or `smallest_size`.

    Returns
    -------
    dict of str to vtkPolyData, or to pyvista.PolyData if PyVista is imported
        Horizons by name, strongest first; with picks, the horizons that the picks belong to. Points have the arrays
        Origin (0 at a pick, 1 on an extracted surface that was taken, 2 where the horizon was grown) and GuideDistance, to
        the nearest pick, in columns.

    Raises
    ------
    TypeError, ValueError, MemoryError
        If `cube` is not an image, has no amplitudes or is too large, or if picks or limits are outside it.

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
    """Makes a triangle mesh of a horizon, with parameters chosen from its points.

    Parameters
    ----------
    horizon : vtkPolyData
        Points on a lattice, as returned by `read`, `horizon`, `horizon_from_points` and `extract`.
    largest_error : float or str, optional
        Largest vertical distance of a point from the mesh, in vertical indices or with a unit such as "2 ms". Without a
        number of triangles, the default is six times the noise of the heights.
    triangles : int, optional
        Largest number of triangles, as an alternative to the error.
    **keywords
        Properties of HorizonSurface, such as `radius`, `smallest_hole_size` or `minimum_patch_size`.

    Returns
    -------
    vtkPolyData, or pyvista.PolyData if PyVista is imported
        Triangles and outlines. `details` reports the errors, the chosen parameters and the ledger of known, filled,
        bridged, extrapolated and left-out columns. A warning reports ledger entries above 0.1 % of the covered area.

    Raises
    ------
    TypeError, ValueError
        If `horizon` is not a horizon, if both an error and a number of triangles are given, or if a parameter is out of
        range.

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
    """Result of `distance`.

    Attributes
    ----------
    vertical : float
        Largest vertical distance.
    reference, mesh : vtkPolyData
        The two surfaces, with the arrays Distance and VerticalDistance.
    largest, mean, rms, percentile_95, ... : float
        Distances over both directions, in the unit.
    unit : {"Lattice", "World"}
        Unit of the distances.
    figures : dict of str to dict
        All figures by direction: {"both": {"largest": ...}, ...}.
    """

    def __repr__(self):
        unit = getattr(self.vertical, "unit", "")
        return "Distance(vertical=%.6g%s, largest=%.6g, mean=%.6g, rms=%.6g, unit=%s)" % (
            self.vertical, " " + unit if unit else "", self.largest, self.mean, self.rms, self.unit)


def distance(reference: vtkPolyData, mesh: vtkPolyData, unit: str | None = None, **keywords: Any) -> Distance:
    """Measures how far a mesh is from a horizon, or from another mesh, in both directions.

    Parameters
    ----------
    reference : vtkPolyData
        Horizon or mesh.
    mesh : vtkPolyData
        Mesh.
    unit : {"Lattice", "World"}, optional
        Unit of distances: columns and vertical indices, or world units. World is the default if the error of the mesh was
        given with a unit, Lattice otherwise.
    **keywords
        Properties of HorizonSurfaceDistance, such as `samples_per_point`.

    Returns
    -------
    Distance
        Largest, mean and other distances, and both surfaces with their distances.

    Raises
    ------
    TypeError, ValueError
        If an argument is not a horizon or a mesh.

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
    return Distance(vertical=vertical, reference=calls.wrap(measured[0]), mesh=calls.wrap(measured[1]), figures=figures, unit=unit,
                    **figures[DISTANCE_LABELS[-1]])


def _largest_vertical(measured):
    """Largest vertical distance of a measured surface from the other one, over all points above or below it."""
    array = measured.GetPointData().GetArray("VerticalDistance")
    values = np.zeros(0) if array is None else np.abs(vtk_to_numpy(array))
    return float(values[np.isfinite(values)].max(initial=0.0))


def write(data: vtkPolyData, path: str | os.PathLike, name: str | None = None) -> None:
    """Writes a horizon or a mesh in the format of the file extension.

    Parameters
    ----------
    data : vtkPolyData
        Mesh for .vtp, .ts, .stl, .ply, .obj, .dxf and the grids .irap, .gri, .zmap and .tif; horizon for .dat, .vsm and
        .vtp; cells of layers for .vtu, .msh, .inp and .disv.
    path : str or path
        File to write.
    name : str, optional
        Name of the surface in the file; by default, the file name without its extension.

    Raises
    ------
    ValueError
        If the extension is unknown, or the format cannot hold the data.
    OSError
        If the file cannot be written.

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
    if not is_of_cells and form in writing.MESH_FORMATS and form != "vtp" and not data.GetNumberOfPolys():
        raise ValueError("%s: a horizon without triangles, expected a mesh: surface(horizon) makes one" % path)
    if not path.absolute().parent.is_dir():
        raise FileNotFoundError("%s: folder \"%s\" does not exist" % (path, path.absolute().parent))
    with calls.python_errors():
        messages = writing.write_cells(data, path) if is_of_cells else writing.write_data(data, path, name or path.stem)
    for text in messages:
        calls.warn(text)


def _existing(path):
    """Returns the path of an existing file. Raises FileNotFoundError or ValueError."""
    path = pathlib.Path(path)
    reading.require_text(path)
    if not os.path.lexists(path):
        raise FileNotFoundError("%s: no such file" % path)
    return path


__all__ = ["crossings", "details", "distance", "extract", "horizon", "horizon_from_points", "layers", "read", "read_cube",
           "surface", "write", *STAGES]
