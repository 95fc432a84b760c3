# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Seismic cubes, and horizons tracked in them."""

from __future__ import annotations

import dataclasses
import os
import pathlib
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._data import Data, Progress, call, give_survey, in_keywords, require_file, stem, survey
from ._files import read
from ._horizon import Floats, Horizon, Lattice, horizon_of
from ._made import framing, horizons, placement
from ._stages import given_options


@dataclasses.dataclass(eq=False, repr=False)
class Cube:
    """Amplitudes of a seismic survey.

    Attributes
    ----------
    values : array of shape (rows, columns, samples)
        Rows are inlines. nan where there is no sample. Values are meaningless where `known` is False; `read_cube` sets
        them to 0. Of shape (0, 0, 0) if samples stay in the file (`load=False`).
    lattice : Lattice
        The lattice of the traces, with samples as vertical indices.
    known : bool array of the same shape, or None
        None where all samples are known.
    line : float64 array of shape (rows, columns, 2), or None
        x and y of each trace of a single line, which need not be on the lattice. Horizons have them as the attributes
        LineX and LineY.
    name : str
    direction : "down" or "up"
        Direction in which the sample number increases.
    vertical_unit, vertical_domain, horizontal_unit, coordinate_system : str
        Empty where unknown.
    taken : tuple of str
        How the file was interpreted, line by line.
    """

    values: NDArray[Any]
    lattice: Lattice
    known: NDArray[np.bool_] | None = None
    line: Floats | None = None
    name: str = "cube"
    direction: str = "down"
    vertical_unit: str = ""
    vertical_domain: str = ""
    horizontal_unit: str = ""
    coordinate_system: str = ""
    taken: tuple[str, ...] = ()
    _file: _core.CubeFile | None = None

    def __post_init__(self) -> None:
        if self._file is not None:
            return
        if np.ndim(self.values) != 3:
            raise ValueError("values of %d axes, expected (rows, columns, samples)" % np.ndim(self.values))
        expected = (*self.lattice.shape, self.lattice.indices)
        if np.shape(self.values) != expected:
            raise ValueError("values of shape %s, expected %s of the lattice" % (np.shape(self.values), expected))

    def __repr__(self) -> str:
        (rows, columns), samples = self.lattice.shape, self.lattice.indices
        first, step = self.lattice.first_z, self.lattice.vertical_step
        unit = " " + self.vertical_unit if self.vertical_unit else ""
        step_unit = " " + self.horizontal_unit if self.horizontal_unit else ""
        return "Cube %s: %d columns x %d rows, %.6g x %.6g%s apart, %d samples from %.6g to %.6g%s" % (
            self.name, columns, rows, *self.lattice.spacing, step_unit, samples, first, first + step * (samples - 1), unit)

    @property
    def sign(self) -> int:
        """1 if z increases upwards, otherwise -1."""
        return 1 if self.direction == "up" else -1

    def _data(self) -> Data:
        (ax, ay), (bx, by), (x, y) = self.lattice.column_step, self.lattice.row_step, self.lattice.origin
        (rows, columns), samples = self.lattice.shape, self.lattice.indices
        to_world = (ax, bx, 0.0, x, ay, by, 0.0, y, 0.0, 0.0, self.sign * self.lattice.vertical_step,
                    self.sign * self.lattice.first_z, 0.0, 0.0, 0.0, 1.0)
        fields = {"LatticeDimensions": np.array([columns, rows, samples], np.int32), "LatticeToWorld": np.array(to_world), **give_survey(self)}
        if self.lattice.lines is not None:
            fields["LineNumbers"] = np.array(self.lattice.lines)
        data = {"extent": [0, columns - 1, 0, rows - 1, 0, samples - 1], "to_world": to_world, "field_data": fields}
        if self._file is not None:
            return {**data, "file": self._file}
        own = np.asarray(self.values).dtype
        taken = np.dtype(np.float32) if own.kind == "f" and own.itemsize not in (4, 8) else own.newbyteorder("=")
        data["amplitudes"] = np.ascontiguousarray(np.asarray(self.values).transpose(2, 0, 1), taken).reshape(-1)
        if self.known is not None:
            hidden = 2  # VTK's mark
            data["ghosts"] = np.where(np.asarray(self.known).transpose(2, 0, 1).reshape(-1), 0, hidden).astype(np.uint8)
        return data


