# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Notes what the active source is, what it has, and whether it is shown."""

import json

from paraview import simple

source = simple.GetActiveSource()
note = {"sources": len(simple.GetSources())}
if source:
    information = source.GetDataInformation()
    display = simple.GetRepresentation(source, simple.GetActiveView())
    note.update(name=type(source).__name__, points=information.GetNumberOfPoints(), cells=information.GetNumberOfCells(),
                bounds=information.GetBounds(), shown=bool(display and display.Visibility))
with open("notes.txt", "a", encoding="utf-8") as notes:
    notes.write(json.dumps(note) + "\n")
