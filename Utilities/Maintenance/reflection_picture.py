# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws a section of a cube of generate_cube with the picks of its horizons over the amplitudes, and the horizons.

usage: reflection_picture.py CUBE.sgy PICTURE.png      for Documentation/Pictures/reflections.png: --noise 0.2
"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter

import seismichorizons as sh
from seismichorizons import pictures

HEADER, TRACE_HEADER = 3600, 240
SCALE = 6, 3  # pixels for each trace and sample
COLORS = np.array([(214, 39, 40), (31, 119, 180), (44, 160, 44), (148, 103, 189), (255, 127, 14), (23, 190, 207),
                   (227, 119, 194), (140, 86, 75)], dtype=np.uint8)


def read(path):
    """The amplitudes by inline, crossline and sample: every trace is there in the cube that is drawn."""
    data = open(path, "rb").read()
    samples = int.from_bytes(data[3220:3222], "big")
    records = np.frombuffer(data[HEADER:], dtype=np.uint8).reshape(-1, TRACE_HEADER + 4 * samples)
    lines = records[:, 188:196].copy().view(">i4")
    traces = records[:, TRACE_HEADER:].copy().view(">f4").astype(np.float32)
    rows, columns = (len(np.unique(lines[:, n])) for n in (0, 1))
    return traces.reshape(rows, columns, samples)


def extract(cube):
    image = vtkImageData()
    image.SetDimensions(cube.shape[1], cube.shape[0], cube.shape[2])
    image.SetSpacing(1.0, 1.0, -0.4)
    amplitudes = numpy_to_vtk(cube.transpose(2, 0, 1).ravel(), deep=True)
    amplitudes.SetName("Amplitude")
    image.GetPointData().SetScalars(amplitudes)
    extraction = sh.vtkSeismicReflectionExtraction()
    extraction.SetInputDataObject(image)
    extraction.SetLargestNumber(36)
    extraction.Update()
    found = extraction.GetOutput()
    return [found.GetPartition(n, 0) for n in range(found.GetNumberOfPartitionedDataSets())]


def section(cube, horizons, row):
    """Grey amplitudes, and a stroke for each pick, in the colour of its horizon."""
    grey = np.clip(128 + 100 * cube[row].T / np.abs(cube[row]).max() * 1.5, 0, 255).astype(np.uint8)
    picture = np.repeat(np.kron(grey, np.ones(SCALE[::-1], dtype=np.uint8))[:, :, None], 3, axis=2)
    for n, horizon in enumerate(horizons):
        places = vtk_to_numpy(horizon.GetPoints().GetData())
        depth = vtk_to_numpy(horizon.GetPointData().GetArray("RealZ")) / -0.4
        for column, sample in zip(places[places[:, 1] == row, 0], depth[places[:, 1] == row]):
            left, top = int(column) * SCALE[0], int(round((abs(sample) + 0.5) * SCALE[1]))
            picture[max(0, top - 1):top + 1, left:left + SCALE[0]] = COLORS[n % len(COLORS)]
    return picture


def main():
    cube = read(sys.argv[1])
    horizons = extract(cube)
    together = vtkAppendPolyData()
    for horizon in horizons[:8]:
        together.AddInputData(horizon)
    together.Update()
    left = section(cube, horizons, cube.shape[0] // 2)
    panel = pictures.Panel("", "", together.GetOutput(), pictures.POINTS)
    drawn = pictures.draw([[panel]], text=False, panel_size=(700, left.shape[0]))
    width, height, _ = drawn.GetDimensions()
    right = vtk_to_numpy(drawn.GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3]
    picture = np.ascontiguousarray(np.hstack([left, right])[::-1])
    image = vtkImageData()
    image.SetDimensions(picture.shape[1], picture.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(picture.reshape(-1, 3), deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(sys.argv[2])
    writer.SetInputData(image)
    writer.Write()


main()
