# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Notes how the active view shows things, and which horizons each source has chosen."""

import json

from paraview import simple

view = simple.GetActiveView()
axes = view.AxesGrid
note = {"axes": [axes.XTitle, axes.YTitle], "axes scale": list(axes.DataScale), "counts lines": axes.UseModelTransform,
        "axes matrix": list(axes.ModelTransformMatrix), "axes bounds": list(axes.ModelBounds),
        "scales": [list(display.Scale) for display in view.Representations if hasattr(display, "Scale")],
        "horizons": [list(source.HorizonStatus) for source in simple.GetSources().values()
                     if source.GetProperty("HorizonStatus")]}
with open("notes.txt", "a", encoding="utf-8") as notes:
    notes.write(json.dumps(note) + "\n")
