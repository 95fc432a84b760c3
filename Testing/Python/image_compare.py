# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares pictures strictly: counts the pixels that differ.

VTK's own comparison allows shifts and averages over neighbours, and so lets changes of a tenth of a picture pass.
"""

import argparse
import pathlib
import shutil
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

STEP = 8  # a pixel differs when one of its colours is off by more than this, of 255
ALLOWED_PIXELS = 20  # what another version of the graphics library may round differently
CHANGED_PIXELS = 10 * ALLOWED_PIXELS  # what a changed scene has to show at least


def load(path):
    """The pixels of a PNG file as an array of rows x columns x 3, or None when there is no such file."""
    if not pathlib.Path(path).is_file():
        return None
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return pixels(reader.GetOutput())


def pixels(image):
    width, height, _ = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(height, width, -1)[:, :, :3]


def save(values, path):
    height, width, components = values.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    flat = np.ascontiguousarray(values.reshape(-1, components), dtype=np.uint8)
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(image)
    writer.Write()


def difference(result, baseline):
    """The number of pixels that differ, and a picture of where."""
    if result.shape != baseline.shape:
        return max(result.shape[0] * result.shape[1], baseline.shape[0] * baseline.shape[1]), None
    off = np.abs(result.astype(int) - baseline.astype(int)).max(axis=2)
    shown = np.repeat(np.minimum(255, 4 * off)[:, :, None], 3, axis=2)
    return int((off > STEP).sum()), shown


def check(result, baseline_path, folder, name, expect_change=False):
    """Whether a picture agrees with its baseline or, with `expect_change`, clearly does not.

    When the answer is no, the picture and where it differs are left in the folder.
    """
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for stale in folder.glob(name + ".*png"):
        stale.unlink()
    baseline = load(baseline_path)
    if baseline is None:
        save(result, folder / (name + ".png"))
        print("%s: there is no baseline %s; the picture is in %s" % (name, baseline_path, folder))
        return False
    number, shown = difference(result, baseline)
    print("%s: %d of %d pixels differ" % (name, number, baseline.shape[0] * baseline.shape[1]))
    good = number >= CHANGED_PIXELS if expect_change else number <= ALLOWED_PIXELS
    if not good:
        save(result, folder / (name + ".png"))
        shutil.copy(baseline_path, folder / (name + ".baseline.png"))
        if shown is not None:
            save(shown, folder / (name + ".diff.png"))
        print("%s: the pictures are in %s" % (name, folder))
    return good


def make_parser():
    """The options that all programs with pictures have."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--data", type=pathlib.Path, required=True)
    parser.add_argument("--output", type=pathlib.Path, required=True)
    parser.add_argument("--changed", action="store_true")
    return parser


def finish(result, name, options):
    """Ends the program with the verdict on a picture."""
    baseline = options.data / "Baseline" / (name + ".png")
    shown = name + ("-changed" if options.changed else "")
    sys.exit(0 if check(result, baseline, options.output, shown, options.changed) else 1)
