# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files: horizons in, horizons and meshes out."""

from __future__ import annotations

import contextlib
import os
import pathlib
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from . import _core, _gdal, _xml
from ._data import Progress, in_keywords, nulls_of, require_file, stem, warn_all
from ._horizon import Horizon
from ._lines import Lines
from ._made import framing, placement
from ._made import horizons as make_horizons
from ._mesh import Mesh, mesh_of

# Formats by extension, and what they hold.
FORMATS = {".vtp": ("vtp", "any"), ".ts": ("ts", "mesh"), ".dxf": ("dxf", "mesh"), ".stl": ("stl", "mesh"), ".ply": ("ply", "mesh"), ".obj": ("obj", "mesh"),
           ".irap": ("irap", "any"), ".gri": ("gri", "any"), ".zmap": ("zmap", "any"), ".cps3": ("cps3", "any"), ".grd": ("grd", "any"),
           ".asc": ("asc", "any"), ".tif": ("tif", "any"), ".dat": ("text", "any"), ".txt": ("text", "any"),
           ".vsm": ("vsm", "horizon")}


@contextlib.contextmanager
def _of_file(path: pathlib.Path) -> Iterator[None]:
    """Within the block errors name the file, and keywords."""
    try:
        yield
    except ValueError as error:
        raise ValueError("%s: %s" % (path, in_keywords(str(error)))) from None
    except OSError as error:
        raise OSError("%s: %s" % (path, error)) from None


def read(path: str | os.PathLike[str], horizons: str | Sequence[str] | None = None, *, columns: str | Sequence[str] = "",
         nodata: str | float | Sequence[float] | None = None, header_lines: int = 0, where: str = "", duplicates: str = "strongest", gridding: str = "",
         origin: Sequence[float] | None = None, column_step: Sequence[float] | None = None, row_step: Sequence[float] | None = None,
         leave_out_strays: bool = False, rows: tuple[int, int] | None = None, vertical_step: float | None = None, direction: str = "",
         vertical_unit: str = "", vertical_domain: str = "", horizontal_unit: str = "", coordinate_system: str = "",
         progress: Progress | None = None) -> dict[str, Horizon]:
    """Reads the horizons of a text file of picks, a grid, or sparse voxels. The format is recognised by content.

    Parameters
    ----------
    path : str or path
        Sparse voxels (.vsm); picks of Petrel, OpendTect, Kingdom, Charisma and IESX, and plain tables; grids of IRAP
        (text and binary), ZMAP, CPS-3, EarthVision, Surfer, GXF, ESRI and Storm; GeoTIFF, with GDAL. Files may be
        compressed with gzip.
    horizons : str or list of str, optional
        Names of the horizons to return; all by default.
    columns : str or list of str, optional
        Columns of a text file, as "Inline Crossline X Y Z", if they are not recognised.
    nodata : number, list of numbers, or str, optional
        Values that mark missing z, in addition to those of the format.
    header_lines : int
        Lines to skip at the beginning of a text file.
    where : str, optional
        Reads only the lines of a text file with this value in this column, as "feature_name=Top".
    duplicates : "strongest", "topmost", "lowest", "mean" or "sheets"
        Which of several picks in a column is kept; "sheets" makes separate horizons of them.
    gridding : "" or "plate" or "nearest"
        Grids points that are on no lattice, with a smooth plate or the nearest point.
    origin, column_step, row_step : (x, y), optional
        The lattice of a text file: position of a column, or of the first number of a matrix of heights, and steps to
        the next column and row (or number and line); found by default.
    leave_out_strays : bool
        Leaves out picks off the lattice or far from the others, up to a tenth of them.
    rows : (first, last), optional
        Reads only these rows of sparse voxels, for a horizon larger than memory.
    vertical_step : float, optional
        z between vertical indices; by default derived from the heights.
    direction : "down" or "up", optional
        Direction in which z increases, if the file does not state it.
    vertical_unit, vertical_domain, horizontal_unit, coordinate_system : str, optional
        Override those of the file.
    progress : callable, optional
        Called with the fraction done; an exception in it stops the work.

    Returns
    -------
    dict of Horizon by name

    Raises
    ------
    ValueError
        If the file violates its format; the message gives the line or byte.
    FileNotFoundError
    """
    path = pathlib.Path(path)
    require_file(path)
    name = str(path)
    lattice: dict[str, Any] = {name: value for name, value in (("origin", origin), ("column_step", column_step), ("row_step", row_step)) if value is not None}
    frame = framing(vertical_step, direction, vertical_unit, vertical_domain, horizontal_unit, coordinate_system)
    nulls = nulls_of(nodata)
    if _is_tiff(path):
        if where or lattice:
            raise ValueError("%s: where, origin, column_step or row_step for a GeoTIFF, expected none" % path)
        return _choose(path, _read_image(path, frame, placement(duplicates, gridding, leave_out_strays), progress), horizons)
    with _of_file(path):
        kind = _core.find_format(os.fsencode(path))
        if kind == "tsurf":
            _core.read_tsurfs(name, progress)  # which says what other files of GOCAD are
            raise ValueError("a mesh in the format of GOCAD, expected picks or a grid: read_mesh(path) reads it")
        if kind == "cube":
            raise ValueError("a seismic cube, expected picks or a grid: extract(read_cube(path)) finds horizons")
        if rows is not None and (kind != "sparse" or duplicates == "sheets"):
            raise ValueError("rows of %s, expected none" % (
                "sheets" if kind == "sparse" else "a file without sparse voxels"))
        if kind in ("sparse", "grid") and (where or lattice):
            raise ValueError("where, origin, column_step or row_step for %s, expected none" % ("sparse voxels" if kind == "sparse" else "a grid"))
        if kind == "sparse":
            if vertical_step is not None:
                raise ValueError("vertical_step for sparse voxels, which have their own, expected none")
            form, found = "sparse voxels", _read_sparse(name, placement(duplicates)["duplicates"], rows, *frame[1:], progress)
        elif kind == "grid":
            form, found = _core.read_grid(name, nulls, *frame, progress)
        else:
            text = columns if isinstance(columns, str) else " ".join(columns)
            form, found = _core.read_text(name, text, nulls or _core.DEFAULT_NULLS, int(header_lines), where,
                                          placement(duplicates, gridding, leave_out_strays, **lattice), *frame, progress)
        made = make_horizons(found, stem(path), form, path.name)
    return _choose(path, made, horizons)


