# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Closed bodies of layers between faults."""

from __future__ import annotations

import dataclasses
import os
import pathlib
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core, _xml
from ._cutoffs import faults_of
from ._data import Data, Progress, call, snake
from ._horizon import Floats, Horizon
from ._lines import Lines
from ._mesh import Mesh, mesh_of
from ._stack import named_horizons
from ._stages import given_options
from ._units import height


@dataclasses.dataclass(eq=False, repr=False)
class SealedModel:
    """Closed bodies of the layers between faults, from `sealed`. Surfaces share points where they meet.

    Attributes
    ----------
    points : float64 array of shape (n, 3)
        x, y and z in world coordinates, with z upwards.
    triangles : int array of shape (m, 3)
        Counter-clockwise as seen from above for horizons, and as seen from the hanging wall for faults.
    surface : list of str of m
        The horizon, fault or wall of each triangle.
    surface_type : uint8 array of m
        0 horizon, 1 fault, 2 wall, 3 top or base.
    body_above, body_below : int32 arrays of m
        Number of the body in front of and behind each triangle; -1 outside.
    guessed : uint8 array of n
        0 near picks, 1 extrapolated, 2 derived from another horizon.
    names : list of str
        Layer and block of each body, such as "Top to Base, F1 footwall".
    bodies : list of Mesh
        The closed surface of each body, facing outwards.
    lines : Lines
        Lines where surfaces meet, named by kind: cutoff, branch, trace, tip, outline, pinch-out or edge.
    figures : dict of arrays
        One value for each body: layer, block, volume, area.
    areas : dict of arrays
        One value for each pair of layers that meet at a fault: fault, footwall, hanging_wall, area.
    picks : dict of arrays
        Use of the picks of each horizon: used, beside_faults, not_agreeing, doubled, outside; moved and largest_move of
        those used; columns of the horizon; and columns without a pick, continued.
    """

    points: Floats
    triangles: NDArray[np.int64]
    surface: list[str]
    surface_type: NDArray[np.uint8]
    body_above: NDArray[np.int32]
    body_below: NDArray[np.int32]
    guessed: NDArray[np.uint8]
    names: list[str]
    bodies: list[Mesh]
    lines: Lines
    figures: dict[str, Any]
    areas: dict[str, Any]
    picks: dict[str, Any]

    _surfaces: Data = dataclasses.field(default_factory=dict)

    def __len__(self) -> int:
        return len(self.names)

    def write(self, path: str | os.PathLike[str], progress: Progress | None = None) -> None:
        """Writes the model: .ml (GOCAD Model3d), .msh (Gmsh), .stl (a solid for each body), or .vtp (VTK, all triangles).

        Parameters
        ----------
        path : str or path
            An existing file is replaced only when the new one is complete.
        progress : callable, optional

        Raises
        ------
        ValueError
            If the extension is none of these.
        OSError
            If the file cannot be written.
        """
        if pathlib.Path(path).suffix == ".vtp":
            _core.write_contents(os.fspath(path), [("", _xml.poly_data(self._surfaces))])
        else:
            _core.write_sealed(os.fspath(path), self._surfaces, progress)

    def __repr__(self) -> str:
        return "Sealed model of %d bodies, {:,} points, {:,} triangles".format(len(self.points), len(self.triangles)) % len(self)


def sealed(horizons: Mapping[str, Horizon] | Sequence[Horizon] | Horizon, faults: Any, *, endings: str = "", end_distance: float = 5.0,
           unconformities: str = "", tips: str = "sticks", outline: str = "box", dip: float = 0.0, drop_distance: float = 0.5, drop_noise: float = 4.0,
           largest_error: float | str | None = None, progress: Progress | None = None) -> SealedModel:
    """Makes closed bodies of the layers between horizons and faults.

    Parameters
    ----------
    horizons : Horizon, or dict or list of Horizon
        In depth, and on the same lattice.
    faults : Faults, dict of Faults by horizon, Lines, list of arrays, or dict of Mesh by fault
        As in `cutoffs`.
    endings : str
        Which fault ends at which, as "F2 > F1; F3 > F1", for all faults that cross. By default, a fault ends at the
        faults it meets, and of two that cross the smaller one ends, on each side.
    end_distance : float
        A fault that extends less than this beyond another ends there, in columns.
    unconformities : str
        Names of horizons, separated by semicolons, at which faults end from below, unless more than a tenth of the
        fault is above.
    tips : "sticks" or "through"
        "sticks": faults die out half a stick spacing beyond their sticks, or at their tip loop, unless the surface that
        they end at is within `end_distance`. "through": faults continue to walls and other faults.
    outline : "box" or "picks"
        Walls form a box around the columns that all horizons have, or follow the picks inside this box, with few
        corners.
    dip, drop_distance, drop_noise : float
        As in `cutoffs`.
    largest_error : float or str, optional
        Largest vertical error at picks, in the unit of z or with a unit; by default six times the noise of the roughest
        horizon.
    progress : callable, optional

    Returns
    -------
    SealedModel

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> x = np.arange(80) * 25.0 + np.zeros((60, 1))
    >>> z = np.where(x < 987.0, 1000.0, 1030.0)
    >>> stick = np.array([(970.0, -900.0), (1010.0, -1100.0)])
    >>> sticks = [np.column_stack((stick[:, 0], [y, y], stick[:, 1])) for y in (0.0, 700.0, 1475.0)]
    >>> model = sh.sealed({"Top": sh.horizon(z, spacing=(25, 25))}, sticks, largest_error=1.0)
    >>> model.names
    ['above Top, Fault footwall', 'above Top, Fault hanging wall', 'below Top, Fault footwall', 'below Top, Fault hanging wall']
    """
    given, blocks, named = faults_of(horizons, faults, "sealed model")
    first = next(iter(given.values()), None)
    options = given_options(endings=endings, end_distance=float(end_distance), unconformities=unconformities, tips=tips, outline=outline, dip=float(dip),
                            drop_distance=float(drop_distance), drop_noise=float(drop_noise),
                            maximum_error=None if largest_error is None or first is None else height("largest_error", largest_error, first.vertical_unit))
    made = call("sealed model", _core.sealed, named, blocks, options, progress)
    surfaces = made["surfaces"]
    cells = surfaces["cell_data"]
    bodies = [mesh_of(name, {**body, "point_data": {}, "cell_data": {}}, {}, body["field_data"], None) for name, body in zip(made["names"], made["bodies"])]
    figures, areas, picks = ({snake(name): values for name, values in made[table].items()} for table in ("figures", "areas", "picks"))
    return SealedModel(np.asarray(surfaces["places"]), np.asarray(surfaces["polygons"][1]).reshape(-1, 3), list(cells["SurfaceName"]),
                       cells["SurfaceType"], cells["BodyAbove"], cells["BodyBelow"], surfaces["point_data"]["Guessed"], made["names"], bodies,
                       Lines.of(_named(made["lines"])), figures, areas, picks, surfaces)


def _named(lines: Data) -> Data:
    """Lines of faults have names; here these are the kinds."""
    cells = lines["cell_data"]
    return {**lines, "point_data": {}, "cell_data": {"FaultName": cells["LineType"], "FaultStick": cells["SurfaceName"]}}
