# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes between horizons as a function."""

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
    """What `layers` made. `cells` has the wedges of all layers with the arrays Layer, Thickness and Volume, `bodies` their
    closed surfaces, where there are cells, and `horizons` the horizons on the same plan, by names; `figures` has `volume`,
    `area`, `thickness_mean` and the like of each layer, `table` the same for programs, and `curve` arrays of `contact` and of
    the volume of each layer above it."""

    def __repr__(self):
        return "Layers(%s)" % ", ".join("%r: %.6g" % (name, own.volume) for name, own in self.figures.items())


def layers(horizons: Mapping[str, vtkPolyData] | Sequence[vtkPolyData], largest_error: float | str | None = None,
           contact: float | None = None, missing: str | None = None, **keywords: Any) -> Layers:
    """Closed volumes of the layers between horizons.

    Parameters
    ----------
    horizons : dict of str to vtkPolyData, or list of vtkPolyData
        points of at least two horizons of one survey, as `read`, `horizon` and `extract` give them.
    largest_error : float or str, optional
        how far a point may be from the layers, vertically: in vertical indices, or with a unit, as "2 ms". By default
        six times the noise of the horizon that has the most.
    contact : float, optional
        a level, as world z, above which volumes are measured too.
    missing : {"Void", "Interpolate", "Follow"}, optional
        what is done where a horizon has no points: layers are left out; its holes and gaps are closed; or, by default, a horizon
        that is absent between two others follows one of these, too.
    **keywords
        properties of HorizonLayers: `crossings`, `crossings_by_layer`, `domain`, `order` and the like.

    Returns
    -------
    Layers

    Raises
    ------
    TypeError, ValueError
        fewer than two horizons, horizons of different lattices, in no order or without a common column.

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
    """Horizons that cross, in order.

    Parameters
    ----------
    horizons : dict of str to vtkPolyData, or list of vtkPolyData
        as `layers` takes them.
    **keywords
        properties of HorizonCrossings: `crossings`, `crossings_by_layer`, `order` and the like.

    Returns
    -------
    dict of str to vtkPolyData, or to pyvista.PolyData where PyVista is imported
        all points, the uppermost horizon first, with the array Moved.

    Raises
    ------
    TypeError, ValueError
        as those of `layers`.

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
    """A filter of all horizons. Returns the unit that heights were given in. Raises TypeError and ValueError."""
    if not isinstance(horizons, (Mapping, Sequence)):
        raise TypeError("%s, expected a dict or a list of horizons" % type(horizons).__name__)
    named = horizons if isinstance(horizons, Mapping) else dict(enumerate(horizons))
    for data in named.values():
        calls.require_points(data, "a horizon")
    unit = calls.set_keywords(maker, keywords, min(named.values(), key=lambda data: heights.step_of(data) or math.inf, default=None))
    if isinstance(horizons, Mapping):
        maker.SetInputDataObject(0, making.collect_picks(horizons))
    else:
        for data in named.values():
            maker.AddInputDataObject(0, data)
    calls.run(maker, label)
    return unit


def of_points(points, settings, label):
    """The layers between horizons of a file, by names, and warnings. Raises HorizonError."""
    if settings.layers.get("Order") == "AsGiven" and settings.horizons:
        places = {reading.name_of(horizon): place for place, horizon in enumerate(settings.horizons)}
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
    """What a filter made, with its `table` of figures."""
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
