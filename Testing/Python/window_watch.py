# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in the window of ParaView, by window_test.py: writes down what each source has chosen and how it is shown.

Variable of the environment: WATCH, the file, with a line of JSON for every picture that is drawn.
"""

import json
import os

from paraview import simple

view = simple.GetActiveViewOrCreate("RenderView")


def write(*_):
    axes = view.AxesGrid
    state = {"DataScale": list(axes.DataScale), "DataPosition": list(axes.DataPosition), "XTitle": axes.XTitle,
             "YTitle": axes.YTitle}
    for (name, _), source in simple.GetSources().items():
        display = simple.GetRepresentation(source, view) if source.SMProxy.GetNumberOfOutputPorts() else None
        status = source.GetProperty("HorizonStatus")
        state[name] = {"Scale": list(display.Scale), "Horizons": list(status) if status else None}
    with open(os.environ["WATCH"], "a", encoding="utf-8") as file:
        file.write(json.dumps(state) + "\n")


view.GetRenderWindow().AddObserver("EndEvent", write)
