# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files: horizons in, horizons and meshes out."""

from __future__ import annotations

import contextlib
import os
import pathlib
import tempfile
import warnings
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from . import _core
from ._horizon import Horizon
from ._made import framing, in_keywords, placement
from ._made import horizons as make_horizons
from ._mesh import Mesh
from ._stages import Progress

GRIDS = {".irap": "irap", ".gri": "gri", ".zmap": "zmap"}
MESHES = {".ts": "ts", ".stl": "stl", ".ply": "ply", ".obj": "obj", ".dxf": "dxf"}


@contextlib.contextmanager
def _of_file(path: pathlib.Path) -> Iterator[None]:
    """Within the block errors name the file, and keywords."""
    try:
        yield
    except ValueError as error:
        raise ValueError("%s: %s" % (path, in_keywords(str(error)))) from None
    except RuntimeError as error:
        raise OSError("%s: %s" % (path, error)) from None


def read(path: str | os.PathLike[str], horizons: str | Sequence[str] | None = None, *, columns: str | Sequence[str] = "",
         nodata: str | float | Sequence[float] | None = None, header_lines: int = 0, duplicates: str = "strongest", gridding: str = "",
         leave_out_strays: bool = False, vertical_step: float | None = None, direction: str = "", vertical_unit: str = "",
         vertical_domain: str = "", horizontal_unit: str = "", coordinate_system: str = "",
         progress: Progress | None = None) -> dict[str, Horizon]:
    """Reads the horizons of a text file of picks or of a grid, by content.

    Parameters
    ----------
    path : str or path
        Sparse voxels (.vsm); picks of Petrel, OpendTect, Kingdom, Charisma, IESX and plain tables; grids of IRAP (text and binary), ZMAP, CPS-3,
        EarthVision, Surfer, GXF, ESRI and Storm; also compressed with gzip.
    horizons : str or list of str, optional
        Names of the horizons to return; all by default.
    columns : str or list of str, optional
        What the columns of a text file are, as "Inline Crossline X Y Z", where they are not found.
    nodata : number, list of numbers, or str, optional
        Values that mean no z, in addition to those of the format.
    header_lines : int
        Lines to skip at the beginning of a text file.
    duplicates : "strongest", "topmost", "lowest", "mean" or "sheets"
        Which pick of several in a column is kept; "sheets" makes horizons of the others.
    gridding : "" or "plate" or "nearest"
        Makes a grid of points that are on no lattice.
    leave_out_strays : bool
        Leaves out up to a tenth of the picks, off the lattice or far from the others.
    vertical_step : float, optional
        z between vertical indices; by default it suits the heights.
    direction : "down" or "up", optional
        Where z increases to, if the file does not say it.
    vertical_unit, vertical_domain, horizontal_unit, coordinate_system : str, optional
        Replace those of the file.
    progress : callable, optional
        Gets the fraction that is done; what it raises stops the work.

    Returns
    -------
    dict of Horizon by name

    Raises
    ------
    ValueError
        With the line or byte, if the file violates its format.
    FileNotFoundError
    """
    path = pathlib.Path(path)
    if not path.is_file():
        raise FileNotFoundError("%s: no such file" % path)
    name = str(path)
    where = framing(vertical_step, direction, vertical_unit, vertical_domain, horizontal_unit, coordinate_system)
    nulls = nodata if isinstance(nodata, str) else " ".join(map(repr, map(float, np.ravel([] if nodata is None else nodata))))
    with _of_file(path):
        kind = _core.find_format(name)
        if kind == "sparse":
            if vertical_step is not None:
                raise ValueError("vertical_step for sparse voxels, which have their own, expected none")
            form, found = _core.read_sparse(name, placement(duplicates)["duplicates"], *where[1:], progress)
        elif kind == "grid":
            form, found = _core.read_grid(name, nulls, *where, progress)
        else:
            text = columns if isinstance(columns, str) else " ".join(columns)
            form, found = _core.read_text(name, text, nulls or "usual", int(header_lines), placement(duplicates, gridding, leave_out_strays),
                                          *where, progress)
        made = make_horizons(found, pathlib.Path(path.name.removesuffix(".gz")).stem, form, path.name)
    if horizons is None:
        return made
    wanted = [horizons] if isinstance(horizons, str) else list(horizons)
    missing = [one for one in wanted if one not in made]
    if missing:
        raise ValueError("%s: no horizon %s, expected one of %s" % (path, missing[0], ", ".join(made)))
    return {one: made[one] for one in wanted}


