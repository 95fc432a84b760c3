#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The program horizon-mesh where its Python packages are not installed, but in PYTHONPATH."""

import sys

try:
    from seismichorizons_command.horizon_mesh import main
except ImportError as error:
    sys.exit("horizon_mesh: error: the Python package seismichorizons_command cannot be loaded; is its folder in PYTHONPATH? "
             "(%s)" % error)

if __name__ == "__main__":
    sys.exit(main())
