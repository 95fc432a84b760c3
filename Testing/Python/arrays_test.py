# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Random chains of stages over data whose arrays have any type, number of components and number of tuples, as programs
make them that add arrays by hand. A stage gives data that fit together, or an error that says what was expected; and
values of an array come from that array.

Arguments: how many chains, and the seed of the first one; a failed one is told with its own seed.
"""

import faulthandler
import random
import re
import sys

import numpy as np
from seismichorizons import vtk as sh
from vtkmodules import vtkCommonCore, vtkCommonDataModel
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

CHAINS = int(sys.argv[1])
FIRST = int(sys.argv[2]) if len(sys.argv) > 2 else 1
LONGEST = 60  # seconds of a chain; then the program is stopped, and tells where it was
LEAST, MOST = 1000, 1250  # between which all values of arrays are that chains make
STAGES = ("Despiking", "Faults", "HoleFilling", "ExteriorBoundary", "BoundarySimplification", "RoughSimplification",
          "ElaborateSimplification", "Triangulation", "Decimation", "Surface")
TYPES = (vtkCommonCore.vtkFloatArray, vtkCommonCore.vtkDoubleArray, vtkCommonCore.vtkIntArray,
         vtkCommonCore.vtkUnsignedShortArray, vtkCommonCore.vtkIdTypeArray, vtkCommonCore.vtkLongLongArray)
# What stages read, beside what they carry on.
READ = ("vtkGhostType", "PatchId", "Boundary", "PointCount", "SurfaceId", "VerticalIndex", "Column", "LatticeToWorld",
        "LatticeDimensions", "FaultId", "Cut", "Quality", "HorizonPoint", "FaultedLinks", "VerticalDirection")


def horizon(chance):
    """Some of the columns of a small lattice, with or without what tells of it."""
    side = chance.randint(1, 14)
    columns = [(i, j) for j in range(side) for i in range(side) if chance.random() < chance.choice((0.5, 0.9, 1.0))]
    step = chance.random() < 0.3
    places = [(i, j, 20 + (9 if step and i > side // 2 else 0) + chance.randint(0, 2)) for i, j in columns]
    points = vtkCommonCore.vtkPoints()
    points.SetData(numpy_to_vtk(np.array(places, float).reshape(-1, 3), deep=True))
    data = vtkCommonDataModel.vtkPolyData()
    data.SetPoints(points)
    if chance.random() < 0.9:
        for name, values in (("LatticeDimensions", np.array([[side, side, 40]], np.int32)),
                             ("LatticeToWorld", np.eye(4).reshape(1, 16))):
            array = numpy_to_vtk(values, deep=True)
            array.SetName(name)
            data.GetFieldData().AddArray(array)
    return data


def any_array(chance, name, size):
    """With as many tuples as there should be, or not."""
    tuples = chance.choice((size, size, size, 0, 1, size - 1, size + 1, 2 * size))
    if chance.random() < 0.1:
        array = vtkCommonCore.vtkStringArray()
        array.SetNumberOfValues(max(tuples, 0))
    else:
        array = vtkCommonCore.vtkUnsignedCharArray() if name == "vtkGhostType" else chance.choice(TYPES)()
        array.SetNumberOfComponents(chance.choice((1, 1, 1, 2, 3, 4, 9)))
        array.SetNumberOfTuples(max(tuples, 0))
        if array.GetNumberOfValues() > 0:
            values = vtk_to_numpy(array)
            random_values = np.random.default_rng(chance.randrange(1 << 30)).integers(LEAST, MOST, values.shape)
            values[...] = random_values % 256 if name == "vtkGhostType" else random_values
    array.SetName(name)
    return array


def spoil(chance, data):
    """Adds arrays, and takes the place of some. Gives the names of those that stages carry on."""
    copy = vtkCommonDataModel.vtkPolyData()
    copy.ShallowCopy(data)
    for n in range(chance.choice((0, 1, 1, 2, 3))):
        attributes, size = chance.choice(((copy.GetPointData(), copy.GetNumberOfPoints()),
                                          (copy.GetCellData(), copy.GetNumberOfCells()), (copy.GetFieldData(), 1)))
        if chance.random() < 0.3:
            attributes.AddArray(any_array(chance, chance.choice(READ), size))
        else:
            attributes.AddArray(any_array(chance, "Own%d" % n, size))
    return copy


def check_sizes(data):
    for attributes, size in ((data.GetPointData(), data.GetNumberOfPoints()),
                             (data.GetCellData(), data.GetNumberOfCells())):
        for n in range(attributes.GetNumberOfArrays()):
            array = attributes.GetAbstractArray(n)
            assert array.GetNumberOfTuples() == size, "%s: %d tuples of %d" % (
                array.GetName(), array.GetNumberOfTuples(), size)
            if array.GetName().startswith("Own") and array.IsNumeric() and size > 0:
                values = vtk_to_numpy(array).astype(float)
                values = values[~np.isnan(values)]
                # Of points that stages add, integers are 0.
                known = (values >= LEAST - 1e-3) & (values <= MOST + 1e-3) | (values == 0)
                assert known.all(), "%s: %s" % (array.GetName(), values[~known][:5])
    cells = data.GetPolys()
    if cells.GetNumberOfCells() > 0:
        corners = vtk_to_numpy(cells.GetConnectivityArray())
        assert corners.min() >= 0 and corners.max() < data.GetNumberOfPoints()


def blocks(data):
    if data.IsA("vtkPolyData"):
        return [data]
    return [data.GetPartitionAsDataObject(n, 0) for n in range(data.GetNumberOfPartitionedDataSets())]


def run(chance, name, data):
    """The first block of what a stage makes of data, or None after an error, and the message."""
    stage = getattr(sh, "vtkHorizon" + name)()
    messages = []

    def add(_, __, text):
        messages.append(text)

    add.CallDataType = "string0"
    stage.AddObserver("ErrorEvent", add)
    stage.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)  # it says that there was an error
    stage.AddObserver("WarningEvent", lambda *_: None)
    if name in ("ExteriorBoundary", "Surface") and chance.random() < 0.5:
        stage.KeepHolesOn()
    stage.SetInputDataObject(data)
    stage.Update()
    output = stage.GetOutputDataObject(0)
    if messages:
        assert len(messages) == 1 and "expected" in messages[0], messages
        assert output is None or all(block is None or block.GetNumberOfPoints() == 0 for block in blocks(output))
        return None, messages[0]
    found = [block for block in blocks(output) if block is not None]
    for block in found:
        check_sizes(block)
    return (found[0] if found else None), None


def main():
    refused = set()
    passed = 0
    for seed in range(FIRST, FIRST + CHAINS):
        faulthandler.dump_traceback_later(LONGEST, exit=True)
        chance = random.Random(seed)
        data = horizon(chance)
        names = []
        try:
            for _ in range(chance.randint(1, 6)):
                names.append(chance.choice(STAGES))
                before = data
                data, message = run(chance, names[-1], spoil(chance, before))
                if message:
                    refused.add(re.sub(r"\d+|array \w+|.*0x\w+\): ", "#", message.strip().splitlines()[-1]))
                    data = before  # as it was, for the next one
                    continue
                if data is None:
                    break
                passed += 1
        except Exception:
            print("chain %d: %s" % (seed, names))
            raise
    faulthandler.cancel_dump_traceback_later()
    print("%d stages passed, %d kinds of refusals" % (passed, len(refused)))
    print("\n".join(sorted(refused)))
    assert CHAINS < 50 or (passed > CHAINS // 4 and len(refused) > 5)


faulthandler.enable()
main()
