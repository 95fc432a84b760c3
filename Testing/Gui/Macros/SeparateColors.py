# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Gives the active source a separate colour map."""

from paraview import simple

display = simple.GetRepresentation(simple.GetActiveSource(), simple.GetActiveView())
simple.ColorBy(display, tuple(display.ColorArrayName), separate=True)
simple.Render()
