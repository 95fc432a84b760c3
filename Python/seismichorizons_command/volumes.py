# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes between the horizons of a file."""

import types
from dataclasses import dataclass

from seismichorizons import _core

from . import core, data, reading
from .core import HorizonError, snake


@dataclass
class Layers:
    """The cells of all layers, a closed body of each layer that has cells, the figures of each layer by name, and the same
    figures as a table by columns."""

    cells: dict
    bodies: dict
    figures: dict
    table: dict


def of_points(points, settings, label):
    """Makes the layers between the horizons of a file, given by name, and returns them with warnings. Raises HorizonError."""
    given = dict(settings.layers)
    if given.get("Order") == "AsGiven" and settings.horizons:
        places = {reading.name_of(horizon): place for place, horizon in
                  enumerate(reading.names_in(settings.horizons, points))}
        points = dict(sorted(points.items(), key=lambda item: places.get(item[0], len(places))))
    own = settings.in_unit_of(next(iter(points.values()))).layers
    options = core.options({name: value for name, value in own.items() if name not in ("Order", "CrossingsByLayer")})
    options["by_height"] = own.get("Order") != "AsGiven"
    if "CrossingsByLayer" in own:
        options["crossings_by_layer"] = own["CrossingsByLayer"]
    with core.errors("%s: " % label):
        made, warnings = core.run(_core.layers, list(points.items()), options, label="%s: layers" % label)
    return _collect(made), list(filter(None, warnings))


def _collect(made):
    table = made["figures"]
    rows = [dict(zip(table, values)) for values in zip(*(column if isinstance(column, list) else column.tolist() for column in table.values()))]
    figures = {row["Name"]: types.SimpleNamespace(**{snake(name): value for name, value in row.items()}) for row in rows}
    bodies = {name: body for name, body in zip(figures, made["bodies"]) if data.count_points(body)}
    return Layers(made["volumes"], bodies, figures, table)
