# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in pvbatch on two ranks, the same on each (--symmetric): stages when horizons lie on ranks in unusual ways.

Arguments: the folder of the data.
"""

import pathlib
import sys

import numpy
from seismichorizons import vtk as sh
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkExtractCells
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import mesh_checks
from dealing import deal

RANKS = vtkMultiProcessController.GetGlobalController()
OWN = RANKS.GetLocalProcessId()


def alone(name, *inputs, port=0, **properties):
    """The output of a stage that this process runs without the others."""
    stage = getattr(sh, "vtk" + name)()
    for key, value in properties.items():
        getattr(stage, "Set" + key)(value)
    for number, data in enumerate(inputs):
        stage.SetInputDataObject(number, data)
    stage.Update()
    return stage.GetOutputDataObject(port)


def run(name, *inputs, port=0, **properties):
    """The output of a stage that all run, and the numbers of its errors and warnings here."""
    stage = getattr(sh, "vtk" + name)()
    for key, value in properties.items():
        getattr(stage, "Set" + key)(value)
    for number, data in enumerate(inputs):
        stage.SetInputDataObject(number, data)
    texts = {"ErrorEvent": [], "WarningEvent": []}
    for event, found in texts.items():
        stage.AddObserver(event, lambda *_, found=found: found.append(event))
    stage.UpdatePiece(OWN, RANKS.GetNumberOfProcesses(), 0)
    return stage.GetOutputDataObject(port), len(texts["ErrorEvent"]), len(texts["WarningEvent"])


def rows(table):
    return [[str(table.GetValue(row, column)) for column in range(table.GetNumberOfColumns())]
            for row in range(table.GetNumberOfRows())]


def points(data):
    return data.GetNumberOfPoints()


def check_pairs(horizons, meshes):
    """Meshes on other ranks than their horizons: the same figures in one table, and colours on each mesh."""
    everything = alone("HorizonSurfaceDistance", deal(horizons, lambda n: OWN), deal(meshes, lambda n: OWN), port=2)
    reference = deal(horizons, lambda n: n % 2)
    for shift in (0, 1):
        mesh = deal(meshes, lambda n, shift=shift: (n + shift) % 2)
        table, errors, _ = run("HorizonSurfaceDistance", reference, mesh, port=2)
        assert errors == 0
        assert rows(table) == (rows(everything) if OWN == 0 else []), (shift, rows(table), rows(everything))
        measured, _, _ = run("HorizonSurfaceDistance", reference, mesh, port=1)
        found = mesh_checks.blocks(measured)
        assert len(found) == len(mesh_checks.blocks(mesh)) > 0, (shift, found)
        for name, block in found.items():
            assert points(block) == points(meshes[name])
            assert len(mesh_checks.array(block, "Distance")) == points(block)


def check_missing(horizons, meshes):
    """A horizon without a mesh on any rank: nobody has a result, and the first rank says why."""
    fewer = dict(list(meshes.items())[:1])
    for port in (0, 1, 2):
        data, errors, _ = run("HorizonSurfaceDistance", deal(horizons, lambda n: n % 2), deal(fewer, lambda n: 1),
                              port=port)
        assert errors >= 1 if OWN == 0 else errors == 0, errors
        assert (data.GetNumberOfRows() if port == 2 else points(data)) == 0


def check_split(horizon):
    """A horizon of which each rank has a part is refused; one that only one rank has is not."""
    half = vtkExtractCells()
    half.SetInputData(horizon)
    half.AddCellRange(*((0, 999) if OWN == 0 else (1000, 1999)))
    surface = vtkGeometryFilter()
    surface.SetInputConnection(half.GetOutputPort())
    surface.Update()
    part = surface.GetOutput()
    part.GetFieldData().PassData(horizon.GetFieldData())
    assert points(part) == 1000
    for data in (part, deal({"Horizon 1": part}, lambda n: OWN)):
        output, errors, _ = run("HorizonExteriorBoundary", data)
        assert points(output) == 0
        assert errors == (1 if OWN == 0 else 0), errors
    output, errors, _ = run("HorizonExteriorBoundary", horizon if OWN == 1 else vtkPolyData())
    assert errors == 0
    assert points(output) == (points(horizon) if OWN == 1 else 0)


def check_large(like):
    """Ranks mesh three bands of one horizon together: the same as the one that has its points. All end if it is refused."""
    side = 3600
    horizon = vtkPolyData()
    if OWN == 1:
        x, y = numpy.meshgrid(numpy.arange(side, dtype=float), numpy.arange(side, dtype=float))
        z = numpy.rint(200 + 150 * numpy.sin(x / 300) * numpy.cos(y / 400))
        places = vtkPoints()
        places.SetDataTypeToDouble()
        places.SetData(numpy_to_vtk(numpy.stack([x.ravel(), y.ravel(), z.ravel()], 1), deep=True))
        horizon.SetPoints(places)
    refused, errors, _ = run("HorizonSurface", horizon)
    assert points(refused) == 0
    assert errors == OWN, errors
    horizon.GetFieldData().PassData(like.GetFieldData())
    size = numpy_to_vtk(numpy.array([side, side, 400], dtype=numpy.int32), deep=True)
    size.SetName("LatticeDimensions")
    horizon.GetFieldData().RemoveArray("LatticeDimensions")
    horizon.GetFieldData().AddArray(size)
    together, errors, _ = run("HorizonSurface", horizon, MaximumError=2.0)
    assert errors == 0
    assert (points(together) > 0) == (OWN == 1)
    if OWN == 1:
        mesh = alone("HorizonSurface", horizon, MaximumError=2.0)
        for of in (lambda data: data.GetPoints().GetData(), lambda data: data.GetPolys().GetConnectivityArray()):
            assert numpy.array_equal(vtk_to_numpy(of(together)), vtk_to_numpy(of(mesh)))


def check_extraction():
    """Surfaces of a cube: each rank has every second one, as one process has them all."""
    wavelet = vtkRTAnalyticSource()
    wavelet.SetWholeExtent(0, 30, 0, 25, -20, 20)
    wavelet.Update()
    cube = wavelet.GetOutput()
    amplitudes = vtk_to_numpy(cube.GetPointData().GetScalars())
    amplitudes -= 150.0
    everything = mesh_checks.blocks(alone("SeismicReflectionExtraction", cube, Order=1, SmallestSize=100))
    assert len(everything) >= 2, everything
    data, errors, _ = run("SeismicReflectionExtraction", cube, Order=1, SmallestSize=100)
    assert errors == 0
    own = mesh_checks.blocks(data)
    assert list(own) == list(everything)[OWN::2], (own, everything)
    for name, horizon in own.items():
        assert (mesh_checks.coordinates(horizon) == mesh_checks.coordinates(everything[name])).all(), name
    guides = alone("SeismicReflectionExtraction", cube, LargestNumber=2)
    guided = mesh_checks.blocks(run("SeismicReflectionExtraction", cube, guides)[0])
    assert len(guided) == 1, guided
    for name, horizon in mesh_checks.blocks(alone("SeismicReflectionExtraction", cube, guides)).items():
        assert name not in guided or points(guided[name]) == points(horizon), name


def check_invalid(horizons):
    """A horizon on one rank that has no lattice stops all, or is left out."""
    broken = {name: vtkPolyData() for name in horizons}
    for name, horizon in broken.items():
        horizon.DeepCopy(horizons[name])
    last = list(broken)[-1]
    broken[last].GetFieldData().Initialize()
    data = deal(broken, lambda n: 0 if list(broken)[n] != last else 1)
    for stage in ("HorizonExteriorBoundary", "HorizonSurface"):
        output, errors, warnings = run(stage, data)
        assert points(output) == 0
        assert (errors, warnings) == ((1, 0) if OWN == 1 else (0, 0)), (errors, warnings)
        output, errors, warnings = run(stage, data, InvalidHorizons=1)
        assert (errors, warnings) == ((0, 1) if OWN == 1 else (0, 0)), (errors, warnings)
        kept = {name for name, block in mesh_checks.blocks(output).items() if points(block)}
        assert kept == (set() if OWN == 1 else set(horizons) - {last}), kept


def main():
    assert RANKS.GetNumberOfProcesses() == 2, RANKS.GetNumberOfProcesses()
    reader = sh.vtkVerneySparseMatrixReader()
    reader.SetFileName(str(pathlib.Path(sys.argv[1]) / "blobs.vsm"))
    reader.Update()
    boundary = alone("HorizonExteriorBoundary", reader.GetOutputDataObject(0))
    horizons = mesh_checks.blocks(boundary)
    meshes = mesh_checks.blocks(alone("HorizonTriangulation", alone("HorizonRoughSimplification", boundary)))
    check_pairs(horizons, meshes)
    check_missing(horizons, meshes)
    check_split(next(iter(horizons.values())))
    check_invalid(horizons)
    check_extraction()
    check_large(next(iter(horizons.values())))
    print("rank %d: done" % OWN)


main()
