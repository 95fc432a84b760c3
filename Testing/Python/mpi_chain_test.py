# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in pvbatch on any number of ranks, the same on each (--symmetric): the chain of all stages gives what it gives on
one process, byte by byte, and what goes wrong on one rank stops all.

Arguments: the folder of the data, and how many ranks there are to be.
"""

import pathlib
import sys

from seismichorizons import vtk as sh
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIntArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkPolyData, vtkTable
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

import mesh_checks
import pipelines
from dealing import deal

RANKS = vtkMultiProcessController.GetGlobalController()
OWN, SIZE = RANKS.GetLocalProcessId(), RANKS.GetNumberOfProcesses()
SAMPLE = pathlib.Path(sys.argv[1]) / "blobs.vsm"

# The way by single stages, after the reader, and those that take the place of some of them.
CHAIN = [("HorizonDespiking", {}), ("HorizonHoleFilling", {"LargestHoleSize": 40}), ("HorizonExteriorBoundary", {}),
         ("HorizonBoundarySimplification", {}), ("HorizonRoughSimplification", {}), ("HorizonTriangulation", {})]
OTHERS = [("HorizonFaults", {}, 1), ("HorizonElaborateSimplification", {}, 3), ("HorizonDecimation", {}, 3),
          ("HorizonSurface", {}, 1)]


def make(name, properties, *inputs):
    stage = getattr(sh, "vtk" + name)()
    for key, value in properties.items():
        getattr(stage, "Set" + key)(value)
    for port, port_input in enumerate(inputs):
        stage.SetInputConnection(port, port_input.GetOutputPort())
    return stage


def make_reader(path=SAMPLE, **properties):
    reader = make("VerneySparseMatrixReader", properties)
    reader.SetFileName(str(path))
    return reader


def make_chain(reader):
    """All stages, the reader first, and the distance last."""
    stages = [reader]
    for name, properties in CHAIN:
        stages.append(make(name, properties, stages[-1]))
    stages += [make(name, properties, stages[source]) for name, properties, source in OTHERS]
    return stages + [make("HorizonSurfaceDistance", {}, stages[0], stages[-1])]


def outputs(stage):
    return [stage.GetOutputDataObject(port) for port in range(stage.GetNumberOfOutputPorts())]


def add_up(values):
    """The sums over all ranks."""
    own, sums = vtkIntArray(), vtkIntArray()
    for array in (own, sums):
        array.SetNumberOfValues(len(values))
    for n, value in enumerate(values):
        own.SetValue(n, value)
    RANKS.AllReduce(own, sums, vtkCommunicator.SUM_OP)
    return [sums.GetValue(n) for n in range(len(values))]


def rows(table):
    return [[str(table.GetValue(row, column)) for column in range(table.GetNumberOfColumns())]
            for row in range(table.GetNumberOfRows())]


def names(collection):
    return [collection.GetMetaData(n).Get(vtkCompositeDataSet.NAME())
            for n in range(collection.GetNumberOfPartitionedDataSets())]


def check_same(found, expected, label):
    """A collection of which this rank has a part is that of one process, and each horizon is on one rank."""
    if found.IsA("vtkTable"):
        assert rows(found) == (rows(expected) if OWN == 0 else []), label
        return
    assert names(found) == names(expected), (label, names(found), names(expected))
    own, everything = mesh_checks.blocks(found), mesh_checks.blocks(expected)
    for name, horizon in own.items():
        pipelines.assert_same(horizon, everything[name])
        pipelines.assert_same_fields(horizon, everything[name])
    assert add_up([name in own for name in everything]) == [1] * len(everything), label


def check_chain(**properties):
    """The chain on one process, and on all of them."""
    expected = make_chain(make_reader(**properties))
    found = make_chain(make_reader(**properties))
    for stage, serial in zip(found, expected):
        serial.Update()
        stage.UpdatePiece(OWN, SIZE, 0)
        for data, serial_data in zip(outputs(stage), outputs(serial)):
            check_same(data, serial_data, stage.GetClassName())
        if hasattr(stage, "GetResults") and stage.IsA("vtkHorizonAlgorithm"):  # of all horizons, on each rank
            assert stage.GetResults() == serial.GetResults() != "", (OWN, stage.GetResults(), serial.GetResults())


def check_places(horizons):
    """Wherever horizons lie, the result is the same."""
    for rank_of in (lambda n: (n + 1) % SIZE, lambda n: SIZE - 1):
        for name, properties in CHAIN[:3] + [("HorizonSurface", {})]:
            stage, serial = make(name, properties), make(name, properties)
            stage.SetInputDataObject(deal(horizons, rank_of))
            serial.SetInputDataObject(deal(horizons, lambda n: OWN))
            serial.Update()
            stage.UpdatePiece(OWN, SIZE, 0)
            check_same(stage.GetOutputDataObject(0), serial.GetOutputDataObject(0), name)


def count_errors(stages):
    counts = [0] * len(stages)
    for n, stage in enumerate(stages):
        def add(*_, n=n):
            counts[n] += 1
        stage.AddObserver("ErrorEvent", add)
        stage.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)  # it says that there was an error
    return counts


def check_nothing(stages):
    for stage in stages:
        for data in outputs(stage):
            points = data.GetNumberOfRows() if data.IsA("vtkTable") else data.GetNumberOfPoints()
            assert points == 0, (OWN, stage.GetClassName(), points)


def check_broken(horizons):
    """A horizon that only the last rank has, and has no lattice, gives one error in all; nobody waits in later stages."""
    broken = vtkPolyData()
    broken.DeepCopy(next(iter(horizons.values())))
    broken.GetFieldData().Initialize()
    data = deal(dict(horizons, broken=broken), lambda n: SIZE - 1 if n == len(horizons) else n % SIZE)
    for first in ("HorizonDespiking", "HorizonHoleFilling", "HorizonFaults", "HorizonExteriorBoundary", "HorizonSurface"):
        stages = [make(first, {})]
        stages[0].SetInputDataObject(data)
        stages.append(make("HorizonSurface" if first != "HorizonSurface" else "HorizonTriangulation", {}, stages[0]))
        stages.append(make("HorizonSurfaceDistance", {}, stages[0], stages[1]))
        errors = count_errors(stages)
        stages[-1].UpdatePiece(OWN, SIZE, 0)
        assert add_up(errors) == [1, 0, 0], (first, add_up(errors))
        assert errors[0] == (OWN == SIZE - 1), (first, errors)
        check_nothing(stages)


def check_wrong_file():
    """A file that one machine does not have, and one that is missing everywhere."""
    for missing in ([SIZE - 1], range(SIZE)):
        stages = make_chain(make_reader("missing.vsm" if OWN in missing else SAMPLE))
        errors = count_errors(stages)
        stages[-1].UpdatePiece(OWN, SIZE, 0)
        # Once for the list of horizons, and once for the data, there by the first that misses it.
        expected = (OWN in missing) + (OWN == missing[0] and SIZE > 1)
        assert errors == [expected] + [0] * (len(stages) - 1), (OWN, missing, errors)
        check_nothing(stages)


def make_table(names):
    """Picks of horizons on a turned lattice, more of each than of the one before."""
    table = vtkTable()
    columns = {"Name": vtkStringArray(), "X": vtkDoubleArray(), "Y": vtkDoubleArray(), "Z": vtkDoubleArray()}
    for n, name in enumerate(names):
        for i in range(8):
            for j in range(8 + n):
                for key, value in zip(columns, (name, 4.0 * i - 3.0 * j, 3.0 * i + 4.0 * j, 10.0 * n + i)):
                    columns[key].InsertNextValue(value)
    for key, array in columns.items():
        array.SetName(key)
        table.AddColumn(array)
    return table


def check_points():
    """Horizons of a table, the largest of which goes to the first rank, and of an image, which VTK would cut."""
    names_of = ["Top", "Middle", "Base", "Floor"]
    image = vtkRTAnalyticSource()
    image.SetWholeExtent(0, 30, 0, 20, 0, 0)
    for name, data in (("HorizonFromPoints", make_table(names_of)), ("HorizonFromImage", None)):
        stages = [make(name, {}) for _ in range(2)]
        for stage in stages:
            if data:
                stage.SetInputDataObject(data)
            else:
                stage.SetInputConnection(image.GetOutputPort())
        stages[0].UpdatePiece(OWN, SIZE, 0)
        stages[1].Update()
        check_same(stages[0].GetOutputDataObject(0), stages[1].GetOutputDataObject(0), name)
        if data and OWN == 0 and SIZE < 5:
            assert "Floor" in mesh_checks.blocks(stages[0].GetOutputDataObject(0))
    different = make("HorizonFromPoints", {})
    different.SetInputDataObject(make_table(names_of if OWN == 0 else names_of[:2]))
    errors = count_errors([different])
    different.UpdatePiece(OWN, SIZE, 0)
    assert errors == [1 if OWN == 0 and SIZE > 1 else 0], errors
    if SIZE > 1:
        check_nothing([different])


def main():
    assert SIZE == int(sys.argv[2]), "%d ranks, expected %s" % (SIZE, sys.argv[2])
    check_chain()
    check_chain(LeastMemory=True, RowRange=(20, 150))
    reader = make_reader()
    reader.Update()
    horizons = mesh_checks.blocks(reader.GetOutputDataObject(0))
    check_places(horizons)
    check_points()
    check_broken(horizons)
    check_wrong_file()
    print("rank %d of %d: done" % (OWN, SIZE))


main()