def _is_tiff(path: pathlib.Path) -> bool:
    with open(path, "rb") as file:
        return file.read(4) in _gdal.BEGINNINGS


def _read_image(path: pathlib.Path, frame: Any, placing: dict[str, Any], progress: Progress | None) -> dict[str, Any]:
    """The horizon of a GeoTIFF."""
    arrays, own = _gdal.read_image(path)
    step, direction, (*units, system) = frame
    lattice = {name: own[name] for name in ("origin", "column_step", "row_step")}
    with _of_file(path):
        found = _core.place_points(arrays, {}, [path.stem], {**placing, **lattice}, step, direction or own["direction"],
                                   (*units, system or own["coordinate_system"]), progress)
    return make_horizons(found, path.stem, "GeoTIFF", path.name)


def _read_sparse(path: str, duplicates: str, rows: tuple[int, int] | None, direction: str, survey: Any, progress: Progress | None) -> tuple[Any, str, list[str]]:
    """Horizons with the real z of the file or, if it has none, vertical indices; a description; and warnings."""
    file = _core.SparseFile(path, rows is not None)
    file.list({"duplicates": duplicates, **({} if rows is None else {"rows": list(rows)})}, progress)
    found = file.take(list(range(len(file.names))), {"use_real_z": file.has_real_z}, direction, survey, progress)
    size = found[0][1]["field_data"]["LatticeDimensions"].ravel().tolist() if found else (0, 0, 0)
    return found, "%d x %d columns, places are their numbers\nz is %s, and increases %s" % (
        *size[:2], "real z of the file" if file.has_real_z else "the vertical index", "upwards" if direction == "up" else "downwards"), []


def _choose(path: pathlib.Path, made: dict[str, Any], names: str | Sequence[str] | None) -> dict[str, Any]:
    if names is None:
        return made
    wanted = [names] if isinstance(names, str) else list(names)
    missing = [one for one in wanted if one not in made]
    if missing:
        raise ValueError("%s: no horizon %s, expected one of %s" % (path, missing[0], ", ".join(made)))
    return {one: made[one] for one in wanted}


def read_mesh(path: str | os.PathLike[str], horizons: str | Sequence[str] | None = None, *,
              progress: Progress | None = None) -> dict[str, Mesh]:
    """Reads the surfaces of a GOCAD TSurf file.

    Parameters
    ----------
    path : str or path
    horizons : str or list of str, optional
        Names of the surfaces to return; all by default.
    progress : callable, optional

    Returns
    -------
    dict of Mesh by name

    Raises
    ------
    ValueError
        If the file violates its format; the message gives the line.
    FileNotFoundError
    """
    path = pathlib.Path(path)
    require_file(path)
    with _of_file(path):
        found, _ = _core.read_tsurfs(str(path), progress)
    made = {name: mesh_of(name, {**data, "point_data": {}, "cell_data": {}}, dict(data["point_data"]), data["field_data"], None)
            for name, data in found}
    return _choose(path, made, horizons)


# Formats of fault lines.
LINE_FORMATS = (".dat", ".txt", ".csv", ".pl", ".pol", _gdal.WRITTEN_LINES)


