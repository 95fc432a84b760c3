# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The way from a file to meshes, with the classes alone and with the proxies of ParaView."""

POINT_ARRAYS = ("SurfaceId", "VerticalIndex", "Thickness", "Amplitude", "RealZ")
BOUNDARY_ARRAYS = ("PatchId", "Boundary")
FIELD_ARRAYS = ("LatticeDimensions", "LatticeToWorld", "VerticalDirection", "DroppedDuplicates")
STAGES = ("HorizonExteriorBoundary", "HorizonBoundarySimplification", "HorizonRoughSimplification",
          "HorizonTriangulation")


def with_classes(path):
    """The outputs of all stages as a list, reader first."""
    import seismichorizons as sh

    stage = sh.vtkVerneySparseMatrixReader()
    stage.SetFileName(str(path))
    stage.Update()
    outputs = [stage.GetOutputDataObject(0)]
    for name in STAGES:
        following = getattr(sh, "vtk" + name)()
        following.SetInputConnection(stage.GetOutputPort())
        following.Update()
        stage = following
        outputs.append(stage.GetOutputDataObject(0))
    return outputs


def with_proxies(path):
    """The proxies of all stages as a list, reader first."""
    from paraview import simple

    proxies = [simple.OpenDataFile(str(path))]
    for name in STAGES:
        proxies.append(getattr(simple, name)(Input=proxies[-1]))
    proxies[-1].UpdatePipeline()
    return proxies


def assert_same(first, second):
    """Two horizons have the same points, arrays and cells, bit for bit."""
    import numpy as np
    from vtkmodules.util.numpy_support import vtk_to_numpy

    assert first.GetNumberOfPoints() == second.GetNumberOfPoints()
    assert (vtk_to_numpy(first.GetPoints().GetData()) == vtk_to_numpy(second.GetPoints().GetData())).all()
    for kind in ("Verts", "Lines", "Polys"):
        cells = [getattr(mesh, "Get" + kind)() for mesh in (first, second)]
        assert cells[0].GetNumberOfCells() == cells[1].GetNumberOfCells(), kind
        if cells[0].GetNumberOfCells():
            ids = [vtk_to_numpy(c.GetConnectivityArray()) for c in cells]
            assert np.array_equal(*ids), kind
    names = [[m.GetPointData().GetArrayName(n) for n in range(m.GetPointData().GetNumberOfArrays())]
             for m in (first, second)]
    assert sorted(names[0]) == sorted(names[1]), names
    for name in names[0]:
        values = [vtk_to_numpy(m.GetPointData().GetArray(name)) for m in (first, second)]
        assert values[0].dtype == values[1].dtype and values[0].tobytes() == values[1].tobytes(), name


def assert_same_fields(first, second):
    """Two datasets have the same field data."""
    fields = [[_values(data.GetFieldData().GetAbstractArray(n)) for n in range(data.GetFieldData().GetNumberOfArrays())]
              for data in (first, second)]
    assert sorted(fields[0]) == sorted(fields[1]), fields


def _values(array):
    return array.GetName(), [str(array.GetVariantValue(n)) for n in range(array.GetNumberOfValues())]