def _whole(pair: Any) -> Any:
    """A pair of whole numbers as such; those of a lattice are floats."""
    return [int(one) if float(one).is_integer() else one for one in pair] if isinstance(pair, (tuple, list)) else pair


def read_cube(path: str | os.PathLike[str], *, inlines: tuple[int, int] | None = None, crosslines: tuple[int, int] | None = None,
              sample_range: tuple[int, int] | None = None, inline_byte: int = 0, crossline_byte: int = 0, x_byte: int = 0, y_byte: int = 0,
              sample_format: int = 0, number_of_samples: int = 0, vertical_step: float | None = None, tolerance: float = 0.25, duplicates: str = "refuse", delays: str = "interpolate",
              ignore_incomplete_trace: bool = False, direction: str = "down", vertical_unit: str = "", vertical_domain: str = "",
              horizontal_unit: str = "", coordinate_system: str = "", load: bool = True, progress: Progress | None = None) -> Cube:
    """Reads a post-stack SEG-Y file.

    Parameters
    ----------
    path : str or path
    inlines, crosslines : (first, last), optional
        Numbers of the lines to read; all by default.
    sample_range : (first, last), optional
        Vertical indices to read, from 0; a last of -1 reads to the end.
    inline_byte, crossline_byte, x_byte, y_byte : int
        Positions of the fields in trace headers, from 1; 0 finds them, -1 means none.
    sample_format : int
        SEG-Y code that replaces that of the file; 0 keeps it.
    number_of_samples : int
        Samples per trace, replacing the number in the file; 0 keeps it.
    vertical_step : float, optional
        z between samples; by default as in the file.
    tolerance : float
        Largest distance of a trace from its column, in columns.
    duplicates : "refuse", "first", "last" or "mean"
        Which of several traces at the same position is kept.
    delays : "interpolate" or "nearest"
        How delays that are not multiples of the sample interval are applied.
    ignore_incomplete_trace : bool
        Reads a file that ends within a trace.
    direction, vertical_unit, vertical_domain, horizontal_unit, coordinate_system
        As in `read`.
    load : bool
        False leaves the samples in the file, and `extract` reads those that it needs: near the picks, in a cube of more
        than 100 million samples.
    progress : callable, optional

    Returns
    -------
    Cube

    Raises
    ------
    ValueError
        If the file is not a post-stack cube or line, or its traces are on no lattice.
    FileNotFoundError
    """
    path = pathlib.Path(path)
    require_file(path)
    where = framing(vertical_step, direction, vertical_unit, vertical_domain, horizontal_unit, coordinate_system)
    options = given_options(
        inlines=_whole(inlines), crosslines=_whole(crosslines), sample_range=_whole(sample_range), inline_byte=inline_byte, crossline_byte=crossline_byte, x_byte=x_byte,
        y_byte=y_byte, sample_format=sample_format, number_of_samples=number_of_samples, vertical_step=where[0], tolerance=float(tolerance), duplicates=duplicates, delays=delays,
        ignore_incomplete_trace=ignore_incomplete_trace)
    file: list[_core.CubeFile] = []

    def read_file() -> Any:
        file.append(_core.CubeFile(str(path if load else path.absolute()), options, progress))
        return file[0].read(*where[1:], load, progress)

    data = call(str(path), read_file)
    first_i, last_i, first_j, last_j, first_k, last_k = data["extent"]
    shape = (last_k - first_k + 1, last_j - first_j + 1, last_i - first_i + 1)
    points, fields = data["point_data"], data["field_data"]
    whole = horizon_of("", {"point_data": {"Column": np.zeros((0, 2), np.int32)}, "field_data": fields, "places": np.zeros((0, 3))}).lattice
    x, y = whole.places(first_i, first_j)
    lines = whole.lines and (whole.lines[0] + whole.lines[1] * first_j, whole.lines[1], whole.lines[2] + whole.lines[3] * first_i, whole.lines[3])
    lattice = dataclasses.replace(whole, shape=shape[1:], origin=(float(x), float(y)), indices=shape[0], lines=lines,
                                  first_z=whole.first_z + first_k * whole.vertical_step)
    ghosts = points.get("vtkGhostType")
    amplitudes = next((values for name, values in points.items() if name != "vtkGhostType"), None)
    return Cube(np.zeros((0, 0, 0), np.float32) if amplitudes is None else amplitudes.reshape(shape).transpose(1, 2, 0), lattice,
                None if ghosts is None else (ghosts == 0).reshape(shape).transpose(1, 2, 0),
                data["line"][:, :2].reshape(*shape[1:], 2) if "line" in data else None, stem(path), direction or "down",
                taken=tuple(in_keywords(data["description"]).splitlines()), _file=None if load else file[0], **survey(fields))


