# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Sources of horizons: their input, and the assembly of what they and the stages give. Argument: a folder for files."""

import pathlib
import shutil
import sys
import unittest

from seismichorizons import vtk as sh
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPartitionedDataSetCollection, vtkPolyData

FOLDER = pathlib.Path(sys.argv[1]).resolve()
NAMES = ["Top Reek", "Base (2)", "日本"]


def points():
    """Those of a plane of 5 x 4 columns."""
    places = vtkPoints()
    for j in range(4):
        for i in range(5):
            places.InsertNextPoint(25.0 * i, 25.0 * j, 7.0)
    data = vtkPolyData()
    data.SetPoints(places)
    return data


def image(depth=1):
    """5 x 4 columns of one value, or with one strong sample each."""
    values = vtkFloatArray()
    values.SetName("Amplitude")
    for k in range(depth):
        for _ in range(20):
            values.InsertNextValue(1.0 if 2 * k in (depth - 1, depth) else 0.0)
    data = vtkImageData()
    data.SetDimensions(5, 4, depth)
    data.GetPointData().SetScalars(values)
    return data


def picks():
    path = FOLDER / "picks.dat"
    path.write_text("".join('"%s"\t%d\t%d\t%d\t%d\t%d\n' % (name, j, i, 25 * i, 25 * j, 9 + i)
                            for name in NAMES for j in range(4) for i in range(5)), encoding="utf-8")
    return path


def labels(collection):
    """The label and the number of the dataset of each node of the assembly."""
    assembly = collection.GetDataAssembly()
    nodes = [assembly.GetChild(0, n) for n in range(assembly.GetNumberOfChildren(0))]
    return [(assembly.GetAttributeOrDefault(node, "label", ""), list(assembly.GetDataSetIndices(node))) for node in nodes]


class SourcesTest(unittest.TestCase):
    def test_input_data(self):
        """As a connection, or with a port; None takes it away. The input comes whole, and is asked for again."""
        for source, data in ((sh.vtkHorizonFromPoints(), points()), (sh.vtkHorizonFromImage(), image()),
                             (sh.vtkSeismicReflectionExtraction(), image(9))):
            with self.subTest(source.GetClassName()):
                if hasattr(source, "SetSmallestSize"):
                    source.SetSmallestSize(1)
                for given in ((data,), (0, data)):
                    source.SetInputData(*given)
                    source.Update()
                    self.assertEqual(source.GetOutput().GetPartition(0, 0).GetNumberOfPoints(), 20)
                self.assertIs(source.GetInputDataObject(0, 0), data)
                self.assertEqual(source.GetNumberOfHorizons(), 1)
                source.SetInputData(None)
                self.assertEqual(source.GetNumberOfInputConnections(0), 0)

    def test_assembly(self):
        """A node for each horizon, from the reader through all stages; the choice of horizons is that of nodes."""
        reader = sh.vtkHorizonTextReader()
        reader.SetFileName(str(picks()))
        stage = reader
        for following in (sh.vtkHorizonDespiking(), sh.vtkHorizonFaults(), sh.vtkHorizonHoleFilling(),
                          sh.vtkHorizonExteriorBoundary(), sh.vtkHorizonBoundarySimplification(),
                          sh.vtkHorizonRoughSimplification(), sh.vtkHorizonElaborateSimplification(),
                          sh.vtkHorizonTriangulation()):
            following.SetInputConnection(stage.GetOutputPort())
            following.Update()
            stage = following
            self.assertEqual(labels(stage.GetOutputDataObject(0)), [(name, [n]) for n, name in enumerate(NAMES)],
                             stage.GetClassName())
        surface = sh.vtkHorizonSurface()
        surface.SetInputConnection(reader.GetOutputPort())
        surface.Update()
        self.assertEqual(labels(surface.GetOutputDataObject(0)), labels(stage.GetOutputDataObject(0)))
        reader.SetHorizonStatus(NAMES[1], 0)
        stage.Update()
        self.assertEqual(labels(stage.GetOutputDataObject(0)), [(NAMES[0], [0]), (NAMES[2], [1])])
        self.assertEqual(labels(stage.GetOutputDataObject(0)), labels(reader.GetOutput()))

    def test_none(self):
        """Data of others without an assembly come out without one."""
        collection = vtkPartitionedDataSetCollection()
        source = sh.vtkHorizonFromPoints()
        source.SetInputData(points())
        source.Update()
        collection.SetPartition(0, 0, source.GetOutput().GetPartition(0, 0))
        stage = sh.vtkHorizonExteriorBoundary()
        stage.SetInputDataObject(0, collection)
        stage.Update()
        self.assertIsNone(stage.GetOutputDataObject(0).GetDataAssembly())


if __name__ == "__main__":
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    unittest.main(argv=["sources_test"], verbosity=2)
