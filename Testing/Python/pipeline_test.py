# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in pvpython: from file to mesh through the proxies of ParaView. Argument: the folder of the data."""

import pathlib
import sys

# Before any object of these classes comes out of a proxy: Python would take it for one of a base class, for good.
import seismichorizons.vtk  # noqa: F401

import mesh_checks
import pipelines


def fetch(proxy):
    """The data of a proxy; the server is this process itself, so they are at hand."""
    return mesh_checks.blocks(proxy.GetClientSideObject().GetOutputDataObject(0))


def check_arrays(number, horizon):
    expected = pipelines.POINT_ARRAYS + (pipelines.BOUNDARY_ARRAYS if number else ())
    for name in expected:
        assert horizon.GetPointData().GetArray(name) is not None, "stage %d lacks %s" % (number, name)
    for name in pipelines.FIELD_ARRAYS:
        assert horizon.GetFieldData().GetArray(name) is not None, "stage %d lacks %s" % (number, name)


def check_counts(stages):
    """Each stage thins out or keeps, and no point of the file is lost from the counts."""
    points = [horizon.GetNumberOfPoints() for horizon in stages]
    assert points[0] == points[1] >= points[2] > points[3] == points[4], points
    total = [int(mesh_checks.counts(horizon).sum()) for horizon in stages]
    assert len(set(total)) == 1 and total[0] == points[0], total
    outlines = [len(mesh_checks.loops(horizon)) for horizon in stages[1:]]
    assert len(set(outlines)) == 1 and outlines[0] >= 1, outlines
    dots = [sum(len(loop) for loop in mesh_checks.loops(horizon)) for horizon in stages[1:]]
    assert dots[0] > dots[1] == dots[2] == dots[3], dots


def check_selection(reader, names):
    """Only the horizons that are switched on are loaded."""
    reader.HorizonStatus = [names[0]]
    reader.UpdatePipeline()
    assert list(fetch(reader)) == [names[0]]
    reader.HorizonStatus = names
    reader.UpdatePipeline()
    assert list(fetch(reader)) == names


def check_distance(reader, mesh):
    """The reference may be points, and is meshed; horizons and meshes find each other by name."""
    from paraview import simple

    distance = simple.HorizonSurfaceDistance(Reference=reader, Mesh=mesh)
    distance.UpdatePipeline()
    algorithm = distance.GetClientSideObject()
    surfaces = [mesh_checks.blocks(algorithm.GetOutputDataObject(port)) for port in (0, 1)]
    assert list(surfaces[0]) == list(surfaces[1]) == list(fetch(reader)), surfaces
    for name, horizon in surfaces[0].items():
        assert len(mesh_checks.triangles(horizon)) > len(mesh_checks.triangles(surfaces[1][name]))
        for surface in (horizon, surfaces[1][name]):
            largest = surface.GetFieldData().GetArray("LargestDistance").GetComponent(2, 0)
            assert 0 < largest < 5, largest
            corners = mesh_checks.triangles(surface).ravel()
            assert (mesh_checks.array(surface, "Distance")[corners] <= largest).all()
    table = algorithm.GetOutputDataObject(2)
    assert table.GetNumberOfRows() == 9 * len(surfaces[0]), table.GetNumberOfRows()
    samples = table.GetValueByName(0, "Samples").ToInt()
    distance.SamplesPerPoint = 5.0
    distance.UpdatePipeline()
    more = algorithm.GetOutputDataObject(2).GetValueByName(0, "Samples").ToInt()
    assert more > 2 * samples, (samples, more)


def check_surface(reader):
    """Straight from the points; the choices of the panel reach the filter, and both outputs have all horizons."""
    from paraview import simple

    surface = simple.HorizonSurface(Input=reader, Target="Number Of Triangles", MaximumNumberOfTriangles=700,
                                    AutomaticRadius=0, Radius=3)
    surface.UpdatePipeline()
    algorithm = surface.GetClientSideObject()
    meshes, outlines = (mesh_checks.blocks(algorithm.GetOutputDataObject(port)) for port in (0, 1))
    assert list(meshes) == list(outlines) == list(fetch(reader)), (meshes, outlines)
    for name, mesh in meshes.items():
        assert 699 <= mesh_checks.check_mesh(mesh) <= 700, name
        assert mesh.GetFieldData().GetArray("ChosenRadius").GetValue(0) == 3
        assert outlines[name].GetNumberOfPoints() == fetch(reader)[name].GetNumberOfPoints()
    surface.Target, surface.MaximumError = "Largest Error", 0.75
    surface.UpdatePipeline()
    for mesh in mesh_checks.blocks(algorithm.GetOutputDataObject(0)).values():
        assert 0.5 < mesh.GetFieldData().GetArray("LargestError").GetValue(0) <= 0.75 + 1e-9
    simple.Delete(surface)


