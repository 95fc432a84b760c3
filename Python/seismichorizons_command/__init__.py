# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The program horizon-mesh. Its command line, which is made by the modules arguments, completion, options, parser, screens and
words, loads neither NumPy nor VTK, so that it answers at once. The work is done by the package seismichorizons; only pictures
load VTK."""

from ._version import VERSION as __version__

NAME = "horizon-mesh"
VERSION_LINE = "%s %s\n" % (NAME, __version__)
