# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Names of version 0.2, which give a warning and go with the next version: those of functions, and of the classes of VTK."""

from __future__ import annotations

import warnings
from typing import Any

from ._door import horizon
from ._stages import despike, fill_holes

NAMES = {"horizon_from_points": horizon, "horizon_from_image": horizon, "hole_filling": fill_holes, "despiking": despike}


def find(name: str) -> Any:
    """The function or class of an old name. Raises AttributeError."""
    if name.startswith("vtk") and name != "vtk":  # the module, which Python asks for here before it loads it
        try:
            from . import vtk
        except ImportError:
            raise AttributeError("module 'seismichorizons' without the classes of VTK, which are in the Debian package "
                                 "python3-seismichorizons") from None
        warnings.warn("seismichorizons.%s is now seismichorizons.vtk.%s" % (name, name), DeprecationWarning, stacklevel=3)
        return getattr(vtk, name)
    if name not in NAMES:
        raise AttributeError("module 'seismichorizons' has no attribute '%s'" % name)
    warnings.warn("seismichorizons.%s is now seismichorizons.%s" % (name, NAMES[name].__name__), DeprecationWarning, stacklevel=3)
    return NAMES[name]