def told(proxy, name):
    """A figure that the panel shows."""
    proxy.UpdatePropertyInformation()
    return proxy.SMProxy.GetProperty(name).GetElement(0)


def check_filling(reader):
    """Spikes out and holes filled before all else; the choices of the panels reach the filters, which say what they did."""
    from paraview import simple

    despiking = simple.HorizonDespiking(Input=reader, Threshold=0.75, NeighborhoodRadius=3)
    filling = simple.HorizonHoleFilling(Input=despiking, LargestHoleSize=30, Method="Membrane", Attributes="Not A Number")
    filling.UpdatePipeline()
    left, filled = (sum(horizon.GetNumberOfPoints() for horizon in fetch(proxy).values()) for proxy in (despiking, filling))
    read = sum(horizon.GetNumberOfPoints() for horizon in fetch(reader).values())
    assert 0 < told(despiking, "NumberOfSpikes") == read - left, (read, left)
    assert told(filling, "NumberOfFilledHoles") > 0 and told(filling, "NumberOfOpenHoles") > 0
    assert told(filling, "NumberOfFilledPoints") == filled - left > 0, (left, filled)
    for horizon in fetch(filling).values():
        new = mesh_checks.array(horizon, "Filled") == 1
        assert (mesh_checks.counts(horizon)[new] == 0).all()
        amplitudes = mesh_checks.array(horizon, "Amplitude")
        assert (amplitudes[new] != amplitudes[new]).all()
    filling.LargestHoleSize = 10000
    filling.UpdatePipeline()
    assert told(filling, "NumberOfOpenHoles") == 0
    simple.Delete(filling)
    simple.Delete(despiking)


