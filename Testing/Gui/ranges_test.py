# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""In the panels of the window every number, choice and switch of every stage is moved to the ends of its range, or through
all of its choices, and back, with Apply each time. Nothing is wrong on the way but what is told with what was expected, and
at the end all is as it was.

Arguments: ParaView, the folder of the panels as built, and a folder.
"""

import json
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

import window

# A horizon with a step and a hole.
HORIZON = "16 12 40\n" + "".join(
    "\n" if 4 < n % 16 < 7 and 3 < n // 16 < 7 else "%d 1 1 %d 0\n" % (10 + n % 16 // 9 * 6 + n % 3, n % 7)
    for n in range(16 * 12))
CHAINS = (
    ["HorizonDespiking", "HorizonFaults", "HorizonHoleFilling", "HorizonExteriorBoundary", "HorizonBoundarySimplification",
     "HorizonRoughSimplification", "HorizonElaborateSimplification", "HorizonTriangulation"],
    ["HorizonExteriorBoundary", "HorizonBoundarySimplification", "HorizonDecimation"],
    ["HorizonSurface"],
)
READER = "VerneySparseMatrixReader"
BEYOND = 10  # how far a number is moved whose range has no end


def load_properties(panels):
    """The properties of each proxy."""
    proxies = {proxy.get("name"): proxy for file in sorted(panels.glob("*.xml"))
               for proxy in ElementTree.parse(file).iter("SourceProxy")}
    return {name: [element for element in proxy if element.tag in ("IntVectorProperty", "DoubleVectorProperty")]
            for name, proxy in proxies.items()}


def fields_of(prop):
    """Where a property is in the panel, and what its fields are moved to: (place, command, values, default) for each."""
    place = window.FIELDS + "ProxyPanel/%s/" % prop.get("name")
    defaults = prop.get("default_values", "").split()
    entries = {entry.get("value"): entry.get("text") for entry in prop.iter("Entry")}
    if entries:
        return [(place + "ComboBox", "set_string", list(entries.values()), entries[defaults[0]])]
    if prop.find("BooleanDomain") is not None:
        return [(place + "CheckBox", "set_boolean", ["true", "false"], "true" if defaults == ["1"] else "false")]
    is_double = prop.tag.startswith("Double")
    domain = prop.find("DoubleRangeDomain" if is_double else "IntRangeDomain")
    lows, highs = (domain.get(end, "").split() for end in ("min", "max"))
    if not lows:
        return []
    values = [lows[0], highs[0] if highs else str(int(float(lows[0])) + BEYOND)]
    if highs:
        names = ["DoubleRangeWidget/DoubleLineEdit" if is_double else "IntRangeWidget/LineEdit"]
    else:
        names = ["%s%d" % ("DoubleLineEdit" if is_double else "LineEdit", n) for n in range(len(defaults))]
    return [(place + name, "set_string", values, default) for name, default in zip(names, defaults)]


def move_all(events, properties):
    """Notes what there is before and after."""
    events.macro("Note")
    for prop in properties:
        if prop.get("information_only") == "1" or prop.get("panel_visibility") == "never":
            continue
        for place, command, values, default in fields_of(prop):
            for value in (*values, default):
                events.add(place, command, value)
                events.apply()
    events.macro("Note")


def wrong_lines(log):
    """Errors without a word of what was expected."""
    told = [line for line in log.splitlines() if re.search(r"critical:|Traceback|ERR\|", line)]
    return [line for line in told if "expected" not in line]


def main():
    paraview, panels, folder = sys.argv[1:4]
    properties = load_properties(pathlib.Path(panels))
    folder = window.new_folder(folder)
    for number, stages in enumerate(CHAINS):
        work = window.new_folder(folder / str(number))
        (work / "horizon.vsm").write_text(HORIZON, encoding="ascii")
        events = window.Events()
        events.open(work / "horizon.vsm")
        events.apply()
        if number == 0:
            move_all(events, properties[READER])
        for stage in stages:
            events.filter(stage)
            events.apply()
            move_all(events, properties[stage])
        events.write(work / "events.xml")
        code, log = window.run(paraview, work / "events.xml", work)
        assert code == 0 and not wrong_lines(log), "\n".join(wrong_lines(log)) or log
        notes = [json.loads(line) for line in (work / "notes.txt").read_text(encoding="utf-8").splitlines()]
        assert [note["name"] for note in notes[0::2]] == ([READER] if number == 0 else []) + stages, notes
        assert notes[0::2] == notes[1::2] and all(note["points"] for note in notes), notes
        print("%d moves" % sum(" command=\"set_" in line for line in events.lines))


main()
