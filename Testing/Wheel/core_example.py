# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A script with types, which mypy checks strictly and which runs. Argument: a folder for files."""

import pathlib
import sys

import numpy as np
import seismichorizons as sh


def largest(meshes: dict[str, sh.Mesh]) -> float:
    return max(mesh.largest_error for mesh in meshes.values())


def main(folder: pathlib.Path) -> None:
    x, y = np.meshgrid(25.0 * np.arange(60), 12.5 * np.arange(40))
    top: sh.Horizon = sh.horizon(x, y, 1500.0 + 40.0 * np.sin(x / 300.0), vertical_unit="ms", name="Top")
    found: sh.Faults = sh.faults(top, "20 ms")
    filled: sh.Horizon = sh.fill_holes(sh.despike(top), faults=found)
    mesh: sh.Mesh = sh.surface(filled, "2 ms", faults=found)
    meshes: dict[str, sh.Mesh] = sh.surface({"Top": top}, 1.0)
    triangles: int = len(mesh.triangles)
    known: int = mesh.ledger.known
    between: sh.Thickness = sh.thickness(top, sh.horizon(x, y, 1600.0 + 0.0 * x, vertical_unit="ms"))
    sh.write(mesh, folder / "top.ts")
    sh.write(top, folder / "top.irap")
    for name, one in sh.read(folder / "top.irap", vertical_unit="ms").items():
        print(name, one.z.mean(), one.lattice.spacing, triangles, known, largest(meshes), between.volume)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
