# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes between horizons."""

from __future__ import annotations

import math
import types
from collections.abc import Mapping, Sequence
from typing import Any

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

from . import calls, heights, making, reading
from .stage import HorizonError, make, update

FILTER = "vtkHorizonLayers"


class Layers(types.SimpleNamespace):
    """Result of `layers`.

    Attributes
    ----------
    cells : vtkUnstructuredGrid
        Wedges of all layers, with the arrays Layer, Thickness and Volume.
    bodies : dict of str to vtkPolyData
        Closed surface of each layer that has cells.
    horizons : dict of str to vtkPolyData
        Horizons on the common plan, by name.
    figures : dict of str
        `volume`, `area`, `thickness_mean` and other figures of each layer.
    table : vtkTable
        The same figures as a table.
    curve : dict of str to array
        Levels in `contact`, and for each layer its volume above each level.
    """

    def __repr__(self):
        return "Layers(%s)" % ", ".join("%r: %.6g" % (name, own.volume) for name, own in self.figures.items())


def layers(horizons: Mapping[str, vtkPolyData] | Sequence[vtkPolyData], largest_error: float | str | None = None,
           contact: float | None = None, missing: str | None = None, **keywords: Any) -> Layers:
    """Makes closed volumes of the layers between horizons.

    Parameters
    ----------
    horizons : dict of str to vtkPolyData, or list of vtkPolyData
        Points of at least two horizons of one survey, as returned by `read`, `horizon` and `extract`.
    largest_error : float or str, optional
        Largest vertical distance of a point from the layers, in vertical indices or with a unit such as "2 ms". By
        default, six times the noise of the noisiest horizon.
    contact : float, optional
        Level in world z; volumes above it are measured as well.
    missing : {"Void", "Interpolate", "Follow"}, optional
        Treatment of columns without a point of a horizon. "Void" leaves out the layers there. "Interpolate" closes the
        holes and gaps of the horizon. "Follow", the default, also lets a horizon that is absent between two others follow
        one of them.
    **keywords
        Properties of HorizonLayers, such as `crossings`, `crossings_by_layer`, `domain` or `order`.

    Returns
    -------
    Layers
        Cells, closed bodies and figures of all layers.

    Raises
    ------
    TypeError, ValueError
        If there are fewer than two horizons, or if they are on different lattices, have no consistent order or share no
        column.

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> flat = sh.horizon(np.full((20, 30), 100.0), vertical_step=1.0)
    >>> deep = sh.horizon(np.full((20, 30), 110.0), vertical_step=1.0)
    >>> sh.layers({"Top": flat, "Base": deep})
    Layers('Top to Base': 5510)
    """
    maker = make(FILTER)
    if largest_error is not None and "maximum_error" in keywords:
        raise TypeError("largest_error and maximum_error, expected one of them")
    target = {} if largest_error is None else {"maximum_error": largest_error}
    level = {} if contact is None else {"measure_above_contact": True, "contact": contact}
    policy = {} if missing is None else {"missing": missing}
    unit = _run(maker, horizons, {**target, **level, **policy, **keywords}, "layers")
    made = _collect(maker)
    for data in (made.cells, *made.horizons.values()):
        heights.note_unit(data, unit)
    made.cells = calls.wrap(made.cells)
    made.bodies = {name: calls.wrap(body) for name, body in made.bodies.items()}
    made.horizons = {name: calls.wrap(mesh) for name, mesh in made.horizons.items()}
    return made


def crossings(horizons: Mapping[str, vtkPolyData] | Sequence[vtkPolyData], **keywords: Any) -> dict[str, vtkPolyData]:
    """Orders horizons that cross each other.

    Parameters
    ----------
    horizons : dict of str to vtkPolyData, or list of vtkPolyData
        Horizons as for `layers`.
    **keywords
        Properties of HorizonCrossings, such as `crossings`, `crossings_by_layer` or `order`.

    Returns
    -------
    dict of str to vtkPolyData, or to pyvista.PolyData if PyVista is imported
        All points of each horizon with the array Moved, uppermost horizon first.

    Raises
    ------
    TypeError, ValueError
        As for `layers`.

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> flat, tilted = sh.horizon(np.full((4, 5), 2.0)), sh.horizon(np.tile(np.arange(5.0), (4, 1)))
    >>> ordered = sh.crossings({"Flat": flat, "Tilted": tilted}, order="AsGiven", crossings="UpperWins")
    >>> sh.details(ordered["Tilted"]).moved_columns
    8
    """
    maker = make("vtkHorizonCrossings")
    _run(maker, horizons, keywords, "crossings")
    return {name: calls.wrap(points) for name, points in reading.list_horizons(maker.GetOutputDataObject(0))}


def _run(maker, horizons, keywords, label):
    """Runs a filter on all horizons and returns the unit of the heights. Raises TypeError and ValueError."""
    if not isinstance(horizons, (Mapping, Sequence)):
        raise TypeError("%s, expected a dict or a list of horizons" % type(horizons).__name__)
    named = horizons if isinstance(horizons, Mapping) else dict(enumerate(horizons))
    for data in named.values():
        calls.require_points(data, "a horizon")
    unit = calls.set_keywords(
        maker, keywords, min(named.values(), key=lambda data: heights.step_of(data) or math.inf, default=None))
    if isinstance(horizons, Mapping):
        maker.SetInputDataObject(0, making.collect_picks(horizons))
    else:
        for data in named.values():
            maker.AddInputDataObject(0, data)
    calls.run(maker, label)
    return unit


def of_points(points, settings, label):
    """Makes the layers between the horizons of a file, given by name, and returns them with warnings. Raises HorizonError."""
    if settings.layers.get("Order") == "AsGiven" and settings.horizons:
        places = {reading.name_of(horizon): place for place, horizon in
                  enumerate(reading.names_in(settings.horizons, points))}
        points = dict(sorted(points.items(), key=lambda item: places.get(item[0], len(places))))
    own = settings.in_unit_of(next(iter(points.values())))
    maker = own.make(FILTER, own.layers)
    maker.SetInputDataObject(0, making.collect_picks(points))
    warnings = []
    try:
        update(maker, "%s: layers" % label, warnings)
    except HorizonError as error:
        raise HorizonError("%s: %s" % (label, error)) from None
    return _collect(maker), warnings


def _collect(maker):
    """Collects the outputs of a filter of layers."""
    cells, bodies, meshes, table, curve = (maker.GetOutputDataObject(port) for port in range(5))
    rows = {table.GetValueByName(row, "Name").ToString(): types.SimpleNamespace(**{
        calls.snake(table.GetColumnName(column)): _value(table.GetValue(row, column))
        for column in range(table.GetNumberOfColumns())}) for row in range(table.GetNumberOfRows())}
    return Layers(
        cells=cells, table=table, figures=rows, bodies=dict(reading.list_horizons(bodies)),
        horizons=dict(reading.list_horizons(meshes)),
        curve={curve.GetColumnName(column) if column else "contact": vtk_to_numpy(curve.GetColumn(column))
               for column in range(curve.GetNumberOfColumns())})


def _value(variant):
    return variant.ToString() if variant.IsString() else variant.ToDouble() if variant.IsDouble() else variant.ToInt()
