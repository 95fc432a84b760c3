# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The way from a file to meshes, with the classes alone and with the proxies of ParaView."""

POINT_ARRAYS = ("SurfaceId", "VerticalIndex", "Thickness", "Amplitude", "RealZ")
BOUNDARY_ARRAYS = ("PatchId", "Boundary")
FIELD_ARRAYS = ("LatticeDimensions", "LatticeToWorld", "VerticalDirection", "DroppedDuplicates")
STAGES = ("HorizonExteriorBoundary", "HorizonBoundarySimplification", "HorizonRoughSimplification",
          "HorizonTriangulation")
CHOSEN = ["Horizon 1", "Horizon 3"]
FAULT = "1455.0 1922.5 0\n1205.0 2922.5 0\n999.0 999.0 999.0\n"  # between columns 20 and 21 of all_stages


def with_classes(path):
    """The outputs of all stages as a list, reader first."""
    from seismichorizons import vtk as sh

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


def write_fault(folder):
    """A file with the fault line that all_stages takes."""
    path = folder / "fault.pol"
    path.write_text(FAULT, encoding="utf-8")
    return path


def all_stages(sample, fault):
    """All stages of the menu that take horizons, each with parameters that are not the defaults. Proxies by their names."""
    from paraview import simple

    made = {}

    def add(name, kind, **properties):
        made[name] = getattr(simple, kind)(registrationName=name, **properties)
        return made[name]

    points = add("points", "VerneySparseMatrixReader", FileName=str(sample), HorizonStatus=CHOSEN,
                 Origin=[1000.0, 2000.0, -50.0], ColumnStep=[20.0, 5.0], RowStep=[-5.0, 20.0], VerticalStep=4.0)
    lines = add("lines", "FaultLinesReader", FileName=str(fault), VerticalDirection="Up")
    quiet = add("quiet", "HorizonDespiking", Input=points, Threshold=2.5, NeighborhoodRadius=2)
    cut = add("cut", "HorizonFaults", Input=quiet, FaultLines=lines, SmallestThrow=4.5)
    whole = add("whole", "HorizonHoleFilling", Input=cut, LargestHoleSize=40, Method="Membrane")
    add("surface", "HorizonSurface", Input=whole, MaximumError=1.5, AutomaticRadius=0, Radius=2)
    outline = add("outline", "HorizonExteriorBoundary", Input=whole, Radius=2, GrowthStrategy="Clockwise",
                  MinimumPatchSize=9)
    loops = add("loops", "HorizonBoundarySimplification", Input=outline, DistanceThreshold=0.7)
    thin = add("thin", "HorizonRoughSimplification", Input=loops, CellSize=4)
    add("few", "HorizonElaborateSimplification", Input=loops, Representative="Nearest Point")
    mesh = add("mesh", "HorizonTriangulation", Input=thin)
    add("least", "HorizonDecimation", Input=loops, MaximumError=2.0)
    add("distance", "HorizonSurfaceDistance", Reference=points, Mesh=mesh, SamplesPerPoint=2.0)
    return made


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
