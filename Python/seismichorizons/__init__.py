# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Seismic horizons from picks, grids and arrays to clean triangle meshes within a known error.

    import seismichorizons as sh

    top = sh.read("picks.dat")["Top"]
    mesh = sh.surface(top, largest_error="2 ms")
    sh.write(mesh, "top.ts")

Everything takes and gives numpy arrays; other packages are imported where their objects are asked for.
"""

import importlib.metadata

from ._door import horizon
from ._files import read, write
from ._horizon import Horizon, Lattice
from ._mesh import Ledger, Mesh
from ._stages import Faults, Thickness, despike, faults, fill_holes, surface, thickness

__version__ = importlib.metadata.version("seismichorizons")
__all__ = ["Faults", "Horizon", "Lattice", "Ledger", "Mesh", "Thickness", "despike", "faults", "fill_holes", "horizon", "read",
           "surface", "thickness", "write"]
