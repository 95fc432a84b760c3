#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws Documentation/Pictures/Report.png: two sections of a report of the sample, in Chromium. Needs an X server.

    report_picture.py PICTURE.png
"""

import base64
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Testing" / "Python"))
from browser import Browser  # noqa: E402: in the folder of the tests

SIZE = (1120, 1500)
GAP = 24
# Scripts that run before each screenshot.
PARTS = ("document.querySelector('.file').open = false",
         "document.getElementById('horizon-0').open = true; document.getElementById('details').scrollIntoView()")


def shoot(page, folder):
    """Returns screenshots of the page as arrays of pixels, bottom row first."""
    parts = []
    with Browser() as browser:
        browser.open(page)
        browser.command("Emulation.setScrollbarsHidden", hidden=True)
        browser.command("Emulation.setDeviceMetricsOverride", width=SIZE[0], height=SIZE[1], deviceScaleFactor=1, mobile=False)
        for number, script in enumerate(PARTS):
            browser.run(script)
            browser.wait("const done = arguments[0]; setTimeout(done, 500)")
            picture = folder / ("%d.png" % number)
            picture.write_bytes(base64.b64decode(browser.command("Page.captureScreenshot", format="png")["data"]))
            reader = vtkPNGReader()
            reader.SetFileName(str(picture))
            reader.Update()
            image = reader.GetOutput()
            width, height, _ = image.GetDimensions()
            parts.append(vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[..., :3])
    return parts


def write(pixels, path):
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(pixels).reshape(-1, 3), deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetCompressionLevel(9)
    writer.SetInputData(image)
    writer.Write()


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        page = folder / "page.html"
        subprocess.run([sys.executable, ROOT / "Utilities" / "horizon_mesh.py", "--z-from", "RealZ", "--cut-faults", "0",
                        "--output-folder", folder, "--report", page, os.path.relpath(ROOT / "Data" / "sample.vsm", ROOT)],
                       check=True, cwd=ROOT)
        first, second = shoot(page, folder)
    gap = np.full((SIZE[1], GAP, 3), 226, dtype=np.uint8)
    write(np.concatenate((first, gap, second), axis=1), sys.argv[1])


main()
