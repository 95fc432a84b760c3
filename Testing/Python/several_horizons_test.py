# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in pvbatch on any number of ranks, the same on each (--symmetric): each filter of several horizons gives on all ranks,
wherever horizons are, what it gives on one process; takes two squares far apart in little memory; takes horizons on every
second line at their full volume; and stops in each tenth of its work.

Argument: how many ranks there are to be.
"""

import os
import pathlib
import sys
import time

import numpy as np
from seismichorizons import vtk as sh
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray, vtkIntArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataObjectTree, vtkPolyData
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

from dealing import deal

RANKS = vtkMultiProcessController.GetGlobalController()
OWN, SIZE = RANKS.GetLocalProcessId(), RANKS.GetNumberOfProcesses()
STEP = 25.0  # of a column
THICK = 40.0
MOST_KB, MOST_SECONDS = 80 << 10, 10.0
CLEAR = "/proc/self/clear_refs"


def named(name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=1)
    array.SetName(name)
    return array


def make(columns, z, step=(1, 1), dimensions=None):
    """A horizon at columns of the survey, on a lattice of steps of several columns."""
    columns = np.asarray(columns)
    to_world = np.diag([STEP * step[0], STEP * step[1], 1.0, 1.0])
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.column_stack((STEP * columns, z)).astype(float), deep=1))
    horizon = vtkPolyData()
    horizon.SetPoints(points)
    size = columns.max(axis=0) // step + 1 if dimensions is None else dimensions
    horizon.GetFieldData().AddArray(named("LatticeDimensions", np.array([*size, 3000], np.int32)))
    horizon.GetFieldData().AddArray(named("LatticeToWorld", to_world.ravel()))
    return horizon


def height(columns):
    x, y = np.asarray(columns, dtype=float).T
    return 2000.0 + 12.0 * np.sin(x / 9.0) * np.cos(y / 7.0)


def grid(width, height_, step=(1, 1)):
    return np.array([(i, j) for j in range(0, height_, step[1]) for i in range(0, width, step[0])])


def stack_of(columns, below=None, noise=0.0, **keywords):
    """Two horizons, by names; the lower one at other columns, on another lattice, say."""
    below = columns if below is None else below
    draw = np.random.default_rng(3)
    return {"Top": make(columns, height(columns) + THICK + noise * draw.normal(size=len(columns))),
            "Base": make(below, height(below) + noise * draw.normal(size=len(below)), **keywords)}


def meshes_of(stack):
    return {name: alone("HorizonSurface", [{"mesh": points}], MaximumError=0.5)[0]["mesh"] for name, points in stack.items()}


# ---- Filters -----------------------------------------------------------------------------------------------------------
def together(stack):
    return [stack]


def with_other(stack):
    return [{"Top": stack["Top"]}, {"Base": stack["Base"]}]


def of_meshes(stack):
    return [meshes_of(stack)]


def to_meshes(stack):
    return [stack, meshes_of(stack)]


def with_sticks(stack):
    """A fault across both horizons, whose throw is 0."""
    places, cells = vtkPoints(), vtkCellArray()
    for n, y in enumerate((-1.0, 10.0, 110.0)):
        for z in (1900.0, 2200.0):
            places.InsertNextPoint(STEP * 14.3 + 0.5 * (z - 2000.0), STEP * y, z)
        cells.InsertNextCell(2, (2 * n, 2 * n + 1))
    sticks = vtkPolyData()
    sticks.SetPoints(places)
    sticks.SetLines(cells)
    return [stack, {"Fault": sticks}]


# Label: class, inputs of its ports, and how many of these are on all ranks as a whole, from the last on.
FILTERS = {
    "thickness": ("HorizonThickness", together, 0),
    "thickness, other": ("HorizonThickness", with_other, 1),
    "thickness of meshes": ("HorizonThickness", of_meshes, 0),
    "crossings": ("HorizonCrossings", together, 1),
    "layers": ("HorizonLayers", together, 1),
    "distance": ("HorizonSurfaceDistance", to_meshes, 0),
    "cutoffs": ("HorizonCutoffs", with_sticks, 2),
    "sealed": ("HorizonSealedModel", with_sticks, 2),
}


WIDE = {"layers", "cutoffs", "sealed"}  # which take memory for what is empty, or have a fault in one place


def prepare(class_name, inputs, rank_of, whole=0, **properties):
    stage = getattr(sh, "vtk" + class_name)()
    for key, value in properties.items():
        getattr(stage, "Set" + key)(value)
    for port, horizons in enumerate(inputs):
        is_whole = port >= len(inputs) - whole
        stage.SetInputDataObject(port, deal(horizons, (lambda n: OWN) if is_whole else rank_of))
    stage.told = []
    stage.AddObserver("ErrorEvent", lambda *_: stage.told.append("error"))
    stage.AddObserver("WarningEvent", lambda *_: stage.told.append("warning"))
    return stage


def leaves(data):
    """The datasets of an output that are not empty, by names."""
    if not isinstance(data, vtkDataObjectTree):
        return {"": data} if data.GetNumberOfElements(data.ROW if data.IsA("vtkTable") else data.POINT) else {}
    found = {}
    for n in range(data.GetNumberOfPartitionedDataSets()):
        leaf = data.GetPartition(n, 0)
        if leaf is not None and leaf.GetNumberOfPoints():
            found[data.GetMetaData(n).Get(data.NAME())] = leaf
    return found


def outputs(stage):
    return [leaves(stage.GetOutputDataObject(port)) for port in range(stage.GetNumberOfOutputPorts())]


def alone(class_name, inputs, **properties):
    """The outputs of one process."""
    stage = prepare(class_name, inputs, lambda n: OWN, **properties)
    stage.Update()
    assert "error" not in stage.told, class_name
    return outputs(stage)


def content(data):
    """All that a dataset has, as bytes."""
    found = {}
    for kind in ("GetPointData", "GetCellData", "GetRowData", "GetFieldData"):
        arrays = getattr(data, kind)() if hasattr(data, kind) else None
        for n in range(arrays.GetNumberOfArrays() if arrays else 0):
            array = arrays.GetAbstractArray(n)
            values = (vtk_to_numpy(array).tobytes() if isinstance(array, vtkDataArray) else
                      [str(array.GetVariantValue(value)) for value in range(array.GetNumberOfValues())])
            found[kind, array.GetName()] = values
    if hasattr(data, "GetPoints"):
        found["points"] = vtk_to_numpy(data.GetPoints().GetData()).tobytes()
    for kind in ("GetVerts", "GetLines", "GetPolys", "GetCells"):
        cells = getattr(data, kind)() if hasattr(data, kind) else None
        if hasattr(cells, "GetConnectivityArray") and cells.GetNumberOfCells():  # not of an image
            found[kind] = vtk_to_numpy(cells.GetConnectivityArray()).tolist()
    return found


def add_up(values):
    """The sums over all ranks."""
    own, sums = vtkIntArray(), vtkIntArray()
    for array in (own, sums):
        array.SetNumberOfValues(len(values))
    for n, value in enumerate(values):
        own.SetValue(n, int(value))
    RANKS.AllReduce(own, sums, vtkCommunicator.SUM_OP)
    return [sums.GetValue(n) for n in range(len(values))]


# ---- Checks ------------------------------------------------------------------------------------------------------------
def check_ranks(label):
    """Wherever horizons are, each output is on one rank, and what it is on one process."""
    class_name, inputs_of, whole = FILTERS[label]
    inputs = inputs_of(stack_of(grid(30, 20)))
    expected = alone(class_name, inputs)
    for rank_of in (lambda n: n % SIZE, lambda n: (SIZE - 1 - n) % SIZE, lambda n: SIZE - 1):
        stage = prepare(class_name, inputs, rank_of, whole)
        stage.UpdatePiece(OWN, SIZE, 0)
        # That the fault has no throw is said.
        assert set(stage.told) <= ({"warning"} if label == "sealed" else set()), (label, stage.told)
        for found, wanted in zip(outputs(stage), expected):
            for name, data in found.items():
                assert content(data) == content(wanted[name]), (label, name)
            assert add_up([name in found for name in wanted]) == [1] * len(wanted), (label, found, list(wanted))


def peak():
    status = pathlib.Path("/proc/self/status").read_text()
    return int(status.split("VmHWM:")[1].split()[0])


def check_apart(label):
    """Two squares of 12 x 12 columns far apart take the memory and the time of two squares."""
    class_name, inputs_of, _ = FILTERS[label]
    square = grid(12, 12)
    for apart in ((20000, 20000), (1 << 27, 0)):
        columns = np.vstack((square, square + apart))
        inputs = inputs_of(stack_of(columns))
        expected = alone(class_name, inputs_of(stack_of(square)))
        start = time.monotonic()
        if OWN == 0 and os.access(CLEAR, os.W_OK):
            pathlib.Path(CLEAR).write_text("5")  # the peak is what is taken now
            before = peak()
            found = alone(class_name, inputs)
            assert peak() - before < MOST_KB, (label, apart, peak() - before)
        else:
            found = alone(class_name, inputs)
        assert time.monotonic() - start < MOST_SECONDS * SIZE, (label, apart, time.monotonic() - start)
        for name, data in expected[0].items():
            assert found[0][name].GetNumberOfPoints() == 2 * data.GetNumberOfPoints(), (label, apart, name)


def field(data, name):
    return vtk_to_numpy(data.GetFieldData().GetArray(name)).ravel()


def check_thickness(found, area):
    for data in found[0].values():
        np.testing.assert_allclose(field(data, "IsochoreVolume"), THICK * area, rtol=0.01)
        np.testing.assert_allclose(field(data, "LedgerArea").sum(), area, rtol=1e-12)
        assert field(data, "LedgerColumns")[4] == 0, field(data, "LedgerColumns")


def check_crossings(found, _area):
    assert all(field(data, "MovedColumns") == 0 for data in found[0].values())


def check_distance(found, _area):
    largest = [field(data, "LargestDistance").max() for data in found[0].values()]
    assert max(largest, default=0.0) < 2.5, largest


LINES = {"thickness": check_thickness, "thickness, other": check_thickness, "crossings": check_crossings,
         "distance": check_distance}


def check_lines(label):
    """Horizons on every second line, of a lattice of their own or of that of all lines, above or below others."""
    class_name, inputs_of, _ = FILTERS[label]
    columns = grid(40, 30)
    for step in ((2, 1), (1, 2), (2, 2)):
        some = grid(40, 30, step)
        for below in ({"step": step}, {"dimensions": (40, 30)}):
            stack = stack_of(columns, some, **below)
            for inputs in (inputs_of(stack), inputs_of(dict(zip(stack, reversed(stack.values()))))):
                LINES[label](alone(class_name, inputs), 40 * 30 * STEP * STEP)


def check_abort(label):
    """A filter that is stopped, by the processes that work, as soon as it says that any number of tenths is done, has no
    output, and says nothing; then it runs again as before."""
    class_name, inputs_of, whole = FILTERS[label]
    inputs = inputs_of(stack_of(grid(150, 100), noise=8.0))
    stage = prepare(class_name, inputs, lambda n: n % SIZE, whole)
    stop = getattr(stage, "SetAbortExecuteAndUpdateTime", lambda: stage.SetAbortExecute(1))
    asked = []

    def listen(*_):
        if tenth / 10 <= stage.GetProgress() < 1 and not asked:
            asked.append(stage.GetProgress())
            stop()

    stage.AddObserver("ProgressEvent", listen)
    for tenth in range(10):
        asked.clear()
        stage.SetAbortExecute(0)
        stage.Modified()
        stage.UpdatePiece(OWN, SIZE, 0)
        assert add_up([bool(asked)])[0] > 0, (label, tenth)
        assert not any(outputs(stage)) and "error" not in stage.told, (label, tenth, asked, outputs(stage), stage.told)
    stage.SetAbortExecute(0)
    tenth = 10
    stage.Modified()
    stage.UpdatePiece(OWN, SIZE, 0)
    assert add_up([len(outputs(stage)[0])])[0] > 0, label


def main():
    assert int(sys.argv[1]) == SIZE, SIZE
    for label in FILTERS:
        for check in (check_ranks, check_abort, *([check_apart] if label not in WIDE else []),
                      *([check_lines] if label in LINES else [])):
            start = time.monotonic()
            check(label)
            if OWN == 0:
                print("%s: %s in %.1f s" % (label, check.__name__, time.monotonic() - start), flush=True)


main()
