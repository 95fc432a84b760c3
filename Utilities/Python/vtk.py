# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The VTK classes, one per stage, reader and writer.

    from seismichorizons.vtk import vtkHorizonSurface
"""

from .vtkSeismicHorizons import *
