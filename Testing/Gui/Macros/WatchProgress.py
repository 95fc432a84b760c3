# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes what the progress bar shows into progress.txt, and null for each time that this macro is started."""

import json

from paraview import servermanager


def note(text):
    with open("progress.txt", "a", encoding="utf-8") as progress:
        progress.write(json.dumps(text) + "\n")


if not hasattr(servermanager, "watched_handler"):  # macros have no memory of their own
    servermanager.watched_handler = servermanager.ActiveConnection.Session.GetProgressHandler()
    servermanager.watched_handler.AddObserver(
        "ProgressEvent", lambda handler, _: note([handler.GetLastProgressText(), handler.GetLastProgress()]))
note(None)
