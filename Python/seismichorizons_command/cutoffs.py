# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Where the horizons of a file meet faults."""

from seismichorizons import _core

from . import core, writing


def write(points, settings, label, names, folder):
    """Writes tables, cutoffs and fault polygons of horizons, given by name, and returns lines to print and warnings. Raises
    HorizonError."""
    are_sticks = settings.torn.get("LineType") == "Sticks"
    faults = [("", settings.fault_lines)] if are_sticks else []
    with core.errors("%s: " % label):
        made, warnings = core.run(_core.cutoffs, list(points.items()), faults, core.options(settings.cutoffs), label="%s: cutoffs" % label)
    for table, name in zip((made["figures"], made["areas"]), names.cutoff_tables):
        writing.write_tables([table], folder / name)
    for place, name in enumerate(points):
        for file, given in names.cutoffs[name].items():
            writing.write_fault_lines(made[given][place], folder / file)
    table = made["figures"]
    lines = ["%s at %s: throw %.4g to %.4g, mean %.4g; guessed %d of %d places" % row for row in zip(
        table["Horizon"], table["Fault"], table["ThrowLeast"], table["ThrowLargest"], table["ThrowMean"], table["Guessed"], table["Places"])]
    return lines, list(filter(None, warnings))