def check_table(folder):
    """What a panel tells of more than three horizons is a table, with the figures of each."""
    from paraview import simple

    def voxel(column, row, number):
        return "%d %d 1 0 0" % (60 * number + (column - 10) ** 2 // 9 + row // 3, number)

    path = folder / "five.vsm"
    size = 24
    path.write_text("%d %d 400\n" % (size, size) + "\n".join(
        " ".join(voxel(column, row, n) for n in range(1, 6)) for row in range(size) for column in range(size)) + "\n")
    surface = simple.HorizonSurface(Input=simple.VerneySparseMatrixReader(FileName=str(path)))
    surface.UpdatePipeline()
    lines = surface.GetClientSideObject().GetResults().splitlines()
    heads = lines[1].split()
    assert lines[0].startswith("5 horizons: ") and heads[0] == "horizon" and "error (z)" in lines[1], lines
    for line, (name, mesh) in zip(lines[2:7], fetch(surface).items()):
        assert line.startswith(name + " "), (line, name)
        row = dict(zip(lines[1].replace("horizon", "").replace(" (z)", "").split(), line[len(name):].split()))
        figures = mesh.GetFieldData()
        assert int(row["in"]) == size * size and int(row["points"]) == mesh.GetNumberOfPoints() and int(row["triangles"]) == mesh.GetNumberOfPolys(), line
        error = figures.GetArray("LargestError").GetValue(0)  # an index is 1 in z
        assert abs(float(row["error"]) - error) <= 5e-4 * error, (line, error)
        assert len(line) == len(lines[1]), lines
    simple.Delete(surface)


def check_faults(reader, folder):
    """Lines of a file cut links beside those that are found, or alone, and no more once they are taken away."""
    from paraview import simple

    path = folder / "fault.pol"
    path.write_text("20.5 -9.0 0\n20.5 900.0 0\n999.0 999.0 999.0\n", encoding="utf-8")
    lines = simple.OpenDataFile(str(path))
    faults = simple.HorizonFaults(Input=reader, FaultLines=lines, SmallestThrow=3.5)
    faults.UpdatePipeline()
    both = told(faults, "NumberOfFaultedLinks")
    assert told(faults, "MeasuredNoise") > 0
    faults.Detect = 0
    faults.UpdatePipeline()
    assert both >= told(faults, "NumberOfFaultedLinks") > 10 and told(faults, "NumberOfFaultLines") > 0
    algorithm = faults.GetClientSideObject()
    horizons, shown = (mesh_checks.blocks(algorithm.GetOutputDataObject(port)) for port in (0, 1))
    for name, horizon in horizons.items():
        cut = horizon.GetFieldData().GetArray("FaultedLinks")
        assert all(cut.GetTuple3(n)[::2] == (20, 0) for n in range(cut.GetNumberOfTuples())), name
        assert shown[name].GetNumberOfCells() == (cut.GetNumberOfTuples() > 0), name
    closed = simple.HorizonSurface(Input=faults, CloseFaults=1)
    closed.UpdatePipeline()
    for name, mesh in fetch(closed).items():
        walls = mesh.GetFieldData().GetArray("FaultTriangleCount").GetValue(0)
        assert (walls > 0) == (shown[name].GetNumberOfCells() > 0), name
        assert mesh.GetCellData().GetArray("Fault").GetRange() == (0.0, float(walls > 0)), name
    simple.Delete(closed)
    faults.FaultLines = None
    faults.UpdatePipeline()
    assert told(faults, "NumberOfFaultedLinks") == 0
    simple.Delete(faults)
    simple.Delete(lines)


def check_warped_maps(reader):
    """Maps that are warped by their elevation lie where the points are."""
    from paraview import simple
    from vtkmodules.util.numpy_support import vtk_to_numpy

    reader.UpdatePipeline()
    expected = {name: mesh_checks.coordinates(horizon).copy() for name, horizon in fetch(reader).items()}
    reader.OutputType = "Images"
    warped = simple.WarpByScalar(Input=reader)
    warped.Scalars = ["POINTS", "Elevation"]
    warped.UpdatePipeline()
    maps = mesh_checks.blocks(warped.GetClientSideObject().GetOutputDataObject(0))
    assert list(maps) == list(expected), maps
    for name, surface in maps.items():
        covered = vtk_to_numpy(surface.GetPointGhostArray()) == 0
        off = abs(mesh_checks.coordinates(surface)[covered] - expected[name]).max()
        assert off < 1e-3, off  # the warped points are in single precision
    reader.OutputType = "Points"
    reader.UpdatePipeline()


def check_reader_properties(reader):
    """The panel's choices reach the reader."""
    name, before = next(iter(fetch(reader).items()))
    points = mesh_checks.coordinates(before).copy()
    reader.Origin = [1000.0, 2000.0, -50.0]
    reader.ColumnStep = [20.0, 5.0]
    reader.RowStep = [-5.0, 20.0]
    reader.VerticalStep = 4.0
    reader.UpdatePipeline()
    moved = mesh_checks.coordinates(fetch(reader)[name])
    i, j, k = points.T  # k is negative: indices count downwards
    assert abs(moved[:, 0] - (1000.0 + 20.0 * i - 5.0 * j)).max() < 1e-9
    assert abs(moved[:, 1] - (2000.0 + 5.0 * i + 20.0 * j)).max() < 1e-9
    assert abs(moved[:, 2] - (-50.0 + 4.0 * k)).max() < 1e-9
    check_warped_maps(reader)
    reader.ZFrom = "Real Z"
    reader.UpdatePipeline()
    horizon = fetch(reader)[name]
    assert (mesh_checks.coordinates(horizon)[:, 2] == -mesh_checks.array(horizon, "RealZ")).all()
    check_warped_maps(reader)
    reader.VerticalDirection = "Up"
    reader.UpdatePipeline()
    horizon = fetch(reader)[name]
    assert (mesh_checks.coordinates(horizon)[:, 2] == mesh_checks.array(horizon, "RealZ")).all()
    reader.ZFrom = "Vertical Index"
    check_warped_maps(reader)


def main():
    sample = pathlib.Path(sys.argv[1]) / "blobs.vsm"
    proxies = pipelines.with_proxies(sample)
    outputs = [fetch(proxy) for proxy in proxies]
    names = list(outputs[0])
    assert len(names) >= 2 and names == sorted(names, key=lambda n: int(n.split()[-1])), names
    for number, output in enumerate(outputs):
        assert list(output) == names, output.keys()
        for horizon in output.values():
            check_arrays(number, horizon)
    direct = mesh_checks.blocks(pipelines.with_classes(sample)[-1])
    for name in names:
        check_counts([output[name] for output in outputs])
        mesh = outputs[-1][name]
        print("%s: %d triangles" % (name, mesh_checks.check_mesh(mesh)))
        pipelines.assert_same(mesh, direct[name])
    check_distance(proxies[0], proxies[-1])
    check_surface(proxies[0])
    check_filling(proxies[0])
    check_table(pathlib.Path.cwd())
    check_faults(proxies[0], pathlib.Path.cwd())
    check_selection(proxies[0], names)
    check_reader_properties(proxies[0])


main()
