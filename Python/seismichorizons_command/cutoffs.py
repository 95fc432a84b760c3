# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Where the horizons of a file meet faults, and the bodies between these."""

from seismichorizons import _core

from . import core, writing


def write(points, settings, label, names, folder):
    """Writes tables, cutoffs and fault polygons of horizons, given by name, and returns lines to print and warnings. Raises
    HorizonError."""
    faults = _faults(settings)
    with core.errors("%s: " % label):
        made, warnings = core.run(_core.cutoffs, list(points.items()), faults, core.options(settings.cutoffs), label="%s: cutoffs" % label)
    for table, name in zip((made["figures"], made["areas"]), names.cutoff_tables):
        writing.write_tables([table], folder / name)
    for place, name in enumerate(points):
        for file, given in names.cutoffs[name].items():
            writing.write_fault_lines(made[given][place], folder / file, settings.written_direction)
    table = made["figures"]
    lines = ["%s at %s: throw %.4g to %.4g, mean %.4g; guessed %d of %d places" % row for row in zip(
        table["Horizon"], table["Fault"], table["ThrowLeast"], table["ThrowLargest"], table["ThrowMean"], table["Guessed"], table["Places"])]
    return lines, list(filter(None, warnings))


def write_sealed(points, settings, label, names, folder):
    """Writes the sealed model of horizons, given by name, and its tables, and returns lines to print and warnings. Raises
    HorizonError."""
    own = {"HeightUnit": "Steps", "Endings": "", "Unconformities": "", **settings.in_unit_of(next(iter(points.values()))).sealed}
    options = {**core.options(own), "endings": own["Endings"], "unconformities": own["Unconformities"]}
    with core.errors("%s: " % label):
        made, warnings = core.run(_core.sealed, list(points.items()), _faults(settings), options, label="%s: sealed model" % label)
    for name in names.sealed:
        writing.write_sealed(made["surfaces"], folder / name)
    for table, name in zip((made["figures"], made["areas"], made["picks"]), names.sealed_tables):
        writing.write_tables([table], folder / name)
    return made["report"].splitlines(), list(filter(None, warnings))


def _faults(settings):
    """The sticks; nothing for the cuts of the horizons."""
    return [("", settings.fault_lines)] if settings.torn.get("LineType") == "Sticks" else []
