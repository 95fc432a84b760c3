# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""SEG-Y files give the samples that segyio reads, at the lines that it finds.

Argument: the folder of real data. Skips itself (77) where there is no segyio, or no file.
"""

import pathlib
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from seismichorizons.vtk import vtkSEGYCubeReader

try:
    import segyio
except ImportError:
    print("skipped: no segyio")
    sys.exit(77)
FILES = sorted(path for path in (pathlib.Path(sys.argv[1]) / "segy").glob("*.s*gy"))
# All that segyio writes; versions 1.8 and before, as of Debian 12, write traces of 1 and 8 bytes a sample too short.
FORMATS = (1, 2, 3, 5) if segyio.__version__ < "1.9" else (1, 2, 3, 5, 6, 8)


def read(path):
    """The samples as (inlines, crosslines, samples), and whether each of them is in the file."""
    reader = vtkSEGYCubeReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    columns, rows, levels = image.GetDimensions()
    data = image.GetPointData()
    samples = vtk_to_numpy(data.GetArray("Amplitude")).reshape(levels, rows, columns).transpose(1, 2, 0)
    ghosts = data.GetArray("vtkGhostType")
    hidden = np.zeros(image.GetNumberOfPoints()) if ghosts is None else vtk_to_numpy(ghosts)
    return samples, hidden.reshape(levels, rows, columns).transpose(1, 2, 0) == 0


def lines(traces):
    """Of the numbers of all traces: where each is among those that there are."""
    numbers = np.unique(traces)
    step = np.gcd.reduce(np.diff(numbers)) if len(numbers) > 1 else 1
    return (traces - numbers[0]) // step


class SegyioTest(unittest.TestCase):
    def compare(self, path):
        samples, is_there = read(path)
        with segyio.open(path, ignore_geometry=True) as file:
            traces = file.trace.raw[:]
            rows = lines(file.attributes(189)[:])
            columns = lines(file.attributes(193)[:])
        found = samples[rows, columns]
        self.assertEqual(found.shape, traces.shape)
        live = traces.any(axis=1)
        self.assertTrue(live.any())
        self.assertEqual(found[live].tobytes(), traces[live].astype(np.float32).tobytes(), path.name)
        self.assertTrue(is_there[rows[live], columns[live]].all())

    def test_formats(self):
        random = np.random.default_rng(1)
        for code in FORMATS:
            with self.subTest(code=code), tempfile.TemporaryDirectory() as folder:
                path = pathlib.Path(folder) / "cube.sgy"
                spec = segyio.spec()
                spec.format, spec.sorting = code, 2
                spec.iline, spec.xline = 189, 193
                spec.samples, spec.ilines, spec.xlines = range(50), range(100, 108), range(300, 311)
                with segyio.create(path, spec) as file:
                    cells = [(i, j) for i in spec.ilines for j in spec.xlines]
                    for number, (row, column) in enumerate(cells):
                        file.header[number] = {189: row, 193: column, 115: 50, 117: 4000, 29: 1}
                        file.trace[number] = (random.integers(1, 127, 50) if code in (2, 3, 8)
                                              else random.normal(0.0, 1e3, 50)).astype(file.dtype)
                    file.bin.update({3217: 4000, 3225: code})
                self.compare(path)

    def test_real_files(self):
        if not FILES:
            self.skipTest("no SEG-Y files in %s" % sys.argv[1])
        for path in FILES:
            with self.subTest(path=path.name):
                self.compare(path)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
