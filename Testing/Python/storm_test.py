# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in pvpython: filters one after the other on whatever those before gave, with parameters at random, valid and not,
as a user may drag them in the panel. ParaView stays alive, and what is refused is told with what was expected.

Arguments: the folder of the plugin, and one for files. The variable ROUNDS of the environment makes it longer, SEED another
one. The last line of settings.txt in the folder tells what ran when the program ended.
"""

import faulthandler
import os
import pathlib
import random
import re
import sys
import xml.etree.ElementTree as ElementTree

from paraview import simple

from errors_test import captured

ROUNDS = int(os.environ.get("ROUNDS", "300"))
SEED = int(os.environ.get("SEED", "1"))
LONGEST = 60  # seconds of a round; then the program is stopped, and tells where it was
MOST_SOURCES = 10
INTEGERS = (-2147483648, -1000, -5, -2, -1, 0, 0, 1, 1, 1, 2, 2, 3, 3, 4, 5, 8, 32, 33, 100, 1000, 2147483647)
NUMBERS = (float("nan"), float("inf"), -1e300, -1000.0, -1.0, -0.1, 0.0, 0.0, 1e-300, 1e-6, 0.1, 0.3, 0.5, 1.0, 1.0, 2.0,
           5.0, 40.0, 90.0, 1e6, 1e300)
FILES = {
    "point.vsm": "1 1 5\n3 1 1 0.5 4.0\n",
    "line.vsm": "6 1 9\n" + "3 1 1 0.5 4.0\n" * 6,
    "two.vsm": "5 4 9\n" + "3 1 1 0.5 4.0 6 2 1 0.5 8.0\n" * 20,
    "step.vsm": "12 9 40\n" + "".join("%d 1 1 0.5 4.0\n" % (5 if n % 12 < 6 else 25) for n in range(108)),
    "holes.vsm": "12 9 40\n" + "".join("\n" if n in (27, 28, 39, 40, 66) else "%d 1 1 0.5 4.0\n" % (5 + n % 7)
                                       for n in range(108)),
    "empty.vsm": "3 3 3\n" + "\n" * 9,
}


def filters(plugin):
    return [proxy.get("name") for proxy in ElementTree.parse(plugin / "Menu.xml").iter("Proxy")]


def sources(folder):
    """What pipelines begin with; they stay all the time."""
    found = []
    for name, text in FILES.items():
        (folder / name).write_text(text)
        found.append(simple.VerneySparseMatrixReader(FileName=str(folder / name)))
    return found + [simple.Wavelet(WholeExtent=[0, 9, 0, 7, 0, 12]), simple.Sphere(), simple.PointSource(NumberOfPoints=9)]


def values(chance, prop):
    """Random values for all elements of a property, or None where it takes no numbers."""
    kind = prop.GetClassName()
    if prop.GetInformationOnly() or kind not in ("vtkSMIntVectorProperty", "vtkSMDoubleVectorProperty"):
        return None
    choices = INTEGERS if kind == "vtkSMIntVectorProperty" else NUMBERS
    domain = prop.FindDomain("vtkSMEnumerationDomain")
    if domain:
        choices = [domain.GetEntryValue(n) for n in range(domain.GetNumberOfEntries())]
    elif prop.FindDomain("vtkSMBooleanDomain"):
        choices = (0, 1)
    return [chance.choice(choices) for _ in range(prop.GetNumberOfElements())]


def set_at_random(chance, proxy):
    """Changes some of the properties; returns what they are."""
    changed = {}
    for name in proxy.ListProperties():
        prop = proxy.SMProxy.GetProperty(name)
        given = values(chance, prop) if prop and chance.random() < 0.3 else None
        if given is not None:
            for n, value in enumerate(given):
                prop.SetElement(n, value)
            changed[name] = given
    proxy.SMProxy.UpdateVTKObjects()
    return changed


def unclear(text):
    """The errors of our own classes that do not say what was expected."""
    plain = re.sub(r"\x1b\[[0-9;]*m", "", text)
    found = re.findall(r"ERR\| vtk(?:Horizon|Seismic|Verney)\w* \(0x[0-9a-f]+\): (.*)", plain)
    return [message for message in found if "expected" not in message]


def run_round(chance, names, fixed, pool, log):
    """One filter; what it gives may be the input of others."""
    make = getattr(simple, chance.choice(names))
    inputs = [chance.choice(fixed + pool) for _ in range(2)]
    proxy = make(Input=inputs[0]) if make is not simple.HorizonSurfaceDistance else make(
        Reference=inputs[0], Mesh=inputs[1])
    if hasattr(proxy, "Polylines") and chance.random() < 0.3:
        proxy.Polylines = inputs[1]
    first = proxy.SMProxy.GetProperty("Input") or proxy.SMProxy.GetProperty("Reference")
    if not first.IsInDomains() and chance.random() < 0.95:  # the menu does not offer it then
        simple.Delete(proxy)
        return
    changed = set_at_random(chance, proxy)
    log.write("%s of %s: %s\n" % (proxy.SMProxy.GetXMLName(), [i.SMProxy.GetXMLName() for i in inputs], changed))
    log.flush()
    with captured() as text:
        proxy.UpdatePipeline()
        told = text()
    assert not unclear(told) and "Traceback" not in told, "%s\n%s" % (changed, told)
    if proxy.GetDataInformation().GetNumberOfPoints() and len(pool) < MOST_SOURCES:
        pool.append(proxy)
        return
    simple.Delete(proxy)
    if pool and chance.random() < 0.3:
        pool.pop(chance.randrange(len(pool)))  # those that use it keep it


def main():
    plugin, folder = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    folder.mkdir(parents=True, exist_ok=True)
    names = filters(plugin)
    fixed, pool = sources(folder), []
    chance = random.Random(SEED)
    with open(folder / "settings.txt", "w", encoding="utf-8") as log:
        for _ in range(ROUNDS):
            faulthandler.dump_traceback_later(LONGEST, exit=True, file=sys.__stderr__)
            run_round(chance, names, fixed, pool, log)
        faulthandler.cancel_dump_traceback_later()
    print("%d rounds" % ROUNDS)


main()
