# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Stops the active filter when it has done a third, as an Abort button would; what the progress bar shows goes to
progress.txt.

The button of ParaView 5.11 is never enabled while a filter runs, and no event is looked at until it has ended. Other
versions do what is done here: they call SetAbortExecuteAndUpdateTime of the running filter.
"""

import json

from paraview import servermanager, simple


def note_progress(handler, _):
    with open("progress.txt", "a", encoding="utf-8") as progress:
        progress.write(json.dumps([handler.GetLastProgressText(), handler.GetLastProgress()]) + "\n")


def stop(algorithm, _, asked=[]):  # a list of its own, which remembers
    if not asked and 1 / 3 <= algorithm.GetProgress() < 1:
        asked.append(True)
        algorithm.SetAbortExecuteAndUpdateTime()


servermanager.ActiveConnection.Session.GetProgressHandler().AddObserver("ProgressEvent", note_progress)
simple.GetActiveSource().GetClientSideObject().AddObserver("ProgressEvent", stop)
