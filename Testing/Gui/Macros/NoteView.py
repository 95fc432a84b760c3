# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Notes how the active view shows things, and which horizons each source has chosen."""

import json

from paraview import simple

view = simple.GetActiveView()
axes = view.AxesGrid
sight = [eye - focus for eye, focus in zip(view.CameraPosition, view.CameraFocalPoint)]
length = sum(part * part for part in sight) ** 0.5
shown = [(source, display) for source in simple.GetSources().values()
         for display in [simple.GetRepresentation(source, view)] if display and display.Visibility]


def range_of(table):
    values = list(table.RGBPoints)[0::4] if table else []
    return [round(min(values), 3), round(max(values), 3)] if values else []


note = {
        "seen from": [round(part / length, 2) for part in sight], "axis": axes.ZTitle.strip(),
        "distance": round(length, 3), "focus": [round(part, 3) for part in view.CameraFocalPoint],
        "shown": [[type(source).__name__, display.ColorArrayName[1], range_of(display.LookupTable)]
                  for source, display in shown],
        "colours": [[display.ColorArrayName[1], range_of(display.LookupTable)]
                    for display in view.Representations if hasattr(display, "ColorArrayName") and display.Visibility],
        "tops": [[round(part, 2) for part in display.LookupTable.RGBPoints[1:4]] for _, display in shown if display.LookupTable],
        "formats": [simple.GetScalarBar(display.LookupTable, view).RangeLabelFormat
                    for _, display in shown if display.LookupTable],
        "contours": [simple.GetScalarBar(display.LookupTable, view).ComponentTitle
                     for _, display in shown if display.LookupTable],
        "selected": simple.GetActiveSource().Port if hasattr(simple.GetActiveSource(), "Port") else 0,
        "results": [source.Results for source, _ in shown if source.GetProperty("Results")],
        "axes": [axes.XTitle.strip(), axes.YTitle.strip()], "axes scale": list(axes.DataScale), "counts lines": axes.UseModelTransform,
        "axes matrix": list(axes.ModelTransformMatrix), "axes bounds": list(axes.ModelBounds),
        "scales": [list(display.Scale) for display in view.Representations if hasattr(display, "Scale")],
        "horizons": [list(source.HorizonStatus) for source in simple.GetSources().values()
                     if source.GetProperty("HorizonStatus")]}
with open("notes.txt", "a", encoding="utf-8") as notes:
    notes.write(json.dumps(note) + "\n")
