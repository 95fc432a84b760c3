# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Turns seismic horizons, as picks, grids and arrays, into clean triangle meshes within a known error.

    import seismichorizons as sh

    top = sh.read("picks.dat")["Top"]
    mesh = sh.surface(top, largest_error="2 ms")
    sh.write(mesh, "top.ts")

All data are numpy arrays; other packages are imported only when you ask for their objects.
"""

from ._cube import Cube, extract, read_cube
from ._cutoffs import Cutoffs, cutoffs
from ._door import horizon
from ._files import read, read_mesh, write
from ._horizon import Horizon, Lattice
from ._lines import Lines, read_faults
from ._mesh import Ledger, Mesh
from ._sealed import SealedModel, sealed
from ._stack import Distance, Layers, crossings, distance, layers
from ._stages import Faults, Thickness, contours, despike, faults, fill_holes, surface, thickness
from ._thesis import (
    boundary_simplification,
    decimation,
    elaborate_simplification,
    exterior_boundary,
    rough_simplification,
    triangulation,
)
from ._version import VERSION as __version__
from ._volume import amplitudes, cube

__all__ = ["Cube", "Cutoffs", "Distance", "Faults", "Horizon", "Lattice", "Layers", "Ledger", "Lines", "Mesh", "SealedModel", "Thickness", "amplitudes",
           "boundary_simplification", "contours", "crossings", "cube", "cutoffs", "decimation", "despike", "distance",
           "elaborate_simplification", "exterior_boundary", "extract", "faults", "fill_holes", "horizon", "layers", "read", "read_cube", "read_faults", "read_mesh", "rough_simplification", "sealed", "surface",
           "thickness", "triangulation", "write"]