def extract(cube: Cube, guides: Any = None, *, limits: Sequence[Horizon] = (), limit_side: str = "below", polarity: str = "both",
            position: str = "peak", threshold: float | None = None, percentile: float = 40.0, phase_rotation: float = 0.0, joining: str = "best_first",
            eight_neighbours: bool = False, largest_step: float = 0.0, smallest_correlation: float = 0.85, smallest_contact: float = 0.5,
            smallest_size: int = 0, largest_number: int = 100, order: str = "strength", guide_tolerance: float = 0.0, growth_correlation: float = 0.6,
            growth_reach: int = 1000, least_confidence: float = 0.0, keep_others: bool = False, progress: Progress | None = None) -> dict[str, Horizon]:
    """Extracts horizons from a cube: those that your picks belong to, or the strongest ones.

    Parameters
    ----------
    cube : Cube
    guides : path, Horizon, dict of Horizon or arrays of shape (n, 3), or such an array, optional
        Picks of each horizon to track. Files have line numbers, x and y, or both. Arrays are x, y and z, in the
        direction of the cube.
    limits : list of Horizon, optional
        Restricts extraction to one side of a horizon, or to the interval between two.
    limit_side : "below" or "above"
        Side to search with one limit.
    polarity : "both", "positive" or "negative"
    position : "peak", "middle" or "zero_crossing"
        Where on the wavelet a reflection is picked.
    threshold : float, optional
        Smallest absolute amplitude of picks; by default the percentile decides.
    percentile : float
        Weakest picks, as a percentile of the magnitudes of all nonzero samples, from 0 to 100.
    phase_rotation : float
        Phase rotation applied to the traces first, in degrees.
    joining : "best_first" or "components"
    eight_neighbours : bool
        Also links picks of diagonal neighbours.
    largest_step : float
        Largest step between neighbours, in samples; 0 chooses it.
    smallest_correlation, smallest_contact : float
        Smallest similarity of linked picks, and of joined parts, from 0 to 1.
    smallest_size : int
        Smallest number of points of a horizon; 0 chooses it.
    largest_number : int
        Largest number of horizons.
    order : "strength" or "size"
    guide_tolerance : float
        Largest distance of your picks from reflections, in samples; 0 chooses it.
    growth_correlation : float
        Smallest similarity of waveforms for a guided horizon to grow beyond automatic parts.
    growth_reach : int
        Largest distance of growth from picks, in columns; 0: no growth.
    least_confidence : float
        Drops points of guided horizons with less confidence, from 0 to 1.
    keep_others : bool
        Also returns automatic horizons when there are guides.
    progress : callable, optional

    Returns
    -------
    dict of Horizon
        With the attributes Amplitude and Thickness. Guided horizons also have Confidence (the probability that a point
        is right, 0 to 1), Correlation (of waveforms with those of the nearest picks), GuideDistance (columns from the
        nearest pick), Origin (0 at picks, 1 on automatic parts, 2 where grown), Block (between faults, from 1) and Seed
        (the nearest pick along the block, from 0; -1 for none). `taken` describes what was found.
    """
    if not isinstance(cube, Cube):
        raise TypeError("extraction from %s, expected a Cube: read_cube(path) reads one" % type(cube).__name__)
    options = given_options(
        limit_side=limit_side, polarity=polarity, position=position, threshold="percentile" if threshold is None else "amplitude",
        amplitude_threshold=threshold, amplitude_percentile=float(percentile), phase_rotation=float(phase_rotation), joining=joining,
        eight_neighbours=bool(eight_neighbours), largest_step=float(largest_step), smallest_correlation=float(smallest_correlation),
        smallest_contact=float(smallest_contact), smallest_size=int(smallest_size), largest_number=int(largest_number), order=order,
        guide_tolerance=float(guide_tolerance), growth_correlation=float(growth_correlation), growth_reach=int(growth_reach), least_confidence=float(least_confidence), keep_others=bool(keep_others))
    if isinstance(guides, (str, os.PathLike)):
        guides = _read_guides(pathlib.Path(guides), cube, progress)
    picks = None if guides is None else [(name, _picks(one, name, cube)) for name, one in (
        guides.items() if isinstance(guides, Mapping) else [(getattr(guides, "name", "guide"), guides)])]
    for one in limits:
        require_unit(one, cube)
    bounds = [(one.name, one._data()) for one in limits] or None
    found, description, _ = call(cube.name, _core.extract, cube._data(), picks, bounds, options, progress)
    own = ("Column", "SurfaceId", "VerticalIndex", "RealZ")
    horizons = {name: horizon_of(name, data, taken=tuple(in_keywords(description).splitlines()), attributes={
        key: values for key, values in data["point_data"].items() if key not in own}) for name, data in found}
    if cube.line is not None:
        for horizon in horizons.values():
            horizon.attributes |= zip(("LineX", "LineY"), cube.line[horizon.columns[:, 1], horizon.columns[:, 0]].T)
    return horizons


