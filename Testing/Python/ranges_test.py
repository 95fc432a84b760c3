# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in pvpython: every parameter of every stage is moved to the ends of its range, as its slider may be, or through all of
its choices, and back. Nothing is wrong on the way but what is told with what was expected; at the end all is as it was.

Arguments: the folder of the data and one for files.
"""

import pathlib
import sys

# Before any object of these classes comes out of a proxy: Python would take it for one of a base class, for good.
import seismichorizons.vtk  # noqa: F401

import mesh_checks
import pipelines
from errors_test import captured, messages

ROWS = [0, 23]  # few, as much is run
BEYOND = 10  # how far a parameter is moved whose range has no end


def stops(prop):
    """The values that a parameter is moved to, each for all of its elements; none where it is no number."""
    if prop.GetInformationOnly() or prop.GetClassName() not in ("vtkSMIntVectorProperty", "vtkSMDoubleVectorProperty"):
        return []
    choices = prop.FindDomain("vtkSMEnumerationDomain")
    if choices:
        return [choices.GetEntryValue(n) for n in range(choices.GetNumberOfEntries())]
    if prop.FindDomain("vtkSMBooleanDomain"):
        return [0, 1]
    kind = "vtkSMIntRangeDomain" if prop.IsA("vtkSMIntVectorProperty") else "vtkSMDoubleRangeDomain"
    domain = prop.FindDomain(kind)
    if not domain or not domain.GetMinimumExists(0):
        return []
    low = domain.GetMinimum(0)
    return [low, domain.GetMaximum(0) if domain.GetMaximumExists(0) else low + BEYOND]


def set_all(proxy, prop, values):
    for element, value in enumerate(values):
        prop.SetElement(element, value)
    proxy.SMProxy.UpdateVTKObjects()


def copies(proxy):
    """Copies of the horizons of output 0; a volume has no names."""
    proxy.UpdatePipeline()
    output = proxy.GetClientSideObject().GetOutputDataObject(0)
    kept = {}
    for name, horizon in ({"": output} if output.IsA("vtkImageData") else mesh_checks.blocks(output)).items():
        kept[name] = horizon.NewInstance()
        kept[name].DeepCopy(horizon)
    return kept


def same(first, second):
    """Whether two horizons have the same points, cells, arrays and field data."""
    if first.GetClassName() != second.GetClassName():
        return False
    try:
        pipelines.assert_same(first, second)
        pipelines.assert_same_fields(first, second)
    except AssertionError:
        return False
    return True


def move(name, proxy, key, expected):
    """Moves one parameter there and back. Returns whether the result was another one on the way."""
    prop = proxy.SMProxy.GetProperty(key)
    values = stops(prop)
    if not values:
        return False
    before = [prop.GetElement(n) for n in range(prop.GetNumberOfElements())]
    changed = False
    for value in values:
        with captured() as log:
            set_all(proxy, prop, [value] * len(before))
            found = copies(proxy)
            told = log()
        assert all("expected" in message for message in messages(told)), (name, key, value, told)
        assert "Traceback" not in told, (name, key, value, told)
        changed = changed or list(found) != list(expected) or not all(
            same(found[block], expected[block]) for block in expected)
    set_all(proxy, prop, before)
    return changed


def main():
    folder = pathlib.Path(sys.argv[2]).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    sample = pathlib.Path(sys.argv[1]).resolve() / "blobs.vsm"
    proxies = pipelines.all_stages(sample, pipelines.write_fault(folder))
    proxies["points"].RowRange = ROWS
    for name, proxy in proxies.items():
        if name == "lines":
            continue
        expected = copies(proxy)
        assert list(expected) == pipelines.CHOSEN, (name, list(expected))
        moved = [key for key in proxy.ListProperties() if proxy.SMProxy.GetProperty(key) and move(name, proxy, key, expected)]
        found = copies(proxy)
        assert list(found) == list(expected), (name, list(found))
        for block, horizon in expected.items():
            pipelines.assert_same(found[block], horizon)
        assert moved, name
        print("%s: %s" % (name, " ".join(moved)))


main()