def _write_lines(lines: Lines, path: pathlib.Path, direction: str, progress: Progress | None) -> None:
    if path.suffix.lower() not in LINE_FORMATS:
        raise ValueError("%s: lines, expected one of the extensions %s" % (path, ", ".join(LINE_FORMATS)))
    with _of_file(path):
        if path.suffix.lower() == _gdal.WRITTEN_LINES:
            _core.write_contents(str(path), [("", _gdal.map_of_lines(lines, path, direction or lines.direction))])
        else:
            _core.write_faults(str(path), [(path.stem, lines._data())], direction or "as_read", progress)


def _write_images(many: Mapping[Any, Any], path: pathlib.Path, name: str | None, direction: str, progress: Progress | None) -> None:
    images = []
    for key, one in many.items():
        with _of_file(path):
            content, messages = _gdal.image(one._data_of_file(), path, direction or one.direction, progress)
        images.append((name or (key if isinstance(key, str) else one.name), content))
        warn_all(path, messages)
    with _of_file(path):
        _core.write_contents(str(path), images)


def write(data: Any, path: str | os.PathLike[str], *, name: str | None = None, with_borders: bool = False,
          with_attributes: bool = True, direction: str = "", progress: Progress | None = None) -> None:
    """Writes meshes, horizons or lines; the extension selects the format.

    Parameters
    ----------
    data : Mesh, Horizon, or a list or dict of these; or Lines
        Meshes and horizons as .vtp (VTK, with all arrays). Meshes as .ts (GOCAD), .stl, .ply, .obj and .dxf. Horizons,
        and meshes with a lattice, as the grids .irap, .gri (IRAP binary), .zmap, .cps3, .grd (Surfer), .asc (Esri,
        elevations) and, with GDAL, .tif (GeoTIFF), and as the tables .dat and .txt; `to_dataframe().to_csv` writes
        .csv. Horizons as .vsm (sparse voxels). Fault lines as .dat, .txt and .csv (tables), .pl (GOCAD), .pol (IRAP,
        one file per fault) and, with GDAL, .gpkg (GeoPackage). Several surfaces share a file of .ts, .dxf, .dat, .txt
        and .vsm; in other formats, each has a file of its own, with its name appended to that of `path`.
    path : str or path
        An existing file is replaced only when the new one is complete. Grids store neither the unit nor the direction
        of z, and .gri is in single precision.
    name : str, optional
        Name of the surface in the file; by default the name of the data.
    with_borders : bool
        Writes border lines to .ts files.
    with_attributes : bool
        Writes attributes to tables.
    direction : "down" or "up", optional
        Direction in which z increases in the file; by default as in the data.
    progress : callable, optional

    Raises
    ------
    ValueError
        If the format cannot hold the data.
    OSError
        If the file cannot be written.
    """
    path = pathlib.Path(path)
    if direction not in ("", "down", "up"):
        raise ValueError("direction '%s', expected down or up" % direction)
    if isinstance(data, Lines):
        _write_lines(data, path, direction, progress)
        return
    many = dict(data) if isinstance(data, Mapping) else {n: one for n, one in enumerate(data)} if isinstance(data, (list, tuple)) else {0: data}
    for one in many.values():
        if not isinstance(one, (Mesh, Horizon)):
            own = ": it has a method write of its own" if hasattr(one, "write") else ""
            raise TypeError("writing %s, expected a Mesh or a Horizon, or a list or dict of these, or Lines%s" % (type(one).__name__, own))
    form, holds = FORMATS.get(path.suffix.lower(), ("", ""))
    for one in many.values():
        what = "mesh" if isinstance(one, Mesh) else "horizon"
        if holds not in (what, "any"):
            endings = ", ".join(ending for ending, (_, kind) in FORMATS.items() if kind in (what, "any"))
            raise ValueError("%s: a %s, expected %s" % (path, what, "a " + holds if holds else "one of the extensions " + endings))
        if holds == "any" and form != "vtp" and one.lattice is None:
            raise ValueError("%s: %s has no lattice, expected the mesh of a horizon; horizon-mesh --formats %s meshes surfaces of others again" % (path, one.name, path.suffix[1:].lower()))
    if not path.absolute().parent.is_dir():
        raise FileNotFoundError("%s: no folder %s" % (path, path.absolute().parent))
    way = direction or (next(iter(many.values())).direction if many else "down")
    options = {"with_borders": bool(with_borders), "is_down": way == "down", "with_attributes": bool(with_attributes), "sense": direction or "as_read"}
    if form == "vtp":
        with _of_file(path):
            _core.write_contents(str(path), [(name or (key if isinstance(key, str) else one.name), _xml.poly_data(one._data_of_vtk()))
                                             for key, one in many.items()])
        return
    if form == "tif":
        _write_images(many, path, name, direction, progress)
        return
    named = [(name or (key if isinstance(key, str) else one.name), one._data_of_file()) for key, one in many.items()]
    with _of_file(path):
        messages = _core.write(str(path), form, named, options, progress)
    warn_all(path, messages)