def write(data: Horizon | Mesh, path: str | os.PathLike[str], *, name: str | None = None, progress: Progress | None = None) -> None:
    """Writes a mesh or a horizon in the format of the extension.

    Parameters
    ----------
    data : Mesh or Horizon
        Mesh for .ts (GOCAD), .stl, .ply, .obj and .dxf; horizon for the grids .irap, .gri (IRAP binary) and .zmap, and .csv.
    path : str or path
        A file of this name is replaced once the new one is complete. Grids say neither the unit nor the direction of z, and
        .gri is of single precision.
    name : str, optional
        Name of the surface in the file; by default that of the data.
    progress : callable, optional

    Raises
    ------
    ValueError
        If the format cannot hold the data.
    OSError
        If the file cannot be written.
    """
    path = pathlib.Path(path)
    kinds = {Mesh: MESHES, Horizon: {**GRIDS, ".csv": "csv"}}
    if type(data) not in kinds:
        raise TypeError("writing %s, expected a Mesh or a Horizon; a file has one" % type(data).__name__)
    form = kinds[type(data)].get(path.suffix.lower())
    if form is None:
        what = "mesh" if isinstance(data, Mesh) else "horizon"
        other = next((kind.__name__.lower() for kind, forms in kinds.items() if path.suffix.lower() in forms), "")
        raise ValueError("%s: a %s, expected %s" % (path, what, "a " + other if other else "one of the extensions " + ", ".join(kinds[type(data)])))
    if not path.absolute().parent.is_dir():
        raise FileNotFoundError("%s: no folder %s" % (path, path.absolute().parent))
    with _of_file(path), _replacing(path) as part:
        if isinstance(data, Mesh):
            _write_mesh(data, part, form, name or data.name, progress)
        elif form == "csv":
            _write_csv(data, part)
        else:
            lattice = data.lattice
            rounding = _core.write_grid(part, form, name or data.name, np.ascontiguousarray(data.grid().ravel()), lattice.shape[::-1],
                                        lattice.origin, lattice.column_step, lattice.row_step, progress)
            if rounding > 1e-3 * min(lattice.spacing):
                warnings.warn("%s: places are rounded to single precision, by up to %.3g; .irap keeps them" % (path, rounding), stacklevel=2)


@contextlib.contextmanager
def _replacing(path: pathlib.Path) -> Iterator[str]:
    """Gives a new file beside `path`, which takes its place at the end, and goes if there is an error."""
    handle, part = tempfile.mkstemp(prefix="." + path.name[:64], dir=path.absolute().parent)
    os.close(handle)
    try:
        yield part
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(part, 0o666 & ~mask)
        os.replace(part, path)
    except BaseException:
        os.unlink(part)
        raise


def _write_mesh(mesh: Mesh, part: str, form: str, name: str, progress: Progress | None) -> None:
    points = mesh.points
    if form == "ts" and mesh.direction == "down":  # The file says where z increases to.
        points = points * (1.0, 1.0, -1.0)
    numbers = {key: np.ascontiguousarray(values, np.float64) for key, values in mesh.attributes.items() if values.dtype.kind in "iuf"}
    survey = (mesh.vertical_unit, mesh.vertical_domain, mesh.horizontal_unit, mesh.coordinate_system)
    _core.write_mesh(part, form, name, np.ascontiguousarray(points), np.ascontiguousarray(mesh.triangles), numbers,
                     mesh.direction == "up", survey, progress)


def _write_csv(horizon: Horizon, part: str) -> None:
    """A table with names and all digits, as `read` takes it."""
    lines: dict[str, Any] = {} if horizon.lattice.lines is None else {"Inline": horizon.inlines, "Crossline": horizon.crosslines}
    z = "Elevation" if horizon.direction == "up" else "Z"
    table = {**lines, "X": horizon.x, "Y": horizon.y, z + (" (%s)" % horizon.vertical_unit if horizon.vertical_unit else ""): horizon.z,
             **{key: values for key, values in horizon.attributes.items() if values.dtype.kind in "iuf"}}
    with open(part, "w", encoding="utf-8") as file:
        print(*table, sep=",", file=file)
        for row in zip(*(values.tolist() for values in table.values())):
            print(*map(repr, row), sep=",", file=file)
