# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Looks at a corner of what is shown, as by the mouse."""

from paraview import simple

view = simple.GetActiveView()
eye, focus = list(view.CameraPosition), list(view.CameraFocalPoint)
view.CameraFocalPoint = [focus[0] + 3, focus[1] - 2, focus[2] + 1]
view.CameraPosition = [focus[n] + 0.3 * (eye[n] - focus[n]) for n in range(3)]
view.StillRender()