def _read_guides(path: pathlib.Path, cube: Cube, progress: Progress | None) -> dict[str, Horizon]:
    """The horizons of a file; picks take the lattice of the cube, as a few do not define one."""
    require_file(path)
    if _core.find_format(os.fsencode(path)) not in ("text", ""):
        return read(path, progress=progress)
    lattice = cube.lattice
    options = placement(leave_out_strays=True, tolerance=0.499, origin=lattice.origin, column_step=lattice.column_step, row_step=lattice.row_step,
                        lines=lattice.lines or ())
    found = call(str(path), lambda: (_core.read_text(str(path), "", _core.DEFAULT_NULLS, 0, "", options, 0.0, "up" if cube.sign > 0 else "",
                                                     ("",) * 4, progress)[1], []))
    return horizons(found, stem(path), file_name=path.name)


def require_unit(horizon: Horizon, cube: Cube) -> None:
    """Raises ValueError if z has another unit than the cube, where both say it."""
    if horizon.vertical_unit and cube.vertical_unit and horizon.vertical_unit != cube.vertical_unit:
        raise ValueError("%s with z in %s, and a cube in %s, expected the same: convert z, or set vertical_unit where it is wrong" % (
            horizon.name, horizon.vertical_unit, cube.vertical_unit))


def _picks(given: Any, name: str, cube: Cube) -> Data:
    if isinstance(given, Horizon):
        require_unit(given, cube)
        return given._data()
    places = np.array(given, np.float64)
    if places.ndim != 2 or places.shape[1] != 3:
        raise ValueError("guide %s of shape %s, expected (n, 3), of x, y and z" % (name, places.shape))
    return {"places": places * (1.0, 1.0, cube.sign)}
