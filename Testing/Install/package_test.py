# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The installed Python package does the whole way. Arguments: the install prefix and the folder of the data."""

import pathlib
import sys

import seismichorizons
from seismichorizons import vtk as sh

import mesh_checks
import pipelines


def main():
    prefix, data = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    assert prefix in pathlib.Path(seismichorizons.__file__).resolve().parents, seismichorizons.__file__
    maps = pathlib.Path("/proc/self/maps").read_text(encoding="utf-8")
    # Five fields, and a path that may have blanks in it.
    libraries = {line.split(maxsplit=5)[-1] for line in maps.splitlines() if "libvtkSeismicHorizons" in line}
    assert libraries and all(str(prefix) in library for library in libraries), libraries
    for place in ("bash-completion/completions/horizon-mesh", "zsh/site-functions/_horizon-mesh"):
        assert "--largest-error" in (prefix / "share" / place).read_text(encoding="utf-8"), place
    stages = pipelines.with_classes(data / "sample.vsm")
    meshes = mesh_checks.blocks(stages[-1])
    assert len(meshes) >= 2
    for name, mesh in meshes.items():
        print("%s: %d triangles" % (name, mesh_checks.check_mesh(mesh)))
    meter = sh.vtkHorizonSurfaceDistance()
    sh.apply(meter, stages[0], stages[-1])
    assert meter.GetOutputDataObject(2).GetNumberOfRows() == 9 * len(meshes)


main()
