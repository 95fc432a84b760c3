# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Generated horizons, and filters run on them: what the scripts in this folder have in common."""

import pathlib
import subprocess
import tempfile

import seismichorizons as sh


def read(path):
    """The first horizon of a file."""
    reader = sh.vtkVerneySparseMatrixReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutputDataObject(0).GetPartition(0, 0)


def make_surface(generator, options):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "surface.vsm"
        subprocess.run([generator, *options, path], check=True, stdout=subprocess.DEVNULL)
        return read(path)


def apply(algorithm, data, **properties):
    for name, value in properties.items():
        getattr(algorithm, "Set" + name)(value)
    algorithm.SetInputDataObject(0, data)
    algorithm.Update()
    return algorithm.GetOutputDataObject(0)
