# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Notes what the panel tells of the active source, and the array that colours it."""

import json

from paraview import servermanager, simple

source = simple.GetActiveSource()
display = simple.GetRepresentation(source, simple.GetActiveView())
note = {"name": source.GetXMLName(), "array": display.ColorArrayName[1]}
source.UpdatePropertyInformation()
for name in ("Results", "Description"):
    if source.SMProxy.GetProperty(name):
        note["told"] = servermanager.vtkSMPropertyHelper(source.SMProxy, name).GetAsString()
with open("notes.txt", "a", encoding="utf-8") as notes:
    notes.write(json.dumps(note) + "\n")
