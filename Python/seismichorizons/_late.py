# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Names that are found when they are asked for: the version, and functions by their names of version 0.2, which give a warning
and go with the next version."""

from __future__ import annotations

import warnings
from typing import Any

from ._door import horizon
from ._stages import despike, fill_holes

NAMES = {"horizon_from_points": horizon, "horizon_from_image": horizon, "hole_filling": fill_holes, "despiking": despike}


def find(name: str) -> Any:
    """The version, or the function of an old name. Raises AttributeError."""
    if name == "__version__":
        import importlib.metadata  # takes as long as half of numpy

        return importlib.metadata.version("seismichorizons")
    if name.startswith("vtk"):
        raise AttributeError("module 'seismichorizons' without the classes of VTK, which are in the Debian package python3-seismichorizons")
    if name not in NAMES:
        raise AttributeError("module 'seismichorizons' has no attribute '%s'" % name)
    warnings.warn("seismichorizons.%s is now seismichorizons.%s" % (name, NAMES[name].__name__), DeprecationWarning, stacklevel=3)
    return NAMES[name]
